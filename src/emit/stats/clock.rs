//! How long each move takes.
//!
//! The time of a move is known when the next one shows how it ends. In: moves and functions in order. Out: the length of each
//! move at once, its time when it has ended, by the number of the move.

use crate::ir::function::Spindle;
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Feed, Function, Pos};
use crate::machine::Axis;

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

/// Ways shorter than this are none, mm.
const TINY: f64 = 1e-9;
/// After so many moves without a way the machine stands: who waits for a time waits no longer.
const MOST_STILL: u32 = 1 << 16;

/// A move has ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ended {
    /// Its number, from 0.
    pub number: u64,
    pub rapid: bool,
    /// Seconds.
    pub time: f64,
}

/// What is known of the time of a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Time {
    /// The next moves tell: see [`Ended`].
    Later,
    /// A move without a way takes none.
    None,
    /// Its start or its speed is not known.
    Unknown,
}

/// A move has begun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// The move before, if its time was still open.
    pub ended: Option<Ended>,
    /// Length of the way in mm, or degrees where only rotary axes move; `None` where its start is not known.
    pub length: Option<f64>,
    pub time: Time,
}

/// A move that waits for the next one: how it ends depends on that.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    number: u64,
    length: f64,
    /// mm/s
    speed: f64,
    from_speed: f64,
    leaves: [f64; 3],
    rapid: bool,
}

/// Follows the moves of a program.
#[derive(Debug)]
pub struct Clock {
    model: Model,
    at: Pos,
    /// Moves so far.
    moves: u64,
    waiting: Option<Waiting>,
    /// Moves without a way since the one that waits.
    still: u32,
    /// rev/min
    speed: Option<f64>,
    /// m/min and the limit in rev/min.
    cutting_speed: Option<(f64, Option<f64>)>,
    /// Cosine of the largest angle that is passed without a stop.
    smooth: f64,
}

impl Clock {
    pub fn new(model: Model) -> Clock {
        let smooth = libm::cos(SMOOTH_DEG.to_radians());
        Clock { model, at: Pos::UNKNOWN, moves: 0, waiting: None, still: 0, speed: None, cutting_speed: None, smooth }
    }

    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Where the machine stands, in the workpiece.
    pub fn at(&self) -> &Pos {
        &self.at
    }

    /// The number of the move whose time is open.
    pub fn open(&self) -> Option<u64> {
        self.waiting.map(|waiting| waiting.number)
    }

    /// The move that waits ends at rest.
    pub fn stop(&mut self) -> Option<Ended> {
        self.end_at(0.0)
    }

    fn end_at(&mut self, speed: f64) -> Option<Ended> {
        let waiting = self.waiting.take()?;
        let acceleration = self.model.acceleration * 1000.0;
        let time = time_of(waiting.length, waiting.from_speed, waiting.speed, speed, acceleration);
        Some(Ended { number: waiting.number, rapid: waiting.rapid, time })
    }

    /// mm/s of a move; `None` where it is not known.
    fn speed_of(&self, mv: &Move, length: f64) -> Option<f64> {
        let per_minute = match &mv.path {
            Path::Rapid => self.model.rapid,
            Path::Line(feed) | Path::Arc(_, feed) => match *feed {
                Feed::PerMinute(feed) => feed,
                Feed::PerRevolution(feed) => feed * self.turns(mv)?,
                Feed::InverseTime(moves) => length * moves,
            },
            Path::Carried { feed, length: along } => feed * length / along,
            Path::Thread { lead } => lead * self.turns(mv)?,
        };
        (per_minute > 0.0 && per_minute.is_finite()).then_some(per_minute / 60.0)
    }

    /// Turns of the spindle a minute; under constant cutting speed those that give the time of a straight move to another
    /// radius.
    fn turns(&self, mv: &Move) -> Option<f64> {
        let Some((speed, limit)) = self.cutting_speed else { return self.speed };
        let from = self.at.get(Axis::X)?;
        let to = mv.end.get(Axis::X).filter(|_| mv.axes.contains(Axis::X)).unwrap_or(from);
        // At this radius and below the spindle turns at its limit.
        let per_turn = 1000.0 * speed / core::f64::consts::TAU;
        let least = limit.map_or(0.0, |limit| per_turn / limit.max(TINY));
        Some(per_turn / mean_radius(from, to, least).max(TINY))
    }

    /// Takes a move.
    pub fn movement(&mut self, mv: &Move) -> Step {
        let number = self.moves;
        self.moves += 1;
        let step = self.step(mv, number);
        if mv.machine {
            mv.axes.iter().for_each(|axis| self.at.forget(axis));
        } else {
            self.at.update(&mv.end);
        }
        step
    }

    fn step(&mut self, mv: &Move, number: u64) -> Step {
        let Some((length, enters, leaves)) = way(mv, &self.at) else {
            return Step { ended: self.stop(), length: None, time: Time::Unknown };
        };
        if length < TINY {
            self.still = self.still.saturating_add(1);
            let ended = if self.still > MOST_STILL { self.stop() } else { None };
            return Step { ended, length: Some(0.0), time: Time::None };
        }
        let Some(speed) = self.speed_of(mv, length) else {
            return Step { ended: self.stop(), length: Some(length), time: Time::Unknown };
        };
        let joint = match &self.waiting {
            Some(before) if cosine(before.leaves, enters) > self.smooth => {
                // No faster than the way before lets it become.
                let reach = before.from_speed * before.from_speed + 2000.0 * self.model.acceleration * before.length;
                before.speed.min(speed).min(libm::sqrt(reach))
            }
            _ => 0.0,
        };
        let ended = self.end_at(joint);
        let rapid = matches!(mv.path, Path::Rapid);
        self.waiting = Some(Waiting { number, length, speed, from_speed: joint, leaves, rapid });
        self.still = 0;
        Step { ended, length: Some(length), time: Time::Later }
    }

    /// Takes what is no move.
    pub fn function(&mut self, function: &Function) -> Option<Ended> {
        match function {
            Function::ToolChange { .. }
            | Function::Dwell(_)
            | Function::Stop
            | Function::OptionalStop
            | Function::End { .. } => self.stop(),
            Function::Spindle(Spindle::Speed(speed)) => {
                self.speed = Some(*speed);
                self.cutting_speed = None;
                None
            }
            Function::Spindle(Spindle::CuttingSpeed { speed, limit }) => {
                self.cutting_speed = Some((*speed, *limit));
                None
            }
            // How far rotary axes turn is for the machine.
            Function::WorkOffset(_) | Function::Tilt(_) => self.lost(),
            Function::Plane(_)
            | Function::PathControl(_)
            | Function::Comment(_)
            | Function::Remark(_)
            | Function::Aux(_)
            | Function::Coolant(_)
            | Function::Cutter(_)
            | Function::FeedSpindle(_)
            | Function::Spindle(_)
            | Function::SpindleOf { .. }
            | Function::ToolPrepare { .. }
            | Function::Transformation(_) => None,
        }
    }

    /// Nobody knows where the machine stands.
    pub fn lost(&mut self) -> Option<Ended> {
        self.at.clear();
        self.stop()
    }

    /// Axes stand here although no move said so.
    pub fn begins_at(&mut self, at: &Pos) {
        self.at.update(at);
    }
}

/// Mean of the radius on the way from one X to another, where a smaller one than `least` counts as that.
fn mean_radius(from: f64, to: f64, least: f64) -> f64 {
    let sum = |x: f64| {
        let radius = x.abs();
        let half = if radius <= least { least * radius } else { (radius * radius + least * least) / 2.0 };
        half.copysign(x)
    };
    let way = to - from;
    if way.abs() < TINY { from.abs().max(least) } else { (sum(to) - sum(from)) / way }
}

/// Seconds for a way between two speeds.
pub(super) fn time_of(length: f64, from: f64, most: f64, to: f64, acceleration: f64) -> f64 {
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

/// Of the angle between two directions.
fn cosine(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
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

pub(super) fn along_arc(arc: &Arc, linear: [f64; 3]) -> (f64, [f64; 3], [f64; 3]) {
    let (first, second, third) = arc.plane.axes();
    let to_start = arc.from - arc.center;
    let to_end = [to_start.x + linear[first], to_start.y + linear[second]];
    let radius = libm::hypot(to_start.x, to_start.y);
    let flat = radius * arc.sweep.abs();
    let length = libm::hypot(flat, linear[third]);
    let tangent = |[x, y]: [f64; 2], radius: f64| {
        let mut direction = [0.0; 3];
        if length > TINY {
            let share = arc.sweep.signum() * flat / length / radius.max(TINY);
            direction[first] = -y * share;
            direction[second] = x * share;
            direction[third] = linear[third] / length;
        }
        direction
    };
    let end_radius = libm::sqrt(to_end[0] * to_end[0] + to_end[1] * to_end[1]);
    (length, tangent([to_start.x, to_start.y], radius), tangent(to_end, end_radius))
}
