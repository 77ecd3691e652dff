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
    let mut text = plain(comment, comments);
    text.splice(0..0, guard(&text, comments).iter().copied());
    text
}

/// The text of `comment` in lines of at most `room` bytes, cut at blanks where there are any. No line is active.
pub fn lines(comment: &[u8], comments: &Comments, room: usize) -> Vec<Vec<u8>> {
    let text = plain(comment, comments);
    let mut rest = text.trim_ascii();
    let mut out = Vec::new();
    while !rest.is_empty() {
        let guard = guard(rest, comments);
        let room = room.saturating_sub(guard.len()).max(1);
        let cut = if rest.len() <= room {
            rest.len()
        } else {
            rest[..=room].iter().rposition(|b| *b == b' ').filter(|cut| *cut > room / 2).unwrap_or(room)
        };
        out.push([guard, rest[..cut].trim_ascii_end()].concat());
        rest = rest[cut..].trim_ascii_start();
    }
    out
}

/// Characters that the target takes.
fn plain(comment: &[u8], comments: &Comments) -> Vec<u8> {
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
    text
}

/// What stands in front of a text that would be active.
fn guard(text: &[u8], comments: &Comments) -> &'static [u8] {
    let word = text.trim_ascii_start();
    let len = word.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let first = &word[..len];
    let active = ACTIVE.iter().any(|active| active.eq_ignore_ascii_case(first)) && !matches!(word.get(len), Some(b' '));
    match (active, comments.upper) {
        (false, _) => b"",
        (true, false) => b": ",
        (true, true) => b"- ",
    }
}

fn in_capitals(b: u8) -> u8 {
    let b = b.to_ascii_uppercase();
    if b.is_ascii_uppercase() || b.is_ascii_digit() || b" ,=_-".contains(&b) { b } else { b'.' }
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
        let cut = |text: &str, room| {
            lines(text.as_bytes(), &PLAIN, room)
                .iter()
                .map(|line| String::from_utf8_lossy(line).into_owned())
                .collect::<Vec<_>>()
        };
        assert_eq!(cut("aaaa bbbb cccc", 9), ["aaaa bbbb", "cccc"]);
        assert_eq!(cut("aaaaaaaaaaaa", 5), ["aaaaa", "aaaaa", "aa"]);
        assert_eq!(cut("Fräsern", 8), ["Fraesern"]);
        assert!(cut("  ", 5).is_empty());
    }

    #[test]
    fn no_line_of_a_long_text_is_active() {
        let cut = lines(b"words of the target (MSG, DEBUG, PRINT, LOG)", &PLAIN, 25);
        assert_eq!(cut, [&b"words of the target [MSG,"[..], b": DEBUG, PRINT, LOG]"]);
        let narrow = lines(b"tool 12345 DEBUG,1234567890", &PLAIN, 14);
        assert_eq!(narrow, [&b"tool 12345"[..], b": DEBUG,123456", b"7890"]);
    }
}
