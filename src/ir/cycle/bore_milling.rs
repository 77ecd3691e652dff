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

/// A hole that is milled on a helix.
#[derive(Debug, Clone, PartialEq)]
pub struct BoreMilling {
    pub mill: Mill,
    /// Its middle.
    pub place: Place,
    /// Radii of the circles of the centre, from inside out; none where the cutter has the size of the hole.
    pub circles: Vec<f64>,
    /// Way down in a whole turn.
    pub pitch: f64,
    pub counter_clockwise: bool,
    /// Where the helix begins: at the safety distance, or lower.
    pub from: f64,
    /// Straight to the wall and back, in place of semicircles.
    pub straight: bool,
}

/// Arguments that make no hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoreMillingFault {
    Mill(MillFault),
    Number,
    Pitch,
    /// The helix begins above the safety distance, or not above the depth.
    Start,
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
    pub whole: u32,
    /// Part of a turn behind them, 0 to below 1.
    pub rest: f64,
}

impl BoreMilling {
    /// The turns of the helix on a circle.
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
