//! Moves in step with the spindle: threads (G33).
//!
//! Source: S 0, 2.1, 7.2 and 7.3 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::geo::tolerance;
use crate::ir::Pos;
use crate::ir::contour::{Path, Thread};
use crate::machine::{Axis, AxisSet};
use crate::text::{Loc, Span};

use super::corners::Corners;
use super::g_groups::{GCode, Group};
use super::vocabulary::Address;
use super::words::{Given, Mode, Words};
use super::{Channel, Core, Outcome, Reported, State};

/// Start angle of threads without SF= (SD 42000).
pub(super) const START_ANGLE: &str = "$SC_THREAD_START_ANGLE";

/// Threads that later blocks go on with.
#[derive(Debug, Clone, Default)]
pub(super) struct Threads {
    /// Lead of the last thread and the axis along which it counts.
    lead: Option<(Axis, f64)>,
    chain: Option<ThreadChain>,
}

impl Threads {
    /// A block is to be asked whether it ends the chain.
    #[inline]
    pub fn are_open(&self) -> bool {
        self.chain.is_some()
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

    /// A block that is no move in step with the spindle may break a chain of threads.
    pub fn go_on_beside(&mut self, core: &Core<'_>, w: &Words) {
        if let Some(chain) = &mut self.chain {
            let broken = breaks_chain(w).map(|(span, alarm)| (core.loc(span), alarm));
            chain.broken = chain.broken.or(broken);
        }
    }

    /// A thread follows on another one without a stop and without auxiliary functions in between.
    fn chain_is_whole(&mut self, core: &Core<'_>, span: Span) -> Outcome {
        let Some(ThreadChain { last, broken: Some((place, alarm)) }) = self.chain.take() else {
            return Ok(());
        };
        let fault = if alarm == AUXILIARY {
            codes::S2081::auxiliary_function_stands_in_chain()
        } else {
            codes::S2081::axes_stand_in_chain()
        };
        let found = fault.alarm(alarm).at(place).also(last, Label::ThreadBefore);
        core.report(found.also(core.loc(span), Label::ThreadAfter));
        Err(Reported)
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

impl Words {
    /// I, J and K.
    pub fn lead(&mut self, core: &Core<'_>, st: &State) -> Outcome<Option<Lead>> {
        let mut found = None;
        let axes = st.machine.geometry_axes;
        for (address, axis) in [Address::I, Address::J, Address::K].into_iter().zip(axes) {
            let Some(lead) = self.take(address) else { continue };
            if lead.value == 0.0 {
                return core.refuse(lead.span, codes::S2081::lead_of_thread_is_0());
            }
            if !self.axes.contains(axis) {
                return core.refuse(lead.span, codes::S2081::lead_counts_along(&axis.letter()));
            }
            found = Some(Lead { axis, lead: lead.value * st.length_unit(), span: lead.span });
        }
        Ok(found)
    }
}

impl State {
    pub(super) fn starts_are_known(&self, core: &Core<'_>, w: &Words, span: Span) -> Outcome {
        match w.axes.iter().find(|axis| axis.is_main() && self.position.get(*axis).is_none()) {
            Some(axis) => self.unknown_axis(core, axis, span),
            None => Ok(()),
        }
    }
}

impl Corners {
    /// Whether a control cuts corners off threads is not documented.
    pub(super) fn none_at_thread(&self, core: &Core<'_>, w: &Words, span: Span) -> Outcome {
        let corner = [Address::Rnd, Address::Chf, Address::Chr].iter().find_map(|address| w.get(*address));
        if corner.is_none() && self.rounding() == 0.0 {
            return Ok(());
        }
        let span = corner.map_or(span, |given| given.span);
        core.refuse(span, codes::S2071::thread_has_no_corner_to_chamfer())
    }
}

impl Channel<'_> {
    /// G33
    pub(super) fn thread_block(&mut self, w: &mut Words, span: Span) -> Outcome {
        self.st.spindles.master_is_main(&self.core, span, "the lead of a thread")?;
        self.speed_is_known()?;
        if self.st.spindles.turn().is_none() && self.core.job.diags.first_time(codes::S8034, ()) {
            let found = codes::S8034::no_block_in_front_of_this_thread().at(self.core.loc(span));
            self.core.report(found.help("program M3 or M4 with a speed before the thread"));
        }
        let follows = self.st.threads.chain.is_some();
        self.st.threads.chain_is_whole(&self.core, span)?;
        let end = self.st.targets(&self.core, w)?;
        let named = w.take(Address::Sf).map(|given| ("SF", given));
        // The setting is for the first thread of a chain.
        let set = || {
            let value = self.st.system.number(START_ANGLE).filter(|_| !follows)?;
            Some((START_ANGLE, Given { value, mode: Mode::Plain, span }))
        };
        let start_angle = named.or_else(set).filter(|(_, given)| given.value != 0.0);
        if let Some(given) = w.lead(&self.core, &self.st)? {
            if given.lead < 0.0 {
                return self.core.refuse(given.span, codes::S2081::lead_of_thread_is_negative());
            }
            self.st.threads.lead = Some((given.axis, given.lead));
        }
        let Some((axis, lead)) = self.st.threads.lead else {
            return self.core.refuse(span, codes::S2081::thread_has_no_lead());
        };
        self.st.starts_are_known(&self.core, w, span)?;
        let way = |axis: Axis| match (end.get(axis), self.st.position.get(axis)) {
            (Some(to), Some(from)) => (to - from).abs(),
            _ => 0.0,
        };
        if let Some(longer) = AxisSet::MAIN.iter().find(|other| way(*other) > way(axis) + tolerance::LOST) {
            return self.core.refuse(span, codes::S2081::lead_is_given_along(&axis.letter(), &longer.letter()));
        }
        if let Some((word, given)) = start_angle {
            let start = shifted_start(&self.core, &self.st, word, given, &end, (axis, lead), follows)?;
            self.send(&start, Path::Rapid);
        }
        self.send(&end, Path::Thread(Thread { lead, along: Some(axis) }));
        let broken = standstill_behind(w).map(|span| (self.core.loc(span), STANDSTILL));
        self.st.threads.chain = Some(ThreadChain { last: self.core.here.origin.loc, broken });
        Ok(())
    }
}

/// SF: the thread begins at an angle of the spindle, the one of the target at its zero mark. Begun farther back by
/// lead · angle / 360, it passes the programmed start at that angle, and is the same thread from there on.
fn shifted_start(
    core: &Core<'_>,
    st: &State,
    word: &str,
    start: Given,
    end: &Pos,
    (axis, lead): (Axis, f64),
    follows: bool,
) -> Outcome<Pos> {
    if !(0.0..360.0).contains(&start.value) {
        return core.refuse(start.span, codes::S9012::start_angle_lies_outside_0_to_359(&word, &start.value));
    }
    let why = if follows {
        "this thread follows on another one, which fixes its angle"
    } else if st.corners.open.is_open() {
        "a chamfer or rounding stands before the thread"
    } else if !st.ctx.frame.is_shift() {
        "the frame is turned, mirrored or scaled"
    } else {
        ""
    };
    if !why.is_empty() {
        return core.refuse(start.span, codes::S9012::start_angle_of_thread_cannot_be_made(&why));
    }
    let back = lead * start.value / 360.0;
    let (Some(to), Some(from)) = (end.get(axis), st.position.get(axis)) else { return Err(Reported) };
    if (to - from).abs() <= tolerance::LOST {
        return core.refuse(start.span, codes::S2081::thread_does_not_move_along_its_lead());
    }
    // The start lies on the line of the thread, tapered ones included.
    let part = back / (to - from).abs();
    let mut shifted = Pos::UNKNOWN;
    for axis in AxisSet::MAIN.iter() {
        if let (Some(to), Some(from)) = (end.get(axis), st.position.get(axis)) {
            shifted.set(axis, from - (to - from) * part);
        }
    }
    let found = codes::S8133::is_made_by_start_that_lies_mm(&word, &start.value, &back, &axis.letter())
        .at(core.loc(start.span));
    core.report(found.help("see that nothing stands there"));
    Ok(shifted)
}

/// A lead word: mm per turn with its sign, and the axis along which it counts.
pub(super) struct Lead {
    pub axis: Axis,
    pub lead: f64,
    pub span: Span,
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
