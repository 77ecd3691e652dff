//! Text of unknown encoding for people: UTF-8 where it is valid, else Windows-1252.

use std::borrow::Cow;

/// Characters that show nothing and change how the text around them is shown: colours, the cursor, the direction.
fn is_active(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
}

/// `text` without active characters: blanks stand in their places.
pub fn harmless(text: &str) -> Cow<'_, str> {
    if text.chars().any(is_active) {
        Cow::Owned(text.chars().map(|c| if is_active(c) { ' ' } else { c }).collect())
    } else {
        Cow::Borrowed(text)
    }
}

/// Lines without active characters.
pub fn harmless_lines(text: &str) -> String {
    text.split('\n').map(harmless).collect::<Vec<_>>().join("\n")
}

/// A JSON text in which active characters are escaped; they stand in strings only.
pub fn escaped_json(text: &str) -> Cow<'_, str> {
    let active = |c: char| c != '\n' && is_active(c);
    if !text.contains(active) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 32);
    for c in text.chars() {
        if active(c) {
            out.push_str(&format!("\\u{:04x}", u32::from(c)));
        } else {
            out.push(c);
        }
    }
    Cow::Owned(out)
}

/// A byte of Windows-1252, as the WHATWG's Encoding Standard reads it.
fn western(byte: u8) -> char {
    const HIGH: [char; 32] = [
        '\u{20ac}', '\u{81}', '\u{201a}', '\u{192}', '\u{201e}', '\u{2026}', '\u{2020}', '\u{2021}', '\u{2c6}',
        '\u{2030}', '\u{160}', '\u{2039}', '\u{152}', '\u{8d}', '\u{17d}', '\u{8f}', '\u{90}', '\u{2018}', '\u{2019}',
        '\u{201c}', '\u{201d}', '\u{2022}', '\u{2013}', '\u{2014}', '\u{2dc}', '\u{2122}', '\u{161}', '\u{203a}',
        '\u{153}', '\u{9d}', '\u{17e}', '\u{178}',
    ];
    let high = byte.checked_sub(0x80).and_then(|at| HIGH.get(usize::from(at)));
    high.copied().unwrap_or(char::from(byte))
}

/// `bytes` as readable text. Control characters, and those that turn the direction of the text, become blanks.
pub fn readable(bytes: &[u8]) -> Cow<'_, str> {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|byte| western(*byte)).collect()),
    };
    match harmless(&text) {
        Cow::Owned(text) => Cow::Owned(text),
        Cow::Borrowed(_) => text,
    }
}

/// A word for a message. One of a character that shows nothing is called by its number.
pub fn named(bytes: &[u8]) -> String {
    let word = readable(bytes);
    match bytes {
        [byte] if byte.is_ascii_control() => format!("a control character (U+{byte:04X})"),
        _ => format!("`{word}`"),
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
    fn active_characters_are_taken_out() {
        assert_eq!(readable("a\u{1b}[31m\u{202e}b\u{2066}\u{200f}c\u{2028}d".as_bytes()), "a [31m b  c d");
        assert_eq!(harmless("Größe µ Ø"), "Größe µ Ø");
        assert_eq!(harmless_lines("a\tb\nc\rd"), "a b\nc d");
        assert_eq!(escaped_json("{\"a\":\"x\u{202e}y\u{9b}\"}\n"), "{\"a\":\"x\\u202ey\\u009b\"}\n");
    }

    #[test]
    fn comments_become_ascii() {
        let mut out = Vec::new();
        to_ascii("Tasche fräsen Ø78 ▲".as_bytes(), &mut out);
        assert_eq!(out, b"Tasche fraesen D78 ?");
    }
}
