//! A speed is zero, or higher than spindles turn.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

/// Fastest speed that is nothing special, rev/min.
const FASTEST: f64 = 100_000.0;

#[derive(Debug)]
pub(super) struct SpeedHuge;

impl SpeedHuge {
    pub(super) fn new(_: &Setup<'_>) -> SpeedHuge {
        SpeedHuge
    }
}

impl MotionRule for SpeedHuge {
    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        let speed = match function {
            Function::Spindle(Spindle::Speed(speed)) => *speed,
            Function::SpindleOf { spindle: Spindle::Speed(speed), .. } => *speed,
            _ => return,
        };
        if speed > FASTEST {
            say.about(
                codes::L1017,
                origin,
                format!("S{speed} is faster than spindles turn"),
                "check the decimal point",
            );
        }
    }
}
