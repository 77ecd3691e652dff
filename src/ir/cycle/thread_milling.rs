//! Arguments of thread milling: helices of one pitch, with a semicircle to them and from them; holes and countersinks that
//! belong to them.

use core::fmt;

use crate::geo::{Point2, parts};
use crate::ir::{Feed, Pos};

use super::Family;
use super::drilling::{Drilling, DrillingFault};
use super::milling::{Mill, MillFault, Place};

/// Most turns or passes; more is a lost decimal point.
const MOST: f64 = 10_000.0;
/// A shorter way has no length, mm.
const NOTHING: f64 = 1e-6;

/// A milled thread.
#[derive(Debug, Clone, PartialEq)]
pub struct ThreadMilling {
    /// The clearance is also that beside an external thread; the depth is the end of the thread.
    pub mill: Mill,
    /// Its middle, and where the helix begins, on the first axis.
    pub place: Place,
    pub side: Side,
    /// Radius of the finished thread at its crest and at its root: the one with the greater radius is the nominal one.
    pub nominal: f64,
    pub core: f64,
    pub pitch: f64,
    pub left_hand: bool,
    /// Sense in which the tool goes round.
    pub counter_clockwise: bool,
    pub turns: Turns,
    /// What each pass leaves of the depth of the thread, from the first one on.
    pub rests: Vec<f64>,
    pub ways: Ways,
    /// Before the thread is cut, and afterwards.
    pub before: Vec<Stage>,
    pub after: Vec<Stage>,
}

/// How a thread is made of turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turns {
    /// One after the other over the whole depth.
    Continuous,
    /// One for each strip that so many teeth cut at once.
    Strips(u32),
    /// One at the depth.
    Once,
}

/// Ways to the thread and from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ways {
    /// Where they begin, on the first axis; `None`: the middle, or beside an external thread as far as the clearance asks.
    pub beside: Option<f64>,
    /// Feed of the way to the thread.
    pub onto: Feed,
    /// Along the tool axis on the way to the thread, and on the way from it.
    pub along: [f64; 2],
    /// The thread itself begins or ends at the depth, and the way to it or from it lies beyond.
    pub beyond: bool,
    /// Straight to the safety distance over the middle, or beside the stud, and from there on so.
    pub positioning: Option<Positioning>,
}

/// How the tool goes where it does not cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Positioning {
    At(Feed),
    Rapid,
}

/// What is made in the same place beside the thread.
#[derive(Debug, Clone, PartialEq)]
pub enum Stage {
    Drill(Drilling),
    Sink(Sink),
}

/// A countersink: down in the middle or beside the thread, and round.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sink {
    /// Height where the feed for the depth ends.
    pub approach: f64,
    pub height: f64,
    /// Of the circle, which a semicircle leads to and from; 0 for none.
    pub radius: f64,
    pub counter_clockwise: bool,
    pub feed: Feed,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    Internal,
    External,
}

/// Arguments that make no thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadMillingFault {
    Mill(MillFault),
    Number,
    Pitch,
    Depth,
    /// The cutter does not fit into the core.
    Cutter,
    /// A way to the thread has no length.
    Way,
    Hole(DrillingFault),
    TooMany,
}

impl fmt::Display for ThreadMillingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ThreadMillingFault::Mill(fault) => return fault.fmt(f),
            ThreadMillingFault::Number => "a diameter is not above 0, or what a pass leaves is below 0",
            ThreadMillingFault::Pitch => "the pitch is not above 0",
            ThreadMillingFault::Depth => "the thread has no depth: its core is not smaller than its diameter",
            ThreadMillingFault::Cutter => "the cutter is larger than the core of the thread",
            ThreadMillingFault::Way => "the way to the thread begins on it",
            ThreadMillingFault::Hole(fault) => return fault.fmt(f),
            ThreadMillingFault::TooMany => "the thread has so many turns or passes that they do not end",
        })
    }
}

/// A helix along the tool axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    /// Where the way to it begins.
    pub start: f64,
    /// Where the thread begins and ends.
    pub first: f64,
    pub last: f64,
    /// Where the way from it ends.
    pub end: f64,
    pub turns: u32,
}

impl Ways {
    /// Half a pitch on each, none of it beyond the depth.
    pub fn of_half_a_pitch(pitch: f64, feed: Feed) -> Ways {
        Ways { beside: None, onto: feed, along: [pitch / 2.0; 2], beyond: false, positioning: None }
    }
}

impl ThreadMilling {
    /// 1 where the tool travels along the tool axis as it counts, -1 against it.
    fn along(&self) -> f64 {
        if self.counter_clockwise == self.left_hand { -1.0 } else { 1.0 }
    }

    /// Radius of the path of the centre, by what the pass leaves.
    pub fn radius(&self, rest: f64) -> f64 {
        match self.side {
            Side::Internal => self.nominal - self.mill.radius - rest,
            Side::External => self.core + self.mill.radius + rest,
        }
    }

    /// Where the tool goes up and down: in the middle, or beside the thread.
    pub fn entry(&self) -> Point2 {
        match self.side {
            _ if self.ways.beside.is_some() => Point2::new(self.ways.beside.unwrap_or(0.0), 0.0),
            Side::Internal => Point2::origin(),
            Side::External => {
                let clearance = self.mill.heights.clearance;
                let beside = self.nominal + self.mill.radius + clearance;
                Point2::new(beside.max(self.radius(0.0) + 2.0 * clearance), 0.0)
            }
        }
    }

    /// The helices one after the other: more than one where the edge has fewer teeth than the thread turns.
    pub fn helices(&self) -> Vec<Helix> {
        let heights = &self.mill.heights;
        let whole = |way: f64, most: f64| parts::count(way, most).max(1.0);
        let (count, turns, strip) = match self.turns {
            Turns::Continuous => (1.0, whole(heights.way(), self.pitch), 0.0),
            Turns::Once => (1.0, 1.0, 0.0),
            Turns::Strips(teeth) => {
                let strip = self.pitch * f64::from(teeth);
                (whole(heights.way(), strip), 1.0, strip)
            }
        };
        let outwards = self.along() * heights.outward() > 0.0;
        let [onto, off] = self.ways.along.map(|way| way * self.along());
        let thread = turns * self.pitch * self.along();
        let helix = |i: f64| {
            let lowest = heights.depth + i * strip * heights.outward();
            let first = match (outwards, self.ways.beyond) {
                (true, true) => lowest,
                (true, false) => lowest + onto,
                (false, true) => lowest - thread,
                (false, false) => lowest - off - thread,
            };
            let last = if !outwards && self.ways.beyond { lowest } else { first + thread };
            let start = if outwards && !self.ways.beyond { lowest } else { first - onto };
            let end = if outwards || self.ways.beyond { last + off } else { lowest };
            Helix { start, first, last, end, turns: turns as u32 }
        };
        let strips = count as u32;
        let order: Vec<u32> = if outwards { (0..strips).collect() } else { (0..strips).rev().collect() };
        order.into_iter().map(|i| helix(f64::from(i))).collect()
    }
}

impl ThreadMilling {
    /// Does the circle of a countersink go through where the tool goes down?
    fn sinks_where_it_stands(&self) -> bool {
        let at = if self.side == Side::External { self.entry().x } else { 0.0 };
        self.stages().any(|stage| match stage {
            Stage::Sink(sink) => sink.radius > 0.0 && (sink.radius - at).abs() < NOTHING,
            Stage::Drill(_) => false,
        })
    }

    fn stages(&self) -> impl Iterator<Item = &Stage> {
        self.before.iter().chain(&self.after)
    }
}

impl Stage {
    fn fault(&self) -> Option<ThreadMillingFault> {
        match self {
            Stage::Drill(hole) => hole.check().err().map(ThreadMillingFault::Hole),
            Stage::Sink(sink) => {
                let good = [sink.approach, sink.height, sink.radius].iter().all(|v| v.is_finite())
                    && sink.radius >= 0.0
                    && sink.feed.value() > 0.0;
                (!good).then_some(ThreadMillingFault::Number)
            }
        }
    }
}

impl Family for ThreadMilling {
    type Fault = ThreadMillingFault;

    fn check(&self) -> Result<(), ThreadMillingFault> {
        self.mill.check().map_err(ThreadMillingFault::Mill)?;
        let positive = |v: f64| v > 0.0 && v.is_finite();
        if !positive(self.nominal) || !positive(self.core) || !self.rests.iter().all(|rest| *rest >= 0.0) {
            Err(ThreadMillingFault::Number)
        } else if !positive(self.pitch) || self.turns == Turns::Strips(0) {
            Err(ThreadMillingFault::Pitch)
        } else if self.core > self.nominal || self.core == self.nominal && self.ways.beside.is_none() {
            Err(ThreadMillingFault::Depth)
        } else if self.side == Side::Internal && self.mill.radius >= self.core {
            Err(ThreadMillingFault::Cutter)
        } else if self.mill.heights.way() / self.pitch > MOST || self.rests.is_empty() || self.rests.len() as f64 > MOST
        {
            Err(ThreadMillingFault::TooMany)
        } else if (self.entry().x - self.radius(0.0)).abs() < NOTHING || self.sinks_where_it_stands() {
            Err(ThreadMillingFault::Way)
        } else if let Some(fault) = self.stages().find_map(Stage::fault) {
            Err(fault)
        } else {
            Ok(())
        }
    }

    fn moves(&self) -> f64 {
        4.0 * self.rests.len() as f64 * self.helices().len() as f64
    }

    /// Above where it goes up.
    fn leaves(&self, at: &mut Pos) {
        let home = if self.side == Side::Internal { Point2::origin() } else { self.entry() };
        self.mill.leaves_above(self.place.point(home), at);
    }
}
