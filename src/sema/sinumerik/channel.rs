//! The channel: what blocks do once the values of their words are known.
//!
//! It knows the modal state and where items go, and nothing of variables, formulas and programs, which [`super::Run`]
//! keeps above it.

use crate::ir::Function;
use crate::ir::contour::Sink;
use crate::machine::{AxisSet, Proposed};
use crate::sema::Job;
use crate::sema::run::Where;
use crate::sema::run::place::move_beside;

use super::axis_names::AxisNames;
use super::beside_path::CurveTable;
use super::capture::Capture;
use super::editor_contour::Stored;
use super::lane::Lane;
use super::left_behind::LeftBehind;
use super::probe_state::{Measured, Touched};
use super::soft_approach::Soft;
use super::synchronized::SetBeside;
use super::{Core, Outcome, Reported, State};

/// Modal state, and the machine that it is carried out on.
pub(super) struct Channel<'a> {
    pub core: Core<'a>,
    pub st: State,
    pub axis_names: AxisNames,
    /// Numbers proposed for tools without one.
    pub proposed: Proposed,
    /// The contour that is described now.
    pub capture: Option<Box<Capture>>,
    /// A soft approach that waits for its contour.
    pub soft: Option<Box<Soft>>,
    /// Blocks are of the ISO dialect, up to G290.
    pub iso: bool,
    /// Straight blocks that may take the lane.
    pub lane: Lane,
    /// What calls that are left out leave behind.
    pub left: LeftBehind,
    /// Values that synchronized actions set, which are left out.
    pub set_beside: SetBeside,
    /// The curve table that is described now.
    pub curve_table: Option<Box<CurveTable>>,
    /// Blocks and cycles that measure and are left out.
    pub measured: Measured,
}

impl<'a> Channel<'a> {
    pub fn new(job: &Job<'a>, out: &'a mut dyn Sink) -> Channel<'a> {
        Channel {
            core: Core::new(job, out),
            st: State::new(job.settings),
            axis_names: AxisNames::new(job.settings),
            proposed: Proposed::default(),
            capture: None,
            soft: None,
            iso: false,
            lane: Lane::Closed,
            left: LeftBehind::default(),
            set_beside: SetBeside::default(),
            curve_table: None,
            measured: Measured::default(),
        }
    }
}

impl Channel<'_> {
    pub(super) fn comment(&mut self, text: &[u8]) {
        if let Some(comment) = self.core.comment_of(text) {
            self.function(comment);
        }
    }

    /// A function, if there is one.
    pub(super) fn function(&mut self, function: impl Into<Option<Function>>) {
        let Some(function) = function.into() else { return };
        if let Some(capture) = &mut self.capture {
            return capture.function(&self.core, &function);
        }
        if self.st.compensation.is_leaving() && self.st.compensation.leaves_before(&self.core, &function).is_err() {
            return;
        }
        let origin = self.core.here.origin;
        if let Some(soft) = &mut self.soft {
            if soft.holds(&function, origin) {
                return;
            }
            let _: Outcome = self.soft_must_be_done();
        }
        if self.st.pair.holds(&function, origin) {
            return;
        }
        self.core.send_function(&function, &self.st.ctx);
    }

    /// Something that cannot stand between the two lines of a pair, or behind an approach without its contour.
    pub(super) fn pending_must_be_done(&mut self, place: impl Into<Where>) -> Outcome {
        self.soft_must_be_done()?;
        self.pair_must_be_done(place)
    }

    /// The same for an approach.
    pub(super) fn soft_must_be_done(&mut self) -> Outcome {
        let Some(soft) = self.soft.take() else { return Ok(()) };
        soft.report_open(&self.core);
        self.lose_all();
        Err(Reported)
    }

    /// The same for a pair, and for records of a contour without an end.
    pub(super) fn pair_must_be_done(&mut self, place: impl Into<Where>) -> Outcome {
        let st = &mut self.st;
        Stored::must_be_done(&mut st.stored, &self.core, &mut st.position)?;
        st.pair.must_be_done(&self.core, &mut st.position, place.into())
    }

    /// A move to these axes, before it: those that stand where a call or a probe left them have to be named.
    pub(super) fn leaves_touched(&mut self, axes: AxisSet, rapid: bool) -> Outcome {
        let (st, here) = (&mut self.st, self.core.here.origin.loc);
        let left = if self.capture.is_some() { AxisSet::EMPTY } else { st.position.left_by_calls() };
        let beside = move_beside(&st.position, left, axes, &st.ctx.frame, here);
        let touched = || Touched::moves(&mut st.touched, axes, rapid, &st.ctx.frame, here);
        let Some(found) = beside.or_else(touched) else { return Ok(()) };
        self.core.report(found);
        self.lose_all();
        Err(Reported)
    }

    /// Nobody knows where the tool is.
    pub(super) fn lost(&mut self) {
        self.core.send_lost(&self.st.ctx);
    }

    /// Some axes are not known any more: the output says the next place of each of them, whatever it was before.
    pub(super) fn only_known_axes_stand(&mut self) {
        self.lost();
        // Behind a transformation the output has other axes than the program: none of them is known better.
        if self.st.transformation.is_some() {
            self.st.position.forget(AxisSet::ALL);
        }
        let known = *self.st.position.at();
        self.core.stands_at(&known, &self.st.ctx);
    }

    /// Nothing is known behind this block; what only suffers from it is not worth another error.
    pub(super) fn lose_all(&mut self) {
        self.st.position.lose(AxisSet::ALL);
        self.st.pair.drop_first();
        self.lost();
    }
}
