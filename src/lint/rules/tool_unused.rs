//! A tool is called and does nothing.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

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
            let message = format!("tool {number} is called and cuts nothing");
            say.about(codes::L1004, &origin, message, "remove the call, or look for the moves of this tool");
        }
    }
}
