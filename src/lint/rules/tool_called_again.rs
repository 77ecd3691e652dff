//! The same tool is called twice, with no move between.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1005 Motion ToolCalledAgain Warning "tool-called-again"
    what "tool that is in the spindle is called again"
    why "The same tool is called twice and nothing moves between the two calls. The second call was meant for another tool, or is \
        left over; on machines without a check the changer puts the tool away and fetches it again. TOOL CALL of a HEIDENHAIN \
        control with the number of the tool in the spindle, and T of HEIDENHAIN turning, change nothing then, and nothing is said."
    example r#"
-- Example (L1005_fires.MPF)
; Tool 5 is called twice.
T5 M6
T5 M6
S1000 M3
G0 X0 Y0 Z5
G1 Z-1 F100
G0 Z50
M30
"#
    says {
        twice(number) "tool {number} is called again, and nothing has moved since"
            help "remove one of the two calls, or name the right tool";
    }
}

#[derive(Debug, Default)]
pub(super) struct ToolCalledAgain {
    last: Option<u32>,
}

impl ToolCalledAgain {
    pub(super) fn new(_: &Setup<'_>) -> ToolCalledAgain {
        ToolCalledAgain::default()
    }
}

impl MotionRule for ToolCalledAgain {
    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        if let Function::ToolChange { number } = function {
            if self.last == Some(*number) && *number != 0 {
                say.about(L1005::twice(&number), origin);
            }
            self.last = Some(*number);
        }
    }

    fn movement(&mut self, _: &Step<'_>, _: &Machine, _: Say<'_>) {
        self.last = None;
    }
}
