//! A path element whose geometry is complete, still in programmed coordinates.

use crate::geo::{Element, Plane, Point2};
use crate::ir::contour::CtxRef;
use crate::ir::{Feed, Origin, Pos, Side};
use crate::machine::{Axis, AxisSet};

/// One element from `start` to `end`.
#[derive(Debug, Clone)]
pub struct Step {
    pub start: Pos,
    /// All known axes after the element.
    pub end: Pos,
    /// Axes the program named.
    pub axes: AxisSet,
    pub path: Path,
    pub feed: Option<Feed>,
    pub side: Side,
    pub machine: bool,
    pub ctx: CtxRef,
    pub origin: Origin,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    Rapid,
    Line,
    /// Sweep in rad, counter-clockwise positive.
    Arc {
        plane: Plane,
        center: Point2,
        sweep: f64,
    },
}

impl Step {
    /// The element as seen in `plane`; `None` if an end is not known there or an arc lies in another plane.
    pub fn element(&self, plane: Plane) -> Option<Element> {
        let from = self.start.in_plane(plane)?;
        let to = self.end.in_plane(plane)?;
        match self.path {
            Path::Rapid | Path::Line => Some(Element::Line { from, to }),
            Path::Arc { plane: own, center, sweep } if own == plane => Some(Element::Arc { from, to, center, sweep }),
            Path::Arc { .. } => None,
        }
    }

    /// Plane of an arc, or the working plane.
    pub fn plane(&self) -> Plane {
        match self.path {
            Path::Arc { plane, .. } => plane,
            _ => self.ctx.plane,
        }
    }

    /// Does an axis outside `plane` move?
    pub fn leaves(&self, plane: Plane) -> bool {
        let (first, second, _) = plane.axes();
        self.axes.iter().any(|axis| {
            axis.index() != first && axis.index() != second && self.start.get(axis) != self.end.get(axis)
        })
    }
}

/// Axes of a plane as a set.
pub fn plane_axes(plane: Plane) -> AxisSet {
    let (first, second, _) = plane.axes();
    [Axis::ALL[first], Axis::ALL[second]].into_iter().collect()
}
