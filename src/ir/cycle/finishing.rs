//! Arguments of finishing: one cut along a contour, and the ways to it and from it.

use crate::geo::tolerance;
use core::fmt;

use crate::geo::offset::{self, NoParallel, OffsetElement};
use crate::geo::{Element, Plane, Point2, Vec2, clearance};
use crate::ir::{Feed, Pos};

use super::Family;
use super::recess::{is_element, joined};
use super::roughing::Nose;
use super::turning::{Towards, is_coordinate, is_point, is_positive};

/// Most elements of a contour.
pub const MOST_ELEMENTS: usize = 500;

/// Finishing along a contour. Points are (Z, X) with X as a radius; all lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Finishing {
    /// In the order of cutting.
    pub contour: Vec<Element>,
    /// The whole finished contour around it, in its own order: the paths to the contour and from it keep clear of all
    /// that. Empty where nothing else is known; then they keep clear of `contour`.
    pub around: Vec<Element>,
    /// The tool is left of `around`, seen in its order.
    pub around_left: bool,
    /// Infeed direction: what goes this way is a descending element.
    pub into: Towards,
    /// The tool is left of `contour`, seen in the order of cutting.
    pub left: bool,
    /// The nose that runs along the contour; its programmed point is what is sent.
    pub nose: Nose,
    /// Allowance on the contour, at right angles to it; a negative one goes deeper, by the nose radius at most.
    pub oversize: f64,
    /// Moves the whole contour, along Z and X (radius).
    pub shift: Vec2,
    /// Away from the part at both ends, -1, 0 or 1 along Z and X. Where that is not free, another quadrant is taken.
    pub away: Vec2,
    /// Along each axis from the contour to where the tool comes down to it and lifts off it, over 0.
    pub clearance: f64,
    /// Lower and upper corner of the blank from which nothing was cut yet: the approach does not pass through it.
    pub blank: Option<(Point2, Point2)>,
    /// Of the cut, of the last part of the approach and of the lift-off; over 0.
    pub feed: Feed,
    /// What becomes of elements that descend into the material.
    pub descending: Descending,
    /// Whether arcs have a feed limit of their own.
    pub arcs: ArcFeed,
    /// Where the tool stands after the cut.
    pub end: FinishingEnd,
}

impl Finishing {
    /// From where the part is cut, by the side on which the tool travels; `None` for an upright contour, which has none.
    pub fn cut_from(&self) -> Option<Towards> {
        let way = self.contour.last()?.to().x - self.contour.first()?.from().x;
        let outside = if (way < 0.0) == self.left { Towards::PlusX } else { Towards::MinusX };
        (way.abs() > crate::geo::SAME_POINT).then_some(outside)
    }
}

/// What becomes of descending elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Descending {
    /// They are cut at `feed`, over 0.
    Cut { feed: Feed },
    /// They are left out: the cut goes on level until the contour rises again.
    Left,
}

/// Feed on arcs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ArcFeed {
    /// That of lines.
    Same,
    /// So low that the spindle turns `turns` times on an arc at least. `speed`: revolutions per minute, for a feed per
    /// minute; without it such a feed stays as it is.
    Turns { turns: f64, speed: Option<f64> },
}

/// Where the tool stands afterwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FinishingEnd {
    /// At the end of the contour.
    Stay,
    /// Lifted off it.
    Lift,
    /// Lifted off, then at `to`, (Z, X) with X as a radius, which is reached as `way` says.
    Point { to: Point2, way: Way },
    /// Lifted off, then back where it came from, as `way` says.
    Start { way: Way },
}

/// How a point is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Way {
    /// Straight, at rapid traverse.
    Diagonal,
    /// First along X, then along Z, at rapid traverse.
    XThenZ,
    /// First along Z, then along X, at rapid traverse.
    ZThenX,
    /// Straight, at the feed of the cut.
    AtFeed,
}

/// An argument that describes no finishing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FinishingFault {
    /// No contour element, or more than [`MOST_ELEMENTS`].
    Elements,
    /// A coordinate of the contour, of what is around it, or of the end point is no number.
    Point,
    /// Neighbouring elements do not meet.
    Gap,
    /// The nose radius is negative, or its programmed point does not lie on the nose.
    Nose,
    /// A negative allowance exceeds the nose radius, or it or the shift is no number.
    Oversize,
    /// The direction away from the part is none of the eight.
    Away,
    /// The clearance is not over 0.
    Clearance,
    /// A feed is not over 0.
    Feed,
}

impl fmt::Display for FinishingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            FinishingFault::Elements => "the contour has 1 to 500 elements",
            FinishingFault::Point => "a point is not a number",
            FinishingFault::Gap => "an element of the contour does not start where the one before ends",
            FinishingFault::Nose => "the nose radius must not be negative",
            FinishingFault::Oversize => "a negative oversize must not be larger than the nose radius",
            FinishingFault::Away => "it is not known on which side of the contour the tool is",
            FinishingFault::Clearance => "the clearance must be over 0",
            FinishingFault::Feed => "a feed must be over 0",
        })
    }
}

impl Family for Finishing {
    type Fault = FinishingFault;

    fn check(&self) -> Result<(), FinishingFault> {
        let sign = |v: f64| v == -1.0 || v == 0.0 || v == 1.0;
        let descending = match self.descending {
            Descending::Cut { feed } => is_positive(feed.value()),
            Descending::Left => true,
        };
        let target = match self.end {
            FinishingEnd::Point { to, .. } => is_point(to),
            FinishingEnd::Stay | FinishingEnd::Lift | FinishingEnd::Start { .. } => true,
        };
        let nose = self.nose.radius >= 0.0
            && is_coordinate(self.nose.radius)
            && sign(self.nose.tip.x)
            && sign(self.nose.tip.y);
        let rules = [
            ((1..=MOST_ELEMENTS).contains(&self.contour.len()), FinishingFault::Elements),
            (self.contour.iter().chain(&self.around).all(is_element) && target, FinishingFault::Point),
            (joined(&self.contour), FinishingFault::Gap),
            (nose, FinishingFault::Nose),
            (is_coordinate(self.oversize) && self.distance() >= 0.0, FinishingFault::Oversize),
            (is_coordinate(self.shift.x) && is_coordinate(self.shift.y), FinishingFault::Oversize),
            (sign(self.away.x) && sign(self.away.y) && self.away != Vec2::zeros(), FinishingFault::Away),
            (is_positive(self.clearance), FinishingFault::Clearance),
            (is_positive(self.feed.value()) && descending, FinishingFault::Feed),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn leaves(&self, at: &mut Pos) {
        let end = || {
            let path = self.path(&self.contour).ok()?;
            let last = path.last()?.element.to();
            if self.end == FinishingEnd::Stay { Some(last) } else { self.beside(last) }
        };
        match self.end {
            FinishingEnd::Start { .. } => {}
            FinishingEnd::Point { to, .. } => at.set_in_plane(Plane::Zx, to),
            FinishingEnd::Stay | FinishingEnd::Lift => {
                match end().filter(|_| self.descending != Descending::Left) {
                    Some(p) => at.set_in_plane(Plane::Zx, p),
                    // It depends on what is left out.
                    None => {
                        let (infeed, cutting) = self.into.axes();
                        at.forget(infeed);
                        at.forget(cutting);
                    }
                }
            }
        }
    }
}

impl Finishing {
    /// From the contour to the centre of the nose.
    fn distance(&self) -> f64 {
        self.nose.radius + self.oversize
    }

    /// The path of the programmed point along `contour`, shift, allowance and nose included, in the order of cutting.
    pub fn path(&self, contour: &[Element]) -> Result<Vec<OffsetElement>, NoParallel> {
        let contour = offset::shifted(contour, self.shift);
        let side = if self.left { 1.0 } else { -1.0 };
        let mut parts = offset::parallel(&contour, side * self.distance())?;
        let tip = self.nose.tip * self.nose.radius;
        for part in &mut parts {
            if let [element] = offset::shifted(&[part.element], tip)[..] {
                part.element = element;
            }
        }
        Ok(parts)
    }

    /// What the ways to the contour and from it keep clear of.
    fn obstacles(&self) -> (Vec<Element>, bool) {
        let (list, left) =
            if self.around.is_empty() { (&self.contour, self.left) } else { (&self.around, self.around_left) };
        (offset::shifted(list, self.shift), left)
    }

    /// Least distance in mm of the nose from the finished contour while the programmed point goes straight `from` one
    /// point `to` another; below 0 where the nose would cut into it.
    pub fn clear(&self, from: Point2, to: Point2) -> f64 {
        let center = -self.nose.tip * self.nose.radius;
        let leg = Element::Line { from: from + center, to: to + center };
        let (obstacles, _) = self.obstacles();
        let near = |least: f64, element: &Element| least.min(clearance::between(&leg, element));
        obstacles.iter().fold(f64::INFINITY, near) - self.nose.radius
    }

    /// Does a straight path of the programmed point lead through the blank? Along its outline is not through it.
    pub fn through_blank(&self, from: Point2, to: Point2) -> bool {
        let Some((low, high)) = self.blank else { return false };
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        let way = to - from;
        for (at, way, low, high) in [(from.x, way.x, low.x, high.x), (from.y, way.y, low.y, high.y)] {
            let (low, high) = (low + tolerance::SAME, high - tolerance::SAME);
            if way.abs() <= f64::EPSILON {
                if at <= low || at >= high {
                    return false;
                }
                continue;
            }
            let (a, b) = ((low - at) / way, (high - at) / way);
            first = first.max(a.min(b));
            last = last.min(a.max(b));
        }
        first < last
    }

    /// Does the nose stand on the free side of the finished contour?
    fn is_outside(&self, p: Point2) -> bool {
        let p = p - self.nose.tip * self.nose.radius;
        let (obstacles, left) = self.obstacles();
        let least = obstacles.iter().map(|element| clearance::point_to(p, element)).fold(f64::INFINITY, f64::min);
        let mut nearest = obstacles.iter().filter(|element| clearance::point_to(p, element) <= least + tolerance::SAME);
        nearest.all(|element| {
            let side = clearance::side_of(p, element);
            if left { side > -tolerance::SAME } else { side < tolerance::SAME }
        })
    }

    /// A place clear of the contour, next to the start or end `p` of the path; `None` if there is none.
    pub fn beside(&self, p: Point2) -> Option<Point2> {
        let away = self.away;
        let ways = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 0.0)];
        let ways = ways.map(|(z, x)| Vec2::new(away.x * z, away.y * x));
        ways.into_iter().filter(|way| *way != Vec2::zeros()).find_map(|way| {
            let mut to = p + way * self.clearance;
            if p.y >= 0.0 {
                // Not beyond the turning centre.
                to.y = to.y.max(0.0);
            }
            // Straight away from `p`: on the whole way as far as it has come.
            let free = |t: f64| {
                let at = p + (to - p) * t;
                self.clear(at, at) >= self.clearance * t + self.oversize.min(0.0) - tolerance::SAME
            };
            let way_is_free = [1.0, 0.5, 0.25, 0.125].into_iter().all(free);
            let keeps_off = self.clear(p, to) >= self.oversize - offset::NEARER;
            (way_is_free && keeps_off && self.is_outside(to)).then_some(to)
        })
    }
}
