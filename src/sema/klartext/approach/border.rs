//! What approaches and departures have in common: their shape, the border point of the contour, the circle at it, and the
//! moves that lead there.

use crate::diag::{Fault, codes};
use crate::geo::{Plane, Point2, SAME_DIRECTION, Vec2, angle, left, tolerance};
use crate::ir::contour::{Arc, ArcShape, Coords, Move, Path};
use crate::ir::{Feed, Frame, Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::plane::plane_axes;
use crate::text::Span;

use super::super::words::Words;
use super::super::{Core, Outcome, Run};

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

impl Border {
    /// Of a contour whose moves have `side`, with the tool at `radius` from it.
    pub(super) fn new(
        contour: Point2,
        heading: Vec2,
        on_left: bool,
        (side, radius): (Side, f64),
        computed: bool,
    ) -> Border {
        let out = if on_left { left(heading) } else { -left(heading) };
        let edge = contour + out * radius;
        let by_target = side != Side::None && !computed;
        let (at, side, tool) = if by_target { (contour, side, radius) } else { (edge, Side::None, 0.0) };
        Border { at, edge, heading, out, left: on_left, side, tool }
    }

    /// The circle that touches the path in the border point.
    pub(super) fn circle(&self, radius: f64, name: &str) -> Result<Circle, Fault> {
        // On the side of the tool the contour lies outside the path of its centre, on the other side inside.
        let sent = radius + self.tool;
        if radius < 0.0 && sent >= 0.0 {
            return Err(codes::K2605::radius_of_is_not_larger_than_tool(&name));
        }
        let ccw = self.left == (radius > 0.0);
        Ok(Circle { center: self.at + self.out * sent, radius: sent.abs(), ccw })
    }
}

/// The moves of an approach or departure in a plane, in their order.
#[derive(Debug)]
pub(super) struct Moves {
    plane: Plane,
    pub list: Vec<Move>,
}

impl Moves {
    pub(super) fn new(plane: Plane) -> Moves {
        Moves { plane, list: Vec::new() }
    }

    /// Straight in the plane, together with the tool axis if `depth` is given.
    pub(super) fn line(&mut self, to: Point2, depth: Option<f64>, feed: Option<Feed>, side: Side) {
        self.add(Some(to), depth, Path::straight(feed), side);
    }

    /// The tool axis alone.
    pub(super) fn depth(&mut self, depth: f64, feed: Option<Feed>, side: Side) {
        self.add(None, Some(depth), Path::straight(feed), side);
    }

    /// An arc, which is refused without a feed.
    pub(super) fn arc(
        &mut self,
        to: Point2,
        depth: Option<f64>,
        on: &Circle,
        feed: Option<Feed>,
        side: Side,
    ) -> Result<(), Fault> {
        let feed = feed.ok_or_else(codes::P2002::no_feed_rate_is_programmed_before)?;
        let shape = ArcShape::Center { center: on.center, ccw: on.ccw, tol: tolerance::SAME };
        self.add(Some(to), depth, Path::Arc(Arc { plane: self.plane, shape, turns: 0 }, feed), side);
        Ok(())
    }

    fn add(&mut self, to: Option<Point2>, depth: Option<f64>, path: Path, side: Side) {
        let end = end_of(self.plane, to, depth);
        self.list.push(Move { end, path, side, coords: Coords::Frame });
    }
}

/// A point of a plane, with the tool axis at `depth`.
pub(super) fn end_of(plane: Plane, to: Option<Point2>, depth: Option<f64>) -> Pos {
    let mut end = Pos::UNKNOWN;
    if let Some(to) = to {
        end.set_in_plane(plane, to);
    }
    if let Some(depth) = depth {
        end.set(Axis::ALL[plane.axes().2], depth);
    }
    end
}

/// Lengths and radii are real ones, as the radius of the tool is.
pub(super) fn forbid_scaling(core: &Core<'_>, frame: &Frame, span: Span) -> Outcome {
    if frame.uniform_scale().is_none_or(|scale| (scale - 1.0).abs() > SAME_DIRECTION) {
        return core.refuse(span, codes::K9003::approach_or_departure_under_scaling_is_not());
    }
    Ok(())
}

impl Run<'_> {
    /// The end point in the plane, and that of the tool axis if the block names it.
    pub(super) fn border_point(
        &mut self,
        name: &str,
        polar: bool,
        from: Point2,
        w: &Words,
    ) -> Outcome<(Point2, Option<f64>)> {
        let plane = self.st.plane();
        let (first, second, third) = plane.axes();
        let third = Axis::ALL[third];
        if !w.axes.known().without(plane_axes(plane)).without(AxisSet::of(third)).is_empty() {
            return self.core.refuse(w.axes_span, codes::P1003::moves_axes_of_plane(&name));
        }
        let end = self.view().absolute(w)?;
        let to = if polar {
            let pole = self.view().pole(name)?;
            if pole.plane != plane {
                return self.core.refuse(w.polar_radius_span, codes::K9003::about_pole_of_another_plane(&name));
            }
            let (radius, angle) = self.view().polar_words(w, &pole, name)?;
            self.st.polar.keep(radius, angle, &pole);
            angle::polar_point(pole.at, radius, angle)
        } else {
            self.st.polar.forget_last();
            let coordinate = |axis: usize, old: f64| end.get(Axis::ALL[axis]).unwrap_or(old);
            Point2::new(coordinate(first, from.x), coordinate(second, from.y))
        };
        Ok((to, end.get(third)))
    }
}
