//! The feed is below 1 mm per minute.

use crate::diag::codes;
use crate::ir::Feed;
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

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
            let message = format!("this move goes at {feed} mm per minute");
            say.about(codes::L1015, step.origin, message, "is the feed meant per revolution (G95, FU, M136)?");
        }
        self.last = feed;
    }
}
