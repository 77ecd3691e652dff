//! What a target is made of: its words, their forms, its limits. Here stand the table and what holds for its text.
//!
//! `None` stands where the target has no word: what needs it is refused, never said in another way that is not exact.

use std::borrow::Cow;

use super::dialog_words::Dialog;
use super::function_words::{CoolantWords, Dwell, Flow, MFunctions, SpindleWords, ToolWords};
use super::move_words::{Arcs, CompensationWords, FeedWords, Lead, Motion, PathWords, Thread};
use super::tilt_words::TiltWords;

/// A receiver of plain G-code.
#[derive(Debug)]
pub struct Target {
    /// Name in `--target`, in the configuration and in the head of the output.
    pub name: &'static str,
    /// The receiver in a few words.
    pub about: &'static str,
    /// Extension of output files, without its first point.
    pub extension: &'static str,
    /// How blocks are made.
    pub form: Form,
    /// What stands around a program, and the modes at its start.
    pub frame: Frame,
    /// How a comment looks.
    pub comments: Comments,
    /// What one line may hold.
    pub line: Line,
    /// How numbers are written.
    pub numbers: Numbers,
    /// Letters of the axes that it moves; a move of another one is refused.
    pub axes: &'static str,
    /// Lines, planes, threads, taps, coordinates of the machine.
    pub motion: Motion,
    /// Feeds and their kinds.
    pub feed: FeedWords,
    /// Words and limits of arcs.
    pub arcs: Arcs,
    /// Spindles and their speeds.
    pub spindle: SpindleWords,
    /// Coolant on and off.
    pub coolant: CoolantWords,
    /// Tools, their change and their length.
    pub tool: ToolWords,
    /// How it waits.
    pub dwell: Dwell,
    /// Stops, and the end of a program.
    pub flow: Flow,
    /// Work offsets in order, from G54 on; empty where there are none.
    pub offsets: &'static [&'static str],
    /// Those after them, by a number; `None` where there are no more.
    pub more_offsets: Option<MoreOffsets>,
    /// So many have the names that a program uses. Those after them are counted on under other names, and which one is
    /// printed is told.
    pub offsets_named: u8,
    /// It is confirmed that the receiver knows them.
    pub offsets_confirmed: bool,
    /// Radius compensation; `None` leaves it to the compiler, or to a refusal.
    pub compensation: Option<CompensationWords>,
    /// How corners are taken.
    pub path: PathWords,
    /// Tilted working planes.
    pub tilt: Option<TiltWords>,
    /// M functions, those of spindle, coolant and stops among them.
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

    /// The word of a work offset, counted from 1; `None` where the target has none of this number.
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

/// Work offsets by a number after a word: `G54.1 P1`.
#[derive(Debug, Clone, Copy)]
pub struct MoreOffsets {
    /// The word that the number follows without a blank.
    pub word: &'static str,
    /// By how much the number is less than that of the offset, counted from 1.
    pub less: u8,
    /// The last offset, counted from 1.
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
    /// First line of the file; `None` for none.
    pub first: Option<&'static str>,
    /// Last line of the file; `None` for none.
    pub last: Option<&'static str>,
    /// By what the receiver knows a program, after the first line.
    pub name: ProgramName,
    /// Blocks of modes that hold on every machine, for a program in millimetres.
    pub head: &'static [&'static str],
    /// The same for a program in inches; `None` where the target knows no inches.
    pub inch_head: Option<&'static [&'static str]>,
    /// Block of modes on a mill, empty for none; `None` where the target is for lathes alone.
    pub mill: Option<&'static str>,
    /// Block of modes on a lathe, with X as a radius; `None` where the target cannot say so.
    pub lathe: Option<&'static str>,
    /// Block of modes on a lathe, with X as a diameter; `None` where the target cannot say so.
    pub lathe_diameter: Option<&'static str>,
}

/// The line that names a program.
#[derive(Debug, Clone, Copy)]
pub enum ProgramName {
    /// There is no such line.
    None,
    /// `O0001`: `letter` and a number of at least `digits` digits, from 1 to `most`.
    Number { letter: u8, digits: usize, most: u32 },
    /// `front`, and at most `most` capitals, digits and `marks` of the name of the source. What is none of them becomes
    /// the first mark, or nothing.
    Text { front: &'static str, most: usize, marks: &'static str },
}

/// How comments look.
#[derive(Debug)]
pub struct Comments {
    /// Begins a comment.
    pub open: &'static str,
    /// Ends it; empty where the end of the line does.
    pub close: &'static str,
    /// Capitals, digits, blanks and `.,=_-` alone; other characters are printed as a point.
    pub upper: bool,
    /// Characters the receiver acts on even inside a comment: printed as a point.
    pub forbidden: &'static [u8],
}

/// Limits of one line.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    /// Most characters of a line, end of line not counted.
    pub length: usize,
    /// Most digits of a number that are read; 0 for any.
    pub digits: u32,
    /// Most digits in front of the point; 0 for any.
    pub whole: u32,
    /// Whether and how blocks have numbers.
    pub sequence: Sequence,
}

/// Numbers of blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sequence {
    /// By this address, up to the largest number, where the configuration wants them.
    Address(u8, u32),
    /// Every line that begins a block has its number, counted from 0.
    Blocks,
    /// A number would mean something else.
    None,
}

/// How numbers are written. Places come in pairs: in millimetres, in inches. The configuration may ask for others, but
/// for those of a lead.
#[derive(Debug, Clone, Copy)]
pub struct Numbers {
    /// A whole length has its point, too: without it, some controls count in their least increment.
    pub point: bool,
    /// So does a whole feed.
    pub feed_point: bool,
    /// The zero in front of a point.
    pub zero: bool,
    /// Places of coordinates and lengths; those in millimetres are those of angles, too.
    pub length: [u8; 2],
    /// Most places of a length that are read.
    pub most: u8,
    /// Of a feed per minute; `None` for the places of lengths.
    pub feed: Option<[u8; 2]>,
    /// Of a feed per revolution; `None` for the places of lengths.
    pub feed_per_revolution: Option<[u8; 2]>,
    /// Of the lead of a thread or tap; `None` for the places of lengths.
    pub lead: Option<[u8; 2]>,
    /// Of a speed; `None` for the places of lengths.
    pub speed: Option<u8>,
    /// Of a wait in seconds, and most that are read; `None` for the places of lengths, of which any are read.
    pub time: Option<u8>,
}
