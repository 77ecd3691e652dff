//! Colours: comments, words with their numbers, names.

use lsp_types::{Range, SemanticToken, SemanticTokenType, SemanticTokens, SemanticTokensLegend};

use crate::text::Span;

use super::document::Document;
use super::names;

const KINDS: [SemanticTokenType; 7] = [
    SemanticTokenType::COMMENT,
    SemanticTokenType::KEYWORD,
    SemanticTokenType::NUMBER,
    SemanticTokenType::STRING,
    SemanticTokenType::VARIABLE,
    SemanticTokenType::FUNCTION,
    SemanticTokenType::OPERATOR,
];
const COMMENT: u32 = 0;
const KEYWORD: u32 = 1;
const NUMBER: u32 = 2;
const STRING: u32 = 3;
const VARIABLE: u32 = 4;
const FUNCTION: u32 = 5;

pub fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend { token_types: KINDS.to_vec(), token_modifiers: Vec::new() }
}

/// The tokens of the document, or of the lines of `range`.
pub fn tokens(document: &Document, range: Option<Range>) -> Option<SemanticTokens> {
    let study = document.study.as_ref()?;
    let end = document.text.bytes().len();
    let (from, to) =
        range.map_or((0, end), |range| (document.text.offset(range.start), document.text.offset(range.end)));
    let mut found: Vec<(Span, u32)> = Vec::new();
    let mut named: Vec<(Span, u32)> = Vec::new();
    for (name, uses) in &study.survey.variables {
        named.extend(
            uses.set
                .iter()
                .chain(&uses.used)
                .map(|span| (names::spot_or_words(document, study, *span, name), VARIABLE)),
        );
    }
    for (name, uses) in &study.survey.labels {
        named.extend(
            uses.set
                .iter()
                .chain(&uses.used)
                .map(|span| (names::spot_or_words(document, study, *span, name), FUNCTION)),
        );
    }
    named.sort_unstable_by_key(|(span, _)| (span.start, span.end));
    let first = study.survey.blocks.partition_point(|block| (block.span.end as usize) < from);
    for block in study.survey.blocks[first..].iter().take_while(|block| block.span.start as usize <= to) {
        words(document, block.span, &named, &mut found);
    }
    Some(SemanticTokens { result_id: None, data: encoded(document, &found) })
}

/// The words of a block, comments of each line included.
fn words(document: &Document, span: Span, named: &[(Span, u32)], found: &mut Vec<(Span, u32)>) {
    let bytes = document.text.bytes();
    let round = document.dialect.is_some_and(|dialect| matches!(dialect.id, "mtc200" | "gcode"));
    let square = document.dialect.is_some_and(|dialect| dialect.id == "heidenhain-turning");
    let (mut at, end) = (span.start as usize, (span.end as usize).min(bytes.len()));
    let until = |from: usize, is: &dyn Fn(u8) -> bool| {
        bytes[from..end].iter().position(|b| is(*b)).map_or(end, |found| from + found)
    };
    while at < end {
        let from = at;
        let kind = match bytes[at] {
            b';' => {
                at = until(at, &|b| b == b'\n' || b == b'\r');
                COMMENT
            }
            b'(' if round => {
                at = (until(at, &|b| b == b')') + 1).min(end);
                COMMENT
            }
            b'[' if square => {
                at = (until(at, &|b| b == b']') + 1).min(end);
                COMMENT
            }
            b'"' => {
                at = (until(at + 1, &|b| b == b'"' || b == b'\n') + 1).min(end);
                STRING
            }
            b'0'..=b'9' | b'.' => {
                at = until(at, &|b| !(b.is_ascii_digit() || b == b'.' || b == b','));
                NUMBER
            }
            b'A'..=b'Z' | b'a'..=b'z' | b'_' | b'$' | b'#' | b'@' => {
                let here = named.partition_point(|(span, _)| (span.start as usize) < at);
                match named.get(here).filter(|(span, _)| span.start as usize == at && span.end as usize <= end) {
                    Some((span, kind)) if !span.is_empty() => {
                        at = span.end as usize;
                        *kind
                    }
                    _ => {
                        at = until(at, &|b| !(b.is_ascii_alphabetic() || b == b'_' || b == b'$')).max(at + 1);
                        KEYWORD
                    }
                }
            }
            _ => {
                at += 1;
                continue;
            }
        };
        found.push((Span { start: from as u32, end: at as u32 }, kind));
    }
}

/// Each token by its way from the one before; one of several lines is divided.
fn encoded(document: &Document, found: &[(Span, u32)]) -> Vec<SemanticToken> {
    let mut data = Vec::new();
    let (mut line, mut column) = (0, 0);
    for (span, kind) in found {
        let range = document.text.range(*span);
        if range.start.line != range.end.line {
            continue;
        }
        let new_line = range.start.line != line;
        data.push(SemanticToken {
            delta_line: range.start.line - line,
            delta_start: if new_line { range.start.character } else { range.start.character - column },
            length: range.end.character - range.start.character,
            token_type: *kind,
            token_modifiers_bitset: 0,
        });
        (line, column) = (range.start.line, range.start.character);
    }
    data
}
