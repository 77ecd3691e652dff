//! The spindle changes its sense where the last cut ended.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::motion::Path;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Last, Machine, MotionRule, Say, Setup, Step, Turning};
use crate::lint::tapping::Tapping;

#[derive(Debug)]
pub(super) struct SpindleReversed<'a> {
    tapping: Tapping<'a>,
    /// The last move was one behind which the spindle is reversed.
    tapped: bool,
    milling: bool,
}

impl<'a> SpindleReversed<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> SpindleReversed<'a> {
        SpindleReversed { tapping: Tapping::new(setup), tapped: false, milling: !setup.is_lathe() }
    }
}

impl MotionRule for SpindleReversed<'_> {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, _: Say<'_>) {
        let of_cycle = step.of_cycle || matches!(step.mv.path, Path::Thread { .. });
        self.tapped = of_cycle || self.milling && self.tapping.taps(step, machine);
    }

    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, say: Say<'_>) {
        let Function::Spindle(Spindle::Start(turn)) = function else { return };
        let reversed = matches!(machine.turning, Turning::On(before) if before != *turn);
        // Tapping with a chuck goes on at feed in the block behind; it goes straight down before.
        if reversed && machine.last == Last::Cut && !self.tapped && self.milling {
            let message = "the spindle changes its sense where the last cut ended";
            say.about(codes::L1031, origin, message, "retract the tool before");
        }
    }
}
