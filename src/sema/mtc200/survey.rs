//! MTC200 blocks for rules on source text.

use crate::parser::mtc200::ast::{Block, Op, Stmt, Target, Value};
use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::sema::run::survey::{Notes, Visitor, What};
use crate::sema::run::unexecuted::Passed;
use crate::sema::run::{Shown, Shows, survey_file};
use crate::text::FileId;

use super::Mtc200;

/// Leads `visitor` through a file.
pub fn survey(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    survey_file::<Mtc200>(job, file, visitor);
}

impl Shows for Mtc200 {
    type Before = ();

    fn show(passed: &Passed<'_, Mtc200>, symbols: &Symbols, _: &mut (), items: bool, notes: &mut Notes) -> Shown {
        let block = passed.block;
        notes.comments.extend_from_slice(&block.comments);
        if items {
            note(block, symbols, notes);
        }
        Shown {
            number: block.number,
            skip: block.skip,
            words: block.span,
            is_empty: matches!(block.stmt, Stmt::Empty | Stmt::Header(_)) && block.label.is_none(),
            is_bad: block.stmt == Stmt::Bad,
        }
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
