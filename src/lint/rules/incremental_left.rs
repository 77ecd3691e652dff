//! The program ends while G91 holds.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;

super::rule! { L2009 Source IncrementalLeft Warning "incremental-left-on"
    what "program ends while G91 holds"
    why "The last of G90 and G91 in the program is G91, and then comes its end. Where the control does not reset it, the next \
        program starts with increments: a rapid move to a height becomes one by this height. Go back to G90 where the increments \
        end."
    example r#"
-- Example (L2009_fires.MPF)
; G91 up to the end.
G0 X0 Y0 Z5
G91 G1 X5 F100
M30
"#
    says {
        left_on() "G91 holds up to the end of the program" help "go back to G90 after the increments";
    }
}

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
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        let block = read.block;
        for item in block.items {
            match &item.what {
                What::Reads(word) if word == "SAVE" => self.saved = true,
                What::Word { letter: b'G', value } if *value == 90.0 => self.last = None,
                What::Word { letter: b'G', value } if *value == 91.0 => self.last = Some(read.loc(item.span)),
                What::Begins | What::Label(_) => self.last = None,
                What::Ends if !block.skip && !self.saved => {
                    if let Some(loc) = self.last.take() {
                        let found = L2009::left_on().at(loc);
                        report.say.found(found);
                    }
                }
                _ => {}
            }
        }
    }
}
