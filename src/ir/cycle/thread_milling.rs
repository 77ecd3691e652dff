//! Arguments of thread milling: helices of one pitch, with a semicircle to them and from them.

use core::fmt;

use crate::geo::Point2;
use crate::ir::Pos;

use super::Family;
use super::milling::{Mill, MillFault, Place};

/// Most turns or passes; more is a lost decimal point.
const MOST: f64 = 10_000.0;
/// What arithmetic may add to a quotient without one more turn.
const WHOLE: f64 = 1e-9;

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
    /// Teeth of an edge: so many turns are cut at once.
    pub teeth: u32,
    /// What each pass leaves of the depth of the thread, from the first one on.
    pub rests: Vec<f64>,
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
            ThreadMillingFault::TooMany => "the thread has so many turns or passes that they do not end",
        })
    }
}

/// A helix along the tool axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    /// Where the way to it begins.
    pub start: f64,
    /// Signed way of half a pitch.
    pub half: f64,
    pub turns: u32,
}

impl Helix {
    /// Where the way from it ends.
    pub fn end(&self) -> f64 {
        self.start + 2.0 * self.half * (f64::from(self.turns) + 1.0)
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
        let whole = |v: f64| libm::ceil(v - WHOLE).max(1.0);
        let strip = self.pitch * f64::from(self.teeth);
        let (count, turns) = if self.teeth == 1 {
            (1.0, whole(heights.way() / self.pitch))
        } else {
            (whole(heights.way() / strip), 1.0)
        };
        let half = self.pitch / 2.0 * self.along();
        // The way along the axis ends or begins at the depth, never below it.
        let travel = 2.0 * half * (turns + 1.0);
        let outwards = travel * heights.outward() > 0.0;
        let lowest = |i: f64| heights.depth + i * strip * heights.outward();
        let start = |i: f64| if outwards { lowest(i) } else { lowest(i) - travel };
        let turns = turns as u32;
        let strips = count as u32;
        let order: Vec<u32> = if outwards { (0..strips).collect() } else { (0..strips).rev().collect() };
        order.into_iter().map(|i| Helix { start: start(f64::from(i)), half, turns }).collect()
    }
}

impl Family for ThreadMilling {
    type Fault = ThreadMillingFault;

    fn check(&self) -> Result<(), ThreadMillingFault> {
        self.mill.check().map_err(ThreadMillingFault::Mill)?;
        let positive = |v: f64| v > 0.0 && v.is_finite();
        if !positive(self.nominal) || !positive(self.core) || !self.rests.iter().all(|rest| *rest >= 0.0) {
            Err(ThreadMillingFault::Number)
        } else if !positive(self.pitch) || self.teeth == 0 {
            Err(ThreadMillingFault::Pitch)
        } else if self.core >= self.nominal {
            Err(ThreadMillingFault::Depth)
        } else if self.side == Side::Internal && self.mill.radius >= self.core {
            Err(ThreadMillingFault::Cutter)
        } else if self.mill.heights.way() / self.pitch > MOST || self.rests.is_empty() || self.rests.len() as f64 > MOST
        {
            Err(ThreadMillingFault::TooMany)
        } else {
            Ok(())
        }
    }

    fn moves(&self) -> f64 {
        4.0 * self.rests.len() as f64 * self.helices().len() as f64
    }

    /// Above where it came down.
    fn leaves(&self, at: &mut Pos) {
        self.mill.leaves_above(self.place.point(self.entry()), at);
    }
}
