//! The program ends and nothing turned the coolant off.

use crate::diag::codes;
use crate::ir::function::Coolant;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

#[derive(Debug, Default)]
pub(super) struct CoolantLeftOn {
    on: Option<Origin>,
}

impl CoolantLeftOn {
    pub(super) fn new(_: &Setup<'_>) -> CoolantLeftOn {
        CoolantLeftOn::default()
    }
}

impl MotionRule for CoolantLeftOn {
    fn wants_moves(&self) -> bool {
        false
    }

    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, _: Say<'_>) {
        match function {
            Function::Coolant(Coolant::Off) => self.on = None,
            Function::Coolant(_) => self.on = Some(*origin),
            _ => {}
        }
    }

    fn finish(&mut self, _: &Machine, say: Say<'_>) {
        if let Some(on) = self.on {
            say.about(codes::L1009, &on, "this coolant is never turned off", "program M9 before the end");
        }
    }
}
