//! MTC200 blocks: header lines, skip mark, block number and label by hand, the words by the grammar, plain
//! blocks of words by a fast loop over the bytes that yields the same.

pub mod ast;
pub mod build;
pub mod literal;
pub mod problem;

#[allow(clippy::all, clippy::pedantic, clippy::unwrap_used, unreachable_pub, missing_debug_implementations, unused)]
mod grammar {
    include!(concat!(env!("PARTC_GRAMMARS"), "/mtc200.rs"));
}

use crate::diag::codes;
use crate::lexer::mtc200::Tokens;
use crate::parser::problem::{Problem, without_printed_dashes};
use crate::parser::symbols::Symbols;
use crate::text::{Span, SplitRules};

use ast::{Block, Stmt};
use build::Build;

/// A block is a line: nothing joins two of them. No line needs a closer look but one with a stray NUL.
pub const SPLIT: SplitRules = SplitRules { mark: 0, continues: |_, _| false };

/// Reads one block into `block`; what is wrong with it goes to `problems`. True if the loop over literals took it.
pub fn parse_block(text: &[u8], block: &mut Block, symbols: &mut Symbols, problems: &mut Vec<Problem>) -> bool {
    block.clear();
    if let Some(at) = stray_break(text) {
        let lead = text[at..].iter().take_while(|b| b.is_ascii_whitespace() || **b == 0).count();
        let span = Span { start: (at + lead) as u32, end: text.trim_ascii_end().len() as u32 };
        problems.push(codes::P1011::line_break_stands_inside_of_block().among(span));
        block.stmt = Stmt::Bad;
        block.span = Span { start: 0, end: text.trim_ascii_end().len() as u32 };
        return false;
    }
    if let Some(&first @ (b'%' | b'!' | b'#' | b'$' | b'*')) = text.first() {
        block.stmt = Stmt::Header(first);
        block.span = Span { start: 0, end: text.trim_ascii_end().len() as u32 };
        return false;
    }
    let from = head(text, block, symbols);
    if from >= text.len() {
        block.span = Span { start: 0, end: from as u32 };
        return false;
    }
    let literal = literal::parse(text, from, block);
    if !literal {
        parse_statement(text, from, block, symbols, problems);
    }
    literal
}

/// A carriage return or line feed with something behind it.
#[inline]
fn stray_break(text: &[u8]) -> Option<usize> {
    let at = memchr::memchr2(b'\r', b'\n', text)?;
    let blank = |b: &u8| b.is_ascii_whitespace() || matches!(b, 0 | 0x0b | 0x1a);
    (!text[at..].iter().all(blank)).then_some(at)
}

/// Skip mark, block number and label. Returns where the words start.
#[inline]
fn head(text: &[u8], block: &mut Block, symbols: &mut Symbols) -> usize {
    let mut at = after_blanks(text, 0);
    if text.get(at) == Some(&b'/') {
        block.skip = true;
        at = after_blanks(text, at + 1);
    }
    if let Some(b'N' | b'n') = text.get(at)
        && text.get(after_blanks(text, at + 1)).is_some_and(u8::is_ascii_digit)
    {
        at = number(text, after_blanks(text, at + 1), block);
    }
    if text.get(at) == Some(&b'.') && text.get(at + 1).is_some_and(u8::is_ascii_alphabetic) {
        at = label(text, at + 1, block, symbols);
    }
    at
}

#[inline]
fn number(text: &[u8], mut at: usize, block: &mut Block) -> usize {
    let mut number = 0u32;
    while let Some(digit @ b'0'..=b'9') = text.get(at) {
        number = number.saturating_mul(10).saturating_add(u32::from(digit - b'0'));
        at += 1;
    }
    block.number = Some(number);
    after_blanks(text, at)
}

#[cold]
fn label(text: &[u8], at: usize, block: &mut Block, symbols: &mut Symbols) -> usize {
    let len = text[at..].iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
    block.label = Some(symbols.intern(&text[at..at + len]));
    after_blanks(text, at + len)
}

#[inline]
fn after_blanks(text: &[u8], mut at: usize) -> usize {
    while let Some(b' ' | b'\t' | b'\r' | 0 | 0x0b | 0x0c | 0x1a) = text.get(at) {
        at += 1;
    }
    at
}

/// Reads the words by the grammar, whatever they are. The only caller of the generated parser, so that it
/// is compiled once.
pub fn parse_statement(
    text: &[u8],
    from: usize,
    block: &mut Block,
    symbols: &mut Symbols,
    problems: &mut Vec<Problem>,
) {
    thread_local! {
        static PARSER: grammar::BlockParser = grammar::BlockParser::new();
    }
    let repaired = without_printed_dashes(text, from, codes::P0011, problems);
    let text = repaired.as_deref().unwrap_or(text);
    let mut tokens = Tokens::new(text, from);
    let mut build = Build::new(text, block, symbols);
    let result = PARSER.with(|parser| parser.parse(&mut build, &mut tokens));
    block.comments.append(&mut tokens.comments);
    block.span = Span { start: from as u32, end: tokens.end.max(from as u32) };
    match result {
        Ok(()) if block.words.is_empty() => block.stmt = Stmt::Empty,
        Ok(()) => block.stmt = Stmt::Words,
        Err(error) => {
            problems.push(problem::of_parse_error(error, text, block.span.start));
            block.stmt = Stmt::Bad;
        }
    }
}

/// The label that a block sets, and its place in the block; looks at the first bytes only.
pub fn label_of(text: &[u8], symbols: &mut Symbols) -> Option<(crate::parser::symbols::Symbol, Span)> {
    let from = memchr::memchr(b'.', text)?;
    if !text[..from].iter().all(|b| b.is_ascii_digit() || b.is_ascii_whitespace() || b"/Nn\x00\x0b\x1a".contains(b)) {
        return None;
    }
    let mut block = Block::default();
    head(text, &mut block, symbols);
    let label = block.label?;
    Some((label, Span::at(from as u32, 1 + symbols.name(label).len() as u32)))
}
