//! What was programmed, without its dialect: absolute coordinates in the programmed frame, millimetres,
//! radius values; arcs by whatever data the program gave, corners still to be cut.

use std::rc::Rc;

use crate::geo::{Deg, Plane, Point2};
use crate::machine::Axis;

use super::captured::{Captured, Unfit};
use super::cycle::Cycle;
use super::undercut::Undercut;
use super::{Feed, Frame, Function, Origin, Pos, Side};

/// State that holds for many items; a new one is made only when something in it changes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ctx {
    /// Working plane.
    pub plane: Plane,
    pub frame: Frame,
}

pub type CtxRef = Rc<Ctx>;

/// A programmed path element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Programmed axes only; the others stay.
    pub end: Pos,
    pub path: Path,
    pub side: Side,
    pub coords: Coords,
}

/// In which system the end point counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Coords {
    /// The frame of the context.
    #[default]
    Frame,
    /// Machine coordinates; frame and work offset do not apply.
    Machine,
}

/// How a move gets to its end, with the feed where it cuts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    Rapid,
    Line(Feed),
    Arc(Arc, Feed),
    Thread(Thread),
}

impl Path {
    /// A straight line at `feed`, or at rapid traverse without one.
    #[inline]
    pub fn straight(feed: Option<Feed>) -> Path {
        feed.map_or(Path::Rapid, Path::Line)
    }

    #[inline]
    pub fn is_rapid(&self) -> bool {
        matches!(self, Path::Rapid)
    }
}

/// A line cut in step with the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thread {
    /// Way per turn of the spindle in mm.
    pub lead: f64,
    /// Axis along which `lead` counts; `None` for along the path.
    pub along: Option<Axis>,
}

/// An arc or helix in `plane`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    pub plane: Plane,
    pub shape: ArcShape,
    /// Whole turns on top of what the shape says.
    pub turns: u32,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ArcShape {
    /// About `center` to the end point, which may miss the circle by `tol` mm. End on start: a full circle.
    Center { center: Point2, ccw: bool, tol: f64 },
    /// About `center` by exactly `sweep` degrees, counter-clockwise positive, any number of turns. The end
    /// point is the one that follows from it.
    Sweep { center: Point2, sweep: Deg },
    /// By radius; a negative one takes the longer arc. The end may lie `tol` mm too far.
    Radius { radius: f64, ccw: bool, tol: f64 },
    /// By the angle between the radii to its ends: `sweep` degrees, counter-clockwise positive, below a turn.
    Opening { sweep: Deg },
    /// Through a point between its ends.
    Via { point: Point2 },
    /// Tangential to the element before.
    Tangent,
}

/// What happens at the corner between the element before and the next one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    pub shape: CornerShape,
    /// Feed on the inserted element; `None` for the feed of the element behind.
    pub feed: Option<Feed>,
    /// What happens between the two elements comes in front of the inserted one, not behind it.
    pub early: bool,
    /// Asked for at every corner: where there is none, nothing is inserted and nothing is said.
    pub modal: bool,
    pub large: LargeCorner,
    pub at_arc: ArcChamfer,
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
    /// The control makes it, but how it lies is not confirmed: the user may choose ours.
    Ask,
    /// It stands at a right angle to the bisector of the corner, its ends on both elements.
    AcrossBisector,
    /// The compiler of the control makes it, but how it is measured is not confirmed: the user may choose ours.
    AskAlong,
    /// Its width is measured along each element.
    Along,
}

/// What becomes of a corner that cuts off more than a neighbour has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LargeCorner {
    /// The control refuses it.
    Refuse,
    /// The control makes it smaller, but its way is not documented: the user may choose ours.
    Ask,
    /// It is made as large as it fits.
    Shorten,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CornerShape {
    Rounding {
        radius: f64,
    },
    /// Chamfer by the length cut off each neighbour.
    Chamfer {
        side: f64,
    },
    /// Chamfer by its own length.
    ChamferLength {
        length: f64,
    },
    /// Relief of an inside corner of a turned part.
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
    fn movement(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin);
    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin);
    fn function(&mut self, function: &Function, ctx: &CtxRef, origin: &Origin);
    /// A cycle with all its arguments; where it leaves the tool is [`Cycle::leaves`].
    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin);
    /// The position is no longer what the moves so far say: an error was reported, or the program moves in
    /// a way that is not in the stream.
    fn lost(&mut self, ctx: &CtxRef, origin: &Origin);
    /// Before everything else: the tool stands here, although no move says so; in the programmed frame.
    fn begins_at(&mut self, at: &Pos);
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
