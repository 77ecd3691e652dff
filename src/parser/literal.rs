//! The fast path of every dialect: blocks whose words are all literals, decoded in one loop over the bytes.
//!
//! For every block it takes it yields exactly what the grammar yields; whatever it does not know it leaves alone. CAM
//! programs consist of such blocks. Property tests and fuzz targets of each dialect hold both ways equal.

use crate::text::number::decimal;

/// How plain words of one dialect look.
pub(super) trait Shape {
    type Block;

    /// Begins a comment that goes on to the end of the block.
    const COMMENT: u8;
    /// Numbers may have a comma for a point.
    const COMMA: bool = false;
    /// A letter may follow a number at once: `G1X5`.
    const GLUED: bool = true;
    /// Longest literal; a longer one is left to the grammar.
    const LONGEST: usize = usize::MAX;

    /// Does the text go on with another block behind this byte?
    #[inline(always)]
    fn ends_text(_byte: u8) -> bool {
        false
    }

    /// Adds the word at `at`, which begins with `letter`; where it ends.
    fn word(text: &[u8], at: usize, letter: u8, block: &mut Self::Block) -> Option<usize>;

    /// Takes the comment that begins at `at`, if it is a plain one.
    fn comment(text: &[u8], at: usize, block: &mut Self::Block) -> bool;

    /// Takes back what [`Shape::word`] and [`Shape::comment`] did.
    fn undo(block: &mut Self::Block);
}

/// A number with its sign.
#[derive(Debug, Clone, Copy)]
pub(super) struct Literal {
    pub value: f64,
    pub signed: bool,
    /// First byte behind the sign.
    pub from: usize,
    /// Behind the last digit or point.
    pub end: usize,
}

impl Literal {
    /// Digits and nothing else: neither point nor sign.
    pub fn is_digits(&self, text: &[u8]) -> bool {
        !self.signed && self.is_whole(text)
    }

    /// Without a point.
    pub fn is_whole(&self, text: &[u8]) -> bool {
        !text[self.from..self.end].contains(&b'.')
    }
}

/// Reads the words at `at`, whose last one ends there or behind `end`; where that is, and where the text ends that may be
/// words. `None` where something else than plain words stands: then `block` is as it was.
#[inline(always)]
pub(super) fn words<S: Shape>(
    text: &[u8],
    mut at: usize,
    mut end: usize,
    block: &mut S::Block,
) -> Option<(usize, usize)> {
    loop {
        at = after_blanks(text, at);
        let Some(&letter) = text.get(at) else { return Some((end, at)) };
        if S::ends_text(letter) {
            return Some((end, at));
        }
        if letter == S::COMMENT {
            if S::comment(text, at, block) {
                return Some((end, at));
            }
            break;
        }
        match S::word(text, at, letter, block) {
            Some(next) => (at, end) = (next, next),
            None => break,
        }
    }
    give_up::<S>(block)
}

/// Where the blanks at `at` end. Mostly there is one of them, or none.
#[inline(always)]
pub(super) fn after_blanks(text: &[u8], at: usize) -> usize {
    let next = at + usize::from(text.get(at) == Some(&b' '));
    match text.get(next) {
        Some(&byte) if byte <= b' ' && matches!(byte, b' ' | b'\t') => after_more_blanks(text, next),
        _ => next,
    }
}

#[inline(never)]
fn after_more_blanks(text: &[u8], at: usize) -> usize {
    let blanks = text.get(at..).unwrap_or_default().iter().take_while(|byte| matches!(byte, b' ' | b'\t'));
    at + blanks.count()
}

#[cold]
fn give_up<S: Shape>(block: &mut S::Block) -> Option<(usize, usize)> {
    S::undo(block);
    None
}

/// The number at `at`, if a plain word may end behind it.
#[inline(always)]
pub(super) fn number<S: Shape>(text: &[u8], at: usize) -> Option<Literal> {
    let (signed, negative) = match text.get(at)? {
        b'-' => (true, true),
        b'+' => (true, false),
        _ => (false, false),
    };
    let from = at + usize::from(signed);
    let (value, len) = decimal(text.get(from..)?, S::COMMA)?;
    let end = from + len;
    if len > S::LONGEST || !ends::<S>(text, end) {
        return None;
    }
    Some(Literal { value: if negative { -value } else { value }, signed, from, end })
}

/// May a plain word end in front of `at`?
#[inline(always)]
pub(super) fn ends<S: Shape>(text: &[u8], at: usize) -> bool {
    match text.get(at) {
        None | Some(b' ' | b'\t') => true,
        Some(&byte) => byte == S::COMMENT || S::GLUED && byte.is_ascii_alphabetic() || S::ends_text(byte),
    }
}
