//! The program changes between inches and millimetres.

use crate::diag::Label;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;

super::rule! { L2010 Source UnitsMixed Warning "units-mixed"
    what "program changes between inches and millimetres"
    why "G70 or G700 (inches) and G71 or G710 (millimetres) both stand in the program. Feeds, offsets and cycle parameters do not \
        all follow the change, and controls differ in which. Write the program in one unit. Said once."
    example r#"
-- Example (L2010_fires.MPF)
; Inches and millimetres.
G700 G0 X0 Y0 Z1
G1 X1 F10
G710 G1 X30 F100
M30
"#
    says {
        mixed() "the program changes between inches and millimetres" help "write the program in one unit";
    }
}

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
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
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
                let found = L2010::mixed().at(loc).also(first, Label::OtherUnit);
                report.say.found(found);
            }
        }
    }
}
