//! Rigid tapping: the blocks of G331 and G332 that belong to one hole are one tap.
//!
//! Source: S 0, 2.1 and 7.3 (docs/sources.md).

use crate::geo::tolerance;
use std::rc::Rc;

use crate::diag::codes;
use crate::geo::Plane;
use crate::ir::contour::{CtxRef, Path, Thread};
use crate::ir::cycle::drilling::MOST_PECKS;
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::tap::Stroke;
use crate::ir::{Function, Origin, Pos, Tap};
use crate::machine::{Axis, AxisSet};
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::spindle_state::{MAIN_SPINDLE, Spindles};
use super::vocabulary::Address;
use super::words::{MWord, Words, misfit};
use super::{Channel, Core, Outcome, State};

/// The M function that may end the block in which a tap comes back.
const COOLANT_OFF: u32 = 9;

/// Taps that later blocks go on with.
#[derive(Debug, Clone, Default)]
pub(super) struct Taps {
    /// Lead of the last tap with its sign, and the axis along which it counts.
    lead: Option<(Axis, f64)>,
    /// A hole that blocks tap, which waits for their end.
    open: Option<Box<OpenTap>>,
    /// A block stopped the spindle at this angle: that of the tap, if one follows.
    angle: Option<(f64, Origin)>,
    /// The block in hand begins a hole; the speed of the spindle before it.
    begins: Option<Option<f64>>,
}

impl Taps {
    /// A block is to be asked whether it ends the tap.
    #[inline]
    pub fn are_open(&self) -> bool {
        self.open.is_some() || self.angle.is_some()
    }

    /// An S word is the speed of a tap, which says it itself.
    pub fn take_speed(&self) -> bool {
        self.open.is_some() || self.begins.is_some()
    }

    /// The block in hand is refused; where it is one of the tap, what is missing of the tap is told with it.
    pub fn block_is_refused(&mut self, of_tap: bool) {
        self.begins = None;
        self.open.take_if(|open| of_tap && open.inside.is_some());
    }

    /// A tap went in and did not come back yet.
    pub fn is_inside(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.inside.is_some())
    }

    /// What a block without a move or a function says need not end the tap, or the stop of the spindle before it.
    pub fn go_on_beside_text(&self) -> bool {
        self.is_inside() || self.open.is_none() && self.angle.is_some()
    }

    /// Does a block end the tap, as one that neither goes on with it nor rests in it? `modal`: the motion in force.
    pub fn end_before(&self, w: &Words, modal: GCode) -> bool {
        !self.goes_on(w, modal) && !self.rest(w)
    }

    /// Rigid tapping: in, or out again.
    fn goes_on(&self, w: &Words, modal: GCode) -> bool {
        let code = w.code_of(Group::Motion).map_or(modal, |(code, _)| code);
        let shaped = [Group::Nonmodal, Group::Frame, Group::Buffer, Group::Suppression];
        code.is_tapping()
            && !w.axes.is_empty()
            && shaped.iter().all(|group| w.code_of(*group).is_none())
            && !self.is_disturbed(w, code)
    }

    /// A function that would act inside the tap, which is one move: that of its first block acts before it, stops and ends of
    /// programs after it.
    fn is_disturbed(&self, w: &Words, code: GCode) -> bool {
        let acts = w.m.iter().any(|m| !matches!(m.number, 0..=5 | 17 | 30)) || w.get(Address::T).is_some();
        let comes_back = code == GCode::G332 && self.is_inside();
        acts && self.open.is_some() && !comes_back
    }

    /// A block that may stand inside a tap, or between SPOS= and G331: one without a move or a function, and of G functions those
    /// that tap alone; and a dwell at the depth.
    fn rest(&self, w: &Words) -> bool {
        let inside = self.is_inside();
        let dwells = w.code_of(Group::Nonmodal).is_some_and(|(code, _)| code == GCode::G4);
        let idle = w.axes.is_empty() && w.m.is_empty() && w.get(Address::T).is_none();
        let positions = w.get(Address::Spos).or(w.get(Address::Sposa)).is_some();
        let taps = w.codes.iter().all(|(code, _)| code.group == Group::Motion && code.is_tapping());
        idle && !positions && (taps || inside && dwells)
    }

    /// In front of the words of a block that taps; the spindle turns at `turns` before it.
    pub fn begin(&mut self, turns: Option<f64>) {
        if self.open.is_none() {
            self.begins = Some(turns);
        }
    }

    /// The tap waits at its depth; false where none is there.
    pub fn wait(&mut self, seconds: f64) -> bool {
        let inside = self.open.as_mut().and_then(|open| open.inside.as_mut());
        if let Some((_, waits)) = inside {
            *waits += seconds;
            return true;
        }
        false
    }

    /// Words that cannot stand in a block that taps.
    pub fn take_only(&self, core: &Core<'_>, spindles: &Spindles, modal: GCode, w: &Words) -> Outcome {
        let master = |m: &&MWord| spindles.is_master(m.spindle);
        if let Some(m) = w.m.iter().filter(master).find(|m| matches!(m.number, 3..=5 | 19 | 70)) {
            return core.refuse(m.span, codes::S2045::m_stands_in_block_that_taps(&m.number));
        }
        if modal == GCode::G332 && self.is_inside() {
            nothing_at_the_depth(core, w)?;
        }
        if let Some(given) = w.get(Address::Spos).or(w.get(Address::Sposa)) {
            return core.refuse(given.span, codes::S2045::spos_stands_in_block_that_taps());
        }
        if let Some(s) = w.s.iter().find(|s| s.value < 0.0) {
            return core.refuse(s.span, codes::S2045::speed_s_is_negative_so_sign(&s.value));
        }
        match [Address::Rnd, Address::Chf, Address::Chr, Address::Frc].iter().find_map(|address| w.get(*address)) {
            Some(given) => core.refuse(given.span, misfit()),
            None => Ok(()),
        }
    }

    /// G331: the tap goes down, or farther down.
    fn go_in(&mut self, core: &Core<'_>, st: (&Spindles, &CtxRef), way: Way, span: Span) -> Outcome {
        let (spindles, ctx) = st;
        let Way { axis, lead, start, to } = way;
        let before = self.begins.take().flatten();
        let speed = spindles.fixed_turns(None).unwrap_or_default();
        let turn = if lead > 0.0 { Turn::Clockwise } else { Turn::CounterClockwise };
        let Some(open) = &mut self.open else {
            // Also one that other blocks followed: the spindle still stands there.
            let orient = self.angle.take().map(|(angle, _)| angle).or(spindles.angle());
            let tap = Tap {
                axis,
                start,
                surface: start,
                strokes: Vec::new(),
                lead: lead.abs(),
                turn,
                speed_in: None,
                speed_out: None,
                orient,
                pause: 0.0,
                again: None,
            };
            let (origin, ctx) = (core.here.origin, Rc::clone(ctx));
            let open = OpenTap { tap, origin, ctx, inside: Some((to, 0.0)), speeds: [speed; 2], before };
            self.open = Some(Box::new(open));
            return Ok(());
        };
        let same =
            open.tap.axis == axis && open.tap.turn == turn && (open.tap.lead - lead.abs()).abs() <= tolerance::LOST;
        let down = to - open.at();
        let deeper = down * (open.tap.strokes.first().map_or(open.at(), |stroke| stroke.to) - open.tap.start) > 0.0;
        let waits = open.inside.is_some_and(|(_, waits)| waits > 0.0);
        if !same || !deeper || waits || open.speeds[0] != speed {
            self.open = None;
            return core.refuse(span, codes::S2081::g331_goes_on_with_another_pitch());
        }
        if open.tap.strokes.len() >= MOST_PECKS {
            return core.refuse(span, codes::S2081::tap_makes_too_many_steps());
        }
        open.inside = Some((to, 0.0));
        Ok(())
    }

    /// G332: the tap comes back.
    fn come_out(&mut self, core: &Core<'_>, spindles: &Spindles, way: Way, span: Span) -> Outcome {
        let Way { axis, lead, to, .. } = way;
        let speed = spindles.fixed_turns(None).unwrap_or_default();
        let turn = if lead > 0.0 { Turn::Clockwise } else { Turn::CounterClockwise };
        let Some((open, (depth, dwell))) = self.open.as_mut().and_then(|open| open.inside.map(|inside| (open, inside)))
        else {
            return core.refuse(span, codes::S2081::g332_comes_back());
        };
        let from = open.tap.strokes.last().map_or(open.tap.start, |stroke| stroke.back);
        let same =
            open.tap.axis == axis && open.tap.turn == turn && (open.tap.lead - lead.abs()).abs() <= tolerance::LOST;
        let alike = open.tap.strokes.is_empty() || open.speeds[1] == speed;
        if !same || !alike || (to - depth) * (from - depth) <= 0.0 {
            self.open = None;
            return core.refuse(span, codes::S2081::g332_comes_back_with_another_pitch());
        }
        open.tap.strokes.push(Stroke { to: depth, back: to, dwell });
        (open.inside, open.speeds[1]) = (None, speed);
        Ok(())
    }
}

/// A stroke along an axis, with the lead of its thread.
struct Way {
    axis: Axis,
    lead: f64,
    start: f64,
    to: f64,
}

/// A hole between the first G331 and the block after the last G332.
#[derive(Debug, Clone)]
struct OpenTap {
    /// With the strokes that are complete.
    tap: Tap,
    /// The block of the first G331, and what held there.
    origin: Origin,
    ctx: CtxRef,
    /// The depth of the stroke that did not come back yet, and the seconds that it waits there.
    inside: Option<(f64, f64)>,
    /// Speeds of the way in and out.
    speeds: [f64; 2],
    /// The one before.
    before: Option<f64>,
}

impl OpenTap {
    /// Where it stands along its axis.
    fn at(&self) -> f64 {
        self.inside.map_or_else(|| self.tap.end(), |(depth, _)| depth)
    }
}

impl Spindles {
    fn can_tap(&self, core: &Core<'_>, kind: GCode, span: Span) -> Outcome {
        if kind.holds_cutting_speed() || self.is_cutting() {
            return core.refuse(span, codes::S2045::rigid_tapping_under_constant_cutting_speed());
        }
        match self.speed() {
            Some(speed) if speed > 0.0 => Ok(()),
            Some(_) => core.refuse(span, codes::S2045::speed_of_rigid_tapping_is_0()),
            None => core.refuse(span, codes::S2045::rigid_tapping_has_no_speed_s()),
        }
    }

    fn stand_after_tap(&mut self, core: &Core<'_>, code: GCode, span: Span) {
        if let Some(before) = self.turn() {
            self.set_turn(None);
            let (m, word) = (if before == Turn::Clockwise { "M3" } else { "M4" }, code.word());
            core.say_once(span, codes::S8041::spindle_stands_after(&word, &m));
        }
        self.forget_angle();
    }
}

/// What starts with the block of G332 would act while the tap is in the hole, and the tap is one move.
fn nothing_at_the_depth(core: &Core<'_>, w: &Words) -> Outcome {
    let m = w.m.iter().find(|m| !matches!(m.number, 0..=2 | COOLANT_OFF | 17 | 30));
    let tool = w.get(Address::T).map(|tool| ("T".to_owned(), tool.span));
    let Some((name, span)) = m.map(|m| (format!("M{}", m.number), m.span)).or(tool) else { return Ok(()) };
    core.refuse(span, codes::S2045::stands_in_block_of_g332(&name))
}

/// The tap follows one axis, which the frame leaves as it is.
fn taps_along(core: &Core<'_>, st: &State, axis: Axis, end: &Pos, w: &Words, span: Span) -> Outcome {
    let moves = |other: &Axis| match (end.get(*other), st.position.get(*other)) {
        (Some(to), Some(from)) => (to - from).abs() > tolerance::LOST,
        (to, _) => to.is_some(),
    };
    if let Some(other) = w.axes.iter().filter(|other| *other != axis).find(moves) {
        let given = w.axis(other).map(|given| given.span).unwrap_or_default();
        return core.refuse(given, codes::S2081::moves_beside_tapping_axis(&other.letter(), &axis.letter()));
    }
    if !moves(&axis) {
        return core.refuse(span, codes::S2081::does_not_move(&axis.letter()));
    }
    let column = st.ctx.frame.linear().column(axis.index());
    if (0..3).any(|row| column[row] != f64::from(u8::from(row == axis.index()))) {
        return core.refuse(span, codes::S9002::frame_turns(&axis.letter()));
    }
    Ok(())
}

impl Channel<'_> {
    /// The spindle stops at an angle: that of a tap, where the next block begins one.
    pub(super) fn stops_at_angle(&mut self, angle: f64, w: &Words, functions: usize) {
        let master = self.st.spindles.master();
        let alone = w.axes.is_empty() && w.m.len() == functions && w.codes.is_empty() && w.get(Address::T).is_none();
        if alone && master == MAIN_SPINDLE && w.beside.positioning.is_empty() && self.capture.is_none() {
            self.st.taps.angle = Some((angle, self.core.here.origin));
        } else {
            self.function(self.st.spindles.function(Spindle::Orient(angle)));
        }
    }

    /// The hole is complete; the spindle stands while no block taps.
    pub(super) fn tapping_ends(&mut self) {
        if let Some((angle, origin)) = self.st.taps.angle.take() {
            // No tap took it.
            let here = std::mem::replace(&mut self.core.here.origin, origin);
            self.function(self.st.spindles.function(Spindle::Orient(angle)));
            self.core.here.origin = here;
        }
        let Some(open) = self.st.taps.open.take() else { return };
        if open.inside.is_some() {
            let found = codes::S2081::g331_taps_down().at(open.origin.loc);
            let help = "program G332 to the height where G331 began after it, with nothing but G4 in between";
            self.core.report(found.help(help));
            self.st.position.lose(AxisSet::of(open.tap.axis));
            return self.lost();
        }
        let OpenTap { mut tap, origin, ctx, speeds: [speed_in, speed_out], before, .. } = *open;
        let now = self.st.spindles.fixed_turns(None);
        let changes = speed_in != speed_out || [before, now].iter().any(|speed| *speed != Some(speed_in));
        if changes {
            (tap.speed_in, tap.speed_out) = (Some(speed_in), Some(speed_out));
        }
        self.left.cuts(self.capture.is_some());
        self.core.send_tap_of(&tap, &ctx, &origin);
        if let Some(now) = now.filter(|_| changes) {
            self.function(self.st.spindles.function(Spindle::Speed(now)));
        }
        self.function(self.st.spindles.function(Spindle::Stop));
    }

    /// G331 and G332: along one axis, the spindle turning with it.
    pub(super) fn tap_block(&mut self, w: &mut Words, code: GCode, span: Span) -> Outcome {
        self.st.spindles.master_is_main(&self.core, span, "rigid tapping")?;
        self.st.spindles.can_tap(&self.core, self.st.codes.of(Group::FeedType), span)?;
        let end = self.st.targets(&self.core, w)?;
        if let Some(given) = w.lead(&self.core, &self.st)? {
            self.st.taps.lead = Some((given.axis, given.lead));
        }
        let Some((axis, lead)) = self.st.taps.lead else {
            return self.core.refuse(span, codes::S2081::tapped_thread_has_no_lead());
        };
        self.st.starts_are_known(&self.core, w, span)?;
        taps_along(&self.core, &self.st, axis, &end, w, span)?;
        let to = end.get(axis).unwrap_or_default();
        if self.capture.is_some() {
            self.send(&end, Path::Thread(Thread { lead: lead.abs(), along: Some(axis) }));
            return Ok(());
        }
        if self.st.offsets.in_machine() {
            return self.core.refuse(span, codes::S2081::hole_is_tapped_in_coordinates_of_machine());
        }
        let way = Way { axis, lead, start: self.st.position.get(axis).unwrap_or_default(), to };
        let st = &mut self.st;
        if code == GCode::G331 {
            st.taps.go_in(&self.core, (&st.spindles, &st.ctx), way, span)?;
        } else {
            st.taps.come_out(&self.core, &st.spindles, way, span)?;
        }
        st.spindles.stand_after_tap(&self.core, code, span);
        self.st.offsets.note_move(&self.core);
        if self.st.plane() != Plane::Xy {
            self.st.length_acts_along_z(&self.core);
        }
        self.st.heading.follow(&self.st.position, &end, &Path::Thread(Thread { lead: lead.abs(), along: Some(axis) }));
        self.st.position.move_to(&end);
        if code == GCode::G332 && w.m.iter().any(|m| m.number == COOLANT_OFF) {
            // At the end of the block the tap is back.
            self.tapping_ends();
            self.function(Function::Coolant(Coolant::Off));
        }
        Ok(())
    }
}
