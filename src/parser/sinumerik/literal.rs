//! Plain words of SINUMERIK: see [`crate::parser::literal`].

use crate::machine::Axis;
use crate::parser::literal::{self, Shape};
use crate::parser::straight::{self, Straight};
use crate::text::Span;
use crate::text::number::leading_digits;

use super::ast::{Block, Stmt, Target, Value, Word};

/// Reads the words at `from` if all are a letter and a number; otherwise leaves `block` as it was.
#[inline]
pub fn parse(text: &[u8], from: usize, block: &mut Block) -> bool {
    let Some(end) = literal::words::<Plain>(text, from, from, block) else { return false };
    block.stmt = Stmt::Words;
    block.span = Span { start: from as u32, end: end as u32 };
    true
}

struct Plain;

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

/// Reads the line at the start of `text`, if it is a straight block.
#[inline(always)]
pub fn straight(text: &[u8], line_end: u8) -> Option<Straight> {
    let mut from = literal::after_blanks(text, 0);
    if let Some(b'N' | b'n') = text.get(from) {
        let digits = leading_digits(text.get(from + 1..)?).filter(|digits| *digits > 0)?;
        from = literal::after_blanks(text, from + 1 + digits);
    }
    straight::read::<Line>(text, from, from, line_end)
}

/// The words of a straight block.
struct Line;

impl Shape for Line {
    type Block = Straight;

    const COMMENT: u8 = Plain::COMMENT;
    const LONGEST: usize = Plain::LONGEST;

    #[inline(always)]
    fn ends_text(byte: u8) -> bool {
        straight::ends_line(byte)
    }

    #[inline(always)]
    fn word(text: &[u8], at: usize, letter: u8, line: &mut Straight) -> Option<usize> {
        let number = literal::number::<Line>(text, at + 1)?;
        // An exponent belongs to the grammar.
        if matches!(text.get(number.end), Some(b'E' | b'e')) || !number.value.is_finite() {
            return None;
        }
        match letter & 0xdf {
            b'X' => line.go(Axis::X, number.value)?,
            b'Y' => line.go(Axis::Y, number.value)?,
            b'Z' => line.go(Axis::Z, number.value)?,
            b'F' => line.feed(number.value)?,
            _ => return None,
        }
        Some(number.end)
    }

    fn comment(_: &[u8], _: usize, _: &mut Straight) -> bool {
        false
    }

    fn undo(_: &mut Straight) {}
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

        #[test]
        fn a_straight_block_says_what_the_parser_finds(
            head in "([Nn] ?[0-9]{0,9})?[ \t]{0,2}",
            words in proptest::collection::vec(
                ("[XYZxyz][+-]?[0-9]{0,8}\\.?[0-9]{0,8}|[Ff][+-]?[0-9]{1,6}|[A-Z][0-9]{0,3}|;|:|X1E5|X1EX2|X=1", "[ \t]{0,2}"),
                0..6,
            ),
            end in proptest::sample::select(vec!["\n", "\r\n", "\r", "", "\r\r\n"]),
            rest in "[ -~\n]{0,12}",
            line_end in proptest::sample::select(vec![b'\n', b'\r']),
        ) {
            let words: String = words.iter().flat_map(|(word, blank)| [word.as_str(), blank]).collect();
            let text = format!("{head}{words}{end}{rest}");
            says_the_same(text.as_bytes(), line_end);
        }
    }

    #[test]
    fn a_straight_block_ends_with_its_line() {
        for (text, len) in [
            ("N10 X1.5 Y-2.25 Z45.\nN20", Some(21)),
            ("x1y2z3f4\r\n", Some(10)),
            ("N10 X1", None),
            ("N10 F5\n", None),
            ("X1:\n", None),
            ("X5 X6\n", None),
            ("X5 G1\n", None),
            ("X5 F-1\n", None),
            ("X1EX2\n", None),
            ("X1;\n", None),
        ] {
            assert_eq!(straight(text.as_bytes(), b'\n').map(|line| line.len), len, "{text:?}");
            says_the_same(text.as_bytes(), b'\n');
        }
    }

    /// What the words of a block say, if it is a straight one.
    fn of_block(block: &Block) -> Option<Straight> {
        let mut line = Straight { words: block.span, ..Straight::default() };
        for word in &block.words {
            let (Target::Letter(letter), Value::Literal { value, .. }) = (word.target, word.value) else { return None };
            match letter {
                b'F' => line.feed(value)?,
                _ => line.go(Axis::of(letter)?, value)?,
            }
        }
        let plain =
            block.skip.is_none() && block.comment.is_none() && block.label.is_none() && block.stmt == Stmt::Words;
        (plain && !line.axes.is_empty()).then_some(line)
    }

    fn says_the_same(text: &[u8], line_end: u8) {
        let Some(found) = straight(text, line_end) else { return };
        let line = &text[..found.len - 1];
        assert_eq!((text[found.len - 1], line.contains(&line_end)), (line_end, false));
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        let (mut block, mut problems) = (Block::default(), Vec::new());
        super::super::parse_block(line, &mut block, &mut Symbols::default(), &mut problems);
        assert!(problems.is_empty(), "{problems:?}");
        assert_eq!(Some(Straight { len: 0, ..found }), of_block(&block), "{}", String::from_utf8_lossy(line));
    }
}
