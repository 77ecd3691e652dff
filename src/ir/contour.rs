//! What was programmed, without its dialect: absolute coordinates in the programmed frame, millimetres,
//! radius values; arcs by whatever data the program gave, corners still to be cut.
//!
//! The comment of a variant says what its producer guarantees; [`super::verify::Contour`] checks it.

use std::rc::Rc;

use crate::geo::{Deg, Plane, Point2};
use crate::machine::Axis;

use super::captured::{Captured, Unfit};
use super::cycle::Cycle;
use super::undercut::Undercut;
use super::{Ask, Compensation, Feed, Frame, Function, Origin, Pos, Side, Tap};

/// Farthest that a coordinate, centre or radius may lie, in mm: 100 km. Beyond, binary fractions are coarser than what
/// the streams promise.
pub const FARTHEST: f64 = 1e8;

/// State that holds for many items; a new one is made only when something in it changes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ctx {
    /// Working plane.
    pub plane: Plane,
    /// From programmed to workpiece coordinates.
    pub frame: Frame,
    /// How the compiler compensates moves with a side; `None` leaves them to the target.
    pub compensation: Option<Rc<Compensation>>,
}

/// Shared by the items that came under the same state; a new one stands for a change.
pub type CtxRef = Rc<Ctx>;

/// A programmed path element. It starts where the item before left the tool; where that is not known the producer
/// has refused every element that needs it, so that only straight moves follow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Programmed axes only, one at least, rotary ones in degrees; the others stay. Polar and incremental words are
    /// resolved.
    pub end: Pos,
    /// How the move gets to its end.
    pub path: Path,
    /// Side of the compensation in force during the move. It may change at any move: what the target cannot switch
    /// there it refuses.
    pub side: Side,
    /// In which system `end` counts.
    pub coords: Coords,
}

impl Move {
    /// Does a number lie farther out than can be computed with?
    #[inline]
    pub fn is_out_of_range(&self) -> bool {
        let arc = match &self.path {
            Path::Arc(arc, _) => arc.shape.farthest(),
            Path::Rapid | Path::Line(_) | Path::Thread(_) => 0.0,
        };
        self.end.exceeds(FARTHEST) || arc.is_nan() || arc > FARTHEST
    }
}

/// In which system the end point counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Coords {
    /// The frame of the context.
    #[default]
    Frame,
    /// Machine coordinates: frame and work offset do not apply. The path is straight; afterwards the programmed position
    /// of these axes, and of all that depend on them under a rotation, is unknown until an absolute word names them.
    Machine,
}

/// How a move gets to its end, with the feed where it cuts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// A straight line as fast as the machine goes. What dog-legs it makes is for the machine.
    Rapid,
    /// A straight line in all axes together. The feed is above zero and finite.
    Line(Feed),
    /// An arc, evenly along the other axes: a helix. The feed is above zero and finite.
    Arc(Arc, Feed),
    /// The spindle turns, as far as the producer can tell.
    Thread(Thread),
}

impl Path {
    /// A straight line at `feed`, or at rapid traverse without one.
    #[inline]
    pub fn straight(feed: Option<Feed>) -> Path {
        feed.map_or(Path::Rapid, Path::Line)
    }

    /// Does the move go at rapid traverse?
    #[inline]
    pub fn is_rapid(&self) -> bool {
        matches!(self, Path::Rapid)
    }
}

/// A line cut in step with the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thread {
    /// Travel per turn of the spindle in mm, above zero.
    pub lead: f64,
    /// Axis along which `lead` counts; `None` for along the path.
    pub along: Option<Axis>,
}

/// An arc or helix in `plane`, which need not be the working plane. Its start in the plane is known, its end is named or
/// stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Plane of the circle; its centre and points are coordinates in it.
    pub plane: Plane,
    /// What the program gave of the circle.
    pub shape: ArcShape,
    /// Whole turns on top of what the shape says.
    pub turns: u32,
}

/// An arc by the data that the program gave. Points are absolute coordinates of the plane, mm; `ccw` is
/// counter-clockwise, seen against the plane normal; tolerances are not below zero. Whether the arc exists is for lower
/// to say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ArcShape {
    /// About `center` in the sense of `ccw` to the end point, which may miss the circle by `tol` mm. End on start: a
    /// full circle.
    Center { center: Point2, ccw: bool, tol: f64 },
    /// About `center` by exactly `sweep` degrees, counter-clockwise positive, any number of turns. The end
    /// point is the one that follows from it.
    Sweep { center: Point2, sweep: Deg },
    /// By `radius` in mm, which is not zero, in the sense of `ccw`; a negative one takes the longer arc. The end may
    /// lie `tol` mm too far.
    Radius { radius: f64, ccw: bool, tol: f64 },
    /// By the angle between the radii to its ends: `sweep` degrees, counter-clockwise positive, not zero and below a
    /// turn.
    Opening { sweep: Deg },
    /// Through `point`, which lies between its ends.
    Via { point: Point2 },
    /// Tangential to the element before. That there is one with a direction is checked in lower.
    Tangent,
}

impl Arc {
    /// Turns that are complete before the one that leads to its end.
    #[inline]
    pub fn whole_turns(&self) -> u64 {
        let sweep = match self.shape {
            ArcShape::Sweep { sweep, .. } => (sweep.0.abs() / 360.0) as u64,
            ArcShape::Center { .. }
            | ArcShape::Radius { .. }
            | ArcShape::Opening { .. }
            | ArcShape::Via { .. }
            | ArcShape::Tangent => 0,
        };
        sweep + u64::from(self.turns)
    }
}

impl ArcShape {
    /// The largest of its numbers that are coordinates or lengths.
    fn farthest(&self) -> f64 {
        match *self {
            ArcShape::Center { center: point, .. }
            | ArcShape::Sweep { center: point, .. }
            | ArcShape::Via { point } => point.x.abs().max(point.y.abs()),
            ArcShape::Radius { radius, .. } => radius.abs(),
            ArcShape::Opening { .. } | ArcShape::Tangent => 0.0,
        }
    }
}

/// What happens at the corner between the element before and the next one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// What is inserted between the two elements.
    pub shape: CornerShape,
    /// Feed on the inserted element; `None` for the feed of the next element, or of the one before where that is rapid.
    pub feed: Option<Feed>,
    /// What happens between the two elements comes before the inserted one, not after it.
    pub early: bool,
    /// Asked for at every corner: where there is none, nothing is inserted and nothing is said.
    pub modal: bool,
    /// What becomes of it where it cuts off more than a neighbour has.
    pub large: LargeCorner,
    /// What becomes of a chamfer where a neighbour is an arc.
    pub at_arc: ArcChamfer,
    /// What becomes of blocks between the two elements that move nothing.
    pub blocks: Blocks,
}

/// What becomes of blocks between a corner and its elements that move nothing. Comments are no blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Blocks {
    /// The control looks past them; how many of them is for the dialect to count.
    PassedOver,
    /// No manual allows them: M functions are passed over with a warning, anything else is refused.
    Unconfirmed,
}

/// What becomes of a chamfer beside an arc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcChamfer {
    /// The control knows none.
    Refuse,
    /// The control makes it, but how it lies, or is measured, is not confirmed: the user may choose ours.
    Ask(&'static Ask),
    /// It stands at a right angle to the bisector of the corner, its ends on both elements.
    AcrossBisector,
    /// Its width is measured along each element.
    Along,
}

/// What becomes of a corner that cuts off more than a neighbour has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LargeCorner {
    /// The control refuses it.
    Refuse,
    /// The control makes it smaller, but its way is not documented: the user may choose ours.
    Ask(&'static Ask),
    /// It is made as large as it fits.
    Shorten,
}

/// What is inserted at a corner. Sizes are finite; whether they fit is for lower to say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CornerShape {
    /// Arc of `radius` mm, above zero, tangential to both neighbours.
    Rounding { radius: f64 },
    /// Chamfer by the length `side` in mm that it cuts off each neighbour, above zero.
    Chamfer { side: f64 },
    /// Chamfer by its own `length` in mm, above zero.
    ChamferLength { length: f64 },
    /// Relief of an inside corner of a turned part; in the plane ZX only.
    Undercut(Undercut),
}

/// What a sink took so far: what a run costs shows here, not in the number of its blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Load {
    /// Moves, those of cycles and of described contours included; what takes as long as several counts as several.
    pub moves: u64,
    /// The output takes no more, which was reported.
    pub full: bool,
}

/// Takes what was programmed, in order. Each item comes with the state it was programmed under and the
/// block that caused it.
pub trait Sink {
    /// The next element of the path.
    fn movement(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin);
    /// A corner at the end of the last element; the next element is its second neighbour.
    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin);
    /// Happens after the element before and in front of the next one, in the order of the calls. Where a corner waits for
    /// its second neighbour, functions wait with it: those before it in the stream come in front of the inserted element,
    /// those after it behind, or in front as [`Corner::early`] says. A tool change, work offset, plane or end does not
    /// wait: a corner in front of it has no second neighbour.
    fn function(&mut self, function: &Function, ctx: &CtxRef, origin: &Origin);
    /// A hole is tapped from where the tool stands, axis and spindle in step all the time. No corner waits for it, and no move
    /// is compensated.
    fn tap(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin);
    /// A cycle with all its arguments; where it leaves the tool is [`Cycle::leaves`].
    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin);
    /// The position is no longer what the moves so far say: an error was reported, or the program moves in
    /// a way that is not in the stream. Sent before the next element, never between the two neighbours of a corner that is
    /// to be cut. All axes are unknown behind it: who knows some of them better keeps that to himself and refuses only
    /// what needs the others.
    fn lost(&mut self, ctx: &CtxRef, origin: &Origin);
    /// Before everything else: the tool stands here, although no move says so; in the programmed frame.
    fn begins_at(&mut self, at: &Pos);
    /// Behind a tool change or a move in machine coordinates: these axes stand here, in the frame of `ctx`, although no move
    /// says so. Nothing is compensated, and no corner waits.
    fn stands_at(&mut self, at: &Pos, ctx: &CtxRef, origin: &Origin);
    /// What was taken so far. Looked at once per block, and between the places of a pattern.
    fn load(&self) -> Load;
    /// From here on the moves describe a contour of at most `limit` elements and are not carried out. The position is
    /// unknown inside and afterwards what it was.
    fn contour_begins(&mut self, limit: usize, ctx: &CtxRef, origin: &Origin);
    /// The description is complete.
    ///
    /// # Errors
    /// See [`Unfit`].
    fn contour_ends(&mut self, origin: &Origin) -> Result<Captured, Unfit>;
}
