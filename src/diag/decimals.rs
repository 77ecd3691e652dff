//! Numbers in messages.

/// More decimals than anybody programs: arithmetic adds them, of inches in mm above all.
const MOST: usize = 9;
/// To so many a number with more is rounded.
const KEPT: usize = 6;

/// The message without what arithmetic added to its numbers. What is quoted stays as it was written.
pub fn rounded(message: String) -> String {
    let is_long = |text: &str| {
        let digits = text.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(|number| number.split_once('.'));
        digits.into_iter().any(|(_, decimals)| decimals.len() > MOST)
    };
    if !is_long(&message) {
        return message;
    }
    let pieces = message.split('`').enumerate();
    let pieces: Vec<String> =
        pieces.map(|(at, piece)| if at % 2 == 0 { of_text(piece) } else { piece.to_owned() }).collect();
    pieces.join("`")
}

fn of_text(text: &str) -> String {
    let mut made = String::with_capacity(text.len());
    for part in text.split_inclusive(|c: char| !c.is_ascii_digit() && c != '.') {
        let (number, rest) = part.split_at(part.trim_end_matches(|c: char| !c.is_ascii_digit()).len());
        let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        match number.parse::<f64>() {
            Ok(value) if decimals > MOST => {
                let digits = format!("{value:.KEPT$}");
                made += digits.trim_end_matches('0').trim_end_matches('.');
            }
            _ => made += number,
        }
        made += rest;
    }
    made
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn numbers_in_messages_are_rounded() {
        let of = |text: &str| rounded(text.to_owned());
        assert_eq!(of("a length of 25.400000000000002 mm, not 12.7"), "a length of 25.4 mm, not 12.7");
        assert_eq!(of("Q1 = -2.5399999999999996 (Q200=0.5)."), "Q1 = -2.54 (Q200=0.5).");
        assert_eq!(
            of("`X1.00000000001` is 0.99999999999, above 0.000000001"),
            "`X1.00000000001` is 1, above 0.000000001"
        );
        assert_eq!(of("1.2.3 of 7.00000000001"), "1.2.3 of 7");
    }
}
