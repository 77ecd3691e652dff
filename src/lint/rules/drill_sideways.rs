//! A drill or tap cuts sideways.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY};
use crate::machine::tools::Tools;

super::rule! { L1034 Motion DrillSideways Warning "drill-cuts-sideways"
    what "drill or tap cuts sideways"
    why "The tool table says that this tool is a drill or a tap, and it moves sideways at feed below the height from which it last \
        went down. It breaks. Either the wrong tool is called, or the retract is missing. Said once for each tool."
    example r#"
-- Example (L1034_fires.H)
0 BEGIN PGM P MM
; A drill goes down and sideways.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-5 F100
4 L X+50 F300
5 L Z+50 FMAX M30
6 END PGM P MM
-- partc.toml
[tools.1]
kind = "drill"
radius = 5.0
"#
    says {
        sideways() "a drill or tap cuts sideways here" help "retract before, or call a mill";
    }
}

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
            say.about(L1034::sideways(), step.origin);
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if let Function::Tilt(_) = function {
            // Heights count along the tool: those of another plane say nothing.
            self.above = None;
        } else if let Function::ToolChange { number } = function {
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
