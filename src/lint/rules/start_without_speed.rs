//! The spindle starts and no speed was given.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

#[derive(Debug, Default)]
pub(super) struct StartWithoutSpeed {
    waits: Option<Origin>,
    done: bool,
}

impl StartWithoutSpeed {
    pub(super) fn new(_: &Setup<'_>) -> StartWithoutSpeed {
        StartWithoutSpeed::default()
    }
}

impl MotionRule for StartWithoutSpeed {
    fn wants_moves(&self) -> bool {
        false
    }

    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, _: Say<'_>) {
        match function {
            Function::Spindle(Spindle::Start(_)) if !machine.has_speed && !self.done => {
                self.waits.get_or_insert(*origin);
            }
            // In the same block the order of the words does not matter.
            Function::Spindle(Spindle::Speed(_) | Spindle::CuttingSpeed { .. }) => {
                self.done = true;
                if self.waits.is_some_and(|start| start.loc.line == origin.loc.line) {
                    self.waits = None;
                }
            }
            _ => {}
        }
    }

    fn finish(&mut self, machine: &Machine, say: Say<'_>) {
        // Where no tool was called, this is a part of another program.
        if let Some(start) = self.waits.filter(|_| machine.tool.is_some()) {
            let message = "the spindle starts, and no speed was given before";
            say.about(codes::L1002, &start, message, "program S with the tool, or beside M3");
        }
    }
}
