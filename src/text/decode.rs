//! Text of unknown encoding for people: UTF-8 where it is valid, else Windows-1252.

use std::borrow::Cow;

/// `bytes` as readable text. Control characters become blanks.
pub fn readable(bytes: &[u8]) -> Cow<'_, str> {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes).0,
    };
    if text.chars().any(char::is_control) {
        Cow::Owned(text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect())
    } else {
        text
    }
}

/// A whole text whose lines are kept.
pub fn readable_lines(bytes: &[u8]) -> String {
    bytes.split(|b| *b == b'\n').map(|line| readable(line).into_owned() + "\n").collect()
}

/// Number of characters in `bytes`, read as [`readable`] reads them.
pub fn char_count(bytes: &[u8]) -> usize {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.chars().count(),
        Err(_) => bytes.len(),
    }
}

/// Appends `bytes` to `out` in plain ASCII: umlauts and accents are spelled out, the rest becomes `?`.
pub fn to_ascii(bytes: &[u8], out: &mut Vec<u8>) {
    for c in readable(bytes).chars() {
        match ascii_of(c) {
            Some(plain) => out.extend_from_slice(plain.as_bytes()),
            None if c.is_ascii() => out.push(c as u8),
            None => out.push(b'?'),
        }
    }
}

fn ascii_of(c: char) -> Option<&'static str> {
    Some(match c {
        'ä' => "ae",
        'ö' => "oe",
        'ü' => "ue",
        'Ä' => "Ae",
        'Ö' => "Oe",
        'Ü' => "Ue",
        'ß' => "ss",
        'à' | 'á' | 'â' | 'ã' | 'å' => "a",
        'À' | 'Á' | 'Â' | 'Ã' | 'Å' => "A",
        'æ' => "ae",
        'Æ' => "Ae",
        'ç' | 'č' | 'ć' => "c",
        'Ç' | 'Č' | 'Ć' => "C",
        'ď' => "d",
        'Ď' => "D",
        'è' | 'é' | 'ê' | 'ë' | 'ě' => "e",
        'È' | 'É' | 'Ê' | 'Ë' | 'Ě' => "E",
        'ì' | 'í' | 'î' | 'ï' => "i",
        'Ì' | 'Í' | 'Î' | 'Ï' => "I",
        'ł' => "l",
        'Ł' => "L",
        'ñ' | 'ň' | 'ń' => "n",
        'Ñ' | 'Ň' | 'Ń' => "N",
        'ò' | 'ó' | 'ô' | 'õ' => "o",
        'Ò' | 'Ó' | 'Ô' | 'Õ' => "O",
        'ø' => "oe",
        'Ø' => "D",
        'ř' => "r",
        'Ř' => "R",
        'š' | 'ś' => "s",
        'Š' | 'Ś' => "S",
        'ť' => "t",
        'Ť' => "T",
        'ù' | 'ú' | 'û' | 'ů' => "u",
        'Ù' | 'Ú' | 'Û' | 'Ů' => "U",
        'ý' | 'ÿ' => "y",
        'Ý' => "Y",
        'ž' | 'ź' | 'ż' => "z",
        'Ž' | 'Ź' | 'Ż' => "Z",
        '°' => " deg",
        '±' => "+-",
        'µ' | 'μ' => "u",
        '–' | '—' | '−' => "-",
        '“' | '”' | '„' => "\"",
        '‘' | '’' | '´' => "'",
        '…' => "...",
        '×' => "x",
        '²' => "2",
        '³' => "3",
        '\u{a0}' => " ",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invalid_utf8_is_read_as_windows_1252() {
        assert_eq!(readable(b"Vorfr\xe4sen"), "Vorfräsen");
        assert_eq!(char_count(b"Vorfr\xe4sen"), 9);
        assert_eq!(char_count("Vorfräsen".as_bytes()), 9);
    }

    #[test]
    fn comments_become_ascii() {
        let mut out = Vec::new();
        to_ascii("Tasche fräsen Ø78 ▲".as_bytes(), &mut out);
        assert_eq!(out, b"Tasche fraesen D78 ?");
    }
}
