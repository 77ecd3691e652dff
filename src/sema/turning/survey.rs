//! Blocks of HEIDENHAIN turning for rules on source text.

use crate::lexer::turning::VarKind;
use crate::machine::Unit;
use crate::parser::symbols::Symbols;
use crate::parser::turning::ast::{Addr, Block, Op, Section, Stmt, Value};
use crate::sema::Job;
use crate::sema::run::survey::{Item, Notes, Visitor, What};
use crate::sema::run::unexecuted::Passed;
use crate::sema::run::{Shown, Shows, survey_file};
use crate::text::{FileId, Span};

use super::Turning;

/// Leads `visitor` through a file.
pub fn survey(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    survey_file::<Turning>(job, file, visitor);
}

impl Shows for Turning {
    type Before = Shape;

    fn show(passed: &Passed<'_, Turning>, _: &Symbols, shape: &mut Shape, items: bool, notes: &mut Notes) -> Shown {
        let (block, text) = (passed.block, passed.text);
        comments(text, block.comment, &mut notes.comments);
        if items {
            note(block, notes);
            shape.note(block, text, notes);
        }
        Shown {
            number: block.number,
            skip: block.skip.is_some(),
            words: block.span,
            is_empty: block.stmt == Stmt::Empty,
            is_bad: block.stmt == Stmt::Bad,
        }
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

/// What the sections in front say of lengths.
#[derive(Debug, Default)]
pub(super) struct Shape {
    in_blank: bool,
    unit: Unit,
}

impl Shape {
    /// A bar by G20 in the section of the blank, where all its words are numbers.
    fn note(&mut self, block: &Block, text: &[u8], notes: &mut Notes) {
        match block.stmt {
            Stmt::Head { key, value }
                if matches!(key.of(text).to_ascii_uppercase().as_slice(), b"UNIT" | b"EINHEIT") =>
            {
                let value = value.of(text).trim_ascii().to_ascii_uppercase();
                let inch = value.ends_with(b"INCH") || value.ends_with(b"ZOLL");
                self.unit = if inch { Unit::Inch } else { Unit::Mm };
            }
            Stmt::Section(section, _) => {
                self.in_blank = section == Section::Blank;
                if section == Section::Contours {
                    notes.add(What::Parts, block.span);
                }
            }
            _ if self.in_blank => {
                let bar = bar(block, self.unit.mm());
                notes.items.extend(bar.map(|what| Item { what, span: block.span }));
            }
            _ => {}
        }
    }
}

/// `G20 X80 Z100 K2 I30`: a diameter, a length, where the right face lies, and the diameter of a bore.
fn bar(block: &Block, mm: f64) -> Option<What> {
    let (mut is_bar, mut of) = (false, [None, None, Some(0.0), Some(0.0)]);
    for word in &block.words {
        let value = match word.value {
            Value::Number { value, .. } => Some(value),
            _ => None,
        };
        let at = match word.address.addr.letter() {
            Some(b'G') => {
                is_bar |= value == Some(20.0);
                continue;
            }
            Some(b'X') => 0,
            Some(b'Z') => 1,
            Some(b'K') => 2,
            Some(b'I') => 3,
            _ => continue,
        };
        of[at] = value.map(|value| value * mm);
    }
    let [Some(diameter), Some(length), Some(right), Some(bore)] = of else { return None };
    is_bar.then_some(What::BlankBar { radius: diameter / 2.0, bore: bore / 2.0, left: right - length, right })
}
