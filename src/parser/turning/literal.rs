//! Plain words of turning programs: see [`crate::parser::literal`].

use crate::lexer::turning::{Addr, Address};
use crate::parser::literal::{self, Shape};
use crate::text::Span;

use super::ast::{Block, Stmt, Value, Word};

/// Reads the words at `from` if all are a letter and a number; otherwise leaves `block` as it was. The span of a
/// comment is only its start.
#[inline]
pub fn parse(text: &[u8], from: usize, block: &mut Block) -> bool {
    let Some((end, _)) = literal::words::<Plain>(text, from, from, block) else { return false };
    if block.words.is_empty() {
        Plain::undo(block);
        return false;
    }
    block.stmt = Stmt::Words;
    block.span = Span { start: from as u32, end: end as u32 };
    true
}

struct Plain;

impl Shape for Plain {
    type Block = Block;

    const COMMENT: u8 = b'[';
    const LONGEST: usize = 16;

    #[inline]
    fn word(text: &[u8], at: usize, letter: u8, block: &mut Block) -> Option<usize> {
        if !letter.is_ascii_alphabetic() {
            return None;
        }
        let letter = letter & 0xdf;
        let incremental = matches!(text.get(at + 1), Some(b'I' | b'i'));
        if incremental && !matches!(letter, b'X' | b'Z' | b'I' | b'K' | b'Y' | b'C') {
            return None;
        }
        let number = literal::number::<Plain>(text, at + 1 + usize::from(incremental))?;
        let value = Value::Number { value: number.value, whole: number.is_digits(text) };
        let address = Address { addr: Addr(u32::from(letter)), incremental };
        block.words.push(Word { address, value, span: Span { start: at as u32, end: number.end as u32 } });
        Some(number.end)
    }

    fn comment(_: &[u8], at: usize, block: &mut Block) -> bool {
        block.comment = Some(Span::at(at as u32, 0));
        !block.words.is_empty()
    }

    fn undo(block: &mut Block) {
        block.words.clear();
        block.comment = None;
    }
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
            words in proptest::collection::vec((r"[A-Za-z][iI]?[+-]?[0-9]{0,18}(\.[0-9]{0,9})?", r"[ \t]{0,2}"), 1..6),
            comment in proptest::option::of(r"\[[ -Z^-~]{0,8}\]"),
        ) {
            let mut text: String = words.iter().flat_map(|(word, blank)| [word.as_str(), blank]).collect();
            text.push_str(comment.as_deref().unwrap_or(""));
            agrees(&text);
        }
    }
}
