//! The walk over the blocks of a file in their order, whether they run or not.

use std::cell::Cell;
use std::rc::Rc;

use crate::diag::CallPath;
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::text::blocks::BlockText;
use crate::text::lines::Stretch;
use crate::text::number::leading_digits;
use crate::text::{Cursor, FileId, Loc, Place, Span, SplitRules};

use super::Language;
use super::files::open_cursor;
use super::report::report_problem;
use super::site::Site;
use super::source::Parsed;
use super::survey::{LONG, OfStraight, StraightLine, Visitor};

/// Reads every block of the main program and reports what is wrong with its form.
pub fn check_form<L: Language>(job: &Job<'_>) {
    let mut symbols = Symbols::default();
    let Some(mut blocks) = Blocks::<L>::of_main(job) else { return };
    while let Some(mut passed) = blocks.next_behind_straight(job, &mut symbols) {
        passed.report_problems(job);
    }
    blocks.note_straight(job);
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
        self.cursor.next_readable(job.sources, None, |_| true, |_| None).ok().flatten()
    }
}

/// The blocks of a file.
#[derive(Debug)]
pub struct Blocks<L: Language> {
    pub texts: Texts,
    language: L,
    parsed: Parsed<L::Block>,
    problems: Vec<Problem>,
    known: Known,
    /// Those that this one finds.
    found: Vec<Stretch>,
}

/// Straight lines that an earlier walk found.
#[derive(Debug)]
struct Known {
    stretches: Rc<[Stretch]>,
    /// So many of them lie behind.
    behind: Cell<usize>,
}

impl Known {
    /// The stretch that begins at this offset.
    fn at(&self, at: u32) -> Option<&Stretch> {
        let mut behind = self.behind.get();
        while self.stretches.get(behind)?.start.at < at {
            behind += 1;
            self.behind.set(behind);
        }
        self.stretches.get(behind).filter(|stretch| stretch.start.at == at)
    }
}

/// Lines of a stretch that is worth noting.
const LEAST_NOTED: u32 = 8;
/// Most stretches that are noted.
const MOST_NOTED: usize = 1 << 16;

/// The block numbers of a walk.
#[derive(Debug, Default)]
pub struct Numbers {
    /// The last one.
    seen: Option<u32>,
    /// The last one of the straight lines that were passed over just now.
    pub passed: Option<u32>,
}

impl Numbers {
    pub fn see(&mut self, number: Option<u32>) {
        self.seen = number.or(self.seen);
    }

    /// Goes to the last number of a stretch, if its first one is higher than those before.
    fn rise_to(&mut self, stretch: &Stretch) -> bool {
        let Some((first, last)) = stretch.numbers else { return true };
        let rises = self.seen.is_none_or(|seen| seen < first);
        if rises {
            (self.seen, self.passed) = (Some(last), Some(last));
        }
        rises
    }
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
        Some(Blocks {
            texts,
            language: L::default(),
            parsed: Parsed::default(),
            problems: Vec::new(),
            known: Known { stretches: job.sources.straight(file), behind: Cell::new(0) },
            found: Vec::new(),
        })
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
        self.pass_straight(&mut Numbers::default(), None);
        self.next(job, symbols)
    }

    /// The next block that `visitor` wants.
    pub fn next_for(
        &mut self,
        job: &Job<'_>,
        symbols: &mut Symbols,
        visitor: &mut dyn Visitor,
        numbers: &mut Numbers,
    ) -> Option<Passed<'_, L>> {
        numbers.passed = None;
        if visitor.wanted().letter.is_none() {
            match visitor.straight() {
                OfStraight::Whole => {}
                OfStraight::Places => self.pass_straight(numbers, Some(visitor)),
                OfStraight::Nothing => self.pass_straight(numbers, None),
            }
        }
        let wanted = visitor.wanted();
        self.next_that(job, symbols, wanted.letter, wanted.is)
    }

    /// Passes over straight lines, up to one whose number does not rise, or that holds a long number. `each` takes them.
    fn pass_straight(&mut self, numbers: &mut Numbers, mut each: Option<&mut dyn Visitor>) {
        let start = self.texts.cursor.place();
        if each.is_none()
            && let Some(stretch) = self.known.at(start.at).filter(|stretch| numbers.rise_to(stretch))
        {
            return self.texts.cursor.pass_to(stretch.end);
        }
        let mut first = None;
        loop {
            let (text, line_end) = self.texts.cursor.ahead();
            let Some((len, words)) = self.language.straight(text, line_end) else { break };
            let Some((number, rest)) = text.get(..len).and_then(number_of) else { break };
            if has_long_number(rest) || number.is_some() && number <= numbers.seen {
                break;
            }
            if number.is_some() {
                first = first.or(number);
                (numbers.seen, numbers.passed) = (number, number);
            }
            if let Some(each) = &mut each {
                let at = self.texts.cursor.place().at;
                let ends =
                    text[words.end as usize..len].iter().rev().take_while(|b| matches!(b, b'\r' | b'\n')).count();
                let span = Span::at(at, (len - ends) as u32);
                each.straight_line(&StraightLine { span, words: words.shifted(at), number });
            }
            self.texts.cursor.pass_line(len);
        }
        let end = self.texts.cursor.place();
        if end.line - start.line >= LEAST_NOTED && self.found.len() < MOST_NOTED {
            self.found.push(Stretch { start, end, numbers: first.zip(numbers.passed) });
        }
    }

    /// Notes the straight lines that were passed over, for the walks to come.
    pub fn note_straight(&mut self, job: &Job<'_>) {
        job.sources.note_straight(self.texts.file, std::mem::take(&mut self.found));
    }

    /// The next block whose text is `wanted`, which it is only where it holds `letter`; the others are not parsed.
    pub fn next_that(
        &mut self,
        job: &Job<'_>,
        symbols: &mut Symbols,
        letter: Option<u8>,
        wanted: impl Fn(&[u8]) -> bool,
    ) -> Option<Passed<'_, L>> {
        self.next_from(job, symbols, (letter, false), wanted)
    }

    /// The same for what is no straight line, whatever its number.
    pub fn next_bent(
        &mut self,
        job: &Job<'_>,
        symbols: &mut Symbols,
        wanted: impl Fn(&[u8]) -> bool,
    ) -> Option<Passed<'_, L>> {
        self.next_from(job, symbols, (None, true), wanted)
    }

    fn next_from(
        &mut self,
        job: &Job<'_>,
        symbols: &mut Symbols,
        (letter, bent): (Option<u8>, bool),
        wanted: impl Fn(&[u8]) -> bool,
    ) -> Option<Passed<'_, L>> {
        let Blocks { texts, language, parsed, problems, known, .. } = self;
        let file = texts.file;
        let pass = |at| known.at(at).filter(|_| bent).map(|stretch| stretch.end);
        let found = texts.cursor.next_readable(job.sources, letter, wanted, pass).ok().flatten()?;
        problems.clear();
        parsed.text.clear();
        language.parse(found.text, parsed, symbols, problems);
        let site = Site::new(file, found.at, found.line, found.lines, CallPath::MAIN);
        Some(Passed { block: &parsed.block, text: found.text, site, problems })
    }
}

/// The block number at the start of a straight line, and what follows it.
fn number_of(line: &[u8]) -> Option<(Option<u32>, &[u8])> {
    let blank = |b: &u8| matches!(b, b' ' | b'\t');
    let from = line.iter().position(|b| !blank(b))?;
    let from = from + usize::from(matches!(line[from], b'N' | b'n'));
    let digits = leading_digits(line.get(from..)?)?;
    let words = &line[from + digits..];
    if digits == 0 {
        return Some((None, words));
    }
    let number = std::str::from_utf8(&line[from..from + digits]).ok()?.parse().ok()?;
    Some((Some(number), words))
}

/// Are there [`LONG`] digits in a row? One of them stands at a multiple of so many bytes.
fn has_long_number(words: &[u8]) -> bool {
    let digits = |bytes: &mut dyn Iterator<Item = &u8>| bytes.take_while(|b| b.is_ascii_digit()).count();
    (LONG - 1..words.len()).step_by(LONG).any(|at| {
        words[at].is_ascii_digit() && digits(&mut words[..at].iter().rev()) + digits(&mut words[at..].iter()) >= LONG
    })
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
