//! Program flow: labels, branches, subroutines, called programs, ends.
//!
//! Source: M 4 (docs/sources.md).

use std::ops::ControlFlow;

use rustc_hash::FxHashMap;

use crate::diag::{Label, codes};
use crate::ir::Function;
use crate::machine::AxisSet;
use crate::parser::mtc200::{SPLIT, label_of};
use crate::parser::symbols::{Symbol, Symbols};
use crate::sema::Job;
use crate::sema::common::compensation::Compensation;
use crate::sema::run::unexecuted::Texts;
use crate::sema::run::{Program, Wanted, like, not_opened};
use crate::text::{FileError, FileId, Loc, Place, Span, Within};

use super::header::Header;
use super::words::{Flow, FlowWord, Words};
use super::{Core, Outcome, Reported, Run};

/// Nesting of subroutines that the control allows.
const MOST_LEVELS: usize = 10;
/// Extensions of called programs; none goes before the other.
const EXTENSIONS: &[&str] = &["dat", "DAT", "npg", "NPG"];

/// What a level of the call stack holds.
#[derive(Debug, Default)]
pub(super) struct Frame {
    /// Called with JSR.
    pub called_program: bool,
}

/// The labels of a program, found in one pass over its text.
#[derive(Debug, Default)]
pub(super) struct Labels(FxHashMap<Symbol, Place>);

impl Labels {
    fn scan(job: &Job<'_>, file: FileId, symbols: &mut Symbols, from: Loc) -> Labels {
        let mut labels = Labels::default();
        let Some(mut texts) = Texts::open(job, file, SPLIT, from) else { return labels };
        let mut in_head = true;
        while let Some(found) = texts.next(job) {
            if !in_head && begins_header(found.text) {
                // Labels of another program are none of this one, and what is wrong was said, or is said at its end.
                break;
            }
            in_head &= is_of_header(found.text);
            let Some((label, span)) = label_of(found.text, symbols) else { continue };
            let place = Place { at: found.at, line: found.line };
            if let Some(first) = labels.0.get(&label) {
                let loc = Loc { file, line: found.line, span: span.shifted(found.at) };
                let first = Loc { file, line: first.line, span: Span::at(first.at, 1) };
                let name = symbols.name(label);
                job.diags.push(codes::P2010::label_is_set_twice(&name).at(loc).also(first, Label::FirstSetHere));
                continue;
            }
            labels.0.insert(label, place);
        }
        labels
    }

    fn like(&self, name: &str, symbols: &Symbols) -> Option<String> {
        like(name, self.0.keys().map(|label| symbols.name(*label)))
    }
}

/// Is this the first or the last line of a file header?
fn begins_header(line: &[u8]) -> bool {
    line.trim_ascii().get(..4).is_some_and(|start| start.eq_ignore_ascii_case(b"%NPG"))
}

fn is_of_header(line: &[u8]) -> bool {
    line.trim_ascii().first().is_none_or(|first| b"%!#$*".contains(first))
}

impl Core<'_> {
    /// A program is over. What stands behind it in its file is not read, and must not be another program: which one a number
    /// means would not be certain.
    fn is_alone(&mut self, program: usize) {
        if std::mem::replace(&mut self.programs[program].known.alone, true) {
            return;
        }
        let header = |text: &[u8]| match begins_header(text) {
            true => ControlFlow::Break(Some(Span::at(0, 4))),
            false => ControlFlow::Continue(()),
        };
        if let Some(loc) = self.first_behind(program, header) {
            let found = codes::P1009::second_program_begins_here().at(loc);
            self.report(found.help("put each program into a file of its own, named by its number: `5.npg` for JSR P5"));
        }
    }

    fn labels(&mut self) -> &Labels {
        let (job, here) = (self.job, self.here.origin.loc);
        let at = self.level().program;
        let Core { programs, symbols, .. } = self;
        let Program { source, known } = &mut programs[at];
        known.labels.get_or_insert_with(|| Labels::scan(&job, source.file, symbols, here))
    }

    fn find(&mut self, label: Symbol, span: Span) -> Outcome<Place> {
        if let Some(place) = self.labels().0.get(&label) {
            return Ok(*place);
        }
        let at = self.level().program;
        // It may be a label of another program in the file.
        self.is_alone(at);
        let name = self.symbols.name(label);
        let like = self.programs[at].known.labels.as_ref().and_then(|labels| labels.like(name, &self.symbols));
        let found = codes::P2011::label_is_not_set(&name).at(self.loc(span));
        // Going on past a jump would run blocks that never run.
        self.stop(match like {
            Some(like) => found.help(format!("did you mean `.{like}`?")),
            None => found.help("set it at the start of a block: `.LOOP G01 X10`"),
        })
    }

    fn call_part(&mut self, program: usize, called_program: bool, to: Place) -> Outcome {
        let deeper = codes::P4003::subroutines_are_nested_deeper;
        self.enter_within(MOST_LEVELS, deeper, (program, to), Frame { called_program })
    }

    fn return_from(&mut self, span: Span) -> Outcome {
        if self.levels.len() < 2 {
            self.stop_run();
            return self.refuse(span, codes::M2203::rts_without_call_by_bsr_or_jsr());
        }
        if self.level().frame.called_program {
            let program = self.level().program;
            self.is_alone(program);
        }
        self.leave().map(drop)
    }

    fn open_numbered(&mut self, number: u32) -> Option<usize> {
        let name = number.to_string();
        let wanted = |extensions| Wanted { name: &name, extensions, within: Within::Anywhere };
        match [EXTENSIONS, &EXTENSIONS[2..]].map(|extensions| self.opens(&wanted(extensions))) {
            [Some(one), Some(other)] if one != other => {
                let names = FileError::Ambiguous { names: vec![one, other] };
                self.report(not_opened(names, &name, self.here.origin.loc));
                None
            }
            _ => self.open_called(&wanted(EXTENSIONS)),
        }
    }

    /// The program has not been read; where it starts.
    fn begin_program(&mut self, program: usize) -> Place {
        let Program { source, known } = &mut self.programs[program];
        known.header = Header::Start;
        source.cursor.start()
    }

    /// BST: where the program starts the next time.
    fn starts_again_at(&mut self, label: Symbol, span: Span) -> Outcome {
        let place = self.find(label, span)?;
        let elsewhere = self.level().program != 0;
        if elsewhere || self.program().known.first.is_some_and(|first| place.at > first) {
            self.stop_run();
            return self.refuse(span, codes::M2208::next_start_would_go(&self.symbols.name(label)));
        }
        Ok(())
    }

    fn warn_open(&self, compensation: &Compensation) {
        if compensation.is_on() {
            self.say_here(codes::P2041::program_ends_with_path_compensation());
        }
    }
}

impl Run<'_> {
    /// The word of the block that says where the program goes on; acts last.
    pub(super) fn go_on(&mut self, word: FlowWord, w: &Words) -> Outcome {
        let FlowWord { flow, span, .. } = word;
        let program = match (flow.takes_program(), w.program) {
            (true, Some(at)) => Some(self.core.made(at.whole("P"))?),
            (true, None) => return self.core.refuse(span, codes::P1004::jmp_and_jsr_name_program()),
            (false, _) => None,
        };
        self.core.flow_reading(flow, span);
        match (flow, word.label, program) {
            (Flow::Return, ..) => self.end_of_program(true, span),
            (Flow::ProgramEnd, ..) => self.end_of_program(false, span),
            (Flow::Halt, ..) => {
                self.core.send_function(&Function::Stop, &self.st.ctx);
                Ok(())
            }
            (Flow::EndOfSubroutine, ..) => self.core.return_from(span),
            (Flow::Branch(condition), Some(label), _) => {
                let holds = self.variables.fulfil(condition);
                if holds.is_err() {
                    self.core.stop_run();
                }
                if self.core.accept(span, holds)? {
                    let place = self.core.find(label, span)?;
                    return self.core.jump_to(place);
                }
                Ok(())
            }
            (Flow::Call, Some(label), _) => {
                let place = self.core.find(label, span)?;
                let program = self.core.level().program;
                self.core.call_part(program, false, place)
            }
            (Flow::StopAndBranch, Some(label), _) => {
                self.core.starts_again_at(label, span)?;
                self.end_of_program(true, span)
            }
            (Flow::Reverse, Some(label), _) => {
                self.core.find(label, span)?;
                self.core.without_geometry("REV", span);
                Ok(())
            }
            (Flow::JumpProgram | Flow::CallProgram, _, Some(number)) => {
                self.other_program(number, flow == Flow::JumpProgram)
            }
            // Words and labels were paired when they were gathered.
            _ => Ok(()),
        }
    }

    /// JSR calls a program; JMP ends this one with a reset of all modal states, and another one begins.
    fn other_program(&mut self, number: u32, jumps: bool) -> Outcome {
        if jumps && self.core.levels.len() > 1 {
            return self.core.end_run(codes::P2013::jmp_in_subroutine_leaves_it_without_rts());
        }
        let Some(program) = self.core.open_numbered(number) else {
            // What the program would have done is unknown: nothing after it can be trusted.
            self.st.position.lose(AxisSet::MAIN);
            self.core.send_lost(&self.st.ctx);
            self.core.stop_run();
            return Err(Reported);
        };
        if !jumps {
            if self.core.is_running(program) {
                return self.core.end_run(codes::P4003::program_calls_itself(&number));
            }
            let start = self.core.begin_program(program);
            return self.core.call_part(program, true, start);
        }
        let ended = self.core.level().program;
        self.core.is_alone(ended);
        self.core.note_jump();
        self.core.warn_open(&self.st.compensation);
        self.st.reset(self.core.job.settings);
        let start = self.core.begin_program(program);
        self.core.level().program = program;
        self.core.seek(start)
    }

    /// RET, M02, M30, PROGRAMMENDE.
    pub(super) fn end_of_program(&mut self, rewind: bool, span: Span) -> Outcome {
        if self.core.levels.iter().any(|level| level.frame.called_program) {
            self.core.stop_run();
            return self.core.refuse(span, codes::P2013::called_program_ends_whole_job());
        }
        let ended = self.core.level().program;
        self.core.is_alone(ended);
        self.core.warn_open(&self.st.compensation);
        self.core.end_is_whole();
        self.core.send_function(&Function::End { rewind }, &self.st.ctx);
        self.core.stop_run();
        Ok(())
    }

    /// The file has no further block.
    pub(super) fn file_over(&mut self) {
        let loc = self.core.end_of_text();
        self.core.here.origin.loc = loc;
        self.core.stop_run();
        if self.core.levels.len() > 1 {
            let site = self.core.level().site;
            self.core.report(codes::M2207::subroutine_called_here_has_no_rts().at(site).also(loc, Label::FileEnds));
            return;
        }
        match self.core.program().known.header {
            Header::Open => self.core.say_here(codes::M1002::header_of_file_never_ends()),
            Header::Closed => self.core.say_here(codes::P1006::file_ends_without_ret_or_m30()),
            Header::Start | Header::None => {
                if self.core.is_between_percents() || self.core.may_end_open("RET or M30", "RET", None) {
                    self.core.say_here(codes::P1007::program_ends_without_ret_or_m30());
                }
                self.core.warn_open(&self.st.compensation);
                self.core.send_function(&Function::End { rewind: false }, &self.st.ctx);
            }
        }
    }
}
