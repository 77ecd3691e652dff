//! A milling program ends in another plane than G17.

use crate::geo::Plane;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1025 Motion PlaneLeft Note off "plane-left-changed"
    what "program ends in another working plane than G17"
    why "On a milling machine the program ends while G18 or G19 holds. A program that follows, or a restart in the middle, may \
        trust in G17. Off by default: controls reset the plane at the end of a program."
    example r#"
-- Example (L1025_fires.MPF)
; G18 holds at the end.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G18
G2 X10 Z5 I5 K0 F100
G0 Z50
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        left() "this plane holds up to the end of the program" help "go back to G17";
    }
}

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
            say.about(L1025::left(), &origin);
        }
    }
}
