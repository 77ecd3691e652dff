//! `CYCLE800`: a swivelled plane, in which positions count from there on. Without angles it shifts the workpiece. The tool may be
//! retracted before.
//!
//! The plane lies inside of the work offset and outside of the programmable frame. Source: S 4.9 (docs/sources.md) and
//! references, multi-axis, section 3.1.

use crate::diag::{Answer, codes};
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::tilt::Solution;
use crate::ir::{Function, Pos, Side, Tilt, Tilting};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::text::{Loc, Span};

use super::diameter::Diameter;
use super::frames::FrameValue;
use super::swivel_call::{Arguments, Direction, Swivel};
use super::tangent::Heading;
use super::{Channel, Core, Outcome, State};

/// What a call does.
#[derive(Debug)]
enum Act {
    /// The rotary axes turn into the plane.
    Into(FrameValue, Solution),
    /// They turn back; the workpiece is shifted.
    Back(FrameValue, Solution),
    /// The plane ends, and nothing turns.
    Off(FrameValue),
    /// There is no plane, and the workpiece is shifted.
    Shift(FrameValue),
}

impl Act {
    /// What of the plane is left outside of the programmable frame.
    fn frame(&self) -> &FrameValue {
        match self {
            Act::Into(frame, _) | Act::Back(frame, _) | Act::Off(frame) | Act::Shift(frame) => frame,
        }
    }
}

impl Channel<'_> {
    /// `CYCLE800(…)`
    pub(super) fn swivel(&mut self, given: &Arguments, span: Span) -> Outcome {
        let done = self.swivel_by(given, span);
        if done.is_err() {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
        }
        done
    }

    /// `CYCLE800()`: back to the plane that is not swivelled.
    pub(super) fn swivel_off(&mut self, span: Span) -> Outcome {
        if self.st.frames.is_tilted() {
            return self.swivel(&Arguments::of(0), span);
        }
        self.shift_workpiece(FrameValue::default());
        self.core.say_once(span, codes::S8103::words_that_only_steer_control());
        Ok(())
    }

    fn swivel_by(&mut self, given: &Arguments, span: Span) -> Outcome {
        let swivel = match given.read(self.st.length_unit()) {
            Ok(swivel) => swivel,
            Err((place, fault)) => return self.core.refuse(place, fault),
        };
        let act = self.st.act_of(&swivel, span);
        let act = self.core.made(act)?;
        let clear = self.st.may_swivel(&self.core, &swivel, &act, span);
        self.core.made(clear)?;
        if let (Some((place, fault)), Act::Into(..) | Act::Back(..)) = (swivel.contradiction.as_ref(), &act) {
            self.core.say_once(*place, fault.clone());
        }
        self.swivel_retracts(&swivel, span)?;
        self.pending_must_be_done(span)?;
        if let Act::Shift(shift) = act {
            self.core.say_once(span, said_of_shift(&shift, &swivel));
            self.shift_workpiece(shift);
            return Ok(());
        }
        // Rotary axes turn away from where a call or a probe left the tool.
        self.leaves_touched(AxisSet::of(Axis::C), true)?;
        self.shift_workpiece(act.frame().clone());
        let tilting = self.st.tilt(&act, self.core.here.origin.loc);
        if tilting.turns() && !swivel.record.is_empty() {
            self.st.swivel_record = swivel.record;
        }
        self.function(Function::Tilt(Box::new(tilting)));
        Ok(())
    }

    fn shift_workpiece(&mut self, frame: FrameValue) {
        self.st.frames.set_swivelled(frame);
        self.st.refresh_frame(&self.core);
    }
}

/// What is said of a call that turns nothing.
fn said_of_shift(shift: &FrameValue, swivel: &Swivel) -> crate::diag::Fault {
    let [x, y, z] = [0, 1, 2].map(|axis| shift.shift[axis]);
    if *shift != FrameValue::default() {
        codes::S8029::turns_nothing_and_shifts(&x, &y, &z)
    } else if swivel.retraction == 0.0 {
        codes::S8029::turns_nothing_and_is_left_out()
    } else {
        codes::S8029::turns_nothing_and_only_retracts()
    }
}

impl State {
    /// The plane is another one: no position of before holds.
    fn tilt(&mut self, act: &Act, loc: Loc) -> Tilting {
        self.heading = Heading::None;
        self.position.forget(AxisSet::ALL);
        self.position.hide(AxisSet::ALL, By::Tilt, loc);
        match act {
            Act::Into(_, solution) => {
                self.orientation.turn_into_plane();
                let plane = self.frames.plane();
                Tilting::Into(Tilt { axes: *plane.axes(), origin: plane.origin(), solution: *solution })
            }
            Act::Back(_, solution) => {
                self.orientation.turn_back();
                Tilting::Back(*solution)
            }
            Act::Off(_) | Act::Shift(_) => {
                self.orientation.leave_plane(loc);
                Tilting::Off
            }
        }
    }

    /// What the call does from the plane in force.
    fn act_of(&self, swivel: &Swivel, span: Span) -> Made<Act> {
        let on = self.frames.is_tilted();
        let plane = if swivel.resets {
            FrameValue::default()
        } else if swivel.additive {
            let chained = self.frames.swivelled().chain(&swivel.plane);
            FrameValue::placed(*chained.axes(), chained.origin())
        } else {
            swivel.plane.clone()
        };
        let solution = match swivel.direction {
            _ if swivel.resets => None,
            Direction::Smaller => Some(Solution::Reference { greater: false }),
            Direction::Greater => Some(Solution::Reference { greater: true }),
            Direction::Stays | Direction::Unknown => None,
        };
        let turned = on || !self.orientation.may_move();
        match solution {
            Some(solution) if !plane.is_shift() => Ok(Act::Into(plane, solution)),
            None if !plane.is_shift() => refused(span, codes::S9006::cycle800_turns_frame_only()),
            Some(solution) if turned || self.is_turned_by_words() && !self.machine.lathe => {
                Ok(Act::Back(plane, solution))
            }
            None if on && swivel.direction == Direction::Unknown && !swivel.resets => {
                refused(span, codes::S9006::cycle800_turns_frame_only())
            }
            None if on => Ok(Act::Off(plane)),
            _ => match self.rotary_off_zero() {
                Some(axis) => refused(span, codes::S9006::cycle800_may_turn_back_to_0(&axis.letter())),
                None => Ok(Act::Shift(plane)),
            },
        }
    }

    /// A rotary axis that is known to stand elsewhere than at 0.
    fn rotary_off_zero(&self) -> Option<Axis> {
        let mut rotary = Axis::ALL.into_iter().filter(|axis| axis.is_rotary());
        rotary.find(|axis| self.position.get(*axis).is_some_and(|at| at != 0.0))
    }

    fn is_turned_by_words(&self) -> bool {
        self.rotary_off_zero().is_some() || self.orientation.is_turned_by_words()
    }

    /// What has to hold where the plane or the shift changes.
    fn may_swivel(&self, core: &Core<'_>, swivel: &Swivel, act: &Act, span: Span) -> Made {
        let changes = !matches!(act, Act::Shift(_));
        let shifts =
            changes || *act.frame() != FrameValue::default() || *self.frames.swivelled() != FrameValue::default();
        let leaving = changes && self.compensation.is_leaving();
        if leaving || self.side() != Side::None && shifts {
            return refused(span, codes::S2080::frame_changes_while_radius_compensation());
        }
        if self.machine.lathe && shifts {
            let swivels = changes;
            return refused(
                span,
                if swivels {
                    codes::S9006::cycle800_swivels_on_lathe()
                } else {
                    codes::S9006::cycle800_shifts_workpiece()
                },
            );
        }
        let programmed = self.frames.programmable().map().is_none_or(|frame| !frame.is_identity());
        if programmed && matches!(act, Act::Off(_)) {
            return refused(span, codes::S2283::programmed_frame_is_in_force_where_plane_ends());
        }
        if programmed && !swivel.resets {
            return refused(span, codes::S9006::cycle800_for_new_plane_deletes_programmed_frames());
        }
        if changes { self.may_turn(core, swivel, act, span) } else { Ok(()) }
    }

    /// What has to hold where the plane turns.
    fn may_turn(&self, core: &Core<'_>, swivel: &Swivel, act: &Act, span: Span) -> Made {
        if self.transformation.is_some() {
            return refused(span, codes::S9006::cycle800_swivels_while_axes_are_transformed());
        }
        if self.offsets.in_machine() {
            return refused(span, codes::S9006::cycle800_swivels_under_g500());
        }
        let Act::Into(plane, _) = act else { return self.same_record(swivel, act, span) };
        if let Some((place, fault)) = &swivel.follows {
            return refused(*place, fault.clone());
        }
        let in_force = self.plane() == crate::geo::Plane::Xy;
        if !in_force || swivel.first_plane == Some(false) || self.machine.geometry_axes != [Axis::X, Axis::Y, Axis::Z] {
            return refused(span, codes::S9006::cycle800_swivels_in_another_plane());
        }
        if self.frames.settable().is_some_and(|offset| !offset.is_shift()) {
            return refused(span, codes::S9006::cycle800_swivels_turned_offset());
        }
        let diameters =
            core.job.settings.machine.diameter_axis == Some(Axis::X) && self.diameter_mode() != Diameter::Off;
        if diameters && plane.axes()[(0, 0)] != 1.0 {
            return refused(span, codes::S9006::cycle800_swivels_diameters());
        }
        self.same_record(swivel, act, span)
    }

    /// Another record is another head or table.
    fn same_record(&self, swivel: &Swivel, act: &Act, span: Span) -> Made {
        let other = &self.swivel_record;
        let ends = matches!(act, Act::Off(_));
        if ends || other.is_empty() || swivel.record.is_empty() || swivel.record == *other {
            return Ok(());
        }
        refused(Where::Words(span), codes::S9006::cycle800_selects_another_record(&swivel.record, other))
    }
}

impl Channel<'_> {
    /// The retraction in front of swivelling: 0 none, 1 along Z, 2 along Z and then X and Y, 4 as far as possible along
    /// the tool, 5 by a way along the tool.
    fn swivel_retracts(&mut self, swivel: &Swivel, span: Span) -> Outcome {
        let machine = &self.core.job.settings.machine;
        let (steps, points, key): (&[&[Axis]], _, _) = match swivel.retraction {
            0.0 => return Ok(()),
            1.0 => (&[&[Axis::Z]], &machine.swivel_retract, "swivel_retract"),
            2.0 => (&[&[Axis::Z], &[Axis::X, Axis::Y]], &machine.swivel_retract, "swivel_retract"),
            4.0 => (&[&[Axis::Z]], &machine.swivel_retract_most, "swivel_retract_most"),
            5.0 => return self.swivel_retracts_by(swivel.way, span),
            other => {
                return self.core.refuse(span, codes::S9006::cycle800_has_no_retraction(&other));
            }
        };
        let missing: Vec<Axis> = steps.concat().into_iter().filter(|axis| !points.contains_key(axis)).collect();
        if let [first, others @ ..] = &missing[..] {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
            let help = Answer::entry("machine", key, first.letter()).help(format!(
                "give it in machine coordinates: `[machine] {key} = {{ Z = 0.0 }}`; or program the retraction \
                 (SUPA G0 Z…) and 0 as the first argument"
            ));
            let help = others.iter().fold(help, |help, axis| help.and(Answer::entry("machine", key, axis.letter())));
            return self.core.refuse(span, codes::S9006::cycle800_retracts_tool_to_place().help(&help));
        }
        self.retracts_uncompensated(span)?;
        for axes in steps {
            let mut end = Pos::UNKNOWN;
            for axis in *axes {
                end.set(*axis, points[axis]);
            }
            self.machine_rapid(end);
        }
        Ok(())
    }

    fn retracts_uncompensated(&mut self, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        if self.st.side() != Side::None {
            return self.core.refuse(span, codes::S2080::cycle800_retracts_under_radius_compensation());
        }
        Ok(())
    }

    /// Along Z by a way.
    fn swivel_retracts_by(&mut self, way: f64, span: Span) -> Outcome {
        self.retracts_uncompensated(span)?;
        if way < 0.0 {
            return self.core.refuse(span, codes::S9006::retraction_fr_i());
        }
        let Some(at) = self.st.position.get(Axis::Z) else { return self.st.unknown_axis(&self.core, Axis::Z, span) };
        let mut end = Pos::UNKNOWN;
        end.set(Axis::Z, at + way);
        self.leaves_touched(end.known(), true)?;
        self.stands_right(&end, Coords::Frame)?;
        let mv = Move { end, path: Path::Rapid, side: Side::None, coords: Coords::Frame };
        self.core.send_move(&mv, &self.st.ctx);
        self.st.position.move_to(&end);
        Ok(())
    }
}

#[cfg(test)]
mod tests;
