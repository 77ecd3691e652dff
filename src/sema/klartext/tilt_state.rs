//! How the tool stands against the workpiece, as planes have it, and what that forbids.
//!
//! Source: K 3.4; M 2 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::ir::Tilt;
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::{Axis, AxisSet};
use crate::text::Loc;

use super::transformation::Transformation;

/// How the tool stands against the workpiece.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) enum Stand {
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
    pub stand: Stand,
    /// The datum shift from before the plane, which goes on behind it.
    pub before: Option<Transformation>,
    /// Rotary axes that the program turned into the plane by name.
    pub turned: AxisSet,
    /// A shift was reset under another plane than it was set in: until it and the plane are both gone, its effect is open.
    pub open_shift: bool,
    /// That moves are barred was said.
    pub said: bool,
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
    pub fn turns_by_name(&self) -> bool {
        matches!(self.stand, Stand::Waits(_) | Stand::Left(_))
    }

    /// May no main axis move by coordinates of the program?
    #[inline]
    pub fn bars(&self) -> bool {
        self.open_shift || matches!(self.stand, Stand::Waits(_) | Stand::Left(_))
    }

    pub fn why(&self) -> Fault {
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

/// Axis angles of a plane: A, B and C.
pub(super) const ANGLES: core::ops::RangeInclusive<u32> = 120..=122;

/// Q120 for A, Q121 for B, Q122 for C.
pub(super) fn is_angle_of(axis: Axis, q: QRef) -> bool {
    axis.is_rotary()
        && q.kind == QKind::Q
        && ANGLES.contains(&q.number)
        && axis.index() - Axis::A.index() == (q.number - ANGLES.start()) as usize
}
