//! Printed numbers against whole numbers of any size: the nearest decimal, and the same text when it is read again.

use partc::internals::emit::number::{LONGEST, Places};

use crate::damage::Dice;

/// What came of it.
#[derive(Debug, Default)]
pub struct Printed {
    pub numbers: u64,
    pub ties: u64,
    /// The first number that was printed wrong.
    pub wrong: Option<(f64, u8, String)>,
}

/// Prints `count` numbers of all magnitudes, and every tie of `ties` units around 0 at each count of places.
pub fn numbers(count: u64, ties: i64) -> Printed {
    let mut printed = Printed::default();
    let mut dice = Dice(0x5ca1_ab1e);
    for n in 0..count {
        let places = (n % 7) as u8;
        // Even over the magnitudes that a machine has, and over the bits of the fraction.
        let scale = [1e-6, 1e-3, 1.0, 50.0, 1e3, 1e5, 1e6][dice.roll(7)];
        let fraction = dice.roll(1 << 53) as f64 / (1u64 << 53) as f64;
        let value = if dice.roll(2) == 0 { fraction } else { -fraction } * scale;
        printed.look(value, places);
    }
    for places in 0..=6u8 {
        let unit = 10i64.pow(u32::from(places));
        for n in -ties..ties {
            let tie = (2 * n + 1) as f64 / (2 * unit) as f64;
            printed.ties += 1;
            for value in [tie, tie.next_up(), tie.next_down()] {
                printed.look(value, places);
            }
        }
    }
    printed
}

impl Printed {
    fn look(&mut self, value: f64, places: u8) {
        self.numbers += 1;
        let table = Places::new(places);
        let mut room = [0; LONGEST];
        let written = table.units(value).map(|units| table.write(false, b'X', units, &mut room));
        let text = &room[..written.unwrap_or(0)];
        if !is_nearest(value, places, text) && self.wrong.is_none() {
            self.wrong = Some((value, places, String::from_utf8_lossy(text).into_owned()));
        }
    }
}

/// Is `text` the address and the shortest form of a decimal of so many places that is at most half a unit and 1e-9 away,
/// ties away from zero?
fn is_nearest(value: f64, places: u8, text: &[u8]) -> bool {
    let Some((units, canonical)) = read(text, places) else { return false };
    let bits = value.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32;
    let mantissa = i128::from((bits & ((1 << 52) - 1)) | if exponent == 0 { 0 } else { 1 << 52 });
    let mantissa = if value < 0.0 { -mantissa } else { mantissa };
    // value = mantissa / 2^shift
    let shift = 1075 - exponent.max(1);
    if !(0..90).contains(&shift) {
        return canonical && units == 0 && shift >= 90;
    }
    // All in billionths of a millimetre, times 2^shift.
    let billionth = 10i128.pow(9 - u32::from(places));
    let off = ((i128::from(units) * billionth) << shift) - mantissa * 1_000_000_000;
    let half = (billionth << shift) / 2;
    // A tie goes away from zero, and so does what lies a billionth in front of it; binary fractions lose a little of it.
    let away = if mantissa < 0 { -off } else { off };
    let tie = (1i128 << shift) + (1 << shift) / 1000 + ((mantissa.abs() * 1_000_000_000) >> 50);
    canonical && away <= half + tie && away >= tie_floor(half, shift, mantissa)
}

/// How far in front of the number its decimal may be: half a unit less the billionth that counts as a tie.
fn tie_floor(half: i128, shift: i32, mantissa: i128) -> i128 {
    (1i128 << shift) - half - ((1 << shift) / 1000) - ((mantissa.abs() * 1_000_000_000) >> 50)
}

/// Units of the last place, and whether nothing is written that could be left out.
fn read(text: &[u8], places: u8) -> Option<(i64, bool)> {
    let number = std::str::from_utf8(text).ok()?.strip_prefix('X')?;
    let digits = number.strip_prefix('-').unwrap_or(number);
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let plain = |part: &str| part.bytes().all(|b| b.is_ascii_digit());
    if whole.is_empty() || !plain(whole) || !plain(fraction) || fraction.len() > usize::from(places) {
        return None;
    }
    let padded: String = [whole, fraction, &"0".repeat(usize::from(places) - fraction.len())].concat();
    let units: i64 = padded.parse().ok()?;
    let negative = digits.len() < number.len();
    let canonical = (whole == "0" || !whole.starts_with('0'))
        && !fraction.ends_with('0')
        && digits.contains('.') != fraction.is_empty()
        && !(negative && units == 0);
    Some((if negative { -units } else { units }, canonical))
}
