//! The feed is far from the one before it.

use crate::ir::{Feed, Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};

super::rule! { L1033 Motion FeedOutlier Warning "feed-outlier"
    what "feed is far from the one before"
    why "Two cuts of one tool that follow each other sideways differ in their feeds by a factor of more than 200. One of the two \
        numbers has its decimal point in the wrong place, or is in another unit."
    example r#"
-- Example (L1033_fires.MPF)
; 500 and 1 mm per minute.
T1 M6
S1000 M3
G0 X0 Y0 Z5
G1 X10 F500
X20 F1
G0 Z50
M30
"#
    says {
        apart(feed, before) "this cut goes at {feed}, the one before it at {before}"
            help "check the decimal points and units of both";
    }
}

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
                say.about(L1033::apart(&feed.value(), &before.value()), step.origin);
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
