//! A turning program ends in another kind of X than it began in.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;

super::rule! { L2017 Source DiameterLeft Warning "radius-left-on"
    what "program ends in radius programming on a lathe that begins in diameters"
    why "The last of DIAMON, DIAM90 and DIAMOF in the program is DIAMOF (G15 of G15 and G16 on an MTC200), and then comes its end. \
        The configuration says that the lathe begins in diameters. Where the control does not reset it, the next program takes its \
        diameters for radii, and the tool stands twice as far out or the part gets twice as thick. Go back to DIAMON where radii \
        end."
    example r#"
-- Example (L2017_fires.MPF)
; DIAMOF holds at M30.
G18 G90 DIAMON G95
T1 D1
G97 S500 M3
G0 X40 Z5
G1 Z-5 F0.2
DIAMOF
G0 X60
M30
-- partc.toml
[machine]
kind = "lathe"
diameter_axis = "X"
"#
    says {
        left_on() "radius programming holds up to the end of the program" help "go back to diameters (DIAMON, G16) after it";
    }
}

#[derive(Debug)]
pub(super) struct DiameterLeft {
    /// Where radius programming was switched on.
    last: Option<Loc>,
    /// The machine begins in diameters.
    diameters: bool,
    /// The caller gets back what held for him.
    saved: bool,
}

impl DiameterLeft {
    pub(super) fn new(setup: &Setup<'_>) -> DiameterLeft {
        let machine = &setup.settings.machine;
        let diameters = setup.is_lathe() && machine.diameter_axis.is_some() && machine.power_on_diameter;
        DiameterLeft { last: None, diameters, saved: false }
    }
}

impl SourceRule for DiameterLeft {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        for item in read.block.items.iter().filter(|_| self.diameters) {
            match &item.what {
                What::Reads(word) if word == "SAVE" => self.saved = true,
                What::Radii(radii) => self.last = radii.then(|| read.loc(item.span)),
                What::Begins | What::Label(_) => self.last = None,
                What::Ends if !read.block.skip && !self.saved => {
                    if let Some(loc) = self.last.take() {
                        let found = L2017::left_on().at(loc);
                        report.say.found(found);
                    }
                }
                _ => {}
            }
        }
    }
}
