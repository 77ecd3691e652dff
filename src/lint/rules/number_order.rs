//! A block number is not larger than the one before.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;

#[derive(Debug, Default)]
pub(super) struct NumberOrder {
    last: Option<u32>,
    said: bool,
}

impl NumberOrder {
    pub(super) fn new(_: &Setup<'_>) -> NumberOrder {
        NumberOrder::default()
    }
}

impl SourceRule for NumberOrder {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        let block = read.block;
        self.last = block.passed.or(self.last);
        let Some(number) = block.number else { return };
        if block.items.iter().any(|item| item.what == What::Begins) {
            self.last = None;
        }
        if let Some(last) = self.last.filter(|last| number <= *last && !self.said) {
            self.said = true;
            let found =
                Diagnostic::new(codes::L2005, read.words(), format!("block {number} stands behind block {last}"));
            told.say.found(found.help("number the blocks anew"));
        }
        self.last = Some(number);
    }
}
