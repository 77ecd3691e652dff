//! No move reaches the blank that the program describes.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::Axis;

super::rule! { L1032 Motion BlankUntouched Warning "blank-untouched"
    what "no move reaches the blank"
    why "The program describes a blank, and all of its cuts are outside it. The blank stands elsewhere than the part, most often \
        because one of them was moved to another zero. A tool has a radius and a length: a cut within 100 mm of the blank counts \
        as one that reaches it. The path does not depend on it; every simulation and `partc`'s own rules about the blank do."
    example r#"
-- Example (L1032_fires.H)
0 BEGIN PGM P MM
; The cuts are 400 mm away from the blank.
1 BLK FORM 0.1 Z X+0 Y+0 Z-40
2 BLK FORM 0.2 X+100 Y+100 Z+0
3 TOOL CALL 1 Z S2000
4 L X+500 Y+50 Z+2 R0 FMAX M3
5 L Z-5 F100
6 L Z+50 FMAX M30
7 END PGM P MM
"#
    says {
        missed() "no cut of this program reaches its blank" help "check BLK FORM and the zero";
    }
}

/// Room for the radius of tools around the blank, mm.
const ROOM: f64 = 100.0;

#[derive(Debug, Default)]
pub(super) struct BlankUntouched {
    blank: Option<Blank>,
    first: Option<Origin>,
    reached: bool,
}

impl BlankUntouched {
    pub(super) fn new(setup: &Setup<'_>) -> BlankUntouched {
        BlankUntouched { blank: setup.blank, ..BlankUntouched::default() }
    }
}

impl MotionRule for BlankUntouched {
    fn wants_moves(&self) -> bool {
        self.blank.is_some()
    }

    fn movement(&mut self, step: &Step<'_>, _: &Machine, _: Say<'_>) {
        let Some(blank) = self.blank.filter(|_| step.cuts() && !self.reached) else { return };
        self.first.get_or_insert(*step.origin);
        // Where the blank is asked for, workpiece coordinates count.
        let (from, to) = (step.place(step.from), step.place(&step.to));
        // The tool has a radius: as much room around.
        self.reached = Axis::ALL[..3].iter().all(|axis| {
            let (a, b) = (from.get(*axis), to.get(*axis));
            let (Some(a), Some(b)) = (a.or(b), b.or(a)) else { return true };
            let (min, max) = (blank.min[axis.index()] - ROOM, blank.max[axis.index()] + ROOM);
            a.min(b) <= max && a.max(b) >= min
        });
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::WorkOffset(_)) && self.first.is_some() {
            self.blank = None;
        }
    }

    fn finish(&mut self, _: &Machine, say: Say<'_>) {
        if let Some(first) = self.first.filter(|_| self.blank.is_some() && !self.reached) {
            say.about(L1032::missed(), &first);
        }
    }
}
