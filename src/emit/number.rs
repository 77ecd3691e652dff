//! Numbers as text: fixed places, trailing zeros cut, no exponent, no minus zero.

/// Values within this distance of a decimal tie count as the tie, in mm: what binary fractions lose of
/// numbers like 0.00005.
const TIE: f64 = 1e-9;

/// Largest coordinate that is printed, in mm or degrees.
const LARGEST: f64 = 1e9;

/// A fixed number of decimal places.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Places(u8);

impl Places {
    /// 0 to 6 places.
    pub fn new(places: u8) -> Places {
        Places(places.min(6))
    }

    /// Units per millimetre.
    #[inline]
    pub fn scale(self) -> f64 {
        const SCALES: [f64; 7] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
        SCALES[self.0 as usize]
    }

    /// `value` in units of the last place, ties away from zero. `None` for what cannot be printed.
    #[inline]
    pub fn units(self, value: f64) -> Option<i64> {
        if value.is_nan() || value.abs() > LARGEST {
            return None;
        }
        let scale = self.scale();
        let scaled = value * scale;
        let half = 0.5 + TIE * scale;
        Some(if scaled < 0.0 { (scaled - half) as i64 } else { (scaled + half) as i64 })
    }

    /// Digits of `units` as it is written.
    #[cold]
    pub fn digits(self, units: i64) -> u32 {
        let (mut units, mut places) = (units.unsigned_abs(), self.0);
        while places > 0 && units % 10 == 0 {
            (units, places) = (units / 10, places - 1);
        }
        units.checked_ilog10().map_or(1, |log| log + 1).max(u32::from(places) + 1)
    }

    /// Appends `address` and `units` as a decimal number, after a blank if `blank`.
    #[inline]
    pub fn write(self, blank: bool, address: u8, units: i64, out: &mut Vec<u8>) {
        // Constant divisors make multiplications of the divisions.
        match self.0 {
            3 => write_fixed::<1_000, 3>(blank, address, units, out),
            4 => write_fixed::<10_000, 4>(blank, address, units, out),
            5 => write_fixed::<100_000, 5>(blank, address, units, out),
            6 => write_fixed::<1_000_000, 6>(blank, address, units, out),
            2 => write_fixed::<100, 2>(blank, address, units, out),
            1 => write_fixed::<10, 1>(blank, address, units, out),
            _ => write_fixed::<1, 0>(blank, address, units, out),
        }
    }
}

/// The numbers from 00 to 99.
const PAIRS: [[u8; 2]; 100] = {
    let mut pairs = [[b'0'; 2]; 100];
    let mut n = 0;
    while n < 100 {
        pairs[n] = [b'0' + n as u8 / 10, b'0' + n as u8 % 10];
        n += 1;
    }
    pairs
};

/// Longest number: blank, address, sign, 20 digits, point; a multiple of 16, which is appended in two steps.
const LONGEST: usize = 32;

/// Blank, address, sign, whole part, fraction without trailing zeros.
#[inline]
fn write_fixed<const POWER: u64, const PLACES: usize>(blank: bool, address: u8, units: i64, out: &mut Vec<u8>) {
    let mut buffer = [b' '; LONGEST];
    let mut at = usize::from(blank);
    let mut put = |byte: u8| {
        buffer[at & (LONGEST - 1)] = byte;
        at += 1;
    };
    put(address);
    if units < 0 {
        put(b'-');
    }
    let magnitude = units.unsigned_abs();
    let (whole, mut fraction) = (magnitude / POWER, magnitude % POWER);
    put_whole(whole, &mut put);
    if fraction != 0 {
        put(b'.');
        // The first digit alone where their number is odd.
        let mut power = POWER;
        if PLACES % 2 == 1 {
            power /= 10;
            put(b'0' + (fraction / power) as u8);
            fraction %= power;
        }
        while fraction != 0 {
            power /= 100;
            let [first, second] = PAIRS[(fraction / power) as usize % 100];
            fraction %= power;
            put(first);
            if fraction != 0 || second != b'0' {
                put(second);
            }
        }
    }
    let length = out.len() + at;
    out.extend_from_slice(&buffer);
    out.truncate(length);
}

/// The digits of `whole` without leading zeros.
#[inline]
fn put_whole(whole: u64, put: &mut impl FnMut(u8)) {
    if whole >= 10_000 {
        put_long(whole / 10_000, put);
        put_pair(whole / 100 % 100, put);
        put_pair(whole % 100, put);
    } else if whole >= 100 {
        put_first(whole / 100, put);
        put_pair(whole % 100, put);
    } else {
        put_first(whole, put);
    }
}

/// One or two digits.
#[inline]
fn put_first(number: u64, put: &mut impl FnMut(u8)) {
    if number >= 10 {
        put_pair(number, put);
    } else {
        put(b'0' + number as u8);
    }
}

#[inline]
fn put_pair(number: u64, put: &mut impl FnMut(u8)) {
    for digit in PAIRS[number as usize % 100] {
        put(digit);
    }
}

#[cold]
fn put_long(number: u64, put: &mut impl FnMut(u8)) {
    if number >= 10 {
        put_long(number / 10, put);
    }
    put(b'0' + (number % 10) as u8);
}

/// Appends a whole number.
#[inline]
pub fn write_whole(mut n: u64, out: &mut Vec<u8>) {
    let mut digits = [0; 20];
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (n % 10) as u8;
        n /= 10;
        if n == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn text(value: f64, places: u8) -> String {
        let places = Places::new(places);
        let mut out = Vec::new();
        places.write(false, b'X', places.units(value).unwrap(), &mut out);
        String::from_utf8(out).unwrap()[1..].to_owned()
    }

    #[test]
    fn forms() {
        assert_eq!(text(0.0, 4), "0");
        assert_eq!(text(-0.00001, 4), "0");
        assert_eq!(text(-0.5, 4), "-0.5");
        assert_eq!(text(12.3400, 4), "12.34");
        assert_eq!(text(100.0, 4), "100");
        assert_eq!(text(0.0001, 4), "0.0001");
        assert_eq!(text(21.650_635, 4), "21.6506");
        // Ties, which binary fractions miss from either side, go away from zero.
        assert_eq!(text(0.00005, 4), "0.0001");
        assert_eq!(text(1.00015, 4), "1.0002");
        assert_eq!(text(-2.00025, 4), "-2.0003");
        assert_eq!(text(1.5, 0), "2");
        assert_eq!(Places::new(4).units(f64::NAN), None);
        assert_eq!(Places::new(4).units(f64::INFINITY), None);
        assert_eq!(Places::new(4).units(1e10), None);
    }

    #[test]
    fn digits_are_those_that_are_written() {
        let digits = |value: f64| Places::new(4).digits(Places::new(4).units(value).unwrap());
        assert_eq!([digits(0.0), digits(0.0001), digits(1234.5678), digits(-12345.6789)], [1, 5, 8, 9]);
        assert_eq!([digits(120_000.0), digits(10_000.5), digits(99_999.0)], [6, 6, 5]);
    }

    #[test]
    fn every_count_of_digits_is_printed() {
        for digits in 0..19 {
            for number in [10i64.pow(digits), 10i64.pow(digits) - 1, 1_234_567_890_123_456_789 / 10i64.pow(18 - digits)]
            {
                for units in [number, -number] {
                    let mut out = Vec::new();
                    Places::new(0).write(true, b'X', units, &mut out);
                    assert_eq!(String::from_utf8(out).unwrap(), format!(" X{units}"));
                }
            }
        }
    }

    proptest! {
        #[test]
        fn printed_is_the_rounded_value(value in -1e6f64..1e6, places in 0u8..=6) {
            let shown: f64 = text(value, places).parse().unwrap();
            let unit = 1.0 / Places::new(places).scale();
            prop_assert!((shown - value).abs() <= unit / 2.0 + 1.1e-9 + value.abs() * 1e-15);
            prop_assert_eq!(text(shown, places), text(value, places));
        }
    }
}
