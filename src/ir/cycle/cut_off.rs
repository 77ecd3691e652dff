//! Arguments of a cut-off: the edge of the workpiece, then straight in, with less feed and a fixed speed at the end.

use core::fmt;

use crate::ir::function::{Spindle, Turn};
use crate::ir::{Feed, Pos};
use crate::machine::Axis;

use super::Family;
use super::recess::RecessTool;
use super::turning::{is_coordinate, is_length, is_positive};

/// A cut-off from outside; the workpiece that falls off lies towards +Z. X values are radii, all lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutOff {
    /// Z of the face of the workpiece.
    pub face: f64,
    /// Surface of the workpiece where it is cut off, above 0.
    pub outer: f64,
    /// From here on the feed is reduced and the speed fixed; below `outer`.
    pub reduced: f64,
    /// The cut ends here, at `reduced` or below it; a value below 0 lies beyond the turning centre.
    pub end: f64,
    /// Edge between the surface and the face; its foot, with the nose of the tool, does not reach below `reduced`.
    pub edge: CutEdge,
    /// The cutting tool. Its corner towards +Z makes the face.
    pub tool: RecessTool,
    /// Clear height above the surface, over 0: rapid traverse passes there, and the cycle ends there.
    pub clearance: f64,
    /// From the surface to `reduced`, and around the edge; over 0.
    pub feed: Feed,
    /// From `reduced` to `end`, over 0.
    pub reduced_feed: Feed,
    /// What the spindle is told before the first cut; `None` leaves its speed as it is.
    pub speed: Option<Spindle>,
    /// Sense in which the spindle is started before the first cut; `None` leaves it as it turns.
    pub turn: Option<Turn>,
    /// What the spindle is told where the feed is reduced.
    pub reduced_speed: Option<Spindle>,
}

/// What the corner between the surface of the workpiece and its face becomes; sizes in mm, over 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CutEdge {
    /// It stays a corner, and no cut goes along it.
    Sharp,
    /// A quarter of a circle of this radius, tangential to both.
    Round(f64),
    /// A line at 45 degrees that takes so much of both.
    Chamfer(f64),
}

impl CutEdge {
    /// What it takes of the surface and of the face, mm; 0 for a corner.
    pub fn size(self) -> f64 {
        match self {
            CutEdge::Sharp => 0.0,
            CutEdge::Round(size) | CutEdge::Chamfer(size) => size,
        }
    }
}

/// An argument that describes no cut-off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutOffFault {
    /// A coordinate is not a finite number.
    Point,
    /// The cutting width is not over 0.
    Width,
    /// The nose radius is negative or over half the cutting width.
    Nose,
    /// The place of the cutting edge is no number.
    Edge,
    /// The clearance is not over 0.
    Clearance,
    /// A feed is not over 0.
    Feed,
    /// The diameters do not become smaller.
    Order,
    /// The edge reaches below the diameter of the reduced feed.
    EdgeSize,
}

impl fmt::Display for CutOffFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            CutOffFault::Point => "a point of the cut-off is not a number",
            CutOffFault::Width => "the cutting width of the tool must be over 0",
            CutOffFault::Nose => "the nose radius must lie between 0 and half the cutting width",
            CutOffFault::Edge => "the reference point of the tool is not known",
            CutOffFault::Clearance => "the clearance must be over 0",
            CutOffFault::Feed => "a feed must be over 0",
            CutOffFault::Order => "the cut has to go from the surface over the diameter of the reduced feed to its end",
            CutOffFault::EdgeSize => "the edge and the corner of the tool reach below the diameter of the reduced feed",
        })
    }
}

impl Family for CutOff {
    type Fault = CutOffFault;

    fn check(&self) -> Result<(), CutOffFault> {
        let tool = &self.tool;
        let points = [self.face, self.outer, self.reduced, self.end];
        let ordered = self.outer > 0.0 && self.reduced < self.outer && self.end <= self.reduced;
        let rules = [
            (points.into_iter().all(is_coordinate), CutOffFault::Point),
            (is_positive(tool.width), CutOffFault::Width),
            (is_length(tool.nose) && tool.nose <= tool.width / 2.0, CutOffFault::Nose),
            (is_coordinate(tool.edge), CutOffFault::Edge),
            (is_positive(self.clearance), CutOffFault::Clearance),
            ([self.feed, self.reduced_feed].iter().all(|feed| is_positive(feed.value())), CutOffFault::Feed),
            (ordered, CutOffFault::Order),
            (self.edge == CutEdge::Sharp || is_positive(self.edge.size()), CutOffFault::EdgeSize),
            (self.edge == CutEdge::Sharp || self.foot() >= self.reduced, CutOffFault::EdgeSize),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn leaves(&self, at: &mut Pos) {
        at.set(Axis::X, self.clear());
        at.set(Axis::Z, self.place(0.0));
    }
}

impl CutOff {
    /// X as a radius where the edge is done: from here on the corner of the tool makes the face.
    pub fn foot(&self) -> f64 {
        self.outer - self.edge.size() - self.tool.nose
    }

    /// X as a radius of the clear height above the surface.
    pub fn clear(&self) -> f64 {
        self.outer + self.clearance
    }

    /// Z of the programmed point where the corner on the side of the workpiece stands `beside` mm off the face, towards
    /// +Z.
    pub fn place(&self, beside: f64) -> f64 {
        self.face + beside - self.tool.width - self.tool.edge
    }
}
