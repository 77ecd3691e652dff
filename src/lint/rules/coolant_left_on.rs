//! The program ends and nothing turned the coolant off.

use crate::ir::function::Coolant;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

super::rule! { L1009 Motion CoolantLeftOn Note off "coolant-left-on"
    what "program ends and nothing turned the coolant off"
    why "M7 or M8 was on, and the program ends without M9. Most controls turn the coolant off at M30; where the program is called \
        by another one, or ends without M30, it runs on. Off by default."
    example r#"
-- Example (L1009_fires.MPF)
; M8 and no M9.
T1 M6
S1000 M3
G0 X0 Y0 Z5 M8
G1 X10 F100
G0 Z50
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        left_on() "this coolant is never turned off" help "program M9 before the end";
    }
}

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
            say.about(L1009::left_on(), &on);
        }
    }
}
