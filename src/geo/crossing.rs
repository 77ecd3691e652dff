//! Whether two contour elements cross.

use super::intersect::{circles, line_circle, lines};
use super::{Element, Point2, direction, distance};

/// Points this close are one, in mm: more than the rounding of stored contours, less than any real crossing.
const NEAR: f64 = 0.003;
/// Sine of the angle under which directions are parallel.
const PARALLEL: f64 = 1e-9;

/// Have the elements a point in common that is none of the `shared` ones? Lines that lie in one another count.
pub fn meet(a: &Element, b: &Element, shared: &[Option<Point2>]) -> bool {
    let allowed = |p: Point2| shared.iter().flatten().any(|q| distance(p, *q) <= NEAR);
    candidates(a, b).into_iter().flatten().any(|p| holds(a, p) && holds(b, p) && !allowed(p))
}

/// Points that may be common to both.
fn candidates(a: &Element, b: &Element) -> [Option<Point2>; 4] {
    let ends = [Some(a.from()), Some(a.to()), Some(b.from()), Some(b.to())];
    let pair = |hits: Option<[Point2; 2]>| match hits {
        Some([p, q]) => [Some(p), Some(q), None, None],
        None => [None; 4],
    };
    match (*a, *b) {
        (Element::Line { from: p, to: p2 }, Element::Line { from: q, to: q2 }) => {
            let (Some(u), Some(w)) = (direction(p2 - p, 0.0), direction(q2 - q, 0.0)) else { return [None; 4] };
            match lines(p, u, q, w, PARALLEL) {
                Some((along, _)) => [Some(p + u * along), None, None, None],
                // On one line the end of one lies on the other, or they are apart.
                None => ends,
            }
        }
        (Element::Line { from, to }, Element::Arc { from: start, center, .. })
        | (Element::Arc { from: start, center, .. }, Element::Line { from, to }) => match direction(to - from, 0.0) {
            Some(u) => pair(line_circle(from, u, center, distance(start, center), 0.0)),
            None => [None; 4],
        },
        (Element::Arc { from: p, center: c, .. }, Element::Arc { from: q, center: d, .. }) => {
            let (r, s) = (distance(p, c), distance(q, d));
            if distance(c, d) <= NEAR && (r - s).abs() <= NEAR { ends } else { pair(circles(c, r, d, s, 0.0)) }
        }
    }
}

/// Does the element run through `p`, a point of its line or circle?
fn holds(element: &Element, p: Point2) -> bool {
    if distance(p, element.from()) <= NEAR || distance(p, element.to()) <= NEAR {
        return true;
    }
    match *element {
        Element::Line { from, to } => {
            let Some(u) = direction(to - from, 0.0) else { return false };
            let along = (p - from).dot(&u);
            along > 0.0 && along < distance(from, to) && super::cross(u, p - from).abs() <= NEAR
        }
        Element::Arc { from, center, sweep, .. } => {
            (distance(p, center) - distance(from, center)).abs() <= NEAR
                && super::arc::sweep(from, p, center, sweep > 0.0).abs() <= sweep.abs()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    fn line(from: (f64, f64), to: (f64, f64)) -> Element {
        Element::Line { from: Point2::new(from.0, from.1), to: Point2::new(to.0, to.1) }
    }

    #[test]
    fn lines_cross_touch_or_pass() {
        let a = line((0.0, 0.0), (10.0, 0.0));
        assert!(meet(&a, &line((5.0, -5.0), (5.0, 5.0)), &[]));
        assert!(!meet(&a, &line((5.0, 1.0), (5.0, 5.0)), &[]));
        assert!(meet(&a, &line((5.0, 0.0), (5.0, 5.0)), &[]));
        // Neighbours share a point, and one that runs back shares more.
        let corner = [Some(Point2::new(10.0, 0.0))];
        assert!(!meet(&a, &line((10.0, 0.0), (10.0, 5.0)), &corner));
        assert!(meet(&a, &line((10.0, 0.0), (4.0, 0.0)), &corner));
        assert!(!meet(&a, &line((10.0, 0.0), (20.0, 0.0)), &corner));
        assert!(!meet(&a, &line((0.0, 1.0), (10.0, 1.0)), &[]));
    }

    #[test]
    fn arcs_are_only_as_long_as_they_turn() {
        // The upper half of the unit circle.
        let arc = Element::Arc {
            from: Point2::new(1.0, 0.0),
            to: Point2::new(-1.0, 0.0),
            center: Point2::origin(),
            sweep: PI,
        };
        assert!(meet(&arc, &line((0.0, 0.0), (0.0, 2.0)), &[]));
        assert!(!meet(&arc, &line((0.0, 0.0), (0.0, -2.0)), &[]));
        let other = Element::Arc {
            from: Point2::new(0.0, 0.0),
            to: Point2::new(2.0, 0.0),
            center: Point2::new(1.0, 0.0),
            sweep: -PI,
        };
        assert!(meet(&arc, &other, &[]));
        // Below, it meets the first one in its end.
        let below = Element::Arc {
            from: Point2::new(0.0, 0.0),
            to: Point2::new(2.0, 0.0),
            center: Point2::new(1.0, 0.0),
            sweep: PI,
        };
        assert!(!meet(&arc, &below, &[]));
    }

    #[test]
    fn arcs_of_one_circle_meet_where_one_ends_on_the_other() {
        let center = Point2::new(2.0, 1.0);
        let on =
            |degrees: f64| center + super::super::turned(super::super::Vec2::new(5.0, 0.0), f64::to_radians(degrees));
        let arc =
            |from: f64, to: f64| Element::Arc { from: on(from), to: on(to), center, sweep: f64::to_radians(to - from) };
        for other in [arc(90.0, 200.0), arc(60.0, 30.0), arc(100.0, 80.0), arc(-30.0, 120.0)] {
            assert!(meet(&arc(0.0, 90.0), &other, &[]), "{other:?}");
        }
        for other in [arc(100.0, 350.0), arc(-10.0, -170.0)] {
            assert!(!meet(&arc(0.0, 90.0), &other, &[]), "{other:?}");
        }
    }
}
