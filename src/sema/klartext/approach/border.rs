//! What approaches and departures have in common: their shape, the border point of the contour, the circle at it.

use crate::geo::{Point2, Vec2};
use crate::ir::Side;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    /// LT: straight along the element, by this length.
    Line { length: f64 },
    /// LN: straight at a right angle to the element, by this length.
    Normal { length: f64 },
    /// CT: arc of this radius (negative: from the other side) over this angle in degrees.
    Arc { radius: f64, angle: f64 },
    /// LCT: arc of this radius with a tangential line.
    LineArc { radius: f64 },
}

impl Shape {
    pub(super) fn is_round(self) -> bool {
        matches!(self, Shape::Arc { .. } | Shape::LineArc { .. })
    }
}

/// First or last point of a contour.
#[derive(Debug, Clone, Copy)]
pub(super) struct Border {
    /// Where the elements that are sent pass it: on the contour where the target compensates, else where the tool
    /// centre stands.
    pub at: Point2,
    /// Where the tool centre stands.
    pub edge: Point2,
    pub heading: Vec2,
    /// From the contour to the tool.
    pub out: Vec2,
    /// Is the tool left of the contour?
    pub left: bool,
    /// Side that is sent.
    pub side: Side,
    /// What the target takes off the radii.
    pub tool: f64,
}

/// The circle of an approach or departure as it is sent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Circle {
    pub center: Point2,
    pub radius: f64,
    pub ccw: bool,
}
