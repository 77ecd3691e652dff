//! The spindle changes its sense where the last cut ended.

use crate::ir::function::Spindle;
use crate::ir::motion::Path;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Last, Machine, MotionRule, Say, Setup, Step, Turning};
use crate::lint::tapping::Tapping;

super::rule! { L1031 Motion SpindleReversed Warning "spindle-reversed"
    what "spindle changes its sense where the last cut ended"
    why "The spindle changes from M3 to M4, or back, while the tool stands where its last cut ended. It runs through standstill in \
        the material. Retract before it; a tap is driven by its cycle. On lathes nothing is said."
    example r#"
-- Example (L1031_fires.MPF)
; M4 in the middle of the cut.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G1 X10 F100
M4
G1 X20
G0 Z50
M30
"#
    says {
        reversed() "the spindle changes its sense where the last cut ended" help "retract the tool before";
    }
}

#[derive(Debug)]
pub(super) struct SpindleReversed<'a> {
    tapping: Tapping<'a>,
    /// The last move was one behind which the spindle is reversed.
    tapped: bool,
    milling: bool,
}

impl<'a> SpindleReversed<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> SpindleReversed<'a> {
        SpindleReversed { tapping: Tapping::new(setup), tapped: false, milling: !setup.is_lathe() }
    }
}

impl MotionRule for SpindleReversed<'_> {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, _: Say<'_>) {
        let of_cycle = step.of_cycle || matches!(step.mv.path, Path::Thread { .. });
        self.tapped = of_cycle || self.milling && self.tapping.taps(step, machine);
    }

    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, say: Say<'_>) {
        let Function::Spindle(Spindle::Start(turn)) = function else { return };
        let reversed = matches!(machine.turning, Turning::On(before) if before != *turn);
        // Tapping with a chuck goes on at feed in the block behind; it goes straight down before.
        if reversed && machine.last == Last::Cut && !self.tapped && self.milling {
            say.about(L1031::reversed(), origin);
        }
    }
}
