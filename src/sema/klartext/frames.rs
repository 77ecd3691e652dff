//! The coordinate system changes: by TRANS functions, by a row of the preset table, and by what cycles make of it.
//!
//! Source: K 3 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::Function;
use crate::ir::contour::Ctx;
use crate::lexer::klartext::Value;
use crate::machine::AxisSet;
use crate::parser::klartext::ast::{Addr, Block, Transform, Word};
use crate::sema::run::{OffsetName, Where};
use crate::text::Span;

use super::cycle_definition::{AxisValue, Open};
use super::known::Known;
use super::reading::Reading;
use super::transformation::Transformation;
use super::{Core, Outcome, Run};

impl Run<'_> {
    /// Puts a new transformation in force; the tool stays where it is.
    pub(super) fn set_transformation(&mut self, transform: Transformation) -> Outcome {
        self.st.frames.warn_of_order(&self.core, &transform);
        self.st.refuse_compensated(&mut self.core, "the coordinate system changes");
        self.st.frames.set(transform);
        let span = self.core.block_span();
        self.update_frame(span)
    }

    /// A datum shift, which a tilted plane may stand before or behind.
    pub(super) fn shift_datum(&mut self, next: Transformation) -> Outcome {
        if let Err(fault) = self.st.tilt.shifts(&next) {
            return self.st.refuse_motion(&mut self.core, Where::Block, fault);
        }
        self.set_transformation(next)
    }

    /// Makes the frame follow the transformation and the length oversize.
    pub(super) fn update_frame(&mut self, span: Span) -> Outcome {
        let lift = self.st.tool.active().map_or(0.0, |tool| tool.call_deltas[0]);
        let axis = self.st.axis();
        let Some(frame) = self.st.frames.transform().frame(axis, lift) else {
            return self.core.refuse(span, codes::P2090::transformations_together_are_too_large_or_too());
        };
        if let Some(tool) = self.st.tool.active().filter(|_| lift != 0.0) {
            let fault = codes::K2011::length_oversize_dl_mm_of_tool(&lift, &tool.called, &axis.letter());
            self.core.note(Where::Block, fault);
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
            self.st.frames.change_system();
        }
        self.st.ctx = std::rc::Rc::new(Ctx { plane, frame, compensation: self.st.ctx.compensation.clone() });
        Ok(())
    }

    /// Cycle 10.
    pub(super) fn rotate(&mut self, angle: f64, incremental: bool) -> Outcome {
        self.st.refuse_compensated(&mut self.core, "the coordinate system turns");
        if self.st.compensation.is_on() {
            self.core.say_here(codes::P2041::rotation_ends_radius_compensation());
            self.st.end_compensation();
        }
        self.set_transformation(self.st.frames.rotated(angle, incremental, self.st.plane()))
    }

    /// Cycle 247: a row of the preset table becomes a work offset.
    pub(super) fn preset(&mut self, open: &Open) -> Outcome {
        let Some(&(_, number)) = open.parameters.iter().find(|(q, _)| *q == 339) else {
            return self.core.refuse(Where::Block, codes::K2402::cycle_247_lacks_preset_number_q339());
        };
        let row = (number >= 0.0 && number.fract() == 0.0).then_some(number as u32);
        let configured = row.and_then(|row| self.core.job.settings.datums.presets.get(&row).copied());
        let offset = configured.or(row.filter(|row| (1..=9).contains(row)).map(|row| row as u8));
        let Some(offset) = offset else {
            return preset_without_offset(&mut self.core, number, row);
        };
        if let Some(row) = row {
            if !self.st.frames.preset_selected() {
                self.core.moves_before_offset(offset, Where::Block);
            }
            let name = OffsetName::Preset { row, mapped: configured.is_some() };
            self.core.prints_offset(name, offset, Where::Block)?;
        }
        if configured.is_none() {
            self.core.say_here(codes::K2504::preset_is_printed(&number, &self.core.offset_word(offset)));
        }
        if self.st.frames.transform().turn.0 != 0.0 || !self.st.tilt.is_upright() {
            return self.core.refuse(Where::Block, codes::K2852::datum_is_set_while_working_plane());
        }
        let stands = self.view().machine_coordinates();
        self.function(Function::WorkOffset(offset));
        // Another part may lie there.
        self.contours.roughed = Known::Nothing;
        let mirror_last = self.st.frames.transform().mirror_last;
        self.set_transformation(Transformation::none(mirror_last))?;
        // In the new system no axis has a known position, but for those that never moved before the first preset.
        if self.st.frames.select_preset(row) {
            self.st.position.end_start();
        }
        self.st.position.stand_at_start();
        self.st.polar.forget_last();
        let places = self.view().out_of_machine(&stands);
        self.st.stand(&mut self.core, &places);
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
                    Some(&word) => self.core.not_admitted(word, head),
                    None if kind == Transform::Datum => {
                        let next = self.st.frames.reset(&self.core, kind)?;
                        self.shift_datum(next)
                    }
                    None => self.set_transformation(self.st.frames.reset(&self.core, kind)?),
                };
            }
            b"TABLE" | b"TABLINE" if kind == Transform::Datum => {
                let Some(row) = table_row(block.span.of(text)) else {
                    return self.core.refuse(block.span, codes::K2402::trans_datum_table_names_no_row());
                };
                let axes = self.datum_table.row(&self.core, f64::from(row))?;
                let next = self.st.frames.shifted(&self.core, &axes)?;
                return self.shift_datum(next);
            }
            b"IROT" if kind == Transform::Rotation => {}
            label if label == wanted.as_bytes() => {}
            _ => {
                let span = block.words.first().map_or(block.span, |word| word.span);
                return self.core.refuse(span, codes::K2402::lacks(&head, &wanted).help(help));
            }
        }
        let (named, value) = transform_words(self.reading(), kind, head, words.as_slice(), block)?;
        let (frames, axis) = (&self.st.frames, self.st.axis());
        let next = match (kind, value) {
            (Transform::Datum, None) if !named.is_empty() => {
                let next = frames.shifted(&self.core, &named)?;
                return self.shift_datum(next);
            }
            (Transform::Mirror, None) if !named.is_empty() => {
                frames.mirrored(&self.core, named.iter().map(|axis| axis.axis).collect(), axis)?
            }
            (Transform::Rotation, Some(angle)) => return self.rotate(angle, label == b"IROT"),
            (Transform::Scale, Some(factor)) => frames.scaled(&self.core, factor, axis)?,
            _ => return self.core.refuse(block.span, codes::K2402::lacks_its_values(&head).help(help)),
        };
        self.set_transformation(next)
    }
}

#[cold]
fn preset_without_offset(core: &mut Core<'_>, number: f64, row: Option<u32>) -> Outcome {
    let help = match row {
        Some(_) if core.job.settings.output.target.offset_range().is_none() => {
            "take the cycle out: positions count from where the part is set up on the machine".into()
        }
        Some(row) => {
            let free = core.free_offset(&format!("preset.{row}"));
            Answer::entry("datums", "preset", row)
                .help(format!("name one in partc.toml: `[datums]` with `preset.{row} = \"{free}\"`"))
        }
        None => "write the number of a row of the preset table, a whole number, into Q339".into(),
    };
    core.refuse(Where::Block, codes::P9014::preset_has_no_work_offset(&number).help(help))
}

/// The row of `TRANS DATUM TABLE TABLINE5`.
fn table_row(code: &[u8]) -> Option<u32> {
    let written = String::from_utf8_lossy(code).to_ascii_uppercase();
    let words: Vec<&str> = written.split(';').next()?.split_whitespace().collect();
    words.concat().rsplit_once("DATUMTABLETABLINE")?.1.parse().ok()
}

/// The axes that TRANS DATUM and TRANS MIRROR name, and the value of the others.
fn transform_words(
    reading: Reading<'_, '_>,
    kind: Transform,
    head: &str,
    words: &[Word],
    block: &Block,
) -> Outcome<(Vec<AxisValue>, Option<f64>)> {
    let core = reading.core;
    let axes = matches!(kind, Transform::Datum | Transform::Mirror);
    let mut named = Vec::new();
    let mut value = None;
    for &word in words {
        match word.addr {
            Addr::Axis { axis, incremental } if axes => {
                if kind == Transform::Mirror && (incremental || word.value != Value::None) {
                    return core.not_admitted(word, head);
                }
                if named.iter().any(|other: &AxisValue| other.axis == axis) {
                    return core.twice(word, block);
                }
                let value = reading.number_if(word.value, word.span)?;
                named.push(AxisValue { axis, incremental, value, loc: core.loc(word.span) });
            }
            Addr::Value if !axes && value.is_none() => value = Some(reading.number(word.value, word.span)?),
            _ => return core.not_admitted(word, head),
        }
    }
    Ok((named, value))
}
