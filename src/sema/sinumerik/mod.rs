//! Runs a SINUMERIK program: an explicit program counter and call stack, variables, modal state.
//!
//! Every block is resolved completely in its turn; only the first line of a two-line contour definition waits
//! for the second. Order inside a block: assignments, G codes, F S T D, spindle and coolant, motion, stops and
//! end, modal call. Source: S 0 to 6 (docs/sources.md).

mod angle_lines;
mod archive;
mod askew;
mod assign;
mod axis_names;
mod axis_order;
mod axis_words;
mod beside_path;
mod block;
mod block_words;
mod call_forms;
mod called_contours;
mod callee;
mod calls;
mod capture;
mod channel;
mod circle;
mod compensation;
mod compensation_rules;
mod control_folders;
mod conversions;
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
mod frame_functions;
mod frame_statements;
mod frames;
mod g_functions;
mod g_groups;
mod given;
mod kept;
mod known_values;
mod known_words;
mod lane;
mod language_procedures;
mod left_behind;
mod left_out;
mod levels;
mod line;
mod machine_place;
mod machining;
mod macros;
mod measuring;
mod measuring_data;
mod modal_call;
mod moves;
mod named_contour;
mod named_words;
mod names;
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
mod sorting;
mod spindle;
mod spindle_state;
mod stand_in;
mod state;
mod survey;
mod swivel;
mod swivel_call;
mod synchronized;
mod system;
mod system_meanings;
mod system_variables;
mod tangent;
mod tapping;
mod targets;
mod technology;
mod threads;
mod tool;
mod tool_questions;
mod transformation;
mod undercut_sizes;
mod unexecuted;
mod value;
mod variables;
mod vars;
mod vocabulary;
mod words;

use crate::diag::codes;
use crate::ir::contour::Sink;
use crate::machine::AxisSet;
use crate::parser::problem::Problem;
use crate::parser::sinumerik::ast::{Block, Op, Stmt, Target, Value, Word};
use crate::parser::sinumerik::scan::scan;
use crate::parser::sinumerik::{SPLIT, parse_block, straight};
use crate::parser::symbols::Symbols;
use crate::sema::run::Where;
use crate::text::{Span, SplitRules};

use super::run::unexecuted::Blocks;
use super::run::{self, Interpreter, Language, Level, Parsed};
use super::{Job, Outcome, Reported};
use channel::Channel;
use externs::Externs;
use lane::Lane;
use levels::{Frame, PartEnds};
use line::{Line, NextText};
use macros::Sinumerik;
use names::Names;
use programs::{Listed, Units};
use state::State;
use vars::Vars;
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

/// Files, call stack and findings of a run.
type Core<'a> = run::Core<'a, Sinumerik>;

/// A run of a program: variables, formulas and calls, above the channel that carries the blocks out.
struct Run<'a> {
    channel: Channel<'a>,
    vars: Vars,
    names: Names,
    units: Units,
    definitions_read: bool,
    externs: Externs,
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
            names: Names::new(),
            units: Units::default(),
            definitions_read: false,
            externs: Externs::default(),
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
        let core = &mut self.channel.core;
        let first = self.units.first_of(&core.job, &core.programs, program);
        let unit = self.units.main_of(core, first);
        entries::refuse_known_words(core);
        core.begins_at(&self.channel.st.position.start());
        self.vars.enter();
        Level::main(program, Frame::main(unit))
    }

    #[inline]
    fn execute(&mut self, block: &Block, text: &[u8]) {
        if !self.channel.straight_block(block) {
            // Blocks that this one runs itself (a contour, a text, a pattern) ask anew.
            self.channel.lane = Lane::Closed;
            self.execute_any(Line { block, text });
            if self.channel.st.smoothing.block_ends() {
                self.channel.send_smoothing();
            }
            self.channel.lane = self.channel.open_lane();
        }
    }

    #[inline]
    fn line_lane(&mut self) -> bool {
        self.channel.straight_line()
    }

    fn end_of_file(&mut self) {
        self.channel.lane = Lane::Closed;
        self.end_of_program_text();
    }

    fn unread_block(&mut self) {
        self.channel.lane = Lane::Closed;
        self.channel.lose_all();
    }

    #[inline]
    fn level_ends(&mut self) -> bool {
        let at = self.channel.core.program().source.cursor.place().at;
        if self.channel.core.levels.len() > 1
            && let Some(part) = self.channel.core.part_ends(at)
        {
            match (part, &mut self.channel.capture) {
                (PartEnds::Program, _) => self.leave_program(),
                (PartEnds::Section { over: true }, Some(capture)) => {
                    capture.level_ended(self.channel.core.levels.len())
                }
                (PartEnds::Section { .. }, _) => {}
            }
            self.channel.lane = Lane::Closed;
            return true;
        }
        let over = at >= self.units.list[levels::unit(&self.channel.core.levels)].end;
        if over {
            self.channel.lane = Lane::Closed;
            self.end_of_program_text();
        }
        over
    }

    fn forgive(&mut self, _: &Block) {
        if self.channel.iso {
            self.channel.core.problems.clear();
        }
    }

    fn finish(&mut self) {
        self.channel.left.report_change(&mut self.channel.core);
        self.channel.core.report_no_change();
        self.channel.report_open();
        self.units.report_others(&mut self.channel.core);
    }
}

impl Run<'_> {
    fn execute_any(&mut self, line: Line<'_>) {
        let block = line.block;
        if self.channel.core.skips(block.skip) {
            return;
        }
        if let Some(span) = block.comment {
            let comment = span.of(line.text);
            self.channel.comment(comment);
            if block.stmt == Stmt::Empty && (self.channel.st.stored.is_some() || comment.starts_with(b"#")) {
                self.channel.core.here.origin.loc.span = span.shifted(self.channel.core.here.at);
                let _ = self.channel.stored_record(comment);
            }
        }
        if block.stmt == Stmt::Empty {
            return;
        }
        if self.channel.iso {
            self.channel.iso = !ends_iso(block);
            if self.channel.iso {
                return;
            }
        }
        if self.channel.st.stored.is_some() {
            self.channel.st.stored_block_begins(&self.channel.core);
        }
        if self.channel.curve_table.is_some() {
            let _ = self.table_block(block);
            return;
        }
        // What went wrong was reported; the next block may show more.
        if self.statement(line).is_err() {
            self.channel.st.compensation.end_unselected(&mut self.channel.st.codes);
        }
    }

    fn statement(&mut self, line: Line<'_>) -> Outcome {
        let block = line.block;
        match block.stmt {
            Stmt::Words => return self.words_block(line),
            Stmt::Empty
            | Stmt::Redef(_)
            | Stmt::Header
            | Stmt::Bad
            | Stmt::Def { .. }
            | Stmt::Proc(_)
            | Stmt::Extern(_)
            | Stmt::Define(_) => return self.declaration(line),
            _ => {}
        }
        let core = &mut self.channel.core;
        core.begins_executing();
        match block.stmt {
            Stmt::IfJump => self.jump_by_arms(None, line),
            Stmt::Goto(jump) => self.jump(jump, line),
            Stmt::GotoStart => {
                core.say_once(block.span, codes::S8049::gotos_is_left_out());
                Ok(())
            }
            Stmt::Case(formula) => self.jump_by_arms(Some(formula), line),
            Stmt::Repeat { from, to, times } => {
                let (from, stop) = self.units.section(core, from, to, block.span)?;
                self.repeat(from, stop, times, line)
            }
            Stmt::RepeatBlock { label, times } => {
                let mark = self.units.section_label(core, label, block.span)?;
                self.repeat(mark.place, mark.after.at, times, line)
            }
            Stmt::Call(form) => {
                self.channel.pending_must_be_done(block.span)?;
                let result =
                    self.call_form(form, line).and_then(|text| text.map_or(Ok(()), |text| self.execute_next(text)));
                if result.is_err() {
                    self.channel.st.position.lose(AxisSet::ALL);
                    self.channel.lost();
                }
                result
            }
            Stmt::Sync(span) => self.synchronized_action(line, span),
            _ => self.structure(line),
        }
    }

    /// Heads of programs, declarations, and what cannot be read.
    fn declaration(&mut self, line: Line<'_>) -> Outcome {
        let (block, text) = (line.block, line.text);
        let core = &mut self.channel.core;
        match block.stmt {
            Stmt::Header => {
                let Some(ends) = self.units.header(core)? else { return Ok(()) };
                self.end_of_program_text();
                if ends.blocks_follow {
                    let fault = codes::S2013::blocks_stand_behind_that_closes_program();
                    return self.channel.core.refuse(Where::Block, fault);
                }
                Ok(())
            }
            // A declaration that cannot be read is followed by others.
            Stmt::Bad if declares(block.span.of(text)) => Err(Reported),
            Stmt::Bad => {
                core.begins_executing();
                // Without the head of a loop or branch nobody knows where the program goes on.
                if scan(text, &mut core.symbols).structure.is_some() {
                    core.stop_run();
                }
                self.channel.lose_all();
                Err(Reported)
            }
            Stmt::Def { kind, length, global } => self.def_block(kind, length, global, line),
            Stmt::Proc(_) => self.proc_block(line),
            Stmt::Extern(name) => self.externs.declare(core, name, block),
            Stmt::Define(span) => {
                levels::program(&mut core.levels).declares = true;
                self.names.define_macro(span.of(text), span, &self.vars, &mut self.channel)
            }
            _ => Ok(()),
        }
    }

    fn words_block(&mut self, line: Line<'_>) -> Outcome {
        let mut words = self.words.take().unwrap_or_else(|| Box::new(Words::new()));
        words.clear();
        let result = match self.block_of_words(&mut words, line) {
            Ok(None) => Ok(()),
            Ok(Some(text)) => self.execute_next(text),
            Err(reported) => Err(reported),
        };
        if result.is_err() {
            self.channel.lose_block(&mut self.names, &words, line.block);
        }
        self.words = Some(words);
        result
    }

    /// Executes a text as a block: EXECSTRING, a block with macros, or what stands for a program.
    #[cold]
    fn execute_next(&mut self, NextText { text, span }: NextText) -> Outcome {
        let core = &mut self.channel.core;
        if self.depth >= MOST_TEXTS {
            core.stop_run();
            return core.refuse(span, codes::P4003::texts_that_execute_texts_are_nested_too());
        }
        let loc = core.loc(span);
        core.budget.text(text.len());
        let text = core.language.expanded(&core.symbols, &text).unwrap_or(text);
        let mut block = Block::default();
        parse_block(&text, &mut block, &mut core.symbols, &mut core.problems);
        core.here.rewritten = true;
        core.here.origin.loc = loc;
        core.report_problems();
        let line = Line { block: &block, text: &text };
        self.depth += 1;
        let result = match block.stmt {
            Stmt::Words => self.words_block(line),
            Stmt::Empty => Ok(()),
            Stmt::Bad => Err(Reported),
            Stmt::Call(form) => {
                self.call_form(form, line).and_then(|text| text.map_or(Ok(()), |text| self.execute_next(text)))
            }
            // The program goes on at the target, as behind a jump that stands there.
            Stmt::IfJump => self.jump_by_arms(None, line),
            Stmt::Goto(jump) => self.jump(jump, line),
            _ => core.refuse(span, codes::S2013::control_structure_or_declaration_cannot_be_executed()),
        };
        self.depth -= 1;
        result
    }
}

/// G290 ends the ISO dialect, and so does the next program; other words of it mean nothing here.
fn ends_iso(block: &Block) -> bool {
    let ends =
        |word: &Word| word.target == Target::Letter(b'G') && matches!(word.value, Value::Literal { value: 290.0, .. });
    block.stmt == Stmt::Header || block.words.iter().any(ends)
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
