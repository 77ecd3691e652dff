//! Runs a SINUMERIK program: an explicit program counter and call stack, variables, modal state.
//!
//! Every block is resolved completely in its turn; only the first line of a two-line contour definition waits
//! for the second. Order inside a block: assignments, G codes, F S T D, spindle and coolant, motion, stops and
//! end, modal call. Source: S 0 to 6 (docs/sources.md).

mod angle_lines;
mod archive;
mod assign;
mod axis_names;
mod axis_order;
mod axis_words;
mod beside_path;
mod block;
mod called_contours;
mod callee;
mod calls;
mod capture;
mod channel;
mod circle;
mod compensation;
mod compensation_rules;
mod control_folders;
mod corners;
mod cycle_alarms;
mod cycle_call;
mod cycles;
mod declare;
mod diameter;
mod dictionary;
mod edge_data;
mod editor_contour;
mod end_point;
mod entries;
mod eval;
mod externs;
mod feed;
mod flow;
mod foreign_codes;
mod formula_functions;
mod frame_statements;
mod frames;
mod g_functions;
mod g_groups;
mod kept;
mod known_values;
mod known_words;
mod lane;
mod left_out;
mod lost_change;
mod machine_place;
mod macros;
mod measuring;
mod measuring_data;
mod modal_call;
mod moves;
mod named_contour;
mod named_words;
mod nonmodal;
mod offsets;
mod parameters;
mod path_control;
mod place;
mod placed_twice;
mod polar;
mod probe_state;
mod procedures;
mod programs;
mod report;
mod rotary;
mod search_path;
mod soft_approach;
mod spindle;
mod spindle_state;
mod stand_in;
mod state;
mod survey;
mod swivel;
mod synchronized;
mod system;
mod system_meanings;
mod system_variables;
mod tangent;
mod tapping;
mod technology;
mod threads;
mod tool;
mod tool_questions;
mod transformation;
mod undercut_sizes;
mod unexecuted;
mod value;
mod vars;
mod vocabulary;
mod words;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diag::codes;
use crate::ir::contour::Sink;
use crate::machine::AxisSet;
use crate::parser::problem::Problem;
use crate::parser::sinumerik::ast::{Block, Op, Stmt, Target, Value, Word};
use crate::parser::sinumerik::scan::scan;
use crate::parser::sinumerik::{SPLIT, parse_block, straight};
use crate::parser::symbols::{Symbol, Symbols};
use crate::sema::run::Where;
use crate::text::{Span, SplitRules};

use super::run::unexecuted::Blocks;
use super::run::{self, Interpreter, Language, Level, Parsed};
use super::{Job, Outcome, Reported};
use calls::Frame;
use channel::Channel;
use g_groups::GCodes;
use lane::Lane;
use macros::Sinumerik;
use programs::{Listed, UnitKind, Units};
use vars::Vars;
use vocabulary::Meaning;
use words::Words;

pub(crate) use control_folders::FOLDERS;
pub use cycles::signatures as cycle_signatures;
pub use dictionary::all_words;
pub use survey::survey;
pub use unexecuted::check_unexecuted;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    let mut run = Run::new(job, out);
    let plane = run.channel.st.codes.of(g_groups::Group::Plane);
    run.channel.st.set_plane(plane);
    run::run(&mut run)
}

/// Reads every block of the file, whether it runs or not, and reports what is wrong with its form.
pub fn check_form(job: &Job<'_>) {
    let mut symbols = Symbols::default();
    let Some(mut blocks) = Blocks::<Sinumerik>::of_main(job) else { return };
    while let Some(mut passed) = blocks.next_behind_straight(job, &mut symbols) {
        // A macro may stand for anything.
        if matches!(passed.block.stmt, Stmt::Define(_)) {
            break;
        }
        passed.report_problems(job);
    }
    blocks.note_straight(job);
}

impl Language for Sinumerik {
    type Block = Block;
    type Known = Listed;
    type Frame = Frame;

    const SPLIT: SplitRules = SPLIT;
    const MOST_ERRORS: u32 = 1000;

    #[inline]
    fn parse(&mut self, text: &[u8], into: &mut Parsed<Block>, symbols: &mut Symbols, problems: &mut Vec<Problem>) {
        if let Some(expanded) = self.expanded(symbols, text) {
            parse_block(&expanded, &mut into.block, symbols, problems);
            into.text = expanded;
            into.rewritten = true;
            return;
        }
        parse_block(text, &mut into.block, symbols, problems);
        if needs_text(&into.block) || self.has_macros() {
            into.text.extend_from_slice(text);
        }
    }

    #[inline]
    fn straight(&self, text: &[u8], line_end: u8) -> Option<(usize, Span)> {
        // A macro may stand for anything.
        if self.has_macros() {
            return None;
        }
        straight::of_line(text, line_end).map(|line| (line.len, line.words))
    }

    #[inline]
    fn span(block: &Block) -> Span {
        block.span
    }

    #[inline]
    fn operations(block: &Block) -> usize {
        block.ops.len()
    }

    #[inline]
    fn has_label(block: &Block) -> bool {
        block.label.is_some()
    }
}

/// Variables that were read before the program gave them a value, which was said.
#[derive(Debug, Default)]
struct Warned {
    r: FxHashSet<u32>,
    /// Elements of global variables.
    kept: FxHashSet<(Symbol, usize)>,
    /// Folders of the control of which it was said what stands for them.
    copies: FxHashSet<&'static str>,
    /// Variables without a value that the formula at hand has read.
    unset: Vec<String>,
}

/// Files, call stack and findings of a run.
type Core<'a> = run::Core<'a, Sinumerik>;

/// A run of a program: variables, formulas and calls, above the channel that carries the blocks out.
struct Run<'a> {
    channel: Channel<'a>,
    vars: Vars,
    meanings: Vec<Option<Meaning>>,
    vocabulary: &'static FxHashMap<&'static str, Meaning>,
    gcodes: GCodes,
    units: Units,
    definitions_read: bool,
    /// Programs by the file that calls them and the name that it calls them by.
    found: FxHashMap<(usize, String), usize>,
    /// The same of programs that are nowhere.
    missing: FxHashSet<(usize, String)>,
    /// The folder that CALLPATH adds to the search path.
    call_path: Option<String>,
    warned: Warned,
    externs: Vec<externs::Extern>,
    /// Contours that CYCLE62 called.
    contours: called_contours::Contours,
    /// Nesting of texts that are executed.
    depth: u32,
    machine: eval::Machine,
    words: Option<Box<Words>>,
}

/// Deepest nesting of texts that are executed.
const MOST_TEXTS: u32 = 8;

impl<'a> Run<'a> {
    fn new(job: &Job<'a>, out: &'a mut dyn Sink) -> Run<'a> {
        let mut vars = Vars::new(&job.settings.variables);
        vars.main_visible = job.settings.control.sinumerik.main_variables_visible;
        Run {
            channel: Channel::new(job, out),
            vars,
            meanings: Vec::new(),
            vocabulary: dictionary::words(),
            gcodes: GCodes::new(),
            units: Units::default(),
            definitions_read: false,
            found: FxHashMap::default(),
            missing: FxHashSet::default(),
            call_path: None,
            warned: Warned::default(),
            externs: Vec::new(),
            contours: called_contours::Contours::default(),
            depth: 0,
            machine: eval::Machine::new(value::RULES),
            words: None,
        }
    }
}

impl<'a> Interpreter<'a> for Run<'a> {
    type Language = Sinumerik;

    #[inline]
    fn core(&mut self) -> &mut Core<'a> {
        &mut self.channel.core
    }

    fn begin(&mut self, program: usize) -> Level<Frame> {
        let first = self.units.first_of(&self.channel.core.job, &self.channel.core.programs, program);
        let unit = self.main_unit(first);
        self.refuse_known_words();
        self.channel.core.begins_at(&self.channel.st.position.start());
        self.vars.enter();
        Level::main(program, Frame::main(unit))
    }

    #[inline]
    fn execute(&mut self, block: &Block, text: &[u8]) {
        if !self.channel.straight_block(block) {
            // Blocks that this one runs itself (a contour, a text, a pattern) ask anew.
            self.channel.lane = Lane::Closed;
            self.execute_any(block, text);
            self.channel.block_stop_ends();
            self.channel.lane = self.channel.open_lane();
        }
    }

    #[inline]
    fn line_lane(&mut self) -> bool {
        self.channel.straight_line()
    }

    fn end_of_file(&mut self) {
        self.channel.lane = Lane::Closed;
        self.file_over();
    }

    fn unread_block(&mut self) {
        self.channel.lane = Lane::Closed;
        self.channel.lose_all();
    }

    #[inline]
    fn level_ends(&mut self) -> bool {
        let at = self.channel.core.place().at;
        if self.channel.core.levels.len() > 1 && self.ends_here(at) {
            self.channel.lane = Lane::Closed;
            return true;
        }
        let over = at >= self.units.list[self.unit()].end;
        if over {
            self.channel.lane = Lane::Closed;
            self.file_over();
        }
        over
    }

    fn forgive(&mut self, _: &Block) {
        if self.channel.iso {
            self.channel.core.problems.clear();
        }
    }

    fn finish(&mut self) {
        self.channel.report_lost_change();
        self.channel.core.report_no_change();
        self.report_open_table();
        self.report_open();
    }
}

impl Run<'_> {
    fn execute_any(&mut self, block: &Block, text: &[u8]) {
        if self.channel.core.skips(block.skip) {
            return;
        }
        if let Some(span) = block.comment {
            let comment = span.of(text);
            self.channel.comment(comment);
            if block.stmt == Stmt::Empty && (self.channel.st.stored.is_some() || comment.starts_with(b"#")) {
                self.channel.core.here.origin.loc.span = span.shifted(self.channel.core.here.at);
                let _ = self.stored_record(comment);
            }
        }
        if block.stmt == Stmt::Empty || self.channel.iso && !self.iso_ends(block) {
            return;
        }
        if self.channel.st.stored.is_some() {
            self.channel.note_stored_block();
        }
        if self.channel.curve_table.is_some() {
            let _ = self.table_block(block);
            return;
        }
        // What went wrong was reported; the next block may show more.
        if self.statement(block, text).is_err() {
            self.channel.begin_no_compensation();
        }
    }

    /// The main program of a file: an archive may begin with its subprograms.
    fn main_unit(&mut self, first: usize) -> usize {
        if self.units.list[first].kind == UnitKind::Main {
            return first;
        }
        let _ = self.list_programs(0);
        let main = self.units.list.iter().position(|unit| unit.kind == UnitKind::Main);
        let unit = main.unwrap_or(first);
        let start = self.units.list[unit].start;
        let _ = self.channel.core.programs[0].source.cursor.seek(self.channel.core.job.sources, start);
        unit
    }

    /// The program that runs.
    fn unit(&self) -> usize {
        self.channel.core.levels.last().map_or(0, |level| level.frame.unit)
    }

    /// Lists the programs of a file.
    fn list_programs(&mut self, file: usize) -> std::io::Result<()> {
        self.units.list_file(&self.channel.core.job, &mut self.channel.core.programs, file)
    }

    fn file_over(&mut self) {
        let _ = self.channel.pending_must_be_done(Where::Block);
        self.end_of_program_text();
    }

    /// G290 ends the ISO dialect; other words of it mean nothing here.
    fn iso_ends(&mut self, block: &Block) -> bool {
        let ends = |word: &Word| {
            word.target == Target::Letter(b'G') && matches!(word.value, Value::Literal { value: 290.0, .. })
        };
        self.channel.iso = !block.words.iter().any(ends) && block.stmt != Stmt::Header;
        !self.channel.iso
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
                if scan(text, &mut self.channel.core.symbols).structure.is_some() {
                    self.channel.core.stop_run();
                }
                self.channel.st.position.lose(AxisSet::ALL);
                self.channel.st.pair.drop_first();
                self.channel.lost();
                return Err(Reported);
            }
            Stmt::Def { kind, length, global } => return self.def_block(kind, length, global, block, text),
            Stmt::Proc(_) => return self.proc_block(block, text),
            Stmt::Extern(name) => return self.extern_block(name, block),
            Stmt::Redef(_) => return Ok(()),
            Stmt::Define(span) => {
                self.channel.core.program_level().declares = true;
                return self.define_macro(span.of(text), span);
            }
            _ => {}
        }
        self.begins_executing();
        match block.stmt {
            Stmt::IfJump => self.if_jumps(block, text),
            Stmt::Goto(jump) => self.jump(jump, block, text),
            Stmt::GotoStart => {
                self.channel.core.says_goto_start(block.span);
                Ok(())
            }
            Stmt::Case(formula) => self.case_block(formula, block, text),
            Stmt::Repeat { from, to, times } => self.repeat(from, to, times, block, text),
            Stmt::RepeatBlock { label, times } => self.repeat_block(label, times, block, text),
            Stmt::Call(form) => {
                self.channel.pending_must_be_done(block.span)?;
                let result = self.call_form(form, block, text);
                if result.is_err() {
                    self.channel.st.position.lose(AxisSet::ALL);
                    self.channel.lost();
                }
                result
            }
            Stmt::Sync(span) => self.synchronized_action(block, text, span),
            _ => self.structure(block, text),
        }
    }

    /// Reads the block again, now that more is known.
    fn again(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let line = if text.is_empty() { self.block_text(block) } else { text.to_vec() };
        self.execute_line(&line, block.span)
    }

    fn block_text(&self, block: &Block) -> Vec<u8> {
        self.channel.core.job.sources.bytes(self.channel.core.here.file, block.span.shifted(self.channel.core.here.at))
    }

    /// Executes a text as a block: EXECSTRING, or a block with macros.
    fn execute_line(&mut self, line: &[u8], span: Span) -> Outcome {
        if self.depth >= MOST_TEXTS {
            self.channel.core.stop_run();
            return self.channel.core.refuse(span, codes::P4003::texts_that_execute_texts_are_nested_too());
        }
        self.depth += 1;
        let result = self.execute_text(line, span);
        self.depth -= 1;
        result
    }

    fn execute_text(&mut self, line: &[u8], span: Span) -> Outcome {
        let loc = self.channel.core.loc(span);
        self.channel.core.budget.text(line.len());
        let line = self.channel.core.expanded(line).unwrap_or_else(|| line.to_vec());
        let mut block = Block::default();
        parse_block(&line, &mut block, &mut self.channel.core.symbols, &mut self.channel.core.problems);
        self.channel.core.here.rewritten = true;
        self.channel.core.here.origin.loc = loc;
        self.channel.core.report_problems();
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
            _ => self.channel.core.refuse(span, codes::S2013::control_structure_or_declaration_cannot_be_executed()),
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
