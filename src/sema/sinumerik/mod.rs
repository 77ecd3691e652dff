//! Runs a SINUMERIK program: an explicit program counter and call stack, variables, modal state.
//!
//! Every block is resolved completely in its turn; only the first line of a two-line contour definition waits
//! for the second. Order inside a block: assignments, G codes, F S T D, spindle and coolant, motion, stops and
//! end, modal call. Source: `reference/sinumerik-core`.

mod archive;
mod assign;
mod axis_names;
mod calls;
mod capture;
mod circle;
mod contour;
mod cycles;
mod declare;
mod editor_contour;
mod eval;
mod externs;
mod feed;
mod flow;
mod formula_functions;
mod frames;
mod g_groups;
mod idle;
mod known_words;
mod left_out;
mod machine_place;
mod macros;
mod modal;
mod motion;
mod moves;
mod names;
mod offsets;
mod parameters;
mod polar;
mod procedures;
mod programs;
mod report;
mod rotary;
mod special;
mod spindle;
mod stand_in;
mod state;
mod system;
mod tangent;
mod technology;
mod threads;
mod tools;
mod value;
mod vars;
mod vocabulary;
mod words;

use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diag::{CallPath, Diagnostic, codes};
use crate::ir::Side;
use crate::ir::contour::Sink;
use crate::ir::function::Turn;
use crate::machine::{Axis, AxisSet, Proposed};
use crate::parser::problem::Problem;
use crate::parser::sinumerik::ast::{Block, Op, Stmt, Target, Value, Word};
use crate::parser::sinumerik::scan::scan;
use crate::parser::sinumerik::{SPLIT, parse_block};
use crate::parser::symbols::{Symbol, Symbols};
use crate::text::blocks::Place;
use crate::text::{Loc, Next, Span};

use super::run::{Budget, Site, open_cursor};
use super::{Job, Outcome, Reported};
use calls::{Level, Modal};
use contour::Pending;
use g_groups::GCodes;
use programs::{Programs, UnitKind};
use state::State;
use value::Val;
use vars::Vars;
use vocabulary::Meaning;
use words::Words;

pub use idle::check_idle;
pub use vocabulary::all_words;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    let mut run = Run::new(job, out);
    run.set_plane(run.st.codes.of(g_groups::Group::Plane));
    let start = Loc { file: job.main, line: 1, span: Span::default() };
    let Some(first) = run.programs.open(job, job.main, start) else { return 0 };
    let unit = run.main_unit(first);
    run.levels.push(Level::main(unit));
    run.out.begins_at(&run.st.position.start());
    run.vars.enter();
    while !run.ended.get() {
        run.step();
    }
    run.finish(unit);
    run.programs.files[0].cursor.content_hash(job.sources).unwrap_or(0)
}

/// Reads every block of the file, whether it runs or not, and reports what is wrong with its form.
pub fn check_form(job: &Job<'_>) {
    let start = Loc { file: job.main, line: 1, span: Span::default() };
    let Some(mut cursor) = open_cursor(job, job.main, SPLIT, start) else { return };
    let mut block = Block::default();
    let mut symbols = Symbols::default();
    let mut problems = Vec::new();
    let mut macros = false;
    while let Ok(Next::Block(text)) = cursor.next(job.sources) {
        parse_block(text.text, &mut block, &mut symbols, &mut problems);
        macros |= matches!(block.stmt, Stmt::Define(_));
        let here = Site::new(job.main, text.at, text.line, text.lines, CallPath::MAIN);
        for problem in problems.drain(..) {
            // A macro may stand for anything.
            if !macros {
                job.diags.push(here.diagnostic(job, problem));
            }
        }
    }
}

/// A block with what its execution needs besides.
#[derive(Debug, Clone, Default)]
struct Parsed {
    block: Block,
    text: Vec<u8>,
    lines: u32,
    next: Place,
    /// Macros were replaced: spans do not fit the file.
    expanded: bool,
}

/// A run of a program.
struct Run<'a> {
    job: Job<'a>,
    out: &'a mut dyn Sink,
    st: State,
    vars: Vars,
    symbols: Symbols,
    meanings: Vec<Option<Meaning>>,
    vocabulary: FxHashMap<&'static str, Meaning>,
    axis_names: axis_names::AxisNames,
    gcodes: GCodes,
    programs: Programs,
    levels: Vec<Level>,
    budget: Budget,
    /// Numbers proposed for tools without one.
    proposed: Proposed,
    /// System variables that the program wrote.
    system: BTreeMap<String, Val>,
    macros: FxHashMap<Symbol, Box<[u8]>>,
    definitions_read: bool,
    /// Programs by the name they were called by.
    found: FxHashMap<String, usize>,
    warned_r: FxHashSet<u32>,
    warned_global: FxHashSet<Symbol>,
    externs: Vec<externs::Extern>,
    modal: Option<Modal>,
    /// Where the modal call stands.
    modal_site: Loc,
    /// The last modal call was refused.
    modal_lost: bool,
    modal_cycle: Option<Box<cycles::ModalCycle>>,
    pending: Option<Box<Pending>>,
    /// The first line of a pair was refused.
    pair_lost: bool,
    /// Contours that CYCLE62 called.
    contours: cycles::Contours,
    /// The contour that is described now.
    capture: Option<Box<capture::Capture>>,
    /// The contour of the contour editor that runs.
    stored: Option<Box<editor_contour::Stored>>,
    /// Lead of the last thread and the axis along which it counts.
    lead: Option<(Axis, f64)>,
    /// The same of the last tap, with its sign.
    tap_lead: Option<(Axis, f64)>,
    /// The spindle turns for a tap, in this sense.
    tapping: Option<Turn>,
    thread_chain: Option<threads::ThreadChain>,
    axis_feed: BTreeMap<Axis, f64>,
    compensation_starts: bool,
    /// The side that G40 ended, and whether its offset still waits for a move in the plane.
    leaving: Side,
    leaving_open: bool,
    /// G41 or G42 of the block, until its D is known.
    cutter_open: Option<Span>,
    /// A corner that waits for its second line, and the blocks since.
    corner_open: Option<(Loc, u32)>,
    /// G96 waits for its S.
    cut_speed_open: Option<Span>,
    /// Nesting of texts that are executed.
    depth: u32,
    machine: eval::Machine,
    words: Option<Box<Words>>,
    here: Site,
    expanded: bool,
    problems: Vec<Problem>,
    scratch: Option<Box<Parsed>>,
    /// Blocks are of the ISO dialect, up to G290.
    iso: bool,
    ended: Cell<bool>,
    errors: Cell<u32>,
}

/// Errors after which a run ends.
const MOST_ERRORS: u32 = 1000;
/// Deepest nesting of texts that are executed.
const MOST_TEXTS: u32 = 8;

impl<'a> Run<'a> {
    fn new(job: &Job<'a>, out: &'a mut dyn Sink) -> Run<'a> {
        let mut vars = Vars::new(&job.settings.variables);
        vars.main_visible = job.settings.control.siemens.main_variables_visible;
        Run {
            job: *job,
            out,
            st: State::new(job.settings),
            vars,
            symbols: Symbols::default(),
            meanings: Vec::new(),
            vocabulary: vocabulary::words(),
            axis_names: axis_names::AxisNames::new(job.settings),
            gcodes: GCodes::new(),
            programs: Programs::default(),
            levels: Vec::new(),
            budget: Budget::new(job.settings.limits.steps),
            proposed: Proposed::default(),
            system: BTreeMap::new(),
            macros: FxHashMap::default(),
            definitions_read: false,
            found: FxHashMap::default(),
            warned_r: FxHashSet::default(),
            warned_global: FxHashSet::default(),
            externs: Vec::new(),
            modal: None,
            modal_site: Loc::default(),
            modal_lost: false,
            modal_cycle: None,
            pending: None,
            pair_lost: false,
            contours: cycles::Contours::default(),
            capture: None,
            stored: None,
            lead: None,
            tap_lead: None,
            tapping: None,
            thread_chain: None,
            axis_feed: BTreeMap::new(),
            compensation_starts: false,
            leaving: Side::None,
            leaving_open: false,
            cutter_open: None,
            corner_open: None,
            cut_speed_open: None,
            depth: 0,
            machine: eval::Machine::new(eval::RULES),
            words: None,
            here: Site::default(),
            expanded: false,
            problems: Vec::new(),
            scratch: None,
            iso: false,
            ended: Cell::new(false),
            errors: Cell::new(0),
        }
    }

    /// The main program of a file: an archive may begin with its subprograms.
    fn main_unit(&mut self, first: usize) -> usize {
        if self.programs.units[first].kind == UnitKind::Main {
            return first;
        }
        let _ = self.programs.list(&self.job, 0);
        let main = self.programs.units.iter().position(|unit| unit.kind == UnitKind::Main);
        let unit = main.unwrap_or(first);
        let start = self.programs.units[unit].start;
        let _ = self.programs.files[0].cursor.seek(self.job.sources, start);
        unit
    }

    fn level(&mut self) -> &mut Level {
        self.levels.last_mut().expect("the main level is popped only when the run ends")
    }

    /// The program that runs.
    fn unit(&self) -> usize {
        self.levels.last().map_or(0, |level| level.unit)
    }

    fn stop_run(&self) {
        self.ended.set(true);
    }

    /// Between two places of a pattern: the run ends here where no step is left, or the output takes no more.
    fn goes_on(&mut self) -> Outcome {
        if self.budget.goes_on(&*self.out) {
            return Ok(());
        }
        self.budget.report_end(&self.job, &*self.out, self.here.origin.loc, self.here.origin.call);
        self.stop_run();
        Err(Reported)
    }

    /// Executes one block.
    fn step(&mut self) {
        let (unit, call) = (self.level().unit, self.level().call);
        if !self.budget.step(&*self.out) {
            self.budget.report_end(&self.job, &*self.out, self.here.origin.loc, call);
            self.ended.set(true);
            return;
        }
        let (at, end) = (self.programs.units[unit].file, self.programs.units[unit].end);
        let file = &mut self.programs.files[at];
        let place = file.cursor.place();
        if self.levels.len() > 1 && self.ends_here(place.at) {
            return;
        }
        if place.at >= end {
            return self.end_of_file();
        }
        let file = &mut self.programs.files[at];
        if file.cursor.is_whole()
            && let Some(parsed) = file.cache.get(place.at)
        {
            file.cursor.resume(parsed.next);
            self.budget.block(parsed.next.at.saturating_sub(place.at), parsed.block.ops.len(), false);
            self.here = Site::new(file.file, place.at, place.line, parsed.lines, call);
            self.expanded = parsed.expanded;
            self.execute(&parsed.block, &parsed.text);
            return;
        }
        let mut parsed = self.scratch.take().unwrap_or_default();
        parsed.text.clear();
        self.read(at, place, call, &mut parsed);
        self.scratch = Some(parsed);
    }

    fn read(&mut self, at: usize, place: Place, call: CallPath, parsed: &mut Parsed) {
        let file = &mut self.programs.files[at];
        match file.cursor.next(self.job.sources) {
            Ok(Next::Block(found)) => {
                self.here = Site::new(file.file, place.at, place.line, found.lines, call);
                parsed.lines = found.lines;
                parsed.expanded = false;
                if self.macros.is_empty() {
                    parse_block(found.text, &mut parsed.block, &mut self.symbols, &mut self.problems);
                    if needs_text(&parsed.block) {
                        parsed.text.extend_from_slice(found.text);
                    }
                } else {
                    let text = found.text.to_vec();
                    let replaced = self.expanded(&text);
                    parsed.expanded = replaced.is_some();
                    parsed.text = replaced.unwrap_or(text);
                    parse_block(&parsed.text, &mut parsed.block, &mut self.symbols, &mut self.problems);
                }
                self.expanded = parsed.expanded;
                let file = &mut self.programs.files[at];
                let again = place.at < file.furthest;
                file.furthest = file.furthest.max(place.at.saturating_add(1));
                self.budget.block(file.cursor.place().at.saturating_sub(place.at), parsed.block.ops.len(), again);
                if file.cursor.is_whole() {
                    parsed.next = file.cursor.place();
                    file.cache.insert(place.at, Rc::new(Parsed::clone(parsed)));
                }
                if self.iso {
                    self.problems.clear();
                }
                if !self.problems.is_empty() {
                    self.report_problems();
                }
                self.execute(&parsed.block, &parsed.text);
            }
            Ok(Next::TooLong { at, line }) => {
                let loc = Loc { file: file.file, line, span: Span::at(at, 1) };
                self.job.diags.push(Diagnostic::new(codes::P0003, loc, "block is longer than 1 MiB"));
            }
            Ok(Next::End) => self.end_of_file(),
            Err(error) => {
                let loc = Loc { file: file.file, line: place.line, span: Span::at(place.at, 0) };
                self.job.diags.push(Diagnostic::new(codes::P0105, loc, format!("the file cannot be read: {error}")));
                self.ended.set(true);
            }
        }
    }

    fn end_of_file(&mut self) {
        let _ = self.pending_must_be_done(Span::default());
        self.end_of_program_text();
    }

    fn execute(&mut self, block: &Block, text: &[u8]) {
        self.here.origin.loc.span =
            if self.expanded { Span::at(self.here.at, 1) } else { block.span.shifted(self.here.at) };
        if let Some(level) = block.skip
            && self.job.settings.control.skip_blocks.iter().any(|on| *on == level || level == 0 && *on == 1)
        {
            return;
        }
        if let Some(comment) = block.comment {
            let comment = comment.of(text);
            if self.job.settings.output.comments {
                self.comment(comment);
            }
            if block.stmt == Stmt::Empty && (self.stored.is_some() || comment.starts_with(b"#")) {
                if let Some(span) = block.comment {
                    self.here.origin.loc.span = span.shifted(self.here.at);
                }
                let _ = self.stored_record(comment);
            }
        }
        if block.stmt == Stmt::Empty || self.iso && !self.iso_ends(block) {
            return;
        }
        if self.stored.is_some() {
            self.note_stored_block();
        }
        // What went wrong was reported; the next block may show more.
        let _ = self.statement(block, text);
    }

    /// G290 ends the ISO dialect; other words of it mean nothing here.
    fn iso_ends(&mut self, block: &Block) -> bool {
        let ends = |word: &Word| {
            word.target == Target::Letter(b'G') && matches!(word.value, Value::Literal { value: 290.0, .. })
        };
        self.iso = !block.words.iter().any(ends) && block.stmt != Stmt::Header;
        !self.iso
    }

    fn statement(&mut self, block: &Block, text: &[u8]) -> Outcome {
        match block.stmt {
            Stmt::Empty => return Ok(()),
            Stmt::Words => return self.words_block(block, text),
            Stmt::Header => return self.header(),
            Stmt::Bad => {
                // A declaration that cannot be read is followed by others.
                if declares(block.span.of(text)) {
                    return Err(Reported);
                }
                self.begins_executing();
                // Without the head of a loop or branch nobody knows where the program goes on.
                if scan(text, &mut self.symbols).structure.is_some() {
                    self.stop_run();
                }
                self.st.position.lose(AxisSet::ALL);
                self.pending = None;
                self.lost();
                return Err(Reported);
            }
            Stmt::Def { kind, length, global } => return self.def_block(kind, length, global, block, text),
            Stmt::Proc(_) => return self.proc_block(block, text),
            Stmt::Extern(name) => return self.extern_block(name, block),
            Stmt::Redef(_) => return Ok(()),
            Stmt::Define(span) => {
                self.program_level().declares = true;
                return self.define_macro(span.of(text), span);
            }
            _ => {}
        }
        self.begins_executing();
        match block.stmt {
            Stmt::IfJump => self.if_jumps(block, text),
            Stmt::Goto(jump) => self.jump(jump, block, text),
            Stmt::GotoStart => {
                self.says_goto_start(block.span);
                Ok(())
            }
            Stmt::Case(formula) => self.case_block(formula, block, text),
            Stmt::Repeat { from, to, times } => self.repeat(from, to, times, block, text),
            Stmt::RepeatBlock { label, times } => self.repeat_block(label, times, block, text),
            Stmt::Call(form) => {
                self.pending_must_be_done(block.span)?;
                let result = self.call_form(form, block, text);
                if result.is_err() {
                    self.st.position.lose(AxisSet::ALL);
                    self.lost();
                }
                result
            }
            Stmt::Sync(span) => self.fail_help(
                codes::S9004,
                0,
                span,
                "synchronized actions run beside the program, as the machine's signals come",
                "leave the action out, or replace it by blocks of the program",
            ),
            _ => self.structure(block, text),
        }
    }

    /// An executable block: DEF is too late from here on, arguments without PROC are too many.
    fn begins_executing(&mut self) {
        let level = self.program_level();
        if level.executed {
            return;
        }
        level.executed = true;
        if level.arguments.is_some() {
            self.refuse_arguments();
        }
    }

    /// Reads the block again, now that more is known.
    fn again(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let line = if text.is_empty() { self.block_text(block) } else { text.to_vec() };
        self.execute_line(&line, block.span)
    }

    fn block_text(&self, block: &Block) -> Vec<u8> {
        self.job.sources.bytes(self.here.file, block.span.shifted(self.here.at))
    }

    /// Executes a text as a block: EXECSTRING, or a block with macros.
    fn execute_line(&mut self, line: &[u8], span: Span) -> Outcome {
        if self.depth >= MOST_TEXTS {
            self.stop_run();
            return self.fail_help(
                codes::P4003,
                14012,
                span,
                "texts that execute texts are nested too deep",
                "check for an EXECSTRING that executes itself",
            );
        }
        self.depth += 1;
        let result = self.execute_text(line, span);
        self.depth -= 1;
        result
    }

    fn execute_text(&mut self, line: &[u8], span: Span) -> Outcome {
        let loc = self.loc(span);
        let line = self.expanded(line).unwrap_or_else(|| line.to_vec());
        let mut block = Block::default();
        parse_block(&line, &mut block, &mut self.symbols, &mut self.problems);
        self.expanded = true;
        self.here.origin.loc = loc;
        self.report_problems();
        match block.stmt {
            Stmt::Words => {
                // The words of the block around are in use.
                let kept = self.words.take();
                let result = self.words_block(&block, &line);
                if kept.is_some() {
                    self.words = kept;
                }
                result
            }
            Stmt::Empty => Ok(()),
            Stmt::Bad => Err(Reported),
            Stmt::Call(form) => self.call_form(form, &block, &line),
            // The program goes on at the target, as behind a jump that stands there.
            Stmt::IfJump => self.if_jumps(&block, &line),
            Stmt::Goto(jump) => self.jump(jump, &block, &line),
            _ => {
                self.fail(codes::S2013, 12080, span, "a control structure or declaration cannot be executed as a text")
            }
        }
    }

    /// The words of the block without the procedure that was done.
    fn words_again(&mut self, w: &mut Words, block: &Block) -> Outcome {
        self.run_words_of(w, block)
    }
}

/// Does a statement that cannot be read begin like a declaration?
fn declares(text: &[u8]) -> bool {
    let len = text.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    ["DEF", "PROC", "EXTERN", "DEFINE", "REDEF"].iter().any(|word| text[..len].eq_ignore_ascii_case(word.as_bytes()))
}

/// Does executing the block need more of its text than the spans of its words?
fn needs_text(block: &Block) -> bool {
    block.comment.is_some()
        || !matches!(block.stmt, Stmt::Words | Stmt::Empty)
        || block.ops.iter().any(|op| matches!(op, Op::Text(_)))
}
