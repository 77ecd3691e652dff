//! The fast path: blocks of plain words, decoded in one loop over the bytes.
//!
//! For every block it takes it yields exactly what the grammar yields; whatever it does not know it leaves
//! alone. CAM programs consist of such blocks.

use crate::text::{Span, number::decimal};

use super::ast::{Block, Stmt, Target, Value, Word};

/// Reads the words at `from` if all are a letter and a number; otherwise leaves `block` as it was.
#[inline]
pub fn parse(text: &[u8], from: usize, block: &mut Block) -> bool {
    let mut at = from;
    let mut end = from;
    loop {
        while let Some(b' ' | b'\t') = text.get(at) {
            at += 1;
        }
        let Some(&letter) = text.get(at) else { break };
        if letter == b';' {
            if text[at..].contains(&b'\n') {
                return undo(block);
            }
            block.comments.push(Span { start: at as u32 + 1, end: text.len() as u32 });
            break;
        }
        let Some((value, next)) = word(text, at, letter) else { return undo(block) };
        let target = Target::Letter(letter & 0xdf);
        block.words.push(Word {
            target,
            value: Value::Literal(value),
            span: Span { start: at as u32, end: next as u32 },
        });
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
    block.comments.clear();
    false
}

/// The word at `at`: its value and where it ends.
#[inline]
fn word(text: &[u8], at: usize, letter: u8) -> Option<(f64, usize)> {
    if !letter.is_ascii_alphabetic() {
        return None;
    }
    let (sign, from) = match text.get(at + 1)? {
        b'-' => (-1.0, at + 2),
        b'+' => (1.0, at + 2),
        b'0'..=b'9' | b'.' => (1.0, at + 1),
        _ => return None,
    };
    let (value, len) = decimal(&text[from..], false)?;
    let next = from + len;
    // `=`, a bracket, a second point may follow: the grammar knows.
    match text.get(next) {
        None | Some(b' ' | b'\t' | b';') => {}
        Some(b) if b.is_ascii_alphabetic() => {}
        _ => return None,
    }
    Some((sign * value, next))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parser::mtc200::parse_statement;
    use crate::parser::symbols::Symbols;
    use proptest::prelude::*;

    fn agrees(text: &str) {
        let mut fast = Block::default();
        if !parse(text.as_bytes(), 0, &mut fast) {
            assert_eq!(fast, Block::default());
            return;
        }
        let mut slow = Block::default();
        let mut problems = Vec::new();
        parse_statement(text.as_bytes(), 0, &mut slow, &mut Symbols::default(), &mut problems);
        assert_eq!(fast, slow, "{text}: {problems:?}");
    }

    #[test]
    fn plain_blocks() {
        let mut block = Block::default();
        for text in ["G1 X10 Y-5.25 Z.5 F100", "G01X5Y6;done", "g3x-.5i+2", "M30", "Z50 M008 F4500.0D02"] {
            assert!(parse(text.as_bytes(), 0, &mut block), "{text}");
            block.clear();
            agrees(text);
        }
        for text in ["X=10", "X 10", "CF5", "X1 =5", "X1(a)", "X-", "LA_ON", "X1 RET", "@1=5", "X1.2.3", "Xé", "X1@"] {
            assert!(!parse(text.as_bytes(), 0, &mut block), "{text}");
            agrees(text);
        }
    }

    proptest! {
        #[test]
        fn agrees_with_the_grammar(
            words in proptest::collection::vec((r"[A-Za-z][+-]?[0-9]{0,18}(\.[0-9]{0,4})?", r"[ \t]{0,2}"), 1..6),
            comment in proptest::option::of("; ?[ -~]{0,8}"),
        ) {
            let mut text: String = words.iter().flat_map(|(word, blank)| [word.as_str(), blank]).collect();
            text.push_str(comment.as_deref().unwrap_or(""));
            agrees(&text);
        }
    }
}
