//! Least distance of contour elements, exact for lines and arcs.

use super::{Element, Point2, SAME_POINT, Vec2, cross, direction, distance, intersect};

/// Least distance of `p` from an element.
pub fn point_to(p: Point2, element: &Element) -> f64 {
    let ends = distance(p, element.from()).min(distance(p, element.to()));
    match *element {
        Element::Line { from, to } => match direction(to - from, 0.0) {
            Some(u) => {
                let along = (p - from).dot(&u);
                if along > 0.0 && along < distance(from, to) { cross(u, p - from).abs() } else { ends }
            }
            None => ends,
        },
        Element::Arc { from, center, .. } => {
            if on_arc(element, p) {
                ends.min((distance(p, center) - distance(from, center)).abs())
            } else {
                ends
            }
        }
    }
}

/// On which side of an element `p` lies at the place nearest to it: over 0 to the left, seen in its direction.
pub fn side_of(p: Point2, element: &Element) -> f64 {
    match *element {
        Element::Line { from, to } => direction(to - from, 0.0).map_or(0.0, |u| cross(u, p - from)),
        Element::Arc { from, center, sweep, .. } => {
            if on_arc(element, p) {
                (distance(from, center) - distance(p, center)) * sweep.signum()
            } else {
                // Beyond an end: the tangent there.
                let at_start = distance(p, element.from()) <= distance(p, element.to());
                let (end, u) = if at_start {
                    (element.from(), element.start_direction())
                } else {
                    (element.to(), element.end_direction())
                };
                u.map_or(0.0, |u| cross(u, p - end))
            }
        }
    }
}

/// Least distance of two elements; 0 where they meet.
pub fn between(a: &Element, b: &Element) -> f64 {
    if meet(a, b) {
        return 0.0;
    }
    let ends = [point_to(a.from(), b), point_to(a.to(), b), point_to(b.from(), a), point_to(b.to(), a)];
    ends.into_iter().fold(inner(a, b), f64::min)
}

/// Does the direction from the centre of the arc to `p` lie within the arc?
fn on_arc(arc: &Element, p: Point2) -> bool {
    let Element::Arc { from, center, sweep, .. } = *arc else { return false };
    let radius = distance(from, center);
    if distance(p, center) <= SAME_POINT || radius <= 0.0 {
        return false;
    }
    let turn = super::arc::sweep(from, center + (p - center) * (radius / distance(p, center)), center, sweep > 0.0);
    // A direction that is nearly the start gives a whole turn.
    turn.abs() <= sweep.abs() + 1e-9 || turn.abs() >= core::f64::consts::TAU - 1e-9
}

fn on_line(line: &Element, p: Point2) -> bool {
    let Element::Line { from, to } = *line else { return false };
    direction(to - from, 0.0).is_some_and(|u| {
        let along = (p - from).dot(&u);
        along >= 0.0 && along <= distance(from, to)
    })
}

fn on(element: &Element, p: &Point2) -> bool {
    match element {
        Element::Line { .. } => on_line(element, *p),
        Element::Arc { .. } => on_arc(element, *p),
    }
}

fn ray(line: &Element) -> Option<(Point2, Vec2)> {
    match *line {
        Element::Line { from, to } => Some((from, direction(to - from, 0.0)?)),
        Element::Arc { .. } => None,
    }
}

fn circle(arc: &Element) -> Option<(Point2, f64)> {
    match *arc {
        Element::Arc { from, center, .. } => Some((center, distance(from, center))),
        Element::Line { .. } => None,
    }
}

/// The points that the whole lines and circles of two elements share; what touches within `tol` counts. A line of no
/// length is a point.
pub(super) fn crossings(a: &Element, b: &Element, tol: f64) -> [Option<Point2>; 2] {
    let pair = |hits: Option<[Point2; 2]>| hits.map_or([None; 2], |[p, q]| [Some(p), Some(q)]);
    match (ray(a), ray(b), circle(a), circle(b)) {
        (Some((p, u)), Some((q, w)), _, _) => {
            [intersect::lines(p, u, q, w, super::SAME_DIRECTION).map(|(s, _)| p + u * s), None]
        }
        (Some((p, u)), _, _, Some((c, r))) | (_, Some((p, u)), Some((c, r)), _) => {
            pair(intersect::line_circle(p, u, c, r, tol))
        }
        (_, _, Some((a, ra)), Some((b, rb))) => pair(intersect::circles(a, ra, b, rb, tol)),
        (None, _, None, _) => [Some(a.from()), None],
        _ => [Some(b.from()), None],
    }
}

fn meet(a: &Element, b: &Element) -> bool {
    crossings(a, b, 0.0).into_iter().flatten().any(|p| on(a, &p) && on(b, &p))
}

/// Least distance at places inside of both elements; infinite if there are none.
fn inner(a: &Element, b: &Element) -> f64 {
    match (ray(a), ray(b), circle(a), circle(b)) {
        (Some(line), _, _, Some(arc)) => foot(a, b, line, arc),
        (_, Some(line), Some(arc), _) => foot(b, a, line, arc),
        (_, _, Some((ca, ra)), Some((cb, rb))) => {
            // About one centre: their ends tell, or they run side by side.
            let Some(u) = direction(cb - ca, SAME_POINT) else { return f64::INFINITY };
            let places = |c: Point2, r: f64| [c + u * r, c - u * r];
            let of_b = places(cb, rb).map(|q| on(b, &q).then_some(q));
            let least = |p: Point2| of_b.iter().flatten().map(|q| distance(p, *q)).fold(f64::INFINITY, f64::min);
            places(ca, ra).into_iter().filter(|p| on(a, p)).map(least).fold(f64::INFINITY, f64::min)
        }
        _ => f64::INFINITY,
    }
}

fn foot(line: &Element, arc: &Element, (p, u): (Point2, Vec2), (c, r): (Point2, f64)) -> f64 {
    let foot = p + u * (c - p).dot(&u);
    if on_line(line, foot) && on_arc(arc, foot) { (distance(foot, c) - r).abs() } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(a: (f64, f64), b: (f64, f64)) -> Element {
        Element::Line { from: Point2::new(a.0, a.1), to: Point2::new(b.0, b.1) }
    }

    #[test]
    fn lines_and_arcs() {
        let half = Element::Arc {
            from: Point2::new(5.0, 0.0),
            to: Point2::new(-5.0, 0.0),
            center: Point2::origin(),
            sweep: core::f64::consts::PI,
        };
        assert_eq!(between(&line((0.0, 0.0), (10.0, 0.0)), &line((5.0, -1.0), (5.0, 1.0))), 0.0);
        assert!(
            (between(&line((0.0, 0.0), (10.0, 0.0)), &line((12.0, 1.0), (12.0, 5.0))) - 5.0_f64.sqrt()).abs() < 1e-12
        );
        assert!((between(&line((-9.0, 7.0), (9.0, 7.0)), &half) - 2.0).abs() < 1e-12);
        // Below the open side only the ends count.
        assert!((between(&line((-9.0, -2.0), (9.0, -2.0)), &half) - 2.0).abs() < 1e-12);
        assert!((between(&line((-1.0, -2.0), (1.0, -2.0)), &half) - 20.0_f64.sqrt()).abs() < 1e-12);
        assert!((point_to(Point2::new(0.0, 1.0), &half) - 4.0).abs() < 1e-12);
        let small = Element::Arc {
            from: Point2::new(1.0, 8.0),
            to: Point2::new(-1.0, 8.0),
            center: Point2::new(0.0, 8.0),
            sweep: -core::f64::consts::PI,
        };
        assert!((between(&half, &small) - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_line_of_no_length_crosses_where_it_is() {
        let (point, way) = (line((3.0, 0.0), (3.0, 0.0)), line((0.0, 0.0), (10.0, 0.0)));
        assert_eq!(crossings(&point, &way, 0.0), [Some(Point2::new(3.0, 0.0)), None]);
        assert_eq!(crossings(&way, &point, 0.0), [Some(Point2::new(3.0, 0.0)), None]);
    }
}
