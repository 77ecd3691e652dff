//! Arguments of pockets with outlines of lines and arcs, and islands in them.

use core::fmt;

use crate::geo::element::quarters;
use crate::geo::{Element, Point2, grid};
use crate::ir::{Feed, Pos};

use super::Family;
use super::milling::{Heights, Mill, MillFault, parts};
use super::pocket::{Finish, Insertion, MOST_RINGS};

/// Largest radius of an arc of a contour, mm; more is a line, or a lost decimal point.
const LARGEST_ARC: f64 = 10_000.0;

/// Pockets along contours. Lengths in mm, contours in coordinates of the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Plane, heights, cutter and feeds.
    pub mill: Mill,
    /// Of each pocket: closed, each element from where the one before ends, in either sense; apart from each other and not in one
    /// another. They are milled one after the other.
    pub outlines: Vec<Vec<Element>>,
    /// Closed, inside the outlines and apart from each other.
    pub islands: Vec<Vec<Element>>,
    /// Sense in which the tool goes round along the outlines, seen against the plane normal; around islands it is the
    /// other one.
    pub counter_clockwise: bool,
    /// Allowance on the walls that roughing leaves, 0 or more.
    pub allowance: f64,
    /// Allowance on the walls that finishing leaves, 0 or more.
    pub left: f64,
    /// Is the pocket roughed already, down to the allowance on its floor? Else finishing goes down to its floor at the
    /// feed.
    pub cleared: bool,
    /// Greatest width of a cut; above 0, at most the diameter of the cutter.
    pub width: f64,
    /// How the tool gets to a level; never [`Insertion::Strokes`].
    pub insertion: Insertion,
    /// Feed of the insertion, above 0; the feed for the depth without one.
    pub insertion_feed: Option<Feed>,
    /// The cutter that roughed before: only what it left is roughed. `None` where all is solid.
    pub coarse: Option<Box<Coarse>>,
    /// Where the tool is to be inserted; `None` leaves the place to the cycle.
    pub start: Option<Point2>,
    /// The pockets are roughed down to the allowances. Without it `finish` is given.
    pub rough: bool,
    /// The finishing cuts after roughing; `None` for none.
    pub finish: Option<Finish>,
    /// From one insertion to the next over the retract height, not over the safety distance.
    pub lifts_high: bool,
}

/// What a coarser cutter roughed down to the same floor. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Coarse {
    /// Radius of that cutter, above the one of the cutter after it.
    pub radius: f64,
    /// What it left on the walls.
    pub allowance: f64,
    /// As those of the pockets, with the inside corners that it left.
    pub outlines: Vec<Vec<Element>>,
    /// As the islands of the pockets.
    pub islands: Vec<Vec<Element>>,
}

/// Arguments that make no pocket.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RegionFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// An allowance, an infeed or a point is out of range, or the cutter before is not larger.
    Number,
    /// The width of a cut is not above 0, or larger than the cutter.
    Width,
    /// The pitch of the helix or a feed is not above 0, the angle not below 90 degrees, or the pocket is no slot.
    Insertion,
    /// The helix falls by so little that its turns do not end.
    Pitch,
    /// The outlines are so large that a level may have more than [`MOST_RINGS`] rings.
    TooManyRings,
    /// An arc has a radius above [`LARGEST_ARC`].
    LargeArc,
    /// Nothing is asked for, or there is no outline.
    Nothing,
}

impl fmt::Display for RegionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RegionFault::Mill(fault) => return fault.fmt(f),
            RegionFault::Number => "a number of the pocket or its contour cannot be used",
            RegionFault::Width => "the infeed in the plane is above 0, and at most the diameter of the cutter",
            RegionFault::Insertion => "the pitch of the helix is above 0, and the angle below 90 degrees",
            RegionFault::Pitch => "the pitch of the helix is so small that its turns do not end",
            RegionFault::TooManyRings => "the infeed in the plane is so small that the rings do not end",
            RegionFault::LargeArc => "an arc of the contour has a radius of more than 10 m",
            RegionFault::Nothing => "neither roughing nor finishing is asked for, or there is no outline",
        })
    }
}

/// 0 for a line.
fn radius_of(element: &Element) -> f64 {
    match *element {
        Element::Line { .. } => 0.0,
        Element::Arc { from, center, .. } => crate::geo::distance(from, center),
    }
}

impl Region {
    /// The elements of outlines and islands, contour by contour.
    pub fn walls(&self) -> impl Iterator<Item = &Element> {
        self.outlines.iter().chain(&self.islands).flatten()
    }

    fn size(&self) -> f64 {
        size(&self.outlines)
    }

    /// The same with its sizes rounded to the grid of contours, on which outlines and islands lie already.
    #[must_use]
    pub fn on_grid(&self) -> Region {
        let on = grid::on_grid;
        let heights = &self.mill.heights;
        let heights = Heights {
            retract: on(heights.retract),
            reference: on(heights.reference),
            clearance: on(heights.clearance),
            depth: on(heights.depth),
            step: on(heights.step),
            allowance: on(heights.allowance),
            ..*heights
        };
        let finish = self.finish.map(|finish| Finish { step: on(finish.step), ..finish });
        Region {
            mill: Mill { heights, radius: on(self.mill.radius), ..self.mill },
            allowance: on(self.allowance),
            left: on(self.left),
            width: on(self.width),
            start: self.start.map(grid::point),
            finish,
            ..self.clone()
        }
    }
}

/// The larger side of what closed outlines take up.
fn size(outlines: &[Vec<Element>]) -> f64 {
    let points = outlines.iter().flatten().flat_map(quarters).map(|piece| piece.from());
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points {
        low = [low[0].min(p.x), low[1].min(p.y)];
        high = [high[0].max(p.x), high[1].max(p.y)];
    }
    (high[0] - low[0]).max(high[1] - low[1]).max(0.0)
}

impl Family for Region {
    type Fault = RegionFault;

    fn check(&self) -> Result<(), RegionFault> {
        self.mill.check().map_err(RegionFault::Mill)?;
        let usable = |v: f64| v.is_finite() && v >= 0.0;
        let insertion = match self.insertion {
            Insertion::Predrilled | Insertion::Vertical => true,
            Insertion::Helix { radius, pitch } => usable(radius) && pitch > 0.0 && pitch.is_finite(),
            Insertion::Ramp { angle, .. } => (0.0..90.0).contains(&angle.0),
            Insertion::Strokes { .. } => false,
        };
        let finish = self.finish.is_none_or(|finish| usable(finish.step) && finish.feed.value() > 0.0);
        let points = self.walls().flat_map(|element| [element.from(), element.to()]).chain(self.start);
        let finite = points.into_iter().all(|p| p.x.is_finite() && p.y.is_finite());
        let rules = [
            (usable(self.allowance) && usable(self.left) && finite && finish, RegionFault::Number),
            (self.width > 0.0 && self.width <= 2.0 * self.mill.radius + 1e-9, RegionFault::Width),
            (self.walls().all(|element| radius_of(element) <= LARGEST_ARC), RegionFault::LargeArc),
            (self.size() / self.width <= MOST_RINGS, RegionFault::TooManyRings),
            (insertion && self.insertion_feed.is_none_or(|feed| feed.value() > 0.0), RegionFault::Insertion),
            (self.coarse.as_ref().is_none_or(|coarse| coarse.radius > self.mill.radius), RegionFault::Number),
            (self.insertion.ends(&self.mill), RegionFault::Pitch),
            (self.rough || self.finish.is_some_and(|finish| finish.wall || finish.floor), RegionFault::Nothing),
            (!self.outlines.is_empty(), RegionFault::Nothing),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn moves(&self) -> f64 {
        let heights = &self.mill.heights;
        let most = self.width.min(self.mill.radius);
        let rings = self.size() / 2.0 / most + 1.0;
        let levels = parts(heights.way(), heights.step) as f64;
        rings * levels * (self.walls().count() + 4) as f64
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_circle_is_as_large_as_its_diameter() {
        let at = Point2::new(4.0, 1.0);
        let circle = Element::Arc { from: at, to: at, center: Point2::new(1.0, 1.0), sweep: core::f64::consts::TAU };
        assert!((size(&[vec![circle]]) - 6.0).abs() < 1e-12);
        assert_eq!(size(&[]), 0.0);
    }
}
