//! Translation validation: what was printed, read back, does what was meant.
//!
//! In: the motion items that the printer takes, each with the text that it made of it. Out: the first difference, if there
//! is one. The text is read by `read`, which shares no code with the printer. Nothing is allocated and nothing is kept but
//! the state of the reader, so that every run is checked as it goes on. What a number may differ by is its rounding.

#![cfg_attr(not(test), warn(clippy::wildcard_enum_match_arm))]

mod arcs;
mod functions;
mod moves;
mod taps;
#[cfg(test)]
mod tests;
mod tilt;

use std::fmt;

use crate::geo;
use crate::ir::function::{CutterData, PathControl};
use crate::ir::motion::Move;
use crate::ir::{Feed, Function, Origin, Pos};
use crate::machine::settings::{Quantity, ToolChange, Units};
use crate::machine::{MachineKind, OutputSettings, Settings};
use crate::read::{AXES, Act, Plane, Reader, Rules, SCALE};

/// Most of the text of an item that is shown.
const SHOWN: usize = 2000;
/// A nanometre's thousandth is what binary fractions lose of a tie, and the printer counts it as one.
const TIE: f64 = 1.0;
/// A millionth of a mm in units of the reader.
const MILLIONTH: f64 = 1e-6 * SCALE as f64;
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

/// What was meant for spindle and coolant.
#[derive(Debug, Clone, Copy, Default)]
struct Running {
    speed: Option<f64>,
    /// The M function that started the spindle.
    turn: Option<u32>,
    coolant: bool,
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
    /// That of X: a diameter tells places that lie half a unit apart.
    half_of_x: f64,
    /// What the radii at both ends of a printed arc may differ by.
    most_off: f64,
    /// How far the middle of a line may leave the arc that it stands for.
    chord: f64,
    grain: Grain,
    /// Axes that were printed since somebody may have moved them.
    stated: u16,
    /// The last feed, as meant and as read: it needs no second look.
    feed: Option<(Feed, i64)>,
    cutter: CutterData,
    /// The plane that the head has to state; `None` where an arc says it itself.
    plane: Option<Plane>,
    /// How corners have to be taken, as far as anything was to be said of it.
    corners: Option<PathControl>,
    output: OutputSettings,
    lathe: bool,
    /// A unit of the last place of a printed bound.
    bound_unit: f64,
    /// X as a diameter or not, where the head has to say it.
    diameter: Option<bool>,
    /// Moves say axes that stand, too.
    in_full: bool,
    /// Where the axes stood in front of the move.
    before: [i64; AXES],
    tool_length: bool,
    /// It is stated by the first move along Z, not with the change.
    length_with_move: bool,
    /// The tool whose length the next move along Z has to state.
    length: Option<u32>,
    tilts: tilt::Expected,
    by_hand: bool,
    /// What stands around a comment.
    brackets: (&'static str, &'static str),
    /// The speed stands in the block that starts the spindle.
    with_start: bool,
    /// A program before may have left a constant cutting speed on: the first speed says that it is off.
    states_speed: bool,
    /// The lead of a thread is an F: a feed per revolution stands in front of it.
    lead_is_feed: bool,
    /// No word ends the program: spindle and coolant have to be stopped in front of its end.
    ends_with_text: bool,
    running: Running,
    ended: bool,
    /// Nothing is compared any more: there was a difference, or the output is of no use anyway.
    done: bool,
    mismatch: Option<Box<Mismatch>>,
}

impl Validator {
    pub fn new(settings: &Settings) -> Validator {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let output = &settings.output;
        let grain = Grain::of(output);
        let unit = grain.length;
        Validator {
            reader: Reader::with(
                Rules::of(output.target.name)
                    .in_milliseconds(output.waits_in_milliseconds())
                    .at_rapid(output.rapid_feed),
            ),
            unit,
            half: unit / 2.0,
            half_of_x: if lathe && output.prints_diameters() { unit / 4.0 } else { unit / 2.0 },
            most_off: (arcs::MOST_OFF * unit).min(output.arc_mismatch() * SCALE as f64),
            chord: output.arc_fallback.map_or(0.0, |most| f64::from(most) * MILLIONTH).max(arcs::CHORD * unit),
            grain,
            stated: 0,
            feed: None,
            cutter: CutterData::default(),
            plane: output.target.motion.planes.map(|_| if lathe { Plane::Zx } else { Plane::Xy }),
            corners: output.path_control(None, lathe),
            output: output.clone(),
            lathe,
            bound_unit: grain.bound,
            diameter: (lathe && output.target.frame.lathe_diameter.is_some()).then_some(output.prints_diameters()),
            in_full: !output.modal,
            before: [0; AXES],
            tool_length: output.prints_tool_length(),
            length_with_move: output.tool_length_waits(),
            length: None,
            tilts: tilt::Expected::of(&settings.machine),
            brackets: (output.target.comments.open, output.target.comments.close),
            by_hand: output.tool_change == ToolChange::Stop,
            with_start: output.target.spindle.speed_with_start,
            states_speed: lathe && output.target.spindle.cutting_speed.is_some(),
            lead_is_feed: output.target.lead_is_feed(),
            ends_with_text: output.target.flow.end.is_none(),
            running: Running::default(),
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
        let result = self.head_acts(text).and_then(|()| self.modes());
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
            let unit = if axis.is_rotary() { 2.0 * self.grain.angle } else { self.unit };
            let units = libm::round(value * SCALE as f64 / unit) * unit;
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
        let result = result.and_then(|()| {
            if self.ends_with_text || self.reader.ended() { Ok(()) } else { Err(Why::new("the program does not end")) }
        });
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

    /// Nothing happens in the head, but that it says how corners are taken.
    fn head_acts(&mut self, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        while let Some(act) = self.reader.next(&mut rest, &mut end)? {
            if !matches!(act, Act::Corners(_)) {
                return Err(Why::new("something happens in the head"));
            }
        }
        Ok(())
    }

    /// All modes as the head has to state them.
    fn modes(&self) -> Result<(), Why> {
        let modes = self.reader.modes();
        let stated = modes.inches == Some(self.grain.inches)
            && modes.incremental == Some(false)
            && modes.absolute_centers == Some(false)
            && modes.feed_kind == Some(crate::read::FeedKind::PerMinute)
            && modes.cutter.is_some_and(|cutter| cutter.side == 0)
            && modes.length == Some(0)
            && modes.plane == self.plane
            && modes.cycles_are_off
            && modes.diameter == self.diameter
            && self.takes_corners();
        if stated { Ok(()) } else { Err(Why::new("the head does not state the modes that the moves need")) }
    }

    /// Is `read` what is printed for the length `meant`: its rounding, ties away from zero?
    #[inline(always)]
    fn is_rounding(&self, read: i64, meant: f64) -> bool {
        is_rounding(read, meant, self.half)
    }
}

/// Is `read` the rounding of `meant`, where half of the last place is `half`?
#[inline(always)]
fn is_rounding(read: i64, meant: f64, half: f64) -> bool {
    (read as f64 - meant * SCALE as f64).abs() <= half - TIE || is_tie(read, meant, half)
}

/// The same beside a tie.
#[cold]
#[inline(never)]
fn is_tie(read: i64, meant: f64, half: f64) -> bool {
    let exact = meant * SCALE as f64;
    let away = (read as f64 - exact) * 1f64.copysign(meant);
    let slack = 0.01 + exact.abs() * 1e-15;
    away <= half + TIE + slack && away >= TIE - half - slack
}

/// Half of the last place of the printed numbers, in units of the reader; of lengths the whole of it.
#[derive(Debug, Clone, Copy)]
struct Grain {
    inches: bool,
    length: f64,
    bound: f64,
    angle: f64,
    feed: f64,
    feed_per_revolution: f64,
    inverse_time: f64,
    lead: f64,
    speed: f64,
    time: f64,
}

impl Grain {
    fn of(output: &OutputSettings) -> Grain {
        let plain = |quantity| (SCALE / 10i64.pow(u32::from(output.places(quantity)))) as f64;
        let inch = if output.units == Units::Inches { 25.4 } else { 1.0 };
        Grain {
            inches: output.units == Units::Inches,
            length: plain(Quantity::Length) * inch,
            bound: (SCALE / 10i64.pow(u32::from(output.target.numbers.most))) as f64 * inch,
            angle: plain(Quantity::Angle) / 2.0,
            feed: plain(Quantity::Feed) * output.feed_unit() / 2.0,
            feed_per_revolution: plain(Quantity::FeedPerRevolution) * inch / 2.0,
            inverse_time: plain(Quantity::InverseTime) / 2.0,
            lead: plain(Quantity::Lead) * inch / 2.0,
            speed: plain(Quantity::Speed) / 2.0,
            time: plain(Quantity::Time) / 2.0,
        }
    }

    #[inline]
    fn feed(&self, feed: Feed) -> f64 {
        match feed {
            Feed::PerMinute(_) => self.feed,
            Feed::PerRevolution(_) => self.feed_per_revolution,
            Feed::InverseTime(_) => self.inverse_time,
        }
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
