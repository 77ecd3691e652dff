//! What lies between the parallels of two contour elements: the joints of radius compensation.
//!
//! `d` is the signed distance of the parallel, positive to the left of the direction of travel.

use core::f64::consts::{PI, TAU};

use super::clearance::crossings;
use super::{Element, Point2, SAME_DIRECTION, SAME_POINT, Vec2, cross, direction, distance, left, turned};

/// Parallels whose ends are closer than this, in mm, meet there, if the contour hardly turns.
const MEETS: f64 = 1e-3;
/// Turns up to this sine (0.01 degrees) are no corner but the rounding of a tangential joint.
const NO_CORNER: f64 = 1.745e-4;
/// Turns this close to half a turn, as a sine, are reversals.
const REVERSAL: f64 = 1e-6;
/// How far a crossing may lie beyond the end of an element, in mm: what double arithmetic loses.
const BEYOND: f64 = 1e-6;
/// How far a line may pass by the centre of a hollow arc as large as the tool, in mm.
const POINT: f64 = 1e-5;
/// What touching circles may miss each other by, in mm.
const TOUCH: f64 = 1e-7;

/// What the parallels of two neighbours do at the point where the contour elements meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Joint {
    /// They meet end to end.
    Tangential(Point2),
    /// They cross: both end here.
    Inside(Point2),
    /// The contour turns away from the parallel: the gap is the control's to fill.
    Outside,
    /// The contour turns towards the parallel, and they do not cross.
    NoRoom,
}

/// Directions of travel at both ends of an element.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Headings {
    pub start: Vec2,
    pub end: Vec2,
}

impl Headings {
    /// `None` for an element of no length.
    #[inline(always)]
    pub fn of(element: &Element) -> Option<Headings> {
        match *element {
            Element::Line { from, to } => {
                // Its square neither overflows nor vanishes, as long as it has a length.
                let (along, square) = (to - from, (to - from).norm_squared());
                let along = (square > 0.0).then(|| along / square.sqrt())?;
                Some(Headings { start: along, end: along })
            }
            Element::Arc { from, to, center, sweep } => {
                let heading = |p: Point2| super::arc::tangent_at(p, center, sweep > 0.0);
                Some(Headings { start: heading(from)?, end: heading(to)? })
            }
        }
    }
}

/// The parallel of an element. A hollow arc of the radius `d` becomes a line of no length in its centre; `None` for an arc
/// in which the parallel has no room.
#[inline(always)]
pub fn parallel(element: &Element, headings: &Headings, d: f64) -> Option<Element> {
    match *element {
        Element::Line { from, to } => {
            let by = left(headings.start) * d;
            Some(Element::Line { from: from + by, to: to + by })
        }
        Element::Arc { from, center, sweep, .. } => {
            let other = distance(from, center) - sweep.signum() * d;
            if other.abs() <= SAME_POINT {
                return Some(Element::Line { from: center, to: center });
            }
            let place = |heading: Vec2| center - left(heading) * (sweep.signum() * other);
            let (from, to) = (place(headings.start), place(headings.end));
            (other > 0.0).then_some(Element::Arc { from, to, center, sweep })
        }
    }
}

/// By how much the contour turns between two directions, in rad: positive to the left, half a turn for a reversal.
pub fn turn(before: Vec2, after: Vec2) -> f64 {
    libm::atan2(cross(before, after), before.dot(&after))
}

/// The joint of the parallels `a` and `b` of two neighbours, which end and begin in these directions. `a` may have lost its
/// beginning, `b` is whole.
#[inline(always)]
pub fn joint(a: &Element, b: &Element, before: Vec2, after: Vec2, d: f64) -> Joint {
    let (sin, goes_on) = (cross(before, after), before.dot(&after) > 0.0);
    if goes_on && (sin.abs() <= SAME_DIRECTION || sin.abs() < NO_CORNER && distance(a.to(), b.from()) < MEETS) {
        return Joint::Tangential(between_ends(a, b));
    }
    if !goes_on && sin.abs() <= REVERSAL || sin * d < 0.0 {
        return Joint::Outside;
    }
    let crossing = match (*a, *b) {
        (Element::Line { from, to }, Element::Line { from: next, to: end }) if from != to && next != end => {
            lines_crossing([from, to], before, [next, end], after)
        }
        _ => first_crossing(a, b),
    };
    crossing.map_or(Joint::NoRoom, Joint::Inside)
}

/// Where two lines cross that run in these directions.
#[inline(always)]
fn lines_crossing([from, to]: [Point2; 2], u: Vec2, [next, end]: [Point2; 2], w: Vec2) -> Option<Point2> {
    let (of_a, of_b) = super::intersect::lines(from, u, next, w, SAME_DIRECTION)?;
    let p = from + u * of_a;
    let ways = [of_a, of_b, (to - p).dot(&u), (end - p).dot(&w)];
    ways.iter().all(|way| *way >= -BEYOND).then_some(p)
}

/// The point in the middle of a tangential joint: on the smaller circle, where the other element misses it least.
#[inline(never)]
fn between_ends(a: &Element, b: &Element) -> Point2 {
    let middle = Point2::from((a.to().coords + b.from().coords) / 2.0);
    let circle = |element: &Element| match *element {
        Element::Line { .. } => None,
        Element::Arc { from, center, .. } => Some((center, distance(from, center))),
    };
    let smaller = circle(a).into_iter().chain(circle(b)).min_by(|(_, p), (_, q)| p.total_cmp(q));
    let on_circle = smaller.and_then(|(center, radius)| Some(center + direction(middle - center, 0.0)? * radius));
    on_circle.unwrap_or(middle)
}

/// `p`, a hollow arc that shrank, if `element` misses it by rounding only.
fn passes(p: Point2, element: &Element) -> Option<Point2> {
    let near = match *element {
        Element::Line { from, to } => {
            direction(to - from, 0.0).map_or(distance(from, p), |u| cross(u, p - from).abs()) <= POINT
        }
        Element::Arc { from, center, .. } => {
            let radius = distance(from, center);
            (distance(p, center) - radius).abs() <= TOUCH * (1.0 + radius)
        }
    };
    near.then_some(p)
}

fn is_point(element: &Element) -> bool {
    matches!(element, Element::Line { from, to } if from == to)
}

/// Where `a` and `b` cross; of two points the one nearest to the start of `b`.
#[inline(never)]
pub fn first_crossing(a: &Element, b: &Element) -> Option<Point2> {
    let on_both = |p: &Point2| {
        let (of_a, of_b) = (way_to_end(a, *p), way_from_start(b, *p));
        (-BEYOND..=a.length() + BEYOND).contains(&of_a) && (-BEYOND..=b.length() + BEYOND).contains(&of_b)
    };
    let of_point = match (is_point(a), is_point(b)) {
        (false, false) => None,
        (true, _) => Some([passes(a.from(), b), None]),
        (_, true) => Some([passes(b.from(), a), None]),
    };
    let found = of_point.unwrap_or_else(|| crossings(a, b, TOUCH)).into_iter().flatten().filter(on_both);
    found.min_by(|p, q| way_from_start(b, *p).total_cmp(&way_from_start(b, *q)))
}

/// Where the parallels meet if both are prolonged, lines as lines and circles as circles, as near to the gap as
/// possible. A hollow arc as large as the tool has nothing to prolong.
pub fn prolonged(a: &Element, b: &Element) -> Option<Point2> {
    if is_point(a) || is_point(b) {
        return None;
    }
    let beyond = |p: &Point2| {
        let (of_a, of_b) = (prolongation(a, *p, true), prolongation(b, *p, false));
        of_a.zip(of_b).map(|(x, y)| x + y)
    };
    let found = crossings(a, b, TOUCH).into_iter().flatten().filter_map(|p| Some((p, beyond(&p)?)));
    found.min_by(|p, q| p.1.total_cmp(&q.1)).map(|(p, _)| p)
}

/// How far `p`, a point of the line or circle of `element`, lies beyond its end, or in front of its start: less than half
/// a turn of a circle.
fn prolongation(element: &Element, p: Point2, at_end: bool) -> Option<f64> {
    let far = match *element {
        Element::Line { .. } if at_end => -way_to_end(element, p),
        Element::Line { .. } => -way_from_start(element, p),
        Element::Arc { from, to, center, sweep } => {
            let radius = distance(from, center);
            let angle = if at_end { angle_on(to, p, center, sweep) } else { angle_on(p, from, center, sweep) };
            if angle < PI { angle * radius } else { return None }
        }
    };
    (far >= -BEYOND).then_some(far)
}

/// Angle from the direction of `p` to that of `q` in the sense of `sweep`, in rad; what is nearly a turn is none.
fn angle_on(p: Point2, q: Point2, center: Point2, sweep: f64) -> f64 {
    let angle = super::arc::sweep(p, q, center, sweep > 0.0).abs();
    let slack = BEYOND / distance(p, center).max(BEYOND);
    if angle >= TAU - slack { angle - TAU } else { angle }
}

/// The same on an element of this sweep: what lies nearer to a turn than to the whole sweep is a little below zero.
fn part_of(sweep: f64, p: Point2, q: Point2, center: Point2) -> f64 {
    let angle = super::arc::sweep(p, q, center, sweep > 0.0).abs();
    // Both ends of a circle lie at one place: what is near them is an end, not the other one.
    let near = MEETS / distance(p, center).max(MEETS);
    let most = if sweep.abs() < TAU - 2.0 * near { (sweep.abs() + TAU) / 2.0 } else { TAU - near };
    if angle > most { angle - TAU } else { angle }
}

/// Way from the start of an element to `p`, a point of its line or circle; a little below zero in front of it.
pub fn way_from_start(element: &Element, p: Point2) -> f64 {
    match *element {
        Element::Line { from, to } => match direction(to - from, 0.0) {
            Some(u) => (p - from).dot(&u),
            None => distance(p, from),
        },
        Element::Arc { from, center, sweep, .. } => part_of(sweep, from, p, center) * distance(from, center),
    }
}

/// Way from `p`, a point of the line or circle of an element, to its end.
pub fn way_to_end(element: &Element, p: Point2) -> f64 {
    match *element {
        Element::Line { from, to } => match direction(to - from, 0.0) {
            Some(u) => (to - p).dot(&u),
            None => distance(p, to),
        },
        Element::Arc { from, to, center, sweep } => part_of(sweep, p, to, center) * distance(from, center),
    }
}

/// The part of an element from `p` on; its circle is kept.
pub fn from_point(element: &Element, p: Point2) -> Element {
    match *element {
        Element::Line { to, .. } => Element::Line { from: p, to },
        Element::Arc { from, to, center, sweep } => {
            let rest = sweep - sweep.signum() * part_of(sweep, from, p, center);
            Element::Arc { from: p, to, center, sweep: rest }
        }
    }
}

/// The part of an element up to `p`; its circle is kept.
pub fn up_to_point(element: &Element, p: Point2) -> Element {
    match *element {
        Element::Line { from, .. } => Element::Line { from, to: p },
        Element::Arc { from, to, center, sweep } => {
            let rest = sweep - sweep.signum() * part_of(sweep, p, to, center);
            Element::Arc { from, to: p, center, sweep: rest }
        }
    }
}

/// The same element prolonged to `p`, a point beyond its end.
pub fn prolonged_to(element: &Element, p: Point2) -> Element {
    match *element {
        Element::Line { from, .. } => Element::Line { from, to: p },
        Element::Arc { from, to, center, sweep } => {
            let more = sweep.signum() * angle_on(to, p, center, sweep);
            Element::Arc { from, to: p, center, sweep: sweep + more }
        }
    }
}

/// The same element begun at `p`, a point in front of its start.
pub fn prolonged_from(element: &Element, p: Point2) -> Element {
    match *element {
        Element::Line { to, .. } => Element::Line { from: p, to },
        Element::Arc { from, to, center, sweep } => {
            let more = sweep.signum() * angle_on(p, from, center, sweep);
            Element::Arc { from: p, to, center, sweep: sweep + more }
        }
    }
}

/// Point from which a line runs tangentially into the circle about `center`, seen from `from`: the circle is travelled on
/// from there in the sense of `ccw`. `None` inside of the circle.
pub fn tangent_point(from: Point2, center: Point2, radius: f64, ccw: bool) -> Option<Point2> {
    let out = from - center;
    let far = super::length(out);
    if far < radius || far <= 0.0 {
        return None;
    }
    let angle = libm::acos((radius / far).min(1.0));
    Some(center + turned(out / far, if ccw { angle } else { -angle }) * radius)
}

/// The direction from the contour to the parallel at a point that is passed in `heading`.
pub fn towards(heading: Vec2, d: f64) -> Vec2 {
    left(heading) * d.signum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: (f64, f64), to: (f64, f64)) -> Element {
        Element::Line { from: Point2::new(from.0, from.1), to: Point2::new(to.0, to.1) }
    }

    fn arc(from: (f64, f64), to: (f64, f64), center: (f64, f64), ccw: bool) -> Element {
        let (from, to, center) =
            (Point2::new(from.0, from.1), Point2::new(to.0, to.1), Point2::new(center.0, center.1));
        Element::Arc { from, to, center, sweep: super::super::arc::sweep(from, to, center, ccw) }
    }

    fn at(p: Point2, x: f64, y: f64) -> bool {
        distance(p, Point2::new(x, y)) < 6e-5
    }

    fn beside(element: &Element, d: f64) -> Option<Element> {
        parallel(element, &Headings::of(element)?, d)
    }

    fn made(a: &Element, b: &Element, d: f64) -> Joint {
        let (before, after) = (Headings::of(a).unwrap().end, Headings::of(b).unwrap().start);
        joint(&beside(a, d).unwrap(), &beside(b, d).unwrap(), before, after, d)
    }

    #[test]
    fn a_circle_between_tangents_stays_whole() {
        for missed in [0.0, 3e-4, -3e-4, 9e-4, -9e-4] {
            let (a, b) = (line((0.0, -20.0), (0.0, 0.0)), line((0.0, 0.0), (0.0, 30.0)));
            let circle = Element::Arc {
                from: Point2::origin(),
                to: Point2::origin(),
                center: Point2::new(20.0, missed),
                sweep: -TAU,
            };
            for d in [5.0, -5.0] {
                let (Joint::Tangential(p), Joint::Tangential(q)) = (made(&a, &circle, d), made(&circle, &b, d)) else {
                    panic!("{missed}");
                };
                let own = beside(&circle, d).unwrap();
                let left = up_to_point(&from_point(&own, p), q);
                let Element::Arc { sweep, .. } = left else { panic!() };
                assert!((sweep + TAU).abs() < 1e-4, "{missed} {d}: {sweep}");
            }
        }
    }

    #[test]
    fn inside_corners() {
        let (a, b) = (line((0.0, 0.0), (50.0, 0.0)), line((50.0, 0.0), (21.7157, 28.2843)));
        assert!(matches!(made(&a, &b, 5.0), Joint::Inside(p) if at(p, 37.9289, 5.0)));
        let (a, b) = (line((0.0, 0.0), (30.0, 0.0)), arc((30.0, 0.0), (56.0954, -3.8697), (42.0, -9.0), false));
        assert!(matches!(made(&a, &b, 4.0), Joint::Inside(p) if at(p, 28.1436, 4.0)));
        let lens = [
            arc((-5.0, 0.0), (42.6667, 10.5462), (20.0, 0.0), false),
            arc((42.6667, 10.5462), (73.0, 0.0), (56.0, 0.0), false),
        ];
        assert!(matches!(made(&lens[0], &lens[1], 6.0), Joint::Inside(p) if at(p, 44.0, 19.6214)));
    }

    #[test]
    fn outside_corners_prolonged() {
        let (a, b) = (line((0.0, 0.0), (40.0, 0.0)), line((40.0, 0.0), (60.0, -34.6410)));
        assert_eq!(made(&a, &b, 5.0), Joint::Outside);
        let p = prolonged(&beside(&a, 5.0).unwrap(), &beside(&b, 5.0).unwrap()).unwrap();
        assert!(at(p, 42.8868, 5.0));
        let (a, b) = (line((0.0, 0.0), (30.0, 0.0)), arc((30.0, 0.0), (51.9904, 19.5), (39.0, 12.0), true));
        let (pa, pb) = (beside(&a, 4.0).unwrap(), beside(&b, 4.0).unwrap());
        let p = prolonged(&pa, &pb).unwrap();
        assert!(at(p, 31.4502, 4.0));
        let longer = prolonged_from(&pb, p);
        assert!(longer.length() > pb.length() && longer.length() < 2.0 * pb.length());
        let (a, b) =
            (arc((12.0, -16.0), (12.0, 16.0), (0.0, 0.0), true), arc((12.0, 16.0), (12.0, -16.0), (24.0, 0.0), true));
        let p = prolonged(&beside(&a, -5.0).unwrap(), &beside(&b, -5.0).unwrap()).unwrap();
        assert!(at(p, 12.0, 21.9317));
        let (a, b) = (
            arc((-5.0, 0.0), (42.6667, 10.5462), (20.0, 0.0), false),
            arc((42.6667, 10.5462), (73.0, 0.0), (56.0, 0.0), false),
        );
        assert_eq!(prolonged(&beside(&a, -6.0).unwrap(), &beside(&b, -6.0).unwrap()), None);
    }

    #[test]
    fn a_point_is_not_prolonged() {
        let hollow = arc((0.0, 0.0), (10.0, 0.0), (5.0, 0.0), true);
        let before = arc((-4.0, 3.0), (0.0, 0.0), (-4.0, -0.5), false);
        let (a, b) = (beside(&before, 5.0).unwrap(), beside(&hollow, 5.0).unwrap());
        assert_eq!((prolonged(&a, &b), prolonged(&b, &a)), (None, None));
    }

    #[test]
    fn reversals_are_outside_on_either_side() {
        let (a, b) = (line((0.0, 0.0), (40.0, 0.0)), line((40.0, 0.0), (0.0, 0.0)));
        assert_eq!(made(&a, &b, 5.0), Joint::Outside);
        assert_eq!(made(&a, &b, -5.0), Joint::Outside);
    }

    #[test]
    fn a_hollow_arc_of_the_radius_is_a_point() {
        let round = arc((32.0, 0.0), (40.0, 8.0), (32.0, 8.0), true);
        let point = beside(&round, 8.0).unwrap();
        assert_eq!(point.length(), 0.0);
        let before = line((0.0, 0.0), (32.0, 0.0));
        assert!(matches!(made(&before, &round, 8.0), Joint::Tangential(p) if at(p, 32.0, 8.0)));
        assert_eq!(beside(&round, 9.0), None);
        assert!(beside(&round, -9.0).is_some());
    }

    #[test]
    fn full_circles_keep_their_turn() {
        let circle = Element::Arc {
            from: Point2::new(50.0, 30.0),
            to: Point2::new(50.0, 30.0),
            center: Point2::new(30.0, 30.0),
            sweep: TAU,
        };
        let inner = beside(&circle, 5.0).unwrap();
        assert_eq!(inner.from(), Point2::new(45.0, 30.0));
        assert_eq!(up_to_point(&inner, inner.to()), inner);
        assert_eq!(from_point(&inner, inner.from()), inner);
    }

    #[test]
    fn a_joint_just_beyond_an_arc_does_not_turn_it_round() {
        // The source is rounded: the line leads 0.0001 rad away from the tangent.
        let long = arc((10.0, 0.0), (0.0, -10.0), (0.0, 0.0), true);
        let after = line((0.0, -10.0), (20.0, -10.002));
        for d in [5.0, -5.0] {
            let (a, b) = (beside(&long, d).unwrap(), beside(&after, d).unwrap());
            let Joint::Tangential(p) = made(&long, &after, d) else { panic!("a corner") };
            let made = up_to_point(&a, p);
            let Element::Arc { from, center, sweep, .. } = made else { panic!("a line") };
            assert!((sweep - 1.5 * PI).abs() < 1e-3, "{sweep}");
            assert!((distance(p, center) - distance(from, center)).abs() < 1e-9);
            assert!(way_to_end(&a, p).abs() < 1e-3 && from_point(&b, p).length() > 19.9);
        }
        let turns = Element::Arc {
            from: Point2::new(1.0, 0.0),
            to: Point2::new(1.0, 0.0),
            center: Point2::origin(),
            sweep: 2.0 * TAU,
        };
        let near = Point2::new(libm::cos(1e-4), libm::sin(1e-4));
        assert!((up_to_point(&turns, near).length() - 2.0 * TAU - 1e-4).abs() < 1e-7);
    }

    #[test]
    fn a_hollow_arc_as_large_as_the_tool_is_reached_only_along_its_tangents() {
        let hollow = arc((5.0, 0.0), (10.0, 5.0), (5.0, 5.0), true);
        let along = line((-20.0, 0.0), (5.0, 0.0));
        assert!(matches!(made(&along, &hollow, 5.0), Joint::Tangential(p) if at(p, 5.0, 5.0)));
        let turns = line((-20.0, 3.0), (5.0, 0.0));
        assert_eq!(made(&turns, &hollow, 5.0), Joint::NoRoom);
        let turns = arc((-3.0, 2.0), (5.0, 0.0), (1.0, 1.0), false);
        assert_eq!(made(&turns, &hollow, 5.0), Joint::NoRoom);
        // What rounding loses is no reason.
        let nearly = line((-20.0, 0.01), (5.0, 0.0));
        assert!(matches!(made(&nearly, &hollow, 5.0), Joint::Inside(p) if at(p, 5.0, 5.0)));
    }

    #[test]
    fn ways_along_an_arc_count_from_both_ends() {
        for sweep in [3.0, -3.0] {
            let center = Point2::new(2.0, 1.0);
            let on = |angle: f64| center + super::super::turned(Vec2::new(10.0, 0.0), angle);
            let arc = Element::Arc { from: on(0.0), to: on(sweep), center, sweep };
            // Up to half of what is left of the turn it lies behind the end, then in front of the start.
            for (part, from_start, to_end) in [
                (0.0, 0.0, 30.0),
                (1.0 / 3.0, 10.0, 20.0),
                (2.0 / 3.0, 20.0, 10.0),
                (1.0, 30.0, 0.0),
                (-0.1, -3.0, 33.0),
            ] {
                let p = on(sweep * part);
                assert!((way_from_start(&arc, p) - from_start).abs() < 1e-9, "{part} {sweep}");
                assert!((way_to_end(&arc, p) - to_end).abs() < 1e-9, "{part} {sweep}");
            }
        }
    }
}
