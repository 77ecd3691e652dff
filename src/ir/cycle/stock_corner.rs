//! Stock removal from a corner of the stock: the tool stands in front of its cuts, and above them.

use crate::geo::element::quarters;
use crate::geo::profile::{Grown, Profile};
use crate::geo::{Element, Point2};
use crate::ir::{Feed, Pos};

use super::layers::{Allowance, Blank, Clearance, LayerFeeds, Layers, Limits, Relief, Segmentation, Trace};
use super::recess::Operation;
use super::roughing::{Corner, Nose};
use super::turning::Towards;

/// Shorter cuts may begin in front of the corner, mm.
const LEAST_CUT: f64 = 1e-3;

/// Sense of the cutting axis, 1 or -1, from a tool at `begin`, (Z, X) with X as a radius, to the contour; `None` where
/// it stands above it.
pub fn sense_of_cuts(contour: &[Element], into: Towards, begin: Point2) -> Option<f64> {
    let pieces = contour.iter().flat_map(quarters);
    let ends = pieces.flat_map(|e| [e.from(), e.to()]).map(|p| into.cutting_coordinate(p));
    let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let begin = into.cutting_coordinate(begin);
    // An upright contour has no side of its own; a tool at its end stands beside it.
    if begin >= high && begin > low {
        Some(-1.0)
    } else if begin <= low && begin < high {
        Some(1.0)
    } else {
        None
    }
}

impl Layers {
    /// Equal cuts from the tool at `home`, (Z, X) with X as a radius, of at most `most` mm down to a contour in either
    /// direction; `None` where it stands above the contour. The tool lifts off by `lift` mm and goes back to where it
    /// stands.
    pub fn from_corner(
        contour: &[Element],
        into: Towards,
        home: Point2,
        most: f64,
        lift: f64,
        feed: Feed,
    ) -> Option<Layers> {
        let along = sense_of_cuts(contour, into, home)?;
        let (first, last) = (contour.first()?.from(), contour.last()?.to());
        let way = (into.cutting_coordinate(last) - into.cutting_coordinate(first)) * along;
        let falls =
            (into.depth_coordinate(last) - into.depth_coordinate(first)) * (into.unit().x + into.unit().y) > 0.0;
        // An upright contour begins at its deeper end.
        let turned = way < 0.0 || (way == 0.0 && falls);
        Some(Layers {
            contour: if turned { contour.iter().rev().map(Element::reversed).collect() } else { contour.to_vec() },
            into,
            along,
            nose: Nose { radius: 0.0, tip: into.unit() },
            blank: Blank::Corner(Corner { infeed: None, back: true }),
            allowance: Allowance::default(),
            most,
            segmentation: Segmentation::Uniform,
            trace: Trace::None,
            chips: None,
            relief: Relief::Left,
            limits: Limits::default(),
            operation: Operation::Rough,
            finish_backwards: false,
            clearance: Clearance { lift, entry: lift },
            feeds: LayerFeeds { rough: feed, plunge: feed, finish: feed },
            home,
        })
    }

    /// The same for the rectangle between the tool and the corner at `to`.
    pub fn rectangle(home: Point2, to: Point2, into: Towards, most: f64, lift: f64, feed: Feed) -> Option<Layers> {
        let (foot, top) = if into.is_radial() {
            (Point2::new(home.x, to.y), Point2::new(to.x, home.y))
        } else {
            (Point2::new(to.x, home.y), Point2::new(home.x, to.y))
        };
        let contour = [Element::Line { from: foot, to }, Element::Line { from: to, to: top }];
        Layers::from_corner(&contour, into, home, most, lift, feed)
    }

    /// Greatest coordinate of stock on the infeed axis (X radius or Z) that roughing from a corner leaves between two
    /// coordinates of the cutting axis; `None` where its cuts do not pass all of it.
    pub fn leaves_standing(&self, from: f64, to: f64) -> Option<f64> {
        let chain = self.seen();
        let (near, far) = ((from * self.along).min(to * self.along), (from * self.along).max(to * self.along));
        let begin = self.into.cutting_coordinate(self.home) * self.along;
        let end = chain.last()?.to().x;
        let axes = if self.into.is_radial() { self.allowance.axes } else { self.allowance.axes.yx() };
        // The nose leaves a fillet in front of a wall, and the allowance.
        let beyond = far + axes.x + self.allowance.around + 2.0 * self.nose.radius;
        if !matches!(self.blank, Blank::Corner(_)) || near < begin || beyond > end {
            return None;
        }
        let steps = if self.trace == Trace::None { self.most } else { 0.0 };
        let high = Profile::new(&chain, Grown::default()).highest(f64::NEG_INFINITY, beyond);
        let out = -(self.into.unit().x + self.into.unit().y);
        Some((high + axes.y + self.allowance.around + steps) * out)
    }

    /// Where a cycle leaves the tool that stays where its cuts begin.
    pub(super) fn leaves_beside(&self, at: &mut Pos) {
        let (infeed, cutting) = self.into.axes();
        at.set(cutting, self.into.cutting_coordinate(self.home));
        match self.last_lift() {
            Some(height) => at.set(infeed, height),
            // It depends on the contour.
            None => at.forget(infeed),
        }
    }

    /// Height of the last lift on the infeed axis, where the last cut runs along a level floor.
    fn last_lift(&self) -> Option<f64> {
        let plain = self.trace == Trace::None && self.operation == Operation::Rough && self.nose.radius == 0.0;
        let [Element::Line { from, to }, Element::Line { from: foot, to: top }] = self.contour[..] else { return None };
        let height = |p: Point2| self.into.depth_coordinate(p);
        let along = |p: Point2| self.into.cutting_coordinate(p);
        let square = height(from) == height(to) && along(foot) == along(top) && height(top) == height(self.home);
        let out = -(self.into.unit().x + self.into.unit().y);
        let axes = self.allowance.axes;
        let (aside, up) = if self.into.is_radial() { (axes.x, axes.y) } else { (axes.y, axes.x) };
        let long = (along(to) - along(from)).abs() > aside + LEAST_CUT;
        (plain && square && long).then(|| height(from) + (up + self.clearance.lift) * out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::Vec2;
    use crate::ir::cycle::recess::tests::lines;

    #[test]
    fn the_tool_stands_on_one_side_of_the_contour() {
        let shaft = lines(&[(0.0, 30.0), (-20.0, 30.0), (-20.0, 40.0)]);
        let side = |z, x| sense_of_cuts(&shaft, Towards::MinusX, Point2::new(z, x));
        assert_eq!((side(2.0, 25.0), side(-22.0, 25.0), side(-10.0, 25.0)), (Some(-1.0), Some(1.0), None));
        // The arc bulges beyond its ends, and a tool above the bulge stands above the contour.
        let (from, to) = (Point2::new(0.0, 30.0), Point2::new(0.0, 40.0));
        let bulge = [Element::Arc { from, to, center: Point2::new(0.0, 35.0), sweep: core::f64::consts::PI }];
        let side = |z| sense_of_cuts(&bulge, Towards::MinusX, Point2::new(z, 25.0));
        assert_eq!((side(6.0), side(4.0), side(0.0)), (Some(-1.0), None, Some(1.0)));
        let upright = lines(&[(0.0, 30.0), (0.0, 40.0)]);
        assert_eq!(sense_of_cuts(&upright, Towards::MinusX, Point2::new(0.0, 25.0)), None);
    }

    #[test]
    fn what_roughing_leaves_standing() {
        let contour = lines(&[(0.0, 30.0), (-20.0, 30.0), (-20.0, 40.0), (-50.0, 40.0)]);
        let home = Point2::new(2.0, 25.0);
        let layers = Layers::from_corner(&contour, Towards::MinusX, home, 2.0, 1.0, Feed::PerRevolution(0.2));
        let mut layers = layers.expect("beside the contour");
        layers.allowance.axes = Vec2::new(0.1, 0.3);
        layers.trace = Trace::Last;
        let left = |layers: &Layers, from, to| layers.leaves_standing(from, to);
        assert_eq!(left(&layers, -15.0, -5.0), Some(15.3));
        assert_eq!((left(&layers, -5.0, -19.95), left(&layers, -45.0, -30.0)), (Some(20.3), Some(20.3)));
        assert_eq!((left(&layers, -49.95, -30.0), left(&layers, -5.0, 3.0)), (None, None));
        layers.trace = Trace::None;
        assert_eq!(left(&layers, -15.0, -5.0), Some(17.3));
    }
}
