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
pub fn decimal(text: &[u8]) -> Option<(i64, usize)> {
    let negative = *text.first()? == b'-';
    let from = usize::from(negative || text[0] == b'+');
    if let Some(eight) = text.get(from..).and_then(<[u8]>::first_chunk::<8>)
        && let Some((units, len)) = short(*eight, negative)
    {
        return Some((units, from + len));
    }
    long_or_short(text)
}

/// [`decimal`] behind its sign, where number and the byte behind it are eight bytes at most.
#[inline(always)]
pub fn short(eight: [u8; 8], negative: bool) -> Option<(i64, usize)> {
    const POINT: u8 = b'.' ^ b'0';
    let (values, others) = others(eight);
    let whole = others.trailing_zeros() & !7;
    let sign = usize::from(negative) * 8;
    // Eight digits begin with one, so that they count as a number without a point.
    if values.wrapping_shr(whole) as u8 != POINT {
        let there = (8..=56).contains(&whole);
        return there.then(|| (joined(values << (64 - whole)) * LAST[sign + 1], whole as usize / 8));
    }
    let end = (others & (others - 1)).trailing_zeros() & !7;
    // A digit at least, and the byte behind the last one.
    if end.wrapping_sub(16) > 40 {
        return None;
    }
    // The digits behind the point move up to those in front of it.
    let in_front = (1 << whole) - 1;
    let digits = (values & in_front) | ((values >> 8) & !in_front);
    Some((joined(digits << (72 - end)) * LAST[(sign + (end - whole) as usize / 8) % 16], end as usize / 8))
}

/// What the last digit of a number counts, by the bytes from its point on; of a negative one from eight on.
const LAST: [i64; 16] = {
    let mut table = [0; 16];
    let mut bytes = 1;
    while bytes < 8 {
        table[bytes] = POWERS[PLACES + 1 - bytes] as i64;
        table[bytes + 8] = -table[bytes];
        bytes += 1;
    }
    table
};

/// The values of eight digits, and the high bit of each byte that is none: the lowest of them is true, and the next one too
/// where that byte is a point.
#[inline(always)]
fn others(eight: [u8; 8]) -> (u64, u64) {
    let values = u64::from_le_bytes(eight) ^ 0x3030_3030_3030_3030;
    (values, (values.wrapping_add(0x7676_7676_7676_7676) | values) & 0x8080_8080_8080_8080)
}

/// The number of eight digits, the last one in the highest byte: pairs, fours, all eight.
#[inline(always)]
fn joined(digits: u64) -> i64 {
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let low = (pairs & 0x0000_00FF_0000_00FF).wrapping_mul(0x000F_4240_0000_0064);
    let high = ((pairs >> 16) & 0x0000_00FF_0000_00FF).wrapping_mul(0x0000_2710_0000_0001);
    (low.wrapping_add(high) >> 32) as i64
}

/// [`decimal`] of any length.
#[inline(never)]
fn long_or_short(text: &[u8]) -> Option<(i64, usize)> {
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
    let (values, others) = others(*eight);
    if others == 0 {
        return one_by_one(text, from);
    }
    let digits = (others.trailing_zeros() / 8) as usize;
    if digits == 0 {
        return Some((0, 0));
    }
    Some((joined(values << (64 - 8 * digits)) as u64, digits))
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
