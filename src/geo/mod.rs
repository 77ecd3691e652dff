//! Plane and space geometry with no idea of blocks, words or controls.
//!
//! Every function is total: degenerate input gives `None` or a variant that names the case. Lengths are
//! millimetres, angles in the unit of their type; tolerances are parameters.

pub mod angle;
pub mod arc;
pub mod area;
pub mod clearance;
pub mod corner;
pub mod crossing;
pub mod element;
pub mod grid;
pub mod intersect;
pub mod joint;
pub mod nose_profile;
pub mod offset;
pub mod open;
pub mod overlay;
pub mod parts;
pub mod pattern;
pub mod plane;
pub mod profile;
pub mod rotation;
pub mod soft;
pub mod tolerance;
pub mod undercut;

pub use angle::Deg;
pub use element::Element;
pub use plane::Plane;
pub use tolerance::{SAME as SAME_POINT, SAME_DIRECTION};

/// A point of the working plane: first and second axis.
pub type Point2 = nalgebra::Point2<f64>;
/// A direction or distance in the working plane.
pub type Vec2 = nalgebra::Vector2<f64>;

/// Length of `v`.
pub fn length(v: Vec2) -> f64 {
    libm::hypot(v.x, v.y)
}

/// Distance of two points.
pub fn distance(a: Point2, b: Point2) -> f64 {
    length(b - a)
}

/// `v` turned a quarter counter-clockwise: the left side of the direction `v`.
pub fn left(v: Vec2) -> Vec2 {
    Vec2::new(-v.y, v.x)
}

/// z part of the cross product: positive if `b` lies left of `a`.
pub fn cross(a: Vec2, b: Vec2) -> f64 {
    a.x * b.y - a.y * b.x
}

/// Direction of `v`; `None` for a vector shorter than `tol`.
pub fn direction(v: Vec2, tol: f64) -> Option<Vec2> {
    let len = length(v);
    (len > tol).then(|| v / len)
}

/// `v` turned counter-clockwise by `angle` radians.
pub fn turned(v: Vec2, angle: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(angle);
    Vec2::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
}
