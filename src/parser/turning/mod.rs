//! HEIDENHAIN turning blocks: number, skip mark, section codes and comments by hand, the statement by the grammar,
//! plain blocks of words by a fast loop over the bytes that yields the same.

pub mod ast;
pub mod build;
pub mod literal;
pub mod problem;
pub mod sections;

#[allow(clippy::all, clippy::pedantic, clippy::unwrap_used, unreachable_pub, missing_debug_implementations, unused)]
mod grammar {
    include!(concat!(env!("PARTC_GRAMMARS"), "/turning.rs"));
}

use crate::diag::codes;
use crate::lexer::turning::Tokens;
use crate::parser::problem::{Problem, without_printed_dashes};
use crate::text::{Span, SplitRules, decode::readable};

use ast::{Block, Stmt};
use build::Build;

/// A block is a line: nothing joins two of them, so the mark is a byte that no program has.
pub const SPLIT: SplitRules = SplitRules { mark: 0, continues: |_, _| false };

/// Reads one block into `block`; what is wrong with it goes to `problems`. True if the loop over literals took it.
pub fn parse_block(text: &[u8], block: &mut Block, problems: &mut Vec<Problem>) -> bool {
    block.clear();
    if memchr::memchr(b'\r', text).is_some() && lone_return(text, block, problems) {
        return false;
    }
    let from = after_blanks(text, 0);
    match text.get(from) {
        Some(b'%') => {
            program_name(text, from, block);
            return false;
        }
        Some(b'#') if head_line(text, from, block) => return false,
        _ => {}
    }
    let from = head(text, from, block);
    let Some(&first) = text.get(from) else { return false };
    if first == b'[' {
        comment(text, from, block, problems);
        return false;
    }
    if literal::parse(text, from, block) {
        if let Some(at) = block.comment.take() {
            comment(text, at.start as usize, block, problems);
        }
        return true;
    }
    let end = code_end(text);
    if end < text.len() {
        comment(text, end, block, problems);
    }
    if block.stmt != Stmt::Bad && !by_first_word(text, from, end, block) {
        parse_statement(&text[..end], from, block, problems);
    }
    false
}

/// A carriage return alone does not end a line in a file with line feeds: what follows it looks like a line of its own.
#[cold]
fn lone_return(text: &[u8], block: &mut Block, problems: &mut Vec<Problem>) -> bool {
    let hidden = |at: &usize| text[*at] == b'\r' && after_blanks(text, *at) < text.len();
    let Some(at) = (0..text.len()).find(hidden) else { return false };
    let start = after_blanks(text, at);
    let len = text[start..].iter().position(|b| *b == b'\r').unwrap_or(text.len() - start);
    let span = Span::at(start as u32, text[start..start + len].trim_ascii_end().len() as u32);
    problems.push(codes::P1011::stands_behind_lone_carriage_return(&readable(span.of(text))).among(span));
    block.span = span;
    block.stmt = Stmt::Bad;
    true
}

/// `%name.nc`
fn program_name(text: &[u8], from: usize, block: &mut Block) {
    let end = code_end(text);
    let name = text[from..end.max(from)].trim_ascii_end();
    block.span = Span::at(from as u32, name.len() as u32);
    block.stmt = Stmt::Program(Span { start: block.span.start + 1, ..block.span });
}

/// `#KEY value`: at least two letters behind the `#`, and no `=`.
fn head_line(text: &[u8], from: usize, block: &mut Block) -> bool {
    let key = &text[from + 1..];
    let len = key.iter().take_while(|b| b.is_ascii_alphabetic() || matches!(b, b'_' | b'.' | b'-')).count();
    let rest = from + 1 + len;
    let argument = key.starts_with(b"__") || text.get(rest).is_some_and(u8::is_ascii_digit);
    if len < 2 || argument || text.get(after_blanks(text, rest)) == Some(&b'=') {
        return false;
    }
    let end = text.trim_ascii_end().len();
    let value = after_blanks(text, rest).min(end);
    let span = |start: usize, end: usize| Span { start: start as u32, end: end as u32 };
    block.span = span(from, end);
    block.stmt = Stmt::Head { key: span(from + 1, rest), value: span(value, end) };
    true
}

/// Skip mark and block number. Returns where the statement starts.
#[inline]
fn head(text: &[u8], mut at: usize, block: &mut Block) -> usize {
    if text.get(at) == Some(&b'/') {
        let level = text.get(at + 1).filter(|b| b.is_ascii_digit());
        block.skip = Some(level.map_or(0, |b| b - b'0'));
        at = after_blanks(text, at + 1 + usize::from(level.is_some()));
    }
    if text.get(at) == Some(&b'$') {
        at = slides(text, at, block);
    }
    if let Some(b'N' | b'n') = text.get(at) {
        let digits = after_blanks(text, at + 1);
        if text.get(digits).is_some_and(u8::is_ascii_digit) {
            at = number(text, digits, block);
        }
    }
    at
}

/// `$1` in front of the rest of a block; alone in its block it is a statement.
#[cold]
fn slides(text: &[u8], mut at: usize, block: &mut Block) -> usize {
    while text.get(at) == Some(&b'$') {
        let digits = text[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
        let behind = after_blanks(text, at + 1 + digits);
        if digits == 0 || matches!(text.get(behind), None | Some(b'[')) {
            break;
        }
        let value = |n: u32, digit: &u8| n.saturating_mul(10).saturating_add(u32::from(digit - b'0'));
        let slide = text[at + 1..at + 1 + digits].iter().fold(0, value);
        if block.slide.is_none_or(|first| first == 1) {
            block.slide = Some(slide);
        }
        at = behind;
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

#[inline]
fn after_blanks(text: &[u8], mut at: usize) -> usize {
    while let Some(b' ' | b'\t' | b'\r' | b'\n' | 0 | 0x0b | 0x0c | 0x1a) = text.get(at) {
        at += 1;
    }
    at
}

/// Where the comment of a block begins, or its end; a `[` in a text begins none.
fn code_end(text: &[u8]) -> usize {
    let mut quoted = false;
    text.iter()
        .position(|b| {
            quoted ^= *b == b'"';
            *b == b'[' && !quoted
        })
        .unwrap_or(text.len())
}

/// The comment that starts at `at`; nothing may follow it but further comments.
fn comment(text: &[u8], at: usize, block: &mut Block, problems: &mut Vec<Problem>) {
    let Some(len) = text[at..].iter().position(|b| *b == b']') else {
        let span = Span { start: at as u32, end: text.trim_ascii_end().len().max(at) as u32 };
        problems.push(codes::T1004::comment_is_not_closed().among(span));
        block.comment = Some(Span { start: at as u32 + 1, end: text.len() as u32 });
        return;
    };
    let end = at + len;
    block.comment.get_or_insert(Span { start: at as u32 + 1, end: end as u32 });
    let next = after_blanks(text, end + 1);
    match text.get(next) {
        None => {}
        Some(b'[') => further_comments(text, next, block, problems),
        Some(_) => words_behind(text, next, block, problems),
    }
}

/// Comments behind the first one.
#[cold]
fn further_comments(text: &[u8], mut at: usize, block: &mut Block, problems: &mut Vec<Problem>) {
    while text.get(at) == Some(&b'[') {
        let Some(len) = text[at..].iter().position(|b| *b == b']') else { return };
        at = after_blanks(text, at + len + 1);
    }
    if at < text.len() {
        words_behind(text, at, block, problems);
    }
}

#[cold]
fn words_behind(text: &[u8], at: usize, block: &mut Block, problems: &mut Vec<Problem>) {
    let span = Span { start: at as u32, end: text.trim_ascii_end().len().max(at) as u32 };
    let found = codes::T1004::words_stand_behind_comment().among(span);
    problems.push(found.help("a comment stands at the end of its block: move it there"));
    block.words.clear();
    block.span = span;
    block.stmt = Stmt::Bad;
}

/// Section codes and units, which are decided by their first word.
fn by_first_word(text: &[u8], from: usize, end: usize, block: &mut Block) -> bool {
    let code = text[from..end].trim_ascii_end();
    block.span = Span::at(from as u32, code.len() as u32);
    if let Some((section, len)) = sections::section(code) {
        let rest = after_blanks(text, from + len).min(from + code.len());
        block.stmt = Stmt::Section(section, Span { start: rest as u32, end: block.span.end });
        return true;
    }
    let len = code.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
    if code[..len].eq_ignore_ascii_case(b"UNIT") {
        block.stmt = Stmt::Unit;
    } else if code[..len].eq_ignore_ascii_case(b"END_OF_UNIT") {
        block.stmt = Stmt::EndUnit;
    } else {
        return false;
    }
    true
}

/// Reads the statement by the grammar, whatever it is; `text` ends before the comment. The only caller of the
/// generated parser, so that it is compiled once.
pub fn parse_statement(text: &[u8], from: usize, block: &mut Block, problems: &mut Vec<Problem>) {
    thread_local! {
        static PARSER: grammar::BlockParser = grammar::BlockParser::new();
    }
    let repaired = without_printed_dashes(text, from, codes::P0011, problems);
    let text = repaired.as_deref().unwrap_or(text);
    let mut tokens = Tokens::new(text, from);
    let mut build = Build::new(text, block);
    let result = PARSER.with(|parser| parser.parse(&mut build, &mut tokens));
    block.span = Span { start: from as u32, end: tokens.end.max(from as u32) };
    if let Err(error) = result {
        problems.push(problem::of_parse_error(error, text, block.span.start));
        block.words.clear();
        block.stmt = Stmt::Bad;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ast::Section;

    fn parsed(text: &str) -> (Block, Vec<Problem>) {
        let (mut block, mut problems) = (Block::default(), Vec::new());
        parse_block(text.as_bytes(), &mut block, &mut problems);
        (block, problems)
    }

    #[test]
    fn lines_by_their_first_word() {
        let stmt = |text: &str| parsed(text).0.stmt;
        assert!(matches!(stmt("%95.nc"), Stmt::Program(_)));
        assert!(matches!(stmt("#UNIT METRIC"), Stmt::Head { .. }));
        assert!(matches!(stmt("#l1=5"), Stmt::Assign(..)));
        assert!(matches!(stmt("#LA = 5"), Stmt::Assign(..)));
        assert!(matches!(stmt("FERTIGTEIL"), Stmt::Section(Section::Finished, _)));
        assert!(matches!(stmt("N5 UNIT ID\"G869_G80\" [text]"), Stmt::Unit));
        assert_eq!(stmt("END_OF_UNIT 4711"), Stmt::EndUnit);
        assert_eq!(stmt("[title]"), Stmt::Empty);
        assert!(matches!(stmt("N7 G13 X? Z{#1+2} AN#5"), Stmt::Words));
        assert!(matches!(stmt("V1=3"), Stmt::Assign(..)));
        assert!(matches!(stmt("IF #1==2 AND V1<3 THEN"), Stmt::If(_)));
    }

    #[test]
    fn slide_in_front_of_a_block() {
        let read = |text: &str| {
            let (block, problems) = parsed(text);
            assert!(problems.is_empty(), "{text}: {problems:?}");
            (block.slide, block.number, block.stmt)
        };
        assert_eq!(read("$1 N95 G0 X50"), (Some(1), Some(95), Stmt::Words));
        assert_eq!(read("$1N95G0X50"), (Some(1), Some(95), Stmt::Words));
        assert_eq!(read("/2 $1$2 N95 G0 X{#l1+2}"), (Some(2), Some(95), Stmt::Words));
        assert_eq!(read("$3"), (None, None, Stmt::Slide(3)));
        assert_eq!(read("$1 [text]").2, Stmt::Slide(1));
    }

    #[test]
    fn comments() {
        let (block, problems) = parsed("N1 G1 X5 [a] [b]");
        assert_eq!((block.comment.unwrap().start, problems.len()), (10, 0));
        assert_eq!(parsed("N1 [a] G1 X5").1.len(), 1);
        assert_eq!(parsed("N1 G1 X5 [a").1.len(), 1);
    }
}
