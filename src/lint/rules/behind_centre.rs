//! A turning tool cuts far behind the centre.

use crate::diag::codes;
use crate::geo::Plane;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::Axis;

/// Farthest behind the centre that facing needs, mm.
const MOST_BEHIND: f64 = 5.0;

#[derive(Debug, Default)]
pub(super) struct BehindCentre {
    said: bool,
    lathe: bool,
}

impl BehindCentre {
    pub(super) fn new(setup: &Setup<'_>) -> BehindCentre {
        BehindCentre { lathe: setup.is_lathe(), ..BehindCentre::default() }
    }
}

impl MotionRule for BehindCentre {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let turning = self.lathe && step.mv.plane == Plane::Zx && step.cuts() && !self.said;
        if let Some(x) = step.to.get(Axis::X).filter(|x| turning && *x < -MOST_BEHIND) {
            self.said = true;
            let message = format!("this move cuts {:.3} mm behind the turning axis", -x);
            say.about(codes::L1026, step.origin, message, "check the sign of X and the shift of the zero");
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::ToolChange { .. }) {
            self.said = false;
        }
    }
}
