//! Frames: from programmed coordinates to workpiece coordinates.

use nalgebra::{Matrix3, Vector3};

use crate::geo::Plane;
use crate::machine::axis::{AXES, Axis, AxisSet};

use super::Pos;

/// What arithmetic loses of a direction or a scale.
const LOST: f64 = 1e-9;

/// An affine map of X, Y and Z, in mm, plus an offset for every other axis, in mm or degrees.
///
/// Immutable once an item refers to it. `workpiece = linear · programmed + shift`.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    linear: Matrix3<f64>,
    inverse: Matrix3<f64>,
    shift: [f64; AXES],
    kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Nothing is changed.
    Identity,
    /// Offsets alone.
    Shift,
    /// The main axes are turned, mirrored or scaled, too.
    Affine,
}

/// What a frame does to a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlaneMap {
    /// Onto `plane`, all lengths times `scale`; `flips` if the sense of rotation turns over.
    Similar { plane: Plane, scale: f64, flips: bool },
    /// Circles become ellipses.
    Uneven,
    /// Out of the main planes.
    Tilted,
}

impl Default for Frame {
    fn default() -> Frame {
        Frame { linear: Matrix3::identity(), inverse: Matrix3::identity(), shift: [0.0; AXES], kind: Kind::Identity }
    }
}

impl Frame {
    /// A frame of its map and its offsets by axis; `None` if `linear` cannot be inverted or a value is not finite.
    pub fn new(linear: Matrix3<f64>, shift: [f64; AXES]) -> Option<Frame> {
        let finite = linear.iter().chain(shift.iter()).all(|v| v.is_finite());
        let plain = linear == Matrix3::identity();
        let inverse = if plain { linear } else { linear.try_inverse()? };
        let kind = match (plain, shift.iter().all(|v| *v == 0.0)) {
            (true, true) => Kind::Identity,
            (true, false) => Kind::Shift,
            _ => Kind::Affine,
        };
        finite.then_some(Frame { linear, inverse, shift, kind })
    }

    /// Are workpiece coordinates the programmed ones?
    pub fn is_identity(&self) -> bool {
        self.kind == Kind::Identity
    }

    /// Nothing but a shift.
    pub fn is_shift(&self) -> bool {
        self.kind != Kind::Affine
    }

    /// What the frame adds along `axis`, in mm or degrees.
    pub fn shift_of(&self, axis: Axis) -> f64 {
        self.shift[axis.index()]
    }

    /// Its map without the offsets: rows are workpiece axes, columns programmed ones.
    pub fn linear(&self) -> &Matrix3<f64> {
        &self.linear
    }

    /// By what all lengths are multiplied; `None` if that depends on the direction.
    pub fn uniform_scale(&self) -> Option<f64> {
        if self.is_shift() {
            return Some(1.0);
        }
        let sizes = [0, 1, 2].map(|i| self.linear.column(i).norm());
        sizes.iter().all(|size| (size - sizes[0]).abs() <= 1e-12 * sizes[0]).then_some(sizes[0])
    }

    /// Do lengths stay what they are? A tool has the size that it has.
    pub fn is_unscaled(&self) -> bool {
        self.uniform_scale().is_some_and(|scale| (scale - 1.0).abs() <= LOST)
    }

    /// Does the axis across the plane stay that of the machine, in its sense?
    pub fn keeps_axis_across(&self, plane: Plane) -> bool {
        let (first, second, third) = plane.axes();
        let off = |a: usize, b: usize| self.linear[(a, b)].abs() > LOST;
        let tilted = [first, second].iter().any(|axis| off(third, *axis) || off(*axis, third));
        !tilted && self.linear[(third, third)] > 0.0
    }

    /// Does it change left and right in the plane?
    pub fn flips(&self, plane: Plane) -> bool {
        let (first, second, _) = plane.axes();
        let at = |a: usize, b: usize| self.linear[(a, b)];
        at(first, first) * at(second, second) - at(first, second) * at(second, first) < 0.0
    }

    /// Workpiece coordinates of `p`. A coordinate that depends on an unknown one is unknown.
    pub fn apply(&self, p: &Pos) -> Pos {
        match self.kind {
            Kind::Identity => *p,
            Kind::Shift => self.shifted(p, 1.0),
            Kind::Affine => {
                let mut out = self.shifted(p, 1.0);
                map_main(&self.linear, p, &mut out);
                for axis in [Axis::X, Axis::Y, Axis::Z] {
                    if let Some(v) = out.get(axis) {
                        out.set(axis, v + self.shift[axis.index()]);
                    }
                }
                out
            }
        }
    }

    /// Programmed coordinates of the workpiece position `p`.
    pub fn unapply(&self, p: &Pos) -> Pos {
        match self.kind {
            Kind::Identity => *p,
            Kind::Shift => self.shifted(p, -1.0),
            Kind::Affine => {
                let moved = self.shifted(p, -1.0);
                let mut out = moved;
                map_main(&self.inverse, &moved, &mut out);
                out
            }
        }
    }

    fn shifted(&self, p: &Pos, sign: f64) -> Pos {
        let mut out = *p;
        for (axis, v) in p.iter() {
            out.set(axis, v + sign * self.shift[axis.index()]);
        }
        out
    }

    /// Axes whose workpiece coordinate depends on one of `axes`.
    pub fn touched(&self, axes: AxisSet) -> AxisSet {
        if self.is_shift() {
            return axes;
        }
        let mut out = axes.without(AxisSet::MAIN);
        for to in AxisSet::MAIN.iter() {
            if axes.common(AxisSet::MAIN).iter().any(|from| self.linear[(to.index(), from.index())] != 0.0) {
                out.insert(to);
            }
        }
        out
    }

    /// What becomes of circles in `plane`.
    pub fn plane_map(&self, plane: Plane) -> PlaneMap {
        if self.is_shift() {
            return PlaneMap::Similar { plane, scale: 1.0, flips: false };
        }
        let (first, second, _) = plane.axes();
        let (a, b) = (self.linear.column(first), self.linear.column(second));
        let size = a.norm().max(b.norm());
        let tiny = 1e-12 * size;
        if a.dot(&b).abs() > tiny * size || (a.norm() - b.norm()).abs() > tiny {
            return PlaneMap::Uneven;
        }
        let normal: Vector3<f64> = a.cross(&b);
        let Some(axis) = (0..3).find(|i| (0..3).all(|j| j == *i || normal[j].abs() <= tiny * size)) else {
            return PlaneMap::Tilted;
        };
        let target = Plane::normal_to(axis).unwrap_or(plane);
        PlaneMap::Similar { plane: target, scale: size, flips: normal[axis] < 0.0 }
    }
}

/// `out` gets the main axes of `matrix · p`; unknown where a needed coordinate is.
fn map_main(matrix: &Matrix3<f64>, p: &Pos, out: &mut Pos) {
    for to in AxisSet::MAIN.iter() {
        let mut sum = 0.0;
        let mut known = true;
        for from in AxisSet::MAIN.iter() {
            let factor = matrix[(to.index(), from.index())];
            if factor != 0.0 {
                match p.get(from) {
                    Some(v) => sum += factor * v,
                    None => known = false,
                }
            }
        }
        if known {
            out.set(to, sum);
        } else {
            out.forget(to);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quarter() -> Frame {
        let turn = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        Frame::new(turn, [10.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).unwrap()
    }

    #[test]
    fn rotation_needs_both_axes() {
        let mut p = Pos::UNKNOWN;
        p.set(Axis::X, 5.0);
        p.set(Axis::Z, 1.0);
        let w = quarter().apply(&p);
        assert_eq!((w.get(Axis::X), w.get(Axis::Y), w.get(Axis::Z)), (None, Some(25.0), Some(1.0)));
        p.set(Axis::Y, 2.0);
        let w = quarter().apply(&p);
        assert_eq!((w.get(Axis::X), w.get(Axis::Y)), (Some(8.0), Some(25.0)));
        assert_eq!(quarter().unapply(&w), p);
    }

    #[test]
    fn planes_under_frames() {
        assert_eq!(quarter().plane_map(Plane::Xy), PlaneMap::Similar { plane: Plane::Xy, scale: 1.0, flips: false });
        let mirror = Frame::new(Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0)), [0.0; AXES]).unwrap();
        assert_eq!(mirror.plane_map(Plane::Xy), PlaneMap::Similar { plane: Plane::Xy, scale: 1.0, flips: true });
        assert_eq!(mirror.plane_map(Plane::Yz), PlaneMap::Similar { plane: Plane::Yz, scale: 1.0, flips: false });
        let uneven = Frame::new(Matrix3::from_diagonal(&Vector3::new(2.0, 1.0, 1.0)), [0.0; AXES]).unwrap();
        assert_eq!(uneven.plane_map(Plane::Xy), PlaneMap::Uneven);
        assert_eq!(uneven.plane_map(Plane::Yz), PlaneMap::Similar { plane: Plane::Yz, scale: 1.0, flips: false });
    }
}
