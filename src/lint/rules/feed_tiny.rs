//! The feed is below 1 mm per minute.

use crate::ir::Feed;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1015 Motion FeedTiny Warning "feed-tiny"
    what "feed is below 1 mm per minute"
    why "A cutting move goes at less than 1 mm per minute. The number is most often meant per revolution (`F0.2` under G94 instead \
        of G95), or a decimal point is in the wrong place: the machine seems to stand. Said once for each feed."
    example r#"
-- Example (L1015_fires.MPF)
; 0.2 mm per minute.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G1 X10 F0.2
G0 Z50
M30
"#
    says {
        slow(feed) "this move goes at {feed} mm per minute" help "is the feed meant per revolution (G95, FU, M136)?";
    }
}

/// Least feed that is nothing special, mm/min.
const LEAST: f64 = 1.0;

#[derive(Debug, Default)]
pub(super) struct FeedTiny {
    last: f64,
}

impl FeedTiny {
    pub(super) fn new(_: &Setup<'_>) -> FeedTiny {
        FeedTiny::default()
    }
}

impl MotionRule for FeedTiny {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let Some(Feed::PerMinute(feed)) = step.feed() else { return };
        if feed < LEAST && feed != self.last && step.cuts() {
            say.about(L1015::slow(&feed), step.origin);
        }
        self.last = feed;
    }
}
