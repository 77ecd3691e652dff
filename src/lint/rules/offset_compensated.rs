//! A work offset changes while radius compensation is on.

use crate::diag::codes;
use crate::ir::{Function, Origin, Side};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

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
            let message = "the work offset changes while radius compensation is on";
            say.about(codes::L1030, origin, message, "end the compensation before (G40, R0)");
        }
    }
}
