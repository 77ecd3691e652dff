//! The words of a line, before anything happens.

use super::Fault;
use super::act::{Cutter, FeedKind, Plane};
use super::number::{SCALE, decimal};
use super::rules::{G, Rules, TiltWord, Words};

/// Moves of taps among the numbers of [`Modes::motion`](super::Modes).
pub(super) const TAP_RETURN: u8 = 133;
pub(super) const TAP_CYCLE: u8 = 84;
pub(super) const TAP_LEFT_CYCLE: u8 = 74;
pub(super) const TAP_INTO: u8 = 131;
const TAP_OUT: u8 = 132;

/// Is this a move of a tap?
pub(super) fn is_tap(motion: Option<u8>) -> bool {
    matches!(motion, Some(TAP_RETURN | TAP_CYCLE | TAP_LEFT_CYCLE | TAP_INTO | TAP_OUT))
}

/// M functions of a line.
const MOST_M: usize = 4;

/// The words of one line: numbers as they stand, modes as they are asked for.
#[derive(Debug, Clone, Default)]
pub(super) struct Block {
    /// A bit for each letter that has a number; [`SPINDLE`] behind them.
    letters: u32,
    numbers: [i64; 27],
    pub motion: Option<u8>,
    pub stop_motion: bool,
    pub machine: bool,
    pub dwell: bool,
    /// Whole turns beside the one that leads to the end of the arc.
    pub more_turns: Option<u32>,
    pub plane: Option<Plane>,
    pub inches: Option<bool>,
    pub diameter: Option<bool>,
    pub incremental: Option<bool>,
    pub absolute_centers: Option<bool>,
    pub feed_kind: Option<FeedKind>,
    pub constant_cut: Option<bool>,
    /// S is the largest speed.
    pub speed_limit: bool,
    /// The side, and that D is a diameter.
    pub side: Option<(i8, bool)>,
    /// G43, or G49.
    pub length: Option<bool>,
    pub offset: Option<u8>,
    /// A word of a tilted plane.
    pub tilt: Option<TiltWord>,
    /// This letter has the number of the work offset, counted on from so many.
    pub offset_by_number: Option<(u8, u8)>,
    /// Where a cycle returns to.
    pub level: bool,
    /// The angle at which the spindle stops, in a word of its own.
    pub orient: Option<i64>,
    /// The word for how corners are taken, and the length of a name of its own: whether it is that of a bound.
    pub corners: Option<CornerWord>,
    pub corner_length: Option<(bool, i64)>,
    m: [u32; MOST_M],
    m_count: usize,
    /// Groups of G functions that were met, a bit each: two of one group contradict each other.
    groups: u32,
}

/// What a word says of corners.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CornerWord {
    Exact,
    /// G64: with a bound where one is given.
    Continuous,
    /// G641 and its ADIS.
    Before,
    /// G642 and its CTOL.
    Within,
}

/// Bit and place of `$`.
const SPINDLE: u8 = 26;

impl Block {
    /// The words of a line.
    ///
    /// # Errors
    /// What is no word of a plain program.
    pub fn read(line: &[u8], rules: &Rules) -> Result<Block, Fault> {
        let mut block = Block::default();
        let mut rest = line;
        if let [b'/', ..] = rest {
            return Err(Fault::new("whether a block with `/` runs is decided at the machine"));
        }
        while let Some(letter) = rest.first() {
            match letter.to_ascii_uppercase() {
                b' ' | b'\t' => rest = &rest[1..],
                b';' => break,
                b'(' if !matches!(rules.words, Words::Siemens | Words::Command) => rest = comment(rest)?,
                _ if rules.words == Words::Siemens && rest.get(1).is_some_and(u8::is_ascii_alphabetic) => {
                    rest = block.name(rest)?;
                }
                letter @ (b'A'..=b'Z' | b'$') => {
                    let behind = rest[1..].trim_ascii_start();
                    let (units, len) = decimal(behind).ok_or_else(|| no_number(letter, behind))?;
                    block.word(letter, units, rules)?;
                    rest = &behind[len..];
                }
                _ => {
                    let len = rest[1..].iter().take_while(|b| **b & 0xc0 == 0x80).count() + 1;
                    let word = String::from_utf8_lossy(&rest[..len]);
                    return Err(Fault::new(format!("`{}` is no word of a plain program", word.escape_debug())));
                }
            }
        }
        Ok(block)
    }

    /// A word of several letters, and its number behind `=`; what stands behind it.
    fn name<'t>(&mut self, text: &'t [u8]) -> Result<&'t [u8], Fault> {
        let letters = text.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let (name, behind) = text.split_at(letters);
        let unknown = || Fault::new(format!("`{}` is no word that is read", String::from_utf8_lossy(name)));
        match name {
            b"DIAMON" | b"DIAMOF" if self.diameter.is_none() => {
                self.diameter = Some(name == b"DIAMON");
                Ok(behind)
            }
            b"SPOS" if self.orient.is_none() => {
                let number = behind.strip_prefix(b"=").ok_or_else(unknown)?;
                let (units, len) = decimal(number).ok_or_else(unknown)?;
                self.orient = Some(units);
                Ok(&number[len..])
            }
            b"SUPA" if !self.machine => {
                self.machine = true;
                Ok(behind)
            }
            b"ADIS" | b"CTOL" if self.corner_length.is_none() => {
                let number = behind.strip_prefix(b"=").ok_or_else(unknown)?;
                let (units, len) = decimal(number).ok_or_else(unknown)?;
                self.corner_length = Some((name == b"CTOL", units));
                Ok(&number[len..])
            }
            b"TURN" if self.more_turns.is_none() => {
                let number = behind.strip_prefix(b"=").ok_or_else(unknown)?;
                let (units, len) = decimal(number).ok_or_else(unknown)?;
                self.more_turns = Some(whole(b'T', units)?);
                Ok(&number[len..])
            }
            _ => Err(unknown()),
        }
    }

    /// Nothing but comments stood there.
    pub fn is_empty(&self) -> bool {
        self.letters == 0
            && self.groups == 0
            && self.m_count == 0
            && !self.speed_limit
            && self.offset_by_number.is_none()
            && self.diameter.is_none()
            && self.orient.is_none()
            && self.corner_length.is_none()
    }

    fn word(&mut self, letter: u8, units: i64, rules: &Rules) -> Result<(), Fault> {
        if rules.words == Words::Command {
            let first = self.groups == 0 && self.m_count == 0;
            if first != matches!(letter, b'G' | b'M') {
                return Err(Fault::new("a line is one command and its parameters"));
            }
        }
        match letter {
            b'G' => self.g(units, rules),
            b'M' => {
                let number = whole(letter, units)?;
                if m_group(number).is_some_and(|group| self.m().any(|other| m_group(other) == Some(group))) {
                    return Err(Fault::new("two M functions of one group contradict each other"));
                }
                let place = self.m.get_mut(self.m_count).ok_or_else(|| Fault::new("too many M functions"))?;
                *place = number;
                self.m_count += 1;
                Ok(())
            }
            // A block number has no meaning.
            b'N' => Ok(()),
            _ => {
                let bit = if letter == b'$' { SPINDLE } else { letter - b'A' };
                if self.letters & (1 << bit) != 0 {
                    return Err(Fault::new(format!("two {} words", letter as char)));
                }
                self.letters |= 1 << bit;
                self.numbers[usize::from(bit)] = units;
                Ok(())
            }
        }
    }

    /// The number of a letter; it counts as used.
    pub fn take(&mut self, letter: u8) -> Option<i64> {
        let bit = if letter == b'$' { SPINDLE } else { letter - b'A' };
        let there = self.letters & (1 << bit) != 0;
        self.letters &= !(1 << bit);
        there.then(|| self.numbers[usize::from(bit)])
    }

    pub fn has(&self, letter: u8) -> bool {
        self.letters & (1 << (letter - b'A')) != 0
    }

    /// The same as a whole number, not negative.
    pub fn take_whole(&mut self, letter: u8) -> Result<Option<u32>, Fault> {
        self.take(letter).map(|units| whole(letter, units)).transpose()
    }

    /// A letter that nobody used.
    pub fn left(&self) -> Option<char> {
        let bit = self.letters.trailing_zeros() as u8;
        (self.letters != 0).then(|| if bit == SPINDLE { '$' } else { (b'A' + bit) as char })
    }

    /// The line has no function but one.
    pub fn is_single(&self) -> bool {
        let others = self.speed_limit || self.offset_by_number.is_some() || self.diameter.is_some();
        self.groups.is_power_of_two() && self.m_count == 0 && !others
    }

    /// The M functions in the order of the line.
    pub fn m(&self) -> impl Iterator<Item = u32> + use<> {
        self.m.into_iter().take(self.m_count)
    }

    /// A G function; tenths tell some apart.
    fn g(&mut self, units: i64, rules: &Rules) -> Result<(), Fault> {
        let tenths = units / (SCALE / 10);
        let unknown = || Fault::new(format!("G{} is no word that is read", tenths as f64 / 10.0));
        if units < 0 || units % (SCALE / 10) != 0 {
            return Err(unknown());
        }
        let tenths = match rules.function(tenths).ok_or_else(unknown)? {
            G::Rs274(tenths) => tenths,
            G::Offset(number) if self.groups & (1 << OFFSETS) == 0 => {
                self.groups |= 1 << OFFSETS;
                self.offset = Some(number);
                return Ok(());
            }
            G::OffsetByNumber(letter, from) if self.offset_by_number.is_none() => {
                self.offset_by_number = Some((letter, from));
                return Ok(());
            }
            G::Offset(_) | G::OffsetByNumber(..) => return Err(Fault::new("two work offsets")),
            G::Tilt(word) => {
                let fine = self.groups == 0 && self.m_count == 0 && self.tilt.replace(word).is_none();
                self.groups |= 1 << TILTS;
                return if fine { Ok(()) } else { Err(Fault::new("a tilted plane in one line with something else")) };
            }
            G::SpeedLimit => {
                self.speed_limit = true;
                return Ok(());
            }
        };
        let group = self
            .motion_word(tenths)
            .or_else(|| self.word_of_place(tenths))
            .or_else(|| self.word_of_mode(tenths))
            .ok_or_else(unknown)?;
        if self.groups & (1 << group) != 0 {
            return Err(Fault::new("two G functions of one group contradict each other"));
        }
        self.groups |= 1 << group;
        Ok(())
    }

    /// A word that says how the block moves, and its group.
    fn motion_word(&mut self, tenths: i64) -> Option<u8> {
        let group = match tenths {
            0 | 10 | 20 | 30 | 330 => {
                self.motion = Some((tenths / 10) as u8);
                0
            }
            331 | 740 | 840 | 3310 | 3320 => {
                self.motion = Some(match tenths {
                    331 => TAP_RETURN,
                    740 => TAP_LEFT_CYCLE,
                    840 => TAP_CYCLE,
                    3310 => TAP_INTO,
                    _ => TAP_OUT,
                });
                0
            }
            // Behind it the tool stands where the cycle began, at either level.
            990 => {
                self.level = true;
                14
            }
            800 => {
                self.stop_motion = true;
                0
            }
            40 => {
                self.dwell = true;
                1
            }
            _ => return None,
        };
        Some(group)
    }

    /// A word that says from where positions count, or for which tool.
    fn word_of_place(&mut self, tenths: i64) -> Option<u8> {
        let group = match tenths {
            170 | 180 | 190 => {
                self.plane = Some([Plane::Xy, Plane::Zx, Plane::Yz][(tenths / 10 - 17) as usize]);
                3
            }
            400 => {
                self.side = Some((0, false));
                5
            }
            410 | 411 => {
                self.side = Some((1, tenths == 411));
                5
            }
            420 | 421 => {
                self.side = Some((-1, tenths == 421));
                5
            }
            430 | 490 => {
                self.length = Some(tenths == 430);
                6
            }
            530 => {
                self.machine = true;
                7
            }
            540 | 550 | 560 | 570 | 580 | 590..=593 => {
                self.offset = Some((tenths / 10 - 53 + tenths % 10) as u8);
                OFFSETS
            }
            _ => return None,
        };
        Some(group)
    }

    /// A word that says how numbers and feeds are meant, or how corners are taken.
    fn word_of_mode(&mut self, tenths: i64) -> Option<u8> {
        let group = match tenths {
            70 | 80 => {
                self.diameter = Some(tenths == 70);
                2
            }
            200 | 210 => {
                self.inches = Some(tenths == 200);
                4
            }
            600 | 610 | 611 | 640 | 6410 | 6420 => {
                self.corners = Some(match tenths {
                    640 => CornerWord::Continuous,
                    6410 => CornerWord::Before,
                    6420 => CornerWord::Within,
                    _ => CornerWord::Exact,
                });
                9
            }
            900 | 910 => {
                self.incremental = Some(tenths == 910);
                10
            }
            901 | 911 => {
                self.absolute_centers = Some(tenths == 901);
                11
            }
            930 | 940 | 950 => {
                let kinds = [FeedKind::InverseTime, FeedKind::PerMinute, FeedKind::PerRevolution];
                self.feed_kind = Some(kinds[(tenths / 10 - 93) as usize]);
                12
            }
            960 | 970 => {
                self.constant_cut = Some(tenths == 960);
                13
            }
            _ => return None,
        };
        Some(group)
    }

    /// The compensation that the block asks for.
    pub fn cutter(&mut self, rules: &Rules) -> Result<Option<Cutter>, Fault> {
        let Some((side, by_diameter)) = self.side else { return Ok(None) };
        if side == 0 {
            return Ok(Some(Cutter::default()));
        }
        let mut cutter = Cutter { side, ..Cutter::default() };
        if rules.words == Words::Siemens {
            return Ok(Some(cutter));
        }
        if by_diameter {
            cutter.diameter = Some(self.take(b'D').ok_or_else(|| Fault::new("a diameter is missing"))?);
            if let Some(number) = self.take_whole(b'L')? {
                cutter.edge = edge(number).ok_or_else(|| Fault::new("L is an orientation of a tool: 0 to 9"))?;
            }
        } else {
            cutter.tool =
                self.take_whole(b'D')?.ok_or_else(|| Fault::new("the D word of the compensation is missing"))?;
        }
        Ok(Some(cutter))
    }
}

/// Where the edge of a turning tool points to in an orientation of LinuxCNC, along Z and X.
fn edge(orientation: u32) -> Option<[i8; 2]> {
    Some(match orientation {
        0 | 9 => [0, 0],
        1 => [1, -1],
        2 => [-1, -1],
        3 => [-1, 1],
        4 => [1, 1],
        5 => [1, 0],
        6 => [0, -1],
        7 => [-1, 0],
        8 => [0, 1],
        _ => return None,
    })
}

/// The group of work offsets.
const OFFSETS: u8 = 8;
/// That of tilted planes.
const TILTS: u8 = 15;

/// Groups of M functions of which a line has one, as LinuxCNC counts them.
fn m_group(number: u32) -> Option<u8> {
    match number {
        0 | 1 | 2 | 30 | 60 => Some(4),
        6 | 61 => Some(6),
        3..=5 => Some(7),
        7..=9 => Some(8),
        48 | 49 => Some(9),
        _ => None,
    }
}

/// What stands behind a comment. Some comments make a control act.
fn comment(text: &[u8]) -> Result<&[u8], Fault> {
    let close = text.iter().position(|b| *b == b')').ok_or_else(|| Fault::new("a comment without an end"))?;
    let inner = text[1..close].trim_ascii_start();
    if inner.contains(&b'(') {
        return Err(Fault::new("a comment within a comment"));
    }
    let word = inner.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    if inner.get(word) == Some(&b',') && !inner[..word].eq_ignore_ascii_case(b"MSG") {
        const ACTIVE: [&[u8]; 7] = [b"DEBUG", b"PRINT", b"LOG", b"LOGOPEN", b"LOGAPPEND", b"PROBEOPEN", b"ABORT"];
        if ACTIVE.iter().any(|active| active.eq_ignore_ascii_case(&inner[..word])) {
            return Err(Fault::new("a comment that the control acts on"));
        }
    }
    Ok(&text[close + 1..])
}

fn whole(letter: u8, units: i64) -> Result<u32, Fault> {
    let number = u32::try_from(units / SCALE).ok().filter(|_| units % SCALE == 0);
    number.ok_or_else(|| Fault::new(format!("{} wants a whole number", letter as char)))
}

#[cold]
fn no_number(letter: u8, behind: &[u8]) -> Fault {
    let shown = String::from_utf8_lossy(&behind[..behind.len().min(12)]).into_owned();
    Fault::new(format!("`{shown}` after {} is no number", letter as char))
}
