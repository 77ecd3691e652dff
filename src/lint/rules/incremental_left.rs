//! The program ends while G91 holds.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;

#[derive(Debug, Default)]
pub(super) struct IncrementalLeft {
    last: Option<Loc>,
    /// The caller gets back what held for him.
    saved: bool,
}

impl IncrementalLeft {
    pub(super) fn new(_: &Setup<'_>) -> IncrementalLeft {
        IncrementalLeft::default()
    }
}

impl SourceRule for IncrementalLeft {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        let block = read.block;
        for item in block.items {
            match &item.what {
                What::Reads(word) if word == "SAVE" => self.saved = true,
                What::Word { letter: b'G', value } if *value == 90.0 => self.last = None,
                What::Word { letter: b'G', value } if *value == 91.0 => self.last = Some(read.loc(item.span)),
                What::Begins | What::Label(_) => self.last = None,
                What::Ends if !block.skip && !self.saved => {
                    if let Some(loc) = self.last.take() {
                        let found = Diagnostic::new(codes::L2009, loc, "G91 holds up to the end of the program");
                        told.say.found(found.help("go back to G90 behind the increments"));
                    }
                }
                _ => {}
            }
        }
    }
}
