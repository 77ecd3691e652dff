//! A tool cuts at the speed of the one before it.

use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1003 Motion ToolWithoutSpeed Note off "tool-without-speed"
    what "tool cuts at the speed of the one before"
    why "A tool was changed in, and it cuts without an S of its own: at the speed of the tool before. For a smaller tool that is \
        too slow, for a larger one perhaps much too fast. Give each tool its speed. Off by default: some shops give the speed once \
        for tools of one size."
    example r#"
-- Example (L1003_fires.H)
0 BEGIN PGM P MM
; The second tool turns at the speed of the first.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-1 F100
4 L Z+50 FMAX
5 TOOL CALL 2 Z
6 L X+0 Y+0 Z+5 R0 FMAX M3
7 L Z-1 F100
8 L Z+50 FMAX M30
9 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        borrowed(number) "tool {number} cuts at the speed of the tool before it" help "give the tool its own S";
    }
}

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
            say.about(L1003::borrowed(&number), &origin);
        }
    }
}
