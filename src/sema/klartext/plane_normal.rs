//! Where the tool axis of a tilted working plane points: named where the tilt is refused.
//!
//! Source: K 3.4 (docs/sources.md); nothing is printed from these matrices.

use nalgebra::{Matrix3, Vector3};

use crate::geo::Deg;

/// Turns about the axis `axis` of X, Y, Z.
pub(super) fn turn(axis: usize, angle: f64) -> Matrix3<f64> {
    let (sin, cos) = Deg(angle).sin_cos();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turn = Matrix3::identity();
    turn[(i, i)] = cos;
    turn[(i, j)] = -sin;
    turn[(j, i)] = sin;
    turn[(j, j)] = cos;
    turn
}

/// PLANE SPATIAL, and cycle 19 by space angles: about the fixed axes X, Y, Z one after the other.
pub(super) fn spatial([a, b, c]: [f64; 3]) -> Vector3<f64> {
    turn(2, c) * turn(1, b) * turn(0, a) * Vector3::z()
}

/// PLANE EULER: about Z, the new X, the new Z.
pub(super) fn euler([precession, nutation, _]: [f64; 3]) -> Vector3<f64> {
    turn(2, precession) * turn(0, nutation) * Vector3::z()
}

/// PLANE POINTS: the side from which the tool comes.
pub(super) fn points([p, q, r]: [Vector3<f64>; 3]) -> Option<Vector3<f64>> {
    let normal = (q - p).cross(&(r - p)).try_normalize(1e-12)?;
    Some(if normal.z < 0.0 { -normal } else { normal })
}

/// `(-0.0396, -0.4178, 0.9077)`
pub(super) fn shown(normal: &Vector3<f64>) -> String {
    // Adding 0 makes a negative zero a zero.
    let [x, y, z] = [normal.x, normal.y, normal.z].map(|v| format!("{:.4}", (v * 1e4).round() / 1e4 + 0.0));
    format!("({x}, {y}, {z})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_of_the_worked_example() {
        let normal = spatial([20.0, -15.0, 30.0]);
        assert!((normal - Vector3::new(-0.039616, -0.417803, 0.907673)).norm() < 1e-6, "{normal}");
        let all = turn(2, 30.0) * turn(1, -15.0) * turn(0, 20.0);
        let point = all * Vector3::new(10.0, 5.0, -2.0);
        assert!((point - Vector3::new(5.7119, 9.5129, 2.4247)).norm() < 1e-4, "{point}");
        assert_eq!(shown(&normal), "(-0.0396, -0.4178, 0.9077)");
    }

    #[test]
    fn other_planes() {
        // Nutation of 90 degrees about X turned by 90 degrees, which is Y: Z goes to +X.
        assert_eq!(shown(&euler([90.0, 90.0, 12.0])), "(1.0000, 0.0000, 0.0000)");
        let at = Vector3::new;
        let plane = [at(0.0, 0.0, 0.0), at(0.0, 20.0, 0.0), at(20.0, 0.0, 20.0)];
        assert_eq!(points(plane).map(|n| shown(&n)).as_deref(), Some("(-0.7071, 0.0000, 0.7071)"));
        assert_eq!(points([at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(2.0, 2.0, 0.0)]), None);
    }
}
