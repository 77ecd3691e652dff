//! MTC200 blocks for rules on source text.

use crate::parser::mtc200::ast::{Block, Op, Stmt, Target, Value};
use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::sema::run::survey::{Notes, Surveyed, Visitor, What};
use crate::sema::run::unexecuted::{Blocks, Numbers};
use crate::text::{FileId, Loc, Span};

use super::Mtc200;

/// Leads `visitor` through a file.
pub fn survey(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    let start = Loc { file, line: 1, span: Span::default() };
    let Some(mut blocks) = Blocks::<Mtc200>::open(job, file, start) else { return };
    let (mut symbols, mut notes) = (Symbols::default(), Notes::default());
    let mut numbers = Numbers::default();
    loop {
        let Some(passed) = blocks.next_for(job, &mut symbols, visitor, &mut numbers) else { return };
        let is_bad = passed.block.stmt == Stmt::Bad || !passed.problems.is_empty();
        let (block, text, site) = (passed.block, passed.text, passed.site);
        notes.clear();
        notes.comments.extend_from_slice(&block.comments);
        if visitor.items() {
            note(block, &symbols, &mut notes);
        }
        let surveyed = Surveyed {
            text,
            site,
            number: block.number,
            skip: block.skip,
            words: block.span,
            is_empty: matches!(block.stmt, Stmt::Empty | Stmt::Header(_)) && block.label.is_none(),
            is_bad,
            comments: &notes.comments,
            items: &notes.items,
            passed: numbers.passed,
        };
        numbers.see(surveyed.number);
        visitor.block(&surveyed, job);
    }
}

fn note(block: &Block, symbols: &Symbols, notes: &mut Notes) {
    if let Some(label) = block.label {
        notes.add(What::Label(symbols.name(label).to_owned()), block.span);
    }
    for word in &block.words {
        if let Value::Label(label) = word.value {
            notes.add(What::Uses(symbols.name(label).to_owned()), word.span);
        }
        match (word.target, word.value) {
            (Target::Letter(letter), Value::Literal(value)) => {
                notes.word(letter, value, word.span);
                if letter == b'G' && (value == 15.0 || value == 16.0) {
                    notes.add(What::Radii(value == 15.0), word.span);
                }
                if letter == b'M' && (value == 2.0 || value == 30.0) {
                    notes.add(What::Ends, word.span);
                }
            }
            (Target::Variable(number), _) => notes.add(What::Writes(format!("@{number}")), word.span),
            (Target::Name(name), _) => match symbols.name(name) {
                "RET" | "PROGRAMMENDE" => notes.add(What::Ends, word.span),
                "RTS" | "BRA" => notes.add(What::Leaves, word.span),
                "JSR" => notes.add(What::Opaque, word.span),
                _ => {}
            },
            _ => {}
        }
    }
    for op in &block.ops {
        if let Op::Variable(number, span) = *op {
            notes.add(What::Reads(format!("@{number}")), span);
        }
    }
}
