//! A tool cuts at the speed of the one before it.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

#[derive(Debug, Default)]
pub(super) struct ToolWithoutSpeed {
    changed: Option<(u32, Origin)>,
}

impl ToolWithoutSpeed {
    pub(super) fn new(_: &Setup<'_>) -> ToolWithoutSpeed {
        ToolWithoutSpeed::default()
    }
}

impl MotionRule for ToolWithoutSpeed {
    fn function(&mut self, function: &Function, machine: &Machine, origin: &Origin, _: Say<'_>) {
        match function {
            Function::ToolChange { number } if machine.has_speed && machine.tool != Some(*number) => {
                self.changed = Some((*number, *origin));
            }
            Function::ToolChange { .. } | Function::Spindle(Spindle::Speed(_) | Spindle::CuttingSpeed { .. }) => {
                self.changed = None;
            }
            _ => {}
        }
    }

    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        if let Some((number, origin)) = self.changed.filter(|_| step.cuts()) {
            self.changed = None;
            let message = format!("tool {number} cuts at the speed of the tool before it");
            say.about(codes::L1003, &origin, message, "give the tool its own S");
        }
    }
}
