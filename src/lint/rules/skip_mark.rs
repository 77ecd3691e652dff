//! Blocks with a skip mark, and nothing says whether they run.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};

#[derive(Debug, Default)]
pub(super) struct SkipMark {
    said: bool,
    open: bool,
}

impl SkipMark {
    pub(super) fn new(setup: &Setup<'_>) -> SkipMark {
        SkipMark { open: setup.settings.control.skip_blocks.is_empty(), said: false }
    }
}

impl SourceRule for SkipMark {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        if read.block.skip && !self.said && self.open {
            self.said = true;
            let found = Diagnostic::new(
                codes::L2014,
                read.words(),
                "this block has a skip mark, and is compiled as if the switch were off",
            );
            told.say.found(found.help("set `[control] skip_blocks`"));
        }
    }
}
