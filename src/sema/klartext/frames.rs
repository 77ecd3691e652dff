//! Cycles 7, 8, 10, 11, 19, 26, 247 and the TRANS functions: what they do to the coordinate system.
//!
//! Source: K 3 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::Function;
use crate::lexer::klartext::Value;
use crate::machine::{AxisSet, ShiftAxes};
use crate::parser::klartext::ast::{Addr, Block, Transform};
use crate::sema::run::{OffsetName, Where};
use crate::text::{Loc, Span};

use super::cycle_definition::{AxisValue, Open};
use super::known::Known;
use super::transformation::Transformation;
use super::{Outcome, Reported, Run};

/// The transformation in force, and the input systems that it made.
#[derive(Debug, Clone)]
pub(super) struct FrameState {
    transform: Transformation,
    /// Counts changes of the input system.
    system: u32,
    /// Cycle 247 selected a preset.
    preset_selected: bool,
    /// The row that it selected last.
    row: Option<u32>,
    /// A touch probe cycle that is left out, after which a basic rotation may be in force that nobody here knows.
    probed: Option<Loc>,
}

impl FrameState {
    pub fn new(transform: Transformation) -> FrameState {
        FrameState { transform, system: 0, preset_selected: false, row: None, probed: None }
    }

    pub fn transform(&self) -> &Transformation {
        &self.transform
    }

    /// The row of the preset table that the program selected last.
    pub fn preset_row(&self) -> Option<u32> {
        self.row
    }

    /// The cycle at `loc` is left out, and may turn the coordinates.
    pub fn may_be_turned(&mut self, loc: Loc) {
        self.probed = Some(loc);
    }

    /// The last cycle that is left out and may have turned the coordinates.
    pub fn probed(&self) -> Option<Loc> {
        self.probed
    }

    /// Number of the input system: another one after each change.
    pub fn system(&self) -> u32 {
        self.system
    }
}

impl Run<'_> {
    /// Puts a new transformation in force; the tool stays where it is.
    pub(super) fn set_transformation(&mut self, transform: Transformation) -> Outcome {
        self.warn_of_order(&transform);
        self.refuse_compensated("the coordinate system changes");
        self.st.frames.transform = transform;
        let span = self.core.block_span();
        self.update_frame(span)
    }

    /// Warns where `next` mixes transformations whose order no available manual gives.
    fn warn_of_order(&self, next: &Transformation) {
        let now = &self.st.frames.transform;
        let here = self.core.here.origin.loc;
        let turned = now.angle != next.angle || now.plane != next.plane;
        if next.mirror_order_counts() && (turned || now.mirror != next.mirror) {
            let fault =
                if next.mirror_last { codes::K2807::rotation_acts_first() } else { codes::K2807::mirror_acts_first() };
            self.core.report(fault.answer(Answer::key("control", "mirror")).at(here));
        }
        if next.scaling_order_counts() && (turned || now.axis_scale != next.axis_scale) {
            self.core.report(codes::K2807::cycle_26_scales_first().at(here));
        }
        if next.scales_twice() && (now.scale != next.scale || now.axis_scale != next.axis_scale) {
            self.core.report(codes::K2808::cycle_11_scales_first().at(here));
        }
    }

    /// Makes the frame follow the transformation and the length oversize.
    pub(super) fn update_frame(&mut self, span: Span) -> Outcome {
        use crate::ir::contour::Ctx;
        let lift = self.st.tool.active().map_or(0.0, |tool| tool.call_deltas[0]);
        let axis = self.st.axis();
        let Some(frame) = self.st.frames.transform.frame(axis, lift) else {
            return self.core.refuse(span, codes::P2090::transformations_together_are_too_large_or_too());
        };
        if let Some(tool) = self.st.tool.active().filter(|_| lift != 0.0) {
            self.core.job.diags.push_once(
                codes::K2011::length_oversize_dl_mm_of_tool(&lift, &tool.called, &axis.letter()).at(self
                    .core
                    .here
                    .origin
                    .loc),
            );
        }
        let plane = self.st.plane();
        if frame == self.st.ctx.frame && plane == self.st.ctx.plane {
            return Ok(());
        }
        if frame != self.st.ctx.frame {
            self.st.position.through_frame(&self.st.ctx.frame, &frame);
            // Where the nominal position of R+ and R- lies in the new system is not documented.
            self.st.position.forget_beside();
            self.st.polar.forget_last();
            self.st.frames.system += 1;
        }
        self.st.ctx = std::rc::Rc::new(Ctx { plane, frame, compensation: self.st.ctx.compensation.clone() });
        Ok(())
    }

    pub(super) fn shift_cycle(&mut self, open: &Open) -> Outcome {
        if open.table_row {
            return self.shift_by_row(open);
        }
        if open.axes.is_empty() {
            return self.core.refuse(self.core.block_span(), codes::K2402::cycle_7_names_no_axis());
        }
        self.shift(&open.axes)
    }

    /// Datum shift: axes that are not named keep theirs.
    pub(super) fn shift(&mut self, axes: &[AxisValue]) -> Outcome {
        let mm = self.core.level().frame.unit.mm();
        let mut next = self.st.frames.transform.clone();
        let turned = self.core.job.settings.control.shift_axes == ShiftAxes::Transformed;
        for axis in axes {
            let Some(value) = axis.value else {
                self.core.report(codes::K2402::shift_of_lacks_its_value(&axis.axis.letter()).at(axis.loc));
                return Err(Reported);
            };
            let value = if axis.axis.is_rotary() { value } else { value * mm };
            next.shift_by(axis.axis, value, axis.incremental, turned);
        }
        self.check_shift_under_turn(&mut next)?;
        let now = &self.st.frames.transform;
        let changes = AxisSet::MAIN.iter().any(|axis| now.shift[axis.index()] != next.shift[axis.index()]);
        let clears = AxisSet::MAIN.iter().all(|axis| next.shift[axis.index()] == 0.0);
        if changes && !clears && !now.is_shift_only() && !turned {
            self.core.report(
                codes::K2501::datum_shift_is_measured_along_original_axes()
                    .answer(Answer::key("control", "shift_axes"))
                    .at(self.core.here.origin.loc),
            );
        }
        self.set_transformation(next)
    }

    /// A datum shift that came before the turn of the working plane is measured along other axes than one after it.
    fn check_shift_under_turn(&self, next: &mut Transformation) -> Outcome {
        let now = &self.st.frames.transform;
        if now.turn.0 == 0.0 || now.shift[..2] == next.shift[..2] {
            return Ok(());
        }
        if now.is_shifted_in_plane() && !now.shifted_in_turn {
            self.core.say_here(codes::K2852::datum_was_shifted_before_working_plane());
            return Err(Reported);
        }
        next.shifted_in_turn = next.is_shifted_in_plane();
        Ok(())
    }

    pub(super) fn mirror(&mut self, axes: AxisSet) -> Outcome {
        if !axes.without(AxisSet::MAIN).is_empty() {
            return self.core.refuse(self.core.block_span(), codes::P2090::only_x_y());
        }
        if axes.contains(self.st.axis()) {
            let axis = self.st.axis().letter();
            self.core.report(codes::P2030::tool_axis_is_mirrored(&axis).at(self.core.here.origin.loc));
        }
        let mut next = self.st.frames.transform.clone();
        next.mirror = axes;
        self.set_transformation(next)
    }

    pub(super) fn rotate(&mut self, angle: f64, incremental: bool) -> Outcome {
        self.refuse_compensated("the coordinate system turns");
        if self.st.compensation.is_on() {
            self.core.report(codes::P2041::rotation_ends_radius_compensation().at(self.core.here.origin.loc));
            self.st.end_compensation();
        }
        let mut next = self.st.frames.transform.clone();
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
        self.core.refuse(self.core.block_span(), codes::P2090::scaling_factor_of_is_out_of_range(&factor))
    }

    pub(super) fn scale(&mut self, factor: f64) -> Outcome {
        self.check_factor(factor)?;
        let in_plane = self.core.job.settings.control.scaling_in_plane;
        if factor != 1.0 && !in_plane {
            self.core.job.diags.push_once(
                codes::K2507::scaling_acts_on_tool_axis().answer(Answer::key("control", "scaling")).at(self
                    .core
                    .here
                    .origin
                    .loc),
            );
        }
        let mut next = self.st.frames.transform.clone();
        next.scale = factor;
        next.unscaled = in_plane.then_some(self.st.axis());
        self.set_transformation(next)
    }

    /// Cycle 26.
    pub(super) fn scale_axes(&mut self, open: &Open) -> Outcome {
        let mm = self.core.level().frame.unit.mm();
        let mut next = self.st.frames.transform.clone();
        for axis in &open.axes {
            let (true, Some(factor)) = (axis.axis.is_main(), axis.value) else {
                self.core.report(codes::P2090::cannot_be_scaled(&axis.axis.letter()).at(axis.loc));
                return Err(Reported);
            };
            self.check_factor(factor)?;
            next.axis_scale[axis.axis.index()] = factor;
        }
        let kept = next.scale_center;
        next.scale_center = [0.0; 3];
        let mut named = [false; 3];
        for labelled in &open.values {
            let axis = match labelled.label.as_str() {
                "CCX" => 0,
                "CCY" => 1,
                "CCZ" => 2,
                // Other names are refused where they are read.
                _ => continue,
            };
            next.scale_center[axis] = labelled.value * mm;
            named[axis] = true;
        }
        self.other_centers(&mut next, kept, named);
        self.set_transformation(next)
    }

    /// Axes that cycle 26 scales about a centre given before: it goes, or stays.
    fn other_centers(&mut self, next: &mut Transformation, kept: [f64; 3], named: [bool; 3]) {
        let keep = self.core.job.settings.control.klartext_readings.keep_scaling_center;
        for axis in AxisSet::MAIN.iter() {
            let i = axis.index();
            if named[i] || kept[i] == 0.0 || next.axis_scale[i] == 1.0 {
                continue;
            }
            let what = if keep {
                next.scale_center[i] = kept[i];
                "the centre given before"
            } else {
                "the datum"
            };
            let letter = axis.letter();
            self.core.report(
                codes::K2809::this_cycle_26_names_no_centre(&letter, &what)
                    .answer(Answer::key("control", "scaling_center"))
                    .at(self.core.here.origin.loc),
            );
        }
    }

    #[cold]
    fn preset_without_offset(&mut self, number: f64, row: Option<u32>) -> Outcome {
        let help = match row {
            Some(_) if self.core.job.settings.output.target.offset_range().is_none() => {
                "take the cycle out: positions count from where the part is set up on the machine".into()
            }
            Some(row) => {
                let free = self.core.free_offset(&format!("preset.{row}"));
                Answer::entry("datums", "preset", row)
                    .help(format!("name one in partc.toml: `[datums]` with `preset.{row} = \"{free}\"`"))
            }
            None => "write the number of a row of the preset table, a whole number, into Q339".into(),
        };
        self.core.report(codes::P9014::preset_has_no_work_offset(&number).at(self.core.here.origin.loc).help(help));
        Err(Reported)
    }

    /// Cycle 247: a row of the preset table becomes a work offset.
    pub(super) fn preset(&mut self, open: &Open) -> Outcome {
        let Some(&(_, number)) = open.parameters.iter().find(|(q, _)| *q == 339) else {
            return self.core.refuse(self.core.block_span(), codes::K2402::cycle_247_lacks_preset_number_q339());
        };
        let row = (number >= 0.0 && number.fract() == 0.0).then_some(number as u32);
        let configured = row.and_then(|row| self.core.job.settings.datums.presets.get(&row).copied());
        let offset = configured.or(row.filter(|row| (1..=9).contains(row)).map(|row| row as u8));
        let Some(offset) = offset else {
            return self.preset_without_offset(number, row);
        };
        if let Some(row) = row {
            if !self.st.frames.preset_selected {
                self.core.moves_before_offset(offset, Where::Block);
            }
            let name = OffsetName::Preset { row, mapped: configured.is_some() };
            self.core.prints_offset(name, offset, Where::Block)?;
        }
        if configured.is_none() {
            self.core.report(
                codes::K2504::preset_is_printed(&number, &self.core.offset_word(offset)).at(self.core.here.origin.loc),
            );
        }
        if self.st.frames.transform.turn.0 != 0.0 {
            self.core.say_here(codes::K2852::datum_is_set_while_working_plane());
            return Err(Reported);
        }
        let stands = self.machine_coordinates();
        self.function(Function::WorkOffset(offset));
        // Another part may lie there.
        self.contours.roughed = Known::Nothing;
        let mirror_last = self.st.frames.transform.mirror_last;
        self.set_transformation(Transformation::none(mirror_last))?;
        // In the new system no axis has a known position, but for those that never moved before the first preset.
        if std::mem::replace(&mut self.st.frames.preset_selected, true) {
            self.st.position.end_start();
        }
        self.st.position.stand_at_start();
        self.st.polar.forget_last();
        self.st.frames.system += 1;
        self.st.frames.row = row;
        self.stand_in_machine(&stands);
        // What moved in front counts from another work offset.
        self.st.tool.worked = AxisSet::EMPTY;
        Ok(())
    }

    /// TRANS DATUM, TRANS MIRROR, TRANS ROTATION, TRANS SCALE.
    pub(super) fn transform_block(&mut self, kind: Transform, block: &Block, text: &[u8]) -> Outcome {
        let (head, wanted, help) = match kind {
            Transform::Datum => ("TRANS DATUM", "AXIS", "write `TRANS DATUM AXIS X+10 Y+25` or `TRANS DATUM RESET`"),
            Transform::Mirror => ("TRANS MIRROR", "AXIS", "write `TRANS MIRROR AXIS X` or `TRANS MIRROR RESET`"),
            Transform::Rotation => ("TRANS ROTATION", "ROT", "write `TRANS ROTATION ROT+90` or `TRANS ROTATION RESET`"),
            Transform::Scale => ("TRANS SCALE", "SCL", "write `TRANS SCALE SCL1.5` or `TRANS SCALE RESET`"),
        };
        let mut words = block.words.iter();
        let first = words.next().filter(|word| word.addr == Addr::Name);
        let label = first.map(|word| word.span.of(text).to_ascii_uppercase()).unwrap_or_default();
        match label.as_slice() {
            b"RESET" => {
                return match words.next() {
                    Some(&word) => self.not_admitted(word, head),
                    None => self.reset_transform(kind),
                };
            }
            b"TABLE" | b"TABLINE" if kind == Transform::Datum => {
                let written = String::from_utf8_lossy(block.span.of(text)).to_ascii_uppercase();
                let words: Vec<&str> = written.split(';').next().unwrap_or_default().split_whitespace().collect();
                let row = words.concat();
                let row = row.rsplit_once("DATUMTABLETABLINE").and_then(|(_, row)| row.parse::<u32>().ok());
                return match row {
                    Some(row) => self.take_datum_row(f64::from(row)),
                    None => self.core.refuse(block.span, codes::K2402::trans_datum_table_names_no_row()),
                };
            }
            b"IROT" if kind == Transform::Rotation => {}
            label if label == wanted.as_bytes() => {}
            _ => {
                let span = block.words.first().map_or(block.span, |word| word.span);
                return self.core.refuse(span, codes::K2402::lacks(&head, &wanted).help(help));
            }
        }
        let axes = matches!(kind, Transform::Datum | Transform::Mirror);
        let mut named = Vec::new();
        let mut value = None;
        for &word in words {
            match word.addr {
                Addr::Axis { axis, incremental } if axes => {
                    if kind == Transform::Mirror && (incremental || word.value != Value::None) {
                        return self.not_admitted(word, head);
                    }
                    if named.iter().any(|other: &AxisValue| other.axis == axis) {
                        return self.twice(word, block);
                    }
                    let value = self.number_if(word.value, word.span)?;
                    named.push(AxisValue { axis, incremental, value, loc: self.core.loc(word.span) });
                }
                Addr::Value if !axes && value.is_none() => value = Some(self.number(word.value, word.span)?),
                _ => return self.not_admitted(word, head),
            }
        }
        match (kind, value) {
            (Transform::Datum, None) if !named.is_empty() => self.shift(&named),
            (Transform::Mirror, None) if !named.is_empty() => self.mirror(named.iter().map(|axis| axis.axis).collect()),
            (Transform::Rotation, Some(angle)) => self.rotate(angle, label == b"IROT"),
            (Transform::Scale, Some(factor)) => self.scale(factor),
            _ => self.core.refuse(block.span, codes::K2402::lacks_its_values(&head).help(help)),
        }
    }

    pub(super) fn reset_transform(&mut self, kind: Transform) -> Outcome {
        let mut next = self.st.frames.transform.clone();
        let none = Transformation::default();
        match kind {
            Transform::Datum => {
                next.unshift();
                self.check_shift_under_turn(&mut next)?;
            }
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
