//! Arguments of recess turning: a groove roughed by plunging and turning in turns, and finished along its
//! contour.

use core::fmt;

use crate::geo::{Element, Plane, Vec2, distance};
use crate::ir::{Feed, Pos};

use super::Family;
use super::turning::{Towards, is_coordinate, is_length, is_point, is_positive};

/// Most elements of a contour.
pub const MOST_ELEMENTS: usize = 100;

/// Ends of neighbouring elements may be this far apart, mm: what four decimals lose.
const JOINT: f64 = 1e-3;

/// Recess turning. Points are (Z, X) with X as a radius; all lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct RecessTurning {
    /// The finished groove from rim to rim: it falls to its floor and rises again, seen from the tool. The
    /// order of the elements says at which wall the work begins.
    pub contour: Vec<Element>,
    /// Infeed direction: plunges go this way, turned cuts across.
    pub into: Towards,
    /// The recessing tool.
    pub tool: RecessTool,
    /// Coordinate of the blank on the infeed axis (X radius or Z) where the groove is cut into it; above the floor of
    /// the groove.
    pub blank: f64,
    /// Greatest depth of a cut, over 0.
    pub most: f64,
    /// Left on the contour along Z and X (radius), not negative.
    pub oversize: Vec2,
    /// How much less far a turned cut ends at a wall, each time it is followed by a plunge there; 0 for none. Made
    /// smaller where the sum would exceed 80 % of the effective cutting width or half of the floor.
    pub offset_width: f64,
    /// Height at which the floor is turned in finishing, above the floor: the tool bends under the side load. Below it where it is
    /// negative.
    pub compensation: f64,
    /// Whether the groove is turned, and in which sense, or only plunged.
    pub passes: Passes,
    /// Roughing, finishing or both.
    pub operation: Operation,
    /// Clear height above the blank, over 0; the tool travels there.
    pub clearance: f64,
    /// Each over 0.
    pub feeds: RecessFeeds,
    /// Where the tool stands after the cycle.
    pub end: RecessEnd,
}

/// A recessing tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecessTool {
    /// Cutting width in mm, over 0.
    pub width: f64,
    /// Nose radius at both corners in mm, 0 to half the width.
    pub nose: f64,
    /// From the programmed point to the edge that lies towards minus on the cutting axis, mm: 0 where that edge is
    /// programmed, `-width` where the other one is, `-width / 2` for the middle.
    pub edge: f64,
}

/// Feeds; each is the one that the control takes for these moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecessFeeds {
    /// Of plunges into the material.
    pub plunge: Feed,
    /// Of turned cuts along the groove.
    pub turn: Feed,
    /// Along the finished contour.
    pub finish: Feed,
}

/// How the groove is roughed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Passes {
    /// To and fro.
    #[default]
    BothWays,
    /// In the direction of the contour; the tool lifts and goes back. There is no change from turning to
    /// plunging, so the offset width has no effect.
    OneWay,
    /// The same, and each pass from the second on ends earlier than the one before by the offset width.
    OneWayShorter,
    /// No turning: strokes side by side to the full depth, at most `width` apart (over 0). The first one cuts
    /// with the whole tool. The greatest depth of a cut and the offset width have no effect. The tool waits
    /// `dwell` seconds at the foot of each stroke and of each finishing cut down a wall.
    Strokes { width: f64, dwell: f64 },
}

/// What a cycle of turning does of its two parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Operation {
    /// Roughing, and finishing after it.
    #[default]
    RoughAndFinish,
    /// Roughing alone; the allowance stays.
    Rough,
    /// Finishing alone.
    Finish,
}

/// Where the tool stands afterwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecessEnd {
    /// Where it stood before: first the infeed axis, then the other one.
    #[default]
    Start,
    /// At the clear height above the start of the contour.
    Front,
    /// At the clear height above the last cut.
    Lift,
}

/// A recess argument that describes no groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecessFault {
    /// No contour element, or more than [`MOST_ELEMENTS`].
    Elements,
    /// A coordinate is not a finite number.
    Point,
    /// Neighbouring elements do not meet.
    Gap,
    /// The cutting width is not over 0.
    Width,
    /// The nose radius is negative or over half the width.
    Nose,
    /// The place of the cutting edge is no number.
    Edge,
    /// The height of the blank is no number.
    Blank,
    /// The greatest infeed is not over 0.
    Most,
    /// The allowance is negative.
    Oversize,
    /// The offset width is negative.
    OffsetWidth,
    /// The height of the floor for turning is no number.
    Compensation,
    /// The distance of strokes is not over 0 or over the effective cutting width, or the dwell is negative.
    Strokes,
    /// The clearance is not over 0.
    Clearance,
    /// A feed is not over 0.
    Feed,
}

impl fmt::Display for RecessFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RecessFault::Elements => "the contour of a recess has 1 to 100 elements",
            RecessFault::Point => "a point of the contour is not a number",
            RecessFault::Gap => "an element of the contour does not start where the one before ends",
            RecessFault::Width => "the cutting width of the tool must be over 0",
            RecessFault::Nose => "the nose radius must lie between 0 and half the cutting width",
            RecessFault::Edge => "the reference point of the tool is not known",
            RecessFault::Blank => "the height of the blank is not known",
            RecessFault::Most => "the greatest infeed must be over 0",
            RecessFault::Oversize => "the oversize must not be negative",
            RecessFault::OffsetWidth => "the offset width must not be negative",
            RecessFault::Compensation => "the turning depth compensation is no length",
            RecessFault::Strokes => {
                "the distance of strokes must be over 0 and at most the effective cutting width, the dwell not negative"
            }
            RecessFault::Clearance => "the clearance must be over 0",
            RecessFault::Feed => "a feed must be over 0",
        })
    }
}

impl Family for RecessTurning {
    type Fault = RecessFault;

    fn check(&self) -> Result<(), RecessFault> {
        let tool = &self.tool;
        let feeds = [self.feeds.plunge, self.feeds.turn, self.feeds.finish];
        let rules = [
            ((1..=MOST_ELEMENTS).contains(&self.contour.len()), RecessFault::Elements),
            (self.contour.iter().all(is_element), RecessFault::Point),
            (joined(&self.contour), RecessFault::Gap),
            (is_positive(tool.width), RecessFault::Width),
            (is_length(tool.nose) && tool.nose <= tool.width / 2.0, RecessFault::Nose),
            (is_coordinate(tool.edge), RecessFault::Edge),
            (is_coordinate(self.blank), RecessFault::Blank),
            (is_positive(self.most), RecessFault::Most),
            (is_length(self.oversize.x) && is_length(self.oversize.y), RecessFault::Oversize),
            (is_length(self.offset_width), RecessFault::OffsetWidth),
            (is_coordinate(self.compensation), RecessFault::Compensation),
            (self.strokes_fit(), RecessFault::Strokes),
            (is_positive(self.clearance), RecessFault::Clearance),
            (feeds.iter().all(|feed| is_positive(feed.value())), RecessFault::Feed),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn leaves(&self, at: &mut Pos) {
        let (infeed, cutting) = self.into.axes();
        match self.end {
            RecessEnd::Start => {}
            RecessEnd::Front => {
                if let Some(first) = self.contour.first() {
                    at.set_in_plane(Plane::Zx, first.from());
                }
                at.set(infeed, self.clear());
            }
            // It depends on the tool and the walls.
            RecessEnd::Lift => {
                at.set(infeed, self.clear());
                at.forget(cutting);
            }
        }
    }
}

impl RecessTurning {
    /// Between strokes further apart than the flat of the edge, ridges would stand.
    fn strokes_fit(&self) -> bool {
        match self.passes {
            Passes::BothWays | Passes::OneWay | Passes::OneWayShorter => true,
            Passes::Strokes { width, dwell } => {
                is_positive(width) && width <= self.tool.width - 2.0 * self.tool.nose && is_length(dwell)
            }
        }
    }

    /// Coordinate of the clear height on the infeed axis (X radius or Z).
    pub fn clear(&self) -> f64 {
        match self.into {
            Towards::MinusX | Towards::MinusZ => self.blank + self.clearance,
            Towards::PlusX | Towards::PlusZ => self.blank - self.clearance,
        }
    }
}

/// Finite numbers, and arcs with a radius.
pub(crate) fn is_element(element: &Element) -> bool {
    let ends = is_point(element.from()) && is_point(element.to());
    match *element {
        Element::Line { .. } => ends,
        Element::Arc { from, center, sweep, .. } => {
            ends && is_point(center) && sweep.is_finite() && sweep != 0.0 && distance(from, center) > 0.0
        }
    }
}

/// Does each element start where the one before ends?
pub(crate) fn joined(contour: &[Element]) -> bool {
    contour.windows(2).all(|pair| distance(pair[0].to(), pair[1].from()) <= JOINT)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A line contour through points given as (Z, X diameter).
    pub(crate) fn lines(points: &[(f64, f64)]) -> Vec<Element> {
        let point = |p: (f64, f64)| crate::geo::Point2::new(p.0, p.1 / 2.0);
        points.windows(2).map(|pair| Element::Line { from: point(pair[0]), to: point(pair[1]) }).collect()
    }

    /// Groove Z-20 to Z-32 in a shaft of 60, floor 48; tool 3 wide, nose 0.2, left edge programmed.
    pub(crate) fn groove() -> RecessTurning {
        RecessTurning {
            contour: lines(&[(-20.0, 60.0), (-20.0, 48.0), (-32.0, 48.0), (-32.0, 60.0)]),
            into: Towards::MinusX,
            tool: RecessTool { width: 3.0, nose: 0.2, edge: 0.0 },
            blank: 30.0,
            most: 2.0,
            oversize: Vec2::new(0.1, 0.2),
            offset_width: 0.3,
            compensation: 0.0,
            passes: Passes::BothWays,
            operation: Operation::Rough,
            clearance: 1.0,
            feeds: RecessFeeds {
                plunge: Feed::PerRevolution(0.08),
                turn: Feed::PerRevolution(0.15),
                finish: Feed::PerRevolution(0.1),
            },
            end: RecessEnd::Lift,
        }
    }

    #[test]
    fn every_bad_argument_has_its_name() {
        type Spoil = fn(&mut RecessTurning);
        let cases: &[(RecessFault, Spoil)] = &[
            (RecessFault::Elements, |r| r.contour.clear()),
            (RecessFault::Elements, |r| r.contour = vec![r.contour[0]; 101]),
            (RecessFault::Point, |r| r.contour = lines(&[(0.0, f64::NAN), (0.0, 1.0)])),
            (RecessFault::Gap, |r| {
                let _ = r.contour.remove(1);
            }),
            (RecessFault::Width, |r| r.tool.width = 0.0),
            (RecessFault::Nose, |r| r.tool.nose = 1.6),
            (RecessFault::Edge, |r| r.tool.edge = f64::NAN),
            (RecessFault::Blank, |r| r.blank = f64::INFINITY),
            (RecessFault::Most, |r| r.most = 0.0),
            (RecessFault::Oversize, |r| r.oversize.y = -0.1),
            (RecessFault::OffsetWidth, |r| r.offset_width = -0.1),
            (RecessFault::Compensation, |r| r.compensation = f64::NAN),
            (RecessFault::Strokes, |r| r.passes = Passes::Strokes { width: 2.7, dwell: 0.0 }),
            (RecessFault::Strokes, |r| r.passes = Passes::Strokes { width: 2.0, dwell: -1.0 }),
            (RecessFault::Clearance, |r| r.clearance = 0.0),
            (RecessFault::Feed, |r| r.feeds.finish = Feed::PerRevolution(0.0)),
        ];
        assert_eq!(groove().check(), Ok(()));
        for (fault, spoil) in cases {
            let mut recess = groove();
            spoil(&mut recess);
            assert_eq!(recess.check(), Err(*fault));
        }
    }
}
