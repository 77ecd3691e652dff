//! The program stops where the last cut ended.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Last, Machine, MotionRule, Say, Setup, Step, TINY};

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
            say.about(
                codes::L1029,
                origin,
                "the program stops where the last cut ended",
                "retract the tool before the stop",
            );
        }
    }
}
