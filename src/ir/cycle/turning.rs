//! What the arguments of all turning cycles share. Points are (Z, X) with X as a radius, in mm.

use crate::geo::{Point2, Vec2};
use crate::machine::Axis;

/// The direction into the material. It also says along which axis the cuts of a cycle run: X cycles cut
/// along Z, Z cycles cut along X.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Towards {
    /// From outside to the turning centre: external machining.
    #[default]
    MinusX,
    /// From the turning centre outwards: internal machining.
    PlusX,
    /// Into the front face.
    MinusZ,
    /// Into the rear face.
    PlusZ,
}

impl Towards {
    /// The direction as (Z, X), of length 1.
    pub fn unit(self) -> Vec2 {
        match self {
            Towards::MinusX => Vec2::new(0.0, -1.0),
            Towards::PlusX => Vec2::new(0.0, 1.0),
            Towards::MinusZ => Vec2::new(-1.0, 0.0),
            Towards::PlusZ => Vec2::new(1.0, 0.0),
        }
    }

    /// Infeed along X, cuts along Z.
    pub fn is_radial(self) -> bool {
        matches!(self, Towards::MinusX | Towards::PlusX)
    }

    /// Outwards, in a bore.
    pub fn is_inside(self) -> bool {
        self == Towards::PlusX
    }

    /// The infeed axis and the cutting axis.
    pub fn axes(self) -> (Axis, Axis) {
        if self.is_radial() { (Axis::X, Axis::Z) } else { (Axis::Z, Axis::X) }
    }

    /// The coordinate of `p`, (Z, X), on the infeed axis.
    pub fn depth_coordinate(self, p: Point2) -> f64 {
        if self.is_radial() { p.y } else { p.x }
    }

    /// The coordinate of `p`, (Z, X), on the cutting axis.
    pub fn cutting_coordinate(self, p: Point2) -> f64 {
        if self.is_radial() { p.x } else { p.y }
    }
}

/// Greatest coordinate or length, mm. No lathe is so long, and products of such numbers stay finite.
const FARTHEST: f64 = 1e7;

/// A coordinate, or a length of either sign: a number of at most [`FARTHEST`] mm.
pub(crate) fn is_coordinate(value: f64) -> bool {
    value.abs() <= FARTHEST
}

/// A length, feed or time that must be over 0.
pub(crate) fn is_positive(value: f64) -> bool {
    value > 0.0 && is_coordinate(value)
}

/// A length, angle or time that may be 0.
pub(crate) fn is_length(value: f64) -> bool {
    value >= 0.0 && is_coordinate(value)
}

/// Both coordinates are such numbers.
pub(crate) fn is_point(p: Point2) -> bool {
    is_coordinate(p.x) && is_coordinate(p.y)
}
