//! Plain words of Klartext: see [`crate::parser::literal`].

use crate::lexer::klartext::Value;
use crate::machine::Axis;
use crate::parser::literal::{self, Shape};
use crate::text::Span;

use super::ast::{Addr, Block, PathFn, Stmt, Word};

/// Reads the statement at `from` if it is plain; otherwise leaves `block` as it was.
#[inline]
pub fn parse(text: &[u8], from: usize, block: &mut Block) -> bool {
    let (stmt, at) = match &text[from..] {
        [b'L', b' ', ..] => (Stmt::Path(PathFn::Line), from + 2),
        [b'C', b'C', b' ', ..] => (Stmt::Pole, from + 3),
        [b'C', b' ', ..] => (Stmt::Path(PathFn::Circle), from + 2),
        _ => return false,
    };
    // A head alone is as long as the head; blanks behind it are not part of the block.
    let Some((end, _)) = literal::words::<Plain>(text, at, at - 1, block) else { return false };
    block.stmt = stmt;
    block.span = Span { start: from as u32, end: end as u32 };
    true
}

pub(super) struct Plain;

impl Shape for Plain {
    type Block = Block;

    const COMMENT: u8 = b';';
    const COMMA: bool = true;
    const GLUED: bool = false;
    const LONGEST: usize = super::MOST_DIGITS;

    #[inline]
    fn word(text: &[u8], at: usize, letter: u8, block: &mut Block) -> Option<usize> {
        let (axis, incremental) = match letter {
            b'X' => (Axis::X, false),
            b'Y' => (Axis::Y, false),
            b'Z' => (Axis::Z, false),
            b'A' => (Axis::A, false),
            b'B' => (Axis::B, false),
            b'C' => (Axis::C, false),
            // A letter in lower case is left to the grammar.
            b'I' => (text.get(at + 1).filter(|b| b.is_ascii_uppercase()).and_then(|b| Axis::of(*b))?, true),
            _ => return other_word(text, at, letter, block),
        };
        let (value, end) = number::<Plain>(text, at + 1 + usize::from(incremental))?;
        Some(add(block, Addr::Axis { axis, incremental }, Value::Number(value), at, end))
    }

    fn comment(text: &[u8], at: usize, block: &mut Block) -> bool {
        block.comment = Some(Span { start: at as u32 + 1, end: text.len() as u32 });
        // The grammar keeps the first comment of the first line; a joined block is left to it.
        memchr::memchr(b'\n', &text[at..]).is_none()
    }

    fn undo(block: &mut Block) {
        block.words.clear();
        block.comment = None;
    }
}

#[inline]
fn add(block: &mut Block, addr: Addr, value: Value, at: usize, end: usize) -> usize {
    block.words.push(Word { addr, value, span: Span { start: at as u32, end: end as u32 } });
    end
}

#[inline(always)]
pub(super) fn number<S: Shape>(text: &[u8], at: usize) -> Option<(f64, usize)> {
    let number = literal::number::<S>(text, at)?;
    (number.value.abs() <= super::LARGEST_WORD).then_some((number.value, number.end))
}

/// Feed, M functions, compensation and direction.
fn other_word(text: &[u8], at: usize, letter: u8, block: &mut Block) -> Option<usize> {
    let rest = &text[at..];
    let (addr, value, end) = match letter {
        b'F' if rest.starts_with(b"FMAX") => (Addr::FeedMax, Value::None, at + 4),
        b'F' if rest.get(1)?.is_ascii_digit() => {
            let (value, end) = number::<Plain>(text, at + 1)?;
            (Addr::Feed, Value::Number(value), end)
        }
        b'M' => m_function(text, at)?,
        b'R' => match rest.get(1)? {
            b'0' => (Addr::Radius { signed: false }, Value::Number(0.0), at + 2),
            b'L' => (Addr::CompLeft, Value::None, at + 2),
            b'R' => (Addr::CompRight, Value::None, at + 2),
            _ => return None,
        },
        b'D' => match rest.get(1..3)? {
            b"R+" => (Addr::TurnPlus, Value::None, at + 3),
            b"R-" => (Addr::TurnMinus, Value::None, at + 3),
            _ => return None,
        },
        _ => return None,
    };
    // `C 90` is an axis word: a block that begins with a word without a number belongs to the grammar.
    let first = block.words.is_empty() && matches!(value, Value::None) && !matches!(addr, Addr::FeedMax);
    if first || !literal::ends::<Plain>(text, end) {
        return None;
    }
    Some(add(block, addr, value, at, end))
}

fn m_function(text: &[u8], at: usize) -> Option<(Addr, Value, usize)> {
    let digits = text[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    if digits == 0 || digits > 3 {
        return None;
    }
    let number = text[at + 1..at + 1 + digits].iter().fold(0, |n, d| n * 10 + u32::from(d - b'0'));
    Some((Addr::M(number), Value::None, at + 1 + digits))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parser::klartext::parse_statement;
    use crate::parser::problem::Problem;
    use proptest::prelude::*;

    fn both(text: &[u8]) -> (bool, Block, Block, Vec<Problem>) {
        let (mut fast, mut slow) = (Block::default(), Block::default());
        let mut problems = Vec::new();
        let taken = parse(text, 0, &mut fast);
        parse_statement(text, 0, &mut slow, &mut problems);
        (taken, fast, slow, problems)
    }

    #[test]
    fn plain_blocks_are_taken() {
        for text in [
            "L X+1.5 Y-2,25 Z45. R0 FMAX M3",
            "L IX-.5 C+90 F2000 M90 ; comment",
            "CC X+1.2105 IY-1.2764",
            "C X+1.2919 Y-0.6434 DR+ M90  ",
            "L Z+50 R0 FMAX M3 M8",
        ] {
            let (taken, fast, slow, problems) = both(text.as_bytes());
            assert!(taken, "{text}");
            assert_eq!(fast, slow, "{text}");
            assert!(problems.is_empty(), "{text}: {problems:?}");
        }
    }

    #[test]
    fn other_blocks_are_left_alone() {
        for text in ["L X+Q1", "L X 5", "C 90", "LP PR+5", "L R F M", "L X+12345678901234567890", "L X1Y2", "L x+5"] {
            let (taken, fast, _, _) = both(text.as_bytes());
            assert!(!taken && fast == Block::default(), "{text}");
        }
    }

    proptest! {
        #[test]
        fn fast_path_equals_grammar(
            head in prop::sample::select(vec!["L ", "C ", "CC ", "L  "]),
            words in prop::collection::vec(prop::sample::select(vec![
                "X+1", "Y-2.5", "Z.5", "IZ-1,25", "C+90", "A1", "R0", "RL", "RR", "R", "FMAX", "F500", "F1.5", "F", "M3", "M08",
                "M128.", "DR+", "DR-", "X", "Q1", "R+5", "X+Q1", "I", "IX5", "Y 7", ";note", "X5Y6", "~", "B-0", "F AUTO", "ix+1",
                "R0.5", "DR+0.5", "Z1234567890123", "F-5", "M1000", "X+99999.9999", "Y-100000", "F100000", "DR +", "\r",
            ]), 0..6),
            gap in prop::sample::select(vec![" ", "  ", "\t"]),
        ) {
            let text = format!("{head}{}", words.join(gap));
            let (taken, fast, slow, problems) = both(text.as_bytes());
            if taken {
                prop_assert_eq!(fast, slow, "{}", text);
                prop_assert!(problems.is_empty(), "{}: {:?}", text, problems);
            } else {
                prop_assert_eq!(fast, Block::default(), "{}", text);
            }
        }

        #[test]
        fn fast_path_equals_grammar_for_all_letters(
            head in prop::sample::select(vec!["L ", "C ", "CC "]),
            words in prop::collection::vec(r"I?[A-Z][+-]?[0-9]{0,17}([.,][0-9]{0,9})?[ \t;]{0,2}", 0..5),
        ) {
            let text = format!("{head}{}", words.concat());
            let (taken, fast, slow, problems) = both(text.as_bytes());
            if taken {
                prop_assert_eq!(fast, slow, "{}", text);
                prop_assert!(problems.is_empty(), "{}: {:?}", text, problems);
            } else {
                prop_assert_eq!(fast, Block::default(), "{}", text);
            }
        }
    }
}
