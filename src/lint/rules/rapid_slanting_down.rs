//! A rapid move goes down and sideways at once.

use crate::diag::codes;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY};

#[derive(Debug)]
pub(super) struct RapidSlantingDown;

impl RapidSlantingDown {
    pub(super) fn new(_: &Setup<'_>) -> RapidSlantingDown {
        RapidSlantingDown
    }
}

impl MotionRule for RapidSlantingDown {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let down = step.rise().is_some_and(|rise| rise < -TINY);
        if step.is_rapid() && !step.of_cycle && down && step.goes_sideways() {
            let message = "this rapid move goes down and sideways at once";
            say.about(codes::L1019, step.origin, message, "position in the plane first, then go down");
        }
    }
}
