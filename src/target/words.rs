//! What a target is made of: its words, their forms, its limits. Here stand the table and what holds for its text.
//!
//! `None` stands where the target has no word: what needs it is refused, never said in another way that is not exact.

use std::borrow::Cow;

use super::dialog_words::Dialog;
use super::function_words::{CoolantWords, Dwell, Flow, MFunctions, SpindleWords, ToolWords};
use super::move_words::{Arcs, CompensationWords, FeedWords, Lead, Motion, PathWords, Thread};

/// A receiver of plain G-code.
#[derive(Debug)]
pub struct Target {
    /// Name in `--target`, in the configuration and in the head of the output.
    pub name: &'static str,
    /// The receiver in a few words.
    pub about: &'static str,
    /// Extension of output files.
    pub extension: &'static str,
    pub form: Form,
    pub frame: Frame,
    pub comments: Comments,
    pub line: Line,
    pub numbers: Numbers,
    /// Letters of the axes.
    pub axes: &'static str,
    pub motion: Motion,
    pub feed: FeedWords,
    pub arcs: Arcs,
    pub spindle: SpindleWords,
    pub coolant: CoolantWords,
    pub tool: ToolWords,
    pub dwell: Dwell,
    pub flow: Flow,
    /// Work offsets in order, from G54 on.
    pub offsets: &'static [&'static str],
    /// Those behind them.
    pub more_offsets: Option<MoreOffsets>,
    /// Those behind so many are others than the program names, counted on: which one is printed is told.
    pub offsets_named: u8,
    /// That the receiver knows them is confirmed.
    pub offsets_confirmed: bool,
    pub compensation: Option<CompensationWords>,
    pub path: PathWords,
    pub m: MFunctions,
}

impl PartialEq for Target {
    fn eq(&self, other: &Target) -> bool {
        self.name == other.name
    }
}

impl Eq for Target {}

impl Target {
    /// Is the lead of a thread given by the word of the feed, where the feed may count per revolution, too?
    pub fn lead_is_feed(&self) -> bool {
        let by_feed = |thread: &Thread| match thread.lead {
            Lead::Way(address) | Lead::OneAxis(address) | Lead::AlongZ(address) => address == self.feed.address,
        };
        self.feed.per_revolution.is_some() && self.motion.thread.as_ref().is_some_and(by_feed)
    }

    /// The word of a work offset, counted from 1.
    pub fn offset(&self, number: u8) -> Option<Cow<'static, str>> {
        let named = self.offsets.get(usize::from(number).checked_sub(1)?);
        named.map(|word| Cow::Borrowed(*word)).or_else(|| {
            let more = self.more_offsets.filter(|more| number > more.less && number <= more.most)?;
            Some(Cow::Owned(format!("{}{}", more.word, number - more.less)))
        })
    }
}

impl Target {
    /// All work offsets, for people: `G54 to G59, G54.1 P1 to G54.1 P48`; `None` where there are none.
    pub fn offset_range(&self) -> Option<String> {
        let last = self.more_offsets.map_or(self.offsets.len() as u8, |more| more.most);
        let range = |from: u8, to: u8| Some(format!("{} to {}", self.offset(from)?, self.offset(to)?));
        match self.offsets_named {
            0 => range(1, last),
            named if named >= last => range(1, last),
            named => Some(format!("{}, {}", range(1, named)?, range(named + 1, last)?)),
        }
    }
}

/// Work offsets by a number behind a word.
#[derive(Debug, Clone, Copy)]
pub struct MoreOffsets {
    pub word: &'static str,
    /// What the number is less than that of the offset.
    pub less: u8,
    /// The last one, as we count.
    pub most: u8,
}

/// How blocks are made.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// Words of a letter and a number; G functions state modes that hold.
    Words,
    /// A block begins with what it does, names its axes, and ends with how fast.
    Dialog(&'static Dialog),
}

/// What stands around the program, and the modes stated at its start.
#[derive(Debug)]
pub struct Frame {
    pub first: Option<&'static str>,
    pub last: Option<&'static str>,
    /// By what the receiver knows a program, behind the first line.
    pub name: ProgramName,
    /// Modes that hold on every machine, in millimetres and in inches; `None` where the target knows no inches.
    pub head: &'static [&'static str],
    pub inch_head: Option<&'static [&'static str]>,
    pub mill: Option<&'static str>,
    /// On a lathe, with X as a radius.
    pub lathe: Option<&'static str>,
    /// On a lathe, with X as a diameter.
    pub lathe_diameter: Option<&'static str>,
}

/// The line that names a program.
#[derive(Debug, Clone, Copy)]
pub enum ProgramName {
    None,
    /// `O0001`: a letter and at least so many digits, from 1 to `most`.
    Number {
        letter: u8,
        digits: usize,
        most: u32,
    },
    /// At most so many letters, digits and `marks` of the name of the source, with this in front.
    Text {
        front: &'static str,
        most: usize,
        marks: &'static str,
    },
}

/// How comments look.
#[derive(Debug)]
pub struct Comments {
    pub open: &'static str,
    pub close: &'static str,
    /// Capitals, digits, blanks and `.,=_-` alone; other characters are printed as a point.
    pub upper: bool,
    /// Characters the receiver acts on even inside a comment: printed as a point.
    pub forbidden: &'static [u8],
}

/// Limits of one line.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    /// Longest line, end of line not counted.
    pub length: usize,
    /// Most digits of a number that are read; 0 for any.
    pub digits: u32,
    /// Most digits in front of the point; 0 for any.
    pub whole: u32,
    pub sequence: Sequence,
}

/// Numbers of blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sequence {
    /// By this address, up to the largest one, where the configuration wants them.
    Address(u8, u32),
    /// Every line that begins a block has its number, counted from 0.
    Blocks,
    /// A number would mean something else.
    None,
}

/// How numbers are written. Places come in pairs: in millimetres, in inches.
#[derive(Debug, Clone, Copy)]
pub struct Numbers {
    /// A whole length has its point, too: without it, some controls count in their least increment.
    pub point: bool,
    /// So does a whole feed.
    pub feed_point: bool,
    /// The zero in front of a point.
    pub zero: bool,
    pub length: [u8; 2],
    /// Most places of a length that are read.
    pub most: u8,
    /// Where they have no places of their own, these have those of lengths.
    pub feed: Option<[u8; 2]>,
    pub feed_per_revolution: Option<[u8; 2]>,
    pub lead: Option<[u8; 2]>,
    pub speed: Option<u8>,
    /// Most places of a wait that are read, too.
    pub time: Option<u8>,
}
