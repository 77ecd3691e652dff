//! The program stops where the last cut ended.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Last, Machine, MotionRule, Say, Setup, Step, TINY};

super::rule! { L1029 Motion StopInCut Warning "stop-in-cut"
    what "program stops where the last cut ended"
    why "M0 stops the machine right after a cutting move that did not lift the tool. The tool stays on the part, on many machines \
        while the spindle runs down, and leaves a mark or breaks at the start. Retract before the stop. On lathes nothing is said."
    example r#"
-- Example (L1029_fires.H)
0 BEGIN PGM P MM
; The program stops in the part.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-5 F100
4 L X+50 F300
5 STOP
6 L Z+50 FMAX M30
7 END PGM P MM
"#
    says {
        stops() "the program stops where the last cut ended" help "retract the tool before the stop";
    }
}

#[derive(Debug, Default)]
pub(super) struct StopInCut {
    up: bool,
    lathe: bool,
}

impl StopInCut {
    pub(super) fn new(setup: &Setup<'_>) -> StopInCut {
        StopInCut { lathe: setup.is_lathe(), ..StopInCut::default() }
    }
}

impl MotionRule for StopInCut {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, _: Say<'_>) {
        self.up = step.of_cycle || self.lathe || step.rise().is_none_or(|rise| rise > TINY);
    }

    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, say: Say<'_>) {
        if matches!(function, Function::Stop) && machine.last == Last::Cut && !self.up {
            say.about(L1029::stops(), origin);
        }
    }
}
