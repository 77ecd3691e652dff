//! What the program has said by the time of a move: tool and spindle.

use crate::ir::function::{Spindle, Turn};
use crate::ir::{Function, Tilting};
use crate::machine::Axis;

/// Speed of the first spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speed {
    /// rev/min
    Turns(f64),
    /// Constant cutting speed in m/min, up to a speed in rev/min.
    Cutting(f64, Option<f64>),
}

/// What the first spindle does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    Clockwise,
    CounterClockwise,
    Off,
}

impl Sense {
    #[cfg(feature = "arrow")]
    pub const ALL: [Sense; 3] = [Sense::Clockwise, Sense::CounterClockwise, Sense::Off];

    pub fn name(self) -> &'static str {
        match self {
            Sense::Clockwise => "cw",
            Sense::CounterClockwise => "ccw",
            Sense::Off => "off",
        }
    }
}

/// Where the tool points, seen from its tip, in workpiece coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum ToolAxis {
    /// Along Z.
    #[default]
    Upright,
    /// Along Z of a tilted plane: a unit vector.
    Tilted([f64; 3]),
    /// The plane was left, and the rotary axes were not turned back. They are before the workpiece counts again.
    Left,
}

impl ToolAxis {
    /// For a move, which may be one in machine coordinates; `None` where nobody knows.
    pub fn direction(self, machine: bool) -> Option<[f64; 3]> {
        match self {
            ToolAxis::Left if machine => None,
            ToolAxis::Upright | ToolAxis::Left => Some([0.0, 0.0, 1.0]),
            ToolAxis::Tilted(axis) => Some(axis),
        }
    }
}

/// Nothing is known that was not said.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpindleAndTool {
    pub tool: Option<u32>,
    pub speed: Option<Speed>,
    pub sense: Option<Sense>,
    pub axis: ToolAxis,
}

impl SpindleAndTool {
    pub fn function(&mut self, function: &Function) {
        match function {
            Function::ToolChange { number } => self.tool = Some(*number),
            Function::Spindle(spindle) => self.spindle(*spindle),
            Function::Tilt(tilting) => self.tilt(tilting),
            Function::ToolPrepare { .. }
            | Function::Cutter(_)
            | Function::SpindleOf { .. }
            | Function::FeedSpindle(_)
            | Function::Transformation(_)
            | Function::Coolant(_)
            | Function::Dwell(_)
            | Function::Stop
            | Function::OptionalStop
            | Function::Aux(_)
            | Function::WorkOffset(_)
            | Function::Plane(_)
            | Function::PathControl(_)
            | Function::Comment(_)
            | Function::Remark(_)
            | Function::End { .. } => {}
        }
    }

    #[cold]
    fn tilt(&mut self, tilting: &Tilting) {
        self.axis = match tilting {
            Tilting::Into(tilt) => ToolAxis::Tilted(tilt.direction(Axis::Z).into()),
            Tilting::Back(_) => ToolAxis::Upright,
            Tilting::Off => ToolAxis::Left,
        };
    }

    fn spindle(&mut self, spindle: Spindle) {
        match spindle {
            Spindle::Start(Turn::Clockwise) => self.sense = Some(Sense::Clockwise),
            Spindle::Start(Turn::CounterClockwise) => self.sense = Some(Sense::CounterClockwise),
            Spindle::Stop | Spindle::Orient(_) => self.sense = Some(Sense::Off),
            Spindle::Speed(speed) => self.speed = Some(Speed::Turns(speed)),
            Spindle::CuttingSpeed { speed, limit } => self.speed = Some(Speed::Cutting(speed, limit)),
        }
    }
}
