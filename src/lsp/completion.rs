//! Words and cycles with their parameters.

use core::fmt::Write;

use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionResponse, CompletionTextEdit, Documentation, InsertTextFormat,
    Position, TextEdit,
};

use crate::sema::cycle::row::{Name, Signature};
use crate::text::Span;

use super::document::Document;
use super::hover::word_at;
use super::words;

/// What may stand at a place.
pub fn complete(document: &Document, position: Position) -> Option<CompletionResponse> {
    let dialect = document.dialect?;
    let offset = document.text.offset(position);
    let (start, _) = word_at(document.text.as_str(), offset);
    // A cycle of Klartext begins with two words in front of its number.
    let line_start = document.text.offset(Position { line: position.line, character: 0 });
    let front = document.text.as_str().get(line_start..offset).unwrap_or_default().to_ascii_uppercase();
    let cycle_start = front.find("CYCL").map_or(start, |at| line_start + at);
    let range = |from: usize| document.text.range(Span { start: from as u32, end: offset as u32 });
    let mut items = Vec::new();
    for cycle in (dialect.cycles)() {
        let snippet = if dialect.id == "klartext" { dialog(cycle) } else { call(cycle, dialect.id) };
        items.push(CompletionItem {
            label: cycle.name.to_owned(),
            kind: Some(CompletionItemKind::FUNCTION),
            detail: Some(cycle.what.to_owned()),
            documentation: Some(Documentation::String(cycle.describe())),
            insert_text_format: Some(InsertTextFormat::SNIPPET),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit { range: range(cycle_start), new_text: snippet })),
            ..CompletionItem::default()
        });
    }
    for (word, meaning) in words::all(dialect.id) {
        items.push(CompletionItem {
            label: word.to_owned(),
            kind: Some(CompletionItemKind::KEYWORD),
            detail: Some(meaning.to_owned()),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit { range: range(start), new_text: word.to_owned() })),
            ..CompletionItem::default()
        });
    }
    if let Some(study) = &document.study {
        for name in study.survey.variables.keys().chain(study.survey.labels.keys()) {
            items.push(CompletionItem {
                label: name.clone(),
                kind: Some(CompletionItemKind::VARIABLE),
                text_edit: Some(CompletionTextEdit::Edit(TextEdit { range: range(start), new_text: name.clone() })),
                ..CompletionItem::default()
            });
        }
    }
    Some(CompletionResponse::Array(items))
}

/// `CYCL DEF 200 DRILLING ~ Q200=…`, a parameter a line.
fn dialog(cycle: &Signature) -> String {
    let mut text = format!("{} {}", cycle.name, cycle.what.to_ascii_uppercase());
    let mut part = None;
    let mut stop = 0;
    for parameter in cycle.parameters {
        match parameter.name {
            Name::Q(number) => {
                stop += 1;
                _ = write!(text, " ~\n  Q{number}=${{{stop}:+0}} ;{}", plain(parameter.what));
            }
            Name::Part(number) | Name::In(number, _) => {
                if part != Some(number) {
                    part = Some(number);
                    _ = write!(text, "\n{}.{number}", cycle.name);
                }
                stop += 1;
                if let Name::In(_, word) = parameter.name {
                    _ = write!(text, " {word}");
                }
                _ = write!(text, " ${{{stop}:+0}}");
            }
            Name::Word(name) => {
                stop += 1;
                _ = write!(text, " {name}${{{stop}:0}}");
            }
        }
    }
    text
}

/// `CYCLE81(RTP, …)`, or words behind the cycle.
fn call(cycle: &Signature, dialect: &str) -> String {
    let name = |parameter: &crate::sema::cycle::row::Parameter| parameter.name.to_string();
    let stops = (1..).zip(cycle.parameters);
    if dialect == "sinumerik" {
        let arguments: Vec<String> =
            stops.map(|(at, parameter)| format!("${{{at}:{}}}", plain(&name(parameter)))).collect();
        return format!("{}({})", cycle.name, arguments.join(", "));
    }
    let words: Vec<String> = stops.map(|(at, parameter)| format!(" {}${{{at}:0}}", name(parameter))).collect();
    format!("{}{}", cycle.name, words.concat())
}

/// Without what a snippet would take for its own.
fn plain(text: &str) -> String {
    text.chars().filter(|c| !"${}\\;".contains(*c)).collect()
}
