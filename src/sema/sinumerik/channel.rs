//! The channel: what blocks do once the values of their words are known.
//!
//! It knows the modal state and where items go, and nothing of variables, formulas and programs, which [`super::Run`]
//! keeps above it.

use crate::ir::Function;
use crate::ir::contour::Sink;
use crate::machine::Proposed;
use crate::sema::Job;
use crate::text::Loc;

use super::Core;
use super::axis_names::AxisNames;
use super::beside_path::CurveTable;
use super::capture::Capture;
use super::lane::Lane;
use super::lost_change::LeftOut;
use super::probe_state::Measured;
use super::soft_approach::Soft;
use super::state::State;
use super::synchronized::SetBeside;

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
    /// What a call that is left out may have changed in.
    pub change_left_out: Option<Box<LeftOut>>,
    /// A call that stands for a program of the machine, until a G code of the path follows: its name and place.
    pub motion_left: Option<Box<(String, Loc)>>,
    /// The last call that stands for a program of the machine.
    pub call_left: Option<Box<(String, Loc)>>,
    /// The call that leaves a speed that is not known, until S is programmed.
    pub speed_lost: Option<Box<(String, Loc)>>,
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
            change_left_out: None,
            motion_left: None,
            call_left: None,
            speed_lost: None,
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

    pub(super) fn function(&mut self, function: Function) {
        if self.capture.is_some() && self.function_in_contour(&function) {
            return;
        }
        if self.st.compensation.is_leaving() && self.leaves_in_front_of(&function).is_err() {
            return;
        }
        if self.soft.is_some() && self.held_by_approach(&function) {
            return;
        }
        if self.st.pair.is_open() && self.held_back(&function) {
            return;
        }
        self.core.send_function(&function, &self.st.ctx);
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
            self.st.position.forget(crate::machine::AxisSet::ALL);
        }
        let known = *self.st.position.at();
        self.core.stands_at(&known, &self.st.ctx);
    }

    /// Nothing is known behind this block; what only suffers from it is not worth another error.
    pub(super) fn lose_all(&mut self) {
        self.st.position.lose(crate::machine::AxisSet::ALL);
        self.st.pair.drop_first();
        self.lost();
    }
}
