//! The walk over the blocks of a file in their order, whether they run or not.

use crate::diag::CallPath;
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::text::blocks::{BlockText, Place};
use crate::text::{Cursor, FileId, Loc, Span, SplitRules};

use super::Language;
use super::files::open_cursor;
use super::report::report_problem;
use super::site::Site;
use super::source::Parsed;

/// Reads every block of the main program and reports what is wrong with its form.
pub fn check_form<L: Language>(job: &Job<'_>) {
    let mut symbols = Symbols::default();
    let Some(mut blocks) = Blocks::<L>::of_main(job) else { return };
    while let Some(mut passed) = blocks.next_behind_straight(job, &mut symbols) {
        passed.report_problems(job);
    }
}

/// The texts of the blocks of a file.
#[derive(Debug)]
pub struct Texts {
    pub file: FileId,
    pub cursor: Cursor,
}

impl Texts {
    /// Opens a file at its start; reports what is wrong with it.
    pub fn open(job: &Job<'_>, file: FileId, rules: SplitRules, from: Loc) -> Option<Texts> {
        Some(Texts { file, cursor: open_cursor(job, file, rules, from)? })
    }

    /// The next block that is not too long; none where the file cannot be read on.
    pub fn next(&mut self, job: &Job<'_>) -> Option<BlockText<'_>> {
        self.next_that(job, None, |_| true)
    }

    /// The next block whose text is `wanted`, which it is only where it holds `letter`.
    pub fn next_that(
        &mut self,
        job: &Job<'_>,
        letter: Option<u8>,
        wanted: impl Fn(&[u8]) -> bool,
    ) -> Option<BlockText<'_>> {
        self.cursor.next_readable(job.sources, letter, wanted).ok().flatten()
    }
}

/// The blocks of a file.
#[derive(Debug)]
pub struct Blocks<L: Language> {
    pub texts: Texts,
    language: L,
    parsed: Parsed<L::Block>,
    problems: Vec<Problem>,
}

/// A block in passing.
#[derive(Debug)]
pub struct Passed<'b, L: Language> {
    pub block: &'b L::Block,
    pub text: &'b [u8],
    pub site: Site,
    /// What is wrong with its form.
    pub problems: &'b mut Vec<Problem>,
}

impl<L: Language> Blocks<L> {
    /// Opens a file at its start; reports what is wrong with it.
    pub fn open(job: &Job<'_>, file: FileId, from: Loc) -> Option<Blocks<L>> {
        let texts = Texts::open(job, file, L::SPLIT, from)?;
        Some(Blocks { texts, language: L::default(), parsed: Parsed::default(), problems: Vec::new() })
    }

    pub fn of_main(job: &Job<'_>) -> Option<Blocks<L>> {
        Blocks::open(job, job.main, Loc { file: job.main, line: 1, span: Span::default() })
    }

    /// The next block that is not too long; none where the file cannot be read on.
    pub fn next(&mut self, job: &Job<'_>, symbols: &mut Symbols) -> Option<Passed<'_, L>> {
        self.next_that(job, symbols, None, |_| true)
    }

    /// The next block behind straight ones, which have nothing but a way to go; not all of those are passed over.
    pub fn next_behind_straight(&mut self, job: &Job<'_>, symbols: &mut Symbols) -> Option<Passed<'_, L>> {
        loop {
            let (text, line_end) = self.texts.cursor.ahead();
            let Some(len) = self.language.straight(text, line_end) else { break };
            self.texts.cursor.pass_line(len);
        }
        self.next(job, symbols)
    }

    /// The next block whose text is `wanted`, which it is only where it holds `letter`; the others are not parsed.
    pub fn next_that(
        &mut self,
        job: &Job<'_>,
        symbols: &mut Symbols,
        letter: Option<u8>,
        wanted: impl Fn(&[u8]) -> bool,
    ) -> Option<Passed<'_, L>> {
        let Blocks { texts, language, parsed, problems } = self;
        let file = texts.file;
        let found = texts.next_that(job, letter, wanted)?;
        problems.clear();
        parsed.text.clear();
        language.parse(found.text, parsed, symbols, problems);
        let site = Site::new(file, found.at, found.line, found.lines, CallPath::MAIN);
        Some(Passed { block: &parsed.block, text: found.text, site, problems })
    }
}

impl<L: Language> Passed<'_, L> {
    pub fn report_problems(&mut self, job: &Job<'_>) {
        for problem in self.problems.drain(..) {
            report_problem::<L>(job, &self.site, problem);
        }
    }

    pub fn place(&self) -> Place {
        Place { at: self.site.at, line: self.site.line }
    }

    /// Is its form right, and does none of the ascending `places` lie in it?
    pub fn is_free_of(&self, places: &[u32]) -> bool {
        let first = places.partition_point(|place| *place < self.site.at);
        let end = self.site.at as usize + self.text.len().max(1);
        self.problems.is_empty() && places.get(first).is_none_or(|place| *place as usize >= end)
    }
}
