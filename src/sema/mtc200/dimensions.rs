//! What the numbers of axis words count: unit, diameters, increments; where a rotary axis goes.
//!
//! Source: M 5, 6.3 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::geo::Deg;
use crate::machine::{Axis, Unit};

/// Half turns closer than this to 180° have no certain direction.
const HALF_TURN: f64 = 1e-9;

/// How words of axes and lengths count.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Dimensions {
    /// G70.
    pub inch: bool,
    /// G16.
    pub diameter: bool,
    /// G91.
    pub incremental: bool,
    /// G90 or G91 was programmed.
    pub said: bool,
}

impl Dimensions {
    /// Millimetres in one programmed unit.
    pub fn unit(self) -> f64 {
        if self.inch { Unit::Inch.mm() } else { Unit::Mm.mm() }
    }

    /// A length along a main axis in mm (X: radius), as written in a block.
    #[inline]
    pub fn main_length(self, axis: Axis, value: f64) -> f64 {
        let length = value * self.unit();
        if axis == Axis::X && self.diameter { length / 2.0 } else { length }
    }

    /// The same of any axis; degrees of a rotary one.
    #[inline]
    pub fn length(self, axis: Axis, value: f64) -> Result<f64, Fault> {
        if axis.is_main() {
            return Ok(self.main_length(axis, value));
        }
        if axis.is_rotary() || !self.inch {
            return Ok(value);
        }
        Err(codes::M9008::may_mean_inches_or_degrees_here(&axis.letter()))
    }

    /// A length that is never a diameter.
    pub fn radius_length(self, axis: Axis, value: f64) -> Result<f64, Fault> {
        Dimensions { diameter: false, ..self }.length(axis, value)
    }
}

/// Where a rotary axis that stands at `from` goes in unbroken degrees: the short way to `value`.
pub(super) fn rotary_target(axis: Axis, value: f64, from: Option<f64>) -> Result<f64, Fault> {
    let letter = axis.letter();
    if value.abs() > 360.0 {
        return Err(codes::M2017::is_more_than_turn(&letter, &value));
    }
    let Some(from) = from else { return Ok(value) };
    let ahead = Deg(value - from).normal().0;
    if (ahead - 180.0).abs() <= HALF_TURN {
        return Err(codes::M2017::moves_exactly_half_turn(&letter));
    }
    Ok(from + if ahead > 180.0 { ahead - 360.0 } else { ahead })
}
