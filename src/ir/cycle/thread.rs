//! Arguments of thread cutting: one line or a chain of lines, cut in passes in step with the spindle.

use core::fmt;

use crate::geo::{Deg, Plane, Point2};
use crate::ir::Pos;

use super::Family;
use super::turning::{Towards, is_coordinate, is_length, is_point, is_positive};

/// Most parts of a chain.
pub const MOST_PARTS: usize = 6;

/// A thread. Points are (Z, X) with X as a radius; all lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Thread {
    /// Start of the thread on its reference surface: the crest of an external thread, the bore of an internal one.
    pub start: Point2,
    /// One to six parts, each from the end of the one before.
    pub parts: Vec<ThreadPart>,
    /// Infeed direction. The lead, run-in and run-out count along the other axis.
    pub into: Towards,
    /// Depth from the reference surface, measured along the infeed axis; over 0.
    pub depth: f64,
    /// How the depth without the last cut is divided into cuts.
    pub infeed: Infeed,
    /// Where the cuts above the last one lie along the thread.
    pub flank: Flank,
    /// Depth left for a last cut of its own, 0 if there is none; under `depth`.
    pub finish: f64,
    /// So many cuts are repeated at full depth after the last one.
    pub air_cuts: u32,
    /// Length before the start on the extension of the first part, measured along the cutting axis, 0 or more.
    pub run_in: f64,
    /// Length after the end on the extension of the last part, measured along the cutting axis, 0 or more.
    pub run_out: f64,
    /// With a flank infeed only the start of a pass is shifted; otherwise its end moves along.
    pub fixed_end: bool,
    /// Number of starts, 1 or more. A part's `lead` is that of one start.
    pub starts: u32,
    /// Spindle angle of the first start, not negative. The target cannot start at an angle, so the length of the angle
    /// is added to the run-in: `angle / 360 · lead`.
    pub start_angle: Deg,
    /// Coordinate on the infeed axis (X radius or Z) at which the tool returns; clear of the whole thread.
    pub retract: f64,
    /// Where the tool stands afterwards; first its cutting axis, then its infeed axis is moved.
    pub park: Point2,
}

/// A piece of a thread with one lead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreadPart {
    /// End of the part on the reference surface, (Z, X) with X as a radius; the parts all advance along the cutting
    /// axis in one sense, and lean out of it by 45 degrees at most.
    pub end: Point2,
    /// mm per revolution along the cutting axis; over 0.
    pub lead: f64,
}

/// How the depth is divided into cuts. Lengths in mm, over 0; numbers of cuts from 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Infeed {
    /// Cut k lies at `first · √k` below the reference surface, so that each removes the same area; `first` is the depth
    /// of the first one, and the last one ends at the depth.
    ConstantArea { first: f64 },
    /// Equal cuts of at most `most`.
    Equal { most: f64 },
    /// The remainder first, then cuts of `most`; the last of them in 1/2, 1/4, 1/8 and 1/8.
    RemainderSplit { most: f64 },
    /// The remainder first, then cuts of `most`.
    Remainder { most: f64 },
    /// `passes` cuts of the same area.
    AreaPasses { passes: u32 },
    /// `passes` equal cuts.
    EqualPasses { passes: u32 },
}

/// Where the cuts above the last one lie, seen along the direction of cutting.
///
/// A shift slides the cut along its own line, so that its depth stays what it is. `d` is the depth of the
/// cut, `A` the angle.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Flank {
    /// All at the same place: infeed along the infeed axis alone.
    #[default]
    Radial,
    /// Ahead of the last one by `(depth - d) · tan A`; A is `angle`, 0 to below 90 degrees.
    Ahead { angle: Deg },
    /// Behind the last one by `(depth - d) · tan A`; A is `angle`.
    Behind { angle: Deg },
    /// The first ahead, the second behind, and so on, by `(depth - d) · tan A`; A is `angle`.
    Alternating { angle: Deg },
    /// Every cut ahead of the crest by `d · tan A`; A is `angle`.
    FromCrest { angle: Deg },
}

impl Flank {
    /// The angle between the infeed and the infeed axis; `None` for an infeed along it.
    pub fn angle(self) -> Option<Deg> {
        match self {
            Flank::Radial => None,
            Flank::Ahead { angle }
            | Flank::Behind { angle }
            | Flank::Alternating { angle }
            | Flank::FromCrest { angle } => Some(angle),
        }
    }
}

/// A thread argument that makes no thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadFault {
    /// No part, or more than six.
    Parts,
    /// A coordinate is not a finite number.
    Point,
    /// A lead is not over 0.
    Lead,
    /// A part does not advance along the cutting axis, or goes the other way than the first.
    Advance,
    /// A part leans more than 45 degrees out of the cutting axis.
    Steep,
    /// The depth is not over 0.
    Depth,
    /// The infeed, or the number of cuts, is not over 0.
    Infeed,
    /// The finishing cut is negative, or not under the depth.
    Finish,
    /// The flank angle is not in 0 to under 90 degrees.
    Angle,
    /// The run-in is negative.
    RunIn,
    /// The run-out is negative.
    RunOut,
    /// The thread has no start.
    Starts,
    /// The angle of the first start is negative.
    StartAngle,
    /// The return way is not clear of the thread.
    Retract,
}

impl fmt::Display for ThreadFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ThreadFault::Parts => "a thread has one to six parts",
            ThreadFault::Point => "a point of the thread is not a number",
            ThreadFault::Lead => "the pitch must be over 0",
            ThreadFault::Advance => "every part of a thread must advance the same way along the thread axis",
            ThreadFault::Steep => "a part of the thread leans more than 45 degrees out of the thread axis",
            ThreadFault::Depth => "the thread depth must be over 0",
            ThreadFault::Infeed => "the infeed must be over 0",
            ThreadFault::Finish => "the finishing cut must be less than the thread depth",
            ThreadFault::Angle => "the flank angle must lie between 0 and 90 degrees",
            ThreadFault::RunIn => "the run-in must not be negative",
            ThreadFault::RunOut => "the run-out must not be negative",
            ThreadFault::Starts => "a thread has at least one start",
            ThreadFault::StartAngle => "the start angle must not be negative",
            ThreadFault::Retract => "the tool does not stand clear of the thread, so it cannot return above it",
        })
    }
}

impl Family for Thread {
    type Fault = ThreadFault;

    fn check(&self) -> Result<(), ThreadFault> {
        self.check_values()?;
        self.check_line()?;
        self.check_retract()
    }

    fn leaves(&self, at: &mut Pos) {
        at.set_in_plane(Plane::Zx, self.park);
    }
}

impl Thread {
    fn check_values(&self) -> Result<(), ThreadFault> {
        let infeed = match self.infeed {
            Infeed::ConstantArea { first: cut }
            | Infeed::Equal { most: cut }
            | Infeed::RemainderSplit { most: cut }
            | Infeed::Remainder { most: cut } => is_positive(cut),
            Infeed::AreaPasses { passes } | Infeed::EqualPasses { passes } => passes > 0,
        };
        let angle = self.flank.angle().is_none_or(|Deg(angle)| is_length(angle) && angle < 90.0);
        let rules = [
            ((1..=MOST_PARTS).contains(&self.parts.len()), ThreadFault::Parts),
            (is_point(self.start) && is_point(self.park), ThreadFault::Point),
            (self.parts.iter().all(|part| is_point(part.end)), ThreadFault::Point),
            (self.parts.iter().all(|part| is_positive(part.lead)), ThreadFault::Lead),
            (is_positive(self.depth), ThreadFault::Depth),
            (infeed, ThreadFault::Infeed),
            (is_length(self.finish) && self.finish < self.depth, ThreadFault::Finish),
            (angle, ThreadFault::Angle),
            (is_length(self.run_in), ThreadFault::RunIn),
            (is_length(self.run_out), ThreadFault::RunOut),
            (self.starts > 0, ThreadFault::Starts),
            (is_length(self.start_angle.0), ThreadFault::StartAngle),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn check_line(&self) -> Result<(), ThreadFault> {
        let mut from = self.start;
        let mut sense = 0.0;
        for part in &self.parts {
            let way = part.end - from;
            let (along, aside) = if self.into.is_radial() { (way.x, way.y) } else { (way.y, way.x) };
            if along == 0.0 || along * sense < 0.0 {
                return Err(ThreadFault::Advance);
            }
            // A drawing says 45 degrees with rounded coordinates.
            if aside.abs() > along.abs() + 1e-3 {
                return Err(ThreadFault::Steep);
            }
            sense = along;
            from = part.end;
        }
        Ok(())
    }

    /// The way back must not touch the reference surface, neither along the thread nor on its extensions.
    fn check_retract(&self) -> Result<(), ThreadFault> {
        let out = -(self.into.unit().x + self.into.unit().y);
        let height = |p: Point2| self.into.depth_coordinate(p) * out;
        let (Some(first), Some(last)) = (self.parts.first(), self.parts.last()) else { return Err(ThreadFault::Parts) };
        let before_last = self.parts.iter().rev().nth(1).map_or(self.start, |part| part.end);
        let ends =
            [self.extended(first.end, self.start, self.run_in), self.extended(before_last, last.end, self.run_out)];
        let top = self.parts.iter().map(|part| part.end).chain(ends).map(height).fold(height(self.start), f64::max);
        if is_coordinate(self.retract) && self.retract * out > top { Ok(()) } else { Err(ThreadFault::Retract) }
    }

    /// The point `way` mm beyond `to` on the line from `from`, measured along the cutting axis.
    pub fn extended(&self, from: Point2, to: Point2, way: f64) -> Point2 {
        let line = to - from;
        let along = if self.into.is_radial() { line.x } else { line.y };
        to + line * (way / along.abs())
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// M20×1.5 external, Z5 to Z-20, tool at X26 Z5.
    pub(crate) fn m20() -> Thread {
        Thread {
            start: Point2::new(5.0, 10.0),
            parts: vec![ThreadPart { end: Point2::new(-20.0, 10.0), lead: 1.5 }],
            into: Towards::MinusX,
            depth: 0.92,
            infeed: Infeed::ConstantArea { first: 0.3 },
            flank: Flank::Radial,
            finish: 0.0,
            air_cuts: 0,
            run_in: 3.0,
            run_out: 1.0,
            fixed_end: false,
            starts: 1,
            start_angle: Deg(0.0),
            retract: 13.0,
            park: Point2::new(5.0, 13.0),
        }
    }

    #[test]
    fn every_bad_argument_has_its_name() {
        type Spoil = fn(&mut Thread);
        let cases: &[(ThreadFault, Spoil)] = &[
            (ThreadFault::Parts, |t| t.parts.clear()),
            (ThreadFault::Parts, |t| t.parts = vec![t.parts[0]; 7]),
            (ThreadFault::Point, |t| t.start.x = f64::NAN),
            (ThreadFault::Lead, |t| t.parts[0].lead = 0.0),
            (ThreadFault::Advance, |t| t.parts[0].end = t.start),
            (ThreadFault::Advance, |t| t.parts.push(ThreadPart { end: Point2::new(0.0, 10.0), lead: 1.0 })),
            (ThreadFault::Steep, |t| t.parts[0].end = Point2::new(0.0, 15.1)),
            (ThreadFault::Depth, |t| t.depth = -0.92),
            (ThreadFault::Infeed, |t| t.infeed = Infeed::Equal { most: 0.0 }),
            (ThreadFault::Infeed, |t| t.infeed = Infeed::AreaPasses { passes: 0 }),
            (ThreadFault::Finish, |t| t.finish = 0.92),
            (ThreadFault::Angle, |t| t.flank = Flank::Ahead { angle: Deg(90.0) }),
            (ThreadFault::RunIn, |t| t.run_in = -1.0),
            (ThreadFault::RunOut, |t| t.run_out = f64::INFINITY),
            (ThreadFault::Starts, |t| t.starts = 0),
            (ThreadFault::StartAngle, |t| t.start_angle = Deg(-1.0)),
            (ThreadFault::Retract, |t| t.retract = 10.0),
            (ThreadFault::Retract, |t| t.into = Towards::PlusX),
        ];
        assert_eq!(m20().check(), Ok(()));
        for (fault, spoil) in cases {
            let mut thread = m20();
            spoil(&mut thread);
            assert_eq!(thread.check(), Err(*fault));
        }
    }

    #[test]
    fn a_taper_must_clear_its_run_out() {
        // 2 mm radius over 20 mm: the run-out of 10 rises to X 13.
        let mut thread = m20();
        thread.start = Point2::new(0.0, 10.0);
        thread.parts[0].end = Point2::new(-20.0, 12.0);
        thread.run_out = 10.0;
        thread.retract = 12.9;
        assert_eq!(thread.check(), Err(ThreadFault::Retract));
        thread.retract = 13.1;
        assert_eq!(thread.check(), Ok(()));
    }
}
