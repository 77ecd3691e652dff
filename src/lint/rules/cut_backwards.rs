//! A milling tool cuts with the spindle turning left.

use crate::diag::codes;
use crate::ir::function::Turn;
use crate::ir::motion::Path;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, Turning};
use crate::lint::tapping::Tapping;

#[derive(Debug, Default)]
pub(super) struct CutBackwards<'a> {
    tapping: Option<Tapping<'a>>,
    said: bool,
    lathe: bool,
}

impl<'a> CutBackwards<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> CutBackwards<'a> {
        CutBackwards { tapping: Some(Tapping::new(setup)), lathe: setup.is_lathe(), ..CutBackwards::default() }
    }
}

impl MotionRule for CutBackwards<'_> {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, say: Say<'_>) {
        let left = machine.turning == Turning::On(Turn::CounterClockwise);
        // A thread of the other hand is cut on purpose.
        let taps = || {
            matches!(step.mv.path, Path::Thread { .. })
                || self.tapping.is_some_and(|tapping| tapping.taps(step, machine))
        };
        if !self.lathe && left && step.cuts() && !step.of_cycle && !self.said && !taps() {
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
