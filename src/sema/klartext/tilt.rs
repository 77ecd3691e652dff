//! Tilted working planes: PLANE and cycle 19 define one, or end it.
//!
//! Source: K 3.4; M 2 (docs/sources.md). A plane is defined first, and reached by TURN, or by the block of rotary axes that
//! follows STAY. The output leaves it to the machine which of its axes turn.

use nalgebra::{Matrix3, Vector3};

use crate::diag::{Fault, codes};
use crate::geo::{Deg, Vec2, tolerance};
use crate::ir::tilt::Solution;
use crate::ir::{Function, Tilt, Tilting};
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::{Axis, AxisSet};
use crate::sema::run::Where;

use super::tilt_state::{ANGLES, Stand};
use super::transformation::Transformation;
use super::vars::Slot;
use super::{Outcome, Run};

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
}

fn shift_of(transform: &Transformation) -> Vector3<f64> {
    Vector3::new(transform.shift[0], transform.shift[1], transform.shift[2])
}

/// The angle about Z, in degrees, of a plane that is not tilted.
pub(super) fn upright(axes: &Matrix3<f64>) -> Option<f64> {
    let tilted = libm::hypot(axes[(0, 2)], axes[(1, 2)]) > tolerance::LOST || axes[(2, 2)] < 0.0;
    (!tilted).then(|| Deg::of(Vec2::new(axes[(0, 0)], axes[(1, 0)])).0)
}
