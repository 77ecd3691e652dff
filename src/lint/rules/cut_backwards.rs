//! A milling tool cuts with the spindle turning left.

use crate::ir::function::Turn;
use crate::ir::motion::Path;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, Turning};
use crate::lint::tapping::Tapping;

super::rule! { L1020 Motion CutBackwards Warning "spindle-counter-clockwise"
    what "milling tool cuts with the spindle turning left"
    why "On a milling machine a tool cuts while M4 turns the spindle counter-clockwise. Nearly all tools cut clockwise: turning \
        left they rub, burn and break. Left-handed tools are rare enough to suppress this finding for them. Tapping out is no cut \
        of this kind. Said once for each tool."
    example r#"
-- Example (L1020_fires.MPF)
; M4 on a milling machine.
T1 M6
S1000 M4
G0 X0 Y0 Z5
G1 X10 F100
G0 Z50
M30
"#
    says {
        turns_left() "this move cuts while M4 turns the spindle left" help "is M3 meant?";
    }
}

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
            say.about(L1020::turns_left(), step.origin);
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::ToolChange { .. }) {
            self.said = false;
        }
    }
}
