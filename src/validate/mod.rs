//! Translation validation: what was printed, read back, does what was meant.
//!
//! In: the motion items that the printer takes, each with the text that it made of it. Out: the first difference, if there
//! is one. The text is read by `read`, which shares no code with the printer. Nothing is allocated and nothing is kept but
//! the state of the reader, so that every run is checked as it goes on. What a number may differ by is its rounding.

#![cfg_attr(not(test), warn(clippy::wildcard_enum_match_arm))]

mod arcs;
mod functions;
mod moves;
#[cfg(test)]
mod tests;

use std::fmt;

use crate::geo;
use crate::ir::function::CutterData;
use crate::ir::motion::Move;
use crate::ir::{Feed, Function, Origin, Pos};
use crate::machine::settings::ToolChange;
use crate::machine::{MachineKind, Settings};
use crate::read::{Plane, Reader, SCALE};

/// Most of the text of an item that is shown.
const SHOWN: usize = 2000;
/// A nanometre's thousandth is what binary fractions lose of a tie, and the printer counts it as one.
const TIE: f64 = 1.0;
/// What the text of an item may be that is no number: the axes that people may move at a stop.
const MAIN: u16 = 0b111;

/// A difference between what was meant and what was printed.
#[derive(Debug, Clone)]
pub struct Mismatch {
    /// The block that caused it.
    pub origin: Origin,
    /// Line of the output, from 1.
    pub line: u64,
    pub why: String,
    /// What was meant.
    pub meant: String,
    /// What was printed for it.
    pub printed: String,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Mismatch { line, why, printed, .. } = self;
        let printed = printed.trim_end().replace('\n', " | ");
        write!(f, "line {line} of the output is not what the program says: {why} (`{printed}`)")
    }
}

/// Why an item and its text do not go together.
#[derive(Debug)]
struct Why(String);

impl Why {
    #[cold]
    fn new(why: &str) -> Why {
        Why(why.to_owned())
    }
}

impl From<crate::read::Fault> for Why {
    #[cold]
    fn from(fault: crate::read::Fault) -> Why {
        Why(fault.why)
    }
}

/// Text behind which other bytes may stand that mean nothing.
#[derive(Debug, Clone, Copy)]
struct Text<'a> {
    bytes: &'a [u8],
    end: usize,
}

/// Reads what is printed and compares it with what was meant.
#[derive(Debug)]
pub struct Validator {
    reader: Reader,
    /// A unit of the last printed place, and half of it.
    unit: f64,
    half: f64,
    /// Axes that were printed since somebody may have moved them.
    stated: u16,
    /// The last feed, as meant and as read: it needs no second look.
    feed: Option<(Feed, i64)>,
    cutter: CutterData,
    plane: Plane,
    /// X as a diameter or not, where the head has to say it.
    diameter: Option<bool>,
    tool_length: bool,
    by_hand: bool,
    ended: bool,
    /// Nothing is compared any more: there was a difference, or the output is of no use anyway.
    done: bool,
    mismatch: Option<Box<Mismatch>>,
}

impl Validator {
    pub fn new(settings: &Settings) -> Validator {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let output = &settings.output;
        let unit = (SCALE / 10i64.pow(u32::from(output.decimals.min(9)))) as f64;
        Validator {
            reader: Reader::new(),
            unit,
            half: unit / 2.0,
            stated: 0,
            feed: None,
            cutter: CutterData::default(),
            plane: if lathe { Plane::Zx } else { Plane::Xy },
            diameter: (lathe && output.target.frame.lathe_diameter.is_some()).then_some(output.diameter),
            tool_length: output.tool_length,
            by_hand: output.tool_change == ToolChange::Stop,
            ended: false,
            done: false,
            mismatch: None,
        }
    }

    /// The first difference that was found.
    pub fn into_mismatch(self) -> Option<Box<Mismatch>> {
        self.mismatch
    }

    /// Was something found, or is nothing looked for any more?
    pub fn is_done(&self) -> bool {
        self.done
    }

    /// The output is of no use: its program has errors.
    #[cold]
    pub fn give_up(&mut self) {
        self.done = true;
    }

    /// The text in front of the first item: it has to state all modes.
    pub fn head(&mut self, bytes: &[u8], end: usize) {
        let text = Text { bytes, end };
        let result = self.no_act(text).and_then(|()| self.modes());
        self.judge(result, &"the head", &Origin::default(), text);
    }

    /// `bytes` up to `end` were printed for this move; what stands behind them means nothing.
    #[inline]
    pub fn movement(&mut self, mv: &Move, origin: &Origin, bytes: &[u8], end: usize) {
        if self.done {
            return;
        }
        let text = Text { bytes, end };
        let result = self.check_move(mv, text);
        if result.is_err() {
            self.judge(result, mv, origin, text);
        }
    }

    /// The same for a function.
    pub fn function(&mut self, function: &Function, origin: &Origin, bytes: &[u8], end: usize) {
        if self.done {
            return;
        }
        let text = Text { bytes, end };
        let result = self.check_function(function, text);
        if result.is_ok() {
            return;
        }
        self.judge(result, function, origin, text);
    }

    /// Nobody knows any more where the axes stand.
    pub fn lost(&mut self) {
        self.reader.forget();
        self.stated = 0;
    }

    /// Axes stand here although no move said so.
    pub fn begins_at(&mut self, at: &Pos) {
        for (axis, value) in at.iter() {
            // The printer counts from where this place would be printed.
            let units = libm::round(value * SCALE as f64 / self.unit) * self.unit;
            self.reader.stand(axis.index(), units as i64);
            self.stated &= !(1 << axis.index());
        }
    }

    /// The text behind the last item.
    pub fn finish(&mut self, bytes: &[u8], end: usize) {
        if self.done {
            return;
        }
        let text = Text { bytes, end };
        let result = if self.ended { self.no_act(text) } else { self.ends(false, text) };
        let result =
            result.and_then(|()| if self.reader.ended() { Ok(()) } else { Err(Why::new("the program does not end")) });
        self.judge(result, &"the end", &Origin::default(), text);
    }

    #[cold]
    fn judge(&mut self, result: Result<(), Why>, meant: &dyn fmt::Debug, origin: &Origin, text: Text<'_>) {
        let Err(Why(why)) = result else { return };
        self.done = true;
        let printed = String::from_utf8_lossy(&text.bytes[..text.end.min(SHOWN)]).into_owned();
        let line = self.reader.lines();
        let meant = format!("{meant:?}");
        self.mismatch = Some(Box::new(Mismatch { origin: *origin, line, why, meant, printed }));
    }

    /// All modes as the head has to state them.
    fn modes(&self) -> Result<(), Why> {
        let modes = self.reader.modes();
        let stated = modes.inches == Some(false)
            && modes.incremental == Some(false)
            && modes.absolute_centers == Some(false)
            && modes.feed_kind == Some(crate::read::FeedKind::PerMinute)
            && modes.cutter.is_some_and(|cutter| cutter.side == 0)
            && modes.length == Some(0)
            && modes.plane == Some(self.plane)
            && modes.cycles_are_off
            && modes.diameter == self.diameter;
        if stated { Ok(()) } else { Err(Why::new("the head does not state the modes that the moves need")) }
    }

    /// Is `read` what is printed for `meant`: its rounding, ties away from zero?
    #[inline(always)]
    fn is_rounding(&self, read: i64, meant: f64) -> bool {
        (read as f64 - meant * SCALE as f64).abs() <= self.half - TIE || self.is_tie(read, meant)
    }

    /// The same beside a tie.
    #[cold]
    #[inline(never)]
    fn is_tie(&self, read: i64, meant: f64) -> bool {
        let exact = meant * SCALE as f64;
        let away = (read as f64 - exact) * 1f64.copysign(meant);
        let slack = 0.01 + exact.abs() * 1e-15;
        away <= self.half + TIE + slack && away >= TIE - self.half - slack
    }
}

/// The plane as the reader calls it.
fn plane(plane: geo::Plane) -> Plane {
    match plane {
        geo::Plane::Xy => Plane::Xy,
        geo::Plane::Zx => Plane::Zx,
        geo::Plane::Yz => Plane::Yz,
    }
}
