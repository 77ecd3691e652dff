//! Datum shift, mirror, rotation and scaling (cycles 7, 8, 10, 11, 26 and TRANS).
//!
//! `workpiece = shift + rotation · scale · mirror · programmed`, or with the mirror in front of the rotation; the four
//! are independent and each is replaced by its own cycle, whatever the order in which they were programmed.

use nalgebra::{Matrix3, Vector3};

use crate::geo::{Deg, Plane};
use crate::ir::Frame;
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};

/// The transformations in force.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Transformation {
    /// By axis of the workpiece, mm or degrees.
    pub shift: [f64; AXES],
    /// What each of X, Y, Z of the datum shift contributes to `shift`. They differ from the axes of the workpiece
    /// where the shift was measured along turned axes.
    parts: [Vector3<f64>; 3],
    pub mirror: AxisSet,
    /// The mirror acts on what was turned, not on what was programmed.
    pub mirror_last: bool,
    /// About the datum, in `plane`.
    pub angle: Deg,
    pub plane: Plane,
    /// About Z by PLANE or cycle 19, outside of the others.
    pub turn: Deg,
    /// Basic rotation by TCH PROBE 404: all others count in what it turns about Z. `None` for what is set up at the machine.
    pub basic: Option<Deg>,
    /// The datum shift in X and Y was measured along the axes that `turn` turned.
    pub shifted_in_turn: bool,
    /// Cycle 11.
    pub scale: f64,
    /// Cycle 11 leaves this axis alone.
    pub unscaled: Option<Axis>,
    /// Cycle 26.
    pub axis_scale: [f64; 3],
    pub scale_center: [f64; 3],
}

impl Default for Transformation {
    fn default() -> Transformation {
        Transformation {
            shift: [0.0; AXES],
            parts: [Vector3::zeros(); 3],
            mirror: AxisSet::EMPTY,
            mirror_last: false,
            angle: Deg(0.0),
            plane: Plane::Xy,
            turn: Deg(0.0),
            basic: None,
            shifted_in_turn: false,
            scale: 1.0,
            unscaled: None,
            axis_scale: [1.0; 3],
            scale_center: [0.0; 3],
        }
    }
}

impl Transformation {
    pub fn none(mirror_last: bool) -> Transformation {
        Transformation { mirror_last, ..Transformation::default() }
    }

    pub fn is_none(&self) -> bool {
        self.is_shift_only() && self.turn.0 == 0.0 && self.shift.iter().all(|v| *v == 0.0)
    }

    /// Is a scaling in force?
    pub fn scales(&self) -> bool {
        self.scale != 1.0 || self.axis_scale != [1.0; 3]
    }

    /// No mirror, rotation or scaling; a turn of the working plane may be in force.
    pub fn is_shift_only(&self) -> bool {
        self.mirror.is_empty() && self.angle.0 == 0.0 && self.scale == 1.0 && self.axis_scale == [1.0; 3]
    }

    /// Shifts the datum along `axis`, to `value` or by it. Along the axes as they are turned and mirrored now, or
    /// along those of the workpiece; a new value replaces the old one of this axis, however it was measured.
    pub fn shift_by(&mut self, axis: Axis, value: f64, incremental: bool, turned: bool) {
        let i = axis.index();
        if !axis.is_main() {
            self.shift[i] = if incremental { self.shift[i] + value } else { value };
            return;
        }
        let mut unit = Vector3::zeros();
        unit[i] = 1.0;
        if turned {
            let unscaled = Transformation { scale: 1.0, axis_scale: [1.0; 3], ..self.clone() };
            unit = unscaled.linear() * unit;
        } else {
            // A turned working plane takes the axes of the shift along.
            unit = turn_about(Plane::Xy, self.turn) * unit;
        }
        self.parts[i] = if incremental { self.parts[i] + unit * value } else { unit * value };
        let sum = self.parts[0] + self.parts[1] + self.parts[2];
        self.shift[..3].copy_from_slice(sum.as_slice());
    }

    /// Does it matter whether a turn about Z comes before the mirror and the scaling, or after them?
    pub fn turns_with_the_plane(&self) -> bool {
        self.mirror.contains(Axis::X) != self.mirror.contains(Axis::Y) || self.axis_scale[0] != self.axis_scale[1]
    }

    /// Is a basic rotation in force that the coordinates hold?
    pub fn is_turned_as_a_whole(&self) -> bool {
        self.basic.is_some_and(|angle| angle.0 != 0.0)
    }

    /// Is the datum shifted in X or Y?
    pub fn is_shifted_in_plane(&self) -> bool {
        self.shift[..2].iter().any(|v| *v != 0.0)
    }

    /// No datum shift.
    pub fn unshift(&mut self) {
        self.shift = [0.0; AXES];
        self.parts = [Vector3::zeros(); 3];
    }

    /// A transformation under which it is open where the parallel axis `axis` goes.
    pub fn touches_parallel(&self, axis: Axis) -> Option<&'static str> {
        let (first, second, _) = self.plane.axes();
        let main = match axis {
            Axis::U => Axis::X,
            Axis::V => Axis::Y,
            _ => Axis::Z,
        };
        if self.scale != 1.0 || self.axis_scale != [1.0; 3] {
            Some("scaling")
        } else if self.mirror.contains(main) {
            Some("mirror")
        } else if self.angle.0 != 0.0 && (main.index() == first || main.index() == second)
            || (self.turn.0 != 0.0 || self.is_turned_as_a_whole()) && main != Axis::Z
        {
            Some("rotation")
        } else {
            None
        }
    }

    /// Do mirror and rotation lead elsewhere in the other order? Not for both axes of the plane, nor by half a turn.
    pub fn mirror_order_counts(&self) -> bool {
        let (first, second, _) = self.plane.axes();
        let mirrored = |i: usize| self.mirror.contains(Axis::ALL[i]);
        mirrored(first) != mirrored(second) && self.angle.normal().0 % 180.0 != 0.0
    }

    /// Does the rotation turn a plane that cycle 26 scales unevenly?
    pub fn scaling_order_counts(&self) -> bool {
        let (first, second, _) = self.plane.axes();
        self.axis_scale[first] != self.axis_scale[second] && self.angle.normal().0 % 180.0 != 0.0
    }

    /// Scaling by cycle 11 and by cycle 26.
    pub fn scales_twice(&self) -> bool {
        self.scale != 1.0 && self.axis_scale != [1.0; 3]
    }

    /// Rotation, scaling and mirror as one matrix.
    pub fn linear(&self) -> Matrix3<f64> {
        let mut linear = Matrix3::identity();
        for axis in AxisSet::MAIN.iter() {
            let i = axis.index();
            let by_11 = if self.unscaled == Some(axis) { 1.0 } else { self.scale };
            linear[(i, i)] = by_11 * self.axis_scale[i];
        }
        // Mirror and scaling are diagonal: their order does not matter.
        if self.mirror_last { self.turned() * linear } else { self.turned() * self.mirroring() * linear }
    }

    fn mirroring(&self) -> Matrix3<f64> {
        let sign = |axis| if self.mirror.contains(axis) { -1.0 } else { 1.0 };
        Matrix3::from_diagonal(&Vector3::new(sign(Axis::X), sign(Axis::Y), sign(Axis::Z)))
    }

    /// What happens behind the scaling.
    fn turned(&self) -> Matrix3<f64> {
        let turned = if self.mirror_last { self.mirroring() * self.rotation() } else { self.rotation() };
        turn_about(Plane::Xy, self.turn) * turned
    }

    fn rotation(&self) -> Matrix3<f64> {
        turn_about(self.plane, self.angle)
    }

    /// The frame; `lift` is added to the coordinate of `tool_axis` (length oversize). `None` if it overflows.
    pub fn frame(&self, tool_axis: Axis, lift: f64) -> Option<Frame> {
        let mut shift = self.shift;
        // p -> c + S (p - c), mirrored before and rotated behind.
        let c = Vector3::from(self.scale_center);
        let s = Vector3::from(self.axis_scale);
        let rest = self.turned() * (c - c.component_mul(&s));
        for i in 0..3 {
            shift[i] += rest[i];
        }
        shift[tool_axis.index()] += lift;
        let mut linear = self.linear();
        if let Some(angle) = self.basic.filter(|angle| angle.0 != 0.0) {
            let basic = turn_about(Plane::Xy, angle);
            linear = basic * linear;
            let turned = basic * Vector3::new(shift[0], shift[1], shift[2]);
            shift[..3].copy_from_slice(turned.as_slice());
        }
        Frame::new(linear, shift)
    }
}

/// Turns about the third axis of `plane`.
fn turn_about(plane: Plane, angle: Deg) -> Matrix3<f64> {
    let (first, second, _) = plane.axes();
    let (sin, cos) = angle.sin_cos();
    let mut turn = Matrix3::identity();
    turn[(first, first)] = cos;
    turn[(first, second)] = -sin;
    turn[(second, first)] = sin;
    turn[(second, second)] = cos;
    turn
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Pos;

    fn at(x: f64, y: f64) -> Pos {
        let mut p = Pos::UNKNOWN;
        p.set(Axis::X, x);
        p.set(Axis::Y, y);
        p
    }

    #[test]
    fn order_is_mirror_scale_rotate_shift() {
        let mut t = Transformation { angle: Deg(90.0), scale: 2.0, ..Transformation::default() };
        t.shift[0] = 100.0;
        t.mirror.insert(Axis::X);
        // (1, 0) -> mirror (-1, 0) -> scale (-2, 0) -> rotate (0, -2) -> shift (100, -2)
        let p = t.frame(Axis::Z, 0.0).unwrap().apply(&at(1.0, 0.0));
        assert_eq!((p.get(Axis::X), p.get(Axis::Y)), (Some(100.0), Some(-2.0)));
    }

    #[test]
    fn the_mirror_may_come_last() {
        let mut t = Transformation { angle: Deg(90.0), mirror_last: true, ..Transformation::default() };
        t.mirror.insert(Axis::X);
        // (1, 2) -> rotate (-2, 1) -> mirror (2, 1)
        let p = t.frame(Axis::Z, 0.0).unwrap().apply(&at(1.0, 2.0));
        assert!((p.get(Axis::X).unwrap() - 2.0).abs() < 1e-12 && (p.get(Axis::Y).unwrap() - 1.0).abs() < 1e-12);
        assert!(t.mirror_order_counts());
        t.angle = Deg(-180.0);
        assert!(!t.mirror_order_counts());
    }

    #[test]
    fn a_datum_shift_counts_in_the_basic_rotation() {
        let mut t = Transformation { basic: Some(Deg(90.0)), ..Transformation::default() };
        t.shift[0] = 10.0;
        // (1, 2) -> shift (11, 2) -> turn (-2, 11)
        let p = t.frame(Axis::Z, 0.0).unwrap().apply(&at(1.0, 2.0));
        assert!((p.get(Axis::X).unwrap() + 2.0).abs() < 1e-12 && (p.get(Axis::Y).unwrap() - 11.0).abs() < 1e-12);
    }

    #[test]
    fn axis_scaling_has_a_centre() {
        let t = Transformation {
            axis_scale: [1.4, 0.6, 1.0],
            scale_center: [15.0, 20.0, 0.0],
            ..Transformation::default()
        };
        let p = t.frame(Axis::Z, 0.0).unwrap().apply(&at(15.0, 30.0));
        assert!((p.get(Axis::X).unwrap() - 15.0).abs() < 1e-12 && (p.get(Axis::Y).unwrap() - 26.0).abs() < 1e-12);
    }
}
