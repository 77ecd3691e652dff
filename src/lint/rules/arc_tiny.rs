//! An arc has a radius below 0.005 mm.

use crate::diag::codes;
use crate::geo::distance;
use crate::ir::motion::Path;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

/// Smallest radius that is nothing special, mm.
const SMALLEST: f64 = 0.005;

#[derive(Debug)]
pub(super) struct ArcTiny;

impl ArcTiny {
    pub(super) fn new(_: &Setup<'_>) -> ArcTiny {
        ArcTiny
    }
}

impl MotionRule for ArcTiny {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let Path::Arc(arc, _) = &step.mv.path else { return };
        let radius = distance(arc.from, arc.center);
        if radius < SMALLEST {
            let message = format!("this arc has a radius of {radius:.4} mm");
            say.about(codes::L1024, step.origin, message, "a straight line does the same");
        }
    }
}
