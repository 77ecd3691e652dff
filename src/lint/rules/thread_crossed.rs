//! A pass crosses the thread that the pass before has cut.

use crate::diag::codes;
use crate::ir::motion::Path;
use crate::ir::{Function, Origin, Pos};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY, Turning};
use crate::lint::tapping::Tapping;
use crate::machine::Axis;

/// Farthest beside each other that two passes of one thread lie, mm.
const MOST_BESIDE: f64 = 5.0;

/// A pass of a thread.
#[derive(Debug, Clone, Copy)]
struct Pass {
    axis: Axis,
    from: Pos,
    to: Pos,
    turning: Turning,
    tool: Option<u32>,
}

impl Pass {
    fn way(&self) -> Option<f64> {
        Some(self.to.get(self.axis)? - self.from.get(self.axis)?)
    }

    /// From the lower end to the upper one.
    fn range(&self) -> Option<(f64, f64)> {
        let (from, to) = (self.from.get(self.axis)?, self.to.get(self.axis)?);
        Some((from.min(to), from.max(to)))
    }

    /// Do both lie in one thread?
    fn beside(&self, other: &Pass) -> bool {
        let (Some(mine), Some(theirs)) = (self.range(), other.range()) else { return false };
        let common = mine.1.min(theirs.1) - mine.0.max(theirs.0);
        let near = |axis: Axis| match (self.to.get(axis), other.to.get(axis)) {
            (Some(a), Some(b)) => (a - b).abs() <= MOST_BESIDE,
            (a, b) => a == b,
        };
        self.axis == other.axis
            && self.tool == other.tool
            && common > 0.5 * (mine.1 - mine.0).min(theirs.1 - theirs.0)
            && Axis::ALL[..3].iter().all(|axis| *axis == self.axis || near(*axis))
    }

    /// Is the helix of the other one of the other hand?
    fn crosses(&self, other: &Pass) -> bool {
        let (Some(mine), Some(theirs)) = (self.way(), other.way()) else { return false };
        let turns = |pass: &Pass| pass.turning != Turning::Off;
        let same_way = (mine > 0.0) == (theirs > 0.0);
        turns(self) && turns(other) && same_way != (self.turning == other.turning)
    }
}

#[derive(Debug)]
pub(super) struct ThreadCrossed<'a> {
    tapping: Tapping<'a>,
    last: Option<Pass>,
}

impl<'a> ThreadCrossed<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> ThreadCrossed<'a> {
        ThreadCrossed { tapping: Tapping::new(setup), last: None }
    }
}

impl MotionRule for ThreadCrossed<'_> {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, say: Say<'_>) {
        let threads = matches!(step.mv.path, Path::Thread { .. });
        if step.of_cycle || !threads && !self.tapping.taps(step, machine) {
            return;
        }
        let ways = Axis::ALL[..3].iter().map(|axis| (*axis, step.way(*axis).unwrap_or_default().abs()));
        let Some((axis, way)) = ways.max_by(|a, b| a.1.total_cmp(&b.1)) else { return };
        if way < TINY {
            return;
        }
        let pass = Pass { axis, from: *step.from, to: step.to, turning: machine.turning, tool: machine.tool };
        if self.last.replace(pass).is_some_and(|last| pass.beside(&last) && pass.crosses(&last)) {
            let message = "this pass crosses the thread of the pass before: it is of the other hand";
            say.about(
                codes::L1036,
                step.origin,
                message,
                "reverse the spindle for the way out of a tapped hole; return beside a turned thread at rapid",
            );
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::ToolChange { .. } | Function::WorkOffset(_)) {
            self.last = None;
        }
    }

    fn lost(&mut self) {
        self.last = None;
    }
}
