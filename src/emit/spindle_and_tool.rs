//! What the program has said by the time of a move: tool and spindle.

use crate::ir::Function;
use crate::ir::function::{Spindle, Turn};

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

/// Nothing is known that was not said.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpindleAndTool {
    pub tool: Option<u32>,
    pub speed: Option<Speed>,
    pub sense: Option<Sense>,
}

impl SpindleAndTool {
    pub fn function(&mut self, function: &Function) {
        match function {
            Function::ToolChange { number } => self.tool = Some(*number),
            Function::Spindle(spindle) => self.spindle(*spindle),
            Function::ToolPrepare { .. }
            | Function::Cutter(_)
            | Function::SpindleOf { .. }
            | Function::FeedSpindle(_)
            | Function::Transformation(_)
            | Function::Tilt(_)
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
