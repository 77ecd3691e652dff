//! Figures of a program: ways, times, tools, extents.
//!
//! The model of time, which [`Model`] states: each move speeds up and slows down evenly. Two moves that follow each other
//! in nearly the same direction are passed at the slower of their speeds; between others the machine stops. A control
//! that looks further ahead, or limits the jerk, takes another time.

mod clock;
mod object;

use std::collections::BTreeMap;

use crate::ir::motion::{Arc, Move, Path, Sink};
use crate::ir::{Function, Origin, Pos};
use crate::machine::Axis;

pub use clock::{Clock, Ended, Step, Time};

#[cfg(feature = "cli")]
pub use object::short;

/// Directions that differ by less than this, in degrees, are passed without a stop.
pub const SMOOTH_DEG: f64 = 10.0;
/// What the machine is taken for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Model {
    /// Rapid traverse, mm/min.
    pub rapid: f64,
    /// Acceleration along the path, m/s².
    pub acceleration: f64,
    /// Seconds of a tool change.
    pub tool_change: f64,
}

impl Default for Model {
    fn default() -> Model {
        Model { rapid: 10_000.0, acceleration: 1.0, tool_change: 0.0 }
    }
}

/// What was counted; lengths in mm, times in seconds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Figures {
    pub cutting: f64,
    pub rapid: f64,
    pub cutting_time: f64,
    pub rapid_time: f64,
    pub moves: u64,
}

impl Figures {
    fn add(&mut self, other: &Figures) {
        self.cutting += other.cutting;
        self.rapid += other.rapid;
        self.cutting_time += other.cutting_time;
        self.rapid_time += other.rapid_time;
        self.moves += other.moves;
    }
}

/// A tool in the order of its first change.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ToolFigures {
    pub number: Option<u32>,
    pub changes: u32,
    pub figures: Figures,
}

/// The figures of a program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stats {
    pub tools: Vec<ToolFigures>,
    /// Least and greatest coordinate of cuts, by axis, in the workpiece.
    pub extents: BTreeMap<Axis, (f64, f64)>,
    pub dwell: f64,
    pub changes: u32,
    pub change_time: f64,
    /// Moves whose start is not known: neither their way nor their time is in the figures.
    pub unknown_moves: u64,
    /// Moves whose speed is not known, such as a feed per turn without a speed: their way counts, their time does not.
    pub untimed_moves: u64,
}

impl Stats {
    pub fn total(&self) -> Figures {
        let mut all = Figures::default();
        self.tools.iter().for_each(|tool| all.add(&tool.figures));
        all
    }

    /// Seconds of everything.
    pub fn time(&self) -> f64 {
        let all = self.total();
        all.cutting_time + all.rapid_time + self.dwell + self.change_time
    }
}

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
