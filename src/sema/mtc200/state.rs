//! Modal state of an MTC200 program.

use std::rc::Rc;

use crate::geo::Plane;
use crate::ir::contour::{Ctx, CtxRef};
use crate::ir::{Feed, Side};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet, MachineKind, Settings, Unit};
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;
use crate::text::Loc;

use super::length::Length;

/// Kind of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Motion {
    Rapid,
    Line,
    Clockwise,
    CounterClockwise,
    Thread,
}

impl Motion {
    pub fn is_arc(self) -> bool {
        matches!(self, Motion::Clockwise | Motion::CounterClockwise)
    }
}

/// Which zero offset is in force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Offset {
    /// Nothing programmed: what the machine has.
    Start,
    /// G54 is 1.
    Work(u8),
    /// G53.
    Machine,
    /// A JMP reset it to what the machine's parameters say.
    Reset,
}

/// Everything that one block leaves to the next. Positions are mm (X: radius) and degrees in the
/// programmed system.
#[derive(Debug)]
pub(super) struct State {
    /// The number that the program wrote last is left alone by a changed offset.
    pub position: Position,
    pub motion: Option<Motion>,
    /// A block was refused that may have named the kind of motion.
    pub motion_lost: bool,
    /// G90 or G91, G94 or G95 was programmed.
    pub dimension_said: bool,
    pub feed_said: bool,
    /// Axes of which the program, or the start, has said a number.
    pub written: AxisSet,
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
    pub feed: Option<Feed>,
    /// G95.
    pub per_revolution: bool,
    pub side: Side,
    /// Side of the last move that was sent.
    pub side_sent: Side,
    /// G44.
    pub chamfers: bool,
    pub offset: Offset,
    /// G50, G51 and G52 together, radius values.
    pub shift: [f64; AXES],
    /// Axes whose `shift` changed since they moved.
    pub shifted: AxisSet,
    /// The spindle does not turn, as far as the program says.
    pub spindle_stands: bool,
    /// A part of `shift` comes from G51 or G52.
    pub added: bool,
    /// G96.
    pub constant_speed: bool,
    /// Cutting speed in m/min.
    pub cutting_speed: Option<f64>,
    /// G92: highest speed under G96, rev/min.
    pub speed_limit: Option<f64>,
    /// Tool of the last T word.
    pub selected: Option<u32>,
    /// Tool of the last change.
    pub tool: Option<u32>,
    /// The last block with words moved at feed: a corner may follow.
    pub cornerable: bool,
    /// A corner waits for its second neighbour: where it stands, and the blocks since.
    pub corner: Option<(Loc, u32)>,
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
        State {
            written: start.position().known(),
            position: Position::new(start),
            motion: None,
            motion_lost: false,
            dimension_said: false,
            feed_said: false,
            length: Length::default(),
            plane,
            inch: settings.control.unit == Some(Unit::Inch),
            diameter,
            incremental: false,
            exact_stop: false,
            feed: settings.control.feed.map(Feed::PerMinute),
            per_revolution: false,
            side: Side::None,
            side_sent: Side::None,
            chamfers: false,
            offset: Offset::Start,
            shift: [0.0; AXES],
            shifted: AxisSet::EMPTY,
            spindle_stands: true,
            added: false,
            constant_speed: false,
            cutting_speed: None,
            speed_limit: None,
            selected: None,
            tool: None,
            cornerable: false,
            corner: None,
            ctx: Rc::new(Ctx { plane, ..Ctx::default() }),
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
