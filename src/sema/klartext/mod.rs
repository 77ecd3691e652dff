//! Runs a HEIDENHAIN Klartext program: an explicit program counter and call stack, parameters, modal state.
//!
//! Every block is resolved completely in its turn, so the programmed position is always known here.
//! Source: K 1 to 5; the order inside a block is: M functions at the
//! start, motion, M functions at the end, cycle call (Appendix B).

mod active_tool;
mod approach;
mod arcs;
mod blank;
mod block_text;
mod builders_cycle;
mod capture;
mod change;
mod compensation;
mod contour;
mod contour_area;
mod contour_data;
mod cycle;
mod cycle_blocks;
mod cycle_call;
mod cycle_definition;
mod cycle_effects;
mod cycle_words;
mod cycles;
mod datum_table;
mod eval;
mod feed;
mod fk;
mod flow;
mod frame_state;
mod frames;
mod gather;
mod global_def;
mod known;
mod labels;
mod lane;
mod left_out;
mod level;
mod m_functions;
mod m_table;
mod meanings;
mod numbered_functions;
mod path;
mod pattern_def;
mod patterns;
mod place;
mod plane;
mod point_table;
mod polar;
mod pole;
mod probing;
mod probing_datum;
mod program_pattern;
mod programs;
mod reading;
mod refused;
mod rotary;
mod sending;
mod spindle;
mod state;
mod survey;
mod system;
mod text_functions;
mod tilt;
mod tilt_state;
mod tool;
mod tool_table;
mod transformation;
mod unexecuted;
mod vars;
mod words;

use crate::diag::{CallPath, Code, codes};
use crate::ir::contour::Sink;
use crate::machine::{AxisSet, Unit};
use crate::parser::klartext::ast::{Block, PathFn, Stmt};
use crate::parser::klartext::{SPLIT, parse_block, straight};
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::text::{Loc, Span, SplitRules};

pub use cycles::signatures as cycle_signatures;
pub use survey::survey;
pub use unexecuted::check_unexecuted;

use super::run::unexecuted::Blocks;
use super::run::{self, Interpreter, Language, Level, Parsed};
use super::value::Machine;
use super::{Job, Outcome, Reported};
use block_text::block_name;
use cycle::Cycles;
use labels::Labels;
use level::Frame;
use pattern_def::{Places, begins_pattern};
use state::State;
use vars::Vars;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    let mut run = Run {
        core: Core::new(job, out),
        st: State::new(job.settings),
        vars: Vars::default(),
        tools: tool_table::Tools::default(),
        cycles: Cycles::default(),
        contours: cycles::data::Contours::default(),
        approach: None,
        free: None,
        pattern: pattern_def::Pattern::default(),
        datum_table: datum_table::DatumTable::default(),
        globals: global_def::Globals::default(),
        selected: None,
        noted: m_table::Noted::default(),
        machine: Machine::new(eval::rules(job.settings)),
        words: None,
        skipped: probing::Skipped::default(),
        plain: false,
    };
    run::run(&mut run)
}

/// Reads every block of the main program, whether it runs or not, and reports what is wrong with its form.
pub fn check_form(job: &Job<'_>) {
    let mut symbols = Symbols::default();
    let Some(mut blocks) = Blocks::<Klartext>::of_main(job) else { return };
    let mut head: Option<(Unit, Loc)> = None;
    while let Some(mut passed) = blocks.next_behind_straight(job, &mut symbols) {
        passed.report_problems(job);
        let loc = passed.site.loc(job, passed.block.span);
        match passed.block.stmt {
            Stmt::Begin { unit: Some(unit), .. } if head.is_none() => head = Some((unit, loc)),
            // What follows END PGM is reported as a whole.
            Stmt::End { unit, .. } => {
                check_end(job, unit, head, loc);
                flow::report_behind_end(job, &mut blocks.texts.cursor, job.main, CallPath::MAIN);
                break;
            }
            _ => {}
        }
    }
    blocks.note_straight(job);
}

/// A run does not come here where the program ends by M30.
fn check_end(job: &Job<'_>, unit: Option<Unit>, head: Option<(Unit, Loc)>, here: Loc) {
    if let (Some(unit), Some((begun, begin))) = (unit, head)
        && unit != begun
    {
        job.diags.push(flow::other_unit(here, begin));
    }
}

/// How the text of a program is read.
#[derive(Debug, Default)]
struct Klartext;

impl Language for Klartext {
    type Block = Block;
    type Known = Known;
    type Frame = Frame;

    const SPLIT: SplitRules = SPLIT;
    const USUAL_HELP: bool = true;

    #[inline]
    fn parse(&mut self, text: &[u8], into: &mut Parsed<Block>, _: &mut Symbols, problems: &mut Vec<Problem>) {
        parse_block(text, &mut into.block, problems);
        if needs_text(&into.block) {
            into.text.extend_from_slice(text);
        }
    }

    #[inline]
    fn straight(&self, text: &[u8], line_end: u8) -> Option<(usize, Span)> {
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

    /// A program without numbers has hundreds of such words: one finding says it all.
    fn said_once(code: &'static Code) -> bool {
        code == codes::K0801
    }
}

/// What is known of a program file.
#[derive(Debug, Default)]
struct Known {
    labels: Option<Labels>,
    /// Labels passed before the file was looked through for them.
    passed: Labels,
    /// A block of it holds M6; `None` before anybody asked.
    writes_m6: Option<bool>,
    /// BEGIN PGM, once it was met.
    head: Option<ProgramHead>,
}

#[derive(Debug, Clone)]
struct ProgramHead {
    name: Vec<u8>,
    unit: Option<Unit>,
    loc: Loc,
}

/// Files, call stack and findings of a run.
type Core<'a> = run::Core<'a, Klartext>;

/// A run of a program.
struct Run<'a> {
    core: Core<'a>,
    st: State,
    vars: Vars,
    /// What the program says of tools.
    tools: tool_table::Tools,
    cycles: Cycles,
    /// What cycles 14, 20 and 270 say.
    contours: cycles::data::Contours,
    /// An approach that waits for the first element of its contour.
    approach: Option<Box<approach::Approach>>,
    /// A free contour, and what is known of those in front.
    free: Option<Box<fk::Free>>,
    /// Places of PATTERN DEF.
    pattern: pattern_def::Pattern,
    datum_table: datum_table::DatumTable,
    /// Values for PREDEF.
    globals: global_def::Globals,
    /// Program of SEL PGM.
    selected: Option<String>,
    /// M functions of which it was said that they are left out.
    noted: m_table::Noted,
    machine: Machine,
    words: Option<Box<words::Words>>,
    /// A definition that was skipped, while lines of its parameters may follow.
    skipped: probing::Skipped,
    /// A straight block may take the lane.
    plain: bool,
}

impl<'a> Interpreter<'a> for Run<'a> {
    type Language = Klartext;

    #[inline]
    fn core(&mut self) -> &mut Core<'a> {
        &mut self.core
    }

    fn begin(&mut self, program: usize) -> Level<Frame> {
        let settings = self.core.job.settings;
        let (vars, locals) = Vars::new(&settings.variables);
        self.vars = vars;
        self.core.refuse_entries_of_cycles();
        self.core.begins_at(&self.st.position.start());
        Level::main(program, Frame::main(settings.control.unit.unwrap_or_default(), locals))
    }

    #[inline]
    fn execute(&mut self, block: &Block, text: &[u8]) {
        if !self.straight_block(block) {
            // Blocks that this one runs itself (a contour, a text, a pattern) ask anew.
            self.plain = false;
            self.execute_any(block, text);
            self.plain = self.is_plain();
        }
    }

    #[inline]
    fn line_lane(&mut self) -> bool {
        self.straight_line()
    }

    fn end_of_file(&mut self) {
        self.plain = false;
        let _ = self.close_contour();
        self.finish_cycle();
        self.file_over();
    }

    fn unread_block(&mut self) {
        self.plain = false;
        self.abandon_contour();
        self.st.lose_all(&mut self.core);
    }

    /// A block that is left out takes the lines along in which it goes on.
    fn forgive(&mut self, block: &Block) {
        if self.core.job.skips(block.skip.then_some(0)) {
            self.core.problems.retain(|problem| problem.code != codes::K1850);
        }
    }

    fn finish(&mut self) {
        self.report_open();
    }
}

impl Run<'_> {
    fn execute_any(&mut self, block: &Block, text: &[u8]) {
        if self.core.skips(block.skip.then_some(0)) {
            self.skipped.skip(block, text);
            return;
        }
        if self.skipped.is_open() && self.skipped.takes(block) {
            return;
        }
        if self.core.job.settings.output.comments
            && let Some(comment) = block.comment
            && !matches!(block.stmt, Stmt::Cycle { .. } | Stmt::PatternDef)
            && let Some(comment) = self.core.comment_of(&whole_comment(comment.of(text)))
        {
            self.function(comment);
        }
        match block.stmt {
            Stmt::Empty => return,
            Stmt::Bad => {
                self.abandon_contour();
                self.bad_block(block, text);
                return;
            }
            _ => {}
        }
        if self.cycles.is_open() && !self.cycles.goes_on(block) {
            self.finish_cycle();
        }
        if self.contour_waits()
            && !fk::goes_on(block, &self.core.job.settings.control.tool_change_m)
            && self.close_contour().is_err()
        {
            self.st.feed.lose(block);
        }
        if self.approach.is_some()
            && !self.contour_waits()
            && !goes_on_with_contour(block.stmt)
            && self.forbid_open_approach().is_err()
        {
            return;
        }
        // What went wrong was reported; the next block may show more.
        if self.statement(block, text).is_err() {
            self.st.feed.lose(block);
        }
    }

    fn statement(&mut self, block: &Block, text: &[u8]) -> Outcome {
        self.st.may_stand_in_contour(&mut self.core, block)?;
        match block.stmt {
            Stmt::Empty | Stmt::Bad => Ok(()),
            Stmt::Path(function) => self.path_block(function, block),
            Stmt::Pole => self.pole_block(block),
            Stmt::Paraxial => self.path_block(PathFn::Line, block),
            Stmt::Functions => self.functions_block(block),
            Stmt::Rounding => self.corner_block(true, block),
            Stmt::Chamfer => self.corner_block(false, block),
            Stmt::Stop => self.stop_block(block),
            Stmt::Begin { name, unit } => self.core.begins(name.of(text), unit, block),
            Stmt::End { name, unit } => self.end(name.of(text), unit),
            Stmt::BlkForm => self.blank_form(block, text),
            Stmt::ToolDef => self.tool_def(block, text),
            Stmt::ToolCall => self.tool_call(block, text),
            Stmt::Label(label) => self.core.passes_label(label, text),
            Stmt::CallLabel { label, repeat } => self.call_label(label, repeat, text),
            Stmt::CallProgram(name) => {
                let name = self.reading().program_name(name.of(text))?;
                self.call_program(&name)
            }
            Stmt::SelectProgram(name) => {
                self.selected = Some(self.reading().program_name(name.of(text))?);
                Ok(())
            }
            Stmt::CallSelected => self.call_selected(),
            Stmt::Assign(q) | Stmt::AssignText(q) | Stmt::Fn { target: q, .. } => self.assign(q, block, text),
            Stmt::If { test, .. } if !self.reading().holds(test, text)? => Ok(()),
            Stmt::If { target, .. } => {
                let label = self.reading().label(target, text)?;
                self.core.jump(&label)
            }
            Stmt::SystemRead(target) => self.system_read(target, block, text),
            Stmt::FnOther { number, rest } => self.fn_other(number, rest.of(text)),
            Stmt::Cycle { number, part } => self.cycle_block(number, part, block, text),
            Stmt::CycleCall(kind) => self.cycle_call(kind, block, text),
            Stmt::Transform(kind) => self.transform_block(kind, block, text),
            Stmt::PatternDef => {
                let places = Places::read(self.reading(), block);
                self.pattern.define(places)
            }
            Stmt::PlaneReset(_) => self.plane_block(block, text),
            Stmt::Approach => self.approach_block(block, text),
            Stmt::Fk(head) => self.fk_block(head, block, text),
            Stmt::Surface => {
                let (name, span) = block_name(block, text, 1);
                self.st.refuse_motion(&mut self.core, span, codes::K9015::blocks_are_not_supported(&name))
            }
            Stmt::Iso => {
                let (name, span) = block_name(block, text, 1);
                self.st.refuse_motion(&mut self.core, span, codes::P9012::is_din_iso_word(&name))
            }
            Stmt::Refused(what, _) => self.refused(what, block, text),
        }
    }

    /// A block that cannot be read, which was reported. A parameter that it would have set is lost.
    fn bad_block(&mut self, block: &Block, text: &[u8]) {
        let written = block.span.of(text);
        self.st.lose(AxisSet::MAIN);
        self.st.feed.lose(block);
        self.st.lost(&mut self.core);
        self.vars.lose_target(&mut self.core, written);
        self.refused_definition(written);
        if begins_pattern(written) {
            let _ = self.pattern.define(Err(Reported));
        }
    }

    /// End of the whole run: what is still open is worth a word.
    fn report_open(&mut self) {
        let _ = self.close_contour();
        self.warn_of_unclosed();
        let _ = self.forbid_open_approach();
        self.finish_cycle();
        self.cycles.note_uncalled(&self.core);
        self.st.tool.warn_of_forgotten(&self.core);
        self.st.refuse_compensated(&mut self.core, "the program ends");
        if self.st.compensation.is_on() {
            self.core.say_here(codes::P2041::program_ends_with_radius_compensation());
        }
        if !self.st.frames.transform().is_none() || !self.st.tilt.is_upright() {
            self.core.say_here(codes::K2502::program_ends_with_transformation_in_force());
        }
    }
}

/// The text of a comment, which may go over several lines.
fn whole_comment(text: &[u8]) -> Vec<u8> {
    let mut whole = Vec::new();
    for line in text.split(|b| *b == b'\n') {
        let line = line.trim_ascii();
        let line = line.strip_suffix(b"~").unwrap_or(line).trim_ascii();
        if !whole.is_empty() && !line.is_empty() {
            whole.push(b' ');
        }
        whole.extend_from_slice(line);
    }
    whole
}

/// May the block stand between an approach and the first element of its contour, or is it that element?
fn goes_on_with_contour(stmt: Stmt) -> bool {
    use Stmt::{
        Assign, AssignText, BlkForm, CallLabel, Empty, Fk, Fn, FnOther, Functions, If, Label, Paraxial, Path, Pole,
        SystemRead,
    };
    matches!(
        stmt,
        Empty
            | Path(_)
            | Paraxial
            | Fk(_)
            | Functions
            | Pole
            | Label(_)
            | CallLabel { .. }
            | Assign(_)
            | AssignText(_)
            | Fn { .. }
            | If { .. }
            | SystemRead(_)
            | FnOther { .. }
            | BlkForm
    )
}

/// Does executing the block need more of its text than the spans of its words?
fn needs_text(block: &Block) -> bool {
    block.comment.is_some() || !matches!(block.stmt, Stmt::Path(_) | Stmt::Pole | Stmt::Empty)
}
