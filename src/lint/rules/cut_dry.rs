//! A tool cuts without coolant where others have it.

use crate::diag::codes;
use crate::ir::function::Coolant;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

/// Most tools that are remembered.
const MOST: usize = 100;

#[derive(Debug, Default)]
pub(super) struct CutDry {
    dry: Vec<Origin>,
    said: bool,
    used: bool,
}

impl CutDry {
    pub(super) fn new(_: &Setup<'_>) -> CutDry {
        CutDry::default()
    }
}

impl MotionRule for CutDry {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, _: Say<'_>) {
        if step.cuts() && !machine.coolant && !self.said && machine.tool.is_some() && self.dry.len() < MOST {
            self.said = true;
            self.dry.push(*step.origin);
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        match function {
            Function::ToolChange { .. } => self.said = false,
            Function::Coolant(Coolant::Flood | Coolant::Mist) => self.used = true,
            _ => {}
        }
    }

    fn finish(&mut self, _: &Machine, say: Say<'_>) {
        for origin in self.dry.drain(..).filter(|_| self.used) {
            say.about(
                codes::L1010,
                &origin,
                "the tool cuts here, and no coolant is on",
                "program M8 after the tool change",
            );
        }
    }
}
