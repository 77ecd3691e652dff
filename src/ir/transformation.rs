//! Axes that a program sees and the machine does not have: it works on a face or a mantle as in a plane, while a rotary
//! axis turns the workpiece.
//!
//! The rotary axis turns about Z. The program sees X, Y and Z; the machine moves X, which is the distance from the axis of
//! rotation, Z, and the rotary axis.

use core::f64::consts::PI;

use crate::machine::Axis;

use super::{Ask, Pos};

/// What the program works on, and the axis that turns it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transformation {
    /// The surface that the program sees as a plane.
    pub surface: Surface,
    /// The rotary axis of the workpiece, which turns about Z.
    pub rotary: Axis,
    /// Where the control counts that axis to stand at the start, in degrees; `None` where nobody knows in which turn it counts.
    pub starts: Option<f64>,
    /// What the user may choose where the tool passes the axis of rotation too closely.
    pub at_pole: &'static Ask,
}

/// The surface on which the program works.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surface {
    /// The face: X and Y are Cartesian about the axis of rotation, X points to the tool where the rotary axis stands at 0.
    Face,
    /// The mantle, unrolled: Y is the way along the circumference at `diameter`, in mm, above zero; X is the radius.
    Mantle { diameter: f64 },
}

impl Transformation {
    /// Degrees of the rotary axis in a millimetre of the circumference.
    pub fn degrees_per_mm(diameter: f64) -> f64 {
        360.0 / (PI * diameter)
    }

    /// The position that the program sees, in mm, where the machine stands at `real`, with the rotary axis in degrees.
    /// Nothing is seen of X and Y where that is not known or does not say one place.
    pub fn seen(&self, real: &Pos) -> Pos {
        let mut seen = *real;
        seen.forget(Axis::Y);
        seen.forget(self.rotary);
        let angle = real.get(self.rotary);
        match self.surface {
            Surface::Face => {
                seen.forget(Axis::X);
                if let Some((radius, angle)) = real.get(Axis::X).zip(angle)
                    && radius > 0.0
                {
                    let angle = angle.to_radians();
                    seen.set(Axis::X, radius * libm::cos(angle));
                    seen.set(Axis::Y, radius * libm::sin(angle));
                }
            }
            // Beyond half a turn the control may count on or begin anew.
            Surface::Mantle { diameter } => {
                if let Some(angle) = self.starts.filter(|angle| angle.abs() <= 180.0) {
                    seen.set(Axis::Y, angle / Transformation::degrees_per_mm(diameter));
                }
            }
        }
        seen
    }

    /// The position of the machine after the transformation, which ends where the program sees `seen`. How often the
    /// workpiece has turned is not said.
    pub fn left(&self, seen: &Pos) -> Pos {
        let mut real = *seen;
        real.forget(Axis::Y);
        real.forget(self.rotary);
        if self.surface == Surface::Face {
            real.forget(Axis::X);
            if let Some((x, y)) = seen.get(Axis::X).zip(seen.get(Axis::Y)) {
                real.set(Axis::X, libm::hypot(x, y));
            }
        }
        real
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn real(x: f64, c: f64) -> Pos {
        let mut pos = Pos::UNKNOWN;
        pos.set(Axis::X, x);
        pos.set(Axis::C, c);
        pos
    }

    const NOTHING: Ask = Ask::key("", "", "");

    #[test]
    fn a_face_is_seen_about_the_axis_of_rotation() {
        let face = Transformation { surface: Surface::Face, rotary: Axis::C, starts: None, at_pole: &NOTHING };
        let seen = face.seen(&real(13.0, 112.619_864_948_040_43));
        let (x, y) = (seen.get(Axis::X).unwrap(), seen.get(Axis::Y).unwrap());
        assert!((x + 5.0).abs() < 1e-9 && (y - 12.0).abs() < 1e-9, "{x} {y}");
        assert_eq!(face.left(&seen).get(Axis::X), Some(13.0));
        assert_eq!(face.seen(&real(-13.0, 0.0)).get(Axis::X), None);
    }

    #[test]
    fn a_mantle_is_seen_up_to_half_a_turn() {
        let mantle = |starts| Transformation {
            surface: Surface::Mantle { diameter: 80.0 },
            rotary: Axis::C,
            starts,
            at_pole: &NOTHING,
        };
        let seen = mantle(Some(14.323_944_878_270_58)).seen(&real(40.0, 14.323_944_878_270_58));
        assert!((seen.get(Axis::Y).unwrap() - 10.0).abs() < 1e-9);
        assert_eq!(mantle(Some(200.0)).seen(&real(40.0, 200.0)).get(Axis::Y), None);
        // Where the output stands says nothing of how the control counts.
        assert_eq!(mantle(None).seen(&real(40.0, 20.0)).get(Axis::Y), None);
        let mantle = mantle(None);
        assert_eq!(mantle.left(&seen).get(Axis::X), Some(40.0));
    }
}
