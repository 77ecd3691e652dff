//! No move reaches the blank that the program describes.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::Axis;

/// Room for the radius of tools around the blank, mm.
const ROOM: f64 = 100.0;

#[derive(Debug, Default)]
pub(super) struct BlankUntouched {
    blank: Option<Blank>,
    first: Option<Origin>,
    reached: bool,
}

impl BlankUntouched {
    pub(super) fn new(setup: &Setup<'_>) -> BlankUntouched {
        BlankUntouched { blank: setup.blank, ..BlankUntouched::default() }
    }
}

impl MotionRule for BlankUntouched {
    fn wants_moves(&self) -> bool {
        self.blank.is_some()
    }

    fn movement(&mut self, step: &Step<'_>, _: &Machine, _: Say<'_>) {
        let Some(blank) = self.blank.filter(|_| step.cuts() && !self.reached) else { return };
        self.first.get_or_insert(*step.origin);
        // The tool has a radius: as much room around.
        self.reached = Axis::ALL[..3].iter().all(|axis| {
            let (a, b) = (step.from.get(*axis), step.to.get(*axis));
            let (Some(a), Some(b)) = (a.or(b), b.or(a)) else { return true };
            let (min, max) = (blank.min[axis.index()] - ROOM, blank.max[axis.index()] + ROOM);
            a.min(b) <= max && a.max(b) >= min
        });
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::WorkOffset(_)) && self.first.is_some() {
            self.blank = None;
        }
    }

    fn finish(&mut self, _: &Machine, say: Say<'_>) {
        if let Some(first) = self.first.filter(|_| self.blank.is_some() && !self.reached) {
            say.about(codes::L1032, &first, "no cut of this program reaches its blank", "check BLK FORM and the zero");
        }
    }
}
