//! A turning tool cuts far behind the centre.

use crate::geo::Plane;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::Axis;

super::rule! { L1026 Motion BehindCentre Warning "cut-behind-centre"
    what "turning tool cuts far behind the centre"
    why "On a lathe a cutting move goes more than 5 mm behind the turning axis (radius below -5). Facing goes a little past the \
        centre; farther out a sign or a shift is wrong, and the tool cuts with its back. Machines with tools behind the centre \
        count X the other way round; suppress the finding for them. Said once for each tool."
    example r#"
-- Example (L1026_fires.MPF)
; A diameter of -20: 10 mm behind the centre.
G18 G90 DIAMON G95
T1 D1
G97 S500 M4
G0 X50 Z2
G0 Z-5
G1 X-20 F0.2
G0 X60
G0 Z50
M30
-- partc.toml
[machine]
kind = "lathe"
diameter_axis = "X"
"#
    says {
        behind(way) "this move cuts {way:.3} mm behind the turning axis" help "check the sign of X and the shift of the zero";
    }
}

/// Farthest behind the centre that facing needs, mm.
const MOST_BEHIND: f64 = 5.0;

#[derive(Debug, Default)]
pub(super) struct BehindCentre {
    said: bool,
    lathe: bool,
}

impl BehindCentre {
    pub(super) fn new(setup: &Setup<'_>) -> BehindCentre {
        BehindCentre { lathe: setup.is_lathe(), ..BehindCentre::default() }
    }
}

impl MotionRule for BehindCentre {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        // X of a tilted plane is no radius: what is turned is turned without one.
        let turning = self.lathe && step.mv.plane == Plane::Zx && step.cuts() && !self.said && !step.is_tilted();
        if let Some(x) = step.to.get(Axis::X).filter(|x| turning && *x < -MOST_BEHIND) {
            self.said = true;
            say.about(L1026::behind(&-x), step.origin);
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::ToolChange { .. }) {
            self.said = false;
        }
    }
}
