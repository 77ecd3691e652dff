//! What programs print where they computed no number: `NaN`, `inf`, `1.#IND`.

/// Forms of "no number" and of infinity in the languages that CAM systems and post-processors are written in.
const FORMS: &[&[u8]] = &[b"NAN", b"INF", b"INFINITY", b"#IND", b"#INF", b"#QNAN", b"#SNAN", b"NAN(IND)", b"-NAN(IND)"];

/// Is the word such a form, with or without an address (`Xnan`, `IY-inf`, `nan`)?
pub fn is_no_number(word: &[u8]) -> bool {
    let upper = word.to_ascii_uppercase();
    let ends = |rest: &[u8]| {
        let rest = rest.strip_prefix(b"+").or(rest.strip_prefix(b"-")).unwrap_or(rest);
        let rest = rest.strip_prefix(b"1.").unwrap_or(rest);
        FORMS.contains(&rest)
    };
    // An address is one letter, or two with the I of an increment or the P of a polar word.
    (0..=3.min(upper.len())).any(|len| {
        let address = &upper[..len];
        address.iter().all(u8::is_ascii_alphabetic)
            && (len < 2 || matches!(address[0], b'I' | b'P'))
            && ends(&upper[len..])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_without_a_number() {
        for word in ["nan", "Xnan", "X-NaN", "IY+inf", "PRnan", "IPAnan", "Z1.#IND", "#IND", "FInfinity"] {
            assert!(is_no_number(word.as_bytes()), "{word}");
        }
        for word in ["X", "NANA", "FINE", "", "INT", "BANANAN", "X+1", "IN"] {
            assert!(!is_no_number(word.as_bytes()), "{word}");
        }
    }
}
