//! The feed word that holds on, and what it counts.

use crate::diag::Fault;
use crate::ir::Feed;

/// What F counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedKind {
    PerMinute,
    PerRevolution,
}

impl FeedKind {
    pub fn per_revolution(on: bool) -> FeedKind {
        if on { FeedKind::PerRevolution } else { FeedKind::PerMinute }
    }

    fn of(feed: Feed) -> Option<FeedKind> {
        match feed {
            Feed::PerMinute(_) => Some(FeedKind::PerMinute),
            Feed::PerRevolution(_) => Some(FeedKind::PerRevolution),
            Feed::InverseTime(_) => None,
        }
    }
}

/// The feed in force.
#[derive(Debug, Clone, Copy)]
pub struct ModalFeed {
    /// In mm.
    word: Option<Feed>,
    /// `None` until the program says it.
    kind: Option<FeedKind>,
}

impl ModalFeed {
    /// `feed` in mm per minute holds until the program says another one.
    pub fn new(feed: Option<f64>, kind: Option<FeedKind>) -> ModalFeed {
        ModalFeed { word: feed.map(Feed::PerMinute), kind }
    }

    #[inline]
    pub fn word(&self) -> Option<Feed> {
        self.word
    }

    #[inline]
    pub fn is_per_revolution(&self) -> bool {
        self.kind == Some(FeedKind::PerRevolution)
    }

    /// A number of F in mm, as it counts now.
    pub fn of(&self, value: f64) -> Option<Feed> {
        self.kind.map(|kind| match kind {
            FeedKind::PerMinute => Feed::PerMinute(value),
            FeedKind::PerRevolution => Feed::PerRevolution(value),
        })
    }

    #[inline]
    pub fn program(&mut self, feed: Feed) {
        self.word = Some(feed);
    }

    /// F counts `kind` from here on: a feed of the other kind is none any more.
    pub fn count(&mut self, kind: FeedKind) {
        self.kind = Some(kind);
        self.word = self.word.filter(|word| FeedKind::of(*word) == Some(kind));
    }

    /// The same on controls that drop the feed where the kind changes, whatever it counted.
    pub fn switch(&mut self, kind: FeedKind) {
        if self.kind != Some(kind) {
            self.word = None;
        }
        self.kind = Some(kind);
    }

    /// F counts `kind`, which the feed that follows says, or a refused block would have said.
    pub fn assume(&mut self, kind: FeedKind) {
        self.kind = Some(kind);
    }

    /// The feed of a cut. Where there is none the fault is made, and worth one report: the next cuts presume one.
    ///
    /// # Errors
    /// There is none.
    #[inline]
    pub fn of_cut(&mut self, missing: fn() -> Fault) -> Result<Feed, Fault> {
        self.word.ok_or_else(|| {
            self.presume();
            missing()
        })
    }

    /// A missing or refused feed was reported: the next moves are not worth another report.
    pub fn presume(&mut self) {
        self.word.get_or_insert(Feed::PerMinute(1.0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_feed_of_the_other_kind_is_none() {
        let mut feed = ModalFeed::new(Some(100.0), None);
        assert_eq!(feed.of(5.0), None);
        feed.count(FeedKind::PerMinute);
        assert_eq!(feed.word(), Some(Feed::PerMinute(100.0)));
        feed.count(FeedKind::PerRevolution);
        assert_eq!((feed.word(), feed.of(0.2)), (None, Some(Feed::PerRevolution(0.2))));
    }

    #[test]
    fn a_switch_drops_the_feed_once() {
        let mut feed = ModalFeed::new(None, Some(FeedKind::PerMinute));
        feed.program(Feed::PerRevolution(0.1));
        feed.switch(FeedKind::PerMinute);
        assert_eq!(feed.word(), Some(Feed::PerRevolution(0.1)));
        feed.switch(FeedKind::PerRevolution);
        assert_eq!(feed.word(), None);
        assert!(feed.is_per_revolution());
    }

    #[test]
    fn a_presumed_feed_gives_way_to_a_programmed_one() {
        let mut feed = ModalFeed::new(None, Some(FeedKind::PerMinute));
        feed.presume();
        assert!(feed.word().is_some());
        feed.program(Feed::PerMinute(50.0));
        feed.presume();
        assert_eq!(feed.word(), Some(Feed::PerMinute(50.0)));
    }
}
