//! Klartext blocks: number, skip mark, comment and structure marks by hand, the statement by the grammar,
//! plain path blocks by a fast loop over the bytes that yields the same.

pub mod ast;
pub mod build;
mod cycle;
pub mod literal;
pub mod problem;
pub mod straight;

pub use problem::misprinted;

#[allow(clippy::all, clippy::pedantic, clippy::unwrap_used, unreachable_pub, missing_debug_implementations, unused)]
mod grammar {
    include!(concat!(env!("PARTC_GRAMMARS"), "/klartext.rs"));
}

use crate::diag::codes;
use crate::lexer::klartext::{Tokens, Value};
use crate::text::{Span, SplitRules, decode::readable};

use crate::parser::problem::{Problem, without_printed_dashes};
use ast::{Addr, Block, Op, Stmt};
use build::Build;

/// Largest literal of a formula or a cycle parameter.
const LARGEST: f64 = 1e9;
/// Largest literal of a position, a radius, an angle or a spindle speed (K 1.2).
pub const LARGEST_WORD: f64 = 99_999.999_9;
/// Highest number of an M function.
pub const MOST_M: u32 = 999;
/// Most digits of a literal.
const MOST_DIGITS: usize = 16;

/// How Klartext joins lines: by a `~` at the end, or in front of the comment.
pub const SPLIT: SplitRules = SplitRules { mark: b'~', continues };

fn continues(line: &[u8], _: bool) -> bool {
    let mut quoted = false;
    let comment = line.iter().position(|b| {
        quoted ^= *b == b'"';
        *b == b';' && !quoted
    });
    let code = line[..comment.unwrap_or(line.len())].trim_ascii_end();
    // Where a block holds nothing but a comment, it is the text that goes on.
    code.ends_with(b"~") || line.trim_ascii_end().ends_with(b"~")
}

/// What stands in front of the statement.
#[derive(Debug, Clone, Copy, Default)]
struct Head {
    number: Option<u32>,
    skip: bool,
    /// First byte of the statement.
    from: usize,
}

#[inline]
fn head(text: &[u8]) -> Head {
    let mut head = Head::default();
    let mut rest = after_blanks(text);
    if let [b'/', tail @ ..] = rest {
        head.skip = true;
        rest = after_blanks(tail);
    }
    let digits = match rest {
        [b'N' | b'n', tail @ ..] => tail,
        _ => rest,
    };
    if let [b'0'..=b'9', ..] = digits {
        let mut number = 0u32;
        rest = digits;
        while let [digit @ b'0'..=b'9', tail @ ..] = rest {
            number = number.saturating_mul(10).saturating_add(u32::from(digit - b'0'));
            rest = tail;
        }
        head.number = Some(number);
        rest = after_blanks(rest);
        if let [b'/', tail @ ..] = rest {
            head.skip = true;
            rest = after_blanks(tail);
        }
    }
    head.from = text.len() - rest.len();
    head
}

#[inline]
fn after_blanks(mut text: &[u8]) -> &[u8] {
    while let [byte, rest @ ..] = text {
        if !is_blank(*byte) {
            break;
        }
        text = rest;
    }
    text
}

fn is_blank(b: u8) -> bool {
    matches!(b, b' ' | b'\t' | b'\r' | b'\n' | 0 | 0x0b | 0x0c | 0x1a)
}

/// Reads one logical block into `block`; what is wrong with it goes to `problems`. True if the loop over literals took it.
pub fn parse_block(text: &[u8], block: &mut Block, problems: &mut Vec<Problem>) -> bool {
    block.clear();
    let head = head(text);
    block.number = head.number;
    block.skip = head.skip;
    let Some(&first) = text.get(head.from) else { return false };
    let mut literal = false;
    match first {
        // A remark, a heading, or a line of a set-up sheet.
        b';' | b'*' | b'(' => whole_comment(text, head.from + 1, block, problems),
        _ if literal::parse(text, head.from, block) => literal = true,
        _ => parse_statement(text, head.from, block, problems),
    }
    if block.comment.is_some() && memchr::memchr(b'\r', text).is_some() {
        hidden_block(text, problems);
    }
    literal
}

/// A carriage return alone does not end a line in a file with line feeds; behind one in a comment a block may
/// stand that some editors show as a line of its own.
#[cold]
fn hidden_block(text: &[u8], problems: &mut Vec<Problem>) {
    let mut line = 0;
    for (at, byte) in text.iter().enumerate() {
        if *byte == b'\n' {
            line = at + 1;
        }
        if *byte != b'\r' || matches!(text.get(at + 1), None | Some(b'\n')) {
            continue;
        }
        let rest = &text[at + 1..];
        let rest = &rest[..rest.iter().position(|b| matches!(b, b'\r' | b'\n')).unwrap_or(rest.len())];
        let in_comment = text[line..at].iter().any(|b| matches!(b, b';' | b'*' | b'('));
        if in_comment && reads_as_block(rest) {
            let lead = rest.iter().take_while(|b| is_blank(**b)).count();
            let end = rest.iter().rposition(|b| !is_blank(*b)).map_or(lead, |last| last + 1);
            let span = Span::at((at + 1 + lead) as u32, (end - lead) as u32);
            let block = readable(span.of(text)).into_owned();
            problems.push(codes::P1010::stands_in_comment_behind_lone_carriage_return(&block).among(span));
            return;
        }
    }
}

fn reads_as_block(text: &[u8]) -> bool {
    let (mut block, mut problems) = (Block::default(), Vec::new());
    parse_block(text, &mut block, &mut problems);
    problems.is_empty() && is_whole(&block)
}

/// Is the block one that a control would take, with no word in it that belongs to a sentence?
fn is_whole(block: &Block) -> bool {
    let text = |word: &ast::Word| matches!(word.addr, Addr::Name | Addr::Text);
    let stray = |word: &ast::Word| text(word) || word.addr == Addr::Value;
    match block.stmt {
        Stmt::Empty | Stmt::Bad | Stmt::Iso => false,
        Stmt::Path(_) => !block.words.is_empty() && !block.words.iter().any(stray),
        Stmt::Paraxial | Stmt::Functions | Stmt::Stop | Stmt::Pole => !block.words.iter().any(stray),
        Stmt::Rounding | Stmt::Chamfer => !block.words.is_empty() && !block.words.iter().any(text),
        _ => true,
    }
}

/// A block that is nothing but a comment: a `~` at the end of a line lets the text go on in the next one. What stands
/// there is text; where it reads as a block all the same, the `~` may be decoration.
fn whole_comment(text: &[u8], start: usize, block: &mut Block, problems: &mut Vec<Problem>) {
    block.comment = Some(Span { start: start as u32, end: text.len() as u32 });
    let mut at = start;
    while let Some(feed) = memchr::memchr(b'\n', &text[at..]) {
        at += feed + 1;
        let line = &text[at..];
        let line = &line[..memchr::memchr(b'\n', line).unwrap_or(line.len())];
        let line = line.trim_ascii_end();
        let line = line.strip_suffix(b"~").unwrap_or(line);
        if reads_as_block(line) {
            let lead = line.len() - line.trim_ascii_start().len();
            let span = Span::at((at + lead) as u32, line.trim_ascii().len() as u32);
            let shown = readable(span.of(text)).into_owned();
            problems.push(codes::K1850::is_text_of_comment_before(&shown).among(span));
            return;
        }
    }
}

/// Reads the statement by the grammar, whatever it is. The only caller of the generated parser, so that it
/// is compiled once.
pub fn parse_statement(text: &[u8], from: usize, block: &mut Block, problems: &mut Vec<Problem>) {
    thread_local! {
        static PARSER: grammar::BlockParser = grammar::BlockParser::new();
    }
    let repaired = without_printed_dashes(text, from, codes::P0011, problems);
    let text = repaired.as_deref().unwrap_or(text);
    let mut tokens = Tokens::new(text, from);
    let mut build = Build::new(text, block);
    let result = PARSER.with(|parser| parser.parse(&mut build, &mut tokens));
    let misspelled = build.misspelled;
    block.comment = tokens.comment;
    block.span = Span { start: from as u32, end: tokens.end.max(from as u32) };
    if let Err(error) = result {
        problems.push(problem::of_parse_error(error, text, block.span.start));
        block.stmt = Stmt::Bad;
        return;
    }
    if misspelled {
        problems.push(codes::K1003::cycle_is_read_as_cycl().among(block.span));
    }
    let problem = number_problem(text, block).or_else(|| return_problem(text, block));
    if let Some(problem) = problem.or_else(|| cycle::problem(text, block)) {
        problems.push(problem);
        block.stmt = Stmt::Bad;
    }
}

/// A carriage return between two words: two lines whose end was damaged, which must not become one block.
fn return_problem(text: &[u8], block: &Block) -> Option<Problem> {
    let code = text.get(..block.span.end as usize)?;
    let mut at = 0;
    while let Some(found) = memchr::memchr(b'\r', code.get(at..)?) {
        at += found + 1;
        let line = code[..at - 1].iter().rposition(|b| *b == b'\n').map_or(0, |feed| feed + 1);
        let commented = code[line..at - 1].contains(&b';');
        if !matches!(code.get(at), None | Some(b'\n')) && !commented {
            let word = code[at..].iter().take_while(|b| !is_blank(**b)).count();
            let span = Span::at(at as u32, word.max(1) as u32);
            return Some(codes::P0010::carriage_return_without_line_feed_stands_inside().among(span));
        }
    }
    None
}

/// Literals that no control accepts.
fn number_problem(text: &[u8], block: &Block) -> Option<Problem> {
    let too_large = |value: f64| value.abs() > LARGEST;
    let bad = |span| codes::K0003::number_is_out_of_range().among(span);
    for word in &block.words {
        if matches!(word.value, Value::Number(n) if too_large(n)) {
            return Some(bad(word.span));
        }
        if matches!(word.value, Value::Number(n) if n.abs() > LARGEST_WORD) && is_narrow(word.addr) {
            let shown = readable(word.span.of(text)).into_owned();
            return Some(codes::K0003::is_beyond_input_range_of_control(&shown).among(word.span));
        }
        if matches!(word.addr, Addr::M(n) if n > MOST_M) {
            return Some(codes::K0003::m_function_number_is_out_of_range().among(word.span));
        }
    }
    if block.ops.iter().any(|op| matches!(op, Op::Number(n) if too_large(*n))) {
        return Some(bad(block.span));
    }
    if matches!(block.stmt, Stmt::Begin { .. } | Stmt::End { .. } | Stmt::Refused(..) | Stmt::FnOther { .. }) {
        return None;
    }
    longest_number(block.span.of(text)).map(|(start, len)| bad(Span::at(block.span.start + start as u32, len as u32)))
}

/// Words whose literals the control takes up to [`LARGEST_WORD`]. Real programs write feeds beyond the printed range,
/// and a control runs them at its highest feed.
fn is_narrow(addr: Addr) -> bool {
    matches!(
        addr,
        Addr::Axis { .. }
            | Addr::PolarRadius { .. }
            | Addr::PolarAngle { .. }
            | Addr::Radius { .. }
            | Addr::Speed
            | Addr::Length
            | Addr::DeltaLength
            | Addr::DeltaRadius
            | Addr::DeltaRadius2
    )
}

/// A run of digits longer than a literal may be, outside texts and comments.
fn longest_number(code: &[u8]) -> Option<(usize, usize)> {
    let mut start = None;
    let mut quoted = false;
    for (at, b) in code.iter().chain(b" ").enumerate() {
        quoted ^= *b == b'"';
        if !quoted && (b.is_ascii_digit() || (start.is_some() && matches!(b, b'.' | b','))) {
            start.get_or_insert(at);
        } else if let Some(from) = start.take()
            && code[from..at].iter().filter(|b| b.is_ascii_digit()).count() > MOST_DIGITS
        {
            return Some((from, at - from));
        }
        if *b == b';' && !quoted {
            return None;
        }
    }
    None
}
