//! A drill or tap cuts sideways.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY};
use crate::machine::tools::Tools;

#[derive(Debug, Default)]
pub(super) struct DrillSideways<'a> {
    said: bool,
    drills: bool,
    above: Option<f64>,
    tools: Option<&'a Tools>,
}

impl<'a> DrillSideways<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> DrillSideways<'a> {
        DrillSideways { tools: Some(&setup.settings.tools), ..DrillSideways::default() }
    }
}

impl MotionRule for DrillSideways<'_> {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        if !self.drills || step.of_cycle {
            return;
        }
        let height = step.to.get(step.tool_axis());
        if step.rise().is_some_and(|rise| rise < -TINY) && step.cuts() && !step.goes_sideways() {
            self.above = step.from.get(step.tool_axis());
        }
        let below = matches!((height, self.above), (Some(height), Some(above)) if height < above - TINY);
        if step.cuts() && step.goes_sideways() && below && !self.said {
            self.said = true;
            say.about(codes::L1034, step.origin, "a drill or tap cuts sideways here", "retract before, or call a mill");
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if let Function::ToolChange { number } = function {
            let tool = self.tools.and_then(|tools| tools.by_printed(*number));
            let kind = tool.and_then(|tool| tool.kind.as_deref());
            *self = DrillSideways {
                tools: self.tools,
                drills: matches!(kind, Some("drill" | "tap")),
                ..DrillSideways::default()
            };
        }
    }
}
