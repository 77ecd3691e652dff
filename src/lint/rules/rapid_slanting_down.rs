//! A rapid move goes down and sideways at once.

use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY};

super::rule! { L1019 Motion RapidSlantingDown Note off "rapid-slanting-down"
    what "rapid move goes down and sideways at once"
    why "One block moves the tool down and sideways at rapid traverse. Controls move each axis as fast as it goes, so the way is no \
        straight line, and a clamp that the straight line misses may be hit. Position in the plane first, then go down. Off by \
        default: post-processors write such blocks high above the part."
    example r#"
-- Example (L1019_fires.H)
0 BEGIN PGM P MM
; Down and sideways in one block.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+50 R0 FMAX M3
3 L X+10 Y+10 Z+2 FMAX
4 L Z-1 F100
5 L Z+50 FMAX M30
6 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        slants() "this rapid move goes down and sideways at once" help "position in the plane first, then go down";
    }
}

#[derive(Debug)]
pub(super) struct RapidSlantingDown;

impl RapidSlantingDown {
    pub(super) fn new(_: &Setup<'_>) -> RapidSlantingDown {
        RapidSlantingDown
    }
}

impl MotionRule for RapidSlantingDown {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let down = step.rise().is_some_and(|rise| rise < -TINY);
        if step.is_rapid() && !step.of_cycle && down && step.goes_sideways() {
            say.about(L1019::slants(), step.origin);
        }
    }
}
