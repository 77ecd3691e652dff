//! What the machine shall do: absolute millimetres, radius values, workpiece coordinates, nothing inherited.

use crate::geo::{Plane, Point2};
use crate::machine::axis::AxisSet;

use super::{Feed, Function, Origin, Pos, Side};

/// A move from the end of the move before.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Move {
    /// All axes whose position is known after the move.
    pub end: Pos,
    /// Axes this move is about: programmed ones, and those a frame turned with them.
    pub axes: AxisSet,
    pub path: Path,
    pub side: Side,
    /// Working plane, which compensation refers to.
    pub plane: Plane,
    /// `end` is in machine coordinates.
    pub machine: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Path {
    #[default]
    Rapid,
    Line(Feed),
    Arc(Arc, Feed),
    /// A line in step with the spindle: mm along the path per turn.
    Thread {
        lead: f64,
    },
}

impl Path {
    /// A straight line at `feed`, or at rapid traverse without one.
    #[inline]
    pub fn straight(feed: Option<Feed>) -> Path {
        feed.map_or(Path::Rapid, Path::Line)
    }

    /// The feed where one counts: a thread goes with the spindle.
    #[inline]
    pub fn feed(&self) -> Option<Feed> {
        match self {
            Path::Rapid | Path::Thread { .. } => None,
            Path::Line(feed) | Path::Arc(_, feed) => Some(*feed),
        }
    }
}

/// Arc or helix. `sweep` in rad, counter-clockwise positive seen against the plane normal; it may exceed
/// a turn. `from` is where the arc starts, so that no printer has to remember.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    pub plane: Plane,
    pub from: Point2,
    pub center: Point2,
    pub sweep: f64,
}

/// Takes what a program does, in order. Each item comes with the block that caused it.
pub trait Sink {
    fn movement(&mut self, mv: &Move, origin: &Origin);
    fn function(&mut self, function: &Function, origin: &Origin);
    /// What the target believes of its position no longer holds.
    fn lost(&mut self, origin: &Origin);
    /// Axes stand here although no move said so.
    fn begins_at(&mut self, _: &Pos) {}
    /// What comes now is not taken any more, which was reported: the run may stop.
    fn full(&self) -> bool {
        false
    }
}
