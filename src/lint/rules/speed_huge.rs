//! A speed is zero, or higher than spindles turn.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, Turning};

/// Fastest speed that is nothing special, rev/min.
const FASTEST: f64 = 100_000.0;

#[derive(Debug, Default)]
pub(super) struct SpeedHuge {
    /// Where the speed became 0; nothing is said before something cuts with it.
    zero: Option<Origin>,
}

impl SpeedHuge {
    pub(super) fn new(_: &Setup<'_>) -> SpeedHuge {
        SpeedHuge::default()
    }
}

impl MotionRule for SpeedHuge {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, say: Say<'_>) {
        let turns = matches!(machine.turning, Turning::On(_));
        if let Some(origin) = self.zero.filter(|_| turns && step.cuts() && !step.of_cycle) {
            self.zero = None;
            say.about(codes::L1017, &origin, "the tool cuts at a spindle speed of 0", "give the speed of the tool");
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        let speed = match function {
            Function::Spindle(Spindle::Speed(speed)) => {
                self.zero = (*speed == 0.0).then_some(*origin);
                *speed
            }
            Function::Spindle(Spindle::CuttingSpeed { .. }) => {
                self.zero = None;
                return;
            }
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
