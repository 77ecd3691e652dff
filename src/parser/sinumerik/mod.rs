//! SINUMERIK blocks: skip mark, block number, label and comment by hand, the statement by the grammar,
//! plain blocks of words by a fast loop over the bytes that yields the same.

pub mod ast;
pub mod build;
pub mod literal;
pub mod problem;
pub mod records;
pub mod scan;
pub mod straight;

#[allow(clippy::all, clippy::pedantic, clippy::unwrap_used, unreachable_pub, missing_debug_implementations, unused)]
mod grammar {
    include!(concat!(env!("PARTC_GRAMMARS"), "/sinumerik.rs"));
}

use crate::diag::codes;
use crate::lexer::sinumerik::{Tokens, comment_start};
use crate::parser::problem::{Problem, without_printed_dashes};
use crate::parser::symbols::{Symbol, Symbols};
use crate::text::{Span, SplitRules, decode::readable};

use ast::{Block, Stmt, Target, Value};
use build::Build;

/// A block is a line: nothing joins two of them.
pub const SPLIT: SplitRules = SplitRules { mark: 0xff, continues: |_, _| false };

/// Highest skip level.
const MOST_SKIP: u8 = 9;
/// Longest name of a label.
const MOST_LABEL: usize = 32;

/// Reads one block into `block`; what is wrong with it goes to `problems`. True if the loop over literals took it.
pub fn parse_block(text: &[u8], block: &mut Block, symbols: &mut Symbols, problems: &mut Vec<Problem>) -> bool {
    block.clear();
    if text.first() == Some(&b'%') {
        block.stmt = Stmt::Header;
        block.span = Span { start: 0, end: comment_start(text).unwrap_or(text.len()) as u32 };
        carriage_returns(text, block, problems);
        return false;
    }
    let from = head(text, block, symbols, problems);
    let mut literal = false;
    match text.get(from) {
        None => {}
        Some(b';') => comment(text, from, block),
        Some(_) if literal::parse(text, from, block) => literal = true,
        Some(_) => parse_statement(text, from, block, symbols, problems),
    }
    carriage_returns(text, block, problems);
    literal
}

/// A carriage return alone ends no line in a file with line feeds: what stands on both sides of it must not become one
/// block.
#[inline]
fn carriage_returns(text: &[u8], block: &mut Block, problems: &mut Vec<Problem>) {
    if memchr::memchr(b'\r', text).is_none() {
        return;
    }
    joined_lines(text, block, problems);
    if let Some(comment) = block.comment {
        hidden_block(text, comment, problems);
    }
}

#[cold]
fn joined_lines(text: &[u8], block: &mut Block, problems: &mut Vec<Problem>) {
    let code = &text[..comment_start(text).unwrap_or(text.len())];
    let lead = code.len() - code.trim_ascii_start().len();
    let Some(at) = memchr::memchr(b'\r', code.trim_ascii()).map(|at| lead + at) else { return };
    let next = at + code[at..].iter().take_while(|b| b.is_ascii_whitespace()).count();
    let len = code[next..].iter().take_while(|b| !b.is_ascii_whitespace()).count();
    problems.clear();
    problems
        .push(codes::P1011::carriage_return_without_line_feed_stands_inside().among(Span::at(next as u32, len as u32)));
    block.stmt = Stmt::Bad;
}

/// A carriage return alone does not end a line in a file with line feeds; behind one in a comment a block may
/// stand that some editors show as a line of its own.
#[cold]
fn hidden_block(text: &[u8], comment: Span, problems: &mut Vec<Problem>) {
    let mut start = comment.start;
    for piece in comment.of(text).split(|b| *b == b'\r') {
        let span = Span::at(start, piece.len() as u32);
        start = span.end + 1;
        if span.start != comment.start && reads_as_block(piece) {
            let shown = readable(piece.trim_ascii()).into_owned();
            problems.push(codes::P1010::stands_in_comment_behind_lone_carriage_return(&shown).among(span));
            return;
        }
    }
}

fn reads_as_block(text: &[u8]) -> bool {
    let (mut block, mut problems) = (Block::default(), Vec::new());
    parse_block(text, &mut block, &mut Symbols::default(), &mut problems);
    problems.is_empty() && !matches!(block.stmt, Stmt::Empty | Stmt::Bad | Stmt::Header)
}

/// The comment that starts at `at`.
fn comment(text: &[u8], at: usize, block: &mut Block) {
    block.comment = Some(Span { start: at as u32 + 1, end: text.len() as u32 });
    // The folder of a program in an archive.
    if text[at + 1..].starts_with(b"$PATH=") {
        block.stmt = Stmt::Header;
        block.comment = None;
    }
}

/// Skip mark, block number and label. Returns where the statement starts.
#[inline]
fn head(text: &[u8], block: &mut Block, symbols: &mut Symbols, problems: &mut Vec<Problem>) -> usize {
    let mut at = after_blanks(text, 0);
    if text.get(at) == Some(&b'/') {
        at = skip_level(text, at, block, problems);
    }
    at = match text.get(at) {
        Some(b'N' | b'n') if text.get(after_blanks(text, at + 1)).is_some_and(u8::is_ascii_digit) => {
            number(text, after_blanks(text, at + 1), block)
        }
        Some(b':') if text.get(at + 1).is_some_and(u8::is_ascii_digit) => number(text, at + 1, block),
        _ => at,
    };
    if let Some((end, next)) = label(text, at) {
        block.label = Some(label_name(text, at, end, symbols, problems));
        at = after_blanks(text, next);
    }
    at
}

#[cold]
fn skip_level(text: &[u8], at: usize, block: &mut Block, problems: &mut Vec<Problem>) -> usize {
    let digits = text[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    let end = at + 1 + digits;
    let level = std::str::from_utf8(&text[at + 1..end]).ok().and_then(|digits| digits.parse().ok());
    match level {
        _ if digits == 0 => block.skip = Some(0),
        Some(level) if level <= MOST_SKIP => block.skip = Some(level),
        _ => {
            let span = Span { start: at as u32, end: end as u32 };
            let problem = codes::S1003::there_is_no_such_skip_level().among(span);
            problems.push(problem.alarm(14060).help("skip levels are /0 to /9; `/` alone is /0"));
            block.skip = Some(0);
        }
    }
    after_blanks(text, end)
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

/// A label at `at`: where its name ends, and what stands behind its colon.
#[inline]
fn label(text: &[u8], at: usize) -> Option<(usize, usize)> {
    let first = *text.get(at)?;
    if !(first.is_ascii_alphabetic() || first == b'_') {
        return None;
    }
    let mut end = at + 1;
    while let Some(b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'_') = text.get(end) {
        end += 1;
    }
    let colon = after_blanks(text, end);
    (text.get(colon) == Some(&b':') && end > at + 1 && !is_keyword(&text[at..end])).then_some((end, colon + 1))
}

/// Words that begin or divide statements; no label has such a name.
const KEYWORDS: &[&str] = &[
    "IF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "FOR", "TO", "ENDFOR", "LOOP", "ENDLOOP", "REPEAT", "REPEATB", "UNTIL",
    "GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS", "CASE", "OF", "DEFAULT", "DEF", "REDEF", "PROC", "EXTERN", "DEFINE",
    "CALL", "PCALL", "MCALL", "EXTCALL", "ISOCALL",
];

#[cold]
fn is_keyword(name: &[u8]) -> bool {
    KEYWORDS.iter().any(|keyword| name.eq_ignore_ascii_case(keyword.as_bytes()))
}

#[cold]
fn label_name(text: &[u8], at: usize, end: usize, symbols: &mut Symbols, problems: &mut Vec<Problem>) -> Symbol {
    let name = &text[at..end];
    if name.len() > MOST_LABEL {
        let span = Span { start: at as u32, end: end as u32 };
        problems
            .push(codes::S1014::label_is_longer_than_characters(&readable(name), &MOST_LABEL).among(span).alarm(12420));
    }
    symbols.intern(name)
}

#[inline]
fn after_blanks(text: &[u8], mut at: usize) -> usize {
    while let Some(b' ' | b'\t' | b'\r' | b'\n' | b'&' | 0 | 0x0b | 0x0c | 0x1a) = text.get(at) {
        at += 1;
    }
    at
}

/// Reads the statement by the grammar, whatever it is. The only caller of the generated parser, so that it
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
    let mut build = Build::new(text, block, symbols, problems);
    let result = PARSER.with(|parser| parser.parse(&mut build, &mut tokens));
    block.comment = comment_start(text).map(|at| Span { start: at as u32 + 1, end: text.len() as u32 });
    block.span = Span { start: from as u32, end: tokens.end.max(from as u32) };
    if let Err(error) = result {
        problems.push(problem::of_parse_error(error, text, block.span.start));
        block.stmt = Stmt::Bad;
    } else if let Some(found) = bare_letter(text, block) {
        problems.push(found);
        block.stmt = Stmt::Bad;
    } else if let Some(found) = structure_mark(block) {
        problems.push(found);
    }
}

/// An address without its value, or an `O` that should be a zero.
fn bare_letter(text: &[u8], block: &Block) -> Option<Problem> {
    let word = block.words.iter().find(|word| matches!((word.target, word.value), (Target::Letter(_), Value::None)))?;
    let Target::Letter(letter) = word.target else { return None };
    let letter = letter as char;
    let before = word.span.start.checked_sub(1).and_then(|at| text.get(at as usize));
    if letter == 'O' && before.is_some_and(u8::is_ascii_digit) {
        let problem = codes::P1001::letter_o_stands_behind_digit().among(word.span);
        return Some(problem.alarm(12080).help("write the digit 0"));
    }
    let problem = codes::P1001::address_has_no_value(&letter).among(word.span);
    Some(problem.alarm(12080).help(format!("write it with a number, or as {letter}=formula")))
}

/// A label or skip mark on a line of a control structure.
fn structure_mark(block: &Block) -> Option<Problem> {
    let structure = matches!(
        block.stmt,
        Stmt::If(_)
            | Stmt::Else
            | Stmt::EndIf
            | Stmt::While(_)
            | Stmt::EndWhile
            | Stmt::For { .. }
            | Stmt::EndFor
            | Stmt::Loop
            | Stmt::EndLoop
            | Stmt::RepeatLoop
            | Stmt::Until(_)
    );
    let what = match (block.label, block.skip) {
        _ if !structure => return None,
        (Some(_), _) => "a label",
        (_, Some(_)) => "a skip mark",
        _ => return None,
    };
    let help = if block.label.is_some() { "put the label into the block before" } else { "remove the /" };
    Some(codes::S1004::cannot_stand_in_front_of_control_structure(&what).among(block.span).alarm(12630).help(help))
}
