//! A pass crosses the thread that the pass before has cut.

use crate::ir::motion::Path;
use crate::ir::{Function, Origin, Pos};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step, TINY, Turning};
use crate::lint::tapping::Tapping;
use crate::machine::Axis;

super::rule! { L1036 Motion ThreadCrossed Warning "thread-crossed"
    what "pass crosses the thread that the pass before has cut"
    why "Two passes lie in one thread, and the second makes a helix of the other hand: it goes the other way while the spindle \
        turns as before, or the same way while the spindle turns the other way. A tap that comes out so tears the thread or \
        breaks; a turned thread is destroyed. Reverse the spindle (M3, M4) for the way out of a tapped hole; return beside a \
        turned thread at rapid. Cycles reverse the spindle by themselves."
    example r#"
-- Example (L1036_fires_tap.H)
0 BEGIN PGM P MM
; M3 in and M3 out.
1 TOOL CALL 1 Z S500
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-10 F750
4 L Z+5
5 L Z+50 FMAX M30
6 END PGM P MM
-- partc.toml
[tools.1]
kind = "tap"
radius = 5.0
"#
    says {
        crosses() "this pass crosses the thread of the pass before: it is of the other hand"
            help "reverse the spindle for the way out of a tapped hole; return beside a turned thread at rapid";
    }
}

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
            say.about(L1036::crosses(), step.origin);
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::ToolChange { .. } | Function::WorkOffset(_) | Function::Tilt(_)) {
            self.last = None;
        }
    }

    fn lost(&mut self) {
        self.last = None;
    }
}
