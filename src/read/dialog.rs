//! Klartext as a TNC reads it: each block begins with what it does. Positions are absolute, an arc goes around the centre
//! that CC has stated last, a helix turns by an angle, FMAX holds for its own block.

use core::f64::consts::TAU;

use super::act::{Act, Arc, FeedKind, LETTERS, Move, Path, PathControl, Plane, Speed, Tap};
use super::number::{SCALE, decimal};
use super::{Fault, Lack, Reader};

/// Degrees of a turn in units.
const TURN: i64 = 360 * SCALE;

/// What a dialog keeps besides the modes.
#[derive(Debug, Clone, Default)]
pub(super) struct Dialog {
    /// Number of the next block.
    number: u64,
    /// Name and unit, as the first block has them.
    program: Vec<u8>,
    /// The centre of the arcs, and the plane of its axes.
    center: Option<(Plane, [i64; 2])>,
    speed: Option<i64>,
    /// What the next line has to go on with.
    open: Open,
    /// Nothing but the last block may follow.
    stopped: bool,
    /// Values of the parameters of a tap, in the order of [`TAP`].
    tap: [i64; TAP.len()],
}

/// Parameters of taps: those of 207, then those that 209 has besides.
const TAP: [&[u8]; 9] = [b"Q200", b"Q201", b"Q239", b"Q203", b"Q204", b"Q257", b"Q256", b"Q336", b"Q403"];
/// Those of 207.
const PLAIN: usize = 5;

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Open {
    #[default]
    Nothing,
    /// The second block of a wait.
    Dwell,
    /// The second block of a tolerance.
    Tolerance,
    /// The second line of a preset.
    Preset,
    /// A parameter of a tap, of which so many are left.
    Tap(usize),
    /// The call of a tap.
    Call,
    /// A shift, of which so many axes are said.
    Shift(usize),
}

/// The words of a block that are still to be read.
pub(super) struct Words<'a>(&'a [u8]);

impl<'a> Words<'a> {
    #[inline]
    pub fn next(&mut self) -> Option<&'a [u8]> {
        let text = self.0.trim_ascii_start();
        let len = text.iter().position(|b| *b == b' ').unwrap_or(text.len());
        let (word, rest) = text.split_at(len);
        self.0 = rest;
        (len > 0).then_some(word)
    }

    fn is(&mut self, wanted: &str) -> bool {
        self.next() == Some(wanted.as_bytes())
    }

    /// The rest is these words.
    pub fn are(&mut self, wanted: &str) -> bool {
        wanted.split(' ').all(|word| self.is(word)) && self.next().is_none()
    }
}

/// The words of a path block.
#[derive(Default)]
struct Way {
    /// A bit for each axis, and those of them that count from where the machine stands.
    axes: u16,
    increments: u16,
    numbers: [i64; 3],
    angle: Option<i64>,
    /// Counter-clockwise.
    sense: Option<bool>,
    feed: Option<i64>,
    /// The feed is that of a turn.
    by_turn: bool,
    rapid: bool,
    uncompensated: bool,
    machine: bool,
}

impl Way {
    fn read(words: &mut Words<'_>) -> Result<Way, Fault> {
        let mut way = Way::default();
        while let Some(word) = words.next() {
            let new = match word {
                [letter @ (b'X' | b'Y' | b'Z'), number @ ..] => way.axis(*letter, number, false)?,
                [b'I', letter @ (b'X' | b'Y' | b'Z'), number @ ..] => way.axis(*letter, number, true)?,
                b"FMAX" => !std::mem::replace(&mut way.rapid, true),
                b"R0" => !std::mem::replace(&mut way.uncompensated, true),
                b"M91" => !std::mem::replace(&mut way.machine, true),
                b"DR+" | b"DR-" => way.sense.replace(word[2] == b'+').is_none(),
                [b'F', b'U', number @ ..] => {
                    way.by_turn = true;
                    way.feed.replace(whole(number, word)?).is_none()
                }
                [b'F', number @ ..] => way.feed.replace(whole(number, word)?).is_none(),
                [b'I', b'P', b'A', number @ ..] => way.angle.replace(whole(number, word)?).is_none(),
                _ => return Err(unknown(word)),
            };
            if !new {
                return Err(Fault::new(format!("two words {}", String::from_utf8_lossy(word))));
            }
        }
        Ok(way)
    }

    #[inline]
    fn axis(&mut self, letter: u8, number: &[u8], increment: bool) -> Result<bool, Fault> {
        let axis = usize::from(letter - b'X');
        let new = self.axes & (1 << axis) == 0;
        self.axes |= 1 << axis;
        self.increments |= u16::from(increment) << axis;
        self.numbers[axis] = whole(number, number)?;
        Ok(new)
    }

    /// Only words that this kind of block may have.
    fn has_only(&self, arc: bool, helix: bool) -> Result<(), Fault> {
        let strange = self.increments != 0 && !helix
            || self.angle.is_some() != helix
            || self.sense.is_some() != arc
            || arc && (self.rapid || self.machine || self.uncompensated)
            || self.rapid && self.feed.is_some();
        if strange { Err(Fault::new("a word has nothing that it belongs to, or one is missing")) } else { Ok(()) }
    }
}

impl Reader {
    /// Number of the next block.
    #[inline]
    pub(super) fn dialog_number(&self) -> i64 {
        self.dialog.number as i64
    }

    /// The next block has the next number.
    #[inline]
    pub(super) fn dialog_counts(&mut self) {
        self.dialog.number += 1;
    }

    /// Reads a line of a dialog. Behind it, a straight move may be read in place.
    pub(super) fn dialog_line(&mut self, line: &[u8]) -> Result<(), Fault> {
        self.dialog_block(line)?;
        let Dialog { number, open, stopped, .. } = self.dialog;
        let goes_on = number > 0 && open == Open::Nothing && !stopped && !self.ended;
        let by_minute = self.modes.feed_kind == Some(FeedKind::PerMinute);
        self.plain = goes_on && by_minute && self.modes.inches == Some(false);
        Ok(())
    }

    fn dialog_block(&mut self, line: &[u8]) -> Result<(), Fault> {
        match self.dialog.open {
            Open::Preset => return self.preset(line),
            Open::Tap(left) => return self.tap_parameter(line, left),
            Open::Nothing | Open::Dwell | Open::Tolerance | Open::Call | Open::Shift(_) => {}
        }
        let digits = line.iter().take_while(|b| b.is_ascii_digit()).count();
        let number = line[..digits].iter().fold(0u64, |n, b| n.wrapping_mul(10).wrapping_add(u64::from(b - b'0')));
        if digits == 0 || digits > 18 || number != self.dialog.number {
            return Err(Fault::new(format!("the block should have the number {}", self.dialog.number)));
        }
        let first = self.dialog.number == 0;
        self.dialog.number += 1;
        if self.ended {
            return Err(Fault::new("something stands after the end of the program"));
        }
        let text = line[digits..].trim_ascii_start();
        if let [b';', comment @ ..] = text {
            let goes_on = comment.ends_with(b"~") || first;
            return if goes_on { Err(Fault::new("a comment that goes on, or stands first")) } else { Ok(()) };
        }
        let mut words = Words(text);
        let word = words.next().unwrap_or_default();
        if first != (word == b"BEGIN") {
            return Err(Fault::new("BEGIN PGM is the first block, and no other"));
        }
        if self.dialog.open == Open::Dwell {
            return self.waits(word, &mut words);
        }
        if self.dialog.open == Open::Call {
            return self.calls_tap(word, &mut words);
        }
        if self.dialog.open == Open::Tolerance {
            return self.tolerance(word, &mut words);
        }
        if let Open::Shift(axis) = self.dialog.open {
            return self.shifts(axis, word, &mut words);
        }
        if self.dialog.stopped && word != b"END" {
            return Err(Fault::new("something stands after the end of the program"));
        }
        match word {
            b"L" => self.dialog_line_move(&mut words),
            b"C" => self.dialog_arc(&mut words),
            b"CP" => self.dialog_helix(&mut words),
            b"CC" => self.dialog_center(&mut words),
            b"BEGIN" => self.begins(&mut words),
            b"END" if words.is("PGM") && words.0.trim_ascii() == self.dialog.program => {
                self.ended = true;
                Ok(())
            }
            b"TOOL" => self.tool_block(&mut words),
            b"CYCL" => self.cycle(&mut words),
            b"PLANE" => self.plane_block(&mut words),
            b"STOP" if words.next().is_none() => self.dialog_m(0),
            [b'M', number @ ..] if words.next().is_none() => match (whole(number, word)?, number) {
                (0, _) => Err(Fault::new("M0 stops the spindle and the coolant, too")),
                (units, _) if units > 0 && units % SCALE == 0 => self.dialog_m((units / SCALE) as u32),
                _ => Err(unknown(word)),
            },
            _ => Err(unknown(word)),
        }
    }

    fn begins(&mut self, words: &mut Words<'_>) -> Result<(), Fault> {
        let pgm = words.is("PGM");
        self.dialog.program = words.0.trim_ascii().to_vec();
        let named = words.next().is_some();
        self.modes.inches = match words.next() {
            Some(b"MM") => Some(false),
            Some(b"INCH") => Some(true),
            _ => None,
        };
        let fine = pgm && named && self.modes.inches.is_some() && words.next().is_none();
        if fine { Ok(()) } else { Err(Fault::new("BEGIN PGM wants a name and MM or INCH")) }
    }

    fn dialog_m(&mut self, number: u32) -> Result<(), Fault> {
        self.dialog.stopped = matches!(number, 2 | 30);
        self.push(Act::M { number, spindle: 0, angle: None })
    }

    /// The feed of a block holds on, and what it counts; in inches a minute it counts tenths.
    fn dialog_feed(&mut self, way: &Way) -> Result<(), Fault> {
        let Some(feed) = way.feed else { return Ok(()) };
        if feed < 0 {
            return Err(Fault::new("a feed below zero"));
        }
        self.modes.feed_kind = Some(if way.by_turn { FeedKind::PerRevolution } else { FeedKind::PerMinute });
        let tenths = if self.modes.inches == Some(true) && !way.by_turn { 10 } else { 1 };
        self.feed = Some(self.length(feed)? / tenths);
        Ok(())
    }

    fn dialog_line_move(&mut self, words: &mut Words<'_>) -> Result<(), Fault> {
        let way = Way::read(words)?;
        way.has_only(false, false)?;
        if way.axes == 0 {
            return Err(Fault::new("a line without an axis"));
        }
        self.dialog_feed(&way)?;
        self.goes(&way)?;
        let path = if way.rapid { Path::Rapid } else { Path::Line };
        if way.machine {
            self.known &= !way.axes;
        }
        self.push(Act::Move(Move { path, axes: way.axes, machine: way.machine }))
    }

    /// The axes of a block go to their ends.
    fn goes(&mut self, way: &Way) -> Result<(), Fault> {
        for axis in 0..3 {
            if way.axes & (1 << axis) == 0 {
                continue;
            }
            let mut units = self.length(way.numbers[axis])?;
            if way.increments & (1 << axis) != 0 {
                let before = self.place(axis);
                let before = before.ok_or_else(|| Fault::unsaid("a way from an unknown place", Lack::Place(axis)))?;
                units = before.checked_add(units).ok_or_else(|| Fault::new("a place is too far away"))?;
            }
            self.stand(axis, units);
        }
        Ok(())
    }

    /// CC with two axes makes their plane that of the arcs.
    fn dialog_center(&mut self, words: &mut Words<'_>) -> Result<(), Fault> {
        let way = Way::read(words)?;
        way.has_only(false, false)?;
        let plane = match way.axes {
            0b011 => Plane::Xy,
            0b101 => Plane::Zx,
            0b110 => Plane::Yz,
            _ => return Err(Fault::new("CC wants two axes")),
        };
        if way.rapid || way.machine || way.uncompensated || way.feed.is_some() {
            return Err(Fault::new("CC takes nothing but its axes"));
        }
        let [first, second, _] = plane.axes();
        let center = [self.length(way.numbers[first])?, self.length(way.numbers[second])?];
        self.dialog.center = Some((plane, center));
        Ok(())
    }

    /// The plane of the arcs, their centre, and where the arc begins.
    fn arc_begins(&self) -> Result<(Plane, [i64; 2], [i64; 2]), Fault> {
        let (plane, center) = self.dialog.center.ok_or_else(|| Fault::new("an arc without a centre"))?;
        let [first, second, _] = plane.axes();
        let at =
            |axis| self.place(axis).ok_or_else(|| Fault::unsaid("an arc from an unknown place", Lack::Place(axis)));
        Ok((plane, center, [at(first)?, at(second)?]))
    }

    fn dialog_arc(&mut self, words: &mut Words<'_>) -> Result<(), Fault> {
        let way = Way::read(words)?;
        way.has_only(true, false)?;
        let (plane, center, from) = self.arc_begins()?;
        let [first, second, _] = plane.axes();
        if way.axes != (1 << first) | (1 << second) {
            return Err(Fault::new("C wants both axes of its plane, and no other"));
        }
        self.dialog_feed(&way)?;
        self.goes(&way)?;
        let to = [self.at[first], self.at[second]];
        let turns = if way.sense == Some(true) { 1 } else { -1 };
        let arc = Arc { plane, from, to, center, turns, by_angle: false };
        self.push(Act::Move(Move { path: Path::Arc(arc), axes: way.axes, machine: false }))
    }

    fn dialog_helix(&mut self, words: &mut Words<'_>) -> Result<(), Fault> {
        let way = Way::read(words)?;
        way.has_only(true, true)?;
        let (plane, center, from) = self.arc_begins()?;
        let [first, second, third] = plane.axes();
        let angle = way.angle.unwrap_or(0);
        let sense = if way.sense == Some(true) { 1 } else { -1 };
        if way.axes != 1 << third || way.increments != way.axes || plane != Plane::Xy {
            return Err(Fault::new("CP wants the way along the third axis, and is read in XY alone"));
        }
        if angle.signum() != sense || angle.abs() > 15 * TURN {
            return Err(Fault::new("IPA and DR contradict each other, or it turns too far"));
        }
        self.dialog_feed(&way)?;
        self.goes(&way)?;
        let to = if angle % TURN == 0 { from } else { turned(from, center, angle)? };
        [self.at[first], self.at[second]] = to;
        let turns = ((angle.abs() - 1) / TURN + 1) as i32 * sense as i32;
        let arc = Arc { plane, from, to, center, turns, by_angle: true };
        let axes = way.axes | (1 << first) | (1 << second);
        self.push(Act::Move(Move { path: Path::Arc(arc), axes, machine: false }))
    }

    /// TOOL DEF brings a tool forth, TOOL CALL changes it, states the speed, or both.
    fn tool_block(&mut self, words: &mut Words<'_>) -> Result<(), Fault> {
        let kind = words.next().unwrap_or_default();
        let mut word = words.next();
        let number =
            word.filter(|word| word.iter().all(u8::is_ascii_digit)).map(|word| whole(word, word)).transpose()?;
        let number = number.map(|units| (units / SCALE) as u32);
        if number.is_some() {
            word = words.next();
        }
        if kind == b"DEF" {
            let tool = number.filter(|_| word.is_none()).ok_or_else(|| Fault::new("TOOL DEF wants a number"))?;
            self.tools[0] = Some(tool);
            return self.push(Act::Select(tool));
        }
        if kind != b"CALL" || word != Some(b"Z") {
            return Err(Fault::new("TOOL CALL with another axis"));
        }
        let speed = match words.next() {
            Some([b'S', speed @ ..]) => Some(whole(speed, speed)?),
            Some(other) => return Err(unknown(other)),
            None => None,
        };
        if words.next().is_some() || number.is_none() && speed.is_none() {
            return Err(Fault::new("TOOL CALL says too much, or nothing"));
        }
        // Whether the feed holds on is a matter of the control.
        self.feed = None;
        if let Some(tool) = number {
            self.tools = [Some(tool); 2];
            self.modes.length = Some(tool);
            self.push(Act::Select(tool))?;
            self.push(Act::Change)?;
        }
        let Some(value) = speed else { return Ok(()) };
        // With a tool, the speed that holds is said again.
        if self.dialog.speed.replace(value) == Some(value) && number.is_some() {
            return Ok(());
        }
        self.push(Act::Speed(Speed { spindle: 0, value, constant_cut: None }))
    }

    fn cycle(&mut self, words: &mut Words<'_>) -> Result<(), Fault> {
        let def = words.is("DEF");
        self.dialog.open = match words.next() {
            Some(b"7.0") if def && words.are("DATUM SHIFT") => Open::Shift(0),
            Some(b"9.0") if def && words.are("DWELL TIME") => Open::Dwell,
            Some(b"32.0") if def && words.are("TOLERANCE") => Open::Tolerance,
            Some(b"247") if def && words.are("DATUM SETTING ~") => Open::Preset,
            Some(b"207") if def && words.are("RIGID TAPPING ~") => self.tap_begins(PLAIN),
            Some(b"209") if def && words.are("TAPPING W/ CHIP BRKG ~") => self.tap_begins(TAP.len()),
            _ => return Err(Fault::new("a cycle that is not read")),
        };
        Ok(())
    }

    fn tap_begins(&mut self, parameters: usize) -> Open {
        self.dialog.tap = [0; TAP.len()];
        // Never, out of the hole, anywhere, as fast as in.
        self.dialog.tap[TAP.len() - 1] = SCALE;
        Open::Tap(parameters)
    }

    /// A line `Q200=+2 ;SET-UP CLEARANCE ~`; the last one does not go on.
    fn tap_parameter(&mut self, line: &[u8], left: usize) -> Result<(), Fault> {
        let word = Words(line).next().unwrap_or_default();
        let (name, number) = word.split_at(word.iter().position(|b| *b == b'=').unwrap_or(0));
        let comment = line[word.len()..].trim_ascii();
        let goes_on = left > 1;
        let place = TAP.iter().position(|known| *known == name);
        let place = place.filter(|_| comment.starts_with(b";") && comment.ends_with(b"~") == goes_on);
        let place = place.ok_or_else(|| Fault::new("the parameter of a tap is meant"))?;
        self.dialog.tap[place] = whole(&number[1..], word)?;
        self.dialog.open = if goes_on { Open::Tap(left - 1) } else { Open::Call };
        Ok(())
    }

    /// CYCL CALL: the tap that was defined, at once.
    fn calls_tap(&mut self, word: &[u8], words: &mut Words<'_>) -> Result<(), Fault> {
        self.dialog.open = Open::Nothing;
        if word != b"CYCL" || !words.is("CALL") || words.next().is_some() {
            return Err(Fault::new("the call of the tap is meant"));
        }
        let mut lengths = [0; TAP.len()];
        for (length, value) in lengths.iter_mut().zip(self.dialog.tap) {
            *length = self.length(value)?;
        }
        let [clearance, deep, lead, surface, second, way, ..] = lengths;
        let [.., pitches, angle, factor] = self.dialog.tap;
        let from = self.place(2).ok_or_else(|| Fault::unsaid("a tap from an unknown place", Lack::Place(2)))?;
        let sum = |a: i64, b: i64| a.checked_add(b).ok_or_else(|| Fault::new("a place is too far away"));
        if sum(surface, clearance)? != from || second != clearance || deep >= 0 || lead == 0 || factor <= 0 {
            return Err(Fault::new("a tap that does not begin where the tool stands, or has no depth"));
        }
        let speed = self.dialog.speed.filter(|speed| *speed > 0);
        let speed = Some(speed.ok_or_else(|| Fault::new("a tap without a speed"))?);
        let back = (i128::from(pitches) * i128::from(lead.abs()) / i128::from(SCALE)) as i64;
        let tap = Tap {
            axis: 2,
            from,
            to: sum(surface, deep)?,
            back: from,
            lead: lead.abs(),
            left: lead < 0,
            speed,
            factor,
            dwell: 0,
            angle: Some(angle),
            way: super::Way::Both,
            steps: (way > 0).then_some([surface, way, back]),
        };
        self.feed = None;
        self.push_tap(tap)
    }

    /// CYCL DEF 7.1 to 7.3: the zero point of one axis after the other.
    fn shifts(&mut self, axis: usize, word: &[u8], words: &mut Words<'_>) -> Result<(), Fault> {
        const LINES: [(&str, u8); 3] = [("7.1", b'X'), ("7.2", b'Y'), ("7.3", b'Z')];
        let (line, letter) = LINES[axis];
        let begins = word == b"CYCL" && words.is("DEF") && words.is(line);
        let number = words.next().and_then(|word| word.strip_prefix(&[letter])).unwrap_or_default();
        let units = whole(number, number)?;
        if !begins || words.next().is_some() {
            return Err(Fault::new("the next axis of a shift is meant"));
        }
        self.modes.shift[axis] = self.length(units)?;
        self.dialog.open = if axis + 1 < LINES.len() { Open::Shift(axis + 1) } else { Open::Nothing };
        if self.dialog.open != Open::Nothing {
            return Ok(());
        }
        self.dialog.center = None;
        self.plane_shifts()
    }

    /// The centre of arcs is not known any more.
    pub(super) fn dialog_forgets(&mut self) {
        self.dialog.center = None;
    }

    fn waits(&mut self, word: &[u8], words: &mut Words<'_>) -> Result<(), Fault> {
        self.dialog.open = Open::Nothing;
        let begins = word == b"CYCL" && words.is("DEF") && words.is("9.1") && words.is("DWELL");
        let number = words.next().unwrap_or_default();
        let seconds = whole(number, number)?;
        if !begins || words.next().is_some() || !(0..=3600 * SCALE).contains(&seconds) {
            return Err(Fault::new("the time of a wait is meant"));
        }
        self.push(Act::Dwell(seconds))
    }

    fn tolerance(&mut self, word: &[u8], words: &mut Words<'_>) -> Result<(), Fault> {
        self.dialog.open = Open::Nothing;
        let begins = word == b"CYCL" && words.is("DEF") && words.is("32.1");
        let number = words.next().and_then(|word| word.strip_prefix(b"T")).unwrap_or_default();
        let units = whole(number, number)?;
        if !begins || words.next().is_some() || units <= 0 {
            return Err(Fault::new("the tolerance of the path is meant"));
        }
        let mode = PathControl::Within(self.length(units)?);
        self.modes.corners = Some(mode);
        self.push(Act::Corners(mode))
    }

    fn preset(&mut self, line: &[u8]) -> Result<(), Fault> {
        self.dialog.open = Open::Nothing;
        let word = Words(line).next().unwrap_or_default();
        let number = word.strip_prefix(b"Q339=").unwrap_or_default();
        let comment = line[word.len()..].trim_ascii();
        let units = whole(number, number)?;
        let preset = u8::try_from(units / SCALE).ok().filter(|_| units % SCALE == 0 && units > 0);
        match preset {
            Some(preset) if comment.starts_with(b";") && !comment.ends_with(b"~") => {
                self.modes.offset = preset;
                // The same place has other coordinates now.
                self.known = 0;
                self.dialog.center = None;
                self.push(Act::Offset(preset))
            }
            _ => Err(Fault::new("the number of a preset is meant")),
        }
    }
}

/// `from`, turned about `center` by an angle in units.
fn turned(from: [i64; 2], center: [i64; 2], angle: i64) -> Result<[i64; 2], Fault> {
    let [x, y] = [0, 1].map(|i| (i128::from(from[i]) - i128::from(center[i])) as f64);
    let (sin, cos) = libm::sincos((angle % TURN) as f64 / TURN as f64 * TAU);
    let to = [x * cos - y * sin, x * sin + y * cos];
    let place = |i: usize| center[i].checked_add(libm::round(to[i]) as i64);
    place(0).zip(place(1)).map(|(u, v)| [u, v]).ok_or_else(|| Fault::new("the end of a helix is too far away"))
}

/// A number that fills its word.
#[inline]
pub(super) fn whole(number: &[u8], word: &[u8]) -> Result<i64, Fault> {
    match decimal(number) {
        Some((units, len)) if len == number.len() => Ok(units),
        _ => Err(unknown(word)),
    }
}

#[cold]
fn unknown(word: &[u8]) -> Fault {
    Fault::new(format!("`{}` is no word that is read", String::from_utf8_lossy(&word[..word.len().min(20)])))
}

const _: () = assert!(LETTERS[0] == b'X' && LETTERS[1] == b'Y' && LETTERS[2] == b'Z');
