//! A tool cuts without coolant where others have it.

use crate::ir::function::Coolant;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1010 Motion CutDry Note off "cut-without-coolant"
    what "tool cuts without coolant where others have it"
    why "The program uses coolant, and this tool cuts while none is on. M8 may be missing after a tool change. Off by default: \
        some tools are meant to cut dry. Said once for each tool."
    example r#"
-- Example (L1010_fires.MPF)
; Tool 2 cuts dry, tool 1 does not.
T1 M6
S1000 M3
G0 X0 Y0 Z5 M8
G1 X10 F100
G0 Z50 M9
T2 M6
S500 M3
G0 X0 Y0 Z5
G1 X10 F100
G0 Z50 M9
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        dry() "the tool cuts here, and no coolant is on" help "program M8 after the tool change";
    }
}

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
            say.about(L1010::dry(), &origin);
        }
    }
}
