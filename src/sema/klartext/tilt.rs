//! Tilted working planes: where one lies, whether the rotary axes stand in it, and what that forbids.
//!
//! Source: K 3.4; M 2 (docs/sources.md). A plane is defined first, and reached by TURN, or by the block of rotary axes that
//! follows STAY. The output leaves it to the machine which of its axes turn.

use nalgebra::{Matrix3, Vector3};

use crate::diag::{Fault, codes};
use crate::geo::{Deg, Vec2, tolerance};
use crate::ir::contour::{Coords, Move};
use crate::ir::tilt::Solution;
use crate::ir::{Function, Pos, Tilt, Tilting};
use crate::lexer::klartext::{QKind, QRef, Value};
use crate::machine::{Axis, AxisSet};
use crate::parser::klartext::ast::{Addr, Block, PathFn};
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::text::Loc;

use super::known::Known;
use super::path::Motion;
use super::transformation::Transformation;
use super::vars::Slot;
use super::words::{Admits, Words};
use super::{Outcome, Reported, Run};

/// How the tool stands against the workpiece.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
enum Stand {
    /// Nothing is tilted.
    #[default]
    Upright,
    /// A plane is defined, and the rotary axes are not known to stand in it.
    Waits(Tilt),
    In(Tilt),
    /// The block at this place has ended the plane, and the rotary axes stand as it had them.
    Left(Loc),
}

/// The tilted plane, and what was in force before it.
#[derive(Debug, Clone, Default)]
pub(super) struct TiltState {
    stand: Stand,
    /// The datum shift from before the plane, which goes on behind it.
    before: Option<Transformation>,
    /// Rotary axes that the program turned into the plane by name.
    turned: AxisSet,
    /// A shift was reset under another plane than it was set in: until it and the plane are both gone, its effect is open.
    open_shift: bool,
    /// That moves are barred was said.
    said: bool,
}

impl TiltState {
    /// Has a plane ended under axes that stay?
    pub fn is_left(&self) -> bool {
        matches!(self.stand, Stand::Left(_))
    }

    /// Is nothing tilted, and do the rotary axes stand as at the start?
    pub fn is_upright(&self) -> bool {
        self.stand == Stand::Upright
    }

    /// The plane that is defined, whether the axes stand in it or not.
    pub fn plane(&self) -> Option<&Tilt> {
        match &self.stand {
            Stand::Waits(tilt) | Stand::In(tilt) => Some(tilt),
            Stand::Upright | Stand::Left(_) => None,
        }
    }

    /// Does a block of Q120 to Q122 turn the axes into the plane now, or back?
    fn turns_by_name(&self) -> bool {
        matches!(self.stand, Stand::Waits(_) | Stand::Left(_))
    }

    /// May no main axis move by coordinates of the program?
    #[inline]
    pub fn bars(&self) -> bool {
        self.open_shift || matches!(self.stand, Stand::Waits(_) | Stand::Left(_))
    }

    fn why(&self) -> Fault {
        match self.stand {
            Stand::Waits(_) => codes::K2857::axes_do_not_stand_in_plane(),
            Stand::Left(since) => codes::P2042::plane_is_off_and_rotary_axes_stay(&since.line),
            Stand::Upright | Stand::In(_) => codes::K2852::shift_and_plane_are_not_both_reset(),
        }
    }

    /// May the program move a rotary axis by a number?
    pub fn admits_rotary(&self, axis: Axis) -> Result<(), Fault> {
        match self.stand {
            Stand::Upright => Ok(()),
            Stand::Left(_) => Err(codes::K2857::which_axes_turned_is_not_known()),
            Stand::Waits(_) | Stand::In(_) => Err(codes::P2043::rotary_axis_moves_in_tilted_plane(&axis.letter())),
        }
    }

    /// A datum shift is set: before the plane, in it, or reset while the plane is on.
    pub fn shifts(&mut self, next: &Transformation) -> Result<(), Fault> {
        let nothing = |transform: &Transformation| transform.shift.iter().all(|v| *v == 0.0);
        let before = self.before.as_ref().is_some_and(|before| !nothing(before));
        if self.plane().is_some() && before {
            if !nothing(next) {
                return Err(codes::K2852::datum_is_shifted_in_plane_and_before());
            }
            self.before = Some(Transformation::none(next.mirror_last));
            self.open_shift = true;
        } else if self.open_shift && nothing(next) && self.plane().is_none() {
            self.open_shift = false;
        }
        Ok(())
    }
}

/// How the rotary axes get into a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Positioning {
    Stay,
    Turn,
}

impl Run<'_> {
    /// The working plane lies along the columns of `axes` from here on, about the datum in force.
    pub(super) fn tilt_into(
        &mut self,
        axes: Matrix3<f64>,
        solution: Solution,
        positioning: Positioning,
        place: Where,
    ) -> Outcome {
        if let Err(fault) = self.may_tilt() {
            return self.st.refuse_motion(&mut self.core, place, fault);
        }
        let now = self.st.frames.transform().clone();
        let origin = match &self.st.tilt.before {
            Some(before) if !self.st.tilt.is_upright() => shift_of(before),
            _ => {
                let mut before = now.clone();
                before.turn = Deg(0.0);
                self.st.tilt.before = Some(before);
                shift_of(&now)
            }
        };
        let tilt = Tilt { axes, origin, solution };
        self.st.tilt.stand = Stand::Waits(tilt);
        self.st.tilt.said = false;
        self.put_angles();
        self.set_transformation(Transformation::none(now.mirror_last))?;
        self.leave_plane();
        if positioning == Positioning::Turn {
            self.st.tilt.turned = AxisSet::EMPTY;
            self.arrive();
        }
        Ok(())
    }

    /// The plane ends; the rotary axes stay or turn back, and the plane is turned about Z by `turn` degrees then.
    pub(super) fn tilt_back(&mut self, turn: f64, positioning: Positioning, place: Where) -> Outcome {
        let now = self.st.frames.transform();
        if !now.is_shift_only() {
            let fault = codes::K2852::plane_ends_before_what_was_set_in_it();
            return self.st.refuse_motion(&mut self.core, place, fault);
        }
        if turn != 0.0 && positioning == Positioning::Stay {
            let fault = codes::K2857::plane_about_z_needs_turn();
            return self.st.refuse_motion(&mut self.core, place, fault);
        }
        let in_plane = self.st.tilt.plane().is_some() && now.shift.iter().any(|v| *v != 0.0);
        let mut next = self.st.tilt.before.take().unwrap_or_else(|| Transformation::none(now.mirror_last));
        if in_plane {
            // It has to be reset right behind the plane.
            self.st.tilt.open_shift = true;
            next.shift = now.shift;
        } else if next.shift.iter().all(|v| *v == 0.0) {
            self.st.tilt.open_shift = false;
        }
        next.turn = Deg(turn);
        let was_in = matches!(self.st.tilt.stand, Stand::In(_) | Stand::Left(_));
        self.st.tilt.said = false;
        self.st.tilt.stand = match positioning {
            Positioning::Turn => Stand::Upright,
            Positioning::Stay if was_in => Stand::Left(self.core.here.origin.loc),
            Positioning::Stay => Stand::Upright,
        };
        match positioning {
            Positioning::Turn => self.turn_back(),
            Positioning::Stay if was_in => self.function(Function::Tilt(Box::new(Tilting::Off))),
            Positioning::Stay => {}
        }
        self.put_angles();
        self.set_transformation(next)?;
        self.leave_plane();
        Ok(())
    }

    fn turn_back(&mut self) {
        self.st.tilt.stand = Stand::Upright;
        self.st.tilt.turned = AxisSet::EMPTY;
        self.function(Function::Tilt(Box::new(Tilting::Back(Solution::Control))));
    }

    /// The rotary axes stand in the plane that was defined.
    fn arrive(&mut self) {
        if let Stand::Waits(tilt) = self.st.tilt.stand {
            self.st.tilt.stand = Stand::In(tilt);
            self.function(Function::Tilt(Box::new(Tilting::Into(tilt))));
        }
    }

    /// No main axis stands where it did in the coordinates of before.
    fn leave_plane(&mut self) {
        let here = self.core.here.origin.loc;
        self.st.position.forget_tip(AxisSet::MAIN, By::Tilt, here);
        self.st.polar.forget_last();
        self.st.polar.lose_pole();
    }

    /// What Q120 to Q122 hold is known at the machine.
    fn put_angles(&mut self) {
        let here = self.core.here.origin.loc;
        for number in ANGLES {
            let q = QRef { kind: QKind::Q, number };
            self.vars.put(&mut self.core, q, Slot::AtMachine(here));
        }
    }

    /// What has to hold before a plane is tilted.
    fn may_tilt(&mut self) -> Result<(), Fault> {
        if self.st.axis() != Axis::Z {
            return Err(codes::K9004::tilts_under_another_tool_axis(&self.st.axis().letter()));
        }
        if let Some(label) = &self.st.described {
            return Err(codes::K2951::stands_in_contour(&"PLANE", &label));
        }
        if self.st.compensation.is_on() {
            return Err(codes::K2606::while_radius_compensation(&"the working plane tilts"));
        }
        if self.st.rotary.follows_tip {
            return Err(codes::K2857::plane_tilts_under_m128());
        }
        let now = self.st.frames.transform();
        if self.st.tilt.plane().is_some() {
            return if now.is_none() { Ok(()) } else { Err(codes::K2852::plane_ends_before_what_was_set_in_it()) };
        }
        let rotary = now.shift[3..].iter().any(|v| *v != 0.0);
        let turned = now.turn.0 != 0.0 && now.shifted_in_turn && now.is_shifted_in_plane();
        if !now.is_shift_only() || now.is_turned_as_a_whole() || rotary || turned {
            return Err(codes::K2852::only_shift_may_stand_before_plane());
        }
        Ok(())
    }

    /// `L A+Q120 C+Q122 R0 FMAX`: the rotary axes go where the plane that STAY defined wants them. False for another block.
    pub(super) fn turns_into_plane(&mut self, block: &Block) -> Outcome<bool> {
        if !self.st.tilt.turns_by_name() {
            return Ok(false);
        }
        let mut axes = AxisSet::EMPTY;
        for word in &block.words {
            match (word.addr, word.value) {
                (Addr::Axis { axis, incremental: false }, Value::Param { negative: false, q })
                    if is_angle_of(axis, q) =>
                {
                    axes.insert(axis);
                }
                (Addr::Axis { .. }, _) => return Ok(false),
                _ => {}
            }
        }
        if axes.is_empty() {
            return Ok(false);
        }
        // The rest of the block acts as it does without its axes.
        let mut rest = block.clone();
        rest.words.retain(|word| !matches!(word.addr, Addr::Axis { .. }));
        let words = self.gather(&rest, "L", Admits::PATH)?;
        self.run_motion(Motion::Programmed(PathFn::Line), &words)?;
        if self.core.has_ended() {
            return Err(Reported);
        }
        self.contours.roughed = Known::Nothing;
        match self.st.tilt.stand {
            Stand::Left(_) => {
                self.turn_back();
                self.leave_plane();
            }
            _ => {
                self.st.tilt.turned = axes;
                self.arrive();
            }
        }
        Ok(true)
    }

    /// `L A+0 C+0 R0 FMAX` behind a plane that ended: where each axis that the program named in the plane has gone back to 0, they all
    /// turn back. What is left of the end point is given back.
    pub(super) fn turns_back_by_numbers(&mut self, w: &Words, mut end: Pos) -> Outcome<Pos> {
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
    pub(super) fn is_barred(&mut self, mv: &Move) -> bool {
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

/// Axis angles of a plane: A, B and C.
const ANGLES: core::ops::RangeInclusive<u32> = 120..=122;

/// Q120 for A, Q121 for B, Q122 for C.
fn is_angle_of(axis: Axis, q: QRef) -> bool {
    axis.is_rotary()
        && q.kind == QKind::Q
        && ANGLES.contains(&q.number)
        && axis.index() - Axis::A.index() == (q.number - ANGLES.start()) as usize
}

fn shift_of(transform: &Transformation) -> Vector3<f64> {
    Vector3::new(transform.shift[0], transform.shift[1], transform.shift[2])
}

/// The angle about Z, in degrees, of a plane that is not tilted.
pub(super) fn upright(axes: &Matrix3<f64>) -> Option<f64> {
    let tilted = libm::hypot(axes[(0, 2)], axes[(1, 2)]) > tolerance::LOST || axes[(2, 2)] < 0.0;
    (!tilted).then(|| Deg::of(Vec2::new(axes[(0, 0)], axes[(1, 0)])).0)
}
