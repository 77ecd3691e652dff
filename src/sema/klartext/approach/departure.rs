//! DEP: from the last element of the contour.

use crate::diag::{Answer, codes};
use crate::geo::{self, Point2, SAME_POINT, distance, joint};
use crate::ir::{Feed, Pos, Side};
use crate::machine::{ApproachDepth, Axis, Generation};

use super::super::words::{Comp, Words};
use super::super::{Outcome, Reported, Run};
use super::border::{Border, Shape};

/// The end of a departure.
#[derive(Debug, Clone, Copy)]
struct Exit {
    shape: Shape,
    /// PN of LCT.
    to: Point2,
    /// The tool axis on the way from PH to PN.
    depth: Option<f64>,
    straight: Option<Feed>,
    feed: Option<Feed>,
}

impl Run<'_> {
    pub(super) fn depart(&mut self, name: &str, shape: Shape, polar: bool, w: &Words) -> Outcome {
        let span = self.core.block_span();
        let side = self.st.compensation.side();
        let plane = self.st.plane();
        let at = self.start_in(plane, name)?;
        // Where RL or RR was refused, that was said.
        if side == Side::None && self.st.compensation.take_lost() {
            return Err(Reported);
        }
        // Behind an approach with R0 the contour has no side.
        let contour = self.st.contour.filter(|contour| contour.side == side);
        if self.approach.is_some() || contour.is_none() || w.comp.is_some_and(|comp| comp != Comp::Side(Side::None)) {
            return self.core.refuse(span, codes::K9003::is_supported_behind_contour_with_rl(&name));
        }
        let mut radius = 0.0;
        if side != Side::None {
            self.check_cutter(span)?;
            radius = self.tool_radius(span)?;
        }
        self.forbid_scaling(span)?;
        if contour.is_some_and(|contour| !contour.begun) {
            return self.core.refuse(span, codes::K9003::stands_behind_block_that_leads_to_contour(&name));
        }
        let last = contour.and_then(|contour| contour.last);
        let Some(heading) =
            last.filter(|last| distance(last.to, at) <= SAME_POINT).and_then(|last| last.direction(false))
        else {
            return self.core.refuse(span, codes::K9003::follows_block_whose_direction_is_not_known(&name));
        };
        self.set_feed(w)?;
        let straight = self.move_feed(w)?;
        let feed = if shape.is_round() { Some(self.arc_feed(w)?) } else { straight };
        let (to, depth) =
            if let Shape::LineArc { .. } = shape { self.border_point(name, polar, at, w)? } else { (at, None) };
        if matches!(shape, Shape::LineArc { .. }) && distance(to, at) <= SAME_POINT {
            return self.core.refuse(span, codes::K9003::has_no_end_point_away_from_contour(&name));
        }
        let together = depth.is_some() && self.rises_together(name);
        let (shared, behind) = if together { (depth, None) } else { (None, depth) };
        let border = self.border(at, heading, side == Side::Left, side, radius);
        let end = self.make_departure(name, &border, &Exit { shape, to, depth: shared, straight, feed })?;
        if let Some(depth) = behind {
            self.axis_move(depth, straight, Side::None);
        }
        let mut after = Pos::UNKNOWN;
        after.set_in_plane(plane, end);
        if let Some(depth) = depth {
            after.set(Axis::ALL[plane.axes().2], depth);
        }
        self.st.position.move_to(&after);
        self.st.position.forget_way();
        if !polar {
            self.st.polar.forget_last();
        }
        self.st.end_compensation();
        self.st.contour = None;
        self.st.feed.last_rapid = straight.is_none();
        Ok(())
    }

    /// Sends the way from the contour; where it ends.
    fn make_departure(&mut self, name: &str, border: &Border, exit: &Exit) -> Outcome<Point2> {
        let Exit { shape, to, depth, straight, feed } = *exit;
        // Where the compiler compensates, the compensation ends where the tool stands.
        if border.side == Side::None && self.st.compensation.is_on() {
            self.plane_move(border.edge, straight, Side::None);
        }
        let end = match shape {
            Shape::Line { length } => border.edge + border.heading * length,
            Shape::Normal { length } => border.edge + border.out * length,
            Shape::Arc { radius, angle } => {
                let on = self.circle_at(border, radius, name)?;
                let turn = geo::Deg(if on.ccw { angle } else { -angle });
                self.arc_to(geo::angle::rotated(border.at, on.center, turn), None, &on, feed, border.side)?;
                geo::angle::rotated(border.edge, on.center, turn)
            }
            Shape::LineArc { radius } => {
                let on = self.circle_at(border, radius, name)?;
                // Backwards it is an approach.
                let Some(touch) = joint::tangent_point(to, on.center, radius, !on.ccw) else {
                    return self
                        .core
                        .refuse(self.core.block_span(), codes::K2605::end_of_lies_inside_its_circle(&name));
                };
                let start = on.center + (touch - on.center) * (on.radius / radius);
                self.arc_to(start, None, &on, feed, border.side)?;
                to
            }
        };
        // The end of an arc is reached already, and the target has still to leave the contour.
        if border.side != Side::None || !matches!(shape, Shape::Arc { .. }) {
            self.way_to(end, depth, straight, Side::None);
        }
        Ok(end)
    }

    /// Does the tool axis move together with the line to PN?
    fn rises_together(&mut self, name: &str) -> bool {
        let settings = &self.core.job.settings.control;
        let generation = settings.klartext;
        match settings.klartext_choices.approach_depth {
            Some(reading) => reading == ApproachDepth::Together,
            None if !self.computes_path() => false,
            None => {
                if generation <= Generation::Itnc530 {
                    self.core.report(
                        codes::K2896::tool_axis_of_moves_at_end(&name)
                            .answer(Answer::key("control", "approach_depth"))
                            .at(self.core.here.origin.loc),
                    );
                }
                generation >= Generation::Tnc7
            }
        }
    }
}
