//! The tool plunges at the feed of milling.

use crate::ir::{Feed, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY};

super::rule! { L1014 Motion PlungeAtFeed Note off "plunge-at-milling-feed"
    what "tool plunges at the feed of milling"
    why "The tool goes straight down at feed, and the move after it cuts sideways at the same feed. End mills take far less along \
        their axis: plunge at a third of the feed, ramp, or go in by a helix. Off by default: wherever the tool goes down beside \
        the part it is right."
    example r#"
-- Example (L1014_fires.H)
0 BEGIN PGM P MM
; F300 down and F300 sideways.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-5 F300
4 L X+50 F300
5 L Z+50 FMAX M30
6 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        plunges() "the tool plunges at the feed of milling" help "plunge at a lower feed, or ramp";
    }
}

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
            say.about(L1014::plunges(), &origin);
        }
        let goes_down = step.is_line() && !step.of_cycle && !sideways && step.rise().is_some_and(|rise| rise < -TINY);
        self.down = step.feed().filter(|_| goes_down).map(|feed| (*step.origin, feed));
    }
}
