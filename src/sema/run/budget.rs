//! What a run costs, and where it ends when it costs too much.

use rustc_hash::FxHashMap;

use crate::diag::{Answer, CallPath, Diagnostic, Diags, Label, codes};
use crate::ir::contour::Sink;
use crate::sema::Job;
use crate::text::Loc;

/// Moves of one block that cost nothing while a program runs straight on.
const FREE_MOVES: u64 = 16;
/// Bytes of a block, and operations of its formulas, that are one step.
pub(super) const BYTES_A_STEP: u32 = 64;
const OPERATIONS_A_STEP: usize = 8;
/// Steps that parsing a block costs.
const PARSING: u64 = 5;
/// Steps that a label of such a block costs.
const LABEL: u64 = 6;
/// Steps that a text costs which is executed as a block.
const TEXT: u64 = 12;
const BYTES_OF_TEXT_A_STEP: usize = 16;
/// Steps that looking for a called program on the disk costs.
const SEARCH: u64 = 250;

/// Steps that an error costs: its words are found before it shows that they were said.
const ERROR: u64 = 12;

/// Steps of a run after a called program that is missing.
const STEPS_IN_DOUBT: u64 = 100_000;

/// With an error nothing is written any more: this part of the limit is left to find further ones.
const AFTER_ERROR: u64 = 10;
/// Steps between two looks at the errors.
const LOOK: u64 = 4096;

/// Counts what a run costs in steps, and knows which jump ran most often.
///
/// A step is a block, a move or a long stretch of text: each takes about the same time, so that the limit of steps is
/// one of time, too.
#[derive(Debug)]
pub struct Budget {
    left: u64,
    limit: u64,
    /// With so many steps left the errors are looked at next.
    look_at: u64,
    /// There was an error, and the rest of the limit was cut.
    is_cut: bool,
    jumps: FxHashMap<Loc, u64>,
    /// Moves that the sink had taken at the last look.
    moves: u64,
    /// Other things than blocks were counted.
    mixed: bool,
    /// What the program does is not known any more: where it stops is no finding.
    in_doubt: bool,
}

impl Budget {
    pub fn new(limit: u64) -> Budget {
        Budget {
            left: limit,
            limit,
            look_at: limit.saturating_sub(LOOK),
            is_cut: false,
            jumps: FxHashMap::default(),
            moves: 0,
            mixed: false,
            in_doubt: false,
        }
    }

    /// Cuts the rest where the run has met an error.
    #[cold]
    fn look(&mut self, diags: &Diags) {
        self.look_at = self.left.saturating_sub(LOOK);
        if !self.is_cut && diags.has_failed() {
            let rest = self.limit / AFTER_ERROR;
            self.is_cut = self.left > rest;
            self.left = self.left.min(rest);
            self.look_at = 0;
        }
    }

    /// The rest is only read for what else it needs: loops in it may depend on what is not known.
    pub fn doubt(&mut self) {
        self.in_doubt = true;
        self.left = self.left.min(STEPS_IN_DOUBT);
    }

    /// Takes the steps of the block before and one for the next; false when none is left, or when `out` is full. Up to
    /// the first jump nothing can run for ever: a file that is read once may have any length.
    #[inline]
    pub fn step(&mut self, out: &dyn Sink, diags: &Diags) -> bool {
        if self.left < self.look_at {
            self.look(diags);
        }
        let load = out.load();
        if self.left == 0 || load.full {
            return false;
        }
        let made = load.moves - self.moves;
        self.moves = load.moves;
        if made > 1 && (made > FREE_MOVES || !self.jumps.is_empty()) {
            self.mixed = true;
            self.left = self.left.saturating_sub(made);
        } else if !self.jumps.is_empty() {
            self.left -= 1;
        }
        true
    }

    /// The same between two places of a pattern, or wherever one block does much: is there anything left?
    pub fn goes_on(&mut self, out: &dyn Sink, diags: &Diags) -> bool {
        if self.left < self.look_at {
            self.look(diags);
        }
        let load = out.load();
        self.mixed = true;
        self.left = self.left.saturating_sub(load.moves - self.moves);
        self.moves = load.moves;
        self.left > 0 && !load.full
    }

    /// Takes `n` steps, for work that grows with a number of the program; false when fewer are left.
    pub fn take(&mut self, n: u64) -> bool {
        self.mixed |= n > 0;
        let enough = self.left >= n;
        self.left = self.left.saturating_sub(n);
        enough
    }

    /// Is there enough left for about so many moves, which are counted once they are made?
    pub fn has(&mut self, moves: f64) -> bool {
        let enough = moves <= self.left as f64;
        self.mixed |= !enough;
        enough
    }

    /// Takes what a block costs over the one step that every block has: its length in bytes, the operations of its
    /// formulas, and that it was parsed although it ran before.
    #[inline]
    pub fn block(&mut self, bytes: u32, operations: usize, parsed_again: bool) {
        if (bytes > BYTES_A_STEP || operations > OPERATIONS_A_STEP || parsed_again) && !self.jumps.is_empty() {
            let parsing = if parsed_again { PARSING } else { 0 };
            self.take(u64::from(bytes / BYTES_A_STEP) + (operations / OPERATIONS_A_STEP) as u64 + parsing);
        }
    }

    /// Takes what the label of a block costs that was parsed again.
    pub fn label(&mut self) {
        if !self.jumps.is_empty() {
            self.take(LABEL);
        }
    }

    /// Takes what a text of so many bytes costs that is executed as a block.
    pub fn text(&mut self, bytes: usize) {
        if !self.jumps.is_empty() {
            self.take(TEXT + (bytes / BYTES_OF_TEXT_A_STEP) as u64);
        }
    }

    /// Takes what `errors` cost.
    #[cold]
    pub fn errors(&mut self, errors: u32) {
        if !self.jumps.is_empty() {
            self.take(ERROR * u64::from(errors));
        }
    }

    /// Takes the steps of looking for a called program.
    pub fn search(&mut self) {
        if !self.jumps.is_empty() {
            self.take(SEARCH);
        }
    }

    /// Notes a jump, repeat or call at `from`.
    pub fn jump(&mut self, from: Loc) {
        *self.jumps.entry(from).or_default() += 1;
    }

    /// Reports a run that has no steps left; `here` is where it stopped. That the output is full was reported.
    pub fn report_end(&self, job: &Job<'_>, out: &dyn Sink, here: Loc, call: CallPath) {
        if !out.load().full && !self.in_doubt {
            job.diags.push(self.exceeded(here, call));
        }
    }

    fn exceeded(&self, here: Loc, call: CallPath) -> Diagnostic {
        let busiest = self.jumps.iter().max_by_key(|(loc, n)| (**n, std::cmp::Reverse((loc.file, loc.span.start))));
        let what = if self.mixed { "steps (blocks, moves and long lines)" } else { "blocks" };
        let stopped = match self.is_cut {
            true => codes::P4001::after_error_fewer_blocks_run(&(self.limit / AFTER_ERROR), &what),
            false => codes::P4001::run_has_no_steps_left(&self.limit, &what).answer(Answer::key("limits", "steps")),
        };
        match busiest {
            Some((&loc, n)) => stopped.at(loc).here(format!("taken {n} times")).also(here, Label::RunStopped),
            None => stopped.at(here).called(call),
        }
    }
}
