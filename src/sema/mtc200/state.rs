//! Modal state of an MTC200 program.

use std::rc::Rc;

use crate::geo::Plane;
use crate::ir::contour::{Ctx, CtxRef};
use crate::machine::{Axis, AxisSet, MachineKind, Settings, Unit};
use crate::sema::common::compensation::Compensation;
use crate::sema::common::feed::{FeedKind, ModalFeed};
use crate::sema::common::position::Position;
use crate::sema::common::spindle::{ModalSpindle, SpeedKind};
use crate::sema::common::start::Start;

use super::dimensions::Dimensions;
use super::g_functions::{G, Motion};
use super::length::Length;
use super::offsets::{Offset, OffsetState};
use super::path::Corners;
use super::tool::{ToolInUse, Transition};

/// The kind of motion in force.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct MotionCode {
    code: Option<Motion>,
    /// A block was refused that may have named it.
    lost: bool,
}

impl MotionCode {
    #[inline]
    pub fn code(&self) -> Option<Motion> {
        self.code
    }

    pub fn is_lost(&self) -> bool {
        self.lost
    }

    pub fn program(&mut self, motion: Motion) {
        self.code = Some(motion);
    }

    pub fn lose(&mut self) {
        self.lost = true;
    }
}

/// Everything that one block leaves to the next. Positions are mm (X: radius) and degrees in the
/// programmed system.
#[derive(Debug)]
pub(super) struct State {
    /// The number that the program wrote last is left alone by a changed offset.
    pub position: Position,
    pub motion: MotionCode,
    pub dimensions: Dimensions,
    pub length: Length,
    /// G61.
    pub exact_stop: bool,
    pub feed: ModalFeed,
    /// G94 or G95 was programmed.
    pub feed_said: bool,
    pub compensation: Compensation,
    pub transition: Transition,
    pub offsets: OffsetState,
    pub spindle: ModalSpindle,
    pub tool: ToolInUse,
    pub corners: Corners,
    pub ctx: CtxRef,
}

impl State {
    pub fn new(settings: &Settings) -> State {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let plane = if lathe { Plane::Zx } else { Plane::Xy };
        let diameter = lathe && settings.machine.diameter_axis == Some(Axis::X) && settings.machine.power_on_diameter;
        let mut start = Start::new(settings, diameter);
        for (axis, value) in &settings.control.mtc200.start {
            start.complete(*axis, *value);
        }
        let written = start.position().known();
        let inch = settings.control.unit == Some(Unit::Inch);
        State {
            position: Position::new(start),
            motion: MotionCode::default(),
            dimensions: Dimensions { inch, diameter, ..Dimensions::default() },
            length: Length::default(),
            exact_stop: false,
            feed: ModalFeed::new(settings.control.feed, Some(FeedKind::PerMinute)),
            feed_said: false,
            compensation: Compensation::default(),
            transition: Transition::default(),
            offsets: OffsetState::new(written),
            spindle: ModalSpindle::counting(SpeedKind::Turns),
            tool: ToolInUse::default(),
            corners: Corners::default(),
            ctx: Rc::new(Ctx { plane, ..Ctx::default() }),
        }
    }

    /// The position of these axes is no longer known in the programmed system.
    pub fn forget(&mut self, axes: AxisSet) {
        self.position.forget_place(axes);
        self.position.not_lost(axes);
    }

    /// A block that names `g` was refused: it holds for the next ones all the same, so that they are not refused as well.
    pub fn assume(&mut self, g: G) {
        match g {
            G::Motion(motion) => self.motion.program(motion),
            G::Incremental(on) => self.dimensions.incremental = on,
            G::Diameter(on) => self.dimensions.diameter = on,
            G::Inch(on) => self.dimensions.inch = on,
            G::ExactStop(on) => self.exact_stop = on,
            G::PerRevolution(on) => self.feed.assume(FeedKind::per_revolution(on)),
            _ => {}
        }
    }

    /// All modal states as at the start; the tool stays where it is, and so does the work offset.
    pub fn reset(&mut self, settings: &Settings) {
        let old = std::mem::replace(self, State::new(settings));
        // The end of a program cancels the programmed offset: positions count from the work offset again.
        self.position = old.position;
        self.position.through_frame(&old.ctx.frame, &self.ctx.frame);
        self.offsets.forget_written();
        self.tool = old.tool;
        if old.offsets.offset() != Offset::Start {
            // Which offset is in force now depends on the machine, and the output still has the old one.
            self.offsets.reset();
            self.forget(self.position.at().known());
        }
    }
}
