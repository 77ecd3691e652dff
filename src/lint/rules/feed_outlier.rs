//! The feed is far from the one before it.

use crate::diag::codes;
use crate::ir::{Feed, Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

/// Most that feeds differ by that follow each other.
const MOST_TIMES: f64 = 200.0;

#[derive(Debug, Default)]
pub(super) struct FeedOutlier {
    last: Option<Feed>,
}

impl FeedOutlier {
    pub(super) fn new(_: &Setup<'_>) -> FeedOutlier {
        FeedOutlier::default()
    }
}

impl MotionRule for FeedOutlier {
    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let Some(feed) = step.feed().filter(|_| step.cuts() && !step.of_cycle && step.goes_sideways()) else { return };
        if let Some(before) = self.last
            && std::mem::discriminant(&before) == std::mem::discriminant(&feed)
        {
            let (less, more) = (before.value().min(feed.value()), before.value().max(feed.value()));
            if more > less * MOST_TIMES {
                let message = format!("this cut goes at {}, the one before it at {}", feed.value(), before.value());
                say.about(codes::L1033, step.origin, message, "check the decimal points and units of both");
            }
        }
        self.last = Some(feed);
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::ToolChange { .. }) {
            self.last = None;
        }
    }
}
