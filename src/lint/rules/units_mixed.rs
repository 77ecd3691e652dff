//! The program changes between inches and millimetres.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;

#[derive(Debug, Default)]
pub(super) struct UnitsMixed {
    inch: Option<Loc>,
    mm: Option<Loc>,
    said: bool,
}

impl UnitsMixed {
    pub(super) fn new(_: &Setup<'_>) -> UnitsMixed {
        UnitsMixed::default()
    }
}

impl SourceRule for UnitsMixed {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        for item in read.block.items {
            let What::Word { letter: b'G', value } = item.what else { continue };
            let loc = read.loc(item.span);
            if value == 70.0 || value == 700.0 {
                self.inch.get_or_insert(loc);
            } else if value == 71.0 || value == 710.0 {
                self.mm.get_or_insert(loc);
            } else {
                continue;
            }
            if let (Some(inch), Some(mm), false) = (self.inch, self.mm, self.said) {
                self.said = true;
                let first = if loc == inch { mm } else { inch };
                let message = "the program changes between inches and millimetres";
                let found = Diagnostic::new(codes::L2010, loc, message).also(first, "the other unit");
                told.say.found(found.help("write the program in one unit"));
            }
        }
    }
}
