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

    /// Appends `lead` and `units` as a decimal number.
    #[inline]
    pub fn write(self, lead: &[u8; 2], units: i64, out: &mut Vec<u8>) {
        // Constant divisors make multiplications of the divisions.
        match self.0 {
            3 => write_fixed::<1_000, 3>(lead, units, out),
            4 => write_fixed::<10_000, 4>(lead, units, out),
            5 => write_fixed::<100_000, 5>(lead, units, out),
            6 => write_fixed::<1_000_000, 6>(lead, units, out),
            2 => write_fixed::<100, 2>(lead, units, out),
            1 => write_fixed::<10, 1>(lead, units, out),
            _ => write_fixed::<1, 0>(lead, units, out),
        }
    }
}

/// Longest number with its lead: two bytes, sign, 20 digits, point.
const LONGEST: usize = 24;

/// Fills a buffer from its end: fraction without trailing zeros, whole part, sign, lead.
#[inline]
fn write_fixed<const POWER: u64, const PLACES: usize>(lead: &[u8; 2], units: i64, out: &mut Vec<u8>) {
    let mut buffer = [0u8; LONGEST];
    let mut at = LONGEST;
    let mut put = |byte: u8| {
        at -= 1;
        buffer[at] = byte;
    };
    let magnitude = units.unsigned_abs();
    let (mut whole, mut fraction) = (magnitude / POWER, magnitude % POWER);
    if fraction != 0 {
        let mut significant = false;
        for _ in 0..PLACES {
            let digit = (fraction % 10) as u8;
            fraction /= 10;
            significant |= digit != 0;
            if significant {
                put(b'0' + digit);
            }
        }
        put(b'.');
    }
    loop {
        put(b'0' + (whole % 10) as u8);
        whole /= 10;
        if whole == 0 {
            break;
        }
    }
    if units < 0 {
        put(b'-');
    }
    put(lead[1]);
    put(lead[0]);
    out.extend_from_slice(&buffer[at..]);
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
        places.write(b" X", places.units(value).unwrap(), &mut out);
        String::from_utf8(out).unwrap()[2..].to_owned()
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
