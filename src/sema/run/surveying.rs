//! The walk over a file that shows its blocks to rules for source text.

use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::text::{FileId, Loc, Span};

use super::Language;
use super::survey::{Notes, Surveyed, Visitor};
use super::unexecuted::{Blocks, Numbers, Passed};

/// What of a block itself is shown.
#[derive(Debug, Clone, Copy, Default)]
pub struct Shown {
    pub number: Option<u32>,
    pub skip: bool,
    /// From the first word to the last.
    pub words: Span,
    pub is_empty: bool,
    /// It cannot be read, which is reported elsewhere; so is what is wrong with its form.
    pub is_bad: bool,
}

/// A language whose blocks can be shown.
pub trait Shows: Language {
    /// What blocks in front say of those behind them.
    type Before: Default;

    /// Notes the comments of a block, and its items where they are wanted.
    fn show(
        passed: &Passed<'_, Self>,
        symbols: &Symbols,
        before: &mut Self::Before,
        items: bool,
        notes: &mut Notes,
    ) -> Shown;
}

/// Leads `visitor` through a file.
pub fn survey_file<L: Shows>(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    let start = Loc { file, line: 1, span: Span::default() };
    let Some(mut blocks) = Blocks::<L>::open(job, file, start) else { return };
    let (mut symbols, mut notes) = (Symbols::default(), Notes::default());
    let (mut before, mut numbers) = (L::Before::default(), Numbers::default());
    while let Some(passed) = blocks.next_for(job, &mut symbols, visitor, &mut numbers) {
        notes.clear();
        let shown = L::show(&passed, &symbols, &mut before, visitor.items(), &mut notes);
        let surveyed = Surveyed {
            text: passed.text,
            site: passed.site,
            number: shown.number,
            skip: shown.skip,
            words: shown.words,
            is_empty: shown.is_empty,
            is_bad: shown.is_bad || !passed.problems.is_empty(),
            comments: &notes.comments,
            items: &notes.items,
            passed: numbers.passed,
        };
        numbers.see(surveyed.number);
        visitor.block(&surveyed, job);
    }
}
