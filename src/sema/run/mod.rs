//! Executes a program: what is the same in every language.
//!
//! [`Core`] is the machine: files, call stack, step budget, the block in hand, findings. A [`Language`] says how text
//! becomes blocks, an [`Interpreter`] what a block does, and [`run`] drives both.

mod budget;
mod calls;
mod chosen_tool;
mod core;
mod described;
mod end;
mod entries;
mod files;
mod level;
mod nowhere;
pub mod place;
mod printed;
mod prints;
pub mod refusal;
mod report;
mod site;
mod source;
pub mod survey;
mod surveying;
pub mod unexecuted;

use crate::diag::Code;
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::text::{Span, SplitRules};

pub use self::calls::like;
pub use self::core::Core;
pub use self::files::{Wanted, no_root, not_opened, open_cursor, open_program, refused};
pub use self::level::{Level, Program};
pub use self::nowhere::Nowhere;
pub use self::printed::OffsetName;
pub use self::report::Where;
pub use self::site::Site;
pub use self::source::{Parsed, Read};
pub use self::surveying::{Shown, Shows, survey_file};

/// How the text of a program becomes blocks. The value holds what reading needs besides the symbols: most languages
/// need nothing.
pub trait Language: Default {
    type Block: Clone + Default;
    /// What is known of a program file besides its text.
    type Known: Default;
    /// What a level of the call stack holds besides the way back.
    type Frame;

    const SPLIT: SplitRules;
    /// Errors after which a run ends.
    const MOST_ERRORS: u32 = u32::MAX;
    /// Does a finding without help of its own get the usual one of its code?
    const USUAL_HELP: bool = false;

    /// Fills `into` from the text of a block. The text is kept only where executing the block needs it.
    fn parse(
        &mut self,
        text: &[u8],
        into: &mut Parsed<Self::Block>,
        symbols: &mut Symbols,
        problems: &mut Vec<Problem>,
    );

    /// Length and words of the line at the start of `text`, if it is a straight block: its form is right, it has no words
    /// but those of axes and a feed, and nothing else depends on it than the position.
    fn straight(&self, _text: &[u8], _line_end: u8) -> Option<(usize, Span)> {
        None
    }

    /// The words of the block, without the blanks around them.
    fn span(block: &Self::Block) -> Span;

    /// Operations of its formulas, for the budget.
    fn operations(block: &Self::Block) -> usize;

    /// Does the block have a label besides its words, which is noted whenever the block is parsed?
    fn has_label(_block: &Self::Block) -> bool {
        false
    }

    /// Is a problem of this kind said once for the whole program?
    fn said_once(_code: &'static Code) -> bool {
        false
    }
}

/// What the blocks of a language do.
pub trait Interpreter<'a> {
    type Language: Language;

    /// The machine under it.
    fn core(&mut self) -> &mut Core<'a, Self::Language>;

    /// The main program is open, and nothing of it was read. Says where the machine stands.
    fn begin(&mut self, program: usize) -> Level<<Self::Language as Language>::Frame>;

    fn execute(&mut self, block: &<Self::Language as Language>::Block, text: &[u8]);

    /// The file has no further block.
    fn end_of_file(&mut self);

    /// A block too long to be read was reported: nobody knows what it would have done.
    fn unread_block(&mut self);

    /// True if a level ended in front of the next block, which is not the end of its file.
    #[inline]
    fn level_ends(&mut self) -> bool {
        false
    }

    /// Executes the next block where it is a straight one and nothing else is on; false if it did nothing.
    #[inline]
    fn line_lane(&mut self) -> bool {
        false
    }

    /// Drops the problems in the form of `block` that do not matter where it stands.
    fn forgive(&mut self, _block: &<Self::Language as Language>::Block) {}

    /// The run is over: what is still open is worth a word.
    fn finish(&mut self) {}
}

/// Runs the main program to its end. Returns the hash of its text, 0 where it cannot be opened.
pub fn run<'a, I: Interpreter<'a>>(run: &mut I) -> u64 {
    let Some(program) = run.core().open_main() else { return 0 };
    let level = run.begin(program);
    run.core().levels.push(level);
    while !run.core().has_ended() {
        step(run);
    }
    run.finish();
    run.core().hash()
}

/// Executes one block.
#[inline]
pub fn step<'a, I: Interpreter<'a>>(run: &mut I) {
    if !run.core().has_steps() || run.level_ends() || run.line_lane() {
        return;
    }
    if let Some(parsed) = run.core().read_before() {
        run.core().here.mark(I::Language::span(&parsed.block));
        return run.execute(&parsed.block, &parsed.text);
    }
    let mut parsed = run.core().scratch.take().unwrap_or_default();
    match run.core().read(&mut parsed) {
        Read::Block(site) => {
            run.core().here = site;
            if !run.core().problems.is_empty() {
                run.forgive(&parsed.block);
                run.core().report_problems();
            }
            run.core().here.mark(I::Language::span(&parsed.block));
            run.execute(&parsed.block, &parsed.text);
        }
        Read::TooLong => run.unread_block(),
        Read::End => run.end_of_file(),
        Read::Broken => run.core().stop_run(),
    }
    run.core().scratch = Some(parsed);
}
