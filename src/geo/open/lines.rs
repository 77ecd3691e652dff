//! Lines with missing data.

use crate::geo::{Element, Point2, SAME_DIRECTION, SAME_POINT, Vec2, corner, cross, distance, intersect, left};

use super::arcs::{at_coordinate, tangent_point};
use super::{
    Data, Entry, Fault, NEVER, NOT_FIXED, PARALLEL, Result, Rules, Situation, Solution, Solutions, Solved, Start, both,
};

/// Completes a line.
pub(super) fn solve(start: &Start, e: &Data, following: [Option<&Data>; 2], rules: &Rules) -> Result<Solutions> {
    let at = start.at;
    let (x, y) = (e.x.given(at.x), e.y.given(at.y));
    let Some(u) = e.along(start.dir) else {
        if let (Some(x), Some(y)) = (e.x.or_stay(at.x), e.y.or_stay(at.y)) {
            return Ok(to(at, Point2::new(x, y)));
        }
        return without_direction(start, e, following[0], rules);
    };
    match (x, y) {
        (Some(x), Some(y)) if cross(u, Point2::new(x, y) - at).abs() > rules.agrees => {
            Err(Fault::Contradiction("the end point does not lie in the direction of the angle"))
        }
        (Some(x), Some(y)) => Ok(to(at, Point2::new(x, y))),
        (None, None) => ray(at, u, e, following, rules),
        _ => match up_to(at, u, x, y) {
            Some(end) => Ok(to(at, end)),
            // The coordinate stays along the whole line.
            None if rules.one_coordinate => ray(at, u, e, following, rules),
            None => Err(NEVER),
        },
    }
}

fn to(at: Point2, end: Point2) -> Solutions {
    Solutions::one(Solved::line(at, end))
}

/// Where the line from `at` along `u`, or against it, has the one coordinate that is given.
fn up_to(at: Point2, u: Vec2, x: Option<f64>, y: Option<f64>) -> Option<Point2> {
    match (x, y) {
        (Some(x), None) if u.x.abs() > SAME_DIRECTION => Some(Point2::new(x, at.y + (x - at.x) * (u.y / u.x))),
        (None, Some(y)) if u.y.abs() > SAME_DIRECTION => Some(Point2::new(at.x + (y - at.y) * (u.x / u.y), y)),
        _ => None,
    }
}

/// A line whose end is cut by the next element.
fn ray(at: Point2, u: Vec2, e: &Data, [next, third]: [Option<&Data>; 2], rules: &Rules) -> Result<Solutions> {
    let Some(next) = next else {
        return Err(Fault::Open("its end is not given, and no element follows that cuts it"));
    };
    if let Some((q, w)) = next.fixed_line(at, Some(u)) {
        let (s, _) = intersect::lines(at, u, q, w, SAME_DIRECTION).ok_or(PARALLEL)?;
        return Ok(to(at, at + u * s));
    }
    if let (Some(ccw), Some(radius), Some(Entry::Turned(0.0))) = (next.arc, next.radius, next.entry) {
        return beside_centre(at, u, next, ccw, radius);
    }
    if let Some((centers, radius)) = next.fixed_circles(rules) {
        let hits = |(center, tag)| {
            let points = intersect::line_circle(at, u, center, radius, rules.touch)?;
            Some(
                both(Situation::LineAndCircle, points)
                    .map(|(p, hit)| Solution { solved: Solved::line(at, p), tags: [tag, hit] }),
            )
        };
        let centers = if centers[0].1.is_some() { &centers[..] } else { &centers[..1] };
        return Solutions::of(centers.iter().copied().filter_map(hits).flatten())
            .ok_or(Fault::Impossible("it does not meet the next arc"));
    }
    if let (Some(ccw), Some(radius), Some(third)) = (next.arc, next.radius, third)
        && let Some((q, w)) = third.fixed_line(at, None)
        && e.smooth
        && next.smooth
    {
        return Ok(to(at, fillet_start(at, u, q, w, radius, ccw)?));
    }
    Err(NOT_FIXED)
}

/// The next arc goes on along the line: its centre lies beside it, and a coordinate of the centre says where.
fn beside_centre(at: Point2, u: Vec2, next: &Data, ccw: bool, radius: f64) -> Result<Solutions> {
    let beside = at + left(u) * if ccw { radius } else { -radius };
    let along = match (next.center.x, next.center.y) {
        (Some(x), _) if u.x.abs() > SAME_DIRECTION => (x - beside.x) / u.x,
        (_, Some(y)) if u.y.abs() > SAME_DIRECTION => (y - beside.y) / u.y,
        _ => return Err(NOT_FIXED),
    };
    Ok(to(at, at + u * along))
}

/// Where the line from `at` along `u` goes over into an arc of `radius` that ends on the line through `q` along `w`.
fn fillet_start(at: Point2, u: Vec2, q: Point2, w: Vec2, radius: f64, ccw: bool) -> Result<Point2> {
    let Some((s, _)) = intersect::lines(at, u, q, w, SAME_DIRECTION) else {
        return Err(Fault::Impossible("the lines before and after the arc are parallel"));
    };
    let meet = at + u * s;
    let before = Element::Line { from: at, to: meet };
    let after = Element::Line { from: meet, to: q };
    let Ok(cut) = corner::rounding(&before, &after, radius, SAME_POINT) else {
        return Err(Fault::Impossible("the arc does not fit between the lines"));
    };
    match cut.arc {
        Some((_, sense)) if sense == ccw => Ok(cut.leave),
        _ => Err(Fault::Contradiction("the arc between the lines turns the other way")),
    }
}

/// A line without an angle whose end is not known.
fn without_direction(start: &Start, e: &Data, next: Option<&Data>, rules: &Rules) -> Result<Solutions> {
    let at = start.at;
    let (x, y) = (e.x.given(at.x), e.y.given(at.y));
    if let Some(end) = start.dir.filter(|_| start.goes_on).and_then(|u| up_to(at, u, x, y)) {
        return Ok(to(at, end));
    }
    let Some(next) = next else { return Err(Fault::Open("its end is not given")) };
    let Some((center, radius)) = next.fixed_circle(rules) else { return Err(NOT_FIXED) };
    match (x, y, next.arc) {
        (None, None, Some(ccw)) if e.smooth => Ok(to(at, tangent_point(at, center, radius, ccw, true)?)),
        _ if x.is_none() && y.is_none() || !rules.one_coordinate => Err(NOT_FIXED),
        _ => {
            // The end of the arc is nearer to what was drawn than its radius.
            let radius = next.absolute_end().map_or(radius, |end| distance(end, center));
            let [more, less] = at_coordinate(center, radius, x, y, rules)
                .ok_or(Fault::Impossible("the next arc does not reach the coordinate"))?;
            let situation = if x.is_some() { Situation::LineToX } else { Situation::LineToY };
            let ends = both(situation, [less, more]);
            let solutions = ends.map(|(p, tag)| Solution { solved: Solved::line(at, p), tags: [tag, None] });
            Solutions::of(solutions.into_iter()).ok_or(NOT_FIXED)
        }
    }
}
