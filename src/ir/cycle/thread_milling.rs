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

/// A milled thread. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct ThreadMilling {
    /// The clearance is also that beside an external thread, and the depth is the end of the thread.
    pub mill: Mill,
    /// The middle of the thread; on its first axis each helix begins.
    pub place: Place,
    /// In a bore or on a stud.
    pub side: Side,
    /// Greater radius of the finished thread: the root of an internal one, the crest of an external one.
    pub nominal: f64,
    /// Smaller radius of the finished thread, above 0: the crest of an internal one, the root of an external one. Equal
    /// to `nominal` only where `ways.beside` is given.
    pub core: f64,
    /// Along the tool axis in a turn, above 0.
    pub pitch: f64,
    /// The thread is left-hand. Together with `counter_clockwise` this says which way the helix leads along the tool
    /// axis.
    pub left_hand: bool,
    /// Sense in which the tool goes round the thread, seen against the plane normal.
    pub counter_clockwise: bool,
    /// How many turns a helix has, and how many helices there are.
    pub turns: Turns,
    /// What each pass leaves of the depth of the thread, as a difference of radii, from the first pass on; one at
    /// least, each 0 or more.
    pub rests: Vec<f64>,
    /// How the cutter comes to the thread and leaves it.
    pub ways: Ways,
    /// What is made before the thread is cut.
    pub before: Vec<Stage>,
    /// What is made after it.
    pub after: Vec<Stage>,
}

/// How a thread is made of turns of the cutter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turns {
    /// One after the other over the whole depth.
    Continuous,
    /// One for each strip that so many teeth cut at once, 1 or more.
    Strips(u32),
    /// One at the depth.
    Once,
}

/// Paths to the thread and from it: semicircles in the plane that climb or fall. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ways {
    /// Coordinate on the first axis, from the middle, where they begin; `None`: the middle, or beside an external
    /// thread as far as the clearance asks.
    pub beside: Option<f64>,
    /// Feed of the path to the thread, above 0; the path from it takes that of the plane.
    pub onto: Feed,
    /// Travel along the tool axis on the path to the thread, and on the path from it, in the sense of the helix.
    pub along: [f64; 2],
    /// The thread itself begins or ends at the depth, and the path to it or from it lies beyond; else nothing lies
    /// beyond the depth.
    pub beyond: bool,
    /// How the tool goes where it does not cut, from the safety distance on, to which it goes straight over the middle
    /// or beside the stud. `None`: from the retract height as in every milling cycle, down at rapid traverse, and back
    /// at the feed for the depth.
    pub positioning: Option<Positioning>,
}

/// How the tool goes where it does not cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Positioning {
    /// At this feed.
    At(Feed),
    /// At rapid traverse.
    Rapid,
}

/// What is made in the same place beside the thread.
#[derive(Debug, Clone, PartialEq)]
pub enum Stage {
    /// A hole where the tool goes down, for an internal thread in its middle.
    Drill(Drilling),
    /// A countersink.
    Sink(Sink),
}

/// A countersink: down in the middle or beside the thread, and round. Heights are coordinates along the tool axis, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sink {
    /// Height down to which the feed for the depth holds, or the positioning of the thread.
    pub approach: f64,
    /// Height of the circle.
    pub height: f64,
    /// Radius of the circle of the centre, mm, which a semicircle leads to and from; 0 for no circle.
    pub radius: f64,
    /// Sense of the circle, seen against the plane normal.
    pub counter_clockwise: bool,
    /// From the approach to the height, and round; above 0.
    pub feed: Feed,
}

/// On which side of the material a thread is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// In a bore: the cutter is inside of the thread.
    Internal,
    /// On a stud: the cutter is around it.
    External,
}

/// Arguments that make no thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadMillingFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// A radius of the thread is not above 0, a pass leaves less than nothing, or a number of a countersink is out of
    /// range.
    Number,
    /// The pitch is not above 0, or a strip has no teeth.
    Pitch,
    /// The core is not smaller than the nominal radius.
    Depth,
    /// The cutter does not fit into the core.
    Cutter,
    /// A way to the thread has no length.
    Way,
    /// A hole that belongs to the thread.
    Hole(DrillingFault),
    /// There is no pass, or there are more than [`MOST`] passes or turns.
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

/// A helix along the tool axis: heights are coordinates along it, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    /// Where the path to it begins.
    pub start: f64,
    /// Where the thread begins.
    pub first: f64,
    /// Where the thread ends.
    pub last: f64,
    /// Where the path from it ends.
    pub end: f64,
    /// Whole turns from `first` to `last`.
    pub turns: u32,
}

impl Ways {
    /// Half of `pitch`, in mm, on each of both, none of it beyond the depth, and the path to the thread at `feed`.
    pub fn of_half_a_pitch(pitch: f64, feed: Feed) -> Ways {
        Ways { beside: None, onto: feed, along: [pitch / 2.0; 2], beyond: false, positioning: None }
    }
}

impl ThreadMilling {
    /// 1 where the tool travels along the tool axis as it counts, -1 against it.
    fn along(&self) -> f64 {
        if self.counter_clockwise == self.left_hand { -1.0 } else { 1.0 }
    }

    /// Radius of the path of the centre in mm, by what the pass leaves.
    pub fn radius(&self, rest: f64) -> f64 {
        match self.side {
            Side::Internal => self.nominal - self.mill.radius - rest,
            Side::External => self.core + self.mill.radius + rest,
        }
    }

    /// Where the tool goes up and down: in the middle, or beside the thread on its first axis.
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

    /// The helices in the order in which they are cut: more than one where the edge has fewer teeth than the thread
    /// turns.
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
