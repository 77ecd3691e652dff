//! The outline of a program, and what of it can be folded.

use lsp_types::{DocumentSymbol, FoldingRange, FoldingRangeKind, SymbolKind};

use crate::text::{FileId, Span};

use super::document::Document;
use super::study::Study;

/// A line of the outline, and where it ends.
struct Entry {
    span: Span,
    name: String,
    detail: Option<String>,
    kind: SymbolKind,
}

/// Programs of the file, tools, and labels, each up to the next of its kind or above.
pub fn symbols(document: &Document) -> Vec<DocumentSymbol> {
    let Some(study) = &document.study else { return Vec::new() };
    let end = document.text.bytes().len() as u32;
    let mut found: Vec<DocumentSymbol> = Vec::new();
    let entries = entries(document, study);
    for (at, entry) in entries.iter().enumerate() {
        let until =
            entries[at + 1..].iter().find(|next| ends(next.kind, entry.kind)).map_or(end, |next| next.span.start);
        #[expect(deprecated, reason = "the protocol still has the field")]
        let symbol = DocumentSymbol {
            name: entry.name.clone(),
            detail: entry.detail.clone(),
            kind: entry.kind,
            tags: None,
            deprecated: None,
            range: document.text.range(Span { start: entry.span.start, end: until.max(entry.span.end) }),
            selection_range: document.text.range(entry.span),
            children: None,
        };
        found.push(symbol);
    }
    found
}

/// Does an entry of the one kind end one of the other?
fn ends(next: SymbolKind, kind: SymbolKind) -> bool {
    next == kind || next == SymbolKind::MODULE
}

fn entries(document: &Document, study: &Study) -> Vec<Entry> {
    let words = |span: Span| String::from_utf8_lossy(span.of(document.text.bytes())).trim().to_owned();
    let mut entries: Vec<Entry> = Vec::new();
    for begin in &study.survey.begins {
        entries.push(Entry { span: *begin, name: words(*begin), detail: None, kind: SymbolKind::MODULE });
    }
    let mut known = Vec::new();
    for tool in study.seen.tools.iter().filter(|tool| tool.file == FileId(0)) {
        if known.contains(&tool.span) {
            continue;
        }
        known.push(tool.span);
        let (name, detail) = (format!("T{}", tool.number), Some(words(tool.span)));
        entries.push(Entry { span: tool.span, name, detail, kind: SymbolKind::CLASS });
    }
    for (name, uses) in &study.survey.labels {
        for span in &uses.set {
            let detail = match uses.used.len() {
                0 => None,
                1 => Some("used once".to_owned()),
                count => Some(format!("used {count} times")),
            };
            entries.push(Entry { span: *span, name: name.clone(), detail, kind: SymbolKind::FUNCTION });
        }
    }
    entries.retain(|entry| !entry.name.is_empty());
    entries.sort_by_key(|entry| entry.span.start);
    entries
}

/// What each tool does, and blocks of several lines.
pub fn folds(document: &Document) -> Vec<FoldingRange> {
    let Some(study) = &document.study else { return Vec::new() };
    let fold = |from: u32, to: u32| FoldingRange {
        start_line: from,
        end_line: to,
        kind: Some(FoldingRangeKind::Region),
        ..FoldingRange::default()
    };
    let mut folds = Vec::new();
    for symbol in symbols(document) {
        let (from, to) = (symbol.range.start.line, symbol.range.end.line);
        let to = if symbol.range.end.character == 0 { to.saturating_sub(1) } else { to };
        if to > from {
            folds.push(fold(from, to));
        }
    }
    for block in &study.survey.blocks {
        let range = document.text.range(block.span);
        if range.end.line > range.start.line {
            folds.push(fold(range.start.line, range.end.line));
        }
    }
    folds
}
