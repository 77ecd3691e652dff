//! What the machine shall do: absolute millimetres, radius values, workpiece coordinates, nothing inherited.
//!
//! The comment of a variant says what its producer guarantees; [`super::verify::Motion`] checks it.

use crate::geo::{Element, Plane, Point2};
use crate::machine::axis::AxisSet;

use super::cycle::turning::Towards;
use super::tap::Part;
use super::{Feed, Function, Origin, Pos, Side, Tap};

/// A move from the end of the move before.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Move {
    /// All axes whose position is known after the move, in workpiece coordinates. Those that are not in `axes` stand
    /// where they stood before it.
    pub end: Pos,
    /// Axes this move is about: programmed ones, those a frame turned with them, and both of the plane of an arc or of an
    /// inserted corner. One at least, each with its place in `end`; whether it gets another coordinate is not said.
    pub axes: AxisSet,
    /// How the move gets to its end.
    pub path: Path,
    /// Side on which the target compensates the radius of its tool; [`Side::None`] where the compiler has done so.
    pub side: Side,
    /// Working plane, which compensation refers to. That of an arc may be another one: then a target cannot compensate it.
    pub plane: Plane,
    /// `end` is in machine coordinates and holds exactly `axes`; the path is straight. Afterwards the workpiece position of
    /// these axes is unknown.
    pub machine: bool,
}

/// How a move gets to its end, with the feed where it cuts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Path {
    /// A straight line as fast as the machine goes. What dog-legs it makes is for the machine.
    #[default]
    Rapid,
    /// A straight line; the feed is above zero and finite.
    Line(Feed),
    /// An arc, evenly along the other axes: a helix. The feed is above zero and finite.
    Arc(Arc, Feed),
    /// A straight line in the axes of the machine by which it makes `length` mm of a contour that the program sees in other
    /// axes, at `feed` mm per minute along that contour. Both are above zero and finite. What F that is depends on what the
    /// target measures.
    Carried { feed: f64, length: f64 },
    /// A line in step with the spindle: `lead` in mm along the path per turn, above zero.
    Thread { lead: f64 },
}

impl Path {
    /// A straight line at `feed`, or at rapid traverse without one.
    #[inline]
    pub fn straight(feed: Option<Feed>) -> Path {
        feed.map_or(Path::Rapid, Path::Line)
    }

    /// The feed where one counts along the axes: a thread goes with the spindle, what is carried out has its own.
    #[inline]
    pub fn feed(&self) -> Option<Feed> {
        match self {
            Path::Rapid | Path::Thread { .. } | Path::Carried { .. } => None,
            Path::Line(feed) | Path::Arc(_, feed) => Some(*feed),
        }
    }
}

/// An arc or helix, in workpiece coordinates, mm. Both ends lie on the circle, and the sweep leads from one to the
/// other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Plane of the circle, which need not be the working plane.
    pub plane: Plane,
    /// Where the arc starts, so that no printer has to remember.
    pub from: Point2,
    /// Centre of the circle, absolute; neither end lies in it.
    pub center: Point2,
    /// In rad, counter-clockwise positive seen against the plane normal; it is not zero and may exceed a turn.
    pub sweep: f64,
}

/// Where a tap begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// All axes whose position is known, in workpiece coordinates, that of the tap at its start.
    pub at: Pos,
    /// Working plane.
    pub plane: Plane,
}

impl Place {
    /// A move of a tap to this coordinate of its axis.
    pub fn along(&self, tap: &Tap, to: f64, path: Path) -> Move {
        let mut end = self.at;
        end.set(tap.axis, to);
        Move { end, axes: AxisSet::of(tap.axis), path, side: Side::None, plane: self.plane, machine: false }
    }
}

/// Takes what a program does, in order. Each item comes with the block that caused it.
pub trait Sink {
    /// The next move. It starts where the one before ends.
    fn movement(&mut self, mv: &Move, origin: &Origin);
    /// Happens after the move before and before the next one.
    fn function(&mut self, function: &Function, origin: &Origin);
    /// A hole is tapped, axis and spindle in step all the time. Who does not say otherwise gets it as its parts: lines in
    /// step with the spindle, and what the spindle does between them. Who hands items on hands this one on as it is.
    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        tap.parts(&mut |part| match part.function() {
            Some(function) => self.function(&function, origin),
            None => {
                if let Part::To(to) = part {
                    self.movement(&place.along(tap, to, Path::Thread { lead: tap.lead }), origin);
                }
            }
        });
    }
    /// What the target believes of its position no longer holds: an error was reported, or the program moves in a way that
    /// is not in the stream.
    fn lost(&mut self, origin: &Origin);
    /// The contour that the next moves run beside, element by element: for pictures. `start` is where the element begins.
    fn programmed(&mut self, _: &Move, _start: &Pos) {}
    /// A contour of a turned part, as (Z, radius), that the moves of a cycle before this cut down to, `into` the material: for
    /// pictures.
    fn finished(&mut self, _: &[Element], _into: Towards) {}
    /// Axes stand here, in workpiece coordinates, although no move said so.
    fn begins_at(&mut self, _: &Pos) {}
    /// What comes now is not taken any more, which was reported: the run may stop.
    fn full(&self) -> bool {
        false
    }
}
