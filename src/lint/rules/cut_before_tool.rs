//! The program cuts before it calls its first tool.

use crate::ir::Origin;
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};

super::rule! { L1022 Motion CutBeforeTool Warning "cut-before-first-tool"
    what "program cuts before it calls its first tool"
    why "The program calls tools, and cuts before the first call: with whatever the program before has left in the spindle. A tool \
        call is missing, or stands too late. A program that calls no tool at all is taken for a part of another one."
    example r#"
-- Example (L1022_fires.H)
0 BEGIN PGM P MM
; The first cut is made by whatever tool is in the spindle.
1 L X+0 Y+0 Z+5 R0 FMAX M3
2 L Z-1 F100
3 L Z+50 FMAX
4 TOOL CALL 1 Z S2000
5 L X+0 Y+0 Z+5 FMAX
6 L Z-1 F100
7 L Z+50 FMAX M30
8 END PGM P MM
"#
    says {
        early() "this move cuts before the program has called a tool" help "call the tool first";
    }
}

#[derive(Debug, Default)]
pub(super) struct CutBeforeTool {
    first: Option<Origin>,
    blank: Option<Blank>,
}

impl CutBeforeTool {
    pub(super) fn new(setup: &Setup<'_>) -> CutBeforeTool {
        CutBeforeTool { blank: setup.blank, ..CutBeforeTool::default() }
    }
}

impl MotionRule for CutBeforeTool {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, _: Say<'_>) {
        if machine.tool.is_none() && step.cuts() && !step.retracts(self.blank) {
            self.first.get_or_insert(*step.origin);
        }
    }

    fn finish(&mut self, machine: &Machine, say: Say<'_>) {
        if let (Some(first), Some(_)) = (self.first, machine.tool) {
            say.about(L1022::early(), &first);
        }
    }
}
