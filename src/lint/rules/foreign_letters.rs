//! A comment holds letters that controls do not show.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};

#[derive(Debug, Default)]
pub(super) struct ForeignLetters {
    said: bool,
}

impl ForeignLetters {
    pub(super) fn new(_: &Setup<'_>) -> ForeignLetters {
        ForeignLetters::default()
    }
}

impl SourceRule for ForeignLetters {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        let foreign = read.block.comments.iter().find(|comment| !comment.of(read.block.text).is_ascii());
        if let Some(comment) = foreign.filter(|_| !self.said) {
            self.said = true;
            let found = Diagnostic::new(codes::L2015, read.loc(*comment), "this comment holds letters beyond ASCII");
            told.say.found(found.help("write it without accents and special signs"));
        }
    }
}
