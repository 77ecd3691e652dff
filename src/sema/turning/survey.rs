//! Blocks of HEIDENHAIN turning for rules on source text.

use crate::lexer::turning::VarKind;
use crate::parser::symbols::Symbols;
use crate::parser::turning::ast::{Addr, Block, Op, Stmt, Value};
use crate::sema::Job;
use crate::sema::run::survey::{Notes, Surveyed, Visitor, What};
use crate::sema::run::unexecuted::Blocks;
use crate::text::{FileId, Loc, Span};

use super::Turning;

/// Leads `visitor` through a file.
pub fn survey(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    let start = Loc { file, line: 1, span: Span::default() };
    let Some(mut blocks) = Blocks::<Turning>::open(job, file, start) else { return };
    let (mut symbols, mut notes) = (Symbols::default(), Notes::default());
    loop {
        let wanted = visitor.wanted();
        let Some(passed) = blocks.next_that(job, &mut symbols, wanted.letter, wanted.is) else { return };
        let is_bad = passed.block.stmt == Stmt::Bad || !passed.problems.is_empty();
        let (block, text, site) = (passed.block, passed.text, passed.site);
        notes.clear();
        comments(text, block.comment, &mut notes.comments);
        if visitor.items() {
            note(block, &mut notes);
        }
        let surveyed = Surveyed {
            text,
            site,
            number: block.number,
            skip: block.skip.is_some(),
            words: block.span,
            is_empty: block.stmt == Stmt::Empty,
            is_bad,
            comments: &notes.comments,
            items: &notes.items,
        };
        visitor.block(&surveyed, job);
    }
}

/// The comments of a block from its first one on: `[one] [two]`.
fn comments(text: &[u8], first: Option<Span>, list: &mut Vec<Span>) {
    let mut next = first;
    while let Some(comment) = next {
        list.push(comment);
        let behind = comment.end as usize + 1;
        let rest = text.get(behind..).unwrap_or_default();
        let open = behind + rest.len() - rest.trim_ascii_start().len() + 1;
        let is_comment = rest.trim_ascii_start().starts_with(b"[");
        next = is_comment.then(|| {
            let end = memchr::memchr(b']', &text[open..]).map_or(text.len(), |at| open + at);
            Span { start: open as u32, end: end as u32 }
        });
    }
}

fn note(block: &Block, notes: &mut Notes) {
    match block.stmt {
        Stmt::Assign(var, _) if var.kind != VarKind::Machine => notes.add(What::Writes(var.to_string()), block.span),
        Stmt::Section(..) | Stmt::Program(_) => notes.add(What::Begins, block.span),
        Stmt::If(_)
        | Stmt::Else
        | Stmt::EndIf
        | Stmt::While(_)
        | Stmt::EndWhile
        | Stmt::Switch(_)
        | Stmt::Case(_)
        | Stmt::Default
        | Stmt::EndSwitch => notes.add(What::Branches, block.span),
        _ => {}
    }
    for word in &block.words {
        if word.address.addr == Addr(u32::from(b'L')) {
            notes.add(What::Opaque, word.span);
        }
        let (Some(letter), Value::Number { value, .. }) = (word.address.addr.letter(), word.value) else { continue };
        if !word.address.incremental {
            notes.word(letter, value, word.span);
        }
        if letter == b'M' && matches!(value as i64, 30 | 99) && value.fract() == 0.0 {
            notes.add(What::Ends, word.span);
        }
    }
    for op in &block.ops {
        if let Op::Var(var, span) = *op {
            notes.add(What::Reads(var.to_string()), span);
        }
    }
}
