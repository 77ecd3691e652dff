//! Cycles 7, 8, 10, 11, 19, 26, 247 and the TRANS functions: what they do to the coordinate system.
//!
//! Source: reference section 3.

use crate::diag::{Diagnostic, codes};
use crate::geo::Deg;
use crate::ir::{Function, Side};
use crate::machine::{AxisSet, ShiftAxes};
use crate::parser::klartext::ast::{Addr, Block, Transform};
use crate::text::Span;

use super::cycle::{AxisValue, Open};
use super::transform::Transformation;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    /// Puts a new transformation in force; the tool stays where it is.
    pub(super) fn set_transformation(&mut self, transform: Transformation) -> Outcome {
        self.st.transform = transform;
        let span = self.block_span();
        self.update_frame(span)
    }

    /// Makes the frame follow the transformation and the length oversize.
    pub(super) fn update_frame(&mut self, span: Span) -> Outcome {
        use crate::ir::contour::Ctx;
        let lift = self.st.tool.as_ref().map_or(0.0, |tool| tool.call_deltas[0]);
        let axis = self.st.axis();
        let Some(frame) = self.st.transform.frame(axis, lift) else {
            return self.fail(codes::K2403, span, "the transformations together have no result");
        };
        let plane = self.st.plane();
        if frame == self.st.ctx.frame && plane == self.st.ctx.plane {
            return Ok(());
        }
        if lift != 0.0 {
            self.job.diags.push_once(Diagnostic::new(
                codes::K2011,
                self.here.origin.loc,
                format!("the length oversize DL {lift} mm is added to {}", axis.letter()),
            ));
        }
        if frame != self.st.ctx.frame {
            let at = self.st.ctx.frame.apply(&self.st.pos);
            self.st.pos = frame.unapply(&at);
            self.st.polar = None;
            self.st.system += 1;
        }
        self.st.ctx = std::rc::Rc::new(Ctx { plane, frame });
        Ok(())
    }

    pub(super) fn shift_cycle(&mut self, open: &Open) -> Outcome {
        if open.table_row {
            self.error(codes::K9012, "a datum shift from a table needs the table of the control");
            return Err(Reported);
        }
        if open.axes.is_empty() {
            self.error(codes::K2402, "cycle 7 names no axis");
            return Err(Reported);
        }
        self.shift(&open.axes)
    }

    /// Datum shift: axes that are not named keep theirs.
    pub(super) fn shift(&mut self, axes: &[AxisValue]) -> Outcome {
        let mm = self.level().unit.mm();
        let mut next = self.st.transform.clone();
        for axis in axes {
            let Some(value) = axis.value else {
                self.error(codes::K2402, format!("the shift of {} lacks its value", axis.axis.letter()));
                return Err(Reported);
            };
            let value = if axis.axis.is_rotary() { value } else { value * mm };
            let shift = &mut next.shift[axis.axis.index()];
            *shift = if axis.incremental { *shift + value } else { value };
        }
        let now = &self.st.transform;
        let changes = AxisSet::MAIN.iter().any(|axis| now.shift[axis.index()] != next.shift[axis.index()]);
        let clears = AxisSet::MAIN.iter().all(|axis| next.shift[axis.index()] == 0.0);
        if changes && !clears && !now.is_shift_only() {
            match self.job.settings.control.shift_axes {
                ShiftAxes::Original => self.report(
                    Diagnostic::new(
                        codes::K2501,
                        self.here.origin.loc,
                        "the datum shift is measured along the original axes, although they are turned, mirrored or scaled",
                    )
                    .help("reset the other transformations first, or set `[control] shift_axes`"),
                ),
                ShiftAxes::Transformed => turn_shift(&mut next),
            }
        }
        self.set_transformation(next)
    }

    pub(super) fn mirror(&mut self, axes: AxisSet) -> Outcome {
        if !axes.without(AxisSet::MAIN).is_empty() {
            self.error(codes::K2403, "only X, Y and Z can be mirrored");
            return Err(Reported);
        }
        if axes.contains(self.st.axis()) {
            let axis = self.st.axis().letter();
            self.report(
                Diagnostic::new(codes::K2503, self.here.origin.loc, format!("the tool axis {axis} is mirrored"))
                    .help("check that this is meant"),
            );
        }
        let mut next = self.st.transform.clone();
        next.mirror = axes;
        self.set_transformation(next)
    }

    pub(super) fn rotate(&mut self, angle: f64, incremental: bool) -> Outcome {
        if self.st.side != Side::None {
            self.report(
                Diagnostic::new(codes::K2603, self.here.origin.loc, "the rotation ends the radius compensation")
                    .help("program a block with R0 first"),
            );
            self.st.side = Side::None;
        }
        let mut next = self.st.transform.clone();
        next.angle = Deg(if incremental { next.angle.0 + angle } else { angle });
        if next.angle.normal().0 == 0.0 {
            next.angle = Deg(0.0);
        }
        next.plane = self.st.plane();
        self.set_transformation(next)
    }

    pub(super) fn check_factor(&mut self, factor: f64) -> Outcome {
        if (0.000_001..=99.999_999).contains(&factor) {
            return Ok(());
        }
        self.error(codes::K2403, format!("a scaling factor of {factor} is out of range (0.000001 to 99.999999)"));
        Err(Reported)
    }

    pub(super) fn scale(&mut self, factor: f64) -> Outcome {
        self.check_factor(factor)?;
        let in_plane = self.job.settings.control.scaling_in_plane;
        if factor != 1.0 && !in_plane {
            self.job.diags.push_once(
                Diagnostic::new(codes::K2507, self.here.origin.loc, "the scaling acts on the tool axis, too")
                    .help("if MP 7410 limits it to the plane, set `[control] scaling = \"plane\"`"),
            );
        }
        let mut next = self.st.transform.clone();
        next.scale = factor;
        next.unscaled = in_plane.then_some(self.st.axis());
        self.set_transformation(next)
    }

    /// Cycle 26.
    pub(super) fn scale_axes(&mut self, open: &Open) -> Outcome {
        let mm = self.level().unit.mm();
        let mut next = self.st.transform.clone();
        for axis in &open.axes {
            let (true, Some(factor)) = (axis.axis.is_main(), axis.value) else {
                self.error(codes::K2403, format!("{} cannot be scaled", axis.axis.letter()));
                return Err(Reported);
            };
            self.check_factor(factor)?;
            next.axis_scale[axis.axis.index()] = factor;
        }
        next.scale_center = [0.0; 3];
        for (label, value) in &open.values {
            let axis = match label.as_str() {
                "CCX" => 0,
                "CCY" => 1,
                "CCZ" => 2,
                _ => {
                    self.error(codes::K2402, format!("`{label}` is no word of cycle 26"));
                    return Err(Reported);
                }
            };
            next.scale_center[axis] = value * mm;
        }
        self.set_transformation(next)
    }

    /// Cycle 19: only its reset can be compiled.
    pub(super) fn tilt(&mut self, open: &Open) -> Outcome {
        if open.axes.iter().all(|axis| axis.value.unwrap_or(0.0) == 0.0) {
            for number in 120..=122 {
                self.set_control_parameter(number, 0.0);
            }
            return Ok(());
        }
        self.error(codes::K9004, "cycle 19 tilts the working plane, which cannot be compiled for three axes");
        Err(Reported)
    }

    /// Cycle 247: a row of the preset table becomes a work offset.
    pub(super) fn preset(&mut self, open: &Open) -> Outcome {
        let Some(&(_, number)) = open.parameters.iter().find(|(q, _)| *q == 339) else {
            self.error(codes::K2402, "cycle 247 lacks the preset number Q339");
            return Err(Reported);
        };
        let row = (number >= 0.0 && number.fract() == 0.0).then_some(number as u32);
        let configured = row.and_then(|row| self.job.settings.datums.presets.get(&row).copied());
        let offset = configured.or(row.filter(|row| (1..=9).contains(row)).map(|row| row as u8));
        let Some(offset) = offset else {
            self.report(
                Diagnostic::new(codes::K2505, self.here.origin.loc, format!("preset {number} has no work offset"))
                    .help(format!("name one in partc.toml: `[datums]` with `preset.{number} = \"G54\"`")),
            );
            return Err(Reported);
        };
        if configured.is_none() {
            self.report(Diagnostic::new(
                codes::K2504,
                self.here.origin.loc,
                format!("preset {number} is printed as work offset {offset} ({})", offset_word(offset)),
            ));
        }
        self.function(Function::WorkOffset(offset));
        self.set_transformation(Transformation::default())?;
        // In the new system no axis has a known position.
        self.st.pos = crate::ir::Pos::UNKNOWN;
        self.st.lost = AxisSet::EMPTY;
        self.st.polar = None;
        self.st.system += 1;
        Ok(())
    }

    /// TRANS DATUM, TRANS MIRROR, TRANS ROTATION, TRANS SCALE.
    pub(super) fn transform_block(&mut self, kind: Transform, block: &Block, text: &[u8]) -> Outcome {
        let mut axes = Vec::new();
        let mut value = None;
        let mut incremental = false;
        let mut label = Vec::new();
        for &word in &block.words {
            match word.addr {
                Addr::Name => {
                    let name = word.span.of(text).to_ascii_uppercase();
                    match name.as_slice() {
                        b"RESET" => return self.reset_transform(kind),
                        b"TABLE" | b"TABLINE" => {
                            return self.fail(codes::K9012, word.span, "datum tables are not supported");
                        }
                        _ => label = name,
                    }
                }
                Addr::Axis { axis, incremental } => {
                    let value = self.number_if(word.value, word.span)?;
                    axes.push(AxisValue { axis, incremental, value });
                }
                Addr::Value => {
                    incremental = label == b"IROT";
                    value = Some(self.number(word.value, word.span)?);
                }
                _ => return self.not_admitted(word, "TRANS"),
            }
        }
        match (kind, value) {
            (Transform::Datum, None) if !axes.is_empty() => self.shift(&axes),
            (Transform::Mirror, None) if !axes.is_empty() => self.mirror(axes.iter().map(|axis| axis.axis).collect()),
            (Transform::Rotation, Some(angle)) => self.rotate(angle, incremental),
            (Transform::Scale, Some(factor)) => self.scale(factor),
            _ => self.fail(codes::K2402, block.span, "this TRANS block lacks its values"),
        }
    }

    pub(super) fn reset_transform(&mut self, kind: Transform) -> Outcome {
        let mut next = self.st.transform.clone();
        let none = Transformation::default();
        match kind {
            Transform::Datum => next.shift = none.shift,
            Transform::Mirror => next.mirror = none.mirror,
            Transform::Rotation => next.angle = none.angle,
            Transform::Scale => {
                next.scale = none.scale;
                next.unscaled = none.unscaled;
            }
        }
        self.set_transformation(next)
    }
}

/// A shift measured along the turned and mirrored axes.
fn turn_shift(next: &mut Transformation) {
    let unscaled = Transformation { scale: 1.0, axis_scale: [1.0; 3], ..next.clone() };
    let v = unscaled.linear() * nalgebra::Vector3::new(next.shift[0], next.shift[1], next.shift[2]);
    next.shift[..3].copy_from_slice(v.as_slice());
}

fn offset_word(offset: u8) -> &'static str {
    ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"].get(offset as usize - 1).unwrap_or(&"G54")
}
