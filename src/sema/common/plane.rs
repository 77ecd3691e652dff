//! Planes and their axes.

use crate::geo::Plane;
use crate::machine::{Axis, AxisSet};

/// Both axes of a plane.
pub fn plane_axes(plane: Plane) -> AxisSet {
    let (first, second, _) = plane.axes();
    [Axis::ALL[first], Axis::ALL[second]].into_iter().collect()
}
