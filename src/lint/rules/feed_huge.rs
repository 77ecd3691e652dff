//! The feed is larger than tools take.

use crate::ir::Feed;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1016 Motion FeedHuge Warning "feed-huge"
    what "feed is larger than tools take"
    why "A cutting move goes at more than 5 mm per revolution, or at more than 50 m per minute. The number is most often meant in \
        the other unit (`F200` under G95 instead of G94), or a decimal point is missing. Threads are cut with their lead and are \
        not meant. Said once for each feed."
    example r#"
-- Example (L1016_fires.MPF)
; 200 mm per revolution.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G95 G1 X10 F200
G0 Z50
M30
"#
    says {
        a_minute(feed) "this move goes at {feed} mm per minute" help "check the unit of the feed and the decimal point";
        a_turn(feed) "this move goes at {feed} mm per revolution" help "check the unit of the feed and the decimal point";
    }
}

/// Most mm per minute and per revolution that are nothing special.
const MOST_A_MINUTE: f64 = 50_000.0;
const MOST_A_TURN: f64 = 5.0;

#[derive(Debug, Default)]
pub(super) struct FeedHuge {
    last: f64,
}

impl FeedHuge {
    pub(super) fn new(_: &Setup<'_>) -> FeedHuge {
        FeedHuge::default()
    }
}

impl MotionRule for FeedHuge {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let (feed, a_minute, is_huge) = match step.feed() {
            Some(Feed::PerMinute(feed)) => (feed, true, feed > MOST_A_MINUTE),
            Some(Feed::PerRevolution(feed)) => (feed, false, feed > MOST_A_TURN),
            Some(Feed::InverseTime(_)) | None => return,
        };
        if is_huge && feed != self.last && !step.of_cycle {
            say.about(if a_minute { L1016::a_minute(&feed) } else { L1016::a_turn(&feed) }, step.origin);
        }
        self.last = feed;
    }
}
