//! Figures of a program: ways, times, tools, extents.
//!
//! The model of time, which [`Model`] states: each move speeds up and slows down evenly. Two moves that follow each other
//! in nearly the same direction are passed at the slower of their speeds; between others the machine stops. A control
//! that looks further ahead, or limits the jerk, takes another time.

mod object;

use std::collections::BTreeMap;

use crate::geo::Plane;
use crate::ir::function::Spindle;
use crate::ir::motion::{Arc, Move, Path, Sink};
use crate::ir::{Feed, Function, Origin, Pos};
use crate::machine::Axis;

#[cfg(feature = "cli")]
pub use object::short;

/// Directions that differ by less than this, in degrees, are passed without a stop.
pub const SMOOTH_DEG: f64 = 10.0;
/// Ways shorter than this are none, mm.
const TINY: f64 = 1e-9;

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

/// A move that waits for the next one: how it ends depends on that.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    length: f64,
    /// mm/s
    speed: f64,
    from_speed: f64,
    leaves: [f64; 3],
    rapid: bool,
}

/// Counts what goes by.
#[derive(Debug)]
pub struct Counter {
    stats: Stats,
    model: Model,
    at: Pos,
    tool: usize,
    waiting: Option<Waiting>,
    /// rev/min
    speed: Option<f64>,
    /// m/min and the limit in rev/min.
    cutting_speed: Option<(f64, Option<f64>)>,
}

impl Counter {
    pub fn new(model: Model) -> Counter {
        Counter {
            stats: Stats { tools: vec![ToolFigures::default()], ..Stats::default() },
            model,
            at: Pos::UNKNOWN,
            tool: 0,
            waiting: None,
            speed: None,
            cutting_speed: None,
        }
    }

    pub fn finish(mut self) -> Stats {
        self.stop();
        self.stats.tools.retain(|tool| tool.changes > 0 || tool.figures.moves > 0);
        self.stats
    }

    /// The move that waits ends at rest.
    fn stop(&mut self) {
        self.end_at(0.0);
    }

    fn end_at(&mut self, speed: f64) {
        let Some(waiting) = self.waiting.take() else { return };
        let acceleration = self.model.acceleration * 1000.0;
        let time = time_of(waiting.length, waiting.from_speed, waiting.speed, speed, acceleration);
        let figures = &mut self.stats.tools[self.tool].figures;
        if waiting.rapid {
            figures.rapid_time += time;
        } else {
            figures.cutting_time += time;
        }
    }

    /// mm/s of a move; `None` where it is not known.
    fn speed_of(&self, path: &Path, length: f64) -> Option<f64> {
        let per_minute = match path {
            Path::Rapid => self.model.rapid,
            Path::Line(feed) | Path::Arc(_, feed) => match *feed {
                Feed::PerMinute(feed) => feed,
                Feed::PerRevolution(feed) => feed * self.turns()?,
                Feed::InverseTime(moves) => length * moves,
            },
            Path::Carried { feed, length: along } => feed * length / along,
            Path::Thread { lead } => lead * self.turns()?,
        };
        (per_minute > 0.0 && per_minute.is_finite()).then_some(per_minute / 60.0)
    }

    /// Turns of the spindle a minute.
    fn turns(&self) -> Option<f64> {
        let Some((speed, limit)) = self.cutting_speed else { return self.speed };
        let radius = self.at.get(Axis::X)?.abs();
        let turns = 1000.0 * speed / (2.0 * core::f64::consts::PI * radius).max(TINY);
        Some(limit.map_or(turns, |limit| turns.min(limit)))
    }

    fn take(&mut self, mv: &Move, from: &Pos) {
        let is_rapid = matches!(mv.path, Path::Rapid);
        let Some((length, enters, leaves)) = way(mv, from) else {
            self.stop();
            self.stats.unknown_moves += 1;
            return;
        };
        let figures = &mut self.stats.tools[self.tool].figures;
        figures.moves += 1;
        if length < TINY {
            return;
        }
        if is_rapid {
            figures.rapid += length;
        } else {
            figures.cutting += length;
        }
        let Some(speed) = self.speed_of(&mv.path, length) else {
            self.stop();
            self.stats.untimed_moves += 1;
            return;
        };
        let joint = match &self.waiting {
            Some(before) if is_smooth(before.leaves, enters) => {
                // No faster than the way before lets it become.
                let reach = before.from_speed * before.from_speed + 2000.0 * self.model.acceleration * before.length;
                before.speed.min(speed).min(libm::sqrt(reach))
            }
            _ => 0.0,
        };
        self.end_at(joint);
        self.waiting = Some(Waiting { length, speed, from_speed: joint, leaves, rapid: is_rapid });
    }

    fn cuts_to(&mut self, pos: &Pos) {
        for (axis, value) in pos.iter() {
            let extent = self.stats.extents.entry(axis).or_insert((value, value));
            *extent = (extent.0.min(value), extent.1.max(value));
        }
    }
}

/// Seconds for a way between two speeds.
fn time_of(length: f64, from: f64, most: f64, to: f64, acceleration: f64) -> f64 {
    let speeding = (most * most - from * from) / (2.0 * acceleration);
    let slowing = (most * most - to * to) / (2.0 * acceleration);
    let even = length - speeding - slowing;
    if even >= 0.0 {
        return (2.0 * most - from - to) / acceleration + even / most;
    }
    let peak = libm::sqrt(acceleration * length + (from * from + to * to) / 2.0);
    if peak >= from.max(to) {
        (2.0 * peak - from - to) / acceleration
    } else {
        // Too short to change its speed so much.
        2.0 * length / (from + to).max(TINY)
    }
}

/// Is the angle between two directions small?
fn is_smooth(a: [f64; 3], b: [f64; 3]) -> bool {
    let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    dot > libm::cos(SMOOTH_DEG.to_radians())
}

/// Length of a move in mm, or degrees where only rotary axes move, with the directions at its ends; `None` where its start
/// is not known.
fn way(mv: &Move, from: &Pos) -> Option<(f64, [f64; 3], [f64; 3])> {
    if mv.machine {
        return None;
    }
    let delta = |axis: Axis| -> Option<f64> {
        if !mv.axes.contains(axis) {
            return Some(0.0);
        }
        Some(mv.end.get(axis)? - from.get(axis)?)
    };
    let mut linear = [delta(Axis::X)?, delta(Axis::Y)?, delta(Axis::Z)?];
    if let Path::Arc(arc, _) = &mv.path {
        return Some(along_arc(arc, linear));
    }
    let square: f64 = linear.iter().map(|d| d * d).sum();
    let length = libm::sqrt(square);
    if length > TINY {
        linear.iter_mut().for_each(|d| *d /= length);
        return Some((length, linear, linear));
    }
    let mut square = 0.0;
    for axis in mv.axes.iter().filter(|axis| !matches!(axis, Axis::X | Axis::Y | Axis::Z)) {
        let way = delta(axis)?;
        square += way * way;
    }
    Some((libm::sqrt(square), [0.0; 3], [0.0; 3]))
}

fn along_arc(arc: &Arc, linear: [f64; 3]) -> (f64, [f64; 3], [f64; 3]) {
    let (first, second, third) = arc.plane.axes();
    let to_start = arc.from - arc.center;
    let radius = libm::hypot(to_start.x, to_start.y);
    let flat = radius * arc.sweep.abs();
    let length = libm::hypot(flat, linear[third]);
    let tangent = |angle: f64| {
        let sign = arc.sweep.signum();
        let mut direction = [0.0; 3];
        let share = if length > TINY { flat / length } else { 0.0 };
        direction[first] = -libm::sin(angle) * sign * share;
        direction[second] = libm::cos(angle) * sign * share;
        direction[third] = if length > TINY { linear[third] / length } else { 0.0 };
        direction
    };
    let start = libm::atan2(to_start.y, to_start.x);
    (length, tangent(start), tangent(start + arc.sweep))
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
        let from = self.at;
        self.take(mv, &from);
        if mv.machine {
            mv.axes.iter().for_each(|axis| self.at.forget(axis));
            return;
        }
        self.at.update(&mv.end);
        if matches!(mv.path, Path::Rapid) {
            return;
        }
        self.cuts_to(&from);
        let to = self.at;
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
        match function {
            Function::ToolChange { number } => {
                self.stop();
                let known = self.stats.tools.iter().position(|tool| tool.number == Some(*number));
                self.tool = known.unwrap_or_else(|| {
                    self.stats.tools.push(ToolFigures { number: Some(*number), ..ToolFigures::default() });
                    self.stats.tools.len() - 1
                });
                self.stats.tools[self.tool].changes += 1;
                self.stats.changes += 1;
                self.stats.change_time += self.model.tool_change;
            }
            Function::Dwell(seconds) => {
                self.stop();
                self.stats.dwell += seconds;
            }
            Function::Spindle(Spindle::Speed(speed)) => {
                self.speed = Some(*speed);
                self.cutting_speed = None;
            }
            Function::Spindle(Spindle::CuttingSpeed { speed, limit }) => self.cutting_speed = Some((*speed, *limit)),
            Function::Stop | Function::OptionalStop | Function::End { .. } => self.stop(),
            Function::WorkOffset(_) => {
                self.stop();
                self.at.clear();
            }
            Function::Plane(Plane::Xy | Plane::Zx | Plane::Yz)
            | Function::Comment(_)
            | Function::Aux(_)
            | Function::Coolant(_)
            | Function::Cutter(_)
            | Function::FeedSpindle(_)
            | Function::Spindle(_)
            | Function::SpindleOf { .. }
            | Function::ToolPrepare { .. }
            | Function::Transformation(_) => {}
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.stop();
        self.at.clear();
    }

    fn begins_at(&mut self, at: &Pos) {
        self.at.update(at);
    }
}

#[cfg(test)]
mod tests;
