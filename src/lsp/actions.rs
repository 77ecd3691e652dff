//! What can be done about a finding: mend it, or ignore it.

use std::collections::HashMap;

use lsp_types::{CodeAction, CodeActionKind, CodeActionOrCommand, Range, TextEdit, WorkspaceEdit};

use crate::text::Span;

use super::document::Document;
use super::study::{Found, Study};

pub fn actions(document: &Document, range: Range) -> Vec<CodeActionOrCommand> {
    let Some(study) = &document.study else { return Vec::new() };
    let (from, to) = (document.text.offset(range.start) as u32, document.text.offset(range.end) as u32);
    let mut actions = Vec::new();
    for found in study.findings.iter().filter(|found| found.span.start <= to && from <= found.span.end) {
        let mends = study.fixes.iter().filter(|fix| fix.code == found.code && fix.at == found.span.start);
        for fix in mends {
            let Ok(text) = String::from_utf8(fix.text.clone()) else { continue };
            let edit = TextEdit { range: document.text.range(fix.span), new_text: text };
            let title = format!("{}: mend ({})", found.code.id, found.code.name);
            actions.push(action(document, title, CodeActionKind::QUICKFIX, edit));
        }
        if let Some(edit) = ignoring(document, study, found) {
            let title = format!("{}: ignore in this block", found.code.id);
            actions.push(action(document, title, CodeActionKind::QUICKFIX, edit));
        }
    }
    actions
}

/// A comment at the end of the block that suppresses the finding; where there is one, the code joins its list.
fn ignoring(document: &Document, study: &Study, found: &Found) -> Option<TextEdit> {
    if !found.ignorable {
        return None;
    }
    let [open, inner_open, inner_close, close] = document.dialect?.comment;
    let block = study.survey.block_at(found.span.start).filter(|block| !block.words.is_empty())?;
    // A block of several lines takes its comment at the end of the last one.
    let line = document.text.position(block.span.end).line as usize;
    let text = document.text.line(line);
    let start = document.text.offset(lsp_types::Position { line: line as u32, character: 0 }) as u32;
    let mark = format!("partc: ignore{inner_open}");
    if let Some(at) = text.find(&mark) {
        let at = at + mark.len();
        return Some(TextEdit {
            range: document.text.range(Span::at(start + at as u32, 0)),
            new_text: format!("{}, ", found.code.id),
        });
    }
    let end = start + text.trim_end().len() as u32;
    let new_text = format!(" {open}partc: ignore{inner_open}{}{inner_close}{close}", found.code.id);
    Some(TextEdit { range: document.text.range(Span::at(end, 0)), new_text })
}

fn action(document: &Document, title: String, kind: CodeActionKind, edit: TextEdit) -> CodeActionOrCommand {
    #[expect(clippy::mutable_key_type, reason = "the protocol's own type")]
    let changes = HashMap::from([(document.uri.clone(), vec![edit])]);
    let edit = Some(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() });
    CodeActionOrCommand::CodeAction(CodeAction { title, kind: Some(kind), edit, ..CodeAction::default() })
}
