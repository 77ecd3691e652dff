//! Shifts of the workpiece zero: G51, G56, G59.
//!
//! The output counts from the workpiece zero of the first G59, or from the one that is set at the machine. Only shifts
//! along Z are compiled: whether X of a shift is a diameter no manual at hand says.

use std::rc::Rc;

use nalgebra::Matrix3;

use crate::diag::{Diagnostic, codes};
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
            return self.fail_help(
                codes::T2016,
                num.span,
                "a zero shift in X is not supported: the manuals do not say whether it counts in diameters",
                "leave out X, or take the shift into the coordinates",
            );
        }
        let z = match self.coord(w.get(b'Z'), Axis::Z) {
            Coord::At(z) => z,
            Coord::Stay if kind != Kind::ShiftAbsolute => 0.0,
            _ => return self.fail(codes::T1005, self.block_span(), "the shift needs an absolute Z"),
        };
        if self.st.compensation.is_on() && self.job.settings.output.compensation == Compensation::Resolve {
            return self.fail_help(
                codes::T2021,
                self.block_span(),
                "the workpiece zero shifts under nose radius compensation",
                "program G40 with a straight move before the shift",
            );
        }
        let mut shift = self.st.shift;
        match kind {
            Kind::ShiftRelative => shift.relative = z,
            Kind::ShiftAdditive => shift.additive += z,
            _ => {
                if shift.base.is_none() {
                    if self.st.moved {
                        return self.fail_help(
                            codes::T2016,
                            self.block_span(),
                            "G59 moves a workpiece zero that the program has used already, by an amount that only the machine knows",
                            "program G59 before the first move, too",
                        );
                    }
                    if !self.st.position.start().known().is_empty() {
                        return self.fail_help(
                            codes::T2016,
                            self.block_span(),
                            "G59 moves the workpiece zero that the positions of `[start]` count from, by an amount that only the machine knows",
                            "leave `[start]` out of partc.toml, and begin the program with absolute positions",
                        );
                    }
                    shift.base = Some(z);
                    let message =
                        format!("coordinates count from the workpiece zero of G59, {z} mm in front of the chuck");
                    let found = Diagnostic::new(codes::T2015, self.here.origin.loc, message);
                    self.job.diags.push_once(found.help("set the work offset of the target there"));
                }
                if shift.relative != 0.0 || shift.additive != 0.0 {
                    return self.fail_help(
                        codes::T2016,
                        self.block_span(),
                        "whether G59 ends the shifts of G51 and G56 no manual at hand says",
                        "program `G51 Z0` first, and take the sum of G56 back",
                    );
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
            return self.fail(codes::T1007, self.block_span(), "the shift is no number");
        };
        self.st.position.through_frame(&self.st.ctx.frame, &frame);
        self.st.last = None;
        self.st.ctx = Rc::new(Ctx { frame, ..(*self.st.ctx).clone() });
        Ok(())
    }
}
