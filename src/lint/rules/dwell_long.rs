//! A dwell takes more than a minute.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};

super::rule! { L1012 Motion DwellLong Warning "dwell-long"
    what "dwell takes more than a minute"
    why "A dwell of more than 60 seconds is most often one in other units: `G4 F500` waits 500 seconds on a SINUMERIK, not \
        milliseconds. With the tool on the part it burns; in any case the machine seems to hang."
    example r#"
-- Example (L1012_fires.MPF)
; 500 seconds, meant as milliseconds.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G4 F500
G0 Z50
M30
"#
    says {
        long(seconds) "this dwell takes {seconds} seconds" help "check the unit: the control counts in seconds";
    }
}

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
            say.about(L1012::long(&seconds), origin);
        }
    }
}
