//! Modal state of an MTC200 program.

use std::rc::Rc;

use crate::geo::Plane;
use crate::ir::contour::{Ctx, CtxRef};
use crate::machine::{Axis, AxisSet, MachineKind, Settings, Unit};
use crate::sema::common::compensation::Compensation;
use crate::sema::common::feed::{FeedKind, ModalFeed};
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;

use super::g_functions::Motion;
use super::length::Length;
use super::m_functions::{SpindleState, ToolInUse};
use super::offsets::OffsetState;
use super::path::Corners;

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

/// From one element of a compensated contour to the next.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Transition {
    /// G44.
    pub chamfers: bool,
    /// G43 or G44 was programmed.
    pub said: bool,
    /// Blocks since the last one that moves in the plane.
    pub between: u32,
}

/// Everything that one block leaves to the next. Positions are mm (X: radius) and degrees in the
/// programmed system.
#[derive(Debug)]
pub(super) struct State {
    /// The number that the program wrote last is left alone by a changed offset.
    pub position: Position,
    pub motion: MotionCode,
    /// G90 or G91, G94 or G95 was programmed.
    pub dimension_said: bool,
    pub feed_said: bool,
    pub length: Length,
    pub plane: Plane,
    /// G70.
    pub inch: bool,
    /// G16.
    pub diameter: bool,
    /// G91.
    pub incremental: bool,
    /// G61.
    pub exact_stop: bool,
    pub feed: ModalFeed,
    pub compensation: Compensation,
    pub transition: Transition,
    pub offsets: OffsetState,
    pub spindle: SpindleState,
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
        State {
            position: Position::new(start),
            motion: MotionCode::default(),
            dimension_said: false,
            feed_said: false,
            length: Length::default(),
            plane,
            inch: settings.control.unit == Some(Unit::Inch),
            diameter,
            incremental: false,
            exact_stop: false,
            feed: ModalFeed::new(settings.control.feed, Some(FeedKind::PerMinute)),
            compensation: Compensation::default(),
            transition: Transition::default(),
            offsets: OffsetState::new(written),
            spindle: SpindleState::default(),
            tool: ToolInUse::default(),
            corners: Corners::default(),
            ctx: Rc::new(Ctx { plane, ..Ctx::default() }),
        }
    }

    /// How the compiler compensates from now on.
    pub fn compensate(&mut self, rules: crate::ir::Compensation) {
        if self.ctx.compensation.as_deref() != Some(&rules) {
            self.ctx = Rc::new(Ctx { compensation: Some(Rc::new(rules)), ..(*self.ctx).clone() });
        }
    }

    /// The position of these axes is no longer known in the programmed system.
    pub fn forget(&mut self, axes: AxisSet) {
        self.position.forget_place(axes);
        self.position.not_lost(axes);
    }

    /// Millimetres in one programmed unit.
    pub fn unit(&self) -> f64 {
        if self.inch { Unit::Inch.mm() } else { Unit::Mm.mm() }
    }
}
