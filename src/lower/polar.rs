//! Pass 1: polar end points become Cartesian ones.

use crate::geo::angle::polar_point;
use crate::ir::Pos;
use crate::ir::contour::Polar;

/// The programmed axes of a polar end point.
pub fn cartesian(end: &Polar) -> Pos {
    let mut pos = end.rest;
    pos.set_in_plane(end.plane, polar_point(end.pole, end.radius, end.angle));
    pos
}
