//! Damages programs the same way in each run.

/// Bytes that mean something in one of the dialects, and some that mean nothing anywhere.
const ODD: &[u8] = b"\0\x1a\r\n ~;\"().,+-*/^%#!$:=@?Q9XFLRIM[]\xff\xc3";

/// Kinds of damage.
pub const KINDS: usize = 9;

/// A small generator of numbers that look random and are the same everywhere.
pub struct Dice(pub u64);

impl Dice {
    pub fn roll(&mut self, sides: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % sides.max(1) as u64) as usize
    }
}

/// Damages `bytes` in the way `kind`.
pub fn damage(bytes: &mut Vec<u8>, kind: usize, dice: &mut Dice) {
    if bytes.is_empty() {
        return;
    }
    let at = dice.roll(bytes.len());
    let mut lines: Vec<Vec<u8>> = bytes.split(|b| *b == b'\n').map(<[u8]>::to_vec).collect();
    let line = dice.roll(lines.len());
    match kind {
        0 => bytes[at] ^= 1 << dice.roll(8),
        1 => bytes[at] = ODD[dice.roll(ODD.len())],
        2 => {
            bytes.remove(at);
        }
        3 => bytes.insert(at, bytes[dice.roll(bytes.len())]),
        4 => {
            lines.remove(line);
            *bytes = lines.join(&b'\n');
        }
        5 => {
            let copy = lines[line].clone();
            lines.insert(dice.roll(lines.len()), copy);
            *bytes = lines.join(&b'\n');
        }
        6 => {
            let other = dice.roll(lines.len());
            lines.swap(line, other);
            *bytes = lines.join(&b'\n');
        }
        7 => {
            // A word of one line into another.
            let mut words: Vec<Vec<u8>> = lines[line].split(|b| *b == b' ').map(<[u8]>::to_vec).collect();
            let donor: Vec<&[u8]> = bytes.split(|b| b.is_ascii_whitespace()).collect();
            let place = dice.roll(words.len());
            words[place] = donor[dice.roll(donor.len())].to_vec();
            lines[line] = words.join(&b' ');
            *bytes = lines.join(&b'\n');
        }
        _ => {
            let ends: &[u8] = [&b"\r\n"[..], b"\r", b"\n\n", b" ~\n"][dice.roll(4)];
            *bytes = lines.join(ends);
        }
    }
}
