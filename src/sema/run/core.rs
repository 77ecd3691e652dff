//! The machine under every interpreter.

use std::cell::Cell;
use std::rc::Rc;

use crate::diag::codes;
use crate::ir::contour::{Corner, CtxRef, Move, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Function, Pos};
use crate::parser::problem::Problem;
use crate::parser::straight::Straight;
use crate::parser::symbols::Symbols;
use crate::sema::{Job, Outcome, Reported};
use crate::text::{FileId, Loc, Span};

use super::Language;
use super::budget::{BYTES_A_STEP, Budget};
use super::level::{Level, Program};
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
    ended: Cell<bool>,
    pub(super) errors: Cell<u32>,
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
            ended: Cell::new(false),
            errors: Cell::new(0),
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
    pub fn hash(&mut self) -> u64 {
        let sources = self.job.sources;
        self.programs.first_mut().and_then(|main| main.source.cursor.content_hash(sources).ok()).unwrap_or(0)
    }

    /// Errors that the run reported.
    pub fn errors(&self) -> u32 {
        self.errors.get()
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
        let goes_on = self.budget.step(&*self.out);
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
        if self.budget.goes_on(&*self.out) {
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

    #[inline]
    pub fn send_move(&mut self, mv: &Move, ctx: &CtxRef) {
        self.out.movement(mv, ctx, &self.here.origin);
    }

    pub fn send_corner(&mut self, corner: &Corner, ctx: &CtxRef) {
        self.out.corner(corner, ctx, &self.here.origin);
    }

    pub fn send_function(&mut self, function: &Function, ctx: &CtxRef) {
        self.out.function(function, ctx, &self.here.origin);
    }

    pub fn send_cycle(&mut self, cycle: &Cycle, ctx: &CtxRef) {
        self.out.cycle(cycle, ctx, &self.here.origin);
    }

    /// Nobody knows where the tool is.
    pub fn send_lost(&mut self, ctx: &CtxRef) {
        self.out.lost(ctx, &self.here.origin);
    }

    /// The last byte of the file that runs, which has no further block.
    pub fn end_of_text(&mut self) -> Loc {
        let source = &self.program().source;
        let place = source.cursor.place();
        let span = Span::at(place.at.saturating_sub(1), 1);
        Loc { file: source.file, line: place.line.saturating_sub(1).max(1), span }
    }

    /// The file cannot be read: the run ends.
    pub(super) fn unreadable<T>(&self, error: &std::io::Error) -> Outcome<T> {
        self.fatal(codes::P0105, format!("the file cannot be read: {error}"))
    }
}
