//! Where the blocks of a program lead: its first pass through each, and how often it passes.

use rustc_hash::FxHashMap;

use crate::diag::Trail;
use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::{Coords, Corner, CtxRef, Load, Move, Path, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Feed, Function, Origin, Pos, Remark, Side, Tap};
use crate::machine::Axis;
use crate::text::{FileId, Span};

/// Most blocks that are remembered.
const MOST: usize = 1 << 21;

/// What the blocks of a program do.
#[derive(Debug, Default)]
pub struct BlockEnds {
    /// In the order in which the blocks first ran.
    pub stops: Vec<Stop>,
    pub tools: Vec<Tool>,
    /// The axis of a lathe that is shown in diameters.
    pub diameter: Option<Axis>,
    by_block: FxHashMap<(FileId, u32), usize>,
    at: Pos,
    tool: Option<u32>,
    broken: bool,
    /// The step in which a block moved last, and its place in `stops`.
    last: (u64, usize),
    /// Where the tool stands while a contour is described.
    stands: Option<Pos>,
}

/// A block that moves.
#[derive(Debug, Clone, Copy)]
pub struct Stop {
    pub file: FileId,
    /// Line on which it begins, from 1.
    pub line: u32,
    /// Its words.
    pub span: Span,
    /// Where all known axes stand behind its first pass: what is programmed, in coordinates of the workpiece.
    pub end: Pos,
    pub path: Way,
    pub feed: Option<Feed>,
    pub side: Side,
    pub tool: Option<u32>,
    /// It moves in machine coordinates.
    pub machine: bool,
    /// A block in front of it was refused: this place is known again, and what lies between is not.
    pub broken: bool,
    /// How often the block ran, and the number of its first run.
    pub passes: u32,
    pub step: u64,
}

/// How a block moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    Rapid,
    Line,
    Arc,
    Thread,
    /// Where the cycle leaves the tool.
    Cycle,
    /// A corner that is rounded or chamfered.
    Corner,
}

impl Way {
    pub fn name(self) -> &'static str {
        match self {
            Way::Rapid => "rapid traverse",
            Way::Line => "line",
            Way::Arc => "arc",
            Way::Thread => "thread",
            Way::Cycle => "cycle",
            Way::Corner => "corner",
        }
    }
}

impl Stop {
    /// The known axes behind the block, and how often it ran; `cut_off` where the program was given up before its end.
    pub fn place(&self, cut_off: bool, diameter: Option<Axis>) -> String {
        let mut text = coordinates(&self.end, diameter);
        if text.is_empty() {
            text.push('?');
        }
        if self.machine {
            text.push_str(" machine");
        }
        if self.path == Way::Corner {
            text.push_str(" corner");
        }
        if self.broken {
            text.push_str(" after an error");
        }
        if self.passes > 1 {
            let least = if cut_off { "\u{2265}" } else { "" };
            text.push_str(&format!(" \u{d7}{least}{}", self.passes));
        }
        text
    }
}

/// `X10 Y-2.5`: three places, without zeros at the end; a diameter is marked, for no word stands there that says it.
pub fn coordinates(pos: &Pos, diameter: Option<Axis>) -> String {
    let word = |(axis, value): (Axis, f64)| match diameter {
        Some(turned) if turned == axis => format!("{}\u{2300}{}", axis.letter(), number(2.0 * value)),
        _ => format!("{}{}", axis.letter(), number(value)),
    };
    pos.iter().map(word).collect::<Vec<_>>().join(" ")
}

/// Three places, without zeros at the end and without a minus zero.
pub fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A block that changes the tool.
#[derive(Debug, Clone, Copy)]
pub struct Tool {
    pub file: FileId,
    pub span: Span,
    pub number: u32,
}

impl BlockEnds {
    /// The block whose words begin at `start`.
    pub fn stop(&self, file: FileId, start: u32) -> Option<&Stop> {
        self.by_block.get(&(file, start)).and_then(|at| self.stops.get(*at))
    }

    fn movement(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin, step: u64) {
        let machine = mv.coords == Coords::Machine;
        let (path, feed) = match mv.path {
            Path::Rapid => (Way::Rapid, None),
            Path::Line(feed) => (Way::Line, Some(feed)),
            Path::Arc(_, feed) => (Way::Arc, Some(feed)),
            Path::Thread(_) => (Way::Thread, None),
        };
        let end = if machine {
            mv.end
        } else {
            let mut end = ctx.frame.unapply(&self.at);
            end.update(&mv.end);
            ctx.frame.apply(&end)
        };
        self.goes(&end, (path, feed, mv.side, machine), origin, step);
    }

    /// A corner stands where the element in front of it ends. In a block that also moves, the move is what counts.
    fn corner(&mut self, origin: &Origin, step: u64) {
        if self.stop(origin.loc.file, origin.loc.span.start).is_none_or(|stop| stop.path == Way::Corner) {
            let at = self.at;
            self.goes(&at, (Way::Corner, None, Side::None, false), origin, step);
        }
    }

    fn goes(&mut self, end: &Pos, how: (Way, Option<Feed>, Side, bool), origin: &Origin, step: u64) {
        let (path, feed, side, machine) = how;
        if machine {
            end.iter().for_each(|(axis, _)| self.at.forget(axis));
        } else {
            self.at = *end;
        }
        let key = (origin.loc.file, origin.loc.span.start);
        if let Some(&known) = self.by_block.get(&key) {
            let stop = &mut self.stops[known];
            if self.last != (step, known) {
                stop.passes = stop.passes.saturating_add(1);
                self.last = (step, known);
            } else if stop.passes == 1 {
                // Some blocks move more than once.
                (stop.end, stop.path, stop.feed) = (*end, path, feed.or(stop.feed));
            }
            return;
        }
        if self.stops.len() == MOST {
            return;
        }
        self.last = (step, self.stops.len());
        self.by_block.insert(key, self.stops.len());
        let (file, line, span) = (origin.loc.file, origin.loc.line, origin.loc.span);
        let (tool, broken) = (self.tool, self.broken);
        self.stops.push(Stop { file, line, span, end: *end, path, feed, side, tool, machine, broken, passes: 1, step });
    }
}

/// Looks on while a program runs, and hands everything to `next`.
pub struct Looks<'s> {
    pub seen: &'s mut BlockEnds,
    pub trail: &'s Trail,
    pub next: &'s mut dyn Sink,
    /// Where it does not, the run ends.
    pub goes_on: &'s dyn Fn() -> bool,
}

impl Sink for Looks<'_> {
    fn movement(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin) {
        self.seen.movement(mv, ctx, origin, self.trail.steps());
        self.next.movement(mv, ctx, origin);
    }

    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin) {
        self.seen.corner(origin, self.trail.steps());
        self.next.corner(corner, ctx, origin);
    }

    fn function(&mut self, function: &Function, ctx: &CtxRef, origin: &Origin) {
        if let Function::Remark(Remark::Refused) = function {
            self.seen.broken = true;
        }
        if let Function::ToolChange { number } = function {
            self.seen.tool = Some(*number);
            if self.seen.tools.len() < MOST {
                let tool = Tool { file: origin.loc.file, span: origin.loc.span, number: *number };
                self.seen.tools.push(tool);
            }
        }
        self.next.function(function, ctx, origin);
    }

    fn tap(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin) {
        let mut end = ctx.frame.unapply(&self.seen.at);
        end.set(tap.axis, tap.end());
        let end = ctx.frame.apply(&end);
        self.seen.goes(&end, (Way::Thread, None, Side::None, false), origin, self.trail.steps());
        self.next.tap(tap, ctx, origin);
    }

    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin) {
        let end = ctx.frame.apply(&cycle.leaves(&ctx.frame.unapply(&self.seen.at)));
        self.seen.goes(&end, (Way::Cycle, None, Side::None, false), origin, self.trail.steps());
        self.next.cycle(cycle, ctx, origin);
    }

    fn lost(&mut self, ctx: &CtxRef, origin: &Origin) {
        self.seen.at.clear();
        self.next.lost(ctx, origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.seen.at.update(at);
        self.next.begins_at(at);
    }

    fn stands_at(&mut self, at: &Pos, ctx: &CtxRef, origin: &Origin) {
        self.seen.at.update(at);
        self.next.stands_at(at, ctx, origin);
    }

    fn load(&self) -> Load {
        let load = self.next.load();
        Load { full: load.full || !(self.goes_on)(), ..load }
    }

    fn contour_begins(&mut self, limit: usize, ctx: &CtxRef, origin: &Origin) {
        self.seen.stands = Some(self.seen.at);
        self.next.contour_begins(limit, ctx, origin);
    }

    fn contour_ends(&mut self, origin: &Origin) -> Result<Captured, Unfit> {
        // A described contour is not travelled.
        self.seen.at = self.seen.stands.take().unwrap_or(self.seen.at);
        self.next.contour_ends(origin)
    }
}
