//! The tool cuts far below the blank.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};

super::rule! { L1007 Motion CutBelowBlank Warning "cut-below-blank"
    what "tool cuts far below the blank"
    why "A cutting move goes more than 5 mm below the lower side of the blank that BLK FORM describes: into the vice, the parallels \
        or the table, or the blank is described wrong. Tips of drills and chamfers need some way below the part, so up to 5 mm \
        nothing is said. Said once for each tool."
    example r#"
-- Example (L1007_fires.H)
0 BEGIN PGM P MM
; The blank ends at Z-40; 10 mm below it is the table.
1 BLK FORM 0.1 Z X+0 Y+0 Z-40
2 BLK FORM 0.2 X+100 Y+100 Z+0
3 TOOL CALL 1 Z S2000
4 L X+50 Y+50 Z+2 R0 FMAX M3
5 L Z-50 F100
6 L Z+50 FMAX M30
7 END PGM P MM
"#
    says {
        below(letter, depth, bottom) "this move cuts at {letter}{depth:.3}, below the blank, which ends at {bottom:.3}"
            help "check the depth, or the blank in BLK FORM";
    }
}

/// Farthest below the blank that tips and chamfers need, mm.
const MOST_BELOW: f64 = 5.0;

#[derive(Debug, Default)]
pub(super) struct CutBelowBlank {
    blank: Option<Blank>,
    said: bool,
}

impl CutBelowBlank {
    pub(super) fn new(setup: &Setup<'_>) -> CutBelowBlank {
        CutBelowBlank { blank: setup.blank, ..CutBelowBlank::default() }
    }
}

impl MotionRule for CutBelowBlank {
    fn wants_moves(&self) -> bool {
        self.blank.is_some()
    }

    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        let Some(blank) = self.blank.filter(|_| step.cuts() && !self.said) else { return };
        let axis = step.tool_axis();
        let bottom = blank.min[axis.index()];
        // The vice and the table lie below the blank, from wherever the tool comes: in workpiece coordinates.
        if let Some(depth) = step.place(&step.to).get(axis).filter(|depth| *depth < bottom - MOST_BELOW) {
            self.said = true;
            say.about(L1007::below(&axis.letter(), &depth, &bottom), step.origin);
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
