//! Sections of a program, header lines, units; which control a program was written for.

use std::ops::ControlFlow;

use crate::diag::{Answer, Fault, Label, codes};
use crate::ir::Function;
use crate::machine::{Settings, Unit};
use crate::parser::turning::ast::{Block, Section, Stmt, Value};
use crate::parser::turning::parse_block;
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::text::{Loc, Span, decode::readable};

use super::calls::LevelKind;
use super::program_parts::{Family, ProgramPart};
use super::words::{Words, letters};
use super::{Core, Outcome, Reported, Run};

/// The sections met so far.
#[derive(Debug, Default)]
pub(super) struct Sections {
    configured: Option<Family>,
    family: Option<Family>,
    pub part: ProgramPart,
    /// Position, edge and name of the tools of the turret.
    tools: Vec<(u32, u8, String)>,
    unit_said: bool,
    unit_open: bool,
    /// The file has a name line or sections, so it has to have an end.
    framed: bool,
    /// The section of a subprogram is being passed.
    passing: bool,
}

impl Sections {
    pub fn new(settings: &Settings) -> Sections {
        let configured = match settings.control.heidenhain_turning.as_str() {
            "manualplus4110" => Some(Family::Basic),
            "" => None,
            _ => Some(Family::DinPlus),
        };
        Sections { configured, family: configured, ..Sections::default() }
    }

    /// The family; a program without sections is one of the 4110.
    #[inline]
    pub fn family(&self) -> Family {
        self.family.unwrap_or(Family::Basic)
    }

    /// A block runs: from now on the family does not change.
    #[inline]
    pub fn settle_family(&mut self) {
        if self.family.is_none() {
            self.family = Some(Family::Basic);
        }
    }

    #[inline]
    pub fn is_unread(&self) -> bool {
        self.part == ProgramPart::Unread
    }

    pub fn tool_name(&self, number: u32, edge: u8) -> Option<String> {
        self.tools.iter().find(|tool| (tool.0, tool.1) == (number, edge)).map(|tool| tool.2.clone())
    }
}

/// What lines of sections and headers say.
impl Sections {
    /// `%name.nc`; `begun`: a block of the program ran.
    pub fn program_line(&mut self, begun: bool) -> Result<(), Fault> {
        if begun {
            return Err(codes::T1008::program_name_stands_in_middle_of_program());
        }
        self.framed = true;
        Ok(())
    }

    /// A section or header line of DIN PLUS.
    fn enter_din_plus(&mut self) -> Result<(), Fault> {
        self.framed = true;
        match (self.configured, self.family) {
            (Some(Family::Basic), _) => {
                // Once is enough; what follows is read as what it is.
                (self.configured, self.family) = (Some(Family::DinPlus), Some(Family::DinPlus));
                Err(codes::T2017::programs_of_manualplus_4110_have_no_sections()
                    .answer(Answer::key("control", "heidenhain_turning")))
            }
            (None, Some(Family::Basic)) => Err(codes::T1008::section_begins_behind_blocks_that_ran_already()),
            _ => {
                self.family = Some(Family::DinPlus);
                Ok(())
            }
        }
    }

    /// `#UNIT METRIC`: the unit, where it is the line of it.
    pub fn head_line(&mut self, key: &[u8], value: &[u8], span: Span) -> Made<Option<Unit>> {
        self.enter_din_plus().or_else(|fault| refused(Where::Block, fault))?;
        if !matches!(self.part, ProgramPart::Start | ProgramPart::Head) {
            return refused(Where::Block, codes::T1008::header_lines_stand_in_section_header());
        }
        let value = readable(value).trim().to_ascii_uppercase();
        match key.to_ascii_uppercase().as_slice() {
            b"UNIT" | b"EINHEIT" => {
                self.unit_said = true;
                match value.trim_start_matches('/') {
                    "METRIC" | "METRISCH" | "MM" => Ok(Some(Unit::Mm)),
                    "INCH" | "ZOLL" => Ok(Some(Unit::Inch)),
                    _ => refused(span, codes::T1014::is_no_unit(&value)),
                }
            }
            b"SLIDE" | b"SCHLITTEN" => {
                let mut slides = value.split(|c: char| !c.is_alphanumeric() && c != '$');
                if slides.any(|slide| slide == "$1" || slide == "1") {
                    return Ok(None);
                }
                refused(span, codes::T2022::program_is_for_slide(&value))
            }
            // Free text.
            _ => Ok(None),
        }
    }

    /// `UNIT` and `END_OF_UNIT`: the blocks between stand there in full. What is wrong with it.
    pub fn unit(&mut self, opens: bool) -> Option<Fault> {
        let odd = std::mem::replace(&mut self.unit_open, opens) == opens;
        let fault =
            if opens { codes::T1012::unit_begins_inside_another } else { codes::T1012::unit_ends_that_did_not_begin };
        odd.then(fault)
    }

    /// `T1 ID"…"`: what of it is not used.
    pub fn turret_line(&mut self, w: &Words, text: &[u8]) -> Made<Option<Fault>> {
        let Some(num) = w.get(b'T') else {
            return refused(Where::Block, codes::P1004::line_of_turret_section_names_position());
        };
        let more = w.present() & !letters("T") != 0 || !w.longs().is_empty() || !w.g().is_empty();
        let digits = num.span.of(text);
        let edge = digits.iter().position(|b| *b == b'.').and_then(|at| digits.get(at + 1)).map_or(0, |b| b - b'0');
        if let Some(span) = w.text("ID") {
            self.tools.push((num.value as u32, edge, readable(span.of(text)).into_owned()));
        }
        let unused =
            || codes::T2023::data_of_this_tool_is_not_used(&num.value).answer(Answer::tool(num.value, "radius"));
        Ok(more.then(unused))
    }

    /// What the blocks behind a section code are read as. None of RETURN, and none of END.
    fn begin(&mut self, section: Section, rest: &[u8]) -> Result<ProgramPart, Fault> {
        Ok(match section {
            Section::Head => ProgramPart::Head,
            Section::Turret => ProgramPart::Turret,
            Section::Clamping | Section::AuxiliaryBlank | Section::Milling => ProgramPart::Unread,
            Section::Contours => {
                one_part(rest)?;
                ProgramPart::Between
            }
            Section::Blank | Section::Finished | Section::AuxiliaryContour => ProgramPart::Contour,
            Section::Assignment if rest.trim_ascii() != b"$1" => {
                return Err(codes::T2022::these_blocks_are_for_other_slides());
            }
            Section::Machining | Section::Assignment => ProgramPart::Machining,
            Section::Names => ProgramPart::Names,
            Section::Subprogram => {
                self.passing = true;
                ProgramPart::Unread
            }
            Section::Return | Section::End => self.part,
        })
    }
}

/// `CONTOUR Q1 X0 Z0`: one part at the workpiece zero is what every program means.
fn one_part(rest: &[u8]) -> Result<(), Fault> {
    let (mut block, mut problems) = (Block::default(), Vec::new());
    parse_block(rest, &mut block, &mut problems);
    let plain = block.words.iter().all(|word| match (word.address.addr.letter(), word.value) {
        (Some(b'Q'), Value::Number { value, .. }) => value == 1.0,
        (Some(b'X' | b'Z'), Value::Number { value, .. }) => value == 0.0,
        _ => false,
    });
    if problems.is_empty() && plain { Ok(()) } else { Err(codes::T9002::several_contours_on_one_bar_are_not()) }
}

impl Core<'_> {
    /// A block for another slide than the first: said once.
    pub(super) fn other_slide(&self, number: u32) -> Outcome {
        if self.job.diags.first_time(codes::T2022, ()) {
            self.say(Where::Block, codes::T2022::block_is_for_slide(&number));
        }
        Err(Reported)
    }

    /// A line of the sections CONST and VAR: said once.
    pub(super) fn names_line(&self) -> Outcome {
        if self.job.diags.first_time(codes::T9002, ()) {
            self.say(Where::Block, codes::T9002::names_of_constants());
        }
        Err(Reported)
    }

    /// Warns about blocks behind END; local subprograms may stand there.
    fn look_behind_end(&mut self) {
        let (mut block, mut ignored) = (Block::default(), Vec::new());
        let program = self.level().program;
        let behind = self.first_behind(program, |text| {
            parse_block(text, &mut block, &mut ignored);
            ignored.clear();
            match block.stmt {
                Stmt::Empty => ControlFlow::Continue(()),
                Stmt::Section(Section::Subprogram, _) => ControlFlow::Break(None),
                _ => ControlFlow::Break(Some(block.span)),
            }
        });
        if let Some(loc) = behind {
            self.report(codes::P1008::this_stands_behind_end_of_program().at(loc));
        }
    }
}

impl Run<'_> {
    pub(super) fn section(&mut self, section: Section, rest: Span, text: &[u8]) -> Outcome {
        self.settle_chain()?;
        self.section_stands_alone(section, rest, text);
        match section {
            Section::Return if self.sections.passing => {
                self.sections.passing = false;
                self.sections.part = ProgramPart::Between;
                return Ok(());
            }
            Section::Return if self.core.level().frame.kind != LevelKind::Main => return self.return_from_subprogram(),
            Section::End if self.sections.passing => {
                return self.core.refuse(Where::Block, codes::T1008::subprogram_ends_with_return());
            }
            Section::Return | Section::End => return self.end_of_job(false),
            _ => {}
        }
        if self.core.levels.len() > 1 {
            return self.core.refuse(Where::Block, codes::T1008::section_begins_inside_subprogram());
        }
        self.core.accept(Where::Block, self.sections.enter_din_plus())?;
        if let Some(loc) = self.core.level().frame.open() {
            let found = codes::T1009::this_is_not_closed_when_next_section().at(loc);
            self.core.report(found.also(self.core.here.origin.loc, Label::Section));
            self.core.level().frame.nests.clear();
        }
        self.core.level().frame.begun = true;
        self.geometry.finish(&self.core);
        let part = self.core.accept(Where::Block, self.sections.begin(section, rest.of(text)))?;
        if part == ProgramPart::Contour {
            self.geometry.in_blank = section == Section::Blank;
            let id = rest.of(text).trim_ascii();
            let name = quoted_id(id);
            if !id.is_empty() && name.is_none() && section == Section::AuxiliaryContour {
                return self.core.refuse(rest, codes::P1001::this_does_not_name_contour());
            }
            self.geometry.begin(name.map(|name| readable(name).into_owned()));
        }
        self.sections.part = part;
        Ok(())
    }

    /// Words behind a section that takes none would be lost (T 3.2).
    fn section_stands_alone(&mut self, section: Section, rest: Span, text: &[u8]) {
        let alone = match section {
            Section::Head
            | Section::Machining
            | Section::Finished
            | Section::Blank
            | Section::Names
            | Section::Return
            | Section::End => true,
            // They have a number, a name, a place or data of a chuck.
            Section::Turret
            | Section::Clamping
            | Section::Contours
            | Section::AuxiliaryBlank
            | Section::AuxiliaryContour
            | Section::Milling
            | Section::Assignment
            | Section::Subprogram => false,
        };
        let words = rest.of(text).trim_ascii();
        if alone && !words.is_empty() {
            self.core.say(rest, codes::P1003::has_no_place_behind_section(&readable(words)));
        }
    }

    /// END, RETURN of a macro, M30.
    pub(super) fn end_of_job(&mut self, rewind: bool) -> Outcome {
        if self.core.levels.len() > 1 {
            self.core.say_here(codes::P2013::subprogram_ends_job());
            self.core.stop_run();
            return Err(Reported);
        }
        if let Some(loc) = self.core.level().frame.open() {
            self.core.report(codes::T1009::this_is_not_closed_when_program_ends().at(loc));
        }
        self.geometry.finish(&self.core);
        let has_unit = self.sections.unit_said || self.core.job.settings.control.unit.is_some();
        if self.sections.family() == Family::DinPlus && !has_unit {
            let loc = Loc { file: self.core.job.main, line: 1, span: Span::at(0, 1) };
            self.core.job.diags.push(codes::T1013::no_unit_line().answer(Answer::key("control", "unit")).at(loc));
        }
        self.core.send_function(&Function::End { rewind }, &self.st.ctx);
        self.core.stop_run();
        if !rewind && self.core.level().frame.kind == LevelKind::Main {
            self.core.look_behind_end();
        }
        Ok(())
    }

    /// The file ends without END or RETURN.
    pub(super) fn file_over(&mut self) {
        let _ = self.settle_chain();
        let called = self.core.levels.len() > 1 || self.sections.passing;
        if called || self.sections.framed {
            let loc = self.core.end_of_text();
            self.core.report(codes::P1006::file_ends(&if called { "RETURN" } else { "END" }).at(loc));
            self.core.stop_run();
            return;
        }
        self.core.may_end_open("END or M30", "M30", None);
        let _ = self.end_of_job(false);
    }
}

/// The name in `ID"…"`.
fn quoted_id(text: &[u8]) -> Option<&[u8]> {
    let rest = text.get(..2).filter(|id| id.eq_ignore_ascii_case(b"ID")).and(text.get(2..))?;
    rest.trim_ascii().strip_prefix(b"\"")?.strip_suffix(b"\"")
}
