//! Shifts of the workpiece zero: G51, G56, G59.
//!
//! The output counts from the workpiece zero of the first G59, or from the one that is set at the machine. Only shifts
//! along Z are compiled: whether X of a shift is a diameter no available manual says.

use nalgebra::Matrix3;

use crate::diag::{Fault, codes};
use crate::ir::Frame;
use crate::machine::Axis;
use crate::machine::axis::AXES;
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};

use super::chain::Coord;
use super::words::Words;

/// What a shift counts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ShiftOf {
    /// G51.
    Relative,
    /// G56.
    Additive,
    /// G59.
    Absolute,
}

/// Shifts of the workpiece zero along Z in mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Shift {
    /// First G59, from which the output counts.
    pub base: Option<f64>,
    /// Last G59.
    absolute: Option<f64>,
    /// G51.
    relative: f64,
    /// Sum of G56.
    additive: f64,
}

impl Shift {
    pub fn total(&self) -> f64 {
        let absolute = self.absolute.unwrap_or(0.0) - self.base.unwrap_or(0.0);
        absolute + self.relative + self.additive
    }

    /// The shifts behind G51, G56 or G59 with this Z. `counted`: why the workpiece zero may not move under what counts from it.
    pub fn after(self, kind: ShiftOf, z: f64, counted: Option<fn() -> Fault>) -> Result<Shift, Fault> {
        match (kind, self.base, counted) {
            (ShiftOf::Relative, ..) => Ok(Shift { relative: z, ..self }),
            (ShiftOf::Additive, ..) => Ok(Shift { additive: self.additive + z, ..self }),
            (_, None, Some(fault)) => Err(fault()),
            _ => Ok(Shift { base: self.base.or(Some(z)), absolute: Some(z), ..self }),
        }
    }

    /// A shift of G51 or G56 is in force.
    pub fn is_added(&self) -> bool {
        self.relative != 0.0 || self.additive != 0.0
    }

    pub fn frame(&self) -> Option<Frame> {
        let mut values = [0.0; AXES];
        values[Axis::Z.index()] = self.total();
        Frame::new(Matrix3::identity(), values)
    }
}

impl Words {
    /// Z of a shift in mm.
    pub(super) fn shift(&self, kind: ShiftOf, mm: f64) -> Made<f64> {
        if let Some(num) = self.get(b'X').filter(|num| num.value != 0.0 || num.unknown || num.incremental) {
            return refused(num.span, codes::T2016::zero_shift_in_x_is_not_supported());
        }
        match self.coord(Axis::Z, mm) {
            Coord::At(z) => Ok(z),
            Coord::Stay if kind != ShiftOf::Absolute => Ok(0.0),
            _ => refused(Where::Block, codes::P1004::shift_needs_absolute_z()),
        }
    }
}
