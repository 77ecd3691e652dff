//! The tool cuts while the spindle stands.

use crate::diag::codes;
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step, Turning};
use crate::machine::axis::Axis;

#[derive(Debug, Default)]
pub(super) struct SpindleOff {
    said: bool,
    blank: Option<Blank>,
}

impl SpindleOff {
    pub(super) fn new(setup: &Setup<'_>) -> SpindleOff {
        SpindleOff { blank: setup.blank, ..SpindleOff::default() }
    }
}

impl MotionRule for SpindleOff {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, say: Say<'_>) {
        if machine.turning != Turning::Off {
            self.said = false;
            return;
        }
        let cuts = step.cuts() && !step.of_cycle && !step.retracts(self.blank);
        if cuts && !self.said && step.mv.axes.iter().any(Axis::is_main) {
            self.said = true;
            say.about(
                codes::L1001,
                step.origin,
                "this move cuts, and the spindle stands",
                "start the spindle before it (M3, M4)",
            );
        }
    }
}
