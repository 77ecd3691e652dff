//! Straight blocks of Klartext: see [`crate::parser::straight`].

use crate::lexer::klartext::Value;
use crate::machine::Axis;
use crate::parser::literal::{self, Shape};
use crate::parser::straight::{self, Straight};
use crate::text::number::leading_digits;

use super::ast::{Addr, Block, PathFn, Stmt};
use super::literal::{Plain, number};

/// Reads the line at the start of `text`, if it is a straight block.
#[inline(always)]
pub fn of_line(text: &[u8], line_end: u8) -> Option<Straight> {
    let number = literal::after_blanks(text, 0);
    let from = literal::after_blanks(text, number + leading_digits(text.get(number..)?)?);
    if text.get(from..)?.first_chunk() != Some(b"L ") {
        return None;
    }
    straight::read::<Line>(text, from, from + 2, line_end)
}

/// The words of a straight block.
struct Line;

impl Shape for Line {
    type Block = Straight;

    const COMMENT: u8 = Plain::COMMENT;
    const COMMA: bool = Plain::COMMA;
    const GLUED: bool = Plain::GLUED;
    const LONGEST: usize = Plain::LONGEST;

    #[inline(always)]
    fn ends_text(byte: u8) -> bool {
        straight::ends_line(byte)
    }

    #[inline(always)]
    fn word(text: &[u8], at: usize, letter: u8, line: &mut Straight) -> Option<usize> {
        let axis = match letter {
            b'X' => Axis::X,
            b'Y' => Axis::Y,
            b'Z' => Axis::Z,
            _ => return rare_word(text, at, letter, line),
        };
        let (value, end) = number::<Line>(text, at + 1)?;
        line.go(axis, value)?;
        Some(end)
    }

    fn comment(_: &[u8], _: usize, _: &mut Straight) -> bool {
        false
    }

    fn undo(_: &mut Straight) {}
}

/// Feed and R0.
#[inline(never)]
fn rare_word(text: &[u8], at: usize, letter: u8, line: &mut Straight) -> Option<usize> {
    match letter {
        b'F' if text[at..].starts_with(b"FMAX") && literal::ends::<Line>(text, at + 4) => {
            let first = line.feed.is_none() && !std::mem::replace(&mut line.rapid, true);
            first.then_some(at + 4)
        }
        b'F' if text.get(at + 1)?.is_ascii_digit() => {
            let (value, end) = number::<Line>(text, at + 1)?;
            line.feed(value)?;
            Some(end)
        }
        b'R' if text.get(at + 1) == Some(&b'0') && literal::ends::<Line>(text, at + 2) => {
            (!std::mem::replace(&mut line.uncompensated, true)).then_some(at + 2)
        }
        _ => None,
    }
}

/// What the words of `block` say, if it is a straight one.
#[inline]
pub fn of_block(block: &Block) -> Option<Straight> {
    let mut line = Straight { words: block.span, ..Straight::default() };
    for word in &block.words {
        match (word.addr, word.value) {
            (Addr::Axis { axis, incremental: false }, Value::Number(value)) => line.go(axis, value)?,
            (Addr::Feed, Value::Number(value)) => line.feed(value)?,
            (Addr::FeedMax, _) if line.feed.is_none() && !line.rapid => line.rapid = true,
            (Addr::Radius { signed: false }, Value::Number(0.0)) if !line.uncompensated => line.uncompensated = true,
            _ => return None,
        }
    }
    let plain = !block.skip && block.comment.is_none() && matches!(block.stmt, Stmt::Path(PathFn::Line));
    (plain && !line.axes.is_empty()).then_some(line)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::parse_block;
    use super::*;

    proptest! {
        #[test]
        fn a_straight_block_says_what_the_parser_finds(
            head in "[0-9]{0,9}[ \t]{0,2}L ",
            words in prop::collection::vec(
                ("[XYZ][+-]?[0-9]{0,8}[.,]?[0-9]{0,8}|F[0-9]{1,6}|FMAX|R0|[A-Z][0-9]{0,3}| ?;|~|F0|X\\+Q1", "[ \t]{0,2}"),
                0..6,
            ),
            end in prop::sample::select(vec!["\n", "\r\n", "\r", "", "\r\r\n"]),
            rest in "[ -~\n]{0,12}",
            line_end in prop::sample::select(vec![b'\n', b'\r']),
        ) {
            let words: String = words.iter().flat_map(|(word, blank)| [word.as_str(), blank]).collect();
            let text = format!("{head}{words}{end}{rest}");
            says_the_same(text.as_bytes(), line_end);
        }
    }

    #[test]
    fn a_straight_block_ends_with_its_line() {
        for (text, len) in [
            ("10 L X+1.5 Y-2,25 Z45.\n11 L", Some(23)),
            ("L Z-5 R0 FMAX \r\n", Some(16)),
            ("7 L Z-5 F200", None),
            ("7 L F200\n", None),
            ("7 L X5 X6\n", None),
            ("7 L X5 M3\n", None),
            ("7 L X5 ;\n", None),
            ("7 L X5 ~\n", None),
            ("7 L X5\rY6\n", None),
            ("7 L X100000\n", None),
            ("7 L X5 F0\n", None),
            ("7 L X5 F5 FMAX\n", None),
        ] {
            assert_eq!(of_line(text.as_bytes(), b'\n').map(|line| line.len), len, "{text:?}");
            says_the_same(text.as_bytes(), b'\n');
        }
    }

    fn says_the_same(text: &[u8], line_end: u8) {
        let Some(found) = of_line(text, line_end) else { return };
        let line = &text[..found.len - 1];
        assert_eq!((text[found.len - 1], line.contains(&line_end)), (line_end, false));
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        let (mut block, mut problems) = (Block::default(), Vec::new());
        parse_block(line, &mut block, &mut problems);
        assert!(problems.is_empty(), "{problems:?}");
        assert_eq!(Some(Straight { len: 0, ..found }), of_block(&block), "{}", String::from_utf8_lossy(line));
    }
}
