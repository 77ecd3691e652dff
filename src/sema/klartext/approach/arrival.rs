//! APPR: known when the first element of the contour is.

use std::fmt::Display;

use crate::diag::{Answer, codes};
use crate::geo::{self, Point2, SAME_POINT, Vec2, distance, joint};
use crate::ir::contour::Move;
use crate::ir::{Feed, Function, Origin, Pos, Side};
use crate::machine::{ApproachDepth, Axis, Generation};
use crate::sema::run::Site;
use crate::text::Span;

use super::super::contour::{Contour, LastMove};
use super::super::words::{Comp, Words};
use super::super::{Outcome, Reported, Run};
use super::border::{Border, Circle, Shape};

/// What may stand between an approach and the first element of its contour.
pub(in super::super) const MOST_HELD: usize = 256;

/// An approach whose contour is not known yet.
#[derive(Debug)]
pub(in super::super) struct Approach {
    shape: Shape,
    name: String,
    here: Site,
    span: Span,
    from: Point2,
    to: Point2,
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
        let (left, side) = self.approach_side(name, span, w)?;
        self.forbid_scaling(span)?;
        let mut radius = 0.0;
        if side != Side::None {
            self.compute_compensation(w.comp_span)?;
            self.check_cutter(w.comp_span)?;
            radius = self.tool_radius(w.comp_span)?;
            self.st.compensation.select(side);
            self.shape_corners(w)?;
        }
        self.m_at_start(w, true)?;
        let plane = self.st.plane();
        let from = self.start_in(plane, name)?;
        // LT, LN and CT go to PH as the block before went, LCT as its own block says.
        let before = if self.st.feed.last_rapid { None } else { self.feed_before() };
        let own = matches!(shape, Shape::LineArc { .. });
        if before.is_none() && !self.st.feed.last_rapid && !own {
            return self.feed_missing();
        }
        self.set_feed(w)?;
        let straight = self.move_feed(w)?;
        let feed = if shape.is_round() { Some(self.arc_feed(w)?) } else { straight };
        let lead = if own { straight } else { before };
        let (to, depth) = self.border_point(name, polar, from, w)?;
        let third = Axis::ALL[plane.axes().2];
        if depth.is_some() && self.st.feed.plunge_share().is_some() {
            return self.core.refuse(w.axes_span, codes::K9003::with_tool_axis_under_m103_is_not(&name));
        }
        let mut after = Pos::UNKNOWN;
        after.set_in_plane(plane, to);
        if let Some(depth) = depth {
            after.set(third, depth);
        }
        let depth = depth.map(|depth| (self.st.position.get(third), depth));
        let (here, name) = (self.core.here, name.to_owned());
        let held = Vec::new();
        self.approach =
            Some(Box::new(Approach { shape, name, here, span, from, to, depth, left, side, radius, lead, feed, held }));
        self.st.compensation.found();
        self.st.contour = Some(Contour { begun: true, ..Contour::new(side) });
        self.st.position.move_to(&after);
        self.st.position.forget_way();
        Ok(())
    }

    /// Is the tool left of the contour, and which side has the contour?
    fn approach_side(&mut self, name: &str, span: Span, w: &Words) -> Outcome<(bool, Side)> {
        if self.st.compensation.is_on() {
            return self.core.refuse(span, codes::K9003::while_rl_or_rr_is_active(&name));
        }
        if self.computes_path() && self.st.contour.is_some() {
            return self.core.refuse(span, codes::K9003::starts_beside_contour(&name));
        }
        match w.comp {
            Some(Comp::Side(side @ (Side::Left | Side::Right))) => Ok((side == Side::Left, side)),
            _ if self.core.job.settings.control.klartext <= Generation::Itnc530 => {
                self.core.report(codes::K2895::without_rl_or_rr(&name).at(self.core.loc(span)));
                Ok((false, Side::None))
            }
            _ => self.core.refuse(span, codes::K9003::with_r0_is_not_supported(&name)),
        }
    }

    /// A move while an approach is open: true if it waits, because it leaves the plane alone, or if the approach to it was
    /// refused. Else it is the first element of the contour, and the approach is sent.
    #[cold]
    pub(in super::super) fn wait_for_contour(&mut self, mv: &Move) -> bool {
        if !self.st.moves_in_plane(&mv.end, &mv.path)
            && let Some(approach) = &mut self.approach
            && approach.held.len() < MOST_HELD
        {
            approach.held.push(Held::Move(*mv, self.core.here.origin));
            return true;
        }
        self.send_approach(mv).is_err()
    }

    /// The first element of the contour is about to be sent: now the approach to it is known.
    fn send_approach(&mut self, mv: &Move) -> Outcome {
        let Some(approach) = self.approach.take() else { return Ok(()) };
        let plane = self.st.plane();
        let (first, second, _) = plane.axes();
        let coordinate = |axis: usize, old: f64| mv.end.get(Axis::ALL[axis]).unwrap_or(old);
        let to = Point2::new(coordinate(first, approach.to.x), coordinate(second, approach.to.y));
        let element = LastMove::new(approach.to, to, plane, mv.path, None);
        let here = std::mem::replace(&mut self.core.here, approach.here);
        let made = match element.direction(true) {
            Some(heading) => self.make_approach(&approach, heading),
            None => {
                self.core.refuse(approach.span, codes::K9003::leads_onto_block_whose_direction_is_not(&approach.name))
            }
        };
        if made.is_err() {
            self.lost();
            self.forget_contour();
        }
        self.core.here = here;
        for held in &approach.held {
            match held {
                Held::Function(function, origin) => self.core.out.function(function, &self.st.ctx, origin),
                Held::Move(mv, origin) if made.is_ok() => self.core.out.movement(mv, &self.st.ctx, origin),
                Held::Move(..) => {}
            }
        }
        made
    }

    fn make_approach(&mut self, a: &Approach, heading: Vec2) -> Outcome {
        let border = self.border(a.to, heading, a.left, a.side, a.radius);
        let way = self.way_of(a, &border)?;
        let lead = distance(a.from, way.start);
        if lead <= SAME_POINT && self.computes_path() {
            return self.core.refuse(a.span, codes::K2605::start_of_is_point(&a.name));
        }
        let (at_start, staged, at_end) = self.depths(a, lead / (lead + way.length))?;
        self.way_to(way.start, at_start, a.lead, border.side);
        if let Some(depth) = staged {
            self.axis_move(depth, a.feed, border.side);
        }
        let enters = a.side != Side::None && border.side == Side::None;
        match way.arc {
            None if enters => self.way_to(a.to, at_end, a.feed, a.side),
            None => self.way_to(border.at, at_end, a.feed, border.side),
            Some(on) => {
                self.arc_to(border.at, at_end, &on, a.feed, border.side)?;
                // The tool stands beside the contour already: this is where the compensation begins.
                if enters && a.radius > 0.0 {
                    self.plane_move(a.to, a.feed, a.side);
                }
            }
        }
        Ok(())
    }

    fn way_of(&mut self, a: &Approach, border: &Border) -> Outcome<Way> {
        Ok(match a.shape {
            Shape::Line { length } => Way { start: border.at - border.heading * length, arc: None, length },
            Shape::Normal { length } => Way { start: border.edge + border.out * length, arc: None, length },
            Shape::Arc { radius, angle } => {
                let on = self.circle_at(border, radius, &a.name)?;
                let turn = geo::Deg(if on.ccw { -angle } else { angle });
                let start = geo::angle::rotated(border.at, on.center, turn);
                Way { start, arc: Some(on), length: radius.abs() * angle.to_radians() }
            }
            Shape::LineArc { radius } => {
                let on = self.circle_at(border, radius, &a.name)?;
                let Some(touch) = joint::tangent_point(a.from, on.center, radius, on.ccw) else {
                    return self.core.refuse(a.span, codes::K2605::start_of_lies_inside_its_circle(&a.name));
                };
                let start = on.center + (touch - on.center) * (on.radius / radius);
                let sweep = geo::arc::sweep(start, border.at, on.center, on.ccw).abs();
                Way { start, arc: Some(on), length: radius * sweep }
            }
        })
    }

    /// Where the tool axis is at PH, whether it moves there alone, and where it is at the contour.
    fn depths(&mut self, a: &Approach, share: f64) -> Outcome<(Option<f64>, Option<f64>, Option<f64>)> {
        let Some((from, depth)) = a.depth else { return Ok((None, None, None)) };
        let settings = &self.core.job.settings.control;
        let newer = settings.klartext >= Generation::Tnc7;
        if !match settings.klartext_choices.approach_depth {
            Some(ApproachDepth::Together) => true,
            Some(ApproachDepth::Staged) => false,
            None => newer,
        } {
            return Ok((None, Some(depth), None));
        }
        if !self.computes_path() {
            return self.core.refuse(a.span, codes::K9003::with_tool_axis_is_not_supported(&a.name));
        }
        let Some(from) = from else {
            let fault = |axis: &dyn Display, why: &dyn Display| {
                codes::P2001::moves_tool_axis_together_with_plane(&a.name, axis, why)
            };
            return self.unknown_position(self.st.axis(), a.span, fault);
        };
        if settings.klartext_choices.approach_depth.is_none() {
            self.core.report(
                codes::K2896::tool_axis_of_moves_evenly_over_whole(&a.name)
                    .answer(Answer::key("control", "approach_depth"))
                    .at(self.core.loc(a.span)),
            );
        }
        Ok((Some(from + (depth - from) * share), None, Some(depth)))
    }

    /// Refuses whatever may not stand between an approach and its contour.
    pub(in super::super) fn forbid_open_approach(&mut self) -> Outcome {
        let Some(approach) = self.approach.take() else { return Ok(()) };
        let loc = approach.here.loc(&self.core.job, approach.span);
        let found = codes::K9003::no_contour_element_follows(&approach.name).at(loc);
        self.core.job.diags.push(found.called(approach.here.origin.call));
        self.forget_contour();
        self.lose_all();
        Err(Reported)
    }
}
