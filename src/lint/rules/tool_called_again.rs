//! The same tool is called twice, with no move between.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

#[derive(Debug, Default)]
pub(super) struct ToolCalledAgain {
    last: Option<u32>,
}

impl ToolCalledAgain {
    pub(super) fn new(_: &Setup<'_>) -> ToolCalledAgain {
        ToolCalledAgain::default()
    }
}

impl MotionRule for ToolCalledAgain {
    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        if let Function::ToolChange { number } = function {
            if self.last == Some(*number) && *number != 0 {
                let message = format!("tool {number} is called again, and nothing has moved since");
                say.about(codes::L1005, origin, message, "remove one of the two calls, or name the right tool");
            }
            self.last = Some(*number);
        }
    }

    fn movement(&mut self, _: &Step<'_>, _: &Machine, _: Say<'_>) {
        self.last = None;
    }
}
