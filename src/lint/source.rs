//! The walk of rules over the blocks of a program, whether they run or not.

use crate::diag::Diagnostic;
use crate::sema::Job;
use crate::sema::run::survey::{OfStraight, Surveyed, Visitor, Wanted, What};
use crate::text::{Loc, Span};

use super::fix::Fix;
use super::motion::{Bar, Blank, Say};

/// A rule over the blocks of the main program.
pub trait SourceRule {
    fn block(&mut self, block: &Read<'_>, say: &mut Report<'_>);
    /// Does the next straight line matter? See [`Visitor::straight`].
    fn wants_straight(&self) -> bool {
        false
    }
    /// The file has no further block.
    fn finish(&mut self, _: &mut Report<'_>) {}
}

/// A block with a way to its places.
pub struct Read<'b> {
    pub block: &'b Surveyed<'b>,
    job: &'b Job<'b>,
}

impl std::fmt::Debug for Read<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.block.fmt(f)
    }
}

impl Read<'_> {
    /// A place in the block.
    pub fn loc(&self, span: Span) -> Loc {
        self.block.site.loc(self.job, span)
    }

    /// The words of the block.
    pub fn words(&self) -> Loc {
        self.loc(self.block.words)
    }

    /// Is there such an item?
    pub fn has(&self, what: &What) -> bool {
        self.block.items.iter().any(|item| item.what == *what)
    }
}

/// Takes what rules find, and how it is mended.
pub struct Report<'t> {
    pub say: Say<'t>,
    pub fixes: &'t mut Vec<Fix>,
}

impl std::fmt::Debug for Report<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Report").finish_non_exhaustive()
    }
}

/// Most changes that are proposed at once.
const MOST_FIXES: usize = 1 << 20;

impl Report<'_> {
    /// Takes a finding with what mends it.
    pub fn found_with(&mut self, found: Diagnostic, fix: Fix) {
        self.say.found(found);
        if self.fixes.len() < MOST_FIXES {
            self.fixes.push(fix);
        }
    }
}

/// Leads the rules through the blocks.
pub struct Reader<'a> {
    pub rules: Vec<Box<dyn SourceRule + 'a>>,
    pub say: Say<'a>,
    pub fixes: Vec<Fix>,
}

impl std::fmt::Debug for Reader<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Reader").finish_non_exhaustive()
    }
}

impl Reader<'_> {
    pub fn finish(&mut self) {
        let Reader { rules, say, fixes } = self;
        let mut report = Report { say: *say, fixes };
        rules.iter_mut().for_each(|rule| rule.finish(&mut report));
    }
}

impl Visitor for Reader<'_> {
    fn wanted(&self) -> Wanted<'_> {
        Wanted::ALL
    }

    fn items(&self) -> bool {
        true
    }

    fn straight(&self) -> OfStraight {
        if self.rules.iter().any(|rule| rule.wants_straight()) { OfStraight::Whole } else { OfStraight::Nothing }
    }

    fn block(&mut self, block: &Surveyed<'_>, job: &Job<'_>) {
        let Reader { rules, say, fixes } = self;
        let mut report = Report { say: *say, fixes };
        let read = Read { block, job };
        rules.iter_mut().for_each(|rule| rule.block(&read, &mut report));
    }
}

/// Bytes of a block that are looked at for the words of a blank.
const HEAD: usize = 40;

fn begins_with_blank(text: &[u8]) -> bool {
    let head = &text[..text.len().min(HEAD)];
    head.windows(3).any(|word| word.eq_ignore_ascii_case(b"BLK") || word.eq_ignore_ascii_case(b"BEG"))
}

/// Finds the blank that a program describes.
#[derive(Debug, Default)]
pub struct FindsBlank {
    corners: [Option<[f64; 3]>; 2],
    bar: Option<Bar>,
    parts: bool,
    /// On lathes any block may belong to it.
    lathe: bool,
}

impl FindsBlank {
    pub fn on(lathe: bool) -> FindsBlank {
        FindsBlank { lathe, ..FindsBlank::default() }
    }

    pub fn bar(&self) -> Option<Bar> {
        self.bar.filter(|bar| !self.parts && bar.is_one())
    }

    pub fn blank(&self) -> Option<Blank> {
        let [Some(min), Some(max)] = self.corners else { return None };
        min.iter().zip(&max).all(|(min, max)| min < max).then_some(Blank { min, max })
    }
}

impl Visitor for FindsBlank {
    fn wanted(&self) -> Wanted<'_> {
        if self.lathe {
            return Wanted::ALL;
        }
        // `BLK FORM`, and the unit in `BEGIN PGM`.
        Wanted { letter: Some(b'B'), is: &begins_with_blank }
    }

    fn items(&self) -> bool {
        true
    }

    fn straight(&self) -> OfStraight {
        OfStraight::Nothing
    }

    fn block(&mut self, block: &Surveyed<'_>, _: &Job<'_>) {
        for item in block.items {
            match item.what {
                What::BlankCorner { high, at } => self.corners[usize::from(high)] = Some(at),
                What::BlankBar { radius, bore, left, right } => {
                    self.bar = Some(Bar { radius, bore, left, right });
                }
                What::Parts => self.parts = true,
                _ => {}
            }
        }
    }
}
