//! The line that most lines are: `G0` or `G1`, axes, a feed. Everything else goes word by word.

use super::Reader;
use super::act::{AXES, LETTERS};
use super::number::{SCALE, decimal, short};
use super::rules::Words;

/// The place of each letter in the order in which such a line names them: the axes, from 1, and [`FEED`]. 0 for what is
/// neither.
const ORDER: [u8; 256] = {
    let mut table = [0; 256];
    let mut axis = 0;
    while axis < AXES {
        table[LETTERS[axis] as usize] = axis as u8 + 1;
        axis += 1;
    }
    table[b'F' as usize] = FEED;
    table
};
/// The place of F behind the axes.
const FEED: u8 = AXES as u8 + 1;

/// A straight move as a line says it; the reader stands where it ends.
#[derive(Debug, Clone, Copy)]
pub struct Straight {
    /// At the feed, not at rapid traverse.
    pub cuts: bool,
    /// A bit for each axis that the line names.
    pub axes: u16,
    /// Bytes of the line.
    pub len: usize,
}

impl Reader {
    /// The move of the first line of `text`, where it is a plain one. Otherwise nothing: what was set then is set again, to
    /// the same, by who reads the line word by word.
    #[inline(always)]
    pub fn straight(&mut self, text: &[u8], end: usize) -> Option<Straight> {
        if !self.plain || end > text.len() || self.open.0 != self.open.1 {
            return None;
        }
        if self.rules.words == Words::Dialog {
            return self.dialog_straight(text, end);
        }
        let (cuts, word_len) = match *text.first_chunk::<4>()? {
            [b'G', b'1', b' ', _] => (true, 3),
            [b'G', b'0', b' ', _] => (false, 3),
            [b'G', b'0', b'1', b' '] => (true, 4),
            [b'G', b'0', b'0', b' '] => (false, 4),
            _ => return None,
        };
        let mut rest = text.get(word_len..)?;
        let behind_end = text.len() - end;
        let (mut last, mut axes) = (0, 0u16);
        let feed = loop {
            let (letter, units, len) = word(rest)?;
            let behind = *rest.get(len)?;
            rest = &rest[len + 1..];
            // What stands behind the text changes nothing.
            if rest.len() < behind_end {
                return None;
            }
            // Neither twice, nor in another order, nor without a meaning.
            let order = ORDER[usize::from(letter)];
            if order <= last {
                return None;
            }
            last = order;
            match self.at.get_mut(usize::from(order) - 1) {
                Some(place) => {
                    *place = units;
                    axes |= 1 << (order - 1);
                }
                None if behind == b'\n' && units >= 0 => break Some(units),
                None => return None,
            }
            match behind {
                b' ' => {}
                b'\n' => break None,
                _ => return None,
            }
        };
        if axes == 0 {
            return None;
        }
        if let (false, Some(rapid)) = (cuts, self.rules.rapid_feed) {
            if feed != Some(rapid) {
                return None;
            }
            self.feed = None;
        } else if feed.is_some() {
            self.feed = feed;
        }
        self.known |= axes;
        self.modes.motion = Some(u8::from(cuts));
        self.lines += 1;
        Some(Straight { cuts, axes, len: text.len() - rest.len() })
    }
}

impl Reader {
    /// The same of a dialog: the number of the block, `L`, axes with their signs, and how fast.
    fn dialog_straight(&mut self, text: &[u8], end: usize) -> Option<Straight> {
        let (units, len) = short(*text.first_chunk()?, false)?;
        if units != self.dialog_number().checked_mul(SCALE)? {
            return None;
        }
        let mut rest = text.get(len..)?.strip_prefix(b" L ")?;
        let behind_end = text.len() - end;
        let (mut last, mut axes, mut cuts, mut feed) = (0, 0u16, true, None);
        loop {
            let len = match *rest.first_chunk()? {
                [b'X'..=b'Z', b'+' | b'-'] => {
                    let (letter, units, len) = signed_word(rest)?;
                    let order = letter - b'X' + 1;
                    if order <= last {
                        return None;
                    }
                    last = order;
                    self.at[usize::from(order) - 1] = units;
                    axes |= 1 << (order - 1);
                    len
                }
                [b'R', b'0'] => 2,
                [b'F', b'M'] if rest.starts_with(b"FMAX\n") => {
                    cuts = false;
                    4
                }
                [b'F', b'0'..=b'9'] => {
                    let (units, len) = decimal(&rest[1..])?;
                    feed = Some(units);
                    1 + len
                }
                _ => return None,
            };
            let behind = *rest.get(len)?;
            let word = rest[0];
            rest = &rest[len + 1..];
            // What stands behind the text changes nothing.
            if rest.len() < behind_end {
                return None;
            }
            match behind {
                // R0 once, and nothing behind the feed.
                b' ' if word != b'F' && !(word == b'R' && rest.first() == Some(&b'R')) => {
                    if word == b'R' {
                        last = FEED;
                    }
                }
                b'\n' => break,
                _ => return None,
            }
        }
        if axes == 0 {
            return None;
        }
        if feed.is_some() {
            self.feed = feed;
        }
        self.known |= axes;
        self.lines += 1;
        self.dialog_counts();
        Some(Straight { cuts, axes, len: text.len() - rest.len() })
    }
}

/// [`word`] with a sign in front of its number.
#[inline(always)]
fn signed_word(text: &[u8]) -> Option<(u8, i64, usize)> {
    if let Some(word) = text.first_chunk::<10>()
        && let Some(number) = word[2..].first_chunk()
        && let Some((units, len)) = short(*number, word[1] == b'-')
    {
        return Some((word[0], units, 2 + len));
    }
    let (units, len) = decimal(text.get(1..)?)?;
    Some((text[0], units, 1 + len))
}

/// The letter in front, the number behind it, and how many bytes both take.
#[inline(always)]
fn word(text: &[u8]) -> Option<(u8, i64, usize)> {
    if let Some(word) = text.first_chunk::<10>() {
        let minus = word[1] == b'-';
        let number = word[1 + usize::from(minus)..].first_chunk();
        if let Some((units, len)) = number.and_then(|number| short(*number, minus)) {
            return Some((word[0], units, 1 + usize::from(minus) + len));
        }
    }
    let (units, len) = decimal(text.get(1..)?)?;
    Some((text[0], units, 1 + len))
}
