//! Rotations in space: made of angles as controls count them, and taken apart again.
//!
//! All are active and right-handed: the columns of a matrix are the turned axes X, Y and Z in the system that was turned.
//! Source: references, multi-axis, sections 1, 2.1 and 6.2.

use nalgebra::{Matrix3, Vector3};

use super::Deg;

/// A turn about one axis, 0 for X, 1 for Y, 2 for Z.
pub fn about(axis: usize, angle: Deg) -> Matrix3<f64> {
    let (sin, cos) = angle.sin_cos();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turn = Matrix3::identity();
    turn[(i, i)] = cos;
    turn[(i, j)] = -sin;
    turn[(j, i)] = sin;
    turn[(j, j)] = cos;
    turn
}

/// About the fixed axes X, Y and Z one after the other, which is about Z, the new Y and the new X.
pub fn spatial([a, b, c]: [f64; 3]) -> Matrix3<f64> {
    about(2, Deg(c)) * about(1, Deg(b)) * about(0, Deg(a))
}

/// About Z, about the new X, about the new Z.
pub fn euler([precession, nutation, rotation]: [f64; 3]) -> Matrix3<f64> {
    about(2, Deg(precession)) * about(0, Deg(nutation)) * about(2, Deg(rotation))
}

/// About axes that each turn before has turned, in this order.
pub fn in_turn(turns: [(usize, f64); 3]) -> Matrix3<f64> {
    turns.iter().fold(Matrix3::identity(), |turned, (axis, angle)| turned * about(*axis, Deg(*angle)))
}

/// The plane whose Z lies along `normal` and whose X lies along `base`, without what that has along the normal.
/// `None` where they do not span one.
pub fn of_vectors(base: Vector3<f64>, normal: Vector3<f64>) -> Option<Matrix3<f64>> {
    let z = unit(normal)?;
    let x = unit(base - z * base.dot(&z))?;
    Some(Matrix3::from_columns(&[x, z.cross(&x), z]))
}

/// The plane through three points: X leads from the first to the second, the third lies on the side of +Y.
pub fn of_points([p, q, r]: [Vector3<f64>; 3]) -> Option<Matrix3<f64>> {
    of_vectors(q - p, (q - p).cross(&(r - p)))
}

/// Shortest vector that has a direction.
const LEAST: f64 = 1e-9;

fn unit(v: Vector3<f64>) -> Option<Vector3<f64>> {
    let length = libm::hypot(libm::hypot(v.x, v.y), v.z);
    (length > LEAST).then(|| v / length)
}

/// Cosine and sine below which an axis counts as upright: 1e-12 of a direction.
const UPRIGHT: f64 = 1e-12;

fn degrees(y: f64, x: f64) -> f64 {
    // Adding 0 makes a negative zero a zero.
    Deg::from_radians(libm::atan2(y + 0.0, x)).0 + 0.0
}

/// The angles of [`spatial`]; that about Y lies within 90 degrees.
pub fn spatial_of(turn: &Matrix3<f64>) -> [f64; 3] {
    let upright = libm::hypot(turn[(0, 0)], turn[(1, 0)]);
    let b = degrees(-turn[(2, 0)], upright);
    if upright < UPRIGHT {
        return [0.0, b, degrees(-turn[(0, 1)], turn[(1, 1)])];
    }
    [degrees(turn[(2, 1)], turn[(2, 2)]), b, degrees(turn[(1, 0)], turn[(0, 0)])]
}

/// The angles of [`euler`]; that about X lies between 0 and 180 degrees.
pub fn euler_of(turn: &Matrix3<f64>) -> [f64; 3] {
    let tilted = libm::hypot(turn[(0, 2)], turn[(1, 2)]);
    let nutation = degrees(tilted, turn[(2, 2)]);
    if tilted < UPRIGHT {
        let sign = if turn[(2, 2)] > 0.0 { 1.0 } else { -1.0 };
        return [0.0, if sign > 0.0 { 0.0 } else { 180.0 }, degrees(sign * turn[(1, 0)], turn[(0, 0)])];
    }
    [degrees(turn[(0, 2)], -turn[(1, 2)]), nutation, degrees(turn[(2, 0)], turn[(2, 1)])]
}

#[cfg(test)]
mod tests {
    use core::f64::consts::FRAC_1_SQRT_2;

    use proptest::prelude::*;

    use super::*;

    fn near(a: &Matrix3<f64>, b: &Matrix3<f64>, tolerance: f64) -> bool {
        (a - b).iter().all(|v| v.abs() <= tolerance)
    }

    fn is(v: Vector3<f64>, wanted: [f64; 3]) {
        for (i, wanted) in wanted.iter().enumerate() {
            assert!((v[i] - wanted).abs() < 2e-6, "{v}");
        }
    }

    fn column(turn: &Matrix3<f64>, i: usize) -> Vector3<f64> {
        turn.column(i).into_owned()
    }

    fn angles(found: [f64; 3], wanted: [f64; 3]) {
        for (found, wanted) in found.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-4, "{found} {wanted}");
        }
    }

    /// Section 9, rows 1 to 4: the same planes by both kinds of angles.
    #[test]
    fn worked_frames() {
        let first = spatial([27.0, 0.0, 45.0]);
        is(column(&first, 0), [FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0]);
        is(column(&first, 1), [-0.630037, 0.630037, 0.453990]);
        is(column(&first, 2), [0.321020, -0.321020, 0.891007]);
        angles(euler_of(&first), [45.0, 27.0, 0.0]);
        let second = spatial([45.0, 0.0, 90.0]);
        is(column(&second, 0), [0.0, 1.0, 0.0]);
        is(column(&second, 2), [FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2]);
        angles(euler_of(&second), [90.0, 45.0, 0.0]);
        let third = spatial([30.0, 20.0, 10.0]);
        is(column(&third, 0), [0.925417, 0.163176, -0.342020]);
        is(column(&third, 1), [0.018028, 0.882564, 0.469846]);
        is(column(&third, 2), [0.378522, -0.440970, 0.813798]);
        angles(euler_of(&third), [40.6423, 35.5313, -36.0524]);
        let fourth = euler([45.0, 20.0, 22.0]);
        is(column(&fourth, 2), [0.241845, -0.241845, 0.939693]);
        is(column(&fourth, 0), [0.406706, 0.904530, 0.128123]);
        angles(spatial_of(&fourth), [18.6479, -7.3611, 65.7898]);
    }

    /// Rows 5 to 9: vectors and points.
    #[test]
    fn worked_vectors_and_points() {
        let at = Vector3::new;
        let of = |base, normal| spatial_of(&of_vectors(base, normal).unwrap());
        angles(of(at(0.810_667_6, 0.585_506_7, 0.0), at(-0.565_556_1, 0.783_044_7, 0.258_819)), [-75.0, 0.0, 35.8388]);
        angles(of(at(1.0, 0.0, 0.0), at(0.0, 0.5, 0.866)), [-30.0007, 0.0, 0.0]);
        angles(of(at(1.0, 1.0, 0.0), at(1.0, 0.0, 1.0)), [39.2315, 24.0948, 63.4349]);
        let of = |points| spatial_of(&of_points(points).unwrap());
        angles(of([at(0.0, 0.0, 20.0), at(30.0, 0.0, 20.0), at(0.0, 20.0, 30.0)]), [26.5651, 0.0, 0.0]);
        angles(of([at(0.0, 0.0, 0.0), at(20.0, 0.0, 5.0), at(0.0, 20.0, 0.0)]), [0.0, -14.0362, 0.0]);
        assert_eq!(of_points([at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(2.0, 2.0, 0.0)]), None);
    }

    /// Rows 10 and 11: a turn about an axis of the plane in force.
    #[test]
    fn worked_relative_turns() {
        let tilted = spatial([0.0, 30.0, 0.0]);
        angles(spatial_of(&(tilted * about(2, Deg(45.0)))), [22.2077, 20.7048, 49.1066]);
        angles(spatial_of(&(tilted * about(0, Deg(20.0)))), [20.0, 30.0, 0.0]);
    }

    /// Section 3.1: the six orders of CYCLE800 with 10, 20, 30, by the Z of the plane.
    #[test]
    fn worked_orders() {
        let (x, y, z) = (0, 1, 2);
        let normal = |axes: [usize; 3]| column(&in_turn([(axes[0], 10.0), (axes[1], 20.0), (axes[2], 30.0)]), 2);
        is(normal([x, y, z]), [0.342020, -0.163176, 0.925417]);
        is(normal([y, x, z]), [0.163176, -0.342020, 0.925417]);
        is(normal([x, z, y]), [0.469846, 0.018028, 0.882564]);
        is(normal([z, x, y]), [0.543838, -0.204874, 0.813798]);
        is(normal([y, z, x]), [0.318796, -0.469846, 0.823173]);
        is(normal([z, y, x]), [0.378522, -0.440970, 0.813798]);
    }

    /// Row 32: the I, J and K of G68.2.
    #[test]
    fn worked_euler_angles() {
        angles(euler_of(&spatial([0.0, 45.0, 0.0])), [90.0, 45.0, -90.0]);
        angles(euler_of(&spatial([-15.0, 0.0, 0.0])), [180.0, 15.0, 180.0]);
        angles(euler_of(&in_turn([(2, -45.0), (0, 54.365), (1, 0.0)])), [-45.0, 54.365, 0.0]);
        angles(euler_of(&spatial([0.0, 90.0, 0.0])), [90.0, 90.0, -90.0]);
        angles(euler_of(&spatial([0.0, 0.0, 30.0])), [0.0, 0.0, 30.0]);
        angles(euler_of(&spatial([180.0, 0.0, 0.0])), [0.0, 180.0, 0.0]);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100_000))]
        #[test]
        fn angles_and_back(a in -400.0f64..400.0, b in -400.0f64..400.0, c in -400.0f64..400.0, whole in 0usize..8) {
            let round = |v: f64, bit: usize| if whole & (1 << bit) == 0 { v } else { (v / 45.0).round() * 45.0 };
            let turn = spatial([round(a, 0), round(b, 1), round(c, 2)]);
            prop_assert!(near(&spatial(spatial_of(&turn)), &turn, 1e-11));
            prop_assert!(near(&euler(euler_of(&turn)), &turn, 1e-11));
            prop_assert!(near(&(turn * turn.transpose()), &Matrix3::identity(), 1e-14));
            let vectors = of_vectors(column(&turn, 0) * 3.0 + column(&turn, 2), column(&turn, 2) * 0.5);
            prop_assert!(near(&vectors.unwrap(), &turn, 1e-11));
        }
    }
}
