//! A work offset changes while radius compensation is on.

use crate::ir::{Function, Origin, Side};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

super::rule! { L1030 Motion OffsetCompensated Warning "offset-while-compensated"
    what "work offset changes while radius compensation is on"
    why "A work offset is selected while G41, G42, RL or RR holds. Where the compensated path goes between the two zeros is \
        hardly intended, and controls differ in it. End the compensation first."
    example r#"
-- Example (L1030_fires.H)
0 BEGIN PGM P MM
; Preset 2 while RL holds.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L X+10 Y+10 RL F100
4 L X+50
5 CYCL DEF 247 Q339=+2
6 L X+60 R0
7 L Z+50 FMAX M30
8 END PGM P MM
-- partc.toml
[output]
compensation = "control"
[tools.1]
radius = 5.0
[tools.2]
radius = 3.0
"#
    says {
        shifted() "the work offset changes while radius compensation is on" help "end the compensation before (G40, R0)";
    }
}

#[derive(Debug)]
pub(super) struct OffsetCompensated;

impl OffsetCompensated {
    pub(super) fn new(_: &Setup<'_>) -> OffsetCompensated {
        OffsetCompensated
    }
}

impl MotionRule for OffsetCompensated {
    fn wants_moves(&self) -> bool {
        false
    }

    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, say: Say<'_>) {
        if matches!(function, Function::WorkOffset(_)) && machine.side != Side::None {
            say.about(L1030::shifted(), origin);
        }
    }
}
