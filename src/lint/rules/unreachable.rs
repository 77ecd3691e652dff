//! A block can never run.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;

#[derive(Debug, Default)]
pub(super) struct Unreachable {
    after: Option<Loc>,
    numbers: bool,
}

impl Unreachable {
    pub(super) fn new(_: &Setup<'_>) -> Unreachable {
        Unreachable::default()
    }
}

impl SourceRule for Unreachable {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        let block = read.block;
        if block.items.iter().any(|item| matches!(item.what, What::Label(_) | What::Begins | What::Ends))
            || block.number.is_some_and(|_| self.numbers)
        {
            self.after = None;
        }
        if let Some(jump) = self.after.filter(|_| !block.is_empty && !block.is_bad) {
            self.after = None;
            let found = Diagnostic::new(codes::L2002, read.words(), "this block can never run")
                .also(jump, "the program goes on elsewhere here");
            told.say.found(found.help("remove it, or give it a label that something jumps to"));
        }
        if let Some(item) = block.items.iter().find(|item| item.what == What::Leaves)
            && !block.skip
        {
            self.after = Some(read.loc(item.span));
        }
        self.numbers |= block.items.iter().any(|item| matches!(&item.what, What::Uses(name) if name.starts_with('N')));
    }
}
