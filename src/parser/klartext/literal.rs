//! The fast path: path blocks whose words are all literals, decoded in one loop over the bytes.
//!
//! For every block it takes it yields exactly what the grammar yields; whatever it does not know it leaves
//! alone. CAM programs consist of such blocks.

use crate::lexer::klartext::Value;
use crate::machine::Axis;
use crate::text::{Span, number::decimal};

use super::ast::{Addr, Block, PathFn, Stmt, Word};

/// Longest literal whose digits need no counting.
const SHORT: usize = 16;

/// Reads the statement at `from` if it is plain; otherwise leaves `block` as it was.
#[inline]
pub fn parse(text: &[u8], from: usize, block: &mut Block) -> bool {
    let (stmt, mut at) = match &text[from..] {
        [b'L', b' ', ..] => (Stmt::Path(PathFn::Line), from + 2),
        [b'C', b'C', b' ', ..] => (Stmt::Pole, from + 3),
        [b'C', b' ', ..] => (Stmt::Path(PathFn::Circle), from + 2),
        _ => return false,
    };
    // A head alone is as long as the head; blanks behind it are not part of the block.
    let mut end = if matches!(stmt, Stmt::Pole) { from + 2 } else { from + 1 };
    let mut first = true;
    loop {
        while let Some(b' ' | b'\t') = text.get(at) {
            at += 1;
        }
        let Some(&letter) = text.get(at) else { break };
        if letter == b';' {
            // The grammar keeps the first comment of the first line; a joined block is left to it.
            if memchr::memchr(b'\n', &text[at..]).is_some() {
                return undo(block);
            }
            block.comment = Some(Span { start: at as u32 + 1, end: text.len() as u32 });
            break;
        }
        let Some((addr, value, next)) = word(text, at, letter) else { return undo(block) };
        // `C 90` is an axis word, and blanks between an address and its number belong to the grammar.
        if first && matches!(value, Value::None) && !matches!(addr, Addr::FeedMax) {
            return undo(block);
        }
        if !matches!(text.get(next), None | Some(b' ' | b'\t' | b';')) {
            return undo(block);
        }
        block.words.push(Word { addr, value, span: Span { start: at as u32, end: next as u32 } });
        first = false;
        at = next;
        end = next;
    }
    block.stmt = stmt;
    block.span = Span { start: from as u32, end: end as u32 };
    true
}

#[cold]
fn undo(block: &mut Block) -> bool {
    block.words.clear();
    block.comment = None;
    false
}

/// The word at `at`: address, value, and where it ends.
#[inline]
fn word(text: &[u8], at: usize, letter: u8) -> Option<(Addr, Value, usize)> {
    let (axis, incremental, value_at) = match letter {
        b'X' => (Axis::X, false, at + 1),
        b'Y' => (Axis::Y, false, at + 1),
        b'Z' => (Axis::Z, false, at + 1),
        b'A' => (Axis::A, false, at + 1),
        b'B' => (Axis::B, false, at + 1),
        b'C' => (Axis::C, false, at + 1),
        b'I' => (Axis::of(*text.get(at + 1)?)?, true, at + 2),
        b'F' => return feed(text, at),
        b'M' => return m_function(text, at),
        b'R' => return compensation(text, at),
        b'D' => {
            return match text.get(at + 1..at + 3)? {
                b"R+" => Some((Addr::TurnPlus, Value::None, at + 3)),
                b"R-" => Some((Addr::TurnMinus, Value::None, at + 3)),
                _ => None,
            };
        }
        _ => return None,
    };
    // An incremental letter in lower case is left to the grammar.
    if incremental && !text[at + 1].is_ascii_uppercase() {
        return None;
    }
    let (value, end) = number(text, value_at)?;
    Some((Addr::Axis { axis, incremental }, Value::Number(value), end))
}

#[inline]
fn number(text: &[u8], at: usize) -> Option<(f64, usize)> {
    let (negative, digits) = match text.get(at)? {
        b'+' => (false, at + 1),
        b'-' => (true, at + 1),
        _ => (false, at),
    };
    let (value, len) = decimal(&text[digits..], true)?;
    if len > SHORT || value > super::LARGEST_WORD {
        return None;
    }
    Some((if negative { -value } else { value }, digits + len))
}

fn feed(text: &[u8], at: usize) -> Option<(Addr, Value, usize)> {
    if text[at..].starts_with(b"FMAX") {
        return Some((Addr::FeedMax, Value::None, at + 4));
    }
    if !text.get(at + 1)?.is_ascii_digit() {
        return None;
    }
    let (value, end) = number(text, at + 1)?;
    Some((Addr::Feed, Value::Number(value), end))
}

fn m_function(text: &[u8], at: usize) -> Option<(Addr, Value, usize)> {
    let digits = text[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    if digits == 0 || digits > 3 {
        return None;
    }
    let number = text[at + 1..at + 1 + digits].iter().fold(0, |n, d| n * 10 + u32::from(d - b'0'));
    Some((Addr::M(number), Value::None, at + 1 + digits))
}

fn compensation(text: &[u8], at: usize) -> Option<(Addr, Value, usize)> {
    match text.get(at + 1)? {
        b'0' => Some((Addr::Radius { signed: false }, Value::Number(0.0), at + 2)),
        b'L' => Some((Addr::CompLeft, Value::None, at + 2)),
        b'R' => Some((Addr::CompRight, Value::None, at + 2)),
        _ => None,
    }
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
    }
}
