//! A polar block uses a pole that was set in another working plane.

use crate::diag::{Diagnostic, codes};
use crate::geo::Plane;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;

/// Where a pole was set, and in which plane.
#[derive(Debug, Clone, Copy)]
struct Pole {
    loc: Loc,
    plane: Option<Plane>,
    stale: bool,
}

#[derive(Debug, Default)]
pub(super) struct PoleElsewhere {
    pole: Option<Pole>,
    plane: Option<Plane>,
}

impl PoleElsewhere {
    pub(super) fn new(_: &Setup<'_>) -> PoleElsewhere {
        PoleElsewhere::default()
    }

    fn plane(&mut self, plane: Plane) {
        self.plane = Some(plane);
        if let Some(pole) = &mut self.pole {
            // The plane that held for it may have been this one.
            pole.stale |= pole.plane.is_some_and(|of_pole| of_pole != plane);
            pole.plane.get_or_insert(plane);
        }
    }
}

impl SourceRule for PoleElsewhere {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        // The plane of a block holds for its pole and its coordinates.
        for item in read.block.items {
            match &item.what {
                What::Plane(plane) => self.plane(*plane),
                What::Word { letter: b'G', value } if *value == 17.0 => self.plane(Plane::Xy),
                What::Word { letter: b'G', value } if *value == 18.0 => self.plane(Plane::Zx),
                What::Word { letter: b'G', value } if *value == 19.0 => self.plane(Plane::Yz),
                // Who leads here is not known.
                What::Label(_) | What::Begins => *self = PoleElsewhere::default(),
                _ => {}
            }
        }
        if read.has(&What::Pole) {
            self.pole = Some(Pole { loc: read.words(), plane: self.plane, stale: false });
            return;
        }
        if let Some(pole) = self.pole.filter(|pole| pole.stale && read.has(&What::Polar)) {
            self.pole = None;
            let message = "this block counts from a pole that was set in another working plane";
            let found = Diagnostic::new(codes::L2016, read.words(), message).also(pole.loc, "the pole");
            told.say.found(found.help("set the pole behind the change of the plane"));
        }
    }
}
