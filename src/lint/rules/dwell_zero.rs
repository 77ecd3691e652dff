//! A dwell takes no time.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};
use crate::text::Sources;
use crate::text::decode::readable;

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
            say.about(codes::L1011, origin, "this dwell takes no time", "give it a time, or remove it");
        }
    }
}
