//! The machine under every interpreter.

use std::cell::Cell;
use std::rc::Rc;

use crate::diag::codes;
use crate::ir::contour::{Coords, Corner, CtxRef, Move, Path, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Function, Origin, Pos, Tap};
use crate::parser::problem::Problem;
use crate::parser::straight::Straight;
use crate::parser::symbols::Symbols;
use crate::sema::{Job, Outcome, Reported};
use crate::text::{FileId, Loc, Span};

use super::Language;
use super::budget::{BYTES_A_STEP, Budget};
use super::chosen_tool::ChosenTool;
use super::level::{Level, Program};
use super::printed::{PrintedOffsets, PrintedTools};
use super::site::Site;
use super::source::{Parsed, Read};

/// Files, call stack, budget, and the block in hand.
pub struct Core<'a, L: Language> {
    pub job: Job<'a>,
    pub out: &'a mut dyn Sink,
    pub language: L,
    pub symbols: Symbols,
    pub programs: Vec<Program<L>>,
    pub levels: Vec<Level<L::Frame>>,
    pub budget: Budget,
    /// The block in hand.
    pub here: Site,
    /// What is wrong with the form of the block in hand.
    pub problems: Vec<Problem>,
    /// Room for a block, so that reading one does not allocate.
    pub(super) scratch: Option<Box<Parsed<L::Block>>>,
    /// Marks of the skip levels 0 and 1 that were met, as bits.
    skip_marks: Cell<u8>,
    ended: Cell<bool>,
    /// A called program is missing: nobody knows what it would have changed.
    pub(super) in_doubt: bool,
    pub(super) printed_offsets: PrintedOffsets,
    /// A move counted from the work offset that is selected.
    pub(super) moved: bool,
    pub(super) printed_tools: PrintedTools,
    pub(super) chosen_tool: ChosenTool,
    pub(super) errors: Cell<u32>,
    /// So many of them have cost their steps.
    paid: u32,
}

impl<L: Language> std::fmt::Debug for Core<'_, L> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Core").field("here", &self.here).finish_non_exhaustive()
    }
}

impl<'a, L: Language> Core<'a, L> {
    pub fn new(job: &Job<'a>, out: &'a mut dyn Sink) -> Core<'a, L> {
        Core {
            job: *job,
            out,
            language: L::default(),
            symbols: Symbols::default(),
            programs: Vec::new(),
            levels: Vec::new(),
            budget: Budget::new(job.settings.limits.steps),
            here: Site::default(),
            problems: Vec::new(),
            scratch: None,
            skip_marks: Cell::new(0),
            ended: Cell::new(false),
            in_doubt: false,
            printed_offsets: PrintedOffsets::default(),
            moved: false,
            printed_tools: PrintedTools::default(),
            chosen_tool: ChosenTool::default(),
            errors: Cell::new(0),
            paid: 0,
        }
    }
}

impl<L: Language> Core<'_, L> {
    pub(super) fn open_main(&mut self) -> Option<usize> {
        let file = self.job.main;
        self.open(file, Loc { file, line: 1, span: Span::default() })
    }

    /// Opens a file of the run, unless it is open already.
    pub fn open(&mut self, file: FileId, from: Loc) -> Option<usize> {
        if let Some(at) = self.programs.iter().position(|program| program.source.file == file) {
            return Some(at);
        }
        self.programs.push(Program::open(&self.job, file, from)?);
        Some(self.programs.len() - 1)
    }

    /// Hash of the text of the main program.
    pub(super) fn hash(&mut self) -> u64 {
        let sources = self.job.sources;
        self.programs.first_mut().and_then(|main| main.source.cursor.content_hash(sources).ok()).unwrap_or(0)
    }

    /// Errors that the run reported.
    pub fn errors(&self) -> u32 {
        self.errors.get()
    }

    /// A called program is missing. The rest is read for what else it needs; what only suffers is not worth an error.
    pub fn go_on_in_doubt(&mut self) {
        self.in_doubt = true;
        self.budget.doubt();
    }

    /// No further block runs.
    pub fn stop_run(&self) {
        self.ended.set(true);
    }

    #[inline]
    pub fn has_ended(&self) -> bool {
        self.ended.get()
    }

    /// Takes the step of one more block; the run ends where none is left, or where the output takes no more.
    #[inline]
    pub(super) fn has_steps(&mut self) -> bool {
        self.has_steps_at(self.here.origin.loc)
    }

    /// The same, for a stretch of blocks that began at `loc`.
    #[inline]
    pub fn has_steps_at(&mut self, loc: Loc) -> bool {
        self.job.trail.step();
        if self.errors.get() != self.paid {
            self.budget.errors(self.errors.get().saturating_sub(self.paid));
            self.paid = self.errors.get();
        }
        let goes_on = self.budget.step(&*self.out, self.job.diags);
        if !goes_on {
            self.out_of_steps(loc);
        }
        goes_on
    }

    #[cold]
    fn out_of_steps(&mut self, loc: Loc) {
        let call = self.level().call;
        self.budget.report_end(&self.job, &*self.out, loc, call);
        self.stop_run();
    }

    /// Between two places of a pattern: the run ends here where no step is left, or the output takes no more.
    pub fn goes_on(&mut self) -> Outcome {
        if self.budget.goes_on(&*self.out, self.job.diags) {
            return Ok(());
        }
        self.budget.report_end(&self.job, &*self.out, self.here.origin.loc, self.here.origin.call);
        self.stop_run();
        Err(Reported)
    }

    /// The next block, if it is a straight one that costs no more than its step. It stays the next one.
    #[inline(always)]
    pub fn straight_ahead(&mut self, decode: impl FnOnce(&[u8], u8) -> Option<Straight>) -> Option<Straight> {
        let (at, _) = self.running();
        let (text, line_end) = self.programs[at].source.cursor.ahead();
        decode(text, line_end).filter(|line| line.len <= BYTES_A_STEP as usize)
    }

    /// The straight block is the block in hand.
    #[inline(always)]
    pub fn take_straight(&mut self, line: &Straight) {
        let (at, call) = self.running();
        self.here = self.programs[at].source.pass_line(line.len, call);
        self.here.mark(line.words);
    }

    /// The next block, if it was read before.
    #[inline]
    pub(super) fn read_before(&mut self) -> Option<Rc<Parsed<L::Block>>> {
        let (at, call) = self.running();
        let source = &mut self.programs[at].source;
        let (parsed, site) = source.again(call)?;
        let (bytes, _) = source.cost(&site);
        self.budget.block(bytes, L::operations(&parsed.block), false);
        self.here = site;
        Some(parsed)
    }

    /// Reads the next block of the program that runs.
    #[inline]
    pub(super) fn read(&mut self, into: &mut Parsed<L::Block>) -> Read {
        let (at, call) = self.running();
        let Core { language, symbols, problems, .. } = self;
        let source = &mut self.programs[at].source;
        let read = source.read(&self.job, call, into, |text, into| language.parse(text, into, symbols, problems));
        if let Read::Block(site) = &read {
            let (bytes, again) = source.cost(site);
            self.budget.block(bytes, L::operations(&into.block), again);
            if again && L::has_label(&into.block) {
                self.budget.label();
            }
        }
        read
    }

    /// Reads the next block, which is not executed; what is wrong with its form does not matter.
    pub fn pass_block(&mut self, into: &mut Parsed<L::Block>) -> Read {
        let (at, call) = self.running();
        let Core { language, symbols, problems, .. } = self;
        let source = &mut self.programs[at].source;
        let read = source.pass(&self.job, call, into, |text, into| language.parse(text, into, symbols, problems));
        self.problems.clear();
        if let Read::Block(site) = &read {
            let (bytes, again) = self.programs[at].source.cost(site);
            self.budget.block(bytes, L::operations(&into.block), again);
            self.here = *site;
            self.here.mark(L::span(&into.block));
        }
        read
    }

    /// Does the control skip the block in hand for its mark? Says once where `[1]` takes two levels together.
    #[inline]
    pub fn skips(&self, mark: Option<u8>) -> bool {
        let Some(level) = mark else { return false };
        let on = &self.job.settings.control.skip_blocks;
        if level <= 1 && on.contains(&1) && !on.contains(&0) {
            let met = self.skip_marks.get();
            self.skip_marks.set(met | 1 << level);
            if met | 1 << level == 0b11 && met != 0b11 {
                self.two_skip_levels();
            }
        }
        self.job.skips(mark)
    }

    #[cold]
    fn two_skip_levels(&self) {
        self.report(codes::P0201::skip_blocks_1_leaves_out_blocks().at(self.here.origin.loc));
    }

    /// A comment of the program, where the output shows them.
    #[inline]
    pub fn comment_of(&self, text: &[u8]) -> Option<Function> {
        if !self.job.settings.output.comments {
            return None;
        }
        let text = text.trim_ascii();
        (!text.is_empty()).then(|| Function::Comment(text.to_vec()))
    }

    // Items of the contour.

    pub fn begins_at(&mut self, position: &Pos) {
        self.out.begins_at(position);
    }

    /// Behind a tool change or a move in machine coordinates these axes stand where the configuration says.
    pub fn stands_at(&mut self, position: &Pos, ctx: &CtxRef) {
        if !position.known().is_empty() {
            let origin = self.here.origin;
            self.out.stands_at(position, ctx, &origin);
        }
    }

    #[inline]
    pub fn send_move(&mut self, mv: &Move, ctx: &CtxRef) {
        let origin = self.here.origin;
        self.send_move_of(mv, ctx, &origin);
    }

    /// A move of another block than the one in hand.
    #[inline]
    pub fn send_move_of(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin) {
        if mv.is_out_of_range() {
            return self.out_of_range(ctx, origin);
        }
        self.moved |= mv.coords == Coords::Frame;
        if !matches!(mv.path, Path::Rapid) {
            self.chosen_tool.cuts();
        }
        self.out.movement(mv, ctx, origin);
    }

    #[cold]
    fn out_of_range(&mut self, ctx: &CtxRef, origin: &Origin) {
        self.report(codes::O1002::number_of_this_block_is_too_large_to().at(origin.loc));
        self.out.lost(ctx, origin);
    }

    pub fn send_corner(&mut self, corner: &Corner, ctx: &CtxRef) {
        let origin = self.here.origin;
        self.send_corner_of(corner, ctx, &origin);
    }

    /// A corner of another block than the one in hand.
    pub fn send_corner_of(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin) {
        self.out.corner(corner, ctx, origin);
    }

    /// A comment of the program, where the output shows them.
    pub fn send_comment(&mut self, text: &[u8], ctx: &CtxRef) {
        if let Some(comment) = self.comment_of(text) {
            self.send_function(&comment, ctx);
        }
    }

    pub fn send_function(&mut self, function: &Function, ctx: &CtxRef) {
        self.chosen_tool.function(function, self.here.origin.loc);
        self.out.function(function, ctx, &self.here.origin);
    }

    pub fn send_cycle(&mut self, cycle: &Cycle, ctx: &CtxRef) {
        if !self.budget.has(cycle.moves()) {
            return self.out_of_steps(self.here.origin.loc);
        }
        self.moved = true;
        self.chosen_tool.cuts();
        self.out.cycle(cycle, ctx, &self.here.origin);
    }

    /// A tap from where the tool stands.
    pub fn send_tap(&mut self, tap: &Tap, ctx: &CtxRef) {
        let origin = self.here.origin;
        self.send_tap_of(tap, ctx, &origin);
    }

    /// A tap of another block than the one in hand.
    pub fn send_tap_of(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin) {
        self.moved = true;
        self.chosen_tool.cuts();
        self.out.tap(tap, ctx, origin);
    }

    /// The loss of a tool change was reported.
    pub fn change_was_reported(&mut self) {
        self.chosen_tool = ChosenTool::Settled;
    }

    /// Says so where the program chose a tool, cut, and never changed one; unless it is known which word changes tools.
    pub fn report_no_change(&mut self) {
        let Some(found) = std::mem::take(&mut self.chosen_tool).never_changed() else { return };
        if self.errors() > 0 || self.in_doubt || self.job.settings.control.says_tool_change() {
            return;
        }
        self.job.diags.push(found);
    }

    /// Nobody knows where the tool is.
    pub fn send_lost(&mut self, ctx: &CtxRef) {
        self.out.lost(ctx, &self.here.origin);
    }

    /// The file cannot be read: the run ends.
    pub(super) fn unreadable<T>(&self, error: &std::io::Error) -> Outcome<T> {
        self.end_run(codes::P0105::file_cannot_be_read(&error))
    }
}
