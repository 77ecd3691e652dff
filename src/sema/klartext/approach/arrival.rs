//! APPR: known when the first element of the contour is.

use std::fmt::Display;

use crate::diag::{Answer, codes};
use crate::geo::{self, Point2, SAME_POINT, Vec2, distance, joint};
use crate::ir::contour::Move;
use crate::ir::{Feed, Function, Origin, Side};
use crate::machine::{ApproachDepth, Axis, Generation};
use crate::sema::run::{Site, Where};
use crate::text::Span;

use super::super::contour::Contour;
use super::super::place::View;
use super::super::words::{Comp, Words};
use super::super::{Core, Outcome, Run};
use super::border::{Border, Circle, Moves, Shape, end_of, forbid_scaling};

/// What may stand between an approach and the first element of its contour.
pub(in super::super) const MOST_HELD: usize = 256;

/// An approach whose contour is not known yet.
#[derive(Debug)]
pub(in super::super) struct Approach {
    shape: Shape,
    pub name: String,
    pub here: Site,
    pub span: Span,
    from: Point2,
    pub to: Point2,
    /// The tool axis: from where to where.
    depth: Option<(Option<f64>, f64)>,
    /// Where the tool lies.
    left: bool,
    /// Side of the contour; none for R0.
    side: Side,
    /// Tool radius in the programmed frame.
    radius: f64,
    /// Feed to PH; `None` for rapid.
    lead: Option<Feed>,
    feed: Option<Feed>,
    /// What came since: it belongs behind the approach.
    pub held: Vec<Held>,
}

#[derive(Debug)]
pub(in super::super) enum Held {
    Function(Function, Origin),
    /// A move that leaves the plane alone.
    Move(Move, Origin),
}

/// The way to a contour, while it is made.
#[derive(Debug, Clone, Copy)]
struct Way {
    /// PH as it is sent.
    start: Point2,
    arc: Option<Circle>,
    /// Length from PH to the contour.
    length: f64,
}

impl Run<'_> {
    pub(super) fn approach_later(&mut self, name: &str, span: Span, shape: Shape, polar: bool, w: &Words) -> Outcome {
        let (left, side) = self.view().approach_side(name, span, w)?;
        forbid_scaling(&self.core, &self.st.ctx.frame, span)?;
        let mut radius = 0.0;
        if side != Side::None {
            self.compute_compensation(w.comp_span)?;
            self.st.tool.check_cutter(&self.core, w.comp_span)?;
            radius = self.st.tool.radius(&self.core, w.comp_span)?;
            self.st.compensation.select(side);
            self.shape_corners(w)?;
        }
        self.m_at_start(w, true)?;
        let plane = self.st.plane();
        let from = self.view().start_in(plane, name)?;
        // LT, LN and CT go to PH as the block before went, LCT as its own block says.
        let before = if self.st.feed.last_rapid { None } else { self.st.feed.before(&self.core) };
        let own = matches!(shape, Shape::LineArc { .. });
        if before.is_none() && !self.st.feed.last_rapid && !own {
            return self.st.feed.missing(&self.core);
        }
        self.st.set_feed(&self.core, w)?;
        let straight = self.st.feed.of_move(&self.core, w)?;
        let feed = if shape.is_round() { Some(self.st.feed.of_arc(&self.core, w)?) } else { straight };
        let lead = if own { straight } else { before };
        let (to, depth) = self.border_point(name, polar, from, w)?;
        let third = Axis::ALL[plane.axes().2];
        if depth.is_some() && self.st.feed.plunge_share().is_some() {
            return self.core.refuse(w.axes_span, codes::K9003::with_tool_axis_under_m103_is_not(&name));
        }
        let after = end_of(plane, Some(to), depth);
        let depth = depth.map(|depth| (self.st.position.get(third), depth));
        let (here, name) = (self.core.here, name.to_owned());
        let held = Vec::new();
        self.approach =
            Some(Box::new(Approach { shape, name, here, span, from, to, depth, left, side, radius, lead, feed, held }));
        self.st.compensation.found();
        self.st.contour.now = Some(Contour { begun: true, ..Contour::new(side) });
        self.st.position.move_to(&after);
        self.st.position.forget_way();
        Ok(())
    }
}

impl View<'_, '_> {
    /// Is the tool left of the contour, and which side has the contour?
    fn approach_side(&self, name: &str, span: Span, w: &Words) -> Outcome<(bool, Side)> {
        if self.st.compensation.is_on() {
            return self.core.refuse(span, codes::K9003::while_rl_or_rr_is_active(&name));
        }
        if self.core.computes_path() && self.st.contour.now.is_some() {
            return self.core.refuse(span, codes::K9003::starts_beside_contour(&name));
        }
        match w.comp {
            Some(Comp::Side(side @ (Side::Left | Side::Right))) => Ok((side == Side::Left, side)),
            _ if self.core.job.settings.control.klartext <= Generation::Itnc530 => {
                self.core.say(span, codes::K2895::without_rl_or_rr(&name));
                Ok((false, Side::None))
            }
            _ => self.core.refuse(span, codes::K9003::with_r0_is_not_supported(&name)),
        }
    }
}

impl Approach {
    /// The moves onto the contour, whose first element begins in the direction `heading`.
    pub fn moves(&self, view: View<'_, '_>, heading: Vec2) -> Outcome<Vec<Move>> {
        let core = view.core;
        let border = Border::new(self.to, heading, self.left, (self.side, self.radius), core.computes_path());
        let way = self.way(core, &border)?;
        let lead = distance(self.from, way.start);
        if lead <= SAME_POINT && core.computes_path() {
            return core.refuse(self.span, codes::K2605::start_of_is_point(&self.name));
        }
        let (at_start, staged, at_end) = self.depths(view, lead / (lead + way.length))?;
        let mut moves = Moves::new(view.st.plane());
        moves.line(way.start, at_start, self.lead, border.side);
        if let Some(depth) = staged {
            moves.depth(depth, self.feed, border.side);
        }
        let enters = self.side != Side::None && border.side == Side::None;
        match way.arc {
            None if enters => moves.line(self.to, at_end, self.feed, self.side),
            None => moves.line(border.at, at_end, self.feed, border.side),
            Some(on) => {
                let arc = moves.arc(border.at, at_end, &on, self.feed, border.side);
                arc.or_else(|fault| core.refuse(Where::Block, fault))?;
                // The tool stands beside the contour already: this is where the compensation begins.
                if enters && self.radius > 0.0 {
                    moves.line(self.to, None, self.feed, self.side);
                }
            }
        }
        Ok(moves.list)
    }

    fn way(&self, core: &Core<'_>, border: &Border) -> Outcome<Way> {
        let circle = |radius| border.circle(radius, &self.name).or_else(|fault| core.refuse(Where::Block, fault));
        Ok(match self.shape {
            Shape::Line { length } => Way { start: border.at - border.heading * length, arc: None, length },
            Shape::Normal { length } => Way { start: border.edge + border.out * length, arc: None, length },
            Shape::Arc { radius, angle } => {
                let on = circle(radius)?;
                let turn = geo::Deg(if on.ccw { -angle } else { angle });
                let start = geo::angle::rotated(border.at, on.center, turn);
                Way { start, arc: Some(on), length: radius.abs() * angle.to_radians() }
            }
            Shape::LineArc { radius } => {
                let on = circle(radius)?;
                let Some(touch) = joint::tangent_point(self.from, on.center, radius, on.ccw) else {
                    return core.refuse(self.span, codes::K2605::start_of_lies_inside_its_circle(&self.name));
                };
                let start = on.center + (touch - on.center) * (on.radius / radius);
                let sweep = geo::arc::sweep(start, border.at, on.center, on.ccw).abs();
                Way { start, arc: Some(on), length: radius * sweep }
            }
        })
    }

    /// Where the tool axis is at PH, whether it moves there alone, and where it is at the contour.
    fn depths(&self, view: View<'_, '_>, share: f64) -> Outcome<(Option<f64>, Option<f64>, Option<f64>)> {
        let Some((from, depth)) = self.depth else { return Ok((None, None, None)) };
        let settings = &view.core.job.settings.control;
        let newer = settings.klartext >= Generation::Tnc7;
        if !match settings.klartext_choices.approach_depth {
            Some(ApproachDepth::Together) => true,
            Some(ApproachDepth::Staged) => false,
            None => newer,
        } {
            return Ok((None, Some(depth), None));
        }
        if !view.core.computes_path() {
            return view.core.refuse(self.span, codes::K9003::with_tool_axis_is_not_supported(&self.name));
        }
        let Some(from) = from else {
            let fault = |axis: &dyn Display, why: &dyn Display| {
                codes::P2001::moves_tool_axis_together_with_plane(&self.name, axis, why)
            };
            return view.unknown_position(view.st.axis(), self.span, fault);
        };
        if settings.klartext_choices.approach_depth.is_none() {
            let fault = codes::K2896::tool_axis_of_moves_evenly_over_whole(&self.name);
            view.core.say(self.span, fault.answer(Answer::key("control", "approach_depth")));
        }
        Ok((Some(from + (depth - from) * share), None, Some(depth)))
    }
}
