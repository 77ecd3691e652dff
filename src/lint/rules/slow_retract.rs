//! The tool is lifted far at feed.

use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1028 Motion SlowRetract Note off "retract-at-feed"
    what "tool is lifted far at feed"
    why "The tool goes up more than 50 mm at a cutting feed. That takes time and does nothing; FMAX or G0 may have been meant. Off \
        by default: for reamers and boring tools it is right."
    example r#"
-- Example (L1028_fires.H)
0 BEGIN PGM P MM
; 100 mm up at F1000.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-5 F100
4 L X+50 F300
5 L Z+95 F1000
6 L X+0 FMAX M30
7 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        lifted(rise) "the tool is lifted {rise:.1} mm at feed" help "retract at rapid traverse (G0, FMAX)";
    }
}

/// Farthest retract at feed that is nothing special, mm.
const FAR: f64 = 50.0;

#[derive(Debug)]
pub(super) struct SlowRetract;

impl SlowRetract {
    pub(super) fn new(_: &Setup<'_>) -> SlowRetract {
        SlowRetract
    }
}

impl MotionRule for SlowRetract {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let far = step.rise().filter(|rise| *rise > FAR);
        if let Some(rise) = far.filter(|_| step.is_line() && !step.of_cycle && !step.goes_sideways()) {
            say.about(L1028::lifted(&rise), step.origin);
        }
    }
}
