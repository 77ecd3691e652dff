//! The last move in the working plane, for its direction at the end.

use crate::geo::{self, Point2, SAME_POINT, Vec2, arc};
use crate::ir::contour::{Arc, ArcShape, Path};

/// A move in the working plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct LastMove {
    pub from: Point2,
    pub to: Point2,
    pub path: Path,
}

impl LastMove {
    pub fn new(from: Point2, to: Point2, path: Path) -> LastMove {
        LastMove { from, to, path }
    }

    /// Direction of travel at the start or the end.
    pub fn direction(&self, at_start: bool) -> Option<Vec2> {
        let at = if at_start { self.from } else { self.to };
        match self.path {
            Path::Line(_) | Path::Rapid => geo::direction(self.to - self.from, SAME_POINT),
            Path::Arc(Arc { shape, .. }, _) => match shape {
                ArcShape::Center { center, ccw, .. } => arc::tangent_at(at, center, ccw),
                ArcShape::Sweep { center, sweep } => arc::tangent_at(at, center, sweep.0 > 0.0),
                ArcShape::Radius { radius, ccw, tol } => {
                    let center = arc::center_by_radius(self.from, self.to, radius, ccw, SAME_POINT, tol)?;
                    arc::tangent_at(at, center, ccw)
                }
                _ => None,
            },
            Path::Thread(_) => None,
        }
    }
}
