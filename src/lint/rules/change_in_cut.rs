//! The tool is changed, or the program ends, where the last cut ended.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Last, Machine, MotionRule, Say, Setup, Step, TINY};

super::rule! { L1018 Motion ChangeInCut Warning "change-at-feed-end"
    what "tool is changed, or the program ends, where the last cut ended"
    why "The last move before a tool change or before the end of the program was a cutting move: the tool still stands where it \
        cut. Some machines retract by themselves, others turn the changer or open the door with the tool in the part, and the next \
        program starts with a rapid move out of it. Retract before it. On lathes, whose tools leave the part in any direction, \
        nothing is said."
    example r#"
-- Example (L1018_fires.H)
0 BEGIN PGM P MM
; The tool stands in the part when the program ends.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-5 F100
4 L X+50 F300
5 L Y+10 M30
6 END PGM P MM
"#
    says {
        change() "the tool is changed where the last cut ended" help "retract the tool before";
        end() "the program ends where the last cut ended" help "retract the tool before";
    }
}

#[derive(Debug, Default)]
pub(super) struct ChangeInCut {
    up: bool,
    lathe: bool,
}

impl ChangeInCut {
    pub(super) fn new(setup: &Setup<'_>) -> ChangeInCut {
        ChangeInCut { lathe: setup.is_lathe(), ..ChangeInCut::default() }
    }
}

impl MotionRule for ChangeInCut {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, _: Say<'_>) {
        // Whoever lifts the tool at feed, or leaves on a way of his own, has retracted.
        self.up = step.of_cycle || self.lathe || step.rise().is_none_or(|rise| rise > TINY);
    }

    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, say: Say<'_>) {
        // Where no tool was called, this is a part of another program.
        if machine.last != Last::Cut || self.up || machine.tool.is_none() {
            return;
        }
        let fault = match function {
            Function::ToolChange { .. } => L1018::change(),
            Function::End { .. } => L1018::end(),
            _ => return,
        };
        say.about(fault, origin);
    }
}
