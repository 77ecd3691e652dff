//! Moves in step with the spindle: threads (G33) and rigid tapping (G331, G332).
//!
//! Source: S 0, 2.1, 7.2 and 7.3 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Diagnostic, codes};
use crate::geo::Plane;
use crate::ir::contour::{CtxRef, Path, Thread};
use crate::ir::cycle::drilling::MOST_PECKS;
use crate::ir::function::{Spindle, Turn};
use crate::ir::tap::Stroke;
use crate::ir::{Origin, Pos, Tap};
use crate::machine::{Axis, AxisSet};
use crate::text::{Loc, Span};

use super::g_groups::{GCode, Group};
use super::vocabulary::Address;
use super::words::{Given, MWord, Mode, Words};
use super::{Channel, Outcome, Reported};

/// Farthest that an axis may stand off its programmed place and still not move, in mm.
const STILL: f64 = 1e-9;

/// Start angle of threads without SF= (SD 42000).
const START_ANGLE: &str = "$SC_THREAD_START_ANGLE";

/// Threads and taps that later blocks go on with.
#[derive(Debug, Clone, Default)]
pub(super) struct Threads {
    /// Lead of the last thread and the axis along which it counts.
    lead: Option<(Axis, f64)>,
    /// The same of the last tap, with its sign.
    tap_lead: Option<(Axis, f64)>,
    /// A hole that blocks tap, which waits for their end.
    open: Option<Box<OpenTap>>,
    chain: Option<ThreadChain>,
}

impl Threads {
    /// A block is to be asked whether it ends the tap or the chain.
    #[inline]
    pub fn are_open(&self) -> bool {
        self.open.is_some() || self.chain.is_some()
    }

    /// The next thread does not follow on another one.
    #[inline]
    pub fn end_chain(&mut self) {
        self.chain = None;
    }

    /// A contour names the lead of its threads itself.
    pub fn forget_lead(&mut self) {
        self.lead = None;
    }
}

/// A hole between the first G331 and the block behind the last G332.
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
}

impl OpenTap {
    /// Where it stands along its axis.
    fn at(&self) -> f64 {
        self.inside.map_or_else(|| self.tap.end(), |(depth, _)| depth)
    }
}

/// A thread block that another one may follow on.
#[derive(Debug, Clone, Copy)]
struct ThreadChain {
    last: Loc,
    /// What interrupts the chain from here on, and the alarm of a thread that follows all the same.
    broken: Option<(Loc, u32)>,
}

/// Auxiliary function in a chain of threads, and standstill between two of them.
const AUXILIARY: u32 = 10600;
const STANDSTILL: u32 = 10601;

impl Channel<'_> {
    /// Rigid tapping: in, or out again.
    fn goes_on_tapping(&self, w: &Words) -> bool {
        let code = w.code_of(Group::Motion).map_or(self.st.codes.of(Group::Motion), |(code, _)| code);
        let shaped = [Group::Nonmodal, Group::Frame, Group::Buffer, Group::Suppression];
        code.is_tapping()
            && !w.axes.is_empty()
            && shaped.iter().all(|group| w.code_of(*group).is_none())
            && !self.acts_in_tap(w)
    }

    /// A function that would act inside the tap, which is one move: that of its first block acts in front of it, stops and ends of
    /// programs behind it.
    fn acts_in_tap(&self, w: &Words) -> bool {
        let acts = w.m.iter().any(|m| !matches!(m.number, 0..=5 | 17 | 30)) || w.get(Address::T).is_some();
        acts && self.st.threads.open.is_some()
    }

    /// A block that may stand inside a tap: one without a move, a function or a G function, and a dwell at the depth.
    fn rests_in_tap(&self, w: &Words) -> bool {
        let inside = self.st.threads.open.as_ref().is_some_and(|open| open.inside.is_some());
        let dwells = w.code_of(Group::Nonmodal).is_some_and(|(code, _)| code == GCode::G4);
        let idle = w.axes.is_empty() && w.m.is_empty() && w.get(Address::T).is_none();
        idle && (w.codes.is_empty() || inside && dwells)
    }

    /// A block that is no move in step with the spindle ends the tapping, and may break a chain of threads.
    #[cold]
    pub(super) fn beside_threads(&mut self, w: &Words) {
        if self.st.threads.open.is_some() && !self.goes_on_tapping(w) && !self.rests_in_tap(w) {
            self.tapping_ends();
        }
        if self.st.threads.chain.is_some() {
            let broken = breaks_chain(w).map(|(span, alarm)| (self.loc(span), alarm));
            if let Some(chain) = &mut self.st.threads.chain {
                chain.broken = chain.broken.or(broken);
            }
        }
    }

    /// The tap waits at its depth; false where none is there.
    pub(super) fn waits_in_tap(&mut self, seconds: f64) -> bool {
        let inside = self.st.threads.open.as_mut().and_then(|open| open.inside.as_mut());
        if let Some((_, waits)) = inside {
            *waits += seconds;
            return true;
        }
        false
    }

    /// The hole is complete; the spindle stands while no block taps.
    pub(super) fn tapping_ends(&mut self) {
        let Some(open) = self.st.threads.open.take() else { return };
        if open.inside.is_some() {
            let found = Diagnostic::new(codes::S2081, open.origin.loc, "G331 taps down, and no G332 comes back");
            let help = "program G332 to the height in front of G331 behind it, with nothing but G4 in between";
            self.report(found.help(help));
            self.st.position.lose(AxisSet::of(open.tap.axis));
            return self.lost();
        }
        let OpenTap { mut tap, origin, ctx, speeds: [speed_in, speed_out], .. } = *open;
        let now = self.st.spindles.speed();
        let changes = speed_in != speed_out || now != Some(speed_in);
        if changes {
            (tap.speed_in, tap.speed_out) = (Some(speed_in), Some(speed_out));
        }
        self.cuts_in_between();
        self.core.send_tap_of(&tap, &ctx, &origin);
        if let Some(now) = now.filter(|_| changes) {
            self.send_spindle(self.st.spindles.master(), Spindle::Speed(now));
        }
        self.send_spindle(self.st.spindles.master(), Spindle::Stop);
    }

    /// G33
    pub(super) fn thread_block(&mut self, w: &mut Words, span: Span) -> Outcome {
        self.master_is_main(span, "the lead of a thread")?;
        self.speed_is_known()?;
        if self.st.spindles.turn().is_none() && self.job.diags.first_time(codes::S8034) {
            let found =
                Diagnostic::new(codes::S8034, self.loc(span), "no block in front of this thread starts the spindle");
            self.report(found.help("program M3 or M4 with a speed in front of the thread"));
        }
        let follows = self.st.threads.chain.is_some();
        self.chain_is_whole(span)?;
        let end = self.targets(w)?;
        let named = w.take(Address::Sf).map(|given| ("SF", given));
        // The setting is for the first thread of a chain.
        let set = || self.start_angle_by_setting(span).filter(|_| !follows).map(|given| (START_ANGLE, given));
        let start_angle = named.or_else(set).filter(|(_, given)| given.value != 0.0);
        if let Some(given) = self.lead_words(w)? {
            if given.lead < 0.0 {
                let help = "the spindle makes the hand of the thread: M3 or M4; program the lead without a sign";
                return self.fail_help(codes::S2081, given.span, "the lead of the thread is negative", help);
            }
            self.st.threads.lead = Some((given.axis, given.lead));
        }
        let Some((axis, lead)) = self.st.threads.lead else {
            return self.fail_help(
                codes::S2081.alarm(16720),
                span,
                "the thread has no lead",
                "program K along Z, I along X",
            );
        };
        self.starts_are_known(w, span)?;
        let way = |axis: Axis| match (end.get(axis), self.st.position.get(axis)) {
            (Some(to), Some(from)) => (to - from).abs(),
            _ => 0.0,
        };
        if let Some(longer) = AxisSet::MAIN.iter().find(|other| way(*other) > way(axis) + STILL) {
            let message = format!("the lead is given along {}, but {} moves further", axis.letter(), longer.letter());
            return self.fail_help(
                codes::S2081.alarm(16730),
                span,
                message,
                "give the lead along the axis that moves further",
            );
        }
        if let Some((word, given)) = start_angle {
            self.shift_start(word, given, &end, (axis, lead), follows)?;
        }
        self.send(&end, Path::Thread(Thread { lead, along: Some(axis) }));
        let broken = standstill_behind(w).map(|span| (self.loc(span), STANDSTILL));
        self.st.threads.chain = Some(ThreadChain { last: self.here.origin.loc, broken });
        Ok(())
    }

    /// SF: the thread begins at an angle of the spindle, the one of the target at its zero mark. Begun farther back by
    /// lead · angle / 360, it passes the programmed start at that angle, and is the same thread from there on.
    fn shift_start(
        &mut self,
        word: &str,
        start: Given,
        end: &Pos,
        (axis, lead): (Axis, f64),
        follows: bool,
    ) -> Outcome {
        if !(0.0..360.0).contains(&start.value) {
            let message = format!("the start angle {word}={} lies outside 0 to 359.999", start.value);
            return self.fail_help(codes::S9012, start.span, message, "program the angle within one turn");
        }
        let why = if follows {
            "this thread follows on another one, which fixes its angle"
        } else if self.st.corners.open.is_open() {
            "a chamfer or rounding stands in front of the thread"
        } else if !self.st.ctx.frame.is_shift() {
            "the frame is turned, mirrored or scaled"
        } else {
            ""
        };
        if !why.is_empty() {
            let message = format!("the start angle of the thread cannot be made by a shift of its start: {why}");
            let help = "program the start point farther back by lead · angle / 360, and no SF=";
            return self.fail_help(codes::S9012, start.span, message, help);
        }
        let back = lead * start.value / 360.0;
        let (Some(to), Some(from)) = (end.get(axis), self.st.position.get(axis)) else { return Err(Reported) };
        if (to - from).abs() <= STILL {
            return self.fail(codes::S2081.alarm(16740), start.span, "the thread does not move along its lead");
        }
        // The start lies on the line of the thread, tapered ones included.
        let part = back / (to - from).abs();
        let mut shifted = Pos::UNKNOWN;
        for axis in AxisSet::MAIN.iter() {
            if let (Some(to), Some(from)) = (end.get(axis), self.st.position.get(axis)) {
                shifted.set(axis, from - (to - from) * part);
            }
        }
        let message = format!(
            "{word}={} is made by a start that lies {back:.4} mm farther back along {}, where the tool goes at rapid",
            start.value,
            axis.letter()
        );
        let found = Diagnostic::new(codes::S8133, self.loc(start.span), message);
        self.report(found.help("see that nothing stands there"));
        self.send(&shifted, Path::Rapid);
        Ok(())
    }

    /// A thread without SF= starts at the angle of SD 42000.
    fn start_angle_by_setting(&self, span: Span) -> Option<Given> {
        let value = self.st.system.number(START_ANGLE)?;
        Some(Given { value, mode: Mode::Plain, span })
    }

    /// What a thread cycle makes of that setting is not confirmed.
    pub(super) fn no_start_angle_by_setting(&self, span: Span) -> Outcome {
        match self.start_angle_by_setting(span).filter(|given| given.value != 0.0) {
            Some(Given { value, .. }) => {
                let message = format!("whether `{START_ANGLE}={value}` holds for the threads of a cycle is not known");
                let help = format!("set it to 0 in front of the cycle: {START_ANGLE}=0");
                self.fail_help(codes::S9012, span, message, &help)
            }
            None => Ok(()),
        }
    }

    /// Whether a control cuts corners off threads is not documented.
    pub(super) fn no_corner_at_thread(&self, w: &Words, span: Span) -> Outcome {
        let corner = [Address::Rnd, Address::Chf, Address::Chr].iter().find_map(|address| w.get(*address));
        if corner.is_none() && self.st.corners.rounding() == 0.0 {
            return Ok(());
        }
        let span = corner.map_or(span, |given| given.span);
        let help = "program the transition as elements of its own, and RNDM=0 in front of the thread";
        self.fail_help(codes::S2071, span, "a thread has no corner to chamfer or round", help)
    }

    /// G331 and G332: along one axis, the spindle turning with it.
    pub(super) fn tap_block(&mut self, w: &mut Words, code: GCode, span: Span) -> Outcome {
        self.master_is_main(span, "rigid tapping")?;
        self.tapping_speed(span)?;
        let end = self.targets(w)?;
        if let Some(given) = self.lead_words(w)? {
            self.st.threads.tap_lead = Some((given.axis, given.lead));
        }
        let Some((axis, lead)) = self.st.threads.tap_lead else {
            let help = "program K along Z: positive for a right-hand thread, negative for a left-hand one";
            return self.fail_help(codes::S2081.alarm(16720), span, "the tapped thread has no lead", help);
        };
        self.starts_are_known(w, span)?;
        self.taps_along(axis, &end, w, span)?;
        let to = end.get(axis).unwrap_or_default();
        if self.is_capturing() {
            self.send(&end, Path::Thread(Thread { lead: lead.abs(), along: Some(axis) }));
            return Ok(());
        }
        if self.st.offsets.in_machine() {
            let help = "select a work offset (G54) in front of the hole";
            return self.fail_help(codes::S2081, span, "a hole is tapped in coordinates of the machine", help);
        }
        if code == GCode::G331 {
            self.taps_in((axis, lead), to, span)?
        } else {
            self.taps_out((axis, lead), to, span)?
        }
        self.stands_behind_tap(code, span);
        self.note_outer();
        if self.st.plane() != Plane::Xy {
            self.length_acts_along_z();
        }
        self.note_heading(&end, &Path::Thread(Thread { lead: lead.abs(), along: Some(axis) }));
        self.st.position.move_to(&end);
        Ok(())
    }

    /// G331: the tap goes down, or farther down.
    fn taps_in(&mut self, (axis, lead): (Axis, f64), to: f64, span: Span) -> Outcome {
        let start = self.st.position.get(axis).unwrap_or_default();
        let speed = self.st.spindles.speed().unwrap_or_default();
        let turn = if lead > 0.0 { Turn::Clockwise } else { Turn::CounterClockwise };
        let Some(open) = &mut self.st.threads.open else {
            let tap = Tap {
                axis,
                start,
                surface: start,
                strokes: Vec::new(),
                lead: lead.abs(),
                turn,
                speed_in: None,
                speed_out: None,
                orient: None,
                pause: 0.0,
                again: None,
            };
            let (origin, ctx) = (self.here.origin, Rc::clone(&self.st.ctx));
            let open = OpenTap { tap, origin, ctx, inside: Some((to, 0.0)), speeds: [speed; 2] };
            self.st.threads.open = Some(Box::new(open));
            return Ok(());
        };
        let same = open.tap.axis == axis && open.tap.turn == turn && (open.tap.lead - lead.abs()).abs() <= STILL;
        let down = to - open.at();
        let deeper = down * (open.tap.strokes.first().map_or(open.at(), |stroke| stroke.to) - open.tap.start) > 0.0;
        let waits = open.inside.is_some_and(|(_, waits)| waits > 0.0);
        if !same || !deeper || waits || open.speeds[0] != speed {
            let message = "G331 goes on with another pitch, at another speed or in another direction";
            let help = "program the steps of one hole alike, or retract by G0 between two holes";
            self.st.threads.open = None;
            return self.fail_help(codes::S2081, span, message, help);
        }
        if open.tap.strokes.len() >= MOST_PECKS {
            return self.fail(codes::S2081, span, "the tap makes too many steps");
        }
        open.inside = Some((to, 0.0));
        Ok(())
    }

    /// G332: the tap comes back.
    fn taps_out(&mut self, (axis, lead): (Axis, f64), to: f64, span: Span) -> Outcome {
        let speed = self.st.spindles.speed().unwrap_or_default();
        let turn = if lead > 0.0 { Turn::Clockwise } else { Turn::CounterClockwise };
        let Some((open, (depth, dwell))) =
            self.st.threads.open.as_mut().and_then(|open| open.inside.map(|inside| (open, inside)))
        else {
            let help = "program G331 down to the depth in front of it, and one G332 back";
            return self.fail_help(codes::S2081, span, "G332 comes back, and no G331 went down", help);
        };
        let from = open.tap.strokes.last().map_or(open.tap.start, |stroke| stroke.back);
        let same = open.tap.axis == axis && open.tap.turn == turn && (open.tap.lead - lead.abs()).abs() <= STILL;
        let alike = open.tap.strokes.is_empty() || open.speeds[1] == speed;
        if !same || !alike || (to - depth) * (from - depth) <= 0.0 {
            let message = "G332 comes back with another pitch, at another speed than before, or not back";
            let help = "program the lead of G331 and a height towards its start";
            self.st.threads.open = None;
            return self.fail_help(codes::S2081, span, message, help);
        }
        open.tap.strokes.push(Stroke { to: depth, back: to, dwell });
        (open.inside, open.speeds[1]) = (None, speed);
        Ok(())
    }

    fn stands_behind_tap(&mut self, code: GCode, span: Span) {
        if let Some(before) = self.st.spindles.turn() {
            self.st.spindles.set_turn(None);
            let (m, word) = (if before == Turn::Clockwise { "M3" } else { "M4" }, code.word());
            let message = format!("the spindle stands behind {word}: the {m} in front of it does not count any more");
            self.note_once(codes::S8041, span, message);
        }
        self.st.spindles.forget_angle();
    }

    /// Words that cannot stand in a block that taps.
    pub(super) fn only_tapping(&self, w: &Words) -> Outcome {
        let master = |m: &&MWord| self.st.spindles.is_master(m.spindle);
        if let Some(m) = w.m.iter().filter(master).find(|m| matches!(m.number, 3..=5 | 19 | 70)) {
            let message = format!("M{} stands in a block that taps", m.number);
            let help =
                "leave it out: the sign of the lead turns the spindle, which stands in front of and behind the tap";
            return self.fail_help(codes::S2045, m.span, message, help);
        }
        if let Some(given) = w.get(Address::Spos).or(w.get(Address::Sposa)) {
            let help = "give SPOS= a block of its own in front of G331";
            return self.fail_help(codes::S2045, given.span, "SPOS= stands in a block that taps", help);
        }
        if let Some(s) = w.s.iter().find(|s| s.value < 0.0) {
            let help = "the sign of the lead turns the spindle; program S without a sign";
            return self.fail_help(
                codes::S2045.alarm(16763),
                s.span,
                format!("the speed S{} is negative", s.value),
                help,
            );
        }
        match [Address::Rnd, Address::Chf, Address::Chr, Address::Frc].iter().find_map(|address| w.get(*address)) {
            Some(given) => self.does_not_fit(given.span),
            None => Ok(()),
        }
    }

    fn tapping_speed(&self, span: Span) -> Outcome {
        if self.st.codes.of(Group::FeedType).holds_cutting_speed() || self.st.spindles.is_cutting() {
            return self.fail_help(
                codes::S2045,
                span,
                "rigid tapping under a constant cutting speed (G96): the speed of the spindle is not fixed",
                "program G97 with S in turns per minute in front of it",
            );
        }
        let help = "program S in this block or before";
        match self.st.spindles.speed() {
            Some(speed) if speed > 0.0 => Ok(()),
            Some(_) => self.fail_help(codes::S2045.alarm(16763), span, "the speed of rigid tapping is 0", help),
            None => self.fail_help(codes::S2045.alarm(16760), span, "rigid tapping has no speed S", help),
        }
    }

    /// The tap follows one axis, which the frame leaves as it is.
    fn taps_along(&self, axis: Axis, end: &Pos, w: &Words, span: Span) -> Outcome {
        let moves = |other: &Axis| match (end.get(*other), self.st.position.get(*other)) {
            (Some(to), Some(from)) => (to - from).abs() > STILL,
            (to, _) => to.is_some(),
        };
        if let Some(other) = w.axes.iter().filter(|other| *other != axis).find(moves) {
            let given = w.axis(other).map(|given| given.span).unwrap_or_default();
            let message = format!("{} moves beside the tapping axis {}", other.letter(), axis.letter());
            let help = "position the tool over the hole in a block in front of G331";
            return self.fail_help(codes::S2081, given, message, help);
        }
        if !moves(&axis) {
            let message = format!("{} does not move, so nothing is tapped", axis.letter());
            return self.fail_help(codes::S2081.alarm(16740), span, message, "program the depth of the hole");
        }
        let column = self.st.ctx.frame.linear().column(axis.index());
        if (0..3).any(|row| column[row] != f64::from(u8::from(row == axis.index()))) {
            let message = format!("the frame turns, mirrors or scales {}, along which the block taps", axis.letter());
            let help = "end the frame in front of G331, and program the hole in plain coordinates";
            return self.fail_help(codes::S9002, span, message, help);
        }
        Ok(())
    }

    /// I, J and K.
    fn lead_words(&mut self, w: &mut Words) -> Outcome<Option<Lead>> {
        let mut found = None;
        let axes = self.st.machine.geometry_axes;
        for (address, axis) in [Address::I, Address::J, Address::K].into_iter().zip(axes) {
            let Some(lead) = w.take(address) else { continue };
            if lead.value == 0.0 {
                return self.fail(codes::S2081.alarm(16720), lead.span, "the lead of the thread is 0");
            }
            if !w.axes.contains(axis) {
                let message = format!("the lead counts along {}, which the block does not move", axis.letter());
                return self.fail(codes::S2081.alarm(16730), lead.span, message);
            }
            found = Some(Lead { axis, lead: lead.value * self.st.length_unit(), span: lead.span });
        }
        Ok(found)
    }

    fn starts_are_known(&self, w: &Words, span: Span) -> Outcome {
        match w.axes.iter().find(|axis| axis.is_main() && self.st.position.get(*axis).is_none()) {
            Some(axis) => self.unknown_axis(axis, span),
            None => Ok(()),
        }
    }

    /// A thread follows on another one without a stop and without auxiliary functions in between.
    fn chain_is_whole(&mut self, span: Span) -> Outcome {
        let Some(ThreadChain { last, broken: Some((place, alarm)) }) = self.st.threads.chain.take() else {
            return Ok(());
        };
        let (message, help) = if alarm == AUXILIARY {
            (
                "an auxiliary function stands in a chain of threads",
                "program M, S, T and H words in front of the first thread or behind the last",
            )
        } else {
            (
                "the axes stand between two threads of a chain, which spoils the thread",
                "leave the stop out, or retract and start the second thread anew",
            )
        };
        let found = Diagnostic::new(codes::S2081.alarm(alarm), place, message);
        self.report(found.also(last, "the thread before").also(self.loc(span), "the thread behind").help(help));
        Err(Reported)
    }
}

/// A lead word: mm per turn with its sign, and the axis along which it counts.
struct Lead {
    axis: Axis,
    lead: f64,
    span: Span,
}

/// A word that does not belong between two threads, and the alarm for it.
fn breaks_chain(w: &Words) -> Option<(Span, u32)> {
    let dwell = w.code_of(Group::Nonmodal).filter(|(code, _)| *code == GCode::G4).map(|(_, span)| span);
    let stop = w.get(Address::Spos).or(w.get(Address::Sposa)).map(|given| given.span);
    if let Some(span) = dwell.or(stop).or(standstill_behind(w)) {
        return Some((span, STANDSTILL));
    }
    let auxiliary = w.m.first().map(|m| m.span).or(w.s.first().map(|s| s.span)).or(w.h);
    auxiliary.or(w.get(Address::T).map(|t| t.span)).map(|span| (span, AUXILIARY))
}

/// M0, M1 and G9: the axes stand at the end of the block.
fn standstill_behind(w: &Words) -> Option<Span> {
    let stop = w.m.iter().find(|m| matches!(m.number, 0 | 1)).map(|m| m.span);
    stop.or(w.code_of(Group::ExactStopBlock).map(|(_, span)| span))
}
