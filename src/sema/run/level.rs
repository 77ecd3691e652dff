//! A level of the call stack: which program runs, where its caller goes on.

use crate::diag::CallPath;
use crate::sema::Job;
use crate::text::{FileId, Loc, Place};

use super::Language;
use super::source::Source;

/// A program file and what is known of it.
#[derive(Debug)]
pub struct Program<L: Language> {
    pub source: Source<L::Block>,
    pub known: L::Known,
}

impl<L: Language> Program<L> {
    /// Opens a file; reports what is wrong with it.
    pub fn open(job: &Job<'_>, file: FileId, from: Loc) -> Option<Program<L>> {
        Some(Program { source: Source::open(job, file, L::SPLIT, from)?, known: L::Known::default() })
    }
}

/// A level of the call stack.
#[derive(Debug)]
pub struct Level<F> {
    /// Index of the program that runs on this level.
    pub program: usize,
    /// Where the caller goes on.
    pub back: Place,
    pub call: CallPath,
    /// The block that called.
    pub site: Loc,
    /// What the language knows of it.
    pub frame: F,
}

impl<F> Level<F> {
    pub fn main(program: usize, frame: F) -> Level<F> {
        Level { program, back: Place::default(), call: CallPath::MAIN, site: Loc::default(), frame }
    }
}
