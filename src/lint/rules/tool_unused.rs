//! A tool is called and does nothing.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1004 Motion ToolUnused Warning "tool-unused"
    what "tool is called and does nothing"
    why "A tool is changed in, and the next tool or the end of the program comes before it has cut anything. A call was left over, \
        or the moves of this tool got lost. A last tool that is put in for the next part, tool 0, and tools that only move at \
        rapid (feelers, stops) can be meant: suppress the finding there."
    example r#"
-- Example (L1004_fires.H)
0 BEGIN PGM P MM
; Tool 1 positions only.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 TOOL CALL 2 Z S2000
4 L X+0 Y+0 Z+5 R0 FMAX M3
5 L Z-1 F100
6 L Z+50 FMAX M30
7 END PGM P MM
"#
    says {
        idle(number) "tool {number} is called and cuts nothing" help "remove the call, or look for the moves of this tool";
    }
}

#[derive(Debug, Default)]
pub(super) struct ToolUnused {
    waits: Option<(u32, Origin)>,
    cut: bool,
    moved: bool,
}

impl ToolUnused {
    pub(super) fn new(_: &Setup<'_>) -> ToolUnused {
        ToolUnused::default()
    }
}

impl MotionRule for ToolUnused {
    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        if let Function::ToolChange { number } = function {
            // The same tool once more has a rule of its own.
            if self.waits.is_some_and(|(before, _)| before != *number) {
                self.settle(say);
            }
            self.moved = false;
            self.waits = (*number != 0).then_some((*number, *origin));
        }
    }

    fn movement(&mut self, step: &Step<'_>, _: &Machine, _: Say<'_>) {
        self.moved = true;
        if step.cuts() {
            self.cut = true;
            self.waits = None;
        }
    }

    // What moves behind an error is not known.
    fn lost(&mut self) {
        self.waits = None;
    }

    fn finish(&mut self, _: &Machine, say: Say<'_>) {
        // A program that cuts nothing has another purpose; a tool in front of the end may be the first one of the next part.
        if self.cut && self.moved {
            self.settle(say);
        }
    }
}

impl ToolUnused {
    fn settle(&mut self, say: Say<'_>) {
        if let Some((number, origin)) = self.waits.take() {
            say.about(L1004::idle(&number), &origin);
        }
    }
}
