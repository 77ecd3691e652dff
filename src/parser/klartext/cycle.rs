//! The form of CYCL DEF: what stands behind a parameter, and what a `~` joins to a definition.

use std::collections::BTreeSet;

use crate::diag::codes;
use crate::parser::problem::Problem;
use crate::text::{Span, decode::readable};

use super::ast::{Addr, Block, Stmt, Word};
use super::is_blank;

/// A word of a definition that would otherwise be dropped, or that hides a block of its own.
pub(super) fn problem(text: &[u8], block: &Block) -> Option<Problem> {
    let Stmt::Cycle { number, part } = block.stmt else { return None };
    let mut seen = BTreeSet::new();
    let mut last: Option<&Word> = None;
    for word in &block.words {
        let parameter = match word.addr {
            Addr::Assign(q) | Addr::AssignText(q) => Some(q),
            _ => None,
        };
        if begins_line(text, word.span.start) && (parameter.is_none() || part.is_some_and(|part| part > 0)) {
            return Some(dangling(text, word.span.start, &format!("the definition of cycle {number}")));
        }
        match parameter {
            Some(q) if !seen.insert(q) => {
                let shown = readable(word.span.of(text)).into_owned();
                return Some(codes::P1002::sets_second_time_so_remove_one(&shown, &q).among(word.span));
            }
            None if part.is_none() => return Some(behind_value(text, last, word)),
            _ => {}
        }
        last = Some(word);
    }
    None
}

/// Does a physical line of the block, but for the first, begin at this byte?
pub(super) fn begins_line(text: &[u8], at: u32) -> bool {
    let before = text.get(..at as usize).unwrap_or_default();
    before.iter().rev().take_while(|b| is_blank(**b)).any(|b| matches!(b, b'\n' | b'\r'))
}

/// A line that a `~` at the end of the one in front of it has made a part of another block.
pub(super) fn dangling(text: &[u8], at: u32, of: &str) -> Problem {
    let line = text.get(at as usize..).unwrap_or_default();
    let len = line.iter().position(|b| matches!(b, b';' | b'~' | b'\n' | b'\r')).unwrap_or(line.len());
    let span = Span::at(at, line[..len].trim_ascii_end().len() as u32);
    let shown = readable(span.of(text)).into_owned();
    codes::P1003::is_joined_to_line_in_front(&shown, &of).among(span)
}

fn behind_value(text: &[u8], last: Option<&Word>, word: &Word) -> Problem {
    let shown = readable(word.span.of(text)).into_owned();
    let Some(last) = last else {
        return codes::P1003::has_no_place_in_cycle_definition(&shown).among(word.span);
    };
    let value = readable(last.span.of(text)).into_owned();
    codes::P1003::has_no_place_so_cycle_parameter(&shown, &value).among(word.span)
}
