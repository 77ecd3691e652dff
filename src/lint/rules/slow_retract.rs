//! The tool is lifted far at feed.

use crate::diag::codes;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

/// Farthest retract at feed that is nothing special, mm.
const FAR: f64 = 50.0;

#[derive(Debug)]
pub(super) struct SlowRetract;

impl SlowRetract {
    pub(super) fn new(_: &Setup<'_>) -> SlowRetract {
        SlowRetract
    }
}

impl MotionRule for SlowRetract {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let far = step.rise().filter(|rise| *rise > FAR);
        if let Some(rise) = far.filter(|_| step.is_line() && !step.of_cycle && !step.goes_sideways()) {
            let message = format!("the tool is lifted {rise:.1} mm at feed");
            say.about(codes::L1028, step.origin, message, "retract at rapid traverse (G0, FMAX)");
        }
    }
}
