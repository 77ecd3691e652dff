//! The tool cuts far beside or above the blank.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::Axis;

super::rule! { L1037 Motion CutBesideBlank Warning "cut-beside-blank"
    what "tool cuts far beside the blank"
    why "A cutting move goes more than 150 mm beyond the sides of the blank. A digit or a sign is wrong, the zero is that of \
        another part, or the blank is described wrong. Tools, and their ways in and out, need some room beside the part, so up to \
        150 mm nothing is said. Said once for each tool; after a change of the datum nothing is said."
    example r#"
-- Example (L1037_fires.H)
0 BEGIN PGM P MM
; X+800, beside a blank of 100 mm.
1 BLK FORM 0.1 Z X+0 Y+0 Z-40
2 BLK FORM 0.2 IX+100 IY+100 IZ+40
3 TOOL CALL 1 Z S2000
4 L X+50 Y+50 Z+2 R0 FMAX M3
5 L Z-5 F100
6 L X+800 F300
7 L Z+50 FMAX M30
8 END PGM P MM
"#
    says {
        beside(letter, at, min, max)
            "this move cuts at {letter}{at:.3}, and the blank lies between {letter}{min:.3} and {letter}{max:.3}"
            help "check the coordinate, the zero and the blank";
    }
}

/// Room for tools and their ways in and out, mm.
const ROOM: f64 = 150.0;

#[derive(Debug, Default)]
pub(super) struct CutBesideBlank {
    blank: Option<Blank>,
    said: bool,
}

impl CutBesideBlank {
    pub(super) fn new(setup: &Setup<'_>) -> CutBesideBlank {
        CutBesideBlank { blank: setup.blank, ..CutBesideBlank::default() }
    }
}

impl MotionRule for CutBesideBlank {
    fn wants_moves(&self) -> bool {
        self.blank.is_some()
    }

    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let Some(blank) = self.blank.filter(|_| step.cuts() && !self.said) else { return };
        // The sides are those of the blank. A tool that stands aslant is lifted beside them.
        let (to, tilted) = (step.place(&step.to), step.is_tilted());
        let outside = |axis: &&Axis| {
            let (at, index) = (to.get(**axis), axis.index());
            let along = step.mv.axes.contains(**axis) && **axis != step.tool_axis();
            let moves = if tilted { step.goes_sideways() } else { along };
            moves && at.is_some_and(|at| at < blank.min[index] - ROOM || at > blank.max[index] + ROOM)
        };
        if let Some(axis) = Axis::ALL[..3].iter().find(outside) {
            self.said = true;
            let at = to.get(*axis).unwrap_or_default();
            let (min, max) = (blank.min[axis.index()], blank.max[axis.index()]);
            say.about(L1037::beside(&axis.letter(), &at, &min, &max), step.origin);
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        match function {
            Function::WorkOffset(_) => self.blank = None,
            Function::ToolChange { .. } => self.said = false,
            _ => {}
        }
    }
}
