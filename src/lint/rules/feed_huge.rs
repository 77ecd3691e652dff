//! The feed is larger than tools take.

use crate::diag::codes;
use crate::ir::Feed;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

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
        let (feed, unit, is_huge) = match step.feed() {
            Some(Feed::PerMinute(feed)) => (feed, "mm per minute", feed > MOST_A_MINUTE),
            Some(Feed::PerRevolution(feed)) => (feed, "mm per revolution", feed > MOST_A_TURN),
            Some(Feed::InverseTime(_)) | None => return,
        };
        if is_huge && feed != self.last && !step.of_cycle {
            let message = format!("this move goes at {feed} {unit}");
            say.about(codes::L1016, step.origin, message, "check the unit of the feed and the decimal point");
        }
        self.last = feed;
    }
}
