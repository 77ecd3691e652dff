//! Blocks as rules for source text see them, in every language alike, whether they run or not.

use crate::geo::Plane;
use crate::sema::Job;
use crate::sema::run::Site;
use crate::text::{FileId, Span};

/// What a rule may want to know of a block.
#[derive(Debug, Clone, PartialEq)]
pub enum What {
    /// A label, by its name in one spelling.
    Label(String),
    /// A jump to a label or its call.
    Uses(String),
    /// A jump or call whose target is computed.
    UsesUnknown,
    /// A variable gets a value.
    Writes(String),
    /// A variable is read.
    Reads(String),
    /// Another program runs, or a name is computed: what it reads and writes is not known.
    Opaque,
    /// The program ends here: what follows runs only where something leads to it.
    Ends,
    /// The program or subprogram goes on elsewhere, whatever happens.
    Leaves,
    /// Something that blocks in front of it need not lead to: a section, or the head of a subprogram.
    Begins,
    /// A branch or a loop begins or ends: what stands behind it may run or not.
    Branches,
    /// A corner of the blank, the high one or the low one, in mm.
    BlankCorner { high: bool, at: [f64; 3] },
    /// A bar about Z as the blank: its radius and that of its bore, and where it ends along Z, in mm.
    BlankBar { radius: f64, bore: f64, left: f64, right: f64 },
    /// The working plane, where no G function says it.
    Plane(Plane),
    /// A pole or centre for blocks that follow.
    Pole,
    /// A block that counts from the pole.
    Polar,
    /// Coordinates of the diameter axis are radii from here on, or diameters again.
    Radii(bool),
    /// Several parts, each with a blank of its own.
    Parts,
    /// F and S of the block are for the tool, or for this block alone: no modal words.
    OwnValues,
    /// A word with a letter and a literal: `G1`, `F200`.
    Word { letter: u8, value: f64 },
}

/// Something in a block, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    pub what: What,
    /// Counted from the start of the block.
    pub span: Span,
}

/// A block in passing.
#[derive(Debug)]
pub struct Surveyed<'b> {
    pub text: &'b [u8],
    pub site: Site,
    pub number: Option<u32>,
    /// It has a skip mark.
    pub skip: bool,
    /// The block from its first word to its last.
    pub words: Span,
    /// It has a comment at most.
    pub is_empty: bool,
    /// It cannot be read, which is reported elsewhere.
    pub is_bad: bool,
    /// Texts of its comments, without their signs.
    pub comments: &'b [Span],
    pub items: &'b [Item],
    /// The number of the last straight line in front of it, where such were passed over.
    pub passed: Option<u32>,
}

/// Which blocks are looked at.
#[derive(Clone, Copy)]
pub struct Wanted<'w> {
    /// A letter that all of them hold.
    pub letter: Option<u8>,
    pub is: &'w dyn Fn(&[u8]) -> bool,
}

impl std::fmt::Debug for Wanted<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Wanted").field("letter", &self.letter).finish_non_exhaustive()
    }
}

impl Wanted<'_> {
    pub const ALL: Wanted<'static> = Wanted { letter: None, is: &|_| true };
}

/// How much of straight lines is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfStraight {
    /// The same as of other blocks.
    Whole,
    Places,
    Nothing,
}

/// Where a straight line is in its file, and where its words are.
#[derive(Debug, Clone, Copy)]
pub struct StraightLine {
    pub span: Span,
    pub words: Span,
    pub number: Option<u32>,
}

/// Takes the blocks of a file one after the other, and says which ones it wants next.
pub trait Visitor {
    fn wanted(&self) -> Wanted<'_>;
    /// Are the items of blocks wanted, not their comments alone?
    fn items(&self) -> bool;
    /// What about straight lines: those with nothing but axes, a feed, and G0 or G1, whose block numbers rise and whose
    /// numbers are not [long](LONG)?
    fn straight(&self) -> OfStraight {
        OfStraight::Whole
    }
    /// Takes a straight line by its [places](OfStraight::Places).
    fn straight_line(&mut self, _: &StraightLine) {}
    fn block(&mut self, block: &Surveyed<'_>, job: &Job<'_>);
}

/// A number with as many digits in a row is looked at, whatever its line.
pub const LONG: usize = 6;

/// Leads a visitor through a file.
pub type Survey = fn(&Job<'_>, FileId, &mut dyn Visitor);

/// Collects the items of a block.
#[derive(Debug, Default)]
pub struct Notes {
    pub items: Vec<Item>,
    pub comments: Vec<Span>,
}

impl Notes {
    pub fn clear(&mut self) {
        self.items.clear();
        self.comments.clear();
    }

    pub fn add(&mut self, what: What, span: Span) {
        self.items.push(Item { what, span });
    }

    pub fn word(&mut self, letter: u8, value: f64, span: Span) {
        self.add(What::Word { letter, value }, span);
    }

    /// The comments of all lines of a block, where each begins with `;` outside a text.
    pub fn comments_of_lines(&mut self, text: &[u8]) {
        let mut at = 0;
        for line in text.split_inclusive(|b| *b == b'\n') {
            let mut quoted = false;
            let mark = line.iter().position(|b| {
                quoted ^= *b == b'"';
                *b == b';' && !quoted
            });
            if let Some(mark) = mark {
                let end = line.trim_ascii_end().len().max(mark + 1);
                self.comments.push(Span { start: (at + mark + 1) as u32, end: (at + end) as u32 });
            }
            at += line.len();
        }
    }
}
