//! A dwell takes no time.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};
use crate::text::Sources;
use crate::text::decode::readable;

super::rule! { L1011 Motion DwellZero Warning "dwell-zero"
    what "dwell takes no time"
    why "A dwell of 0 seconds does nothing, and some controls read 0 as another value. A parameter was not set, or a digit is \
        missing. Where P2021 has said already that nothing sets the variable, it is not said again."
    example r#"
-- Example (L1011_fires.MPF)
; No time at all.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G4 F0
G0 Z50
M30
"#
    says {
        empty() "this dwell takes no time" help "give it a time, or remove it";
    }
}

#[derive(Debug)]
pub(super) struct DwellZero<'a> {
    sources: &'a Sources,
}

impl<'a> DwellZero<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> DwellZero<'a> {
        DwellZero { sources: setup.sources }
    }
}

impl MotionRule for DwellZero<'_> {
    fn wants_moves(&self) -> bool {
        false
    }

    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        if !matches!(function, Function::Dwell(seconds) if *seconds <= 0.0) {
            return;
        }
        // What the operator sets before the start is 0 here only.
        let block = self.sources.bytes(origin.loc.file, origin.loc.span);
        if !say.reads_unset(&readable(&block)) {
            say.about(L1011::empty(), origin);
        }
    }
}
