//! Straight blocks of SINUMERIK: see [`crate::parser::straight`].

use crate::machine::Axis;
use crate::parser::literal::{self, Shape};
use crate::parser::straight::{self, Straight};
use crate::text::number::leading_digits;

use super::ast::{Block, Stmt, Target, Value};
use super::literal::Plain;

/// Reads the line at the start of `text`, if it is a straight block.
#[inline(always)]
pub fn of_line(text: &[u8], line_end: u8) -> Option<Straight> {
    let from = behind_number(text)?;
    straight::read::<Line>(text, from, from, line_end)
}

/// Where the words begin, behind the block number.
#[inline(always)]
fn behind_number(text: &[u8]) -> Option<usize> {
    let from = literal::after_blanks(text, 0);
    let Some(b'N' | b'n') = text.get(from) else { return Some(from) };
    let digits = leading_digits(text.get(from + 1..)?).filter(|digits| *digits > 0)?;
    Some(literal::after_blanks(text, from + 1 + digits))
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
            b'I' => line.about(Axis::X, number.value)?,
            b'J' => line.about(Axis::Y, number.value)?,
            b'G' if number.is_digits(text) => line.code(number.value)?,
            _ => return None,
        }
        Some(number.end)
    }

    fn comment(_: &[u8], _: usize, _: &mut Straight) -> bool {
        false
    }

    fn undo(_: &mut Straight) {}
}

/// What the words of `block` say, if it is a straight one.
#[inline]
pub fn of_block(block: &Block) -> Option<Straight> {
    let mut line = Straight { words: block.span, ..Straight::default() };
    for word in &block.words {
        let (Target::Letter(letter), Value::Literal { value, digits, .. }) = (word.target, word.value) else {
            return None;
        };
        match letter {
            b'F' => line.feed(value)?,
            b'G' if digits > 0 => line.code(value)?,
            b'I' if value.is_finite() => line.about(Axis::X, value)?,
            b'J' if value.is_finite() => line.about(Axis::Y, value)?,
            _ if value.is_finite() => line.go(Axis::of(letter)?, value)?,
            _ => return None,
        }
    }
    let plain = block.skip.is_none() && block.comment.is_none() && block.label.is_none() && block.stmt == Stmt::Words;
    (plain && !line.axes.is_empty()).then_some(line)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::parse_block;
    use super::*;
    use crate::parser::symbols::Symbols;

    proptest! {
        #[test]
        fn a_straight_block_says_what_the_parser_finds(
            head in "([Nn] ?[0-9]{0,9})?[ \t]{0,2}",
            words in prop::collection::vec(
                ("[XYZIJxyzij][+-]?[0-9]{0,8}\\.?[0-9]{0,8}|[Ff][+-]?[0-9]{1,6}|[A-Z][0-9]{0,3}|;|:|X1E5|X1EX2|X=1", "[ \t]{0,2}"),
                0..6,
            ),
            end in prop::sample::select(vec!["\n", "\r\n", "\r", "", "\r\r\n"]),
            rest in "[ -~\n]{0,12}",
            line_end in prop::sample::select(vec![b'\n', b'\r']),
        ) {
            let words: String = words.iter().flat_map(|(word, blank)| [word.as_str(), blank]).collect();
            says_the_same(format!("{head}{words}{end}{rest}").as_bytes(), line_end);
            for g in ["G0 ", "g1 ", "G01 ", "G1", "G2 ", "g03"] {
                says_the_same(format!("{head}{g}{words}{end}{rest}").as_bytes(), line_end);
            }
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
            ("X5 G1\n", Some(6)),
            ("X5 F-1\n", None),
            ("X1EX2\n", None),
            ("X1;\n", None),
        ] {
            assert_eq!(of_line(text.as_bytes(), b'\n').map(|line| line.len), len, "{text:?}");
            says_the_same(text.as_bytes(), b'\n');
        }
    }

    #[test]
    fn a_straight_block_may_name_its_interpolation() {
        for (text, motion) in [
            ("N10 G1 X1 F5\nN20", Some(1)),
            ("g00 z5\r\n", Some(0)),
            ("X1 G01\n", Some(1)),
            ("G1X5\n", Some(1)),
            ("N5 G2 X1 I5 J-3.5\n", Some(2)),
            ("g03X1J0\n", Some(3)),
            ("X1 I2\n", None),
            ("X1\n", None),
        ] {
            assert_eq!(of_line(text.as_bytes(), b'\n').map(|line| line.motion), Some(motion), "{text:?}");
            says_the_same(text.as_bytes(), b'\n');
        }
        for text in [
            "G1 F5\n",
            "G4 X5\n",
            "G2 I5\n",
            "G2 X5 I1 I2\n",
            "G2 X5 K1\n",
            "G2 X5 I=AC(3)\n",
            "G2 X5 CR=9\n",
            "G1 G0 X5\n",
            "G1 G1 X5\n",
            "G1.0 X5\n",
            "G+1 X5\n",
            "G1=1 X5\n",
        ] {
            assert_eq!(of_line(text.as_bytes(), b'\n'), None, "{text:?}");
        }
    }

    fn says_the_same(text: &[u8], line_end: u8) {
        let Some(found) = of_line(text, line_end) else { return };
        let line = &text[..found.len - 1];
        assert_eq!((text[found.len - 1], line.contains(&line_end)), (line_end, false));
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        let (mut block, mut problems) = (Block::default(), Vec::new());
        parse_block(line, &mut block, &mut Symbols::default(), &mut problems);
        assert!(problems.is_empty(), "{problems:?}");
        assert_eq!(Some(Straight { len: 0, ..found }), of_block(&block), "{}", String::from_utf8_lossy(line));
    }
}
