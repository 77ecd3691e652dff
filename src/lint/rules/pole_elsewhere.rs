//! A polar block uses a pole that was set in another working plane.

use crate::diag::Label;
use crate::geo::Plane;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;

super::rule! { L2016 Source PoleElsewhere Warning "pole-of-other-plane"
    what "polar block uses a pole of another working plane"
    why "The pole was set, then the working plane changed (G17, G18, G19; another tool axis in TOOL CALL), and now a block counts \
        from the pole. SINUMERIK takes the zero of the new plane for its pole; a HEIDENHAIN control keeps a pole in axes that are \
        no longer those of the plane. Neither is what the program seems to mean. Set the pole again after the change of the \
        plane. After a label nothing is said: who leads there is not known."
    example r#"
-- Example (L2016_fires_by_the_tool_axis.H)
0 BEGIN PGM P MM
; The pole lies in X and Y, the plane of tool 2 in Z and X.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 CC X+10 Y+10
4 LP PR+20 PA+30 F500
5 L Z+50 R0 FMAX
6 TOOL CALL 2 Y S2000
7 L X+0 Y+5 Z+0 R0 FMAX M3
8 LP PR+20 PA+30 F500
9 L Y+50 R0 FMAX M30
10 END PGM P MM
"#
    says {
        elsewhere() "this block counts from a pole that was set in another working plane"
            help "set the pole after the change of the plane";
    }
}

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
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
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
            let found = L2016::elsewhere().at(read.words()).also(pole.loc, Label::Pole);
            report.say.found(found);
        }
    }
}
