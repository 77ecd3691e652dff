//! Arcs: C about the pole, CR by radius, CT tangential.
//!
//! Source: K 2.3 to 2.5 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Plane, Point2};
use crate::ir::Pos;
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::machine::Axis;
use crate::parser::klartext::ast::PathFn;
use crate::sema::common::plane::plane_axes;
use crate::sema::run::Where;

use super::words::Words;
use super::{Outcome, Run};

/// How far the end of an arc may miss the circle: machine parameter *circleDeviation* at its largest.
const CIRCLE_TOLERANCE: f64 = 0.016;

impl Run<'_> {
    /// C, CR and CT: axes of the plane that are not written keep their value.
    pub(super) fn arc(&mut self, w: &Words, function: PathFn) -> Outcome {
        let name = function.word();
        let (plane, shape) = match function {
            PathFn::Circle => {
                let pole = self.view().pole(name)?;
                let ccw = self.st.polar.turns(&self.core, w, name)?;
                (pole.plane, ArcShape::Center { center: pole.at, ccw, tol: CIRCLE_TOLERANCE })
            }
            PathFn::CircleRadius => {
                let Some(radius) = w.radius.filter(|r| *r != 0.0) else {
                    return self.core.refuse(Where::Block, codes::P1004::cr_needs_radius_that_is_not_zero());
                };
                let ccw = self.st.polar.turns(&self.core, w, name)?;
                (self.st.plane(), ArcShape::Radius { radius, ccw, tol: CIRCLE_TOLERANCE })
            }
            _ => {
                w.flat(&self.core, self.st.plane(), name)?;
                self.view().follows_a_block(name)?;
                (self.st.plane(), ArcShape::Tangent)
            }
        };
        let start = self.view().start_in(plane, name)?;
        let mut end = self.view().absolute(w)?;
        let (first, second, _) = plane.axes();
        for (axis, value) in [(Axis::ALL[first], start.x), (Axis::ALL[second], start.y)] {
            if end.get(axis).is_none() {
                end.set(axis, value);
            }
        }
        let cuts = self.st.feed.of_move(&self.core, w)?.is_some();
        let end = self.check_axes(w, end, cuts)?;
        if function != PathFn::Circle && w.axes.known().common(plane_axes(plane)).is_empty() {
            let fault = match function {
                PathFn::CircleRadius => codes::K2109::cr_names_no_end_point_in_working(),
                _ => codes::K2109::ct_names_no_end_point_in_working(),
            };
            return self.core.refuse(Where::Block, fault);
        }
        self.st.polar.forget_last();
        self.send_arc(w, plane, shape, end)
    }

    /// An arc of a free contour; its end is in the words.
    pub(super) fn solved_arc(&mut self, w: &Words, center: Point2, ccw: bool) -> Outcome {
        self.st.polar.set_turn(ccw);
        self.st.polar.forget_last();
        self.send_arc(w, self.st.plane(), ArcShape::Center { center, ccw, tol: CIRCLE_TOLERANCE }, w.axes)
    }

    pub(super) fn send_arc(&mut self, w: &Words, plane: Plane, shape: ArcShape, end: Pos) -> Outcome {
        let feed = self.st.feed.of_arc(&self.core, w)?;
        self.st.feed.check_edge(&self.core, self.st.compensation.side())?;
        let shared = self.st.feed.plunge_share().is_some();
        let length = if shared { Some(self.view().arc_length(plane, shape, &end)?) } else { None };
        let feed = self.view().plunged(w, feed, &end, length);
        self.send(&end, Path::Arc(Arc { plane, shape, turns: 0 }, feed));
        Ok(())
    }
}
