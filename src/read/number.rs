//! Decimal numbers as scaled integers.

/// Units in a millimetre, a degree, a revolution: all numbers are whole counts of them.
pub const SCALE: i64 = 1_000_000_000;
/// Places behind the point that are kept.
const PLACES: usize = 9;
const POWERS: [u64; PLACES + 1] =
    [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000];
/// Largest whole part: nothing on a machine is longer, and sums of two fit.
const MOST: u64 = 4_000_000_000;

/// The number at the start of `text` in units, and how many bytes it takes; what follows it may be anything.
///
/// Digits beyond the ninth place are rounded. `None` where no number stands, or a larger one than is taken.
#[inline(always)]
pub fn decimal(text: &[u8]) -> Option<(i64, usize)> {
    let negative = *text.first()? == b'-';
    let from = usize::from(negative || text[0] == b'+');
    let (whole, digits) = run(text, from)?;
    let mut at = from + digits;
    let mut units = whole * POWERS[PLACES];
    if text.get(at) == Some(&b'.') {
        let (fraction, places) = run(text, at + 1)?;
        if places > PLACES {
            return long(text, from);
        }
        if digits + places == 0 {
            return None;
        }
        units += fraction * POWERS[PLACES - places];
        at += 1 + places;
    } else if digits == 0 {
        return None;
    }
    if whole > MOST {
        return None;
    }
    Some((if negative { -(units as i64) } else { units as i64 }, at))
}

/// The digits of `text` from `from` on: their value, and how many they are. `None` beyond what a word holds.
#[inline(always)]
fn run(text: &[u8], from: usize) -> Option<(u64, usize)> {
    let Some(eight) = text.get(from..).and_then(<[u8]>::first_chunk::<8>) else { return one_by_one(text, from) };
    // A digit becomes its value; the high bit of a byte says that it was none. Only the lowest of these bits counts.
    let values = u64::from_le_bytes(*eight) ^ 0x3030_3030_3030_3030;
    let others = (values.wrapping_add(0x7676_7676_7676_7676) | values) & 0x8080_8080_8080_8080;
    if others == 0 {
        return one_by_one(text, from);
    }
    let digits = (others.trailing_zeros() / 8) as usize;
    if digits == 0 {
        return Some((0, 0));
    }
    // The digits alone, the last one in the highest byte; then pairs, fours, all eight.
    let aligned = values << (64 - 8 * digits);
    let pairs = aligned.wrapping_mul(10).wrapping_add(aligned >> 8);
    let low = (pairs & 0x0000_00FF_0000_00FF).wrapping_mul(0x000F_4240_0000_0064);
    let high = ((pairs >> 16) & 0x0000_00FF_0000_00FF).wrapping_mul(0x0000_2710_0000_0001);
    Some((low.wrapping_add(high) >> 32, digits))
}

/// The same digit by digit.
#[inline(never)]
fn one_by_one(text: &[u8], from: usize) -> Option<(u64, usize)> {
    let digits = text.get(from..)?.iter().take_while(|b| b.is_ascii_digit()).count();
    let mut value = 0u64;
    for b in text[from..from + digits].iter().take(PLACES + 1) {
        value = value * 10 + u64::from(b - b'0');
    }
    // More digits are looked at where they are places.
    (digits <= PLACES + 1 || text.get(from.wrapping_sub(1)) == Some(&b'.')).then_some((value, digits))
}

/// A number of more places than are kept.
#[cold]
fn long(text: &[u8], from: usize) -> Option<(i64, usize)> {
    let point = from + text[from..].iter().position(|b| *b == b'.')?;
    let places = text[point + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    let (units, _) = decimal(&text[..point + 1 + PLACES])?;
    let up = i64::from(text[point + 1 + PLACES] >= b'5');
    let negative = text[0] == b'-';
    Some((if negative { units - up } else { units + up }, point + 1 + places))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Padded, so that eight bytes can be looked at, or not.
    fn both(text: &str) -> Option<(i64, usize)> {
        let bare = decimal(text.as_bytes());
        for behind in [" Y99999999", "\n77777777", "X.5555555555", "-12345678", "\u{7f}99999999"] {
            assert_eq!(decimal(format!("{text}{behind}").as_bytes()), bare, "{text} {behind:?}");
        }
        bare
    }

    #[test]
    fn forms() {
        assert_eq!(both("0"), Some((0, 1)));
        assert_eq!(both("-1.5"), Some((-1_500_000_000, 4)));
        assert_eq!(both("+12"), Some((12_000_000_000, 3)));
        assert_eq!(both(".25"), Some((250_000_000, 3)));
        assert_eq!(both("7."), Some((7_000_000_000, 2)));
        assert_eq!(both("123456789.123456"), Some((123_456_789_123_456_000, 16)));
        assert_eq!(both("0.1234567894"), Some((123_456_789, 12)));
        assert_eq!(both("-0.1234567895999"), Some((-123_456_790, 16)));
        assert_eq!(both("4000000000"), Some((4_000_000_000_000_000_000, 10)));
        assert_eq!(decimal(b""), None);
        for none in ["-", ".", "-.", "X", "4000000001", "99999999999", "--1"] {
            assert_eq!(both(none), None, "{none}");
        }
    }

    proptest! {
        #[test]
        fn every_printed_number_is_read(whole in 0u64..2_000_000_000, fraction in 0u64..1_000_000_000, places in 0usize..=9, minus in any::<bool>()) {
            let fraction = fraction / POWERS[PLACES - places];
            let sign = if minus { "-" } else { "" };
            let text = if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction:0places$}") };
            let units = whole as i64 * SCALE + (fraction * POWERS[PLACES - places]) as i64;
            prop_assert_eq!(both(&text), Some((if minus { -units } else { units }, text.len())));
        }
    }
}
