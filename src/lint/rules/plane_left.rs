//! A milling program ends in another plane than G17.

use crate::diag::codes;
use crate::geo::Plane;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

#[derive(Debug, Default)]
pub(super) struct PlaneLeft {
    last: Option<Origin>,
    lathe: bool,
}

impl PlaneLeft {
    pub(super) fn new(setup: &Setup<'_>) -> PlaneLeft {
        PlaneLeft { lathe: setup.is_lathe(), ..PlaneLeft::default() }
    }
}

impl MotionRule for PlaneLeft {
    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, _: Say<'_>) {
        if let Function::Plane(plane) = function {
            self.last = (*plane != Plane::Xy).then_some(*origin);
        }
    }

    // Not every language says the plane by itself.
    fn movement(&mut self, step: &Step<'_>, _: &Machine, _: Say<'_>) {
        if step.mv.plane == Plane::Xy {
            self.last = None;
        } else if !step.of_cycle {
            self.last.get_or_insert(*step.origin);
        }
    }

    fn finish(&mut self, _: &Machine, say: Say<'_>) {
        if let Some(origin) = self.last.filter(|_| !self.lathe) {
            say.about(codes::L1025, &origin, "this plane holds up to the end of the program", "go back to G17");
        }
    }
}
