//! Positions of which some axes may be unknown.

use crate::geo::{Plane, Point2};
use crate::machine::axis::{AXES, Axis, AxisSet};

/// Coordinates by axis, with the set of those that are known: mm for linear axes, degrees for rotary ones. In which
/// system they count is for the one who has the position to say.
///
/// What is stored for an unknown coordinate is never read.
#[derive(Debug, Clone, Copy, Default)]
pub struct Pos {
    values: [f64; AXES],
    known: AxisSet,
}

impl Pos {
    /// Nothing known.
    pub const UNKNOWN: Pos = Pos { values: [0.0; AXES], known: AxisSet::EMPTY };

    /// X, Y and Z in mm, of which those in `known` count; no other axis is known.
    #[inline(always)]
    pub fn of_main([x, y, z]: [f64; 3], known: AxisSet) -> Pos {
        Pos { values: [x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], known: known.common(AxisSet::MAIN) }
    }

    /// The coordinate along `axis`; `None` where it is unknown.
    #[inline]
    pub fn get(&self, axis: Axis) -> Option<f64> {
        self.known.contains(axis).then_some(self.values[axis.index()])
    }

    /// Makes the coordinate along `axis` known.
    #[inline]
    pub fn set(&mut self, axis: Axis, value: f64) {
        self.values[axis.index()] = value;
        self.known.insert(axis);
    }

    /// Makes the coordinate along `axis` unknown.
    pub fn forget(&mut self, axis: Axis) {
        self.known.remove(axis);
    }

    /// Forgets every axis.
    #[inline]
    pub fn clear(&mut self) {
        self.known = AxisSet::EMPTY;
    }

    /// The axes whose coordinates are known.
    #[inline]
    pub fn known(&self) -> AxisSet {
        self.known
    }

    /// The coordinates of all axes; those of axes that are not known mean nothing.
    #[inline]
    pub fn values(&self) -> &[f64; AXES] {
        &self.values
    }

    /// The known axes in order.
    #[inline]
    pub fn iter(&self) -> impl Iterator<Item = (Axis, f64)> + '_ {
        self.known.iter().map(|axis| (axis, self.values[axis.index()]))
    }

    /// Takes over every known coordinate of `other`.
    #[inline]
    pub fn update(&mut self, other: &Pos) {
        // Most moves name main axes only.
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            if other.known.contains(axis) {
                self.values[axis.index()] = other.values[axis.index()];
            }
        }
        for axis in other.known.without(AxisSet::MAIN).iter() {
            self.values[axis.index()] = other.values[axis.index()];
        }
        self.known = self.known.union(other.known);
    }

    /// Is a known coordinate beyond `most`, or no number?
    #[inline]
    pub fn exceeds(&self, most: f64) -> bool {
        let beyond = |value: &f64| value.is_nan() || value.abs() > most;
        self.values.iter().any(beyond) && self.iter().any(|(_, value)| beyond(&value))
    }

    /// The same for the coordinates of a plane.
    #[inline]
    pub fn exceeds_in(&self, plane: Plane, most: f64) -> bool {
        let beyond = |value: f64| value.is_nan() || value.abs() > most;
        self.in_plane(plane).is_some_and(|p| beyond(p.x) || beyond(p.y))
    }

    /// First and second coordinate of a plane; `None` unless both are known.
    #[inline]
    pub fn in_plane(&self, plane: Plane) -> Option<Point2> {
        let (first, second, _) = plane.axes();
        Some(Point2::new(self.get(Axis::ALL[first])?, self.get(Axis::ALL[second])?))
    }

    /// Sets first and second coordinate of a plane.
    #[inline]
    pub fn set_in_plane(&mut self, plane: Plane, p: Point2) {
        let (first, second, _) = plane.axes();
        self.set(Axis::ALL[first], p.x);
        self.set(Axis::ALL[second], p.y);
    }
}

impl PartialEq for Pos {
    fn eq(&self, other: &Pos) -> bool {
        self.known == other.known && self.iter().eq(other.iter())
    }
}
