//! Plain words of SINUMERIK: see [`crate::parser::literal`].

use crate::parser::literal::{self, Shape};
use crate::text::Span;

use super::ast::{Block, Stmt, Target, Value, Word};

/// Reads the words at `from` if all are a letter and a number; otherwise leaves `block` as it was.
#[inline]
pub fn parse(text: &[u8], from: usize, block: &mut Block) -> bool {
    let Some((end, _)) = literal::words::<Plain>(text, from, from, block) else { return false };
    block.stmt = Stmt::Words;
    block.span = Span { start: from as u32, end: end as u32 };
    true
}

pub(super) struct Plain;

impl Shape for Plain {
    type Block = Block;

    const COMMENT: u8 = b';';
    const LONGEST: usize = 16;

    #[inline]
    fn word(text: &[u8], at: usize, letter: u8, block: &mut Block) -> Option<usize> {
        if !letter.is_ascii_alphabetic() {
            return None;
        }
        let number = literal::number::<Plain>(text, at + 1)?;
        // An exponent belongs to the grammar.
        if matches!(text.get(number.end), Some(b'E' | b'e')) {
            return None;
        }
        let whole = number.is_whole(text);
        let digits = if whole && !number.signed { (number.end - number.from) as u8 } else { 0 };
        let value = Value::Literal { value: number.value, whole, digits };
        let span = Span { start: at as u32, end: number.end as u32 };
        block.words.push(Word { target: Target::Letter(letter & 0xdf), value, span });
        Some(number.end)
    }

    fn comment(text: &[u8], at: usize, block: &mut Block) -> bool {
        block.comment = Some(Span { start: at as u32 + 1, end: text.len() as u32 });
        true
    }

    fn undo(block: &mut Block) {
        block.words.clear();
        block.comment = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parser::sinumerik::parse_statement;
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
        for text in ["G1 X10 Y-5.25 Z.5 F100", "G01X5Y6;done", "g3x-.5i+2", "M30", "L001 P2"] {
            assert!(parse(text.as_bytes(), 0, &mut block), "{text}");
            block.clear();
            agrees(text);
        }
        for text in ["X=10", "X 10", "CR=5", "X1EX2", "X10E", "R1=5", "X1 =5", "X1[2]", "X-", "(X1)", "Xé"] {
            assert!(!parse(text.as_bytes(), 0, &mut block), "{text}");
            agrees(text);
        }
    }

    proptest! {
        #[test]
        fn agrees_with_the_grammar(
            words in proptest::collection::vec((r"[A-Za-z][+-]?[0-9]{0,18}(\.[0-9]{0,9})?", r"[ \t]{0,2}"), 1..6),
            comment in proptest::option::of("; ?[ -~]{0,8}"),
        ) {
            let mut text: String = words.iter().flat_map(|(word, blank)| [word.as_str(), blank]).collect();
            text.push_str(comment.as_deref().unwrap_or(""));
            agrees(&text);
        }
    }
}
