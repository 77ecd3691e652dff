//! The line that most lines are: `G0` or `G1`, axes, a feed. Everything else goes word by word.

use super::Reader;
use super::act::{AXES, LETTERS, Move, Path};
use super::number::decimal;

/// The axis of each letter; [`FEED`] for F, [`OTHER`] for what is neither.
const MEANING: [u8; 256] = {
    let mut table = [OTHER; 256];
    let mut axis = 0;
    while axis < AXES {
        table[LETTERS[axis] as usize] = axis as u8;
        axis += 1;
    }
    table[b'F' as usize] = FEED;
    table
};
const FEED: u8 = AXES as u8;
const OTHER: u8 = u8::MAX;

impl Reader {
    /// The move of the first line of `text`, and the length of the line, where it is a plain one. Otherwise nothing: what
    /// was set then is set again, to the same, by who reads the line word by word.
    #[inline(always)]
    pub(super) fn straight(&mut self, text: &[u8], end: usize) -> Option<(Move, usize)> {
        if !self.plain || end > text.len() || self.ended {
            return None;
        }
        let path = match *text.first_chunk::<3>()? {
            [b'G', b'1', b' '] => Path::Line,
            [b'G', b'0', b' '] => Path::Rapid,
            _ => return None,
        };
        let mut at = 3;
        let mut axes = 0u16;
        loop {
            let word = text.get(at..)?;
            let (units, len) = decimal(word.get(1..)?)?;
            // What stands behind the text changes nothing.
            if at + 1 + len >= end {
                return None;
            }
            match MEANING[usize::from(*word.first()?)] {
                FEED if axes & (1 << FEED) == 0 => {
                    if units < 0 {
                        return None;
                    }
                    self.feed = Some(units);
                    axes |= 1 << FEED;
                }
                axis if axis < FEED && axes & (1 << axis) == 0 => {
                    self.at[usize::from(axis)] = units;
                    axes |= 1 << axis;
                }
                _ => return None,
            }
            at += len + 2;
            match *text.get(at - 1)? {
                b' ' => {}
                b'\n' => break,
                _ => return None,
            }
        }
        let axes = axes & !(1 << FEED);
        if axes == 0 {
            return None;
        }
        self.known |= axes;
        self.modes.motion = Some(u8::from(matches!(path, Path::Line)));
        self.lines += 1;
        Some((Move { path, axes, machine: false }, at))
    }
}
