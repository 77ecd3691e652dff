//! What goes out: moves and functions, those that wait for the first element of a contour with them.

use crate::diag::{Label, codes};
use crate::geo::Point2;
use crate::ir::contour::{Arc, ArcShape, Coords, Move, Path};
use crate::ir::tilt::Solution;
use crate::ir::{Function, Pos, Side, Tilting};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::By;
use crate::sema::common::plane::plane_axes;

use super::active_tool::Change;
use super::approach::{Held, MOST_HELD};
use super::compensation::round_border;
use super::contour::LastMove;
use super::known::Known;
use super::state::{CornerMade, State};
use super::tilt_state::Stand;
use super::words::Words;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn function(&mut self, function: Function) {
        if self.st.described.is_some() {
            return;
        }
        if let Some(approach) = &mut self.approach
            && approach.held.len() < MOST_HELD
        {
            return approach.held.push(Held::Function(function, self.core.here.origin));
        }
        self.core.send_function(&function, &self.st.ctx);
    }

    /// Sends a move and takes over its end.
    #[inline]
    pub(super) fn send(&mut self, end: &Pos, path: Path) {
        if self.st.left_by.is_some() {
            let rises = path.is_rapid() || self.st.rises(end);
            self.st.leave_open_end(&self.core, end.known(), rises);
        }
        let mv = Move { end: *end, path, side: self.st.compensation.side(), coords: Coords::Frame };
        if self.approach.is_none() || !self.wait_for_contour(&mv) {
            self.movement(&mv);
        }
        self.st.note_contour(end, &path);
        if matches!(path, Path::Arc(Arc { shape: ArcShape::Tangent, .. }, _)) {
            self.st.last_entry = if self.approach.is_some() { None } else { self.st.last_direction() };
        }
        self.st.last_path = path;
        self.st.feed.last_rapid = path.is_rapid();
        self.st.position.move_to(end);
        self.st.moved = true;
    }

    #[inline]
    pub(super) fn movement(&mut self, mv: &Move) {
        if !matches!(self.st.tool.change, Change::None) {
            let (cuts, along) = (self.st.cuts(mv), mv.end.get(self.st.axis()).is_some());
            self.st.tool.watch_move(&self.core, cuts, along);
        }
        if self.st.tilt.bars() && self.is_barred(mv) {
            return;
        }
        if let Some(corner) = self.st.corner.take() {
            self.side_at_corner(&corner, mv.side);
        }
        if !mv.end.known().without(AxisSet::MAIN).is_empty() {
            // Another side of the part may lie under the tool.
            self.contours.roughed = Known::Nothing;
        }
        if self.st.moves_beside(&mut self.core, mv.end.known(), matches!(mv.path, Path::Rapid)) {
            return;
        }
        self.core.send_move(mv, &self.st.ctx);
    }

    /// The element after a chamfer or rounding: the compensation goes on as it was in front of it.
    #[cold]
    fn side_at_corner(&mut self, made: &CornerMade, side: Side) {
        if side == made.side {
            return;
        }
        let word = |side| match side {
            Side::None => "R0",
            Side::Left => "RL",
            Side::Right => "RR",
        };
        let change = format!("the compensation changes from {} to {}", word(made.side), word(side));
        let here = self.core.here.origin.loc;
        if !made.rounding {
            self.core.report(codes::K2891::at_this_chamfer(&change).at(made.loc).also(here, Label::InThisBlock));
        } else if side != Side::None {
            let found = codes::K2892::at_this_rounding_it_is_made_all(&change).at(made.loc);
            self.core.report(found.also(here, Label::InThisBlock));
        } else if round_border(&self.core, "RND", true).is_err() {
            // A rounding from a compensated contour into R0 is the departure on an arc.
            self.st.lose_all(&mut self.core);
        }
    }

    /// Sends the moves of an approach or departure.
    pub(super) fn send_moves(&mut self, moves: &[Move]) -> Outcome {
        for mv in moves {
            if let Path::Arc(..) = mv.path {
                self.st.feed.no_edge(&self.core, mv.side)?;
            }
            self.movement(mv);
            self.st.moved = true;
        }
        Ok(())
    }

    /// A move while an approach is open: true if it waits, because it leaves the plane alone, or if the approach to it was
    /// refused. Else it is the first element of the contour, and the approach is sent.
    #[cold]
    fn wait_for_contour(&mut self, mv: &Move) -> bool {
        if !self.st.step(&mv.end, &mv.path).moves()
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
            Some(heading) => approach.moves(self.view(), heading).and_then(|moves| self.send_moves(&moves)),
            None => {
                self.core.refuse(approach.span, codes::K9003::leads_onto_block_whose_direction_is_not(&approach.name))
            }
        };
        if made.is_err() {
            self.st.lost(&mut self.core);
            self.st.lose_contour();
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

    /// Refuses whatever may not stand between an approach and its contour.
    pub(super) fn forbid_open_approach(&mut self) -> Outcome {
        let Some(approach) = self.approach.take() else { return Ok(()) };
        let loc = approach.here.loc(&self.core.job, approach.span);
        let found = codes::K9003::no_contour_element_follows(&approach.name).at(loc);
        self.core.job.diags.push(found.called(approach.here.origin.call));
        self.st.lose_contour();
        self.st.lose_all(&mut self.core);
        Err(Reported)
    }

    /// Rotary axes and parallel axes have rules of their own.
    #[inline]
    pub(super) fn check_axes(&mut self, w: &Words, end: Pos, cuts: bool) -> Outcome<Pos> {
        if end.known().without(AxisSet::MAIN).is_empty() {
            return Ok(end);
        }
        self.rare_axes(w, end, cuts)
    }

    #[cold]
    fn rare_axes(&mut self, w: &Words, mut end: Pos, cuts: bool) -> Outcome<Pos> {
        if self.st.tilt.is_left() && end.known().iter().any(|axis| axis.is_rotary()) {
            return self.turns_back_by_numbers(w, end);
        }
        self.st.frames.no_rotary_move_under_turn(&self.core, end.known(), w.axes_span)?;
        for axis in end.known().without(AxisSet::MAIN).iter() {
            if !axis.is_rotary() {
                if let Some(what) = self.st.frames.transform().touches_parallel(axis) {
                    return self.core.refuse(w.axes_span, codes::K2506::moves_while_is_active(&axis.letter(), &what));
                }
                continue;
            }
            if self.st.feed.at_surface && cuts {
                return self.core.refuse(w.axes_span, codes::K2509::moves_at_feed_under_m116(&axis.letter()));
            }
            if let Err(fault) = self.st.tilt.admits_rotary(axis) {
                return self.core.refuse(w.axes_span, fault);
            }
            let (rotary, position, span) = (&mut self.st.rotary, &self.st.position, w.axes_span);
            rotary.moves(axis);
            if w.incremental.contains(axis) {
                rotary.check_tip(&self.core, position, axis, end.get(axis), span)?;
                // Counted from a position that holds the whole turns already.
                rotary.check_increment(&self.core, w, axis)?;
                continue;
            }
            let target = rotary.target(&self.core, position, axis, end.get(axis).unwrap_or(0.0), span);
            rotary.check_tip(&self.core, position, axis, Some(target), span)?;
            end.set(axis, target);
        }
        Ok(end)
    }
}

impl Run<'_> {
    /// The rotary axes go back to where the tool stands along Z of the workpiece.
    pub(super) fn turn_back(&mut self) {
        self.st.tilt.stand = Stand::Upright;
        self.st.tilt.turned = AxisSet::EMPTY;
        self.st.rotary.stand_at_zero();
        self.function(Function::Tilt(Box::new(Tilting::Back(Solution::Control))));
    }

    /// The rotary axes stand in the plane that was defined.
    pub(super) fn arrive(&mut self) {
        if let Stand::Waits(tilt) = self.st.tilt.stand {
            self.st.tilt.stand = Stand::In(tilt);
            self.function(Function::Tilt(Box::new(Tilting::Into(tilt))));
        }
    }

    /// No main axis stands where it did in the coordinates of before.
    pub(super) fn leave_plane(&mut self) {
        let here = self.core.here.origin.loc;
        self.st.position.forget_tip(AxisSet::MAIN, By::Tilt, here);
        self.st.position.forget(AxisSet::ALL.without(AxisSet::MAIN));
        self.st.polar.forget_last();
        self.st.polar.lose_pole();
    }

    /// `L A+0 C+0 R0 FMAX` behind a plane that ended: where each axis that the program named in the plane has gone back to 0, they all
    /// turn back. What is left of the end point is given back.
    fn turns_back_by_numbers(&mut self, w: &Words, mut end: Pos) -> Outcome<Pos> {
        for axis in end.known().iter().filter(|axis| axis.is_rotary()) {
            let at_zero = end.get(axis).is_some_and(|target| target % 360.0 == 0.0) && !w.incremental.contains(axis);
            if !at_zero || !self.st.tilt.turned.contains(axis) {
                return self.core.refuse(w.axes_span, codes::K2857::which_axes_turned_is_not_known());
            }
            self.st.tilt.turned = self.st.tilt.turned.without(AxisSet::of(axis));
            end.forget(axis);
        }
        if self.st.tilt.turned.is_empty() {
            self.turn_back();
            self.leave_plane();
        }
        Ok(end)
    }

    /// Is a move refused for how the tool stands? Says so once.
    #[cold]
    fn is_barred(&mut self, mv: &Move) -> bool {
        if mv.coords == Coords::Machine || mv.end.known().common(AxisSet::MAIN).is_empty() {
            return false;
        }
        self.bar();
        true
    }

    /// Says why nothing moves by coordinates of the program here.
    #[cold]
    pub(super) fn bar(&mut self) {
        if !std::mem::replace(&mut self.st.tilt.said, true) {
            self.core.say_here(self.st.tilt.why());
        }
        self.st.lose_all(&mut self.core);
    }
}

impl State {
    /// Does the move cut? Not at rapid traverse, and not upwards along the tool axis alone, however fast.
    fn cuts(&self, mv: &Move) -> bool {
        let (axis, plane) = (self.axis(), plane_axes(self.plane()));
        if mv.path.is_rapid() || mv.coords == Coords::Machine {
            return false;
        }
        if !matches!(mv.path, Path::Line(_)) || plane.iter().any(|axis| goes(self.position.at(), &mv.end, axis)) {
            return true;
        }
        let height = match self.tool.change {
            Change::Called { height, .. } => height,
            _ => None,
        };
        match (mv.end.get(axis), self.position.get(axis), height) {
            (Some(to), Some(from), _) => to < from,
            (Some(to), None, Some(height)) => to <= height,
            _ => false,
        }
    }
}

/// Does the move give the axis another coordinate? Yes where the old one is not known.
fn goes(from: &Pos, end: &Pos, axis: Axis) -> bool {
    end.get(axis).is_some_and(|to| from.get(axis) != Some(to))
}
