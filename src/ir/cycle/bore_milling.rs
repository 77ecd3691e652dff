//! Arguments of bore milling: on a helix to the depth, a full circle there, back to the middle.

use core::fmt;

use crate::geo::Point2;
use crate::ir::Pos;

use super::Family;
use super::milling::{Mill, MillFault, Place};

/// Most turns of a helix; more is a lost decimal point.
const MOST: f64 = 10_000.0;
/// A rest of a turn whose chord is shorter is none, mm: what is printed would not tell it from a full circle.
const SHORTEST: f64 = 1e-3;

/// A hole that is milled on a helix. All lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct BoreMilling {
    /// Its depth is the bottom of the hole; `step`, `division` and `allowance` of its heights play no part.
    pub mill: Mill,
    /// The middle of the hole. Semicircles and lines to a circle run along its first axis.
    pub place: Place,
    /// Radii of the circles of the cutter's centre, from inside out, each above 0; none where the cutter has the size
    /// of the hole and plunges in its middle.
    pub circles: Vec<f64>,
    /// Infeed of the helix in a whole turn, above 0.
    pub pitch: f64,
    /// Sense in which the tool goes round, seen against the plane normal.
    pub counter_clockwise: bool,
    /// Height where the helix begins: at the safety distance, or lower, and above the depth.
    pub from: f64,
    /// From the middle to a circle and back on straight lines, in place of semicircles.
    pub straight: bool,
}

/// Arguments that make no hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoreMillingFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// The radius of a circle is not above 0.
    Number,
    /// The infeed of a turn is not above 0.
    Pitch,
    /// The helix begins above the safety distance, or not above the depth.
    Start,
    /// The helix has more than [`MOST`] turns, or there are more circles than that.
    TooMany,
}

impl fmt::Display for BoreMillingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BoreMillingFault::Mill(fault) => return fault.fmt(f),
            BoreMillingFault::Number => "a radius of the path is not above 0",
            BoreMillingFault::Pitch => "the infeed of a turn is not above 0",
            BoreMillingFault::Start => "the helix has to begin between the safety distance and the depth",
            BoreMillingFault::TooMany => "the infeed is so small that the turns do not end",
        })
    }
}

/// Turns of a helix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turns {
    /// Complete turns.
    pub whole: u32,
    /// Part of a turn after them, 0 to below 1.
    pub rest: f64,
}

impl BoreMilling {
    /// The turns of the helix on a circle of `radius` mm, from its start down to the depth. A rest whose chord is below
    /// [`SHORTEST`] counts as none, or as one whole turn.
    pub fn turns(&self, radius: f64) -> Turns {
        let turns = (self.from - self.mill.heights.depth).abs() / self.pitch;
        let whole = libm::floor(turns);
        let rest = turns - whole;
        let chord = 2.0 * radius * libm::sin(core::f64::consts::PI * rest);
        match chord < SHORTEST {
            true if rest > 0.5 => Turns { whole: whole as u32 + 1, rest: 0.0 },
            true => Turns { whole: whole as u32, rest: 0.0 },
            false => Turns { whole: whole as u32, rest },
        }
    }
}

impl Family for BoreMilling {
    type Fault = BoreMillingFault;

    fn check(&self) -> Result<(), BoreMillingFault> {
        self.mill.check().map_err(BoreMillingFault::Mill)?;
        let heights = &self.mill.heights;
        let positive = |v: f64| v > 0.0 && v.is_finite();
        let (above, below) = (heights.safe() - self.from, self.from - heights.depth);
        if !self.circles.iter().all(|radius| positive(*radius)) {
            Err(BoreMillingFault::Number)
        } else if !positive(self.pitch) {
            Err(BoreMillingFault::Pitch)
        } else if above * heights.outward() < 0.0 || below * heights.outward() <= 0.0 {
            Err(BoreMillingFault::Start)
        } else if below.abs() / self.pitch > MOST || self.circles.len() as f64 > MOST {
            Err(BoreMillingFault::TooMany)
        } else {
            Ok(())
        }
    }

    fn moves(&self) -> f64 {
        5.0 * self.circles.len() as f64
    }

    /// Above its middle.
    fn leaves(&self, at: &mut Pos) {
        self.mill.leaves_above(self.place.point(Point2::origin()), at);
    }
}
