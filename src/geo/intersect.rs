//! Intersections of lines and circles.

use super::{Point2, Vec2, cross, length};

/// Parameters along both lines where `p + s·u` and `q + t·w` meet. `None` for directions that are
/// parallel within `tol` (sine of the angle between unit directions).
pub fn lines(p: Point2, u: Vec2, q: Point2, w: Vec2, tol: f64) -> Option<(f64, f64)> {
    let det = cross(u, w);
    if det.abs() <= tol {
        return None;
    }
    let d = q - p;
    Some((cross(d, w) / det, cross(d, u) / det))
}

/// Points in which the line through `p` along the unit vector `u` meets a circle: none, or two that
/// coincide where it touches within `tol`. In the order of travel.
pub fn line_circle(p: Point2, u: Vec2, center: Point2, radius: f64, tol: f64) -> Option<[Point2; 2]> {
    let to_center = center - p;
    let along = to_center.dot(&u);
    let off = cross(u, to_center).abs();
    if off > radius + tol {
        return None;
    }
    let half = (radius * radius - off * off).max(0.0).sqrt();
    Some([p + u * (along - half), p + u * (along + half)])
}

/// Points in which two circles meet: none, or two that coincide where they touch within `tol`. The first
/// lies left of the way from the first centre to the second.
pub fn circles(a: Point2, ra: f64, b: Point2, rb: f64, tol: f64) -> Option<[Point2; 2]> {
    let v = b - a;
    let d = length(v);
    if d <= tol || d > ra + rb + tol || d < (ra - rb).abs() - tol {
        return None;
    }
    let along = (d * d + ra * ra - rb * rb) / (2.0 * d);
    let height = (ra * ra - along * along).max(0.0).sqrt();
    let foot = a + v * (along / d);
    let side = super::left(v) * (height / d);
    Some([foot + side, foot - side])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn basic_cases() {
        let o = Point2::origin();
        assert_eq!(lines(o, Vec2::x(), Point2::new(3.0, -2.0), Vec2::y(), 1e-12), Some((3.0, 2.0)));
        assert_eq!(lines(o, Vec2::x(), Point2::new(3.0, -2.0), Vec2::x(), 1e-12), None);
        let hit = line_circle(Point2::new(-5.0, 3.0), Vec2::x(), o, 5.0, 1e-9).unwrap();
        assert_eq!(hit, [Point2::new(-4.0, 3.0), Point2::new(4.0, 3.0)]);
        let hit = circles(o, 5.0, Point2::new(6.0, 0.0), 5.0, 1e-9).unwrap();
        assert_eq!(hit, [Point2::new(3.0, 4.0), Point2::new(3.0, -4.0)]);
        assert_eq!(circles(o, 1.0, Point2::new(6.0, 0.0), 1.0, 1e-9), None);
    }
}
