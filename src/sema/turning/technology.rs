//! Feeds, spindle, tools, oversizes: what holds until it is changed.

use std::fmt::Display;
use std::rc::Rc;

use crate::diag::{Answer, Fault, Label, codes};
use crate::geo::Vec2;
use crate::ir::function::{CutterData, Spindle, Turn};
use crate::ir::{self, Feed, Function, Side};
use crate::machine::tools::ToolKey;
use crate::machine::{AxisSet, Compensation, Unit};
use crate::sema::common::compensation::edge_direction;
use crate::sema::common::feed::FeedKind;
use crate::sema::common::hidden::By;
use crate::text::{Span, decode::readable};

use super::readings::Question;
use super::words::{Fun, Num, Words};
use super::{Outcome, Reported, Run};

/// Metres in a foot.
const FOOT: f64 = 0.3048;

/// What S means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SpeedMode {
    /// G96: cutting speed.
    Cutting,
    /// G97: revolutions per minute.
    Revolutions,
}

/// Oversize of the next cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Oversize {
    /// G57: X as a diameter, Z, in mm.
    Paraxial { x: f64, z: f64 },
    /// G58: normal distance in mm.
    Equidistant(f64),
}

impl Oversize {
    /// The function that sets it.
    pub fn name(self) -> &'static str {
        match self {
            Oversize::Paraxial { .. } => "G57",
            Oversize::Equidistant(_) => "G58",
        }
    }
}

/// The tool in the cutting position.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ActiveTool {
    pub number: u32,
    /// Its edge: 0 for the only one.
    pub edge: u8,
    /// Its name of the turret section.
    pub name: Option<String>,
}

/// What the program told the spindle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SpindleState {
    mode: Option<SpeedMode>,
    /// S in the unit of its mode: m/min or rev/min.
    speed: Option<f64>,
    /// G26, rev/min.
    limit: Option<f64>,
    turn: Option<Turn>,
}

impl SpindleState {
    /// Sense of rotation, while it turns.
    pub fn turn(&self) -> Option<Turn> {
        self.turn
    }

    /// S counts as cutting speed.
    pub fn is_cutting(&self) -> bool {
        self.mode == Some(SpeedMode::Cutting)
    }

    /// S, where it counts in turns.
    pub fn turns(&self) -> Option<f64> {
        self.speed.filter(|_| self.mode == Some(SpeedMode::Revolutions))
    }

    pub fn speed(&self) -> Option<f64> {
        self.speed
    }

    /// A number of turns, kept under the limit.
    pub fn limited(&self, turns: f64) -> f64 {
        self.limit.map_or(turns, |limit| turns.min(limit))
    }

    /// G96 and G97. True if S means something else now.
    fn count(&mut self, mode: SpeedMode) -> bool {
        let changes = self.mode != Some(mode);
        if changes {
            self.speed = None;
        }
        self.mode = Some(mode);
        changes
    }
}

impl Run<'_> {
    // Feed.

    /// G94 and G95.
    pub(super) fn feed_mode(&mut self, kind: FeedKind, w: &Words, claims_f: bool) -> Outcome {
        match w.get(b'F').filter(|_| claims_f) {
            Some(num) => {
                self.st.feed.assume(kind);
                self.feed_word(num)
            }
            None => {
                self.st.feed.count(kind);
                Ok(())
            }
        }
    }

    pub(super) fn feed_word(&mut self, num: Num) -> Outcome {
        let value = num.value * self.st.mm();
        if value <= 0.0 {
            return self.core.refuse(num.span, codes::O1001::feed(&num.value));
        }
        let Some(feed) = self.st.feed.of(value) else {
            return self.core.refuse(num.span, codes::P2002::neither_g94_nor_g95_says_what_f());
        };
        self.st.feed.program(feed);
        Ok(())
    }

    /// Feed of a move that cuts.
    #[inline]
    pub(super) fn cutting_feed(&mut self) -> Outcome<Feed> {
        match self.st.feed.word() {
            Some(feed) => Ok(feed),
            None => self.feed_missing(),
        }
    }

    #[cold]
    fn feed_missing(&mut self) -> Outcome<Feed> {
        self.core.report(codes::P2002::no_feed_is_programmed_before_this_cutting().at(self.core.here.origin.loc));
        // One report is enough.
        self.st.feed.presume();
        Err(Reported)
    }

    // Spindle.

    /// G26: highest speed.
    pub(super) fn speed_limit(&mut self, w: &Words) -> Outcome {
        let num = self.needed(w, b'S', "the highest speed in revolutions per minute", self.core.block_span())?;
        if num.value <= 0.0 {
            return self.core.refuse(num.span, codes::T1007::speed_limit_is_above_zero());
        }
        self.st.spindle.limit = Some(num.value);
        self.send_speed(num.span);
        Ok(())
    }

    /// G96 and G97.
    pub(super) fn speed_mode(&mut self, mode: SpeedMode, w: &Words) -> Outcome {
        let changes = self.st.spindle.count(mode);
        match w.get(b'S') {
            Some(num) => self.speed_word(num),
            None if changes => {
                let (name, form) = match mode {
                    SpeedMode::Cutting => ("G96", "`G96 S180`"),
                    SpeedMode::Revolutions => ("G97", "`G97 S800`"),
                };
                self.core.refuse(self.core.block_span(), codes::P1004::changes_what_s_means(&name, &form))
            }
            None => Ok(()),
        }
    }

    pub(super) fn speed_word(&mut self, num: Num) -> Outcome {
        if num.value < 0.0 {
            return self.core.refuse(num.span, codes::O9002::speed(&num.value));
        }
        match self.st.spindle.mode {
            None => {
                return self.core.refuse(num.span, codes::T2004::neither_g96_nor_g97_says_what_s());
            }
            Some(SpeedMode::Cutting) if self.st.unit == Unit::Inch => self.st.spindle.speed = Some(num.value * FOOT),
            Some(_) => self.st.spindle.speed = Some(num.value),
        }
        self.send_speed(num.span);
        Ok(())
    }

    /// Prints the speed in force, kept under the limit.
    fn send_speed(&mut self, span: Span) {
        let Some(speed) = self.st.spindle.speed else { return };
        let limit = self.st.spindle.limit;
        let spindle = match self.st.spindle.mode {
            Some(SpeedMode::Cutting) => Spindle::CuttingSpeed { speed, limit },
            _ => match limit.filter(|limit| speed > *limit) {
                Some(limit) => {
                    self.core
                        .report(codes::T2005::speed_is_lowered_to_limit_of_g26(&speed, &limit).at(self.core.loc(span)));
                    Spindle::Speed(limit)
                }
                None => Spindle::Speed(speed),
            },
        };
        self.function(Function::Spindle(spindle));
    }

    pub(super) fn turn_spindle(&mut self, turn: Option<Turn>) {
        self.st.spindle.turn = turn;
        self.function(Function::Spindle(match turn {
            Some(turn) => Spindle::Start(turn),
            None => Spindle::Stop,
        }));
    }

    /// A thread is cut with a turning spindle.
    pub(super) fn spindle_turns(&self, number: u16) -> Outcome {
        if self.st.spindle.turn().is_some() {
            return Ok(());
        }
        self.core.refuse(self.core.block_span(), codes::P1004::spindle_does_not_turn_when_g_begins(&number))
    }

    // Compensation of the nose radius.

    pub(super) fn compensation(&mut self, side: Side, fun: Fun) -> Outcome {
        if side != Side::None {
            if self.st.compensation.is_on() && self.st.compensation.side() != side {
                return self.core.refuse(fun.span, codes::T2021::g41_g42_follow_each_other_without_g40());
            }
            if self.core.job.settings.output.compensation == Compensation::Resolve {
                self.compute_compensation(fun)?;
            }
        }
        self.st.compensation.select(side);
        Ok(())
    }

    /// The compiler itself computes the path of the nose centre.
    fn compute_compensation(&mut self, fun: Fun) -> Outcome {
        let known = self.st.known_tool(self.core.job.settings);
        let radius = known.and_then(|tool| tool.radius.map(|radius| radius + tool.deltas[1]));
        let edge = known.and_then(|tool| tool.orientation).and_then(edge_direction);
        let (radius, edge) = match (radius, edge) {
            (Some(radius), Some(edge)) if radius >= 0.0 => (radius, edge),
            (Some(0.0), None) => (0.0, Vec2::zeros()),
            (radius, _) => {
                let what = match radius {
                    Some(radius) if radius < 0.0 => "the nose radius of the tool is below zero",
                    Some(_) => "the cutting-edge position of the tool is not known",
                    None => "the nose radius of the tool is not known",
                };
                return self.core.refuse(
                    fun.span,
                    codes::P2004::g_compensates_nose_radius(&fun.number, &what)
                        .answer(Answer::key("output", "compensation").one_of(&["\"control\""])),
                );
            }
        };
        if radius > 0.0 {
            self.depends_on(Question::NosePath, fun.span);
        }
        self.st.compensate(ir::Compensation { radius, nose: -edge * radius, ..Default::default() });
        Ok(())
    }

    // Tool.

    /// T: `T3`, `T3.1`, or the four digits of a tool and its offset.
    pub(super) fn tool_word(&mut self, num: Num, text: &[u8]) -> Outcome {
        let written = num.span.of(text);
        let (number, edge) = self.tool_number(num, written)?;
        if self.st.tool.as_ref().is_some_and(|tool| tool.number == number && tool.edge == edge) {
            return Ok(());
        }
        if self.st.compensation.is_on() {
            return self.core.refuse(num.span, codes::T2021::tool_changes_under_nose_radius_compensation());
        }
        let name = self.sections.tool_name(number, edge);
        self.core.job.calls_tool_in(self.st.unit, self.core.loc(num.span));
        let known = self.core.job.settings.tools.by_number(number, edge);
        let known = known.map(|tool| tool.number).or_else(|| {
            let (own, tool) = self.core.job.settings.tools.by_name(name.as_deref()?)?;
            Some(own.or(tool.number))
        });
        let printed = match (known.flatten(), edge) {
            (Some(printed), _) => printed,
            (None, 0) => number,
            (None, _) => {
                return self.core.refuse(
                    num.span,
                    codes::T2007::edge_of_tool_has_no_tool_number(&edge, &number)
                        .answer(Answer::tool(format!("{number}.{edge}"), "number")),
                );
            }
        };
        self.core.prints_tool(&ToolKey::Number(number, edge), printed, num.span)?;
        self.function(Function::ToolChange { number: printed });
        self.function(Function::Cutter(CutterData { number: printed, ..CutterData::default() }));
        self.st.tool = Some(ActiveTool { number, edge, name });
        self.st.forget();
        self.st.position.hide(AxisSet::MAIN, By::ToolChange, self.core.here.origin.loc);
        self.stand_after_change();
        Ok(())
    }

    /// The change is over: axes stand where the configuration says. The lengths of a turning tool, which machine coordinates
    /// count without, are not in its table.
    fn stand_after_change(&mut self) {
        let (after, in_machine) = self.st.position.after_change();
        if in_machine {
            return;
        }
        let ctx = Rc::clone(&self.st.ctx);
        let known = self.st.position.stand_in_offset(&after, &ctx.frame);
        self.core.stands_at(&known, &ctx);
    }

    fn tool_number(&self, num: Num, written: &[u8]) -> Outcome<(u32, u8)> {
        let unclear = |fault: fn(&dyn Display) -> Fault| self.core.refuse(num.span, fault(&readable(written)));
        let digits = written.get(1..).unwrap_or_default();
        let (whole, fraction) = match digits.iter().position(|b| *b == b'.') {
            Some(at) => (&digits[..at], &digits[at + 1..]),
            None => (digits, &[][..]),
        };
        let read = |text: &[u8]| std::str::from_utf8(text).ok().and_then(|text| text.parse::<u32>().ok());
        let whole_digits = !whole.is_empty() && whole.iter().all(u8::is_ascii_digit);
        let number =
            if whole_digits { read(whole) } else { Some(num.value).filter(|n| n.fract() == 0.0).map(|n| n as u32) };
        let Some(number) = number.filter(|_| (0.0..=99_999.0).contains(&num.value)) else {
            return unclear(codes::T2007::word_is_no_tool);
        };
        if !whole_digits || whole.len() < 4 {
            let edge = if whole_digits && !fraction.is_empty() { read(fraction) } else { Some(0) };
            return match edge.and_then(|edge| u8::try_from(edge).ok()) {
                Some(edge) => Ok((number, edge)),
                None => unclear(codes::T2007::word_is_no_edge),
            };
        }
        match (number / 100, number % 100) {
            (tool, offset) if tool == offset && whole.len() == 4 && fraction.is_empty() => Ok((tool, 0)),
            _ => unclear(codes::T2007::word_names_tool_and_offset_of_another),
        }
    }

    // What the next cycles use.

    pub(super) fn clearance(&mut self, w: &Words) -> Outcome {
        self.st.clearance = match w.get(b'P') {
            Some(num) => Some(self.above_zero(num, "the clearance")?),
            None => None,
        };
        Ok(())
    }

    pub(super) fn oversize(&mut self, w: &Words, equidistant: bool) -> Outcome {
        let mm = self.st.mm();
        let oversize = if equidistant {
            let num = self.needed(w, b'P', "the oversize", self.core.block_span())?;
            Oversize::Equidistant(num.value * mm)
        } else {
            let value = |letter| w.value(letter).unwrap_or(0.0) * mm;
            Oversize::Paraxial { x: value(b'X'), z: value(b'Z') }
        };
        if let Some((before, loc)) = self.st.oversize
            && std::mem::discriminant(&before) != std::mem::discriminant(&oversize)
        {
            let (old, new) = (before.name(), oversize.name());
            let found = codes::T8017::from_here_on_changes_nothing(&old, &new).at(loc);
            self.core.report(found.also(self.core.here.origin.loc, Label::TakesItsPlace));
        }
        self.st.oversize = Some((oversize, self.core.here.origin.loc));
        Ok(())
    }
}
