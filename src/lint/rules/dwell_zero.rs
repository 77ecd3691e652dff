//! A dwell takes no time.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

#[derive(Debug)]
pub(super) struct DwellZero;

impl DwellZero {
    pub(super) fn new(_: &Setup<'_>) -> DwellZero {
        DwellZero
    }
}

impl MotionRule for DwellZero {
    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        if matches!(function, Function::Dwell(seconds) if *seconds <= 0.0) {
            say.about(codes::L1011, origin, "this dwell takes no time", "give it a time, or remove it");
        }
    }
}
