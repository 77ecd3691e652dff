//! CYCL DEF and CYCL CALL.
//!
//! A definition may go over several blocks (`7.0`, `7.1`, …) or lines; it acts when it is complete.
//! Source: K 4.4 and 4.5 (docs/sources.md).

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::diag::{Label, codes};
use crate::ir::Function;
use crate::ir::function::PathControl;
use crate::lexer::klartext::QRef;
use crate::machine::{AxisSet, Generation};
use crate::parser::klartext::ast::{Addr, Block, CallKind, Stmt};
use crate::text::{FileId, Loc, Span};

use super::cycle_definition::{DottedValue, Open, What};
use super::cycles::DefinedCycle;
use super::cycles::call::Calling;
use super::cycles::contours::ROUGH_OUT;
use super::cycles::{Nature, Row, find};
use super::known::Known;
use super::m_table::{When, entry};
use super::words::{Admits, MWord};
use super::{Outcome, Reported, Run};

/// What is known of cycles: the definition under way and the one that calls run.
#[derive(Debug, Default)]
pub(super) struct Cycles {
    open: Option<Open>,
    defined: Option<Defined>,
    /// M89: every positioning block calls the cycle.
    modal: bool,
    /// Definitions of cycles that are not supported, by place.
    unsupported: BTreeMap<(FileId, u32, u32), Unsupported>,
}

/// A definition of a cycle that is not supported.
#[derive(Debug)]
struct Unsupported {
    number: u32,
    loc: Loc,
    called: bool,
}

/// What CYCL CALL, M99 and M89 run.
#[derive(Debug, Clone)]
enum Defined {
    Program {
        name: String,
    },
    Machining {
        cycle: Rc<DefinedCycle>,
        refused: bool,
    },
    /// The definition was refused, which was reported.
    Refused,
}

impl Cycles {
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub fn modal(&self) -> bool {
        self.modal
    }

    pub fn set_modal(&mut self, on: bool) {
        self.modal = on;
    }

    /// A cycle that is not supported is defined there, and perhaps called.
    fn defines_unsupported(&mut self, number: u32, loc: Loc, called: bool) {
        let place = (loc.file, loc.line, loc.span.start);
        self.unsupported.entry(place).or_insert(Unsupported { number, loc, called }).called |= called;
    }
}

impl Run<'_> {
    /// Does the block go on with the definition that is open?
    pub(super) fn continues_cycle(&self, block: &Block) -> bool {
        let Some(open) = &self.cycles.open else { return false };
        match block.stmt {
            Stmt::Cycle { number, part: Some(part) } => number == open.number && part > 0 && open.part.is_some(),
            // A line of parameters without a continuation mark in front of it.
            Stmt::Assign(q) => block.number.is_none() && open.part.is_none() && find(open.number).takes(open.number, q),
            _ => false,
        }
    }

    /// A formula block turned out to be a line of the open definition.
    pub(super) fn note_cycle_parameter(&mut self, q: QRef, value: f64, span: Span) -> Outcome {
        let Some(open) = &mut self.cycles.open else { return Ok(()) };
        if open.part.is_some() || !find(open.number).takes(open.number, q) {
            return Ok(());
        }
        // Behind a definition that `~` holds together, such a line is a block that changes the cycle.
        if !open.parameters.iter().any(|(number, _)| *number == q.number) {
            open.loose = true;
            open.parameters.push((q.number, value));
        } else if open.loose {
            open.failed = true;
            return self.core.refuse(span, codes::P1002::sets_second_time_so_remove_one(&self.word_text(span), &q));
        }
        Ok(())
    }

    /// A block that cannot be read was to define a cycle: what calls it or goes on with it suffers only from that.
    pub(super) fn refused_definition(&mut self, text: &[u8]) {
        let Some((number, part)) = definition(text) else { return };
        if let Some(open) = &mut self.cycles.open
            && open.number == number
            && part.is_some_and(|part| part > 0)
        {
            open.failed = true;
            open.part = part;
            return;
        }
        self.finish_cycle();
        self.cycles.open = Some(Open::new(number, part, self.core.here, true));
    }

    pub(super) fn cycle_block(&mut self, number: u32, part: Option<u32>, block: &Block, text: &[u8]) -> Outcome {
        match part {
            None | Some(0) => {
                let words = self.check_title(number, part, block, text);
                self.cycles.open = Some(Open::new(number, part, self.core.here, words.is_err()));
            }
            Some(part) => match &mut self.cycles.open {
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
        if matches!(find(number).nature, Nature::Unknown) {
            self.keep_left_words(part, block, text);
        }
        let result = self.cycle_words(block, text);
        if let (Err(_), Some(open)) = (&result, &mut self.cycles.open) {
            open.failed = true;
        }
        result
    }

    /// Keeps what a part of an old machining cycle says.
    pub(super) fn keep_part(&mut self, what: What, value: f64) {
        let open = self.open_cycle();
        if let Some(part) = open.part {
            open.parts.push(DottedValue { part, what, value });
        }
    }

    pub(super) fn open_cycle(&mut self) -> &mut Open {
        self.cycles.open.as_mut().expect("called while a definition is open")
    }

    /// The definition that was open is complete: it acts.
    pub(super) fn finish_cycle(&mut self) {
        let Some(open) = self.cycles.open.take() else { return };
        let here = std::mem::replace(&mut self.core.here, open.here);
        let failed = open.failed || self.apply_cycle(&open).is_err();
        let nature = find(open.number).nature;
        if failed && (nature.is_machining() || matches!(nature, Nature::ProgramCall | Nature::Unknown)) {
            self.cycles.defined = Some(Defined::Refused);
            self.cycles.modal = false;
        }
        match nature {
            Nature::Setting(_) if failed => self.contours.lose(open.number),
            _ if failed && !nature.is_machining() => self.st.lose(AxisSet::MAIN),
            _ => {}
        }
        self.core.here = here;
    }

    fn apply_cycle(&mut self, open: &Open) -> Outcome {
        let row = find(open.number);
        if row.has_parts(open.number) && open.part.unwrap_or(0) == 0 {
            self.core.say_here(codes::K2402::cycle_lacks_its_part_1(&open.number));
            return Err(Reported);
        }
        match row.nature {
            Nature::DatumShift => self.shift_cycle(open),
            Nature::Mirror => {
                let axes = open.axes.iter().map(|axis| axis.axis).collect();
                self.mirror(axes)
            }
            Nature::Dwell => self.dwell(open),
            Nature::Rotation => {
                let angle = self.single_value(open)?;
                let incremental = open.values.iter().any(|value| value.label == "IROT");
                self.rotate(angle, incremental)
            }
            Nature::Scaling => {
                let factor = self.single_value(open)?;
                self.scale(factor)
            }
            Nature::AxisScaling => self.scale_axes(open),
            Nature::ProgramCall => self.define_program(open),
            Nature::Orientation => self.orientation(open),
            Nature::Tilt => self.tilt(open),
            Nature::Tolerance => self.path_tolerance(open),
            Nature::Preset => self.preset(open),
            Nature::Setting(setting) => self.keep_setting(setting, open),
            Nature::Data => {
                self.cycles.defines_unsupported(open.number, self.core.here.origin.loc, false);
                Ok(())
            }
            Nature::Acting => self.acts_unsupported(open.number),
            Nature::Drilling(_) | Nature::Milling(_) | Nature::Machining => self.define_machining(row, open),
            Nature::Pattern(places) => {
                let pattern = self.defined_here(open);
                self.pattern_cycle(&pattern, places).inspect_err(|_| self.lose_all())
            }
            Nature::Unknown => self.builders_cycle(open),
        }
    }

    fn dwell(&mut self, open: &Open) -> Outcome {
        let seconds = self.single_value(open)?;
        if !(0.0..=3600.0).contains(&seconds) {
            return self.core.refuse(self.core.block_span(), codes::P2090::dwell_of_s_is_out_of_range(&seconds));
        }
        self.function(Function::Dwell(seconds));
        Ok(())
    }

    fn orientation(&mut self, open: &Open) -> Outcome {
        let angle = self.single_value(open)?;
        if !(0.0..=360.0).contains(&angle) {
            return self.core.refuse(self.core.block_span(), codes::P2090::spindle_angle_of_degrees_is_out(&angle));
        }
        self.st.spindle.orient(angle);
        Ok(())
    }

    fn define_program(&mut self, open: &Open) -> Outcome {
        let Some(name) = open.program.clone() else {
            self.core.say_here(codes::K2402::cycle_12_names_no_program());
            return Err(Reported);
        };
        self.cycles.defined = Some(Defined::Program { name });
        self.cycles.modal = false;
        Ok(())
    }

    fn define_machining(&mut self, row: &Row, open: &Open) -> Outcome {
        let cycle = self.defined_here(open);
        self.check_definition(&cycle)?;
        if matches!(row.nature, Nature::Machining) {
            self.cycles.defines_unsupported(open.number, cycle.loc, false);
        }
        self.cycles.defined = Some(Defined::Machining { cycle: Rc::new(cycle), refused: false });
        self.cycles.modal = false;
        Ok(())
    }

    fn defined_here(&mut self, open: &Open) -> DefinedCycle {
        let mm = self.core.level().frame.unit.mm();
        DefinedCycle::new(open, self.core.here.origin.loc, mm)
    }

    /// Cycle 32: how far corners are rounded off; without T the setting of the machine holds again.
    fn path_tolerance(&mut self, open: &Open) -> Outcome {
        let tolerance = open.values.iter().find(|value| value.label == "T").map(|value| value.value);
        if open.values.iter().any(|value| value.label != "T") {
            self.core.job.diags.push_once(codes::K2703::hsc_mode().at(self.core.here.origin.loc));
        }
        let said = match tolerance {
            None => None,
            Some(t) if t > 0.0 => Some(PathControl::Within(t * self.core.level().frame.unit.mm())),
            // No deviation at all.
            Some(0.0) => Some(PathControl::Exact),
            Some(t) => {
                return self.core.refuse(self.core.block_span(), codes::P2090::tolerance(&t));
            }
        };
        self.function(Function::PathControl(said));
        Ok(())
    }

    fn single_value(&mut self, open: &Open) -> Outcome<f64> {
        match open.values.as_slice() {
            // Two values are refused where they are read.
            [only, ..] => Ok(only.value),
            [] => {
                self.core.say_here(codes::K2402::cycle_lacks_its_value(&open.number));
                Err(Reported)
            }
        }
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
                let w = self.gather(block, "CYCL CALL", Admits::M)?;
                self.check_m(&w)?;
                self.forbid_m(&w, "CYCL CALL", &[89, 91, 92, 99])?;
                if let Some(m) = w.any_m(&[2, 30]) {
                    return self.core.refuse(m.span, codes::P1005::cycle_call());
                }
                self.m_at_start(&w, false)?;
                // Newer controls end M89 by M99, CYCL CALL POS or a new definition only.
                if self.core.job.settings.control.klartext == Generation::Tnc426 {
                    self.cycles.modal = false;
                }
                self.call_cycle_then("CYCL CALL", w.m())
            }
            CallKind::At => self.call_cycle_at(block),
            CallKind::Pattern => {
                let result = self.call_pattern(block);
                if result.is_err() {
                    self.lose_all();
                }
                result
            }
        }
    }

    /// The program that calls run.
    pub(super) fn program_of_cycle_12(&self) -> Option<String> {
        match &self.cycles.defined {
            Some(Defined::Program { name }) => Some(name.clone()),
            _ => None,
        }
    }

    /// The machining cycle that a pattern runs.
    pub(super) fn pattern_subject(&mut self, by: &str) -> Outcome<Rc<DefinedCycle>> {
        match &self.cycles.defined {
            Some(Defined::Refused) => Err(Reported),
            Some(Defined::Machining { cycle, .. }) if cycle.row().nature.runs() => Ok(Rc::clone(cycle)),
            Some(Defined::Machining { .. }) => {
                self.call_cycle(by)?;
                Err(Reported)
            }
            Some(Defined::Program { name }) => {
                self.core.say_here(codes::P9010::with_program_of_cycle_12_is_not(&by, &name));
                Err(Reported)
            }
            None => {
                self.core.say_here(codes::K2401::runs_machining_cycle(&by));
                Err(Reported)
            }
        }
    }

    /// CYCL CALL POS moves to a position and runs the cycle there.
    fn call_cycle_at(&mut self, block: &Block) -> Outcome {
        self.cycles.modal = false;
        if let Some(Defined::Program { .. }) = self.cycles.defined {
            self.core.report(codes::P9010::cycl_call_pos_with_program_call().at(self.core.here.origin.loc));
            self.lose_all();
            return Err(Reported);
        }
        let cycle = self.pattern_subject("CYCL CALL POS")?;
        let result = self.run_cycle_at(&cycle, block);
        if result.is_err() {
            self.lose_all();
        }
        result
    }

    /// Runs the cycle defined last, and after it what acts at the end of the block.
    pub(super) fn call_cycle_then(&mut self, by: &str, functions: &[MWord]) -> Outcome {
        let wait = functions.iter().any(|m| matches!(entry(m.number), Some((_, When::End))));
        match self.program_of_cycle_12() {
            Some(name) if wait => self.run_whole(&name)?,
            _ => self.call_cycle(by)?,
        }
        self.these_at_end(functions)
    }

    /// Runs the cycle defined last.
    pub(super) fn call_cycle(&mut self, by: &str) -> Outcome {
        let here = self.core.here.origin.loc;
        match &mut self.cycles.defined {
            None => {
                self.core.report(codes::K2401::calls_cycle(&by).at(here));
                Err(Reported)
            }
            Some(Defined::Refused) => {
                self.lose_all();
                // It may have been a cycle 22.
                self.contours.roughed = Known::Lost;
                Err(Reported)
            }
            Some(Defined::Program { name, .. }) => {
                let name = name.clone();
                self.call_program_named(&name)
            }
            Some(Defined::Machining { cycle, .. }) if cycle.row().nature.runs() => {
                let cycle = Rc::clone(cycle);
                let result = self.run_cycle(&cycle, Calling::HERE);
                if result.is_err() {
                    let drills = cycle.row().drills();
                    if cycle.number == ROUGH_OUT {
                        self.contours.roughed = Known::Lost;
                    }
                    self.st.lose(if drills { AxisSet::of(self.st.axis()) } else { AxisSet::MAIN });
                    self.lost();
                }
                result
            }
            Some(Defined::Machining { cycle, refused }) => {
                let (number, loc, again) = (cycle.number, cycle.loc, std::mem::replace(refused, true));
                self.cycles.defines_unsupported(number, loc, true);
                if !again {
                    let what = find(number).called();
                    self.core.report(
                        codes::P9010::cycle_is_not_supported_yet(&number, &what)
                            .at(here)
                            .here("called here")
                            .also(loc, Label::DefinedHere),
                    );
                }
                let axis = self.st.axis();
                self.st.lose(AxisSet::of(axis));
                self.lost();
                Err(Reported)
            }
        }
    }
}

impl Run<'_> {
    /// A cycle that acts where it is defined, which cannot be compiled.
    fn acts_unsupported(&mut self, number: u32) -> Outcome {
        let what = find(number).called();
        self.core.say_here(codes::P9010::cycle_acts_where_it_is_defined(&number, &what));
        self.lose_all();
        Err(Reported)
    }

    /// Says of definitions that nothing used that their cycles are not supported.
    pub(super) fn note_uncalled(&mut self) {
        let all = std::mem::take(&mut self.cycles.unsupported);
        for Unsupported { number, loc, .. } in all.into_values().filter(|cycle| !cycle.called) {
            let row = find(number);
            let what = if matches!(row.nature, Nature::Data) {
                "is defined for cycles that are not supported, and none of them is called"
            } else {
                "is defined and never called; it is not supported"
            };
            self.core.report(codes::K2412::cycle(&number, &row.called(), &what).at(loc));
        }
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
