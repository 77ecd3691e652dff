//! Source comments as comments of the output: plain ASCII, never nested, never active.

use crate::target::Comments;
use crate::text::decode::to_ascii;

/// Words that make LinuxCNC act on a comment.
const ACTIVE: &[&[u8]] = &[
    b"msg",
    b"debug",
    b"print",
    b"log",
    b"logopen",
    b"logappend",
    b"logclose",
    b"probeopen",
    b"probeclose",
    b"abort",
    b"py",
];

/// The text of `comment` as it may stand between brackets. Characters that the target does not take become points.
pub fn harmless(comment: &[u8], comments: &Comments) -> Vec<u8> {
    let mut text = Vec::with_capacity(comment.len() + 2);
    to_ascii(comment, &mut text);
    for b in &mut text {
        *b = match *b {
            b'(' => b'[',
            b')' => b']',
            b'%' => b'#',
            // A bare control character was turned into a blank before.
            b if !b.is_ascii_graphic() => b' ',
            b if comments.forbidden.contains(&b) => b'.',
            b => b,
        };
    }
    if comments.upper {
        text.iter_mut().for_each(|b| *b = in_capitals(*b));
    }
    let word = text.trim_ascii_start();
    let len = word.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let first = word[..len].to_ascii_lowercase();
    if ACTIVE.iter().any(|active| **active == *first) && !matches!(word.get(len), Some(b' ')) {
        text.splice(0..0, if comments.upper { *b"- " } else { *b": " });
    }
    text
}

fn in_capitals(b: u8) -> u8 {
    let b = b.to_ascii_uppercase();
    if b.is_ascii_uppercase() || b.is_ascii_digit() || b" ,=_-".contains(&b) { b } else { b'.' }
}

/// Pieces of a text of at most `len` bytes, cut at blanks where there are any.
pub fn pieces(text: &[u8], len: usize) -> Vec<&[u8]> {
    let mut rest = text.trim_ascii();
    let mut out = Vec::new();
    while rest.len() > len {
        let cut = rest[..=len].iter().rposition(|b| *b == b' ').filter(|cut| *cut > len / 2).unwrap_or(len);
        out.push(rest[..cut].trim_ascii_end());
        rest = rest[cut..].trim_ascii_start();
    }
    if !rest.is_empty() {
        out.push(rest);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: Comments = Comments { open: "(", close: ")", upper: false, forbidden: b"" };
    const STREAMED: Comments = Comments { forbidden: b"!?~", ..PLAIN };
    const CAPITALS: Comments = Comments { upper: true, ..PLAIN };

    #[test]
    fn nothing_active_comes_through() {
        assert_eq!(harmless(b"MSG,tool (4) 50 %", &PLAIN), b": MSG,tool [4] 50 #");
        assert_eq!(harmless(b" debug,#1", &PLAIN), b":  debug,#1");
        assert_eq!(harmless(b"print this", &PLAIN), b"print this");
        assert_eq!(harmless(b"PROBEOPEN a.txt", &PLAIN), b"PROBEOPEN a.txt");
        assert_eq!(harmless("fräsen".as_bytes(), &PLAIN), b"fraesen");
        assert_eq!(harmless(b"what? stop! ~", &STREAMED), b"what. stop. .");
        assert_eq!(harmless("MSG, Fräser D=5_x-y (2/3)".as_bytes(), &CAPITALS), b"- MSG, FRAESER D=5_X-Y .2.3.");
    }

    #[test]
    fn long_texts_are_cut_at_blanks() {
        assert_eq!(pieces(b"aaaa bbbb cccc", 9), [&b"aaaa bbbb"[..], b"cccc"]);
        assert_eq!(pieces(b"aaaaaaaaaaaa", 5), [&b"aaaaa"[..], b"aaaaa", b"aa"]);
        assert!(pieces(b"  ", 5).is_empty());
    }
}
