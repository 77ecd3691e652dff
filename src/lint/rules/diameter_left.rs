//! A turning program ends in another kind of X than it began in.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;

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
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        for item in read.block.items.iter().filter(|_| self.diameters) {
            match &item.what {
                What::Reads(word) if word == "SAVE" => self.saved = true,
                What::Radii(radii) => self.last = radii.then(|| read.loc(item.span)),
                What::Begins | What::Label(_) => self.last = None,
                What::Ends if !read.block.skip && !self.saved => {
                    if let Some(loc) = self.last.take() {
                        let message = "radius programming holds up to the end of the program";
                        let found = Diagnostic::new(codes::L2017, loc, message);
                        told.say.found(found.help("go back to diameters (DIAMON, G16) behind it"));
                    }
                }
                _ => {}
            }
        }
    }
}
