//! What programs print where they computed no number, `NaN`, `inf`, `1.#IND`, `-nan(ind)`, or one that the control cannot
//! read, `1e-05`.

/// Forms of "no number" and of infinity in the languages that CAM systems and post-processors are written in.
const FORMS: &[&[u8]] = &[b"NAN", b"INF", b"INFINITY", b"NULL", b"NONE"];
/// The same behind a mark, as runtime libraries of C print them: `1.#IND`, `1.#QNAN0`, `1.#J`.
const MARKED: &[&[u8]] = &[b"IND", b"INF", b"QNAN", b"SNAN", b"J"];

/// Why a word is no number of the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Misprint {
    /// There was no value.
    Nothing,
    /// It has an exponent.
    Exponent,
}

/// Is the word such a form, with or without an address (`Xnan`, `IY-inf`, `nan`)?
pub fn is_no_number(word: &[u8]) -> bool {
    let upper = word.to_ascii_uppercase();
    // An address is one letter, or two with the I of an increment or the P of a polar word.
    (0..=3.min(upper.len())).any(|len| {
        let address = &upper[..len];
        address.iter().all(u8::is_ascii_alphabetic)
            && (len < 2 || matches!(address[0], b'I' | b'P'))
            && is_form(&upper[len..])
    })
}

fn is_form(rest: &[u8]) -> bool {
    let rest = rest.strip_prefix(b"=").unwrap_or(rest);
    let rest = rest.strip_prefix(b"+").or(rest.strip_prefix(b"-")).unwrap_or(rest);
    if let Some(marked) = rest.strip_prefix(b"1.").unwrap_or(rest).strip_prefix(b"#") {
        let digits = marked.iter().rev().take_while(|b| b.is_ascii_digit()).count();
        return MARKED.contains(&&marked[..marked.len() - digits]);
    }
    // `nan(ind)`, `nan(snan)`, `nan(0x8000000000000)`
    let in_brackets =
        |rest: &[u8]| rest.ends_with(b")") && rest[1..rest.len() - 1].iter().all(u8::is_ascii_alphanumeric);
    match rest.strip_prefix(b"NAN") {
        Some([b'(', ..]) => rest.len() > 5 && in_brackets(&rest[3..]),
        _ => FORMS.contains(&rest),
    }
}

/// What is wrong with the number in the word around `at` of a block that cannot be read, and where that word stands.
pub fn misprint(text: &[u8], at: usize) -> Option<(Misprint, std::ops::Range<usize>)> {
    let is_blank = |b: &u8| b.is_ascii_whitespace();
    let start = text.get(..at)?.iter().rposition(is_blank).map_or(0, |blank| blank + 1);
    let end = text[at..].iter().position(is_blank).map_or(text.len(), |len| at + len);
    let word = &text[start..end];
    if is_no_number(word) {
        return Some((Misprint::Nothing, start..end));
    }
    // Words that stand without blanks: from the address in front to the one behind.
    let from = word[..(at - start).min(word.len())].iter().rposition(u8::is_ascii_alphabetic).unwrap_or(0);
    let candidates = (from..word.len()).map(|last| &word[from..=last]);
    if let Some(found) = candidates.rev().find(|part| is_no_number(part)) {
        return Some((Misprint::Nothing, start + from..start + from + found.len()));
    }
    exponent(word, at - start).map(|len| (Misprint::Exponent, start + from..start + len))
}

/// The end of a number with an exponent whose E stands at `at`.
fn exponent(word: &[u8], at: usize) -> Option<usize> {
    let e =
        matches!(word.get(at), Some(b'E' | b'e')) && matches!(word.get(at.checked_sub(1)?), Some(b'0'..=b'9' | b'.'));
    let rest = word.get(at + 1..).filter(|_| e)?;
    let sign = usize::from(matches!(rest.first(), Some(b'+' | b'-')));
    let digits = rest[sign..].iter().take_while(|b| b.is_ascii_digit()).count();
    (digits > 0).then_some(at + 1 + sign + digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_without_a_number() {
        for word in [
            "nan",
            "Xnan",
            "X-NaN",
            "IY+inf",
            "PRnan",
            "IPAnan",
            "Z1.#IND",
            "#IND",
            "FInfinity",
            "X-nan(ind)",
            "Xnan(snan)",
            "Y-1.#QNAN",
            "Z1.#INF000",
            "X1.#J",
            "Xnan(0x8000)",
            "X=nan",
            "Xnull",
        ] {
            assert!(is_no_number(word.as_bytes()), "{word}");
        }
        for word in ["X", "NANA", "FINE", "", "INT", "BANANAN", "X+1", "IN", "nan(", "nan()", "X1.#", "X#5", "nan(a b)"]
        {
            assert!(!is_no_number(word.as_bytes()), "{word}");
        }
    }

    #[test]
    fn the_word_around_a_place() {
        let found = |text: &str, at: &str| {
            let (kind, range) = misprint(text.as_bytes(), text.find(at).unwrap())?;
            Some((kind, text[range].to_owned()))
        };
        let nothing = |word: &str| Some((Misprint::Nothing, word.to_owned()));
        let exponent = |word: &str| Some((Misprint::Exponent, word.to_owned()));
        assert_eq!(found("L X-nan(ind) Y+1", "("), nothing("X-nan(ind)"));
        assert_eq!(found("L X-1.#IND000 R0", "#"), nothing("X-1.#IND000"));
        assert_eq!(found("LX1.#QNANY5", "#"), nothing("X1.#QNAN"));
        assert_eq!(found("L X+1.5e-05 Y+1", "e"), exponent("X+1.5e-05"));
        assert_eq!(found("L X1E5Y2", "E"), exponent("X1E5"));
        assert_eq!(found("L X+1 E", "E"), None);
        assert_eq!(found("L X+1e", "e"), None);
    }
}
