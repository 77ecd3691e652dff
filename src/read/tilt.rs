//! Tilted working planes as each receiver says them: a block with Euler angles and one that turns, a call of a cycle, a
//! dialog behind a shift.

use super::act::{Act, Plane, Tilting};
use super::block::Block;
use super::dialog::{Words as Said, whole};
use super::number::{SCALE, decimal};
use super::rules::TiltWord;
use super::rules::{Rules, Words};
use super::{Fault, Reader};

/// A tilted plane as it is stated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tilt {
    /// Where its zero point lies in the workpiece.
    pub origin: [i64; 3],
    /// Units of degrees, in the order in which they are counted.
    pub angles: [i64; 3],
    /// What they turn about.
    pub about: Angles,
    pub choice: Choice,
}

/// What angles turn about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Angles {
    /// Z, the new X, the new Z.
    #[default]
    Euler,
    /// The fixed axes X, Y and Z.
    Spatial,
}

/// Which of two positions the rotary axes take.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Choice {
    /// There is no word for it.
    #[default]
    Unsaid,
    /// The axis next to the tool gets a positive angle, or a negative one, or whichever the control takes.
    Primary(Option<bool>),
    /// The reference axis gets the greater value, or the smaller one.
    Reference(bool),
}

/// Arguments of CYCLE800.
const ARGUMENTS: usize = 16;
/// Its modes: about Z, the new Y and the new X; about X, the new Y and the new Z.
const ZYX: i64 = 27 * SCALE;
const XYZ: i64 = 57 * SCALE;

impl Reader {
    /// The plane is another one, and so are all positions and the feed of the path.
    fn plane_changes(&mut self, tilting: Tilting) -> Result<(), Fault> {
        self.modes.tilted = tilting == Tilting::Into;
        self.known = 0;
        self.feed = None;
        self.plain = false;
        self.dialog_forgets();
        self.push(Act::Tilt(tilting))
    }

    /// G68.2, G53.1 or G69.
    pub(super) fn tilts(&mut self, mut block: Block) -> Result<(), Fault> {
        let word = block.tilt;
        if !block.is_single() {
            return Err(Fault::new("a tilted plane in one line with something else"));
        }
        if word == Some(TiltWord::Stated) {
            self.plane_is_stated(&mut block)?;
        }
        if let Some(letter) = block.left() {
            return Err(Fault::new(format!("the {letter} word has nothing that it belongs to")));
        }
        match word {
            Some(TiltWord::Turns) if std::mem::take(&mut self.turns) => self.plane_changes(Tilting::Into),
            Some(TiltWord::Turns) => Err(Fault::new("G53.1 without a plane that is stated before it")),
            Some(TiltWord::Off) if self.turns => Err(Fault::new("G69 between G68.2 and G53.1")),
            Some(TiltWord::Off) => self.plane_changes(Tilting::Off),
            Some(TiltWord::Stated) | None => Ok(()),
        }
    }

    /// G68.2 with its zero point and its angles.
    fn plane_is_stated(&mut self, block: &mut Block) -> Result<(), Fault> {
        if self.modes.tilted || self.turns {
            return Err(Fault::new("G68.2 while a plane is on"));
        }
        if self.modes.cutter.is_none_or(|cutter| cutter.side != 0) || self.modes.length != Some(0) {
            return Err(Fault::new("G68.2 under a compensation of the tool"));
        }
        let mode = block.take(b'P');
        if mode != (self.rules.tilts == Some(true)).then_some(0) {
            return Err(Fault::new("which angles G68.2 counts"));
        }
        let mut take = |letters: &[u8; 3]| -> Result<[i64; 3], Fault> {
            let mut numbers = [0; 3];
            for (number, letter) in numbers.iter_mut().zip(letters) {
                *number = block.take(*letter).ok_or_else(|| Fault::new("G68.2 wants X, Y, Z, I, J and K"))?;
            }
            Ok(numbers)
        };
        let (place, angles) = (take(b"XYZ")?, take(b"IJK")?);
        let origin = self.place_of_plane(place)?;
        self.tilt = Tilt { origin, angles, about: Angles::Euler, choice: Choice::Unsaid };
        self.turns = true;
        self.known = 0;
        self.plain = false;
        Ok(())
    }

    fn place_of_plane(&self, numbers: [i64; 3]) -> Result<[i64; 3], Fault> {
        let mut place = [0; 3];
        for (units, number) in place.iter_mut().zip(numbers) {
            *units = self.length(number)?;
        }
        Ok(place)
    }

    /// CYCLE800 with all its arguments, or with none.
    pub(super) fn swivels(&mut self, arguments: &[u8]) -> Result<(), Fault> {
        if arguments.is_empty() {
            return self.plane_changes(Tilting::Off);
        }
        let mut list = [0; ARGUMENTS];
        let mut count = 0;
        for (i, argument) in arguments.split(|b| *b == b',').enumerate() {
            let place = list.get_mut(i).ok_or_else(|| Fault::new("too many arguments of CYCLE800"))?;
            if i == 1 {
                let name = argument.strip_prefix(b"\"").and_then(|rest| rest.strip_suffix(b"\""));
                let name = name.filter(|name| !name.contains(&b'"') && *name != b"0");
                self.record = name.ok_or_else(|| Fault::new("the swivel record of CYCLE800"))?.to_vec();
            } else {
                let number = decimal(argument).filter(|(_, len)| *len == argument.len());
                *place = number.ok_or_else(|| Fault::new("an argument of CYCLE800 is no number"))?.0;
            }
            count = i + 1;
        }
        let [retract, _, state, mode, x, y, z, first, second, third, x1, y1, z1, direction, way, plane] = list;
        let fixed = [retract, state, x1, y1, z1, way] == [0; 6] && plane == SCALE && count == ARGUMENTS;
        if !fixed || direction.abs() != SCALE {
            return Err(Fault::new("a CYCLE800 that is not read"));
        }
        let choice = Choice::Reference(direction > 0);
        self.modes.plane = Some(Plane::Xy);
        if mode == XYZ && [x, y, z, first, second, third] == [0; 6] {
            self.tilt = Tilt { about: Angles::Spatial, choice, ..Tilt::default() };
            return self.plane_changes(Tilting::Back);
        }
        if mode != ZYX {
            return Err(Fault::new("which angles CYCLE800 counts"));
        }
        let origin = self.place_of_plane([x, y, z])?;
        self.tilt = Tilt { origin, angles: [third, second, first], about: Angles::Spatial, choice };
        self.plane_changes(Tilting::Into)
    }

    /// All three axes of a shift are said.
    pub(super) fn plane_shifts(&mut self) -> Result<(), Fault> {
        if self.modes.tilted {
            return Err(Fault::new("a shift in a tilted plane"));
        }
        self.known = 0;
        self.push(Act::Tilt(Tilting::Shifted))
    }

    /// A block that begins with PLANE.
    pub(super) fn plane_block(&mut self, words: &mut Said<'_>) -> Result<(), Fault> {
        let strange = || Fault::new("a PLANE that is not read");
        match words.next() {
            Some(b"RESET") => match words.next() {
                Some(b"STAY") if words.next().is_none() => self.plane_changes(Tilting::Off),
                Some(b"TURN") if words.are("FMAX") => {
                    self.tilt = Tilt { choice: Choice::Primary(None), ..Tilt::default() };
                    self.plane_changes(Tilting::Back)
                }
                _ => Err(strange()),
            },
            Some(b"SPATIAL") if self.modes.tilted => Err(Fault::new("PLANE while another one is on")),
            Some(b"SPATIAL") => {
                let mut angles = [0; 3];
                for (angle, name) in angles.iter_mut().zip([b"SPA", b"SPB", b"SPC"]) {
                    let number = words.next().and_then(|word| word.strip_prefix(name)).ok_or_else(strange)?;
                    *angle = whole(number, number)?;
                }
                if words.next() != Some(b"TURN") || words.next() != Some(b"FMAX") {
                    return Err(Fault::new("how the rotary axes of PLANE turn"));
                }
                let (choice, last) = match words.next() {
                    Some(b"SEQ+") => (Some(true), words.next()),
                    Some(b"SEQ-") => (Some(false), words.next()),
                    other => (None, other),
                };
                // An axis parallel to the tool stays in its place where there is one; the path is the same either way.
                if !(last.is_none() || last == Some(b"COORD") && words.are("ROT")) {
                    return Err(strange());
                }
                let (origin, choice) = (self.modes.shift, Choice::Primary(choice));
                self.tilt = Tilt { origin, angles, about: Angles::Spatial, choice };
                self.plane_changes(Tilting::Into)
            }
            _ => Err(strange()),
        }
    }
}

impl Rules {
    /// The arguments of a line that calls CYCLE800.
    pub(super) fn swivel<'t>(&self, line: &'t [u8]) -> Option<&'t [u8]> {
        if self.words != Words::Siemens {
            return None;
        }
        let number = line.strip_prefix(b"N").unwrap_or_default();
        let digits = number.iter().take_while(|b| b.is_ascii_digit()).count();
        let call = if digits > 0 { number[digits..].trim_ascii_start() } else { line };
        call.strip_prefix(b"CYCLE800(")?.strip_suffix(b")")
    }
}
