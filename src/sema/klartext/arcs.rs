//! Arcs: C about the pole, CR by radius, CT tangential.
//!
//! Source: K 2.3 to 2.5 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::{Plane, Point2, SAME_POINT, arc, distance};
use crate::ir::compensation::FeedAt;
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::ir::{Feed, Pos, Side};
use crate::machine::Axis;
use crate::sema::common::plane::plane_axes;

use super::polar::PoleState;
use super::words::Words;
use super::{Outcome, Reported, Run};

/// How far the end of an arc may miss the circle: machine parameter *circleDeviation* at its largest.
const CIRCLE_TOLERANCE: f64 = 0.016;

impl Run<'_> {
    /// The pole in force.
    pub(super) fn pole(&mut self, function: &str) -> Outcome<PoleState> {
        let Some(pole) = self.st.polar.pole() else {
            if self.st.polar.is_lost() {
                return Err(Reported);
            }
            self.core.report(codes::K2101::needs_circle_centre_or_pole(&function).at(self.core.here.origin.loc));
            return Err(Reported);
        };
        if pole.system != self.st.frames.system() {
            self.core.report(
                codes::K2108::coordinate_system_changed_since_cc_was_programmed()
                    .at(self.core.here.origin.loc)
                    .also(pole.set, Label::PoleProgrammed),
            );
        }
        Ok(pole)
    }

    /// Direction of an arc: as written, or that of the last one.
    pub(super) fn turn(&mut self, w: &Words, function: &str) -> Outcome<bool> {
        let turn = match (w.turn, self.st.polar.turn()) {
            (Some(turn), _) => turn,
            (None, Some(turn)) => {
                self.core.report(
                    codes::K2103::without_dr_turns_as_last_dr_said(&function, &(if turn { "DR+" } else { "DR-" }))
                        .at(self.core.here.origin.loc),
                );
                turn
            }
            (None, None) => {
                self.core.report(codes::K2104::without_dr_no_arc_before(&function).at(self.core.here.origin.loc));
                return Err(Reported);
            }
        };
        self.st.polar.set_turn(turn);
        Ok(turn)
    }

    /// Where the tool stands in `plane`.
    pub(super) fn start_in(&mut self, plane: Plane, what: &str) -> Outcome<Point2> {
        let (first, second, _) = plane.axes();
        let span = self.core.block_span();
        if self.st.position.stands_beside(plane_axes(plane)) {
            return self.core.refuse(span, codes::K2604::starts_where_r_or_r_left_tool(&what));
        }
        let x = self.position_of(Axis::ALL[first], span, what)?;
        let y = self.position_of(Axis::ALL[second], span, what)?;
        Ok(Point2::new(x, y))
    }

    /// End point of an arc: axes of the plane that are not written keep their value.
    pub(super) fn arc_end(&mut self, w: &Words, plane: Plane, start: Point2) -> Outcome<Pos> {
        let mut end = self.absolute(w)?;
        let (first, second, _) = plane.axes();
        for (axis, value) in [(Axis::ALL[first], start.x), (Axis::ALL[second], start.y)] {
            if end.get(axis).is_none() {
                end.set(axis, value);
            }
        }
        let cuts = self.move_feed(w)?.is_some();
        self.check_axes(w, end, cuts)
    }

    /// Feed of an arc. Plain G-code has no arc at rapid traverse: FMAX needs a number.
    pub(super) fn arc_feed(&mut self, w: &Words) -> Outcome<Feed> {
        if let Some(feed) = self.move_feed(w)? {
            return Ok(feed);
        }
        match self.core.job.settings.control.rapid_feed {
            Some(feed) => Ok(Feed::PerMinute(feed)),
            None => self.core.refuse(
                w.feed_span,
                codes::K9019::arc_at_fmax_has_no_counterpart().answer(Answer::key("control", "rapid_feed")),
            ),
        }
    }

    /// Refuses M109 and M110 on an arc that the target compensates.
    pub(super) fn check_edge_feed(&self, side: Side) -> Outcome {
        if self.st.feed.at == FeedAt::Centre || side == Side::None || self.computes_path() {
            return Ok(());
        }
        self.core.say_here(codes::K9008::m109_m110_change_feed_on_compensated_arcs());
        Err(Reported)
    }

    /// Refuses M109 and M110 on the arc of APPR or DEP: it is no element of the contour.
    pub(super) fn no_edge_feed(&self, side: Side) -> Outcome {
        if self.st.feed.at == FeedAt::Centre || side == Side::None {
            return Ok(());
        }
        self.core.report(codes::K9008::what_m109().at(self.core.here.origin.loc));
        Err(Reported)
    }

    pub(super) fn send_arc(&mut self, w: &Words, plane: Plane, shape: ArcShape, end: Pos) -> Outcome {
        let feed = self.arc_feed(w)?;
        self.check_edge_feed(self.st.compensation.side())?;
        let length =
            if self.st.feed.plunge_share().is_some() { Some(self.arc_length(plane, shape, &end)?) } else { None };
        let feed = self.plunged(w, feed, &end, length);
        self.send(&end, Path::Arc(Arc { plane, shape, turns: 0 }, feed));
        Ok(())
    }

    /// Length of an arc in its plane. An arc that does not exist has none: it is refused later.
    #[cold]
    fn arc_length(&mut self, plane: Plane, shape: ArcShape, end: &Pos) -> Outcome<f64> {
        let from = self.start_in(plane, "M103")?;
        let Some(to) = end.in_plane(plane) else { return Ok(0.0) };
        let about = |center: Point2, ccw: bool| {
            let whole = distance(from, to) <= SAME_POINT;
            let sweep = if whole { core::f64::consts::TAU } else { arc::sweep(from, to, center, ccw).abs() };
            distance(from, center) * sweep
        };
        Ok(match shape {
            ArcShape::Center { center, ccw, .. } => about(center, ccw),
            ArcShape::Sweep { center, sweep } => distance(from, center) * sweep.radians().abs(),
            ArcShape::Radius { radius, ccw, tol } => {
                arc::center_by_radius(from, to, radius, ccw, SAME_POINT, tol).map_or(0.0, |center| about(center, ccw))
            }
            // A tangential arc moves no other axis, and the rest is not of this language.
            ArcShape::Tangent | ArcShape::Opening { .. } | ArcShape::Via { .. } => 0.0,
        })
    }

    /// An arc of a free contour; its end is in the words.
    pub(super) fn solved_arc(&mut self, w: &Words, center: Point2, ccw: bool) -> Outcome {
        self.st.polar.set_turn(ccw);
        self.st.polar.forget_last();
        self.send_arc(w, self.st.plane(), ArcShape::Center { center, ccw, tol: CIRCLE_TOLERANCE }, w.axes)
    }

    pub(super) fn circle(&mut self, w: &Words) -> Outcome {
        let pole = self.pole("C")?;
        let ccw = self.turn(w, "C")?;
        let start = self.start_in(pole.plane, "C")?;
        let end = self.arc_end(w, pole.plane, start)?;
        self.st.polar.forget_last();
        let shape = ArcShape::Center { center: pole.at, ccw, tol: CIRCLE_TOLERANCE };
        self.send_arc(w, pole.plane, shape, end)
    }

    pub(super) fn circle_by_radius(&mut self, w: &Words) -> Outcome {
        let Some(radius) = w.radius.filter(|r| *r != 0.0) else {
            return self.core.refuse(self.core.block_span(), codes::P1004::cr_needs_radius_that_is_not_zero());
        };
        let ccw = self.turn(w, "CR")?;
        let plane = self.st.plane();
        let start = self.start_in(plane, "CR")?;
        let end = self.arc_end(w, plane, start)?;
        if w.axes.known().common(plane_axes(plane)).is_empty() {
            return self.core.refuse(self.core.block_span(), codes::K2109::cr_names_no_end_point_in_working());
        }
        self.st.polar.forget_last();
        self.send_arc(w, plane, ArcShape::Radius { radius, ccw, tol: CIRCLE_TOLERANCE }, end)
    }

    pub(super) fn tangent(&mut self, w: &Words) -> Outcome {
        let plane = self.st.plane();
        self.flat(w, plane, "CT")?;
        self.follows_a_block("CT")?;
        let start = self.start_in(plane, "CT")?;
        let end = self.arc_end(w, plane, start)?;
        if w.axes.known().common(plane_axes(plane)).is_empty() {
            return self.core.refuse(self.core.block_span(), codes::K2109::ct_names_no_end_point_in_working());
        }
        self.st.polar.forget_last();
        self.send_arc(w, plane, ArcShape::Tangent, end)
    }

    /// CT and CTP go on from the element of the program in front of them, not from the way of a cycle.
    pub(super) fn follows_a_block(&mut self, function: &str) -> Outcome {
        if !self.st.position.moved_by_cycle() {
            return Ok(());
        }
        self.core.refuse(self.core.block_span(), codes::K2946::stands_directly_behind_cycle(&function))
    }

    /// CT and CTP are arcs of the plane: no other axis can move along.
    pub(super) fn flat(&mut self, w: &Words, plane: Plane, function: &str) -> Outcome {
        if w.axes.known().without(plane_axes(plane)).is_empty() {
            return Ok(());
        }
        self.core.refuse(w.axes_span, codes::P1003::is_arc_in_plane(&function))
    }
}
