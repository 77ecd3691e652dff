//! Runs a HEIDENHAIN turning program: 4110 DIN programs, DIN PLUS and smart.Turn files.
//!
//! X words are diameters here and radii in the contour stream; the working plane is ZX, so points are (Z, X).
//! Source: `reference/heidenhain-turning`, sections 2 to 7 and 13.

mod capture;
mod chain;
mod contour;
mod contour_finishing;
mod contour_words;
mod coordinates;
mod cycles;
mod drilling;
mod eval;
mod finishing;
mod flow;
mod forms;
mod functions;
mod geometry;
mod geometry_forms;
mod machining;
mod modal;
mod moves;
mod mwords;
mod readings;
mod recess_turning;
mod roughing;
mod sections;
mod shifts;
mod sides;
mod simple_recess;
mod simple_thread;
mod state;
mod stock;
mod subprograms;
mod thread_line;
mod threads;
mod undercut_cycle;
mod undercuts;
mod vars;
mod words;

use crate::diag::{CallPath, Code, Diagnostic, codes};
use crate::ir::Function;
use crate::ir::contour::{Move, Sink};
use crate::parser::problem::Problem;
use crate::parser::turning::ast::{Block, Stmt};
use crate::parser::turning::{SPLIT, parse_block};
use crate::text::{FileId, Loc, Next, Span};

use super::exec::{Budget, Parsed, Read, Source, open_cursor};
use super::here::Here;
use super::value::Machine;
use super::{Job, Outcome, Reported};
use capture::Capture;
use chain::Chain;
use geometry::Geometry;
use moves::Tag;
use sections::Sections;
use state::State;
use subprograms::{Level, Names};
use vars::Vars;
use words::Words;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    let mut run = Run {
        job: *job,
        out,
        st: State::new(job.settings),
        vars: Vars::new(&job.settings.variables),
        programs: Vec::new(),
        levels: Vec::new(),
        budget: Budget::new(job.settings.limits.steps),
        calls: 1,
        sections: Sections::new(job.settings),
        geometry: Geometry::default(),
        named: None,
        capture: None,
        chain: Chain::default(),
        machine: Machine::new(eval::RULES),
        words: Some(Box::default()),
        here: Here::default(),
        problems: Vec::new(),
        scratch: None,
        ended: false,
    };
    let start = Loc { file: job.main, line: 1, span: Span::default() };
    let Some(program) = run.open(job.main, start) else { return 0 };
    run.out.begins_at(&run.st.start.position());
    run.levels.push(Level::main(program));
    while !run.ended {
        run.step();
    }
    run.finish();
    run.programs[program].source.cursor.content_hash(job.sources).unwrap_or(0)
}

/// Reads every block of the main program, whether it runs or not, and reports what is wrong with its form.
pub fn check_form(job: &Job<'_>) {
    let start = Loc { file: job.main, line: 1, span: Span::default() };
    let Some(mut cursor) = open_cursor(job, job.main, SPLIT, start) else { return };
    let mut block = Block::default();
    let mut problems = Vec::new();
    while let Ok(Next::Block(text)) = cursor.next(job.sources) {
        parse_block(text.text, &mut block, &mut problems);
        let here = Here::new(job.main, text.at, text.line, text.lines, CallPath::MAIN);
        for problem in problems.drain(..) {
            job.diags.push(here.diagnostic(job, problem));
        }
    }
}

/// A program file and what is known of it.
#[derive(Debug)]
struct Program {
    source: Source<Block>,
    /// Local subprograms, once they were looked for.
    names: Option<Names>,
}

/// A run of a program.
struct Run<'a> {
    job: Job<'a>,
    out: &'a mut dyn Sink,
    st: State,
    vars: Vars,
    programs: Vec<Program>,
    levels: Vec<Level>,
    budget: Budget,
    /// Calls made so far, the main program included.
    calls: u32,
    sections: Sections,
    geometry: Geometry,
    /// The contour that ID of the cycle in hand names.
    named: Option<String>,
    /// The cycle whose contour is being read.
    capture: Option<Box<Capture>>,
    /// Moves that wait for the next one.
    chain: Chain<Tag>,
    machine: Machine,
    words: Option<Box<Words>>,
    here: Here,
    problems: Vec<Problem>,
    scratch: Option<Box<Parsed<Block>>>,
    ended: bool,
}

impl Run<'_> {
    fn open(&mut self, file: FileId, from: Loc) -> Option<usize> {
        if let Some(at) = self.programs.iter().position(|program| program.source.file == file) {
            return Some(at);
        }
        let source = Source::open(&self.job, file, SPLIT, from)?;
        self.programs.push(Program { source, names: None });
        Some(self.programs.len() - 1)
    }

    fn level(&mut self) -> &mut Level {
        self.levels.last_mut().expect("the main level is popped only when the run ends")
    }

    fn program(&mut self) -> &mut Program {
        let at = self.level().program;
        &mut self.programs[at]
    }

    /// Executes one block.
    fn step(&mut self) {
        let (at, call) = (self.level().program, self.level().call);
        if !self.budget.step(&*self.out) {
            self.budget.report_end(&self.job, &*self.out, self.here.origin.loc, call);
            self.ended = true;
            return;
        }
        let source = &mut self.programs[at].source;
        if let Some((parsed, here)) = source.again(call) {
            let bytes = source.cursor.place().at.saturating_sub(here.at);
            self.budget.block(bytes, parsed.block.ops.len(), false);
            self.here = here;
            self.execute(&parsed.block, &parsed.text);
            return;
        }
        let mut parsed = self.scratch.take().unwrap_or_default();
        if self.read(&mut parsed, at, call) {
            self.execute(&parsed.block, &parsed.text);
        }
        self.scratch = Some(parsed);
    }

    /// Reads the next block of the program `at` into `parsed`; false where there is none.
    fn read(&mut self, parsed: &mut Parsed<Block>, at: usize, call: CallPath) -> bool {
        let read = self.programs[at].source.read(&self.job, call, parsed, |text, into| {
            parse_block(text, &mut into.block, &mut self.problems);
            if needs_text(&into.block) {
                into.text.extend_from_slice(text);
            }
        });
        match read {
            Read::Block(here) => {
                let source = &self.programs[at].source;
                let bytes = source.cursor.place().at.saturating_sub(here.at);
                self.budget.block(bytes, parsed.block.ops.len(), source.parsed_again);
                self.here = here;
                if !self.problems.is_empty() {
                    self.report_problems();
                }
                return true;
            }
            Read::TooLong => {}
            Read::End => self.end_of_file(),
            Read::Broken => self.ended = true,
        }
        false
    }

    fn report_problems(&mut self) {
        // What stands in a section that is not read is of no interest.
        let unread = self.sections.is_unread();
        for problem in self.problems.drain(..) {
            if !unread {
                self.job.diags.push(self.here.diagnostic(&self.job, problem));
            }
        }
    }

    fn execute(&mut self, block: &Block, text: &[u8]) {
        self.here.origin.loc.span = block.span.shifted(self.here.at);
        // A mark without a level is the one of the first level.
        if block
            .skip
            .is_some_and(|level| self.job.settings.control.skip_blocks.iter().any(|on| (*on).max(1) == level.max(1)))
        {
            return;
        }
        if self.job.settings.output.comments
            && let Some(comment) = block.comment
        {
            self.comment(comment.of(text));
        }
        if block.stmt == Stmt::Empty {
            return;
        }
        // What went wrong was reported; the next block may show more.
        let _ = self.statement(block, text);
    }

    fn statement(&mut self, block: &Block, text: &[u8]) -> Outcome {
        if self.sections.is_unread() && !matches!(block.stmt, Stmt::Section(..)) {
            return Ok(());
        }
        match block.stmt {
            Stmt::Empty => Ok(()),
            Stmt::Words => self.words_block(block, text),
            Stmt::Bad => {
                self.lose_all();
                Err(Reported)
            }
            Stmt::Program(_) => self.program_line(),
            Stmt::Head { key, value } => self.head_line(key.of(text), value.of(text), value),
            Stmt::Section(section, rest) => self.section(section, rest, text),
            Stmt::Unit => self.unit(true),
            Stmt::EndUnit => self.unit(false),
            Stmt::Slide(number) => self.slide(number),
            Stmt::Refused(word) => {
                let word = crate::text::decode::readable(word.of(text)).into_owned();
                self.lose_all();
                self.error(codes::T9002, format!("`{word}` is not supported"));
                Err(Reported)
            }
            _ => self.flow_block(block),
        }
    }

    fn comment(&mut self, text: &[u8]) {
        let text = text.trim_ascii();
        if !text.is_empty() && !self.sections.is_unread() {
            self.function(Function::Comment(text.to_vec()));
        }
    }

    #[inline]
    fn movement(&mut self, mv: &Move) {
        self.out.movement(mv, &self.st.ctx, &self.here.origin);
    }

    fn function(&mut self, function: Function) {
        self.out.function(&function, &self.st.ctx, &self.here.origin);
    }

    /// Nobody knows where the tool is.
    fn lose_all(&mut self) {
        self.chain.clear();
        self.st.lose();
        self.out.lost(&self.st.ctx, &self.here.origin);
    }

    /// Reports an error about the whole block.
    fn error(&self, code: &'static Code, message: impl Into<String>) {
        self.report(Diagnostic::new(code, self.here.origin.loc, message));
    }

    fn report(&self, found: Diagnostic) {
        self.job.diags.push(found.called(self.here.origin.call));
    }

    /// Reports an error about `span` of the block and gives up the block.
    fn fail<T>(&self, code: &'static Code, span: Span, message: impl Into<String>) -> Outcome<T> {
        self.report(Diagnostic::new(code, self.loc(span), message));
        Err(Reported)
    }

    /// The same with a line of help.
    fn fail_help<T>(
        &self,
        code: &'static Code,
        span: Span,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Outcome<T> {
        self.report(Diagnostic::new(code, self.loc(span), message).help(help));
        Err(Reported)
    }

    /// A place in the current block.
    fn loc(&self, span: Span) -> Loc {
        self.here.loc(&self.job, span)
    }

    /// Span of the whole block, counted from its start.
    fn block_span(&self) -> Span {
        let span = self.here.origin.loc.span;
        Span { start: span.start.saturating_sub(self.here.at), end: span.end.saturating_sub(self.here.at) }
    }

    /// End of the whole run: what is still open is worth a word.
    fn finish(&mut self) {
        if let Some(capture) = self.capture.take() {
            self.report(
                Diagnostic::new(codes::T3003, capture.loc(), "the contour of this cycle has no end")
                    .help("close it with a block that holds G80 alone"),
            );
        }
        let _ = self.settle_chain();
        if self.st.side != crate::ir::Side::None {
            self.report(
                Diagnostic::new(
                    codes::T2021,
                    self.here.origin.loc,
                    "the program ends with the nose radius compensation on",
                )
                .help("program G40 with a straight move before the end"),
            );
        }
    }
}

/// Does executing the block need more of its text than the spans of its words?
fn needs_text(block: &Block) -> bool {
    use crate::parser::turning::ast::Value;
    let worded = |word: &crate::parser::turning::ast::Word| {
        matches!(word.value, Value::Text(_)) || word.address.addr.letter() == Some(b'T')
    };
    block.comment.is_some()
        || match block.stmt {
            Stmt::Words => block.words.iter().any(worded),
            Stmt::Empty => false,
            _ => true,
        }
}
