//! The spindle starts and no speed was given.

use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

super::rule! { L1002 Motion StartWithoutSpeed Warning "spindle-without-speed"
    what "spindle starts and no speed was given"
    why "M3 or M4 comes before any S word. The control starts the spindle at the speed that the program before has left, or not at \
        all. Program S with the tool call or beside M3."
    example r#"
-- Example (L1002_fires.MPF)
; M3 and no S at all.
T1 M6
M3
G0 X0 Y0 Z5
G1 X10 F100
G0 Z50
M30
"#
    says {
        unset() "the spindle starts, and no speed was given before" help "program S with the tool, or beside M3";
    }
}

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
            say.about(L1002::unset(), &start);
        }
    }
}
