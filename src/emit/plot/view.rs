//! From which side the path is seen.

use crate::geo::{Plane, Point2};
use crate::ir::Pos;
use crate::machine::Axis;

/// Two axes of the picture: to the right and up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct View {
    plane: Plane,
    lathe: bool,
}

impl View {
    /// The view for a program that begins in `plane`. On a lathe it is Z to the right and X up.
    pub(super) fn new(plane: Plane, lathe: bool) -> View {
        View { plane: if lathe { Plane::Zx } else { plane }, lathe }
    }

    pub(super) fn axes(self) -> (Axis, Axis) {
        let (first, second, _) = self.plane.axes();
        (Axis::ALL[first], Axis::ALL[second])
    }

    /// The second axis is the radius of a turned part.
    pub(super) fn is_lathe(self) -> bool {
        self.lathe
    }

    /// Are arcs of `plane` arcs in the picture?
    pub(super) fn shows(self, plane: Plane) -> bool {
        self.plane == plane
    }

    pub(super) fn point(self, pos: &Pos) -> Option<Point2> {
        pos.in_plane(self.plane)
    }
}
