//! Program flow: labels, branches, subroutines, called programs, ends.
//!
//! Source: reference section 4.

use rustc_hash::FxHashMap;

use crate::diag::{CallPath, Diagnostic, codes};
use crate::ir::{Function, Side};
use crate::machine::AxisSet;
use crate::parser::mtc200::{SPLIT, label_of};
use crate::parser::symbols::{Symbol, Symbols};
use crate::text::blocks::Place;
use crate::text::{FileId, Loc, Next, Span};

use super::super::Job;
use super::super::exec::{open_cursor, open_program};
use super::header::Header;
use super::state::{Offset, State};
use super::words::{Condition, Flow, FlowWord, Words};
use super::{Outcome, Reported, Run};

/// Nesting of subroutines that the control allows.
const MOST_LEVELS: usize = 10;
/// Results nearer to zero than this, and not zero, come from rounding.
const NEAR_ZERO: f64 = 1e-9;
/// Extensions of called programs.
const EXTENSIONS: &[&str] = &["dat", "npg", "DAT", "NPG"];

/// A level of the call stack.
#[derive(Debug)]
pub(super) struct Level {
    /// Index of the program that runs on this level.
    pub program: usize,
    /// Called with JSR.
    pub called_program: bool,
    /// Where the caller goes on.
    back: Place,
    pub call: CallPath,
    /// The block that called.
    site: Loc,
}

impl Level {
    pub fn main(program: usize) -> Level {
        Level { program, called_program: false, back: Place::default(), call: CallPath::MAIN, site: Loc::default() }
    }
}

/// The labels of a program, found in one pass over its text.
#[derive(Debug, Default)]
pub(super) struct Labels(FxHashMap<Symbol, Place>);

impl Labels {
    fn scan(job: &Job<'_>, file: FileId, symbols: &mut Symbols, from: Loc) -> Labels {
        let mut labels = Labels::default();
        let Some(mut cursor) = open_cursor(job, file, SPLIT, from) else { return labels };
        loop {
            let found = match cursor.next(job.sources) {
                Ok(Next::Block(found)) => found,
                Ok(Next::TooLong { .. }) => continue,
                Ok(Next::End) | Err(_) => return labels,
            };
            let Some((label, span)) = label_of(found.text, symbols) else { continue };
            let place = Place { at: found.at, line: found.line };
            if let Some(first) = labels.0.get(&label) {
                let loc = Loc { file, line: found.line, span: span.shifted(found.at) };
                let first = Loc { file, line: first.line, span: Span::at(first.at, 1) };
                let name = symbols.name(label);
                job.diags.push(
                    Diagnostic::new(codes::M2202, loc, format!("the label .{name} is set twice"))
                        .also(first, "first set here")
                        .help("rename one of them"),
                );
                continue;
            }
            labels.0.insert(label, place);
        }
    }

    fn like(&self, name: &str, symbols: &Symbols) -> Option<String> {
        let mut names: Vec<&str> = self.0.keys().map(|label| symbols.name(*label)).collect();
        names.sort_unstable();
        crate::machine::tree::did_you_mean(name, names).map(str::to_owned)
    }
}

impl Run<'_> {
    /// The word of the block that says where the program goes on; acts last.
    pub(super) fn go_on(&mut self, word: FlowWord, w: &Words) -> Outcome {
        let program = match (word.flow, w.program) {
            (Flow::JumpProgram | Flow::CallProgram, Some(at)) => Some(self.whole(at, "P")?),
            (Flow::JumpProgram | Flow::CallProgram, None) => {
                return self.missing(word.span, "JMP and JSR name a program: `JSR P5`");
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
                    self.budget.jump(self.here.origin.loc);
                    return self.seek(place);
                }
                Ok(())
            }
            (Flow::Call, Some(label), _) => {
                let place = self.find(label, word.span)?;
                let program = self.level().program;
                self.enter(program, false, place)
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
            let help = "assign the variable that the branch is about in the block before";
            self.ended = true;
            return self.fail_help(codes::M2204, span, "no result was calculated before this branch", help);
        };
        if result != 0.0 && result.abs() < NEAR_ZERO {
            self.ended = true;
            let message = format!("the last result is {result:.1e}, nearly zero");
            let help = "count with whole numbers, or compare with a margin";
            return self.fail_help(codes::M2205, span, message, help);
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
        let (job, here) = (self.job, self.here.origin.loc);
        let at = self.level().program;
        let program = &mut self.programs[at];
        let (file, symbols) = (program.source.file, &mut self.symbols);
        program.labels.get_or_insert_with(|| Labels::scan(&job, file, symbols, here))
    }

    fn find(&mut self, label: Symbol, span: Span) -> Outcome<Place> {
        if let Some(place) = self.labels().0.get(&label) {
            return Ok(*place);
        }
        let at = self.level().program;
        let name = self.symbols.name(label);
        let like = self.programs[at].labels.as_ref().and_then(|labels| labels.like(name, &self.symbols));
        let found = Diagnostic::new(codes::M2201, self.loc(span), format!("the label .{name} is not set"));
        self.report(match like {
            Some(like) => found.help(format!("did you mean `.{like}`?")),
            None => found.help("set it at the start of a block: `.LOOP G01 X10`"),
        });
        // Going on past a jump would run blocks that never run.
        self.ended = true;
        Err(Reported)
    }

    pub(super) fn seek(&mut self, place: Place) -> Outcome {
        let sources = self.job.sources;
        if let Err(error) = self.program().source.cursor.seek(sources, place) {
            self.error(codes::P0105, format!("the file cannot be read: {error}"));
            self.ended = true;
            return Err(Reported);
        }
        Ok(())
    }

    fn enter(&mut self, program: usize, called_program: bool, to: Place) -> Outcome {
        let site = self.here.origin.loc;
        let most = MOST_LEVELS.min(self.job.settings.limits.call_depth);
        if self.levels.len() > most {
            self.error(codes::P4003, format!("subroutines are nested deeper than {most} levels"));
            self.ended = true;
            return Err(Reported);
        }
        // The place to come back to needs the caller in memory.
        let sources = self.job.sources;
        if let Err(error) = self.program().source.cursor.load(sources) {
            self.error(codes::P0105, format!("the file cannot be read: {error}"));
            self.ended = true;
            return Err(Reported);
        }
        let back = self.program().source.cursor.place();
        let call = self.job.trail.enter(self.level().call, site);
        self.levels.push(Level { program, called_program, back, call, site });
        self.budget.jump(site);
        self.seek(to)
    }

    fn return_from(&mut self, span: Span) -> Outcome {
        if self.levels.len() < 2 {
            self.ended = true;
            let help = "end the main part with RET in front of the subroutines";
            return self.fail_help(codes::M2203, span, "RTS without a call by BSR or JSR", help);
        }
        match self.levels.pop() {
            Some(level) => self.seek(level.back),
            None => Ok(()),
        }
    }

    // Other programs.

    fn open_numbered(&mut self, number: u32) -> Outcome<usize> {
        let (site, call) = (self.here.origin.loc, self.here.origin.call);
        self.budget.search();
        let opened = open_program(&self.job, &number.to_string(), EXTENSIONS, site, call);
        if let Some(program) = opened.and_then(|file| self.open(file, site)) {
            return Ok(program);
        }
        // What the program would have done is unknown: nothing after it can be trusted.
        self.st.position.lose(AxisSet::MAIN);
        self.lost();
        self.ended = true;
        Err(Reported)
    }

    fn call_program(&mut self, number: u32) -> Outcome {
        let program = self.open_numbered(number)?;
        if self.levels.iter().any(|level| level.program == program) {
            self.error(codes::P4003, format!("program {number} calls itself"));
            self.ended = true;
            return Err(Reported);
        }
        self.programs[program].header = Header::Start;
        let start = self.programs[program].source.cursor.start();
        self.enter(program, true, start)
    }

    /// JMP ends this program with a reset of all modal states, and another one begins.
    fn jump_program(&mut self, number: u32) -> Outcome {
        if self.levels.len() > 1 {
            self.error(codes::M2206, "JMP in a subroutine leaves it without RTS");
            self.ended = true;
            return Err(Reported);
        }
        let program = self.open_numbered(number)?;
        self.budget.jump(self.here.origin.loc);
        self.reset();
        self.programs[program].header = Header::Start;
        let start = self.programs[program].source.cursor.start();
        self.level().program = program;
        self.seek(start)
    }

    /// All modal states as at the start; the tool stays where it is, and so does the work offset.
    fn reset(&mut self) {
        self.warn_open();
        let old = std::mem::replace(&mut self.st, State::new(self.job.settings));
        // The end of a program cancels the programmed offset: positions count from the work offset again.
        self.st.position = old.position;
        self.st.position.through_frame(&old.ctx.frame, &self.st.ctx.frame);
        self.st.written = AxisSet::EMPTY;
        self.st.selected = old.selected;
        self.st.tool = old.tool;
        if old.offset != Offset::Start {
            // Which offset is in force now depends on the machine, and the output still has the old one.
            self.st.offset = Offset::Reset;
            self.st.forget(self.st.position.at().known());
        }
    }

    // Ends.

    fn stop_and_branch(&mut self, label: Symbol, span: Span) -> Outcome {
        let place = self.find(label, span)?;
        let elsewhere = self.level().program != 0;
        if elsewhere || self.program().first.is_some_and(|first| place.at > first) {
            self.ended = true;
            let message = format!("the next start would go on at .{}", self.symbols.name(label));
            let help = "end the program with RET, or put the label at the top";
            return self.fail_help(codes::M2208, span, message, help);
        }
        self.end_of_program(true, span)
    }

    /// RET, M02, M30, PROGRAMMENDE.
    pub(super) fn end_of_program(&mut self, rewind: bool, span: Span) -> Outcome {
        if self.levels.iter().any(|level| level.called_program) {
            self.ended = true;
            let help = "end a called program with RTS";
            return self.fail_help(codes::M2206, span, "a called program ends the whole job", help);
        }
        self.warn_open();
        self.function(Function::End { rewind });
        self.ended = true;
        Ok(())
    }

    fn warn_open(&mut self) {
        if self.st.side != Side::None {
            let text = "the program ends with path compensation on";
            self.report(
                Diagnostic::new(codes::M2601, self.here.origin.loc, text)
                    .help("program G40 with a straight move before the end"),
            );
        }
    }

    /// The file has no further block.
    pub(super) fn end_of_file(&mut self) {
        let place = self.program().source.cursor.place();
        let file = self.program().source.file;
        let line = place.line.saturating_sub(1).max(1);
        let loc = Loc { file, line, span: Span::at(place.at.saturating_sub(1), 1) };
        self.here.origin.loc = loc;
        self.ended = true;
        if self.levels.len() > 1 {
            let site = self.level().site;
            self.report(
                Diagnostic::new(codes::M2207, site, "the subroutine called here has no RTS")
                    .also(loc, "the file ends here")
                    .help("add RTS at its end"),
            );
            return;
        }
        match self.program().header {
            Header::Open => {
                self.report(
                    Diagnostic::new(codes::M1002, loc, "the header of the file never ends")
                        .help("a second line `%NPG` ends it"),
                );
            }
            Header::Closed => {
                self.report(
                    Diagnostic::new(codes::M1008, loc, "the file ends without RET or M30")
                        .help("it may have been cut off in transfer; if it is complete, add RET"),
                );
            }
            Header::Start | Header::None => {
                self.report(Diagnostic::new(codes::M1009, loc, "the program ends without RET or M30"));
                self.warn_open();
                self.function(Function::End { rewind: false });
            }
        }
    }
}
