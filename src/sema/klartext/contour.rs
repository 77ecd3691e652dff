//! The contour that is programmed under compensation, as far as a departure has to know it.

use crate::geo::{self, Plane, Point2, SAME_POINT, Vec2, arc};
use crate::ir::Side;
use crate::ir::contour::{Arc, ArcShape, Path};

/// The last move in the working plane, for its direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct LastMove {
    from: Point2,
    pub to: Point2,
    plane: Plane,
    path: Path,
    /// Where a tangential arc begins: the direction of the element before.
    entering: Option<Vec2>,
}

/// The contour under way, or the one that the tool still stands beside.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contour {
    /// [`Side::None`] behind an approach with R0.
    pub side: Side,
    /// More than the way to it was programmed.
    pub begun: bool,
    pub last: Option<LastMove>,
}

/// Does the block change what is made of the corner at its end?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum OwnCorner {
    #[default]
    No,
    /// Yes, and no element was sent yet.
    Waits,
    Sent,
}

impl LastMove {
    /// Behind `before`, which a tangential arc goes on from.
    pub fn new(from: Point2, to: Point2, plane: Plane, path: Path, before: Option<LastMove>) -> LastMove {
        let entering = match path {
            Path::Arc(Arc { shape: ArcShape::Tangent, .. }, _) => before.and_then(|before| before.direction(false)),
            Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Thread(_) => None,
        };
        LastMove::entered(from, to, plane, path, entering)
    }

    /// With the direction in which a tangential arc begins.
    pub fn entered(from: Point2, to: Point2, plane: Plane, path: Path, entering: Option<Vec2>) -> LastMove {
        LastMove { from, to, plane, path, entering }
    }

    #[inline]
    pub fn straight(from: Point2, to: Point2, plane: Plane) -> LastMove {
        LastMove { from, to, plane, path: Path::Rapid, entering: None }
    }

    /// Direction of travel at the start or the end.
    pub fn direction(&self, at_start: bool) -> Option<Vec2> {
        let at = if at_start { self.from } else { self.to };
        match self.path {
            Path::Line(_) | Path::Rapid => geo::direction(self.to - self.from, SAME_POINT),
            Path::Arc(Arc { plane, .. }, _) if plane != self.plane => None,
            Path::Arc(Arc { shape, .. }, _) => match shape {
                ArcShape::Center { center, ccw, .. } => arc::tangent_at(at, center, ccw),
                ArcShape::Sweep { center, sweep } => arc::tangent_at(at, center, sweep.0 > 0.0),
                ArcShape::Radius { radius, ccw, tol } => {
                    let center = arc::center_by_radius(self.from, self.to, radius, ccw, SAME_POINT, tol)?;
                    arc::tangent_at(at, center, ccw)
                }
                ArcShape::Tangent if at_start => self.entering,
                // The chord halves the turn of an arc.
                ArcShape::Tangent => {
                    let (along, t) = (self.to - self.from, self.entering?);
                    let half = libm::atan2(geo::cross(t, along), t.dot(&along));
                    Some(geo::turned(t, 2.0 * half))
                }
                ArcShape::Opening { .. } | ArcShape::Via { .. } => None,
            },
            Path::Thread(_) => None,
        }
    }
}

impl Contour {
    pub fn new(side: Side) -> Contour {
        Contour { side, begun: false, last: None }
    }
}
