//! CYCL DEF and CYCL CALL.
//!
//! A definition may go over several blocks (`7.0`, `7.1`, …) or lines; it acts when it is complete.
//! Source: K 4.4 and 4.5 (docs/sources.md).

use crate::diag::codes;
use crate::machine::{AxisSet, Generation};
use crate::parser::klartext::ast::{Addr, Block, CallKind};
use crate::sema::run::Where;

use super::cycle::Defined;
use super::cycle_definition::Open;
use super::cycle_words::{Defining, check_title};
use super::cycles::DefinedCycle;
use super::cycles::{CycleKind, Row, find};
use super::words::Admits;
use super::{Outcome, Run};

impl Run<'_> {
    /// A block that cannot be read was to define a cycle: what calls it or goes on with it suffers only from that.
    pub(super) fn refused_definition(&mut self, text: &[u8]) {
        let Some((number, part)) = definition(text) else { return };
        if let Some(open) = self.cycles.open()
            && open.number == number
            && part.is_some_and(|part| part > 0)
        {
            open.failed = true;
            open.part = part;
            return;
        }
        self.finish_cycle();
        self.cycles.begin(Open::new(number, part, self.core.here, true));
    }

    pub(super) fn cycle_block(&mut self, number: u32, part: Option<u32>, block: &Block, text: &[u8]) -> Outcome {
        match part {
            None | Some(0) => {
                let words = check_title(&self.core, number, part, block, text);
                self.cycles.begin(Open::new(number, part, self.core.here, words.is_err()));
            }
            Some(part) => match self.cycles.open() {
                Some(open) if open.number == number && open.part.is_some_and(|last| last < part) => {
                    open.part = Some(part);
                    // The effect belongs to the last block of the definition.
                    open.here = self.core.here;
                }
                _ => {
                    return self.core.refuse(block.span, codes::K2402::part_does_not_follow_its_cycle(&number, &part));
                }
            },
        }
        let Some(open) = self.cycles.open() else { return Ok(()) };
        if matches!(find(number).nature, CycleKind::Unknown) {
            open.keep_left_words(&self.core, part, block, text);
        }
        let (core, vars, st, globals) = (&mut self.core, &mut self.vars, &self.st, &self.globals);
        let result = Defining { open, core, vars, st, globals }.words(block, text);
        open.failed |= result.is_err();
        result
    }

    /// The definition that was open is complete: it acts.
    pub(super) fn finish_cycle(&mut self) {
        let Some(open) = self.cycles.complete() else { return };
        let here = std::mem::replace(&mut self.core.here, open.here);
        let failed = open.failed || self.apply_cycle(&open).is_err();
        let nature = find(open.number).nature;
        if failed && (nature.is_machining() || matches!(nature, CycleKind::ProgramCall | CycleKind::Unknown)) {
            self.cycles.define(Defined::Refused);
        }
        match nature {
            CycleKind::Setting(_) if failed => self.contours.lose(open.number),
            _ if failed && !nature.is_machining() => self.st.lose(AxisSet::MAIN),
            _ => {}
        }
        self.core.here = here;
    }

    fn apply_cycle(&mut self, open: &Open) -> Outcome {
        let row = find(open.number);
        if row.has_parts(open.number) && open.part.unwrap_or(0) == 0 {
            return self.core.refuse(Where::Block, codes::K2402::cycle_lacks_its_part_1(&open.number));
        }
        let (frames, axis) = (&self.st.frames, self.st.axis());
        let next = match row.nature {
            CycleKind::DatumShift => {
                let next = frames.shifted(&self.core, &self.datum_table.axes_of(&self.core, open)?)?;
                return self.shift_datum(next);
            }
            CycleKind::Mirror => frames.mirrored(&self.core, open.axes.iter().map(|axis| axis.axis).collect(), axis)?,
            CycleKind::Scaling => frames.scaled(&self.core, open.single_value(&self.core)?, axis)?,
            CycleKind::AxisScaling => frames.axes_scaled(&self.core, open)?,
            _ => return self.apply_other(row, open),
        };
        self.set_transformation(next)
    }

    /// Cycles that do not only shift, mirror or scale.
    fn apply_other(&mut self, row: &Row, open: &Open) -> Outcome {
        let here = self.core.here.origin.loc;
        match row.nature {
            CycleKind::Dwell | CycleKind::Tolerance => {
                let function = open.function(&self.core, row.nature)?;
                self.function(function);
            }
            CycleKind::Rotation => {
                let incremental = open.values.iter().any(|value| value.label == "IROT");
                return self.rotate(open.single_value(&self.core)?, incremental);
            }
            CycleKind::ProgramCall => match &open.program {
                Some(name) => self.cycles.define(Defined::Program { name: name.clone() }),
                None => return self.core.refuse(Where::Block, codes::K2402::cycle_12_names_no_program()),
            },
            CycleKind::Orientation => {
                let angle = open.single_value(&self.core)?;
                if !(0.0..=360.0).contains(&angle) {
                    let fault = codes::P2090::spindle_angle_of_degrees_is_out(&angle);
                    return self.core.refuse(Where::Block, fault);
                }
                self.st.spindle.orient(angle);
            }
            CycleKind::Tilt => return self.tilt(open),
            CycleKind::Preset => return self.preset(open),
            CycleKind::Setting(setting) => return self.contours.keep(&self.core, setting, open),
            CycleKind::Data => self.cycles.defines_unsupported(open.number, here, false),
            CycleKind::Acting => {
                let fault = codes::P9010::cycle_acts_where_it_is_defined(&open.number, &row.called());
                return self.st.refuse_motion(&mut self.core, Where::Block, fault);
            }
            CycleKind::Pattern(places) => {
                let pattern = DefinedCycle::new(open, here, self.core.mm());
                let run = self.pattern_cycle(&pattern, places);
                return run.inspect_err(|_| self.st.lose_all(&mut self.core));
            }
            CycleKind::Unknown => return self.builders_cycle(open),
            CycleKind::Drilling(_) | CycleKind::Milling(_) | CycleKind::Machining => {
                let cycle = DefinedCycle::new(open, here, self.core.mm());
                return self.cycles.define_machining(&self.core, cycle);
            }
            CycleKind::DatumShift | CycleKind::Mirror | CycleKind::Scaling | CycleKind::AxisScaling => {}
        }
        Ok(())
    }

    pub(super) fn cycle_call(&mut self, kind: CallKind, block: &Block, text: &[u8]) -> Outcome {
        let first = block.words.first().filter(|word| word.addr == Addr::Name);
        let kind = match first.map(|word| word.span.of(text).to_ascii_uppercase()).as_deref() {
            Some(b"POS") => CallKind::At,
            Some(b"PAT") => CallKind::Pattern,
            _ => kind,
        };
        match kind {
            CallKind::Here => {
                let w = self.gather_m(block, "CYCL CALL", Admits::M, &[89, 91, 92, 99])?;
                if let Some(m) = w.any_m(&[2, 30]) {
                    return self.core.refuse(m.span, codes::P1005::cycle_call());
                }
                self.m_at_start(&w, false)?;
                // Newer controls end M89 by M99, CYCL CALL POS or a new definition only.
                if self.core.job.settings.control.klartext == Generation::Tnc426 {
                    self.cycles.set_modal(false);
                }
                self.call_cycle_then("CYCL CALL", w.m())
            }
            CallKind::At => self.call_cycle_at(block),
            CallKind::Pattern => self.call_pattern(block).inspect_err(|_| self.st.lose_all(&mut self.core)),
        }
    }

    /// CYCL CALL POS moves to a position and runs the cycle there.
    fn call_cycle_at(&mut self, block: &Block) -> Outcome {
        self.cycles.set_modal(false);
        if self.cycles.program().is_some() {
            let fault = codes::P9010::cycl_call_pos_with_program_call();
            return self.st.refuse_motion(&mut self.core, Where::Block, fault);
        }
        let cycle = self.pattern_subject("CYCL CALL POS")?;
        self.run_cycle_at(&cycle, block).inspect_err(|_| self.st.lose_all(&mut self.core))
    }
}

/// Number and part of the cycle that `CYCL DEF` at the start of the text defines.
fn definition(text: &[u8]) -> Option<(u32, Option<u32>)> {
    let text = text.get(..text.len().min(40))?.to_ascii_uppercase();
    let mut words = std::str::from_utf8(&text).unwrap_or_default().split_ascii_whitespace();
    if !matches!(words.next()?, "CYCL" | "CYCLE") {
        return None;
    }
    let number =
        words.next()?.strip_prefix("DEF").map(|rest| if rest.is_empty() { words.next() } else { Some(rest) })??;
    let (number, part) = number.split_once('.').map_or((number, None), |(number, part)| (number, Some(part)));
    let digits = |text: &str| text.trim_end_matches(|c: char| !c.is_ascii_digit()).parse().ok();
    Some((digits(number)?, part.and_then(digits)))
}
