//! A block stands behind the end of the program and nothing leads to it.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;

#[derive(Debug, Default)]
pub(super) struct BehindEnd {
    end: Option<Loc>,
    said: bool,
    branches: bool,
}

impl BehindEnd {
    pub(super) fn new(_: &Setup<'_>) -> BehindEnd {
        BehindEnd::default()
    }
}

impl SourceRule for BehindEnd {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        let block = read.block;
        if block.items.iter().any(|item| matches!(item.what, What::Label(_) | What::Begins)) {
            self.end = None;
        }
        let ends = block.items.iter().find(|item| item.what == What::Ends);
        if let Some(end) = self.end.filter(|_| !block.is_empty && !block.is_bad && ends.is_none() && !self.said) {
            self.said = true;
            let found = Diagnostic::new(codes::L2003, read.words(), "this block stands behind the end of the program")
                .also(end, "the program ends here");
            told.say.found(found.help("remove it, or give it a label that something calls"));
        }
        // One that may be skipped, or stands in a branch, ends nothing for sure.
        if let Some(item) = ends.filter(|_| !block.skip && !self.branches) {
            self.end = Some(read.loc(item.span));
        }
        self.branches |= read.has(&What::Branches);
    }
}
