//! What the target knows now: where the axes stand, which feed and modes hold.

use crate::geo::Plane;
use crate::ir::Feed;
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::target::FeedWords;

/// The modes of the target and its position, in units of the last printed place.
#[derive(Debug)]
pub(super) struct Modal {
    at: [i64; AXES],
    known: AxisSet,
    /// Axes that are printed again even if they do not change.
    stale: AxisSet,
    feed: Option<(FeedKind, i64)>,
    /// The feed as it was given, which needs no second look.
    given: Option<Feed>,
    feed_kind: FeedKind,
    pub plane: Plane,
    /// Constant cutting speed is on, or a program before may have left it on.
    pub cutting_speed: bool,
    /// It is on by this program.
    pub cuts_at_speed: bool,
    /// What a dialog has said.
    pub dialog: Said,
}

/// What holds in a dialog until it is said anew.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Said {
    /// Centre of the arcs, and the plane that its axes make.
    pub center: Option<(Plane, [i64; 2])>,
    /// The speed of the spindle.
    pub speed: Option<i64>,
    /// That nothing is compensated.
    pub uncompensated: bool,
}

impl Modal {
    pub fn new(plane: Plane) -> Modal {
        Modal {
            at: [0; AXES],
            known: AxisSet::EMPTY,
            stale: AxisSet::EMPTY,
            feed: None,
            given: None,
            feed_kind: FeedKind::PerMinute,
            plane,
            cutting_speed: false,
            cuts_at_speed: false,
            dialog: Said::default(),
        }
    }

    /// Where the axes stand; only those that are known count.
    #[inline]
    pub fn at(&self) -> &[i64; AXES] {
        &self.at
    }

    /// Where `axis` stands, if the target knows.
    #[inline]
    pub fn place(&self, axis: Axis) -> Option<i64> {
        self.known.contains(axis).then_some(self.at[axis.index()])
    }

    /// Would printing `units` tell the target nothing new?
    #[inline(always)]
    pub fn says(&self, axis: Axis, units: i64) -> bool {
        self.known.contains(axis) && self.at[axis.index()] == units && !self.stale.contains(axis)
    }

    /// These axes were printed with these ends.
    #[inline(always)]
    pub fn reach(&mut self, axes: AxisSet, ends: &[i64; AXES]) {
        for axis in axes.iter() {
            self.at[axis.index()] = ends[axis.index()];
        }
        self.known = self.known.union(axes);
        self.stale = self.stale.without(axes);
    }

    /// Where a move that is not printed leads, so that what follows is judged by itself.
    #[cold]
    pub fn pretend(&mut self, axis: Axis, units: Option<i64>) {
        match units {
            Some(units) => self.begins(axis, units),
            None => self.known.remove(axis),
        }
    }

    /// `axis` stands there although nothing printed says so.
    pub fn begins(&mut self, axis: Axis, units: i64) {
        self.at[axis.index()] = units;
        self.known.insert(axis);
        self.stale.insert(axis);
    }

    /// Nobody knows in workpiece coordinates where these axes stand.
    pub fn forget(&mut self, axes: AxisSet) {
        self.known = self.known.without(axes);
    }

    pub fn forget_all(&mut self) {
        self.known = AxisSet::EMPTY;
    }

    /// A stop or a change of tool: somebody may have moved the main axes.
    pub fn may_have_moved(&mut self) {
        self.stale = AxisSet::MAIN;
    }

    /// True if the kind of feed changes to `kind`.
    pub fn feed_kind_changes(&mut self, kind: FeedKind) -> bool {
        std::mem::replace(&mut self.feed_kind, kind) != kind
    }

    /// Is a feed of this kind in force?
    pub fn has_feed_kind(&self, kind: FeedKind) -> bool {
        self.feed_kind == kind
    }

    /// True if the feed has to be printed.
    pub fn feed_changes(&mut self, feed: Feed, units: i64) -> bool {
        let kind = FeedKind::of(feed);
        let new = (kind, units);
        // By time, every line has its own feed.
        let each = kind == FeedKind::InverseTime;
        self.given = (!each).then_some(feed);
        self.feed.replace(new) != Some(new) || each
    }

    /// A feed was printed that holds for its own line.
    pub fn forget_feed(&mut self) {
        (self.feed, self.given) = (None, None);
    }

    /// Was the last feed this one, so that it holds without a word?
    #[inline(always)]
    pub fn holds(&self, feed: Feed) -> bool {
        self.given == Some(feed)
    }
}

/// What the printed feed counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FeedKind {
    PerMinute,
    PerRevolution,
    InverseTime,
}

impl FeedKind {
    #[inline]
    pub fn of(feed: Feed) -> FeedKind {
        match feed {
            Feed::PerMinute(_) => FeedKind::PerMinute,
            Feed::PerRevolution(_) => FeedKind::PerRevolution,
            Feed::InverseTime(_) => FeedKind::InverseTime,
        }
    }

    /// For people.
    pub fn name(self) -> &'static str {
        match self {
            FeedKind::PerMinute => "feed",
            FeedKind::PerRevolution => "feed per revolution",
            FeedKind::InverseTime => "feed by time",
        }
    }

    /// The word that switches to this kind.
    pub fn word(self, words: &FeedWords) -> Option<&'static str> {
        match self {
            FeedKind::PerMinute => Some(words.per_minute),
            FeedKind::PerRevolution => words.per_revolution,
            FeedKind::InverseTime => words.inverse_time,
        }
    }
}
