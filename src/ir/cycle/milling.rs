//! What all milling cycles share: plane, heights, cutter, feeds, and the places where a shape is milled.

use core::fmt;

use crate::geo::{self, Deg, Plane, Point2, angle};
use crate::ir::{Feed, Pos};
use crate::machine::Axis;

/// Most levels of a cycle; more is a lost decimal point.
pub const MOST_LEVELS: usize = 10_000;

/// Into how many equal parts of at most `most` mm a length of `way` mm is divided: one at least, one where `most` is 0.
pub fn parts(way: f64, most: f64) -> usize {
    if most > 0.0 && way > most { geo::parts::count(way, most).clamp(1.0, 1e9) as usize } else { 1 }
}

/// What every milling cycle takes. Lengths are in mm, heights are coordinates along the tool axis in the programmed
/// frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mill {
    /// The plane of the shape; its third axis is the tool axis.
    pub plane: Plane,
    /// Heights of the tool, and how the depth is divided into levels.
    pub heights: Heights,
    /// Radius of the cutter in mm, above 0.
    pub radius: f64,
    /// Both are above 0; a cycle for finishing may have a feed of its own beside them.
    pub feeds: Feeds,
}

/// Feeds of a milling cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feeds {
    /// Of cuts in the plane.
    pub plane: Feed,
    /// Of infeeds along the tool axis into the material.
    pub depth: Feed,
}

/// Heights along the tool axis, in mm, and how the depth is divided. Heights are coordinates in the programmed frame;
/// `retract` and `depth` lie on the two sides of `reference`, and either of them may be the greater coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heights {
    /// Retract height: here the tool travels between places and stands in the end. Not below [`Heights::safe`].
    pub retract: f64,
    /// Surface of the workpiece, from which depths and infeeds count.
    pub reference: f64,
    /// Safety distance above the surface, mm, 0 or more: rapid traverse ends there.
    pub clearance: f64,
    /// The finished floor.
    pub depth: f64,
    /// Greatest infeed in depth, mm; 0 for one level.
    pub step: f64,
    /// How the depth becomes infeeds of at most `step`.
    pub division: Division,
    /// Allowance on the floor that roughing leaves, mm; 0 or more, and less than the depth.
    pub allowance: f64,
}

/// How a depth is divided into levels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Division {
    /// Equal infeeds of at most the greatest one.
    #[default]
    Even,
    /// Whole infeeds, and the rest at last.
    Whole,
}

/// Where a shape lies in the plane: its own origin, and its own first axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Origin of the shape, in coordinates of the plane, mm.
    pub at: Point2,
    /// From the first axis of the plane to that of the shape, counter-clockwise positive.
    pub turn: Deg,
}

/// Arguments that make no milling cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MillFault {
    /// A height is no finite number, or the clearance, the infeed or the allowance is below 0.
    Number,
    /// Retract height and depth do not lie on the two sides of the surface, or all three are one.
    ReferencePlane,
    /// The retract height lies below the surface plus the safety distance.
    RetractBelowStart,
    /// The allowance on the floor is as large as the depth.
    FloorAllowance,
    /// The radius of the cutter is not above 0.
    Radius,
    /// A feed is not above 0.
    Feed,
    /// The infeed asks for more than [`MOST_LEVELS`] levels.
    TooManyLevels,
}

impl fmt::Display for MillFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MillFault::Number => "a height is not a number, or an allowance, clearance or infeed is below 0",
            MillFault::ReferencePlane => "the surface must lie between the retract height and the depth",
            MillFault::RetractBelowStart => "the retract height lies below the surface plus the safety distance",
            MillFault::FloorAllowance => "the allowance on the floor is not smaller than the depth",
            MillFault::Radius => "the radius of the cutter must be over 0",
            MillFault::Feed => "the feed must be over 0",
            MillFault::TooManyLevels => "the infeed in depth is so small that the levels do not end",
        })
    }
}

impl Mill {
    /// # Errors
    /// The first fault.
    pub fn check(&self) -> Result<(), MillFault> {
        self.heights.check()?;
        let positive = |v: f64| v > 0.0 && v.is_finite();
        if !positive(self.radius) {
            Err(MillFault::Radius)
        } else if !positive(self.feeds.plane.value()) || !positive(self.feeds.depth.value()) {
            Err(MillFault::Feed)
        } else {
            Ok(())
        }
    }

    /// The tool axis.
    pub fn axis(&self) -> Axis {
        Axis::ALL[self.plane.axes().2]
    }

    /// The tool stands at the retract height above `end`, a point of the plane in the programmed frame.
    pub fn leaves_above(&self, end: Point2, at: &mut Pos) {
        at.set_in_plane(self.plane, end);
        at.set(self.axis(), self.heights.retract);
    }
}

/// Heights that differ by less are one height, computed in two ways.
const ROUNDED: f64 = 1e-9;

impl Heights {
    /// # Errors
    /// The first fault.
    pub fn check(&self) -> Result<(), MillFault> {
        let numbers = [self.retract, self.reference, self.clearance, self.depth, self.step, self.allowance];
        let unsigned = [self.clearance, self.step, self.allowance];
        let out = self.outward();
        if !numbers.iter().all(|v| v.is_finite()) || unsigned.iter().any(|v| *v < 0.0) {
            Err(MillFault::Number)
        } else if out == 0.0 || (self.reference - self.depth) * out < 0.0 {
            Err(MillFault::ReferencePlane)
        } else if (self.retract - self.safe()) * out < -ROUNDED {
            Err(MillFault::RetractBelowStart)
        } else if self.allowance > 0.0 && self.allowance >= self.way() {
            Err(MillFault::FloorAllowance)
        } else if parts(self.way(), self.step) > MOST_LEVELS {
            Err(MillFault::TooManyLevels)
        } else {
            Ok(())
        }
    }

    /// Direction out of the material along the tool axis, 1 or -1; 0 where all heights are one.
    pub fn outward(&self) -> f64 {
        let way =
            if self.retract == self.reference { self.reference - self.depth } else { self.retract - self.reference };
        if way == 0.0 { 0.0 } else { way.signum() }
    }

    /// Height at which rapid traverse ends: the safety distance above the surface.
    pub fn safe(&self) -> f64 {
        self.above(self.reference)
    }

    /// The safety distance above `height`.
    pub fn above(&self, height: f64) -> f64 {
        height + self.clearance * self.outward()
    }

    /// The safety distance above ground that is cleared down to `height`, but no higher than above the surface.
    pub fn above_cleared(&self, height: f64) -> f64 {
        let (made, safe) = (self.above(height), self.safe());
        if (made - safe) * self.outward() > 0.0 { safe } else { made }
    }

    /// Depth of the floor below the surface, mm, 0 or more.
    pub fn way(&self) -> f64 {
        (self.reference - self.depth).abs()
    }

    /// Height of the floor that roughing leaves: the allowance above the depth.
    pub fn rough_floor(&self) -> f64 {
        self.depth + self.allowance * self.outward()
    }

    /// Heights of the levels from the surface down to what roughing leaves on the floor, which is the last one.
    pub fn levels(&self) -> Vec<f64> {
        self.levels_to(self.rough_floor(), self.step)
    }

    /// Heights of levels with infeeds of at most `step` mm from the surface down to `floor`, which is the last one.
    pub fn levels_to(&self, floor: f64, step: f64) -> Vec<f64> {
        let way = self.reference - floor;
        let count = parts(way.abs(), step).min(MOST_LEVELS);
        let infeed = match self.division {
            Division::Even => way / count as f64,
            Division::Whole => step * way.signum(),
        };
        (1..=count).map(|k| if k == count { floor } else { self.reference - infeed * k as f64 }).collect()
    }
}

impl Place {
    /// The shape is given in the coordinates of the plane.
    pub const HERE: Place = Place { at: Point2::new(0.0, 0.0), turn: Deg(0.0) };

    /// A point of the shape, in coordinates of the plane.
    pub fn point(&self, p: Point2) -> Point2 {
        angle::rotated(Point2::new(self.at.x + p.x, self.at.y + p.y), self.at, self.turn)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heights(depth: f64, step: f64, allowance: f64) -> Heights {
        let division = Division::Even;
        Heights { retract: 10.0, reference: 0.0, clearance: 2.0, depth, step, division, allowance }
    }

    #[test]
    fn levels_are_equal_and_end_on_the_floor() {
        let made = heights(-17.5, 4.0, 0.2).levels();
        let wanted = [-3.46, -6.92, -10.38, -13.84, -17.3];
        assert!(made.len() == 5 && made.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9), "{made:?}");
        let whole = Heights { division: Division::Whole, ..heights(-17.5, 4.0, 0.2) };
        assert_eq!(whole.levels(), [-4.0, -8.0, -12.0, -16.0, -17.3]);
        assert_eq!(heights(-12.0, 4.0, 0.0).levels(), [-4.0, -8.0, -12.0]);
        assert_eq!(heights(-12.000_000_9, 4.0, 0.0).levels().len(), 3);
        assert_eq!(heights(-12.0, 0.0, 0.0).levels(), [-12.0]);
    }

    #[test]
    fn a_depth_may_lie_above_the_surface_where_the_tool_works_upwards() {
        let up = Heights { retract: -10.0, ..heights(9.0, 3.0, 0.0) };
        assert_eq!((up.check(), up.safe(), up.levels()), (Ok(()), -2.0, vec![3.0, 6.0, 9.0]));
    }

    #[test]
    fn heights_that_make_no_cycle_are_named() {
        assert_eq!(heights(1.0, 4.0, 0.0).check(), Err(MillFault::ReferencePlane));
        assert_eq!(heights(-1.0, 4.0, 1.0).check(), Err(MillFault::FloorAllowance));
        assert_eq!(heights(-1.0, 1e-7, 0.0).check(), Err(MillFault::TooManyLevels));
        assert_eq!(heights(f64::NAN, 1.0, 0.0).check(), Err(MillFault::Number));
        let low = Heights { retract: 1.0, ..heights(-1.0, 1.0, 0.0) };
        assert_eq!(low.check(), Err(MillFault::RetractBelowStart));
    }
}
