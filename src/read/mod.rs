//! Reads the text of a target: what each line has the machine do.
//!
//! In: lines of RS274 text. Out: acts in the order in which a control carries them out, and the modes that hold. Written
//! from the manuals of the receivers, and shares no code with what prints (`tests/suite/layering.rs`), so that the one can
//! be the proof of the other. Numbers are whole counts of 1e-9 mm throughout. A word that is not known is a fault; nothing
//! is passed over, and a mode that nobody stated is not assumed.

#![cfg_attr(not(test), warn(clippy::wildcard_enum_match_arm))]

mod act;
mod block;
mod dialog;
mod number;
mod rules;
mod run;
mod straight;
mod tap;
mod tilt;

pub use act::{AXES, Act, Arc, Cutter, FeedKind, Move, Path, PathControl, Plane, Speed, Tap, Tilting, Way};
pub use number::SCALE;
pub use rules::Rules;
pub use straight::Straight;
pub use tilt::{Angles, Choice, Tilt};

use act::Turning;
use block::Block;
use dialog::Dialog;
use rules::Words;

/// Lines in which a program has its name.
const NAMED: u64 = 2;
/// Letters of the name of an Okuma program, O included.
const LONGEST_NAME: usize = 5;
/// Most acts of one line.
const ACTS: usize = 16;

/// Why a line cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    pub why: String,
    /// What a line in front of it had to say, and did not.
    pub lacks: Option<Lack>,
}

/// What nobody has said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lack {
    /// Where an axis stands.
    Place(usize),
    Unit,
    Mode,
}

impl Fault {
    #[cold]
    fn new(why: impl Into<String>) -> Fault {
        Fault { why: why.into(), lacks: None }
    }

    /// Nobody said what the line counts on.
    #[cold]
    fn unsaid(why: &str, lacks: Lack) -> Fault {
        Fault { why: why.to_owned(), lacks: Some(lacks) }
    }
}

/// The modes of a control, `None` where no line has stated one yet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Modes {
    pub plane: Option<Plane>,
    pub inches: Option<bool>,
    pub incremental: Option<bool>,
    /// Centres of arcs count from the zero point (G90.1), not from the start (G91.1).
    pub absolute_centers: Option<bool>,
    pub feed_kind: Option<FeedKind>,
    /// X words are diameters; where nobody said it, they are not.
    pub diameter: Option<bool>,
    /// No drilling cycle of the control is on.
    pub cycles_are_off: bool,
    /// Each S is a cutting speed; not known before a G96 or G97.
    pub constant_cut: Option<bool>,
    pub cutter: Option<Cutter>,
    /// Number of the tool whose length counts; 0 for none.
    pub length: Option<u32>,
    /// Work offset, from 1 on.
    pub offset: u8,
    /// How corners are taken.
    pub corners: Option<PathControl>,
    /// Positions count in a tilted plane.
    pub tilted: bool,
    /// Where the zero point is shifted to.
    pub shift: [i64; 3],
    /// The move that axis words mean by themselves: 0 to 3, 33, and those of taps.
    motion: Option<u8>,
}

/// What stands behind a closing `%`.
const BEHIND_PERCENT: &str = "something stands after the `%` that closes the program";

/// Where a program stands between its two lines of `%`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tape {
    /// Nothing but blank lines was read.
    Start,
    Open,
    Closed,
    /// It begins without `%`.
    Bare,
}

/// A control that reads.
#[derive(Debug, Clone)]
pub struct Reader {
    rules: Rules,
    at: [i64; AXES],
    /// A bit for each axis whose place is known.
    known: u16,
    feed: Option<i64>,
    modes: Modes,
    /// Positions are absolute, in mm, and as they are written; the program goes on.
    plain: bool,
    lines: u64,
    ended: bool,
    tape: Tape,
    /// The largest speed that was stated for constant cutting speeds.
    speed_limit: Option<i64>,
    dialog: Dialog,
    /// The tool that T chose, and the one in the spindle.
    tools: [Option<u32>; 2],
    spindle: Turning,
    /// The last tap.
    tap: Tap,
    /// The last tilted plane.
    tilt: Tilt,
    /// It is stated, and the rotary axes did not turn yet.
    turns: bool,
    /// Name of the last swivel record.
    record: Vec<u8>,
    acts: [Act; ACTS],
    /// The acts of the last line that are still to be handed out: from, up to.
    open: (usize, usize),
}

impl Default for Reader {
    fn default() -> Reader {
        Reader::new()
    }
}

impl Reader {
    /// A control of which nothing is known.
    pub fn new() -> Reader {
        Reader::with(rules::RS274)
    }

    /// The same with the rules of a receiver.
    pub fn with(rules: Rules) -> Reader {
        let fixed = rules.fixes();
        Reader {
            rules,
            at: [0; AXES],
            known: 0,
            feed: None,
            modes: Modes {
                plane: None,
                inches: None,
                incremental: fixed.absolute.then_some(false),
                absolute_centers: fixed.centers.then_some(false),
                feed_kind: fixed.per_minute.then_some(FeedKind::PerMinute),
                diameter: rules.diameters.then_some(true),
                cycles_are_off: fixed.no_cycles,
                constant_cut: None,
                cutter: fixed.no_cutter.then_some(Cutter::default()),
                length: fixed.no_length.then_some(0),
                offset: 1,
                corners: None,
                tilted: false,
                shift: [0; 3],
                motion: None,
            },
            plain: false,
            lines: 0,
            ended: false,
            tape: Tape::Start,
            speed_limit: None,
            dialog: Dialog::default(),
            tools: [None; 2],
            spindle: Turning::default(),
            tap: Tap::default(),
            tilt: Tilt::default(),
            turns: false,
            record: Vec::new(),
            acts: [Act::Change; ACTS],
            open: (0, 0),
        }
    }

    /// A control as LinuxCNC switches on: XY plane, absolute positions, centres from the start of the arc, feed a minute,
    /// nothing compensated. Millimetres or inches it takes from its own settings, so that a program has to say them.
    pub fn at_power_on() -> Reader {
        Reader::switched_on(rules::RS274)
    }

    /// The same for a receiver.
    pub fn switched_on(rules: Rules) -> Reader {
        let mut reader = Reader::with(rules);
        reader.modes = Modes {
            plane: Some(Plane::Xy),
            incremental: Some(false),
            absolute_centers: Some(false),
            feed_kind: Some(FeedKind::PerMinute),
            diameter: Some(rules.diameters),
            cycles_are_off: true,
            constant_cut: Some(false),
            cutter: Some(Cutter::default()),
            length: Some(0),
            ..reader.modes
        };
        reader
    }

    /// What the next lines of `text` up to `end` do; lines that only set modes are read on the way. `text` shrinks by
    /// what is read. `None` at its end. Bytes behind `end` mean nothing, and let numbers be read in one piece.
    ///
    /// # Errors
    /// What cannot be read; the reader is of no use afterwards.
    pub fn next(&mut self, text: &mut &[u8], end: &mut usize) -> Result<Option<Act>, Fault> {
        if let Some(Straight { cuts, axes, len }) = self.straight(text, *end) {
            *text = &text[len..];
            *end -= len;
            let path = if cuts { Path::Line } else { Path::Rapid };
            return Ok(Some(Act::Move(Move { path, axes, machine: false })));
        }
        self.next_by_words(text, end)
    }

    /// [`Reader::next`] for any line.
    fn next_by_words(&mut self, text: &mut &[u8], end: &mut usize) -> Result<Option<Act>, Fault> {
        loop {
            if self.open.0 < self.open.1 {
                self.open.0 += 1;
                return Ok(Some(self.acts[self.open.0 - 1]));
            }
            if *end == 0 {
                return Ok(None);
            }
            let line = &text[..*end];
            let len = line.iter().position(|b| *b == b'\n').unwrap_or(line.len());
            self.line(&line[..len])?;
            let read = (len + 1).min(*end);
            *text = &text[read..];
            *end -= read;
        }
    }

    /// Reads a line.
    fn line(&mut self, line: &[u8]) -> Result<(), Fault> {
        self.lines += 1;
        self.open = (0, 0);
        let line = line.trim_ascii();
        if self.rules.words == Words::Dialog {
            return self.dialog_line(line);
        }
        if line.is_empty() {
            return Ok(());
        }
        if line == b"%" {
            return self.percent();
        }
        if self.tape == Tape::Closed && !self.ended {
            return Err(Fault::new(BEHIND_PERCENT));
        }
        if self.tape == Tape::Start {
            self.tape = Tape::Bare;
        }
        if self.rules.named && self.lines <= NAMED && line[0] == b'O' {
            let letters = self.rules.words == Words::Okuma && line.len() <= LONGEST_NAME;
            let named = |b: &u8| b.is_ascii_digit() || letters && b.is_ascii_uppercase();
            return if line[1..].iter().all(named) { Ok(()) } else { Err(Fault::new("no program number")) };
        }
        let call = self.rules.swivel(line);
        let block = if call.is_some() { Block::default() } else { Block::read(line, &self.rules)? };
        if self.ended && (call.is_some() || !block.is_empty()) {
            return Err(Fault::new("something stands after the end of the program"));
        }
        match call {
            Some(arguments) => self.swivels(arguments),
            None if block.tilt.is_some() => self.tilts(block),
            None => self.run(block),
        }
    }

    /// A line of a `%` alone: the first one opens the program, the second one ends it, as on a tape (RS274/NGC 3.1; LinuxCNC
    /// User Manual, "Program structure"). Behind the end of the program it means nothing.
    #[cold]
    fn percent(&mut self) -> Result<(), Fault> {
        self.tape = match self.tape {
            Tape::Start => Tape::Open,
            Tape::Open => Tape::Closed,
            tape if self.ended => tape,
            Tape::Bare => return Err(Fault::new("`%` stands inside of the program, which does not begin with one")),
            Tape::Closed => return Err(Fault::new(BEHIND_PERCENT)),
        };
        Ok(())
    }

    /// Has a second `%` ended the program, as the end of a tape does?
    pub fn closed(&self) -> bool {
        self.tape == Tape::Closed
    }

    /// Lines that were read.
    pub fn lines(&self) -> u64 {
        self.lines
    }

    /// Where an axis stands.
    #[inline]
    pub fn place(&self, axis: usize) -> Option<i64> {
        (self.known & (1 << axis) != 0).then_some(self.at[axis])
    }

    /// Where all axes stand, as far as they are known.
    #[inline]
    pub fn at(&self) -> &[i64; AXES] {
        &self.at
    }

    #[inline]
    pub fn known(&self) -> u16 {
        self.known
    }

    #[inline]
    pub fn feed(&self) -> Option<i64> {
        self.feed
    }

    #[inline]
    pub fn modes(&self) -> &Modes {
        &self.modes
    }

    /// The tap of the act that was handed out last.
    pub fn tap(&self) -> &Tap {
        &self.tap
    }

    /// The tilted plane of the act that was handed out last.
    pub fn tilt(&self) -> &Tilt {
        &self.tilt
    }

    /// The swivel record that was named last.
    pub fn record(&self) -> &[u8] {
        &self.record
    }

    /// The speed of the tap after which nothing was said of the spindle.
    pub fn tapped_speed(&self) -> Option<i64> {
        self.spindle.speed.filter(|_| self.spindle.tapped)
    }

    /// Has the program ended?
    pub fn ended(&self) -> bool {
        self.ended
    }

    /// Nobody knows where any axis stands, and the rest of the line means nothing.
    pub fn forget(&mut self) {
        self.known = 0;
        self.open = (0, 0);
    }

    /// Nobody knows where this axis stands.
    pub fn lose(&mut self, axis: usize) {
        self.known &= !(1 << axis);
    }

    /// What the control takes for granted from here on.
    pub fn modes_mut(&mut self) -> &mut Modes {
        &mut self.modes
    }

    /// An axis stands here although no line said so.
    pub fn stand(&mut self, axis: usize, at: i64) {
        self.at[axis] = at;
        self.known |= 1 << axis;
    }
}
