//! Angles in degrees, exact where a drawing expects it.

use core::f64::consts::PI;

use super::{Point2, Vec2};

/// An angle in degrees; any number of turns.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Deg(pub f64);

impl Deg {
    pub fn from_radians(radians: f64) -> Deg {
        Deg(radians * (180.0 / PI))
    }

    pub fn radians(self) -> f64 {
        self.0 * (PI / 180.0)
    }

    /// The same direction in `0.0..360.0`.
    pub fn normal(self) -> Deg {
        let rest = self.0 % 360.0;
        let rest = if rest < 0.0 { rest + 360.0 } else { rest };
        Deg(if rest >= 360.0 { 0.0 } else { rest })
    }

    /// Sine and cosine; exact at all multiples of 30 and 45 degrees that have an exact or a
    /// square-root value, so that 90 degrees give 0 and not 6e-17.
    pub fn sin_cos(self) -> (f64, f64) {
        let whole = self.normal().0;
        let quarter = (whole / 90.0) as u32;
        let rest = whole - 90.0 * f64::from(quarter);
        let (sin, cos) = if rest == 0.0 {
            (0.0, 1.0)
        } else if rest == 30.0 {
            (0.5, 0.75_f64.sqrt())
        } else if rest == 45.0 {
            (0.5_f64.sqrt(), 0.5_f64.sqrt())
        } else if rest == 60.0 {
            (0.75_f64.sqrt(), 0.5)
        } else {
            libm::sincos(Deg(rest).radians())
        };
        match quarter {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    /// Unit vector of the direction.
    pub fn unit(self) -> Vec2 {
        let (sin, cos) = self.sin_cos();
        Vec2::new(cos, sin)
    }

    /// Direction of `v` in `0.0..360.0`, exact along the axes and diagonals; 0 for the null vector.
    pub fn of(v: Vec2) -> Deg {
        let (x, y) = (v.x, v.y);
        let angle = if y == 0.0 {
            if x < 0.0 { 180.0 } else { 0.0 }
        } else if x == 0.0 {
            if y < 0.0 { 270.0 } else { 90.0 }
        } else if x.abs() == y.abs() {
            match (x > 0.0, y > 0.0) {
                (true, true) => 45.0,
                (false, true) => 135.0,
                (false, false) => 225.0,
                (true, false) => 315.0,
            }
        } else {
            Deg::from_radians(libm::atan2(y, x)).0
        };
        Deg(angle).normal()
    }
}

/// The point at `radius` and `angle` about `pole`. A negative radius points the other way.
///
/// `angle` counts from the first axis of the plane, counter-clockwise seen against the plane normal.
pub fn polar_point(pole: Point2, radius: f64, angle: Deg) -> Point2 {
    pole + angle.unit() * radius
}

/// `p` turned about `center` by `angle`, exact for quarter turns.
pub fn rotated(p: Point2, center: Point2, angle: Deg) -> Point2 {
    let (sin, cos) = angle.sin_cos();
    let v = p - center;
    center + Vec2::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawing_angles_are_exact() {
        assert_eq!(Deg(90.0).sin_cos(), (1.0, 0.0));
        assert_eq!(Deg(-270.0).sin_cos(), (1.0, 0.0));
        assert_eq!(Deg(180.0).sin_cos(), (0.0, -1.0));
        assert_eq!(Deg(30.0).sin_cos().0, 0.5);
        assert_eq!(Deg(300.0).sin_cos().1, 0.5);
        assert_eq!(Deg(3600.0 + 150.0).sin_cos().0, 0.5);
        assert_eq!(Deg::of(Vec2::new(-3.0, 3.0)), Deg(135.0));
        assert_eq!(Deg::of(Vec2::new(0.0, -2.0)), Deg(270.0));
        assert_eq!(Deg(-1e-30).normal(), Deg(0.0));
    }

    proptest::proptest! {
        #[test]
        fn polar_to_cartesian_and_back(radius in 0.001f64..10_000.0, angle in -720.0f64..720.0, x in -1e3f64..1e3, y in -1e3f64..1e3) {
            let pole = Point2::new(x, y);
            let p = polar_point(pole, radius, Deg(angle));
            let back = Deg::of(p - pole);
            let off = (back.0 - Deg(angle).normal().0).abs();
            // One part in 1e12 of the distances involved, seen from the pole.
            let tol = 1e-9 * (1.0 + (x.abs() + y.abs()) / radius);
            proptest::prop_assert!(off < tol || (off - 360.0).abs() < tol, "{off}");
            proptest::prop_assert!((super::super::distance(p, pole) - radius).abs() < 1e-9);
        }
    }
}
