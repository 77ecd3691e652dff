//! A coordinate is farther out than machines reach.

use crate::diag::codes;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::AxisSet;

/// Farthest coordinate that is nothing special, mm.
const FARTHEST: f64 = 10_000.0;

#[derive(Debug, Default)]
pub(super) struct FarCoordinates {
    limited: AxisSet,
    said: AxisSet,
}

impl FarCoordinates {
    pub(super) fn new(setup: &Setup<'_>) -> FarCoordinates {
        let mut limited = AxisSet::EMPTY;
        setup.settings.machine.limits.keys().for_each(|axis| limited.insert(*axis));
        FarCoordinates { limited, said: AxisSet::EMPTY }
    }
}

impl MotionRule for FarCoordinates {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        if !step.to.exceeds(FARTHEST) {
            return;
        }
        for axis in step.mv.axes.iter().filter(|axis| !axis.is_rotary()) {
            let Some(value) = step.mv.end.get(axis).filter(|value| value.abs() > FARTHEST) else { continue };
            if !self.limited.contains(axis) && !self.said.contains(axis) {
                self.said.insert(axis);
                let message = format!("{}{value:.3} is over 10 m away", axis.letter());
                say.about(
                    codes::L1013,
                    step.origin,
                    message,
                    "check the decimal point; `[machine] limits` says how far the machine goes",
                );
            }
        }
    }
}
