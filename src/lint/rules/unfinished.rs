//! A comment says that something is to be done.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};

#[derive(Debug)]
pub(super) struct Unfinished;

impl Unfinished {
    pub(super) fn new(_: &Setup<'_>) -> Unfinished {
        Unfinished
    }
}

impl SourceRule for Unfinished {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        for comment in read.block.comments {
            let text = comment.of(read.block.text);
            let words = text.split(|b| !b.is_ascii_alphanumeric());
            if words.into_iter().any(|word| matches!(word, b"TODO" | b"FIXME" | b"XXX")) {
                let found =
                    Diagnostic::new(codes::L2013, read.loc(*comment), "this comment says that something is to be done");
                told.say.found(found.help("do it, and remove the comment"));
            }
        }
    }
}
