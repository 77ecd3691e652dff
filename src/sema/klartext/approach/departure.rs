//! DEP: from the last element of the contour.

use crate::diag::{Answer, Fault, codes};
use crate::geo::{self, Point2, SAME_POINT, distance, joint};
use crate::ir::{Feed, Side};
use crate::machine::{ApproachDepth, Generation};

use super::super::words::{Comp, Words};
use super::super::{Core, Outcome, Reported, Run};
use super::border::{Border, Moves, Shape, end_of, forbid_scaling};

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
        let at = self.view().start_in(plane, name)?;
        // Where RL or RR was refused, that was said.
        if side == Side::None && self.st.compensation.take_lost() {
            return Err(Reported);
        }
        // Behind an approach with R0 the contour has no side.
        let contour = self.st.contour.now.filter(|contour| contour.side == side);
        if self.approach.is_some() || contour.is_none() || w.comp.is_some_and(|comp| comp != Comp::Side(Side::None)) {
            return self.core.refuse(span, codes::K9003::is_supported_behind_contour_with_rl(&name));
        }
        let mut radius = 0.0;
        if side != Side::None {
            self.st.tool.check_cutter(&self.core, span)?;
            radius = self.st.tool.radius(&self.core, span)?;
        }
        forbid_scaling(&self.core, &self.st.ctx.frame, span)?;
        if contour.is_some_and(|contour| !contour.begun) {
            return self.core.refuse(span, codes::K9003::stands_behind_block_that_leads_to_contour(&name));
        }
        let last = contour.and_then(|contour| contour.last);
        let Some(heading) =
            last.filter(|last| distance(last.to, at) <= SAME_POINT).and_then(|last| last.direction(false))
        else {
            return self.core.refuse(span, codes::K9003::follows_block_whose_direction_is_not_known(&name));
        };
        self.st.set_feed(&self.core, w)?;
        let straight = self.st.feed.of_move(&self.core, w)?;
        let feed = if shape.is_round() { Some(self.st.feed.of_arc(&self.core, w)?) } else { straight };
        let (to, depth) =
            if let Shape::LineArc { .. } = shape { self.border_point(name, polar, at, w)? } else { (at, None) };
        if matches!(shape, Shape::LineArc { .. }) && distance(to, at) <= SAME_POINT {
            return self.core.refuse(span, codes::K9003::has_no_end_point_away_from_contour(&name));
        }
        let together = depth.is_some() && rises_together(&self.core, name);
        let (shared, behind) = if together { (depth, None) } else { (None, depth) };
        let computed = self.core.computes_path();
        let border = Border::new(at, heading, side == Side::Left, (side, radius), computed);
        let mut moves = Moves::new(plane);
        let exit = Exit { shape, to, depth: shared, straight, feed };
        let end = exit.moves(name, &border, self.st.compensation.is_on(), &mut moves);
        if let (Some(depth), Ok(_)) = (behind, &end) {
            moves.depth(depth, straight, Side::None);
        }
        self.send_moves(&moves.list)?;
        let end = end.or_else(|fault| self.core.refuse(span, fault))?;
        self.st.position.move_to(&end_of(plane, Some(end), depth));
        self.st.position.forget_way();
        if !polar {
            self.st.polar.forget_last();
        }
        self.st.end_compensation();
        self.st.contour.now = None;
        self.st.feed.last_rapid = straight.is_none();
        Ok(())
    }
}

impl Exit {
    /// Adds the moves from the contour; where they end. `entered`: the compensation is on.
    fn moves(&self, name: &str, border: &Border, entered: bool, moves: &mut Moves) -> Result<Point2, Fault> {
        let Exit { shape, to, depth, straight, feed } = *self;
        // Where the compiler compensates, the compensation ends where the tool stands.
        if border.side == Side::None && entered {
            moves.line(border.edge, None, straight, Side::None);
        }
        let end = match shape {
            Shape::Line { length } => border.edge + border.heading * length,
            Shape::Normal { length } => border.edge + border.out * length,
            Shape::Arc { radius, angle } => {
                let on = border.circle(radius, name)?;
                let turn = geo::Deg(if on.ccw { angle } else { -angle });
                moves.arc(geo::angle::rotated(border.at, on.center, turn), None, &on, feed, border.side)?;
                geo::angle::rotated(border.edge, on.center, turn)
            }
            Shape::LineArc { radius } => {
                let on = border.circle(radius, name)?;
                // Backwards it is an approach.
                let Some(touch) = joint::tangent_point(to, on.center, radius, !on.ccw) else {
                    return Err(codes::K2605::end_of_lies_inside_its_circle(&name));
                };
                let start = on.center + (touch - on.center) * (on.radius / radius);
                moves.arc(start, None, &on, feed, border.side)?;
                to
            }
        };
        // The end of an arc is reached already, and the target has still to leave the contour.
        if border.side != Side::None || !matches!(shape, Shape::Arc { .. }) {
            moves.line(end, depth, straight, Side::None);
        }
        Ok(end)
    }
}

/// Does the tool axis move together with the line to PN?
fn rises_together(core: &Core<'_>, name: &str) -> bool {
    let generation = core.job.settings.control.klartext;
    match core.job.settings.control.klartext_choices.approach_depth {
        Some(reading) => reading == ApproachDepth::Together,
        None if !core.computes_path() => false,
        None => {
            if generation <= Generation::Itnc530 {
                let fault = codes::K2896::tool_axis_of_moves_at_end(&name);
                core.say_here(fault.answer(Answer::key("control", "approach_depth")));
            }
            generation >= Generation::Tnc7
        }
    }
}
