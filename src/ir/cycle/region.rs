//! Arguments of pockets with an outline of lines and arcs, and islands in it.

use core::fmt;

use crate::geo::{Element, Point2};
use crate::ir::Pos;

use super::Family;
use super::milling::{Mill, MillFault};
use super::pocket::{Finish, Insertion, MOST_RINGS};

/// A pocket along a contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    pub mill: Mill,
    /// Closed, each element from where the one before ends; in either sense.
    pub outline: Vec<Element>,
    /// Closed, inside the outline and apart from each other.
    pub islands: Vec<Vec<Element>>,
    /// Sense in which the tool goes round along the outline; around islands it is the other one.
    pub counter_clockwise: bool,
    /// What roughing leaves on the walls.
    pub allowance: f64,
    /// Greatest width of a cut.
    pub width: f64,
    pub insertion: Insertion,
    /// Where the tool is inserted, if it can be.
    pub start: Option<Point2>,
    pub rough: bool,
    pub finish: Option<Finish>,
    /// From one insertion to the next over the retract height, not over the safety distance.
    pub lifts_high: bool,
}

/// Arguments that make no pocket.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RegionFault {
    Mill(MillFault),
    Number,
    Width,
    Insertion,
    TooManyRings,
    Nothing,
}

impl fmt::Display for RegionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RegionFault::Mill(fault) => return fault.fmt(f),
            RegionFault::Number => "a number of the pocket or its contour cannot be used",
            RegionFault::Width => "the infeed in the plane is above 0, and at most the diameter of the cutter",
            RegionFault::Insertion => "the pitch of the helix is above 0, and the angle below 90 degrees",
            RegionFault::TooManyRings => "the infeed in the plane is so small that the rings do not end",
            RegionFault::Nothing => "neither roughing nor finishing is asked for, or there is no outline",
        })
    }
}

impl Region {
    /// Outline and islands.
    pub fn walls(&self) -> impl Iterator<Item = &Element> {
        self.outline.iter().chain(self.islands.iter().flatten())
    }

    fn largest(&self) -> f64 {
        let size = |element: &Element| [element.from(), element.to()].map(|p| p.x.abs().max(p.y.abs()));
        self.outline.iter().flat_map(size).fold(0.0, f64::max)
    }
}

impl Family for Region {
    type Fault = RegionFault;

    fn check(&self) -> Result<(), RegionFault> {
        self.mill.check().map_err(RegionFault::Mill)?;
        let usable = |v: f64| v.is_finite() && v >= 0.0;
        let insertion = match self.insertion {
            Insertion::Predrilled | Insertion::Vertical => true,
            Insertion::Helix { radius, pitch } => usable(radius) && pitch > 0.0 && pitch.is_finite(),
            Insertion::Sway { angle, .. } => (0.0..90.0).contains(&angle.0),
        };
        let finish = self.finish.is_none_or(|finish| usable(finish.step) && finish.feed.value() > 0.0);
        let points = self.walls().flat_map(|element| [element.from(), element.to()]).chain(self.start);
        let finite = points.into_iter().all(|p| p.x.is_finite() && p.y.is_finite());
        let rules = [
            (usable(self.allowance) && finite && finish, RegionFault::Number),
            (self.width > 0.0 && self.width <= 2.0 * self.mill.radius + 1e-9, RegionFault::Width),
            (2.0 * self.largest() / self.width <= MOST_RINGS, RegionFault::TooManyRings),
            (insertion, RegionFault::Insertion),
            (self.rough || self.finish.is_some_and(|finish| finish.wall || finish.floor), RegionFault::Nothing),
            (!self.outline.is_empty(), RegionFault::Nothing),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    /// Above the last cut, which only its path knows.
    fn leaves(&self, at: &mut Pos) {
        self.mill.leaves_above(Point2::origin(), at);
        let (first, second, _) = self.mill.plane.axes();
        for axis in [first, second] {
            at.forget(crate::machine::Axis::ALL[axis]);
        }
    }
}
