//! The tool is changed, or the program ends, where the last cut ended.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Last, Machine, MotionRule, Say, Setup, Step, TINY};

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
        let what = match function {
            Function::ToolChange { .. } => "the tool is changed",
            Function::End { .. } => "the program ends",
            _ => return,
        };
        say.about(codes::L1018, origin, format!("{what} where the last cut ended"), "retract the tool before");
    }
}
