//! Constant cutting speed without a limit of the speed.

use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

super::rule! { L1027 Motion SpeedUnlimited Warning "cutting-speed-unlimited"
    what "constant cutting speed without a limit of the speed"
    why "G96 keeps the cutting speed constant, so the spindle turns the faster the nearer the tool comes to the centre, up to what \
        the machine can do. Without LIMS= or G26 a part or a chuck that is not made for it flies out. Program a limit that part, \
        chuck and bar take."
    example r#"
-- Example (L1027_fires.MPF)
; Nothing limits the speed.
G18 G90 DIAMON G95
T1 D1
G96 S200 M4
G0 X50 Z2
G1 Z-5 F0.2
G0 X60
G97 S500
G0 Z50
M30
-- partc.toml
[machine]
kind = "lathe"
diameter_axis = "X"
"#
    says {
        unlimited() "constant cutting speed, and nothing limits the speed of the spindle"
            help "limit the speed before it (LIMS=, G26)";
    }
}

#[derive(Debug, Default)]
pub(super) struct SpeedUnlimited {
    said: bool,
}

impl SpeedUnlimited {
    pub(super) fn new(_: &Setup<'_>) -> SpeedUnlimited {
        SpeedUnlimited::default()
    }
}

impl MotionRule for SpeedUnlimited {
    fn wants_moves(&self) -> bool {
        false
    }

    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        let cutting = match function {
            Function::Spindle(Spindle::CuttingSpeed { limit, .. }) => limit,
            Function::SpindleOf { spindle: Spindle::CuttingSpeed { limit, .. }, .. } => limit,
            _ => return,
        };
        if cutting.is_none() && !self.said {
            self.said = true;
            say.about(L1027::unlimited(), origin);
        }
    }
}
