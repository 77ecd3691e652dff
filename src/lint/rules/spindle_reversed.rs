//! The spindle changes its sense where the last cut ended.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::motion::Path;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Last, Machine, MotionRule, Say, Setup, Step, Turning};

#[derive(Debug, Default)]
pub(super) struct SpindleReversed {
    of_cycle: bool,
    milling: bool,
}

impl SpindleReversed {
    pub(super) fn new(setup: &Setup<'_>) -> SpindleReversed {
        SpindleReversed { milling: !setup.is_lathe(), ..SpindleReversed::default() }
    }
}

impl MotionRule for SpindleReversed {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, _: Say<'_>) {
        self.of_cycle = step.of_cycle || matches!(step.mv.path, Path::Thread { .. });
    }

    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, say: Say<'_>) {
        let Function::Spindle(Spindle::Start(turn)) = function else { return };
        let reversed = matches!(machine.turning, Turning::On(before) if before != *turn);
        // Tapping with a chuck goes on at feed in the block behind; it goes straight down before.
        if reversed && machine.last == Last::Cut && !self.of_cycle && self.milling {
            let message = "the spindle changes its sense where the last cut ended";
            say.about(codes::L1031, origin, message, "retract the tool before");
        }
    }
}
