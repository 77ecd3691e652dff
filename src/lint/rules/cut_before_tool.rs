//! The program cuts before it calls its first tool.

use crate::diag::codes;
use crate::ir::Origin;
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};

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
            let message = "this move cuts before the program has called a tool";
            say.about(codes::L1022, &first, message, "call the tool first");
        }
    }
}
