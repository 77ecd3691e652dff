//! A coordinate is farther out than machines reach.

use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::AxisSet;

super::rule! { L1013 Motion FarCoordinates Warning "coordinate-far"
    what "coordinate is farther out than machines reach"
    why "A linear axis goes farther than 10 m from the zero of the workpiece. A decimal point is missing, or a parameter has a \
        wrong value. Where the travel of the machine is known, `[machine] limits` says it exactly, and the error G3018 takes the \
        place of this warning. Said once for each axis."
    example r#"
-- Example (L1013_fires.MPF)
; 20 m away.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G0 X20000
G0 Z50
M30
"#
    says {
        far(letter, value) "{letter}{value:.3} is over 10 m away"
            asks "check the decimal point; `[machine] limits` says how far the machine goes";
    }
}

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
        // A slip of the pen is in a number of the program: that of a tilted plane, where one is on.
        for axis in step.mv.axes.iter().filter(|axis| !axis.is_rotary()) {
            let Some(value) = step.mv.end.get(axis).filter(|value| value.abs() > FARTHEST) else { continue };
            if !self.limited.contains(axis) && !self.said.contains(axis) {
                self.said.insert(axis);
                // The limits keep it quiet; what it wants is a look at the number.
                let fault = L1013::far(&axis.letter(), &value).answers([]);
                say.about(fault, step.origin);
            }
        }
    }
}
