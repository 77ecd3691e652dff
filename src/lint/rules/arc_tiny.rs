//! An arc has a radius below 0.005 mm.

use crate::geo::distance;
use crate::ir::motion::Path;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1024 Motion ArcTiny Note off "arc-tiny"
    what "arc has a radius below 0.005 mm"
    why "An arc is so small that the machine cannot make it: a rest of a post-processor, or a radius in the wrong unit. Off by \
        default."
    example r#"
-- Example (L1024_fires.MPF)
; A radius of 0.004 mm.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G2 X0.004 Y0.004 I0.004 J0 F100
G0 Z50
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        tiny(radius) "this arc has a radius of {radius:.4} mm" help "a straight line does the same";
    }
}

/// Smallest radius that is nothing special, mm.
const SMALLEST: f64 = 0.005;

#[derive(Debug)]
pub(super) struct ArcTiny;

impl ArcTiny {
    pub(super) fn new(_: &Setup<'_>) -> ArcTiny {
        ArcTiny
    }
}

impl MotionRule for ArcTiny {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let Path::Arc(arc, _) = &step.mv.path else { return };
        let radius = distance(arc.from, arc.center);
        if radius < SMALLEST {
            say.about(L1024::tiny(&radius), step.origin);
        }
    }
}
