//! A speed is zero, or higher than spindles turn.

use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, Turning};

super::rule! { L1017 Motion SpeedHuge Warning "speed-huge"
    what "spindle speed is zero, or higher than spindles turn"
    why "A tool cuts at a speed of 0, or a spindle is to turn at more than 100,000 revolutions per minute. A parameter was not set, \
        a decimal point is missing, or a cutting speed was written as a speed. What the machine really reaches is for its own \
        limits."
    example r#"
-- Example (L1017_fires.MPF)
; 200,000 revolutions per minute.
T1 M6
S200000 M3
G0 X0 Y0 Z5
G1 X10 F100
G0 Z50
M30
"#
    says {
        zero() "the tool cuts at a spindle speed of 0" help "give the speed of the tool";
        fast(speed) "S{speed} is faster than spindles turn" help "check the decimal point";
    }
}

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
            say.about(L1017::zero(), &origin);
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
            say.about(L1017::fast(&speed), origin);
        }
    }
}
