//! Figures of a program: ways, times, tools, extents.
//!
//! The model of time, which [`Model`] states: each move speeds up and slows down evenly. Two moves that follow each other
//! in nearly the same direction are passed at the slower of their speeds; between others the machine stops. A control
//! that looks further ahead, or limits the jerk, takes another time.

mod clock;
mod figures;

use crate::ir::motion::{Arc, Move, Path, Sink};
use crate::ir::{Function, Origin, Pos};
use crate::machine::Axis;

pub use clock::{Clock, Ended, Model, SMOOTH_DEG, Step, Time};
#[cfg(feature = "cli")]
pub use figures::Figures;
pub use figures::{Stats, ToolFigures};

#[cfg(feature = "cli")]
pub use figures::short;

/// Counts what goes by.
#[derive(Debug)]
pub struct Counter {
    stats: Stats,
    clock: Clock,
    tool: usize,
}

impl Counter {
    pub fn new(model: Model) -> Counter {
        Counter {
            stats: Stats { tools: vec![ToolFigures::default()], ..Stats::default() },
            clock: Clock::new(model),
            tool: 0,
        }
    }

    pub fn finish(mut self) -> Stats {
        let ended = self.clock.stop();
        self.add(ended);
        self.stats.tools.retain(|tool| tool.changes > 0 || tool.figures.moves > 0);
        self.stats
    }

    fn add(&mut self, ended: Option<Ended>) {
        let Some(ended) = ended else { return };
        let figures = &mut self.stats.tools[self.tool].figures;
        if ended.rapid {
            figures.rapid_time += ended.time;
        } else {
            figures.cutting_time += ended.time;
        }
    }

    fn take(&mut self, step: Step, is_rapid: bool) {
        self.add(step.ended);
        let Some(length) = step.length else {
            self.stats.unknown_moves += 1;
            return;
        };
        let figures = &mut self.stats.tools[self.tool].figures;
        figures.moves += 1;
        if is_rapid {
            figures.rapid += length;
        } else {
            figures.cutting += length;
        }
        if step.time == Time::Unknown {
            self.stats.untimed_moves += 1;
        }
    }

    fn cuts_to(&mut self, pos: &Pos) {
        for (axis, value) in pos.iter() {
            let extent = self.stats.extents.entry(axis).or_insert((value, value));
            *extent = (extent.0.min(value), extent.1.max(value));
        }
    }
}

/// The points of an arc that lie farthest along the axes of its plane.
fn farthest(arc: &Arc, mut take: impl FnMut(usize, f64)) {
    let (first, second, _) = arc.plane.axes();
    let to_start = arc.from - arc.center;
    let radius = libm::hypot(to_start.x, to_start.y);
    let start = libm::atan2(to_start.y, to_start.x);
    let (low, high) = (start.min(start + arc.sweep), start.max(start + arc.sweep));
    let quarter = core::f64::consts::FRAC_PI_2;
    let mut turn = libm::ceil(low / quarter);
    for _ in 0..4 {
        if turn * quarter > high {
            return;
        }
        take(first, arc.center.x + radius * libm::cos(turn * quarter));
        take(second, arc.center.y + radius * libm::sin(turn * quarter));
        turn += 1.0;
    }
}

impl Sink for Counter {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        let from = *self.clock.at();
        let step = self.clock.movement(mv);
        let is_rapid = matches!(mv.path, Path::Rapid);
        self.take(step, is_rapid);
        if mv.machine || is_rapid {
            return;
        }
        self.cuts_to(&from);
        let to = *self.clock.at();
        self.cuts_to(&to);
        if let Path::Arc(arc, _) = &mv.path {
            farthest(arc, |axis, value| {
                let mut pos = Pos::UNKNOWN;
                pos.set(Axis::ALL[axis], value);
                self.cuts_to(&pos);
            });
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        // What ends here was made with the tool before.
        let ended = self.clock.function(function);
        self.add(ended);
        if let Function::ToolChange { number } = function {
            let known = self.stats.tools.iter().position(|tool| tool.number == Some(*number));
            self.tool = known.unwrap_or_else(|| {
                self.stats.tools.push(ToolFigures { number: Some(*number), ..ToolFigures::default() });
                self.stats.tools.len() - 1
            });
            self.stats.tools[self.tool].changes += 1;
            self.stats.changes += 1;
            self.stats.change_time += self.clock.model().tool_change;
        } else if let Function::Dwell(seconds) = function {
            self.stats.dwell += seconds;
        }
    }

    fn lost(&mut self, _: &Origin) {
        let ended = self.clock.lost();
        self.add(ended);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.clock.begins_at(at);
    }
}

#[cfg(test)]
mod tests;
