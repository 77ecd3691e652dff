//! Shifts of the workpiece zero: G51, G56, G59.
//!
//! The output counts from the workpiece zero of the first G59, or from the one that is set at the machine. Only shifts
//! along Z are compiled: whether X of a shift is a diameter no available manual says.

use std::rc::Rc;

use nalgebra::Matrix3;

use crate::diag::codes;
use crate::ir::Frame;
use crate::ir::contour::Ctx;
use crate::machine::axis::AXES;
use crate::machine::{Axis, Compensation};

use super::chain::Coord;
use super::g_functions::Kind;
use super::words::Words;
use super::{Outcome, Run};

impl Run<'_> {
    pub(super) fn shift(&mut self, kind: Kind, w: &Words) -> Outcome {
        if let Some(num) = w.get(b'X').filter(|num| num.value != 0.0 || num.unknown || num.incremental) {
            return self.core.refuse(num.span, codes::T2016::zero_shift_in_x_is_not_supported());
        }
        let z = match self.coord(w.get(b'Z'), Axis::Z) {
            Coord::At(z) => z,
            Coord::Stay if kind != Kind::ShiftAbsolute => 0.0,
            _ => return self.core.refuse(self.core.block_span(), codes::P1004::shift_needs_absolute_z()),
        };
        if self.st.compensation.is_on() && self.core.job.settings.output.compensation == Compensation::Resolve {
            return self
                .core
                .refuse(self.core.block_span(), codes::T2021::workpiece_zero_shifts_under_nose_radius_compensation());
        }
        let mut shift = self.st.shift;
        match kind {
            Kind::ShiftRelative => shift.relative = z,
            Kind::ShiftAdditive => shift.additive += z,
            _ => {
                if shift.base.is_none() {
                    if self.st.moved {
                        return self
                            .core
                            .refuse(self.core.block_span(), codes::T2016::g59_moves_workpiece_zero_that_program());
                    }
                    if !self.st.position.start().known().is_empty() {
                        return self
                            .core
                            .refuse(self.core.block_span(), codes::T2016::g59_moves_workpiece_zero_that_positions());
                    }
                    shift.base = Some(z);
                    let fault = codes::T2015::coordinates_count_from_workpiece_zero_of_g59(&z);
                    self.core.job.diags.push_once(fault.at(self.core.here.origin.loc));
                }
                if shift.relative != 0.0 || shift.additive != 0.0 {
                    return self.core.refuse(self.core.block_span(), codes::T2016::whether_g59_ends_shifts_of_g51());
                }
                shift.absolute = Some(z);
            }
        }
        self.st.shift = shift;
        self.enter_frame(shift.total())
    }

    /// The workpiece zero lies at `z` now; the tool stays where it is.
    fn enter_frame(&mut self, z: f64) -> Outcome {
        let mut values = [0.0; AXES];
        values[Axis::Z.index()] = z;
        let Some(frame) = Frame::new(Matrix3::identity(), values) else {
            return self.core.refuse(self.core.block_span(), codes::T1007::shift_is_no_number());
        };
        self.st.position.through_frame(&self.st.ctx.frame, &frame);
        self.st.last = None;
        self.st.ctx = Rc::new(Ctx { frame, ..(*self.st.ctx).clone() });
        Ok(())
    }
}
