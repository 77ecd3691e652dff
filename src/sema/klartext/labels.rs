//! The labels of one program, found in one pass over its text.

use rustc_hash::FxHashMap;

use crate::diag::{self, Diagnostic, codes};
use crate::parser::klartext::ast::{LabelRef, Stmt};
use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::sema::run::like;
use crate::sema::run::unexecuted::Blocks;
use crate::text::Place;
use crate::text::{FileId, Loc, Span, decode::readable};

use super::Klartext;

/// A label as programs call it.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Label {
    Number(u32),
    Name(Box<str>),
}

impl Label {
    /// A label as it is written; `None` for one in a parameter.
    pub fn written(label: LabelRef, text: &[u8]) -> Option<Label> {
        match label {
            LabelRef::Number(n) => Some(Label::Number(n)),
            LabelRef::Name(span) => Some(Label::Name(readable(span.of(text)).into())),
            LabelRef::Param(_) => None,
        }
    }
}

impl std::fmt::Display for Label {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Label::Number(n) => write!(f, "LBL {n}"),
            Label::Name(name) => write!(f, "LBL \"{name}\""),
        }
    }
}

/// Where the labels stand.
#[derive(Debug, Default)]
pub(super) struct Labels {
    places: FxHashMap<Label, Place>,
    /// Offsets of LBL 0, ascending.
    zeros: Vec<u32>,
}

impl Labels {
    /// Scans `file`; a label set twice is given to `twice`.
    pub fn scan(job: &Job<'_>, file: FileId, from: Loc, twice: &mut dyn FnMut(Diagnostic)) -> Labels {
        let mut labels = Labels::default();
        let Some(mut blocks) = Blocks::<Klartext>::open(job, file, from) else { return labels };
        let mut symbols = Symbols::default();
        while let Some(passed) = blocks.next_bent(job, &mut symbols, may_be_label) {
            let place = passed.place();
            match passed.block.stmt {
                Stmt::Label(LabelRef::Number(0)) => labels.zeros.push(place.at),
                Stmt::Label(label) => {
                    let loc = Loc { file, line: place.line, span: passed.block.span.shifted(place.at) };
                    if let Some(found) = labels.add(label, passed.text, place, loc) {
                        twice(found);
                    }
                }
                Stmt::End { .. } => break,
                _ => {}
            }
        }
        labels
    }

    /// Notes a label; the finding where it is set already.
    pub fn add(&mut self, label: LabelRef, text: &[u8], place: Place, loc: Loc) -> Option<Diagnostic> {
        let label = Label::written(label, text)?;
        // A program that runs again passes its labels again.
        if let Some(&first) = self.places.get(&label).filter(|first| **first != place) {
            let first = Loc { line: first.line, span: Span::at(first.at, 1), ..loc };
            return Some(codes::P2010::is_set_twice(&label).at(loc).also(first, diag::Label::FirstSetHere));
        }
        self.places.insert(label, place);
        None
    }

    /// The finding for a label that is not set.
    pub fn missing(&self, label: &Label, loc: Loc) -> Diagnostic {
        let found = codes::P2011::is_not_set_in_this_program(&label).at(loc);
        match self.like(label) {
            Some(like) => found.help(format!("did you mean `{like}`?")),
            None => found,
        }
    }

    pub fn place(&self, label: &Label) -> Option<Place> {
        self.places.get(label).copied()
    }

    /// Offset of the first LBL 0 behind `at`.
    pub fn zero_after(&self, at: u32) -> Option<u32> {
        self.zeros.get(self.zeros.partition_point(|zero| *zero <= at)).copied()
    }

    /// The label most like `label`, for a hint.
    fn like(&self, label: &Label) -> Option<String> {
        let names: Vec<String> = self.places.keys().map(ToString::to_string).collect();
        like(&label.to_string(), names.iter().map(String::as_str))
    }
}

/// Could this block set a label or end the program? Looks at the first bytes only.
fn may_be_label(text: &[u8]) -> bool {
    let from = text.iter().position(|b| !matches!(b, b' ' | b'\t' | b'/' | b'0'..=b'9' | b'N' | b'n'));
    matches!(from.and_then(|at| text.get(at)), Some(b'L' | b'l' | b'E' | b'e'))
        && from.and_then(|at| text.get(at + 1)).is_some_and(|b| matches!(b, b'B' | b'b' | b'N' | b'n'))
}
