//! Arguments of long holes: slots as wide as the cutter, milled to and fro.

use core::fmt;

use crate::geo::{Point2, distance};
use crate::ir::Pos;

use super::Family;
use super::milling::{Mill, MillFault};

/// Long holes, milled one after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct LongHole {
    /// Its levels are one stroke each; `feeds.depth` leads from level to level.
    pub mill: Mill,
    /// Both ends of the path of the cutter's centre, in coordinates of the plane, mm; one pair a hole, one hole at
    /// least.
    pub holes: Vec<[Point2; 2]>,
    /// Over this point of the plane the tool stands in the end; `None`: over the end of the last stroke.
    pub home: Option<Point2>,
}

/// Arguments that make no long hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LongHoleFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// An end is not a number, or there is no hole.
    Number,
}

impl fmt::Display for LongHoleFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LongHoleFault::Mill(fault) => fault.fmt(f),
            LongHoleFault::Number => f.write_str("there is no hole, or an end of one is not a number"),
        }
    }
}

impl LongHole {
    /// The holes in their order, each from its end that is nearer to where the tool comes from. `from` is where the
    /// tool stands; `None` takes the first hole as it is given.
    pub fn in_order(&self, from: Option<Point2>) -> Vec<[Point2; 2]> {
        // Every level is one way.
        let back = self.mill.heights.levels().len().is_multiple_of(2);
        let mut at = from;
        let mut nearer = |[a, b]: [Point2; 2]| {
            let turned = at.is_some_and(|at| distance(at, b) < distance(at, a));
            let hole = if turned { [b, a] } else { [a, b] };
            at = Some(hole[usize::from(!back)]);
            hole
        };
        self.holes.iter().map(|hole| nearer(*hole)).collect()
    }
}

impl Family for LongHole {
    type Fault = LongHoleFault;

    fn check(&self) -> Result<(), LongHoleFault> {
        self.mill.check().map_err(LongHoleFault::Mill)?;
        let finite = self.holes.iter().flatten().chain(&self.home).all(|p| p.x.is_finite() && p.y.is_finite());
        if self.holes.is_empty() || !finite { Err(LongHoleFault::Number) } else { Ok(()) }
    }

    fn moves(&self) -> f64 {
        (self.holes.len() * (2 * self.mill.heights.levels().len() + 4)) as f64
    }

    /// Above the end of the last way.
    fn leaves(&self, at: &mut Pos) {
        let back = self.mill.heights.levels().len().is_multiple_of(2);
        if let Some(hole) = self.in_order(at.in_plane(self.mill.plane)).last() {
            self.mill.leaves_above(self.home.unwrap_or(hole[usize::from(!back)]), at);
        }
    }
}
