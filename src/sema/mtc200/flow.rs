//! Program flow: labels, branches, subroutines, called programs, ends.
//!
//! Source: M 4 (docs/sources.md).

use rustc_hash::FxHashMap;

use crate::diag::{Label, codes};
use crate::ir::Function;
use crate::machine::AxisSet;
use crate::parser::mtc200::{SPLIT, label_of};
use crate::parser::symbols::{Symbol, Symbols};
use crate::sema::Job;
use crate::sema::run::unexecuted::Texts;
use crate::sema::run::{Core, Program, Wanted, not_opened};
use crate::text::{FileError, FileId, Loc, Next, Place, Span, Within};

use super::g_functions::Offset;
use super::header::Header;
use super::state::State;
use super::words::{Condition, Flow, FlowWord, Words};
use super::{Outcome, Reported, Run};

/// Nesting of subroutines that the control allows.
const MOST_LEVELS: usize = 10;
/// Results nearer to zero than this, and not zero, come from rounding.
const NEAR_ZERO: f64 = 1e-9;
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
        let mut names: Vec<&str> = self.0.keys().map(|label| symbols.name(*label)).collect();
        names.sort_unstable();
        crate::machine::tree::did_you_mean(name, names).map(str::to_owned)
    }
}

/// Is this the first or the last line of a file header?
fn begins_header(line: &[u8]) -> bool {
    line.trim_ascii().get(..4).is_some_and(|start| start.eq_ignore_ascii_case(b"%NPG"))
}

fn is_of_header(line: &[u8]) -> bool {
    line.trim_ascii().first().is_none_or(|first| b"%!#$*".contains(first))
}

impl Run<'_> {
    /// A program is over. What stands behind it in its file is not read, and must not be another program: which one a number
    /// means would not be certain.
    fn is_alone(&mut self, program: usize) {
        if std::mem::replace(&mut self.core.programs[program].known.alone, true) {
            return;
        }
        let sources = self.core.job.sources;
        let source = &mut self.core.programs[program].source;
        let file = source.file;
        let mut second = None;
        while second.is_none() {
            let place = source.cursor.place();
            match source.cursor.next(sources) {
                Ok(Next::Block(block)) => second = begins_header(block.text).then_some(place),
                Ok(Next::TooLong { .. }) => {}
                Ok(Next::End) | Err(_) => break,
            }
        }
        if let Some(loc) = second.map(|place: Place| Loc { file, line: place.line, span: Span::at(place.at, 4) }) {
            let found = codes::P1009::second_program_begins_here().at(loc);
            self.core
                .report(found.help("put each program into a file of its own, named by its number: `5.npg` for JSR P5"));
        }
    }

    /// The word of the block that says where the program goes on; acts last.
    pub(super) fn go_on(&mut self, word: FlowWord, w: &Words) -> Outcome {
        let program = match (word.flow, w.program) {
            (Flow::JumpProgram | Flow::CallProgram, Some(at)) => Some(self.whole(at, "P")?),
            (Flow::JumpProgram | Flow::CallProgram, None) => {
                return self.core.refuse(word.span, codes::P1004::jmp_and_jsr_name_program());
            }
            _ => None,
        };
        self.flow_reading(word.flow, word.span);
        match (word.flow, word.label, program) {
            (Flow::Return, ..) => self.end_of_program(true, word.span),
            (Flow::ProgramEnd, ..) => self.end_of_program(false, word.span),
            (Flow::Halt, ..) => {
                self.function(Function::Stop);
                Ok(())
            }
            (Flow::EndOfSubroutine, ..) => self.return_from(word.span),
            (Flow::Branch(condition), Some(label), _) => {
                if self.holds(condition, word.span)? {
                    let place = self.find(label, word.span)?;
                    return self.core.jump_to(place);
                }
                Ok(())
            }
            (Flow::Call, Some(label), _) => {
                let place = self.find(label, word.span)?;
                let program = self.core.level().program;
                self.call_part(program, false, place)
            }
            (Flow::StopAndBranch, Some(label), _) => self.stop_and_branch(label, word.span),
            (Flow::Reverse, Some(label), _) => {
                self.find(label, word.span)?;
                self.without_geometry("REV", word.span);
                Ok(())
            }
            (Flow::JumpProgram, _, Some(number)) => self.jump_program(number),
            (Flow::CallProgram, _, Some(number)) => self.call_program(number),
            // Words and labels were paired when they were gathered.
            _ => Ok(()),
        }
    }

    fn holds(&mut self, condition: Condition, span: Span) -> Outcome<bool> {
        if condition == Condition::Always {
            return Ok(true);
        }
        let Some(result) = self.result else {
            self.core.stop_run();
            return self.core.refuse(span, codes::M2204::no_result_was_calculated_before_this_branch());
        };
        if result != 0.0 && result.abs() < NEAR_ZERO {
            self.core.stop_run();
            return self.core.refuse(span, codes::M2205::last_result_is_nearly_zero(&format_args!("{result:.1e}")));
        }
        Ok(match condition {
            Condition::Always => true,
            Condition::Zero => result == 0.0,
            Condition::NotZero => result != 0.0,
            Condition::NotNegative => result >= 0.0,
            Condition::Negative => result < 0.0,
        })
    }

    fn labels(&mut self) -> &Labels {
        let (job, here) = (self.core.job, self.core.here.origin.loc);
        let at = self.core.level().program;
        let Core { programs, symbols, .. } = &mut self.core;
        let Program { source, known } = &mut programs[at];
        known.labels.get_or_insert_with(|| Labels::scan(&job, source.file, symbols, here))
    }

    fn find(&mut self, label: Symbol, span: Span) -> Outcome<Place> {
        if let Some(place) = self.labels().0.get(&label) {
            return Ok(*place);
        }
        let at = self.core.level().program;
        // It may be a label of another program in the file.
        self.is_alone(at);
        let name = self.core.symbols.name(label);
        let like =
            self.core.programs[at].known.labels.as_ref().and_then(|labels| labels.like(name, &self.core.symbols));
        let found = codes::P2011::label_is_not_set(&name).at(self.core.loc(span));
        // Going on past a jump would run blocks that never run.
        self.core.stop(match like {
            Some(like) => found.help(format!("did you mean `.{like}`?")),
            None => found.help("set it at the start of a block: `.LOOP G01 X10`"),
        })
    }

    fn call_part(&mut self, program: usize, called_program: bool, to: Place) -> Outcome {
        let most = MOST_LEVELS.min(self.core.job.settings.limits.call_depth);
        if self.core.levels.len() > most {
            return self.core.too_deep(codes::P4003::subroutines_are_nested_deeper(&most));
        }
        self.core.enter(program, to, Frame { called_program })
    }

    fn return_from(&mut self, span: Span) -> Outcome {
        if self.core.levels.len() < 2 {
            self.core.stop_run();
            return self.core.refuse(span, codes::M2203::rts_without_call_by_bsr_or_jsr());
        }
        if self.core.level().frame.called_program {
            let program = self.core.level().program;
            self.is_alone(program);
        }
        self.core.leave().map(drop)
    }

    // Other programs.

    fn open_numbered(&mut self, number: u32) -> Outcome<usize> {
        let name = number.to_string();
        let wanted = |extensions| Wanted { name: &name, extensions, within: Within::Anywhere };
        let [one, other] = [EXTENSIONS, &EXTENSIONS[2..]].map(|extensions| self.core.opens(&wanted(extensions)));
        let program = match (one, other) {
            (Some(one), Some(other)) if one != other => {
                let names = FileError::Ambiguous { names: vec![one, other] };
                self.core.report(not_opened(names, &name, self.core.here.origin.loc));
                None
            }
            _ => self.core.open_called(&wanted(EXTENSIONS)),
        };
        if let Some(program) = program {
            return Ok(program);
        }
        // What the program would have done is unknown: nothing after it can be trusted.
        self.st.position.lose(AxisSet::MAIN);
        self.lost();
        self.core.stop_run();
        Err(Reported)
    }

    fn call_program(&mut self, number: u32) -> Outcome {
        let program = self.open_numbered(number)?;
        if self.core.is_running(program) {
            return self.core.end_run(codes::P4003::program_calls_itself(&number));
        }
        self.core.programs[program].known.header = Header::Start;
        let start = self.core.programs[program].source.cursor.start();
        self.call_part(program, true, start)
    }

    /// JMP ends this program with a reset of all modal states, and another one begins.
    fn jump_program(&mut self, number: u32) -> Outcome {
        if self.core.levels.len() > 1 {
            return self.core.end_run(codes::P2013::jmp_in_subroutine_leaves_it_without_rts());
        }
        let program = self.open_numbered(number)?;
        let ended = self.core.level().program;
        self.is_alone(ended);
        self.core.note_jump();
        self.reset();
        self.core.programs[program].known.header = Header::Start;
        let start = self.core.programs[program].source.cursor.start();
        self.core.level().program = program;
        self.core.seek(start)
    }

    /// All modal states as at the start; the tool stays where it is, and so does the work offset.
    fn reset(&mut self) {
        self.warn_open();
        let old = std::mem::replace(&mut self.st, State::new(self.core.job.settings));
        // The end of a program cancels the programmed offset: positions count from the work offset again.
        self.st.position = old.position;
        self.st.position.through_frame(&old.ctx.frame, &self.st.ctx.frame);
        self.st.offsets.forget_written();
        self.st.tool = old.tool;
        if old.offsets.offset() != Offset::Start {
            // Which offset is in force now depends on the machine, and the output still has the old one.
            self.st.offsets.reset();
            self.st.forget(self.st.position.at().known());
        }
    }

    // Ends.

    fn stop_and_branch(&mut self, label: Symbol, span: Span) -> Outcome {
        let place = self.find(label, span)?;
        let elsewhere = self.core.level().program != 0;
        if elsewhere || self.core.program().known.first.is_some_and(|first| place.at > first) {
            self.core.stop_run();
            return self.core.refuse(span, codes::M2208::next_start_would_go(&self.core.symbols.name(label)));
        }
        self.end_of_program(true, span)
    }

    /// RET, M02, M30, PROGRAMMENDE.
    pub(super) fn end_of_program(&mut self, rewind: bool, span: Span) -> Outcome {
        if self.core.levels.iter().any(|level| level.frame.called_program) {
            self.core.stop_run();
            return self.core.refuse(span, codes::P2013::called_program_ends_whole_job());
        }
        let ended = self.core.level().program;
        self.is_alone(ended);
        self.warn_open();
        self.core.end_is_whole();
        self.function(Function::End { rewind });
        self.core.stop_run();
        Ok(())
    }

    fn warn_open(&mut self) {
        if self.st.compensation.is_on() {
            self.core.report(codes::P2041::program_ends_with_path_compensation().at(self.core.here.origin.loc));
        }
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
            Header::Open => {
                self.core.report(codes::M1002::header_of_file_never_ends().at(loc));
            }
            Header::Closed => {
                self.core.report(codes::P1006::file_ends_without_ret_or_m30().at(loc));
            }
            Header::Start | Header::None => {
                if self.core.is_between_percents() || self.core.may_end_open("RET or M30", "RET", None) {
                    self.core.report(codes::P1007::program_ends_without_ret_or_m30().at(loc));
                }
                self.warn_open();
                self.function(Function::End { rewind: false });
            }
        }
    }
}
