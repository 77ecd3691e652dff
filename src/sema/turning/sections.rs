//! Sections of a program, header lines, units; which control a program was written for.

use crate::diag::{Answer, Label, codes};
use crate::ir::Function;
use crate::machine::{Settings, Unit};
use crate::parser::turning::ast::{Block, Section, Stmt, Value};
use crate::parser::turning::parse_block;
use crate::text::{Loc, Next, Span, decode::readable};

use super::calls::LevelKind;
use super::program_parts::{Family, ProgramPart};
use super::words::{Words, letters};
use super::{Outcome, Reported, Run};

/// The sections met so far.
#[derive(Debug)]
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
    /// That another slide moves, and that names are not read, was said.
    slide_said: bool,
    names_said: bool,
}

impl Sections {
    pub fn new(settings: &Settings) -> Sections {
        let configured = match settings.control.heidenhain_turning.as_str() {
            "manualplus4110" => Some(Family::Basic),
            "" => None,
            _ => Some(Family::DinPlus),
        };
        Sections {
            configured,
            family: configured,
            part: ProgramPart::Start,
            tools: Vec::new(),
            unit_said: false,
            unit_open: false,
            framed: false,
            passing: false,
            slide_said: false,
            names_said: false,
        }
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

impl Run<'_> {
    /// `%name.nc`
    pub(super) fn program_line(&mut self) -> Outcome {
        if self.core.level().frame.begun {
            return self.core.refuse(self.core.block_span(), codes::T1008::program_name_stands_in_middle_of_program());
        }
        self.core.level().frame.begun = true;
        self.sections.framed = true;
        Ok(())
    }

    /// A section or header line of DIN PLUS.
    fn enter_din_plus(&mut self) -> Outcome {
        self.sections.framed = true;
        match (self.sections.configured, self.sections.family) {
            (Some(Family::Basic), _) => {
                // Once is enough; what follows is read as what it is.
                self.sections.configured = Some(Family::DinPlus);
                self.sections.family = Some(Family::DinPlus);
                self.core.refuse(
                    self.core.block_span(),
                    codes::T2017::programs_of_manualplus_4110_have_no_sections()
                        .answer(Answer::key("control", "heidenhain_turning")),
                )
            }
            (None, Some(Family::Basic)) => {
                self.core.refuse(self.core.block_span(), codes::T1008::section_begins_behind_blocks_that_ran_already())
            }
            _ => {
                self.sections.family = Some(Family::DinPlus);
                Ok(())
            }
        }
    }

    /// `#UNIT METRIC`
    pub(super) fn head_line(&mut self, key: &[u8], value: &[u8], span: Span) -> Outcome {
        self.enter_din_plus()?;
        if !matches!(self.sections.part, ProgramPart::Start | ProgramPart::Head) {
            return self.core.refuse(self.core.block_span(), codes::T1008::header_lines_stand_in_section_header());
        }
        let key = key.to_ascii_uppercase();
        let value = readable(value).trim().to_ascii_uppercase();
        match key.as_slice() {
            b"UNIT" | b"EINHEIT" => self.unit_line(&value, span),
            b"SLIDE" | b"SCHLITTEN" => {
                if value.split(|c: char| !c.is_alphanumeric() && c != '$').any(|slide| slide == "$1" || slide == "1") {
                    return Ok(());
                }
                self.core.refuse(span, codes::T2022::program_is_for_slide(&value))
            }
            // Free text.
            _ => Ok(()),
        }
    }

    fn unit_line(&mut self, value: &str, span: Span) -> Outcome {
        self.sections.unit_said = true;
        let unit = match value.trim_start_matches('/') {
            "METRIC" | "METRISCH" | "MM" => Unit::Mm,
            "INCH" | "ZOLL" => Unit::Inch,
            _ => {
                return self.core.refuse(span, codes::T1014::is_no_unit(&value));
            }
        };
        self.st.unit = unit;
        Ok(())
    }

    pub(super) fn section(&mut self, section: Section, rest: Span, text: &[u8]) -> Outcome {
        self.settle_chain()?;
        match section {
            Section::Return => return self.return_section(),
            Section::End if self.sections.passing => {
                return self.core.refuse(self.core.block_span(), codes::T1008::subprogram_ends_with_return());
            }
            Section::End => return self.end_of_job(false),
            _ => {}
        }
        if self.core.levels.len() > 1 {
            return self.core.refuse(self.core.block_span(), codes::T1008::section_begins_inside_subprogram());
        }
        self.enter_din_plus()?;
        if let Some(nest) = self.core.level().frame.nests.last() {
            let loc = nest.loc;
            self.core.report(
                codes::T1009::this_is_not_closed_when_next_section()
                    .at(loc)
                    .also(self.core.here.origin.loc, Label::Section),
            );
            self.core.level().frame.nests.clear();
        }
        self.core.level().frame.begun = true;
        self.finish_contour();
        self.sections.part = match section {
            Section::Head => ProgramPart::Head,
            Section::Turret => ProgramPart::Turret,
            Section::Clamping | Section::AuxiliaryBlank | Section::Milling => ProgramPart::Unread,
            Section::Contours => self.contours(rest, text)?,
            Section::Blank | Section::Finished | Section::AuxiliaryContour => {
                self.geometry.in_blank = section == Section::Blank;
                let id = rest.of(text).trim_ascii();
                let name = quoted_id(id);
                if !id.is_empty() && name.is_none() && section == Section::AuxiliaryContour {
                    return self.core.refuse(rest, codes::P1001::this_does_not_name_contour());
                }
                self.begin_contour(name.map(|name| readable(name).into_owned()));
                ProgramPart::Contour
            }
            Section::Machining => ProgramPart::Machining,
            Section::Assignment => {
                self.assignment(rest, text)?;
                ProgramPart::Machining
            }
            Section::Names => ProgramPart::Names,
            Section::Subprogram => {
                self.sections.passing = true;
                ProgramPart::Unread
            }
            Section::Return | Section::End => self.sections.part,
        };
        Ok(())
    }

    /// `CONTOUR Q1 X0 Z0`: one part at the workpiece zero is what every program means.
    fn contours(&mut self, rest: Span, text: &[u8]) -> Outcome<ProgramPart> {
        let mut block = Block::default();
        parse_block(rest.of(text), &mut block, &mut self.core.problems);
        let plain = block.words.iter().all(|word| match (word.address.addr.letter(), word.value) {
            (Some(b'Q'), Value::Number { value, .. }) => value == 1.0,
            (Some(b'X' | b'Z'), Value::Number { value, .. }) => value == 0.0,
            _ => false,
        });
        if !self.core.problems.is_empty() || !plain {
            self.core.problems.clear();
            return self.core.refuse(self.core.block_span(), codes::T9002::several_contours_on_one_bar_are_not());
        }
        Ok(ProgramPart::Between)
    }

    fn assignment(&mut self, rest: Span, text: &[u8]) -> Outcome {
        let rest = rest.of(text).trim_ascii();
        if rest == b"$1" {
            return Ok(());
        }
        self.core.refuse(self.core.block_span(), codes::T2022::these_blocks_are_for_other_slides())
    }

    /// `$1` in front of blocks.
    pub(super) fn slide(&mut self, number: u32) -> Outcome {
        if number == 1 {
            return Ok(());
        }
        self.lose_all();
        if std::mem::replace(&mut self.sections.slide_said, true) {
            return Err(Reported);
        }
        self.core.refuse(self.core.block_span(), codes::T2022::block_is_for_slide(&number))
    }

    /// A line of the sections CONST and VAR.
    pub(super) fn names_line(&mut self) -> Outcome {
        if std::mem::replace(&mut self.sections.names_said, true) {
            return Err(Reported);
        }
        self.core.refuse(self.core.block_span(), codes::T9002::names_of_constants())
    }

    /// `UNIT` and `END_OF_UNIT`: the blocks between stand there in full.
    pub(super) fn unit(&mut self, opens: bool) -> Outcome {
        self.settle_chain()?;
        if self.sections.unit_open == opens {
            self.core.say_here(if opens {
                codes::T1012::unit_begins_inside_another()
            } else {
                codes::T1012::unit_ends_that_did_not_begin()
            });
        }
        self.sections.unit_open = opens;
        Ok(())
    }

    /// `T1 ID"…"`
    pub(super) fn turret_line(&mut self, w: &Words, text: &[u8]) -> Outcome {
        let Some(num) = w.get(b'T') else {
            return self.core.refuse(self.core.block_span(), codes::P1004::line_of_turret_section_names_position());
        };
        if w.present() & !letters("T") != 0 || !w.longs().is_empty() || !w.g().is_empty() {
            let tool = num.value;
            self.core.say_here(codes::T2023::data_of_this_tool_is_not_used(&tool).answer(Answer::tool(tool, "radius")));
        }
        let name = w.text("ID").map(|span| readable(span.of(text)).into_owned());
        let digits = num.span.of(text);
        let edge = digits.iter().position(|b| *b == b'.').and_then(|at| digits.get(at + 1)).map_or(0, |b| b - b'0');
        if let Some(name) = name {
            self.sections.tools.push((num.value as u32, edge, name));
        }
        Ok(())
    }

    fn return_section(&mut self) -> Outcome {
        if self.sections.passing {
            self.sections.passing = false;
            self.sections.part = ProgramPart::Between;
            return Ok(());
        }
        match self.core.level().frame.kind {
            LevelKind::Main => self.end_of_job(false),
            _ => self.return_from_subprogram(),
        }
    }

    /// END, RETURN of a macro, M30.
    pub(super) fn end_of_job(&mut self, rewind: bool) -> Outcome {
        if self.core.levels.len() > 1 {
            self.core.say_here(codes::P2013::subprogram_ends_job());
            self.core.stop_run();
            return Err(Reported);
        }
        if let Some(nest) = self.core.level().frame.nests.last() {
            let loc = nest.loc;
            self.core.report(codes::T1009::this_is_not_closed_when_program_ends().at(loc));
        }
        self.finish_contour();
        if self.sections.family() == Family::DinPlus
            && !self.sections.unit_said
            && self.core.job.settings.control.unit.is_none()
        {
            let loc = Loc { file: self.core.job.main, line: 1, span: Span::at(0, 1) };
            self.core.job.diags.push(codes::T1013::no_unit_line().answer(Answer::key("control", "unit")).at(loc));
        }
        self.function(Function::End { rewind });
        self.core.stop_run();
        if !rewind && self.core.level().frame.kind == LevelKind::Main {
            self.look_behind_end();
        }
        Ok(())
    }

    /// Warns about blocks behind END; local subprograms may stand there.
    fn look_behind_end(&mut self) {
        let sources = self.core.job.sources;
        let program = self.core.program();
        let file = program.source.file;
        let mut block = Block::default();
        let mut ignored = Vec::new();
        let found = loop {
            let Ok(Next::Block(text)) = program.source.cursor.next(sources) else { return };
            parse_block(text.text, &mut block, &mut ignored);
            ignored.clear();
            match block.stmt {
                Stmt::Empty => {}
                Stmt::Section(Section::Subprogram, _) => return,
                _ => break Loc { file, line: text.line, span: block.span.shifted(text.at) },
            }
        };
        self.core.report(codes::P1008::this_stands_behind_end_of_program().at(found));
    }

    /// The file ends without END or RETURN.
    pub(super) fn file_over(&mut self) {
        let _ = self.settle_chain();
        let called = self.core.levels.len() > 1;
        if called || self.sections.framed || self.sections.passing {
            let loc = self.core.end_of_text();
            let what = if called || self.sections.passing { "RETURN" } else { "END" };
            self.core.report(codes::P1006::file_ends(&what).at(loc));
            self.core.stop_run();
            return;
        }
        self.core.may_end_open("END or M30", "M30", None);
        let _ = self.end_of_job(false);
    }
}

/// The name in `ID"…"`.
pub(super) fn quoted_id(text: &[u8]) -> Option<&[u8]> {
    let rest = text.get(..2).filter(|id| id.eq_ignore_ascii_case(b"ID")).and(text.get(2..))?;
    rest.trim_ascii().strip_prefix(b"\"")?.strip_suffix(b"\"")
}
