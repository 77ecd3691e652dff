//! The tool cuts far beside or above the blank.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step};
use crate::machine::axis::Axis;

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
        let outside = |axis: &&Axis| {
            let (at, index) = (step.to.get(**axis), axis.index());
            let moves = step.mv.axes.contains(**axis) && **axis != step.tool_axis();
            moves && at.is_some_and(|at| at < blank.min[index] - ROOM || at > blank.max[index] + ROOM)
        };
        if let Some(axis) = Axis::ALL[..3].iter().find(outside) {
            self.said = true;
            let at = step.to.get(*axis).unwrap_or_default();
            let (min, max) = (blank.min[axis.index()], blank.max[axis.index()]);
            let letter = axis.letter();
            let message = format!(
                "this move cuts at {letter}{at:.3}, and the blank lies between {letter}{min:.3} and {letter}{max:.3}"
            );
            say.about(codes::L1037, step.origin, message, "check the coordinate, the zero and the blank");
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
