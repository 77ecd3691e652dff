//! Decimal literals: one place that turns digits into a double, correctly rounded.

/// Powers of ten that a double holds exactly.
const POWERS: [f64; 16] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

/// `0` in each byte.
const ZEROS: u64 = 0x3030_3030_3030_3030;
/// The high bit of each byte.
const HIGH: u64 = 0x8080_8080_8080_8080;

/// Reads an unsigned decimal at the start of `text`: digits with an optional `.` or, if `comma`, `,`.
///
/// Returns the value and the number of bytes read; `None` where no digit stands. A point without a digit
/// after it (`45.`) or before it (`.5`) is fine. The result is the double nearest to the decimal.
#[inline(always)]
pub fn decimal(text: &[u8], comma: bool) -> Option<(f64, usize)> {
    let bytes = first_bytes(text) ^ ZEROS;
    // Bytes that are no digits. Behind a short text stand zero bytes, which are none either.
    let others = others(bytes);
    let whole = others.trailing_zeros() / 8;
    let mark = (bytes.wrapping_shr(8 * whole) as u8) ^ b'0';
    let (digits, count, places, used) = if others == 0 {
        return long_decimal(text, comma);
    } else if mark == b'.' || mark == b',' && comma {
        let next = others & (others - 1);
        if next == 0 {
            return long_decimal(text, comma);
        }
        // The fraction moves onto the point.
        let used = next.trailing_zeros() / 8;
        let low = (1u64 << (8 * whole)) - 1;
        (bytes & low | (bytes >> 8) & !low, used - 1, used - 1 - whole, used)
    } else {
        (bytes, whole, 0, whole)
    };
    if count == 0 {
        return None;
    }
    let mantissa = eight_digits(digits << (64 - 8 * count));
    Some((mantissa as f64 / POWERS[places as usize & 15], used as usize))
}

/// Digits at the start of `text`; `None` where they are more than seven.
#[inline(always)]
pub fn leading_digits(text: &[u8]) -> Option<usize> {
    let others = others(first_bytes(text) ^ ZEROS);
    (others != 0).then_some(others.trailing_zeros() as usize / 8)
}

/// The high bit of each byte that is no digit, of text with the bits of `0` turned.
#[inline(always)]
fn others(bytes: u64) -> u64 {
    ((bytes & !HIGH).wrapping_add(0x7676_7676_7676_7676) | bytes) & HIGH
}

/// The first eight bytes of `text`, the first one lowest; zero bytes behind a shorter one.
#[inline(always)]
fn first_bytes(text: &[u8]) -> u64 {
    if let Some(bytes) = text.first_chunk::<8>() {
        return u64::from_le_bytes(*bytes);
    }
    if let (Some(head), Some(tail)) = (text.first_chunk::<4>(), text.last_chunk::<4>()) {
        // Both hold the bytes in the middle.
        let tail = u64::from(u32::from_le_bytes(*tail)) << (8 * (text.len() - 4));
        return u64::from(u32::from_le_bytes(*head)) | tail;
    }
    text.iter().rev().fold(0, |bytes, byte| bytes << 8 | u64::from(*byte))
}

/// The number of eight digits, the first one in the lowest byte: neighbours are joined to pairs, fours and all.
#[inline(always)]
fn eight_digits(digits: u64) -> u64 {
    let pairs = (digits & 0x0f0f_0f0f_0f0f_0f0f).wrapping_mul(10 * 256 + 1) >> 8;
    let fours = (pairs & 0x00ff_00ff_00ff_00ff).wrapping_mul(100 * 65_536 + 1) >> 16;
    (fours & 0x0000_ffff_0000_ffff).wrapping_mul(10_000 * 4_294_967_296 + 1) >> 32
}

/// The same for any length.
#[inline(never)]
fn long_decimal(text: &[u8], comma: bool) -> Option<(f64, usize)> {
    let (mantissa, rest) = digits(0, text);
    let whole = text.len() - rest.len();
    let (mantissa, places, used) = match rest {
        [b'.', fraction @ ..] => {
            let (mantissa, rest) = digits(mantissa, fraction);
            (mantissa, fraction.len() - rest.len(), text.len() - rest.len())
        }
        [b',', fraction @ ..] if comma => {
            let (mantissa, rest) = digits(mantissa, fraction);
            (mantissa, fraction.len() - rest.len(), text.len() - rest.len())
        }
        _ => (mantissa, 0, whole),
    };
    let count = whole + places;
    if count == 0 {
        return None;
    }
    // Up to 15 digits both operands are exact, so the one division rounds correctly.
    if count <= 15 {
        return Some((mantissa as f64 / POWERS[places & 15], used));
    }
    Some((slow(&text[..used]), used))
}

/// Appends the digits at the start of `text` to `number`; the rest of the text. Overflow is the caller's to avoid.
#[inline(always)]
fn digits(mut number: u64, mut text: &[u8]) -> (u64, &[u8]) {
    while let [byte, rest @ ..] = text {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            break;
        }
        number = number.wrapping_mul(10).wrapping_add(u64::from(digit));
        text = rest;
    }
    (number, text)
}

fn slow(text: &[u8]) -> f64 {
    let plain: String = text.iter().map(|b| if *b == b',' { '.' } else { *b as char }).collect();
    plain.trim_end_matches('.').parse().unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms() {
        assert_eq!(decimal(b"12,5x", true), Some((12.5, 4)));
        assert_eq!(decimal(b"12,5", false), Some((12.0, 2)));
        assert_eq!(decimal(b"45. ", true), Some((45.0, 3)));
        assert_eq!(decimal(b".943", true), Some((0.943, 4)));
        assert_eq!(decimal(b".", true), None);
        assert_eq!(decimal(b"X", true), None);
        assert_eq!(decimal(b"0.1", true), Some((0.1, 3)));
        assert_eq!(decimal(b"12345678901234567.25", true).map(|n| n.0), Some(12345678901234567.25));
    }

    proptest::proptest! {
        #[test]
        fn equals_the_standard_parser(whole in 0u64..100_000_000, fraction in 0u64..10_000_000, places in 1usize..8) {
            let text = format!("{whole}.{:0places$}", fraction % 10u64.pow(places as u32));
            proptest::prop_assert_eq!(decimal(text.as_bytes(), false), Some((text.parse().unwrap(), text.len())));
        }

        #[test]
        fn short_texts_read_as_long_ones(number in "[0-9]{0,9}([.,][0-9]{0,9})?", rest in "[ -~]{0,10}|[0-9.,]{0,4}|\\PC{0,3}") {
            let text = format!("{number}{rest}");
            for comma in [false, true] {
                proptest::prop_assert_eq!(decimal(text.as_bytes(), comma), long_decimal(text.as_bytes(), comma), "{}", text);
            }
        }
    }
}
