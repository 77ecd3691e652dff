//! Numbers as text: fixed places, trailing zeros cut, no exponent, no minus zero.

/// Values within this distance of a decimal tie count as the tie, in mm: what binary fractions lose of
/// numbers like 0.00005.
const TIE: f64 = 1e-9;

/// Largest coordinate that is printed, in mm or degrees.
const LARGEST: f64 = 1e9;

/// A fixed number of decimal places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Places {
    /// 0 to 6.
    count: u8,
    /// A whole number has its point, too.
    point: bool,
    /// The zero in front of a point is written.
    zero: bool,
    /// What is not negative has a sign, too.
    plus: bool,
    /// Units per millimetre.
    scale: f64,
    /// What rounding adds to a number of units.
    half: f64,
}

impl Places {
    /// 0 to 6 places.
    pub fn new(count: u8) -> Places {
        const SCALES: [f64; 7] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
        let count = count.min(6);
        let scale = SCALES[usize::from(count)];
        Places { count, point: false, zero: true, plus: false, scale, half: 0.5 + TIE * scale }
    }

    /// The same places of a length in inches.
    pub fn of_inches(self) -> Places {
        self.of(25.4)
    }

    /// The same places of what counts so many millimetres.
    pub fn of(self, millimetres: f64) -> Places {
        let scale = self.scale / millimetres;
        Places { scale, half: 0.5 + TIE * scale, ..self }
    }

    /// The same places, with the point and the zero in front of it as the target wants them.
    pub fn written(self, point: bool, zero: bool) -> Places {
        Places { point, zero, ..self }
    }

    /// The same places, with a sign in front of every number or of negative ones alone.
    pub fn signed(self, plus: bool) -> Places {
        Places { plus, ..self }
    }

    /// Units per millimetre.
    #[inline]
    pub fn scale(self) -> f64 {
        self.scale
    }

    /// Units of a whole number, in whatever they count.
    #[inline]
    pub fn power(self) -> u64 {
        10u64.pow(u32::from(self.count))
    }

    /// `value` in units of the last place, ties away from zero. `None` for what cannot be printed.
    #[inline(always)]
    pub fn units(self, value: f64) -> Option<i64> {
        let scaled = value * self.scale;
        let rounded = (scaled + self.half.copysign(scaled)) as i64;
        // Nor is what is no number.
        (value.abs() <= LARGEST).then_some(rounded)
    }

    /// Digits of `units` in front of the point.
    #[cold]
    pub fn whole_digits(self, units: i64) -> u32 {
        let whole = units.unsigned_abs() / self.power();
        whole.checked_ilog10().map_or(1, |log| log + 1)
    }

    /// Digits of `units` as it is written.
    #[cold]
    pub fn digits(self, units: i64) -> u32 {
        let (mut units, mut places) = (units.unsigned_abs(), self.count);
        while places > 0 && units % 10 == 0 {
            (units, places) = (units / 10, places - 1);
        }
        units.checked_ilog10().map_or(1, |log| log + 1).max(u32::from(places) + 1)
    }

    /// Writes `address` and `units` as a decimal number, after a blank if `blank`; how many bytes that are.
    #[inline(always)]
    pub fn write(self, blank: bool, address: u8, units: i64, room: &mut Room) -> usize {
        let mut digits = Digits::begin(blank, address, room);
        if units < 0 {
            digits.put(b'-');
        } else if self.plus {
            digits.put(b'+');
        }
        let units = units.unsigned_abs();
        let form = (self.point, self.zero);
        // Constant divisors make multiplications of the divisions.
        match self.count {
            3 => digits.fixed::<1_000, 3>(units, form),
            4 => digits.fixed::<10_000, 4>(units, form),
            5 => digits.fixed::<100_000, 5>(units, form),
            6 => digits.fixed::<1_000_000, 6>(units, form),
            2 => digits.fixed::<100, 2>(units, form),
            1 => digits.fixed::<10, 1>(units, form),
            _ => {
                digits.whole(units);
                if self.point {
                    digits.put(b'.');
                }
            }
        }
        digits.at
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

/// Longest number: blank, address, sign, 20 digits, point; a power of two.
pub const LONGEST: usize = 32;

/// Where a number is written.
pub type Room = [u8; LONGEST];

/// A number under construction.
struct Digits<'a> {
    room: &'a mut Room,
    /// Bytes that are written.
    at: usize,
}

impl<'a> Digits<'a> {
    #[inline(always)]
    fn begin(blank: bool, address: u8, room: &'a mut Room) -> Digits<'a> {
        let mut digits = Digits { room, at: usize::from(blank) };
        digits.room[0] = b' ';
        digits.put(address);
        digits
    }

    #[inline(always)]
    fn put(&mut self, byte: u8) {
        self.room[self.at % LONGEST] = byte;
        self.at += 1;
    }

    /// Two digits of a number under a hundred.
    #[inline(always)]
    fn pair(&mut self, number: u64) {
        let [first, second] = PAIRS[number as usize % 100];
        self.put(first);
        self.put(second);
    }

    /// Whole part, and a fraction of `PLACES` places without its trailing zeros.
    #[inline(always)]
    fn fixed<const POWER: u64, const PLACES: usize>(&mut self, units: u64, (point, zero): (bool, bool)) {
        let (whole, fraction) = (units / POWER, units % POWER);
        if zero || whole != 0 || fraction == 0 {
            self.whole(whole);
        }
        if fraction == 0 {
            if point {
                self.put(b'.');
            }
            return;
        }
        self.put(b'.');
        // An odd place more makes pairs of them; it is zero, and goes with the others.
        let mut rest = if PLACES % 2 == 1 { fraction * 10 } else { fraction };
        let mut power = if PLACES % 2 == 1 { POWER * 10 } else { POWER };
        let mut kept = self.at;
        for _ in 0..PLACES.div_ceil(2) {
            power /= 100;
            let pair = rest / power;
            rest %= power;
            self.pair(pair);
            if pair != 0 {
                kept = self.at - usize::from(pair % 10 == 0);
            }
        }
        self.at = kept;
    }

    /// Digits without leading zeros.
    #[inline(always)]
    fn whole(&mut self, number: u64) {
        if number < 10 {
            self.put(b'0' + number as u8);
        } else if number < 100 {
            self.pair(number);
        } else {
            self.long(number);
        }
    }

    #[inline(never)]
    fn long(&mut self, number: u64) {
        if number < 1_000 {
            self.put(b'0' + (number / 100) as u8);
        } else if number < 10_000 {
            self.pair(number / 100);
        } else {
            self.long(number / 100);
        }
        self.pair(number % 100);
    }
}

/// Writes `address` and a whole number, after a blank if `blank`; how many bytes that are.
pub fn write_whole(blank: bool, address: u8, number: u64, room: &mut Room) -> usize {
    let mut digits = Digits::begin(blank, address, room);
    digits.whole(number);
    digits.at
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn written(places: Places, blank: bool, units: i64) -> String {
        let mut room = [b'?'; LONGEST];
        let len = places.write(blank, b'X', units, &mut room);
        String::from_utf8(room[..len].to_vec()).unwrap()
    }

    fn text(value: f64, places: u8) -> String {
        let places = Places::new(places);
        written(places, false, places.units(value).unwrap())[1..].to_owned()
    }

    #[test]
    fn points_and_zeros_as_the_target_wants_them() {
        let text = |value: f64, places: u8| {
            let places = Places::new(places).written(true, false);
            written(places, false, places.units(value).unwrap())[1..].to_owned()
        };
        for (value, wanted) in [(0.0, "0."), (10.0, "10."), (0.25, ".25"), (-0.5, "-.5"), (-12.0, "-12."), (1.5, "1.5")]
        {
            assert_eq!(text(value, 3), wanted);
        }
        assert_eq!(text(7.0, 0), "7.");
    }

    #[test]
    fn inches_are_rounded_once() {
        let places = Places::new(4).of_inches();
        let text = |value: f64| written(places, false, places.units(value).unwrap())[1..].to_owned();
        for (value, wanted) in [(25.4, "1"), (30.0, "1.1811"), (40.0, "1.5748"), (10.0, "0.3937"), (-1.0, "-0.0394")] {
            assert_eq!(text(value), wanted);
        }
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
                    assert_eq!(written(Places::new(0), true, units), format!(" X{units}"));
                }
            }
        }
    }

    /// The number by the standard library: whole part, point, all places; then the zeros go.
    fn by_the_standard(units: i64, places: u8) -> String {
        let (sign, power) = (if units < 0 { "-" } else { "" }, 10u64.pow(u32::from(places)));
        let (whole, fraction) = (units.unsigned_abs() / power, units.unsigned_abs() % power);
        match fraction {
            0 => format!(" X{sign}{whole}"),
            _ => format!(" X{sign}{whole}.{fraction:0places$}", places = usize::from(places))
                .trim_end_matches('0')
                .to_owned(),
        }
    }

    /// Rounding in so many words.
    fn rounded(value: f64, places: u8) -> Option<i64> {
        if value.is_nan() || value.abs() > LARGEST {
            return None;
        }
        let scale = (0..places).fold(1.0, |scale, _| scale * 10.0);
        let (scaled, half) = (value * scale, 0.5 + TIE * scale);
        Some(if scaled < 0.0 { (scaled - half) as i64 } else { (scaled + half) as i64 })
    }

    #[test]
    fn the_edges_are_rounded_as_said() {
        let edges = [
            0.0,
            1e-9,
            0.5,
            1.5,
            0.00005,
            0.000_049_999_999,
            999.99995,
            9.999_95,
            1e9,
            1e9 + 1e-6,
            1e15,
            1e300,
            f64::MIN_POSITIVE,
        ];
        for value in edges.into_iter().flat_map(|v| [v, -v]).chain([f64::NAN, f64::INFINITY, f64::NEG_INFINITY]) {
            for places in 0..=6 {
                assert_eq!(Places::new(places).units(value), rounded(value, places), "{value} to {places} places");
            }
        }
    }

    proptest! {
        #[test]
        fn written_as_the_standard_library_writes(units in any::<i64>(), shift in 0u32..64, places in 0u8..=6, zeros in 0u32..8) {
            let units = (units >> shift) / 10i64.pow(zeros) * 10i64.pow(zeros);
            prop_assert_eq!(written(Places::new(places), true, units), by_the_standard(units, places));
        }

        #[test]
        fn rounded_as_said(value in prop_oneof![any::<f64>(), -1e4f64..1e4, (-1_000_000i64..1_000_000).prop_map(|n| n as f64 / 2e4)], places in 0u8..=6) {
            prop_assert_eq!(Places::new(places).units(value), rounded(value, places));
        }

        #[test]
        fn printed_is_the_rounded_value(value in -1e6f64..1e6, places in 0u8..=6) {
            let shown: f64 = text(value, places).parse().unwrap();
            let unit = 1.0 / Places::new(places).scale();
            prop_assert!((shown - value).abs() <= unit / 2.0 + 1.1e-9 + value.abs() * 1e-15);
            prop_assert_eq!(text(shown, places), text(value, places));
        }
    }
}
