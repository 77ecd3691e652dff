//! The fast path: blocks of plain words, decoded in one loop over the bytes.
//!
//! For every block it takes it yields exactly what the grammar yields; whatever it does not know it leaves
//! alone. CAM programs consist of such blocks.

use crate::lexer::turning::{Addr, Address};
use crate::text::{Span, number::decimal};

use super::ast::{Block, Stmt, Value, Word};

/// Longest literal that is decoded here.
const SHORT: usize = 16;

/// Reads the words at `from` if all are a letter and a number; otherwise leaves `block` as it was. The span of a
/// comment is only its start.
#[inline]
pub fn parse(text: &[u8], from: usize, block: &mut Block) -> bool {
    let mut at = from;
    let mut end = from;
    loop {
        while let Some(b' ' | b'\t') = text.get(at) {
            at += 1;
        }
        let Some(&letter) = text.get(at) else { break };
        if letter == b'[' && !block.words.is_empty() {
            block.comment = Some(Span::at(at as u32, 0));
            break;
        }
        let Some((word, next)) = word(text, at, letter) else { return undo(block) };
        block.words.push(word);
        at = next;
        end = next;
    }
    if block.words.is_empty() {
        return undo(block);
    }
    block.stmt = Stmt::Words;
    block.span = Span { start: from as u32, end: end as u32 };
    true
}

#[cold]
fn undo(block: &mut Block) -> bool {
    block.words.clear();
    block.comment = None;
    false
}

/// The word at `at`, and where it ends.
#[inline]
fn word(text: &[u8], at: usize, letter: u8) -> Option<(Word, usize)> {
    if !letter.is_ascii_alphabetic() {
        return None;
    }
    let letter = letter & 0xdf;
    let incremental = matches!(text.get(at + 1), Some(b'I' | b'i'));
    if incremental && !matches!(letter, b'X' | b'Z' | b'I' | b'K' | b'Y' | b'C') {
        return None;
    }
    let value_at = at + 1 + usize::from(incremental);
    let (sign, from) = match text.get(value_at)? {
        b'-' => (-1.0, value_at + 1),
        b'+' => (1.0, value_at + 1),
        b'0'..=b'9' | b'.' => (1.0, value_at),
        _ => return None,
    };
    let (value, len) = decimal(&text[from..], false)?;
    let next = from + len;
    match text.get(next) {
        None | Some(b' ' | b'\t' | b'[') => {}
        Some(b) if b.is_ascii_alphabetic() => {}
        _ => return None,
    }
    if len > SHORT {
        return None;
    }
    let whole = from == value_at && !text[from..next].contains(&b'.');
    let value = Value::Number { value: sign * value, whole };
    let address = Address { addr: Addr(u32::from(letter)), incremental };
    Some((Word { address, value, span: Span { start: at as u32, end: next as u32 } }, next))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parser::turning::parse_statement;
    use proptest::prelude::*;

    fn agrees(text: &str) -> bool {
        let mut fast = Block::default();
        if !parse(text.as_bytes(), 0, &mut fast) {
            assert_eq!(fast, Block::default());
            return false;
        }
        let end = fast.comment.take().map_or(text.len(), |span| span.start as usize);
        let mut slow = Block::default();
        let mut problems = Vec::new();
        parse_statement(&text.as_bytes()[..end], 0, &mut slow, &mut problems);
        assert_eq!(fast, slow, "{text}: {problems:?}");
        true
    }

    #[test]
    fn plain_blocks() {
        for text in ["G1 X10 Z-5.25 B-.5", "G01X5Z6[done]", "g3xi-.5ki+2", "M30", "T0303 G96 S200", "II-8 KI5"] {
            assert!(agrees(text), "{text}");
        }
        for text in ["X=10", "X 10", "AN30", "X#5", "X?", "ID\"A\"", "V1=5", "RI5", "X1.2.3", "X5-2", "[a]", ""] {
            assert!(!agrees(text), "{text}");
        }
    }

    proptest! {
        #[test]
        fn agrees_with_the_grammar(
            words in proptest::collection::vec((r"[A-Za-z][iI]?[+-]?[0-9]{0,6}(\.[0-9]{0,4})?", r"[ \t]{0,2}"), 1..6),
            comment in proptest::option::of(r"\[[ -Z^-~]{0,8}\]"),
        ) {
            let mut text: String = words.iter().flat_map(|(word, blank)| [word.as_str(), blank]).collect();
            text.push_str(comment.as_deref().unwrap_or(""));
            agrees(&text);
        }
    }
}
