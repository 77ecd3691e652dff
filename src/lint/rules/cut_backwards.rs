//! A milling tool cuts with the spindle turning left.

use crate::diag::codes;
use crate::ir::function::Turn;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, Turning};

#[derive(Debug, Default)]
pub(super) struct CutBackwards {
    said: bool,
    lathe: bool,
}

impl CutBackwards {
    pub(super) fn new(setup: &Setup<'_>) -> CutBackwards {
        CutBackwards { lathe: setup.is_lathe(), ..CutBackwards::default() }
    }
}

impl MotionRule for CutBackwards {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, say: Say<'_>) {
        let left = machine.turning == Turning::On(Turn::CounterClockwise);
        if !self.lathe && left && step.cuts() && !step.of_cycle && !self.said {
            self.said = true;
            say.about(codes::L1020, step.origin, "this move cuts while M4 turns the spindle left", "is M3 meant?");
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::ToolChange { .. }) {
            self.said = false;
        }
    }
}
