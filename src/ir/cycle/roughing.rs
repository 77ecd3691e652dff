//! Arguments of stock removal along a contour: roughing in parallel cuts, finishing along it.

use core::fmt;

use crate::geo::{Element, Point2, Vec2};
use crate::ir::{Feed, Pos};

use super::Family;
use super::recess::{MOST_ELEMENTS, Operation, is_element, joined};
use super::turning::{Towards, is_coordinate, is_length, is_positive};

/// Roughing in cuts parallel to the cutting axis. Points are (Z, X) with X as a radius; all lengths in mm.
///
/// What is removed lies between the contour, the height of the blank and the place where the cuts begin.
#[derive(Debug, Clone, PartialEq)]
pub struct Roughing {
    /// The finished contour, in either direction. Seen from where the cuts begin, it rises.
    pub contour: Vec<Element>,
    pub into: Towards,
    pub nose: Nose,
    /// Height of the blank on the infeed axis (X radius or Z).
    pub blank: f64,
    /// Where the cuts begin on the cutting axis, clear of the blank.
    pub begin: f64,
    /// Greatest depth of a cut, over 0. The cuts are equal.
    pub most: f64,
    /// Left on the contour along Z and X (radius), not negative.
    pub oversize: Vec2,
    pub smoothing: Smoothing,
    /// Roughing, finishing along the contour without oversize, or both.
    pub operation: Operation,
    /// What becomes of parts of the contour that fall away from the cut.
    pub falling: Falling,
    /// How far the tool lifts off at 45 degrees, over 0.
    pub lift: f64,
    /// Feed of the cuts.
    pub feed: Feed,
    /// Feed along the contour in finishing.
    pub finish_feed: Feed,
    /// Feed to the depth of a cut; `None` for rapid traverse.
    pub entry: Option<Feed>,
    pub end: RoughingEnd,
}

/// A round tool nose and its programmed point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Nose {
    /// Not negative; 0 for a tool that is taken as a point.
    pub radius: f64,
    /// From the centre of the nose to the programmed point, in radii along Z and X: each -1, 0 or 1. It must
    /// point into the material along the infeed axis.
    pub tip: Vec2,
}

/// When the steps between the cuts are removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Smoothing {
    /// After every cut, along the contour up to the cut before.
    EachCut,
    /// Along the whole contour after the last cut.
    #[default]
    LastCut,
    Never,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Falling {
    /// They are no contour for this cycle.
    #[default]
    Refused,
    /// They are left standing: the cuts end as if the contour went on level.
    Bridged,
}

/// Where the tool stands afterwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RoughingEnd {
    /// Where it stood before: first the infeed axis, then the other one.
    #[default]
    Start,
    /// Where the cuts begin, at the height of the last lift.
    Beside,
}

/// A roughing argument that describes no stock removal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoughingFault {
    /// No contour element, or too many.
    Elements,
    /// A coordinate is not a finite number.
    Point,
    /// Neighbouring elements do not meet.
    Gap,
    /// The nose radius is negative, or its tip points out of the material.
    Nose,
    Blank,
    /// The cuts do not begin outside of the contour.
    Begin,
    /// The greatest infeed is not over 0.
    Most,
    Oversize,
    Lift,
    /// A feed is not over 0.
    Feed,
}

impl fmt::Display for RoughingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RoughingFault::Elements => "the contour has 1 to 100 elements",
            RoughingFault::Point => "a point of the contour is not a number",
            RoughingFault::Gap => "an element of the contour does not start where the one before ends",
            RoughingFault::Nose => "the nose radius must not be negative, and the tool must point into the material",
            RoughingFault::Blank => "the height of the blank is not known",
            RoughingFault::Begin => "the tool does not stand beside the contour, so there is no side to begin at",
            RoughingFault::Most => "the greatest infeed must be over 0",
            RoughingFault::Oversize => "the oversize must not be negative",
            RoughingFault::Lift => "the lift must be over 0",
            RoughingFault::Feed => "the feed must be over 0",
        })
    }
}

impl Family for Roughing {
    type Fault = RoughingFault;

    fn check(&self) -> Result<(), RoughingFault> {
        let rules = [
            ((1..=MOST_ELEMENTS).contains(&self.contour.len()), RoughingFault::Elements),
            (self.contour.iter().all(is_element), RoughingFault::Point),
            (joined(&self.contour), RoughingFault::Gap),
            (self.nose.fits(self.into), RoughingFault::Nose),
            (is_coordinate(self.blank), RoughingFault::Blank),
            (is_coordinate(self.begin) && self.side().is_some(), RoughingFault::Begin),
            (is_positive(self.most), RoughingFault::Most),
            (is_length(self.oversize.x) && is_length(self.oversize.y), RoughingFault::Oversize),
            (is_positive(self.lift), RoughingFault::Lift),
            (is_positive(self.feed.value()), RoughingFault::Feed),
            (is_positive(self.finish_feed.value()), RoughingFault::Feed),
            (self.entry.is_none_or(|feed| is_positive(feed.value())), RoughingFault::Feed),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn leaves(&self, at: &mut Pos) {
        if self.end == RoughingEnd::Beside {
            let (infeed, cutting) = self.into.axes();
            at.set(cutting, self.begin);
            match self.last_lift() {
                Some(height) => at.set(infeed, height),
                // It depends on the contour.
                None => at.forget(infeed),
            }
        }
    }
}

impl Roughing {
    /// A rectangle between the tool at `from` and the corner at `to`, as simple cycles remove it: cuts of
    /// `depth` at most, a lift of 1 mm. With `oblique` the end face leans by that much along the cutting axis
    /// between the corner and the height of the tool.
    pub fn rectangle(from: Point2, to: Point2, into: Towards, depth: f64, oblique: f64, feed: Feed) -> Roughing {
        let line = |from, to| Element::Line { from, to };
        let (foot, top, begin) = if into.is_radial() {
            (Point2::new(from.x, to.y), Point2::new(to.x + oblique, from.y), from.x)
        } else {
            (Point2::new(to.x, from.y), Point2::new(from.x, to.y + oblique), from.y)
        };
        Roughing {
            contour: vec![line(foot, to), line(to, top)],
            into,
            nose: Nose { radius: 0.0, tip: into.unit() },
            blank: into.depth_coordinate(from),
            begin,
            most: depth,
            oversize: Vec2::zeros(),
            smoothing: Smoothing::Never,
            operation: Operation::Rough,
            falling: Falling::Refused,
            lift: 1.0,
            feed,
            finish_feed: feed,
            entry: None,
            end: RoughingEnd::Beside,
        }
    }

    /// Sense of the cutting axis from the contour to where the cuts begin; `None` if they begin above it.
    pub fn side(&self) -> Option<f64> {
        let along = |p: Point2| if self.into.is_radial() { p.x } else { p.y };
        let ends = self.contour.iter().flat_map(|e| [along(e.from()), along(e.to())]);
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        // An upright contour has no side of its own; a tool at its end stands beside it.
        if self.begin >= high && self.begin > low {
            Some(1.0)
        } else if self.begin <= low && self.begin < high {
            Some(-1.0)
        } else {
            None
        }
    }

    /// Height of the last lift on the infeed axis, where the last cut runs along a level floor.
    fn last_lift(&self) -> Option<f64> {
        let plain = self.smoothing == Smoothing::Never && self.operation == Operation::Rough && self.nose.radius == 0.0;
        let [Element::Line { from, to }, Element::Line { from: foot, to: top }] = self.contour[..] else { return None };
        let height = |p: Point2| self.into.depth_coordinate(p);
        let out = -(self.into.unit().x + self.into.unit().y);
        let along = |p: Point2| if self.into.is_radial() { p.x } else { p.y };
        let square = height(from) == height(to) && along(foot) == along(top) && height(top) == self.blank;
        let aside = if self.into.is_radial() { self.oversize.y } else { self.oversize.x };
        (plain && square).then(|| height(from) + (aside + self.lift) * out)
    }
}

impl Nose {
    pub(crate) fn fits(&self, into: Towards) -> bool {
        let component = |v: f64| v == -1.0 || v == 0.0 || v == 1.0;
        is_length(self.radius)
            && (self.radius == 0.0
                || component(self.tip.x) && component(self.tip.y) && self.tip.dot(&into.unit()) == 1.0)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::ir::cycle::recess::tests::lines;

    /// A stepped shaft with a cone, tool at X52 Z2.
    pub(crate) fn shaft() -> Roughing {
        Roughing {
            contour: lines(&[(2.0, 30.0), (-20.0, 30.0), (-30.0, 40.0), (-30.0, 50.0)]),
            nose: Nose::default(),
            most: 3.0,
            smoothing: Smoothing::LastCut,
            ..Roughing::rectangle(
                Point2::new(2.0, 26.0),
                Point2::new(-30.0, 15.0),
                Towards::MinusX,
                3.0,
                0.0,
                Feed::PerRevolution(0.3),
            )
        }
    }

    #[test]
    fn every_bad_argument_has_its_name() {
        type Spoil = fn(&mut Roughing);
        let cases: &[(RoughingFault, Spoil)] = &[
            (RoughingFault::Elements, |r| r.contour.clear()),
            (RoughingFault::Point, |r| r.contour = lines(&[(0.0, f64::NAN), (0.0, 1.0)])),
            (RoughingFault::Gap, |r| {
                let _ = r.contour.remove(1);
            }),
            (RoughingFault::Nose, |r| r.nose.radius = -0.1),
            (RoughingFault::Nose, |r| r.nose = Nose { radius: 0.4, tip: Vec2::new(-1.0, 1.0) }),
            (RoughingFault::Blank, |r| r.blank = f64::NAN),
            (RoughingFault::Begin, |r| r.begin = -10.0),
            (RoughingFault::Most, |r| r.most = 0.0),
            (RoughingFault::Oversize, |r| r.oversize.x = -1.0),
            (RoughingFault::Lift, |r| r.lift = 0.0),
            (RoughingFault::Feed, |r| r.feed = Feed::PerMinute(0.0)),
            (RoughingFault::Feed, |r| r.finish_feed = Feed::PerMinute(-1.0)),
            (RoughingFault::Feed, |r| r.entry = Some(Feed::PerMinute(f64::NAN))),
        ];
        assert_eq!(shaft().check(), Ok(()));
        for (fault, spoil) in cases {
            let mut roughing = shaft();
            spoil(&mut roughing);
            assert_eq!(roughing.check(), Err(*fault));
        }
    }
}
