//! The tool cuts far below the blank.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};

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
        if let Some(depth) = step.to.get(axis).filter(|depth| *depth < bottom - MOST_BELOW) {
            self.said = true;
            let message =
                format!("this move cuts at {}{depth:.3}, below the blank, which ends at {bottom:.3}", axis.letter());
            say.about(codes::L1007, step.origin, message, "check the depth, or the blank in BLK FORM");
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
