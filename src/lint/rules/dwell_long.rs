//! A dwell takes more than a minute.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

/// Longest dwell that is nothing special, seconds.
const LONGEST: f64 = 60.0;

#[derive(Debug)]
pub(super) struct DwellLong;

impl DwellLong {
    pub(super) fn new(_: &Setup<'_>) -> DwellLong {
        DwellLong
    }
}

impl MotionRule for DwellLong {
    fn wants_moves(&self) -> bool {
        false
    }

    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        if let Function::Dwell(seconds) = function
            && *seconds > LONGEST
        {
            let message = format!("this dwell takes {seconds} seconds");
            say.about(codes::L1012, origin, message, "check the unit: the control counts in seconds");
        }
    }
}
