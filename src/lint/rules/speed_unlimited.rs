//! Constant cutting speed without a limit of the speed.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

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
            let message = "constant cutting speed, and nothing limits the speed of the spindle";
            say.about(codes::L1027, origin, message, "limit the speed before it (LIMS=, G26)");
        }
    }
}
