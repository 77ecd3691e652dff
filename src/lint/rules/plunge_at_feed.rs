//! The tool plunges at the feed of milling.

use crate::diag::codes;
use crate::ir::{Feed, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY};

#[derive(Debug, Default)]
pub(super) struct PlungeAtFeed {
    down: Option<(Origin, Feed)>,
}

impl PlungeAtFeed {
    pub(super) fn new(_: &Setup<'_>) -> PlungeAtFeed {
        PlungeAtFeed::default()
    }
}

impl MotionRule for PlungeAtFeed {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let sideways = step.goes_sideways();
        if let (Some((origin, feed)), true) = (self.down, sideways)
            && step.feed() == Some(feed)
        {
            say.about(
                codes::L1014,
                &origin,
                "the tool plunges at the feed of milling",
                "plunge at a lower feed, or ramp",
            );
        }
        let goes_down = step.is_line() && !step.of_cycle && !sideways && step.rise().is_some_and(|rise| rise < -TINY);
        self.down = step.feed().filter(|_| goes_down).map(|feed| (*step.origin, feed));
    }
}
