//! Arguments of path milling: along a contour with the cutter beside it, or on it, level by level.

use core::fmt;

use crate::geo::soft::{self, Shape, Touch};
use crate::geo::{Deg, Element, Point2, Vec2};
use crate::ir::{Compensation, Feed, Pos, Side};

use super::Family;
use super::milling::{Mill, MillFault};

/// A contour that is milled.
#[derive(Debug, Clone, PartialEq)]
pub struct PathMilling {
    /// Plane, heights, cutter and feeds. Its radius is that of the cutter, not its distance from the contour.
    pub mill: Mill,
    /// In the order of travel, each element from where the one before ends, in coordinates of the plane, mm; one at
    /// least, none without length.
    pub contour: Vec<Element>,
    /// Side of the cutter; none: its centre is on the contour.
    pub side: Side,
    /// How the path of the centre follows from the contour; its radius is the distance between the two, with what is left on
    /// the contour.
    pub rules: Compensation,
    /// How the cutter comes to the start of the contour.
    pub approach: Way,
    /// How the cutter leaves the end of the contour.
    pub leave: Way,
    /// Down to the floor, not only to its allowance.
    pub finishes_floor: bool,
    /// How the tool gets from one level to the next.
    pub between: LevelChange,
    /// Every second level is milled backwards, from where the one before ends.
    pub alternates: bool,
}

/// A way to the contour, or from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Way {
    /// What it is made of. A centre on the contour takes a soft line, a tangent or nothing.
    pub form: Form,
    /// Radius or length of the path of the centre in mm; for a soft line the distance of the cutter's edge. Above 0,
    /// and not looked at where there is no such path.
    pub size: f64,
    /// It falls onto the level by the safety distance at the feed for the depth, or rises from it.
    pub spatial: bool,
}

/// What a way is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Form {
    /// A line, a quadrant or a semicircle of the centre that goes on in the direction of the contour.
    Soft(Shape),
    /// An arc by this angle that touches the contour, over 0 to below 360.
    Arc(Deg),
    /// A line on in the direction of the contour.
    Tangent,
    /// A line at a right angle to the contour.
    Square,
    /// Straight down beside the contour, and up.
    None,
}

/// From the end of one level to the start of the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelChange {
    /// How far the tool is lifted.
    pub lift: Lift,
    /// Feed to the start of the next level; rapid traverse without one. Not lifted at all, the tool goes at the feed of
    /// the plane.
    pub feed: Option<Feed>,
}

/// How far the tool is lifted at the end of the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lift {
    /// To the retract height.
    Retract,
    /// To the safety distance above the surface.
    Surface,
    /// By the safety distance above the level; at rapid traverse to the one above the surface.
    Clearance,
    /// Not at all: the tool goes back on the level.
    None,
}

/// Arguments that make no path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// The contour has no element.
    Empty,
    /// An element without length or with a coordinate that is no number.
    Element,
    /// The radius, length or angle of a path to or from the contour is out of range.
    Way,
    /// A way from beside a contour on which the centre lies.
    Round,
}

impl fmt::Display for PathFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            PathFault::Mill(fault) => return fault.fmt(f),
            PathFault::Empty => "the contour has no element",
            PathFault::Element => "an element of the contour has no direction",
            PathFault::Way => "the length or radius of a way to or from the contour is 0",
            PathFault::Round => "on the contour itself the cutter comes and leaves on lines in its direction",
        })
    }
}

impl PathMilling {
    /// Distance between the contour and the path of the centre, mm; 0 for a centre on the contour.
    pub fn distance(&self) -> f64 {
        if self.side == Side::None { 0.0 } else { self.rules.radius }
    }

    /// 1 where the cutter is on the left.
    fn left(&self) -> f64 {
        if self.side == Side::Right { -1.0 } else { 1.0 }
    }

    fn start(&self) -> Option<(Point2, Vec2)> {
        let first = self.contour.first()?;
        Some((first.from(), first.start_direction()?))
    }

    fn end(&self) -> Option<(Point2, Vec2)> {
        let last = self.contour.last()?;
        Some((last.to(), last.end_direction()?))
    }

    /// The path to the start of the contour; `None` for a contour without direction.
    pub fn comes(&self) -> Option<Touch> {
        let (at, heading) = self.start()?;
        Some(self.approach.touch(at, -heading, -self.left(), self.distance()))
    }

    /// The path from the end of the contour; `None` for a contour without direction.
    pub fn goes(&self) -> Option<Touch> {
        let (at, heading) = self.end()?;
        Some(self.leave.touch(at, heading, self.left(), self.distance()))
    }

    /// From its end to its start, with the cutter where it was.
    pub fn backwards(&self) -> PathMilling {
        let side = match self.side {
            Side::None => Side::None,
            Side::Left => Side::Right,
            Side::Right => Side::Left,
        };
        let contour = self.contour.iter().rev().map(Element::reversed).collect();
        PathMilling { contour, side, approach: self.leave, leave: self.approach, ..self.clone() }
    }

    /// Sense of an arc to the contour or from it.
    pub fn turns_counter_clockwise(&self) -> bool {
        self.side == Side::Left
    }

    /// Heights of the levels, from the first cut to the last.
    pub fn levels(&self) -> Vec<f64> {
        let heights = &self.mill.heights;
        if self.finishes_floor { heights.levels_to(heights.depth, heights.step) } else { heights.levels() }
    }
}

impl Way {
    fn touch(&self, at: Point2, away: Vec2, side: f64, radius: f64) -> Touch {
        match self.form {
            Form::Soft(shape) => soft::touch(shape, self.size, at, away, side, radius),
            Form::Arc(sweep) => soft::arc(self.size, sweep, at, away, side, radius),
            Form::Tangent => soft::tangent(self.size, at, away, side, radius),
            Form::Square => soft::square(self.size, at, away, side, radius),
            Form::None => soft::square(0.0, at, away, side, radius),
        }
    }

    fn has_size(&self) -> bool {
        let turns = match self.form {
            Form::Arc(sweep) => sweep.0 > 0.0 && sweep.0 < 360.0,
            Form::Soft(_) | Form::Tangent | Form::Square | Form::None => true,
        };
        self.form == Form::None || turns && self.size > 0.0 && self.size.is_finite()
    }

    /// Does it lie in the contour, or above it?
    fn follows_contour(&self) -> bool {
        matches!(self.form, Form::Soft(Shape::Line) | Form::Tangent | Form::None)
    }
}

impl Family for PathMilling {
    type Fault = PathFault;

    fn check(&self) -> Result<(), PathFault> {
        self.mill.check().map_err(PathFault::Mill)?;
        let sound = |element: &Element| {
            let ends = [element.from(), element.to()];
            element.start_direction().is_some() && ends.iter().all(|p| p.x.is_finite() && p.y.is_finite())
        };
        let ways = [self.approach, self.leave];
        if self.contour.is_empty() {
            Err(PathFault::Empty)
        } else if !self.contour.iter().all(sound) {
            Err(PathFault::Element)
        } else if !ways.iter().all(Way::has_size) {
            Err(PathFault::Way)
        } else if self.side == Side::None && !ways.iter().all(Way::follows_contour) {
            Err(PathFault::Round)
        } else {
            Ok(())
        }
    }

    fn moves(&self) -> f64 {
        (self.contour.len() + 7) as f64 * self.levels().len() as f64
    }

    /// Above the end of the way from the contour.
    fn leaves(&self, at: &mut Pos) {
        let back = self.alternates && self.levels().len().is_multiple_of(2);
        if let Some(touch) = if back { self.comes() } else { self.goes() } {
            self.mill.leaves_above(touch.centre, at);
        }
    }
}
