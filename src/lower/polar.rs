//! Pass 1: polar end points become Cartesian ones.

use crate::geo::angle::polar_point;
use crate::ir::Pos;
use crate::ir::contour::EndPoint;

/// The programmed axes of an end point.
#[inline]
pub fn cartesian(end: &EndPoint) -> Pos {
    match end {
        EndPoint::Cartesian(pos) => *pos,
        EndPoint::Polar(polar) => {
            let mut pos = polar.rest;
            pos.set_in_plane(polar.plane, polar_point(polar.pole, polar.radius, polar.angle));
            pos
        }
    }
}
