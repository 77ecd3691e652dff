//! Arcs with missing data.

use crate::geo::arc::{self, TangentArc};
use crate::geo::{Point2, SAME_POINT, Vec2, direction, distance, intersect, left, length, turned};

use super::{
    Data, Entry, Fault, NOT_FIXED, RADIUS_DIFFERS, Result, Rules, Situation, Solution, Solutions, Solved, Start,
    TOO_MUCH, Tag, both,
};

/// Points, each with the choice that leads to it.
type Points = [(Point2, Option<Tag>); 2];

/// Completes an arc: its centre first, then its end.
pub(super) fn solve(start: &Start, e: &Data, ccw: bool, next: Option<&Data>, rules: &Rules) -> Result<Solutions> {
    let at = start.at;
    let coords = (e.x.or_stay(at.x), e.y.or_stay(at.y));
    let end = coords.0.zip(coords.1).map(|(x, y)| Point2::new(x, y));
    let centers = center(start, e, ccw, end, rules)?;
    let mut list: [Option<Solution>; 4] = [None; 4];
    let mut fault = None;
    let count = if centers[0].0 == centers[1].0 { 1 } else { 2 };
    for (i, (center, by)) in centers.iter().take(count).enumerate() {
        let ends = match end {
            Some(end) => Ok([(end, None); 2]),
            None => open_end(e, next, ccw, at, *center, coords, rules),
        };
        match ends {
            Ok([first, second]) => {
                let made = |(to, tag): (Point2, Option<Tag>)| {
                    let solved = Solved { from: at, to, arc: Some((*center, ccw)) };
                    Some(Solution { solved, tags: [*by, tag] })
                };
                list[2 * i] = made(first);
                list[2 * i + 1] = if first.1.is_some() { made(second) } else { None };
            }
            Err(why) => fault = fault.or(Some(why)),
        }
    }
    Solutions::of(list.into_iter().flatten()).ok_or(fault.unwrap_or(NOT_FIXED))
}

fn sure(point: Point2) -> Points {
    [(point, None); 2]
}

fn center(start: &Start, e: &Data, ccw: bool, end: Option<Point2>, rules: &Rules) -> Result<Points> {
    let at = start.at;
    let base = if e.center.absolute { Point2::origin() } else { at };
    let (cx, cy) = (e.center.x.map(|x| base.x + x), e.center.y.map(|y| base.y + y));
    let radius_differs =
        |center| e.radius.is_some_and(|radius| (radius.abs() - distance(center, at)).abs() > e.tolerance);
    if let (Some(x), Some(y)) = (cx, cy) {
        let center = Point2::new(x, y);
        if end.is_none() && distance(center, at) <= SAME_POINT {
            return Err(Fault::Impossible("its centre is its start"));
        }
        if rules.agrees.is_finite() && radius_differs(center) {
            return Err(RADIUS_DIFFERS);
        }
        return Ok(sure(center));
    }
    let beside_start = |u: Vec2, radius: f64| sure(at + left(u) * if ccw { radius } else { -radius });
    if let (Some(u), Some(radius)) = (e.along(start.dir), e.radius) {
        return Ok(beside_start(u, radius));
    }
    let Some(to) = end else {
        let on = start.dir.filter(|_| start.goes_on);
        return match (e.radius, on, cx.or(cy)) {
            (Some(radius), Some(u), _) if radius > 0.0 => Ok(beside_start(u, radius)),
            (Some(radius), None, Some(_)) if rules.one_coordinate => beside(at, cx, cy, radius, rules)
                .map(|centers| both(Situation::CenterByStart, centers))
                .ok_or(Fault::Impossible("its radius does not reach the coordinate of its centre")),
            _ => Err(Fault::Open("neither its end nor its centre is known")),
        };
    };
    if let Some(u) = e.along(start.dir) {
        return tangential(ccw, at, to, u);
    }
    match (cx.or(cy), e.radius) {
        (Some(_), Some(radius)) if rules.one_coordinate => by_end(e, at, to, (cx, cy), radius, rules),
        _ if distance(at, to) <= SAME_POINT => {
            Err(Fault::Impossible("it ends where it starts, and its centre is not given"))
        }
        (Some(_), Some(_)) => Err(TOO_MUCH),
        (Some(_), None) => between(at, to, cx, cy).map(sure),
        (None, Some(radius)) => {
            let center = arc::center_by_radius(at, to, radius, ccw, SAME_POINT, rules.chord.unwrap_or(e.tolerance))
                .ok_or(Fault::Impossible("its radius is too small for the distance of its ends"))?;
            let tag = Tag { situation: Situation::ShorterArc, second: radius < 0.0, apart: 0.0 };
            Ok([(center, Some(tag)); 2])
        }
        (None, None) => match start.dir.filter(|_| start.goes_on) {
            Some(u) => tangential(ccw, at, to, u),
            None => Err(Fault::Open("neither its centre nor its radius is given, and it is tangential to nothing")),
        },
    }
}

/// Both centres of an arc that ends in `to`; the start leaves one of them, as a rule.
fn by_end(
    e: &Data,
    at: Point2,
    to: Point2,
    (cx, cy): (Option<f64>, Option<f64>),
    radius: f64,
    rules: &Rules,
) -> Result<Points> {
    let centers = beside(to, cx, cy, radius, rules)
        .ok_or(Fault::Impossible("its radius does not reach the coordinate of its centre"))?;
    let fits = centers.map(|center| (distance(at, center) - radius).abs() < e.tolerance);
    Ok(match fits {
        [true, false] => sure(centers[0]),
        [false, true] => sure(centers[1]),
        _ => both(Situation::CenterByEnd, centers),
    })
}

/// The centres of circles through a point of which one coordinate of the centre is known: the greater other one first.
pub(super) fn beside(p: Point2, cx: Option<f64>, cy: Option<f64>, radius: f64, rules: &Rules) -> Option<[Point2; 2]> {
    match (cx, cy) {
        (Some(x), None) => {
            half_chord(radius, x - p.x, rules).map(|h| [Point2::new(x, p.y + h), Point2::new(x, p.y - h)])
        }
        (None, Some(y)) => {
            half_chord(radius, y - p.y, rules).map(|h| [Point2::new(p.x + h, y), Point2::new(p.x - h, y)])
        }
        _ => None,
    }
}

/// The points of a circle with this coordinate: the greater other one first.
pub(super) fn at_coordinate(
    center: Point2,
    radius: f64,
    x: Option<f64>,
    y: Option<f64>,
    rules: &Rules,
) -> Option<[Point2; 2]> {
    let (c, r) = (center, radius);
    match (x, y) {
        (Some(x), _) => half_chord(r, x - c.x, rules).map(|h| [Point2::new(x, c.y + h), Point2::new(x, c.y - h)]),
        (None, Some(y)) => half_chord(r, y - c.y, rules).map(|h| [Point2::new(c.x + h, y), Point2::new(c.x - h, y)]),
        (None, None) => None,
    }
}

/// Half of the chord that lies `off` from the centre.
fn half_chord(radius: f64, off: f64, rules: &Rules) -> Option<f64> {
    (off.abs() <= radius.abs() + (rules.reach)(radius.abs())).then(|| (radius * radius - off * off).max(0.0).sqrt())
}

/// The centre of which one coordinate is known, as far from both ends.
fn between(at: Point2, to: Point2, x: Option<f64>, y: Option<f64>) -> Result<Point2> {
    let v = to - at;
    let middle = at + v / 2.0;
    // (C - M)·v = 0
    match (x, y) {
        (Some(x), None) if v.y.abs() > SAME_POINT => Ok(Point2::new(x, middle.y - (x - middle.x) * v.x / v.y)),
        (None, Some(y)) if v.x.abs() > SAME_POINT => Ok(Point2::new(middle.x - (y - middle.y) * v.y / v.x, y)),
        _ => Err(Fault::Open("one coordinate of its centre is missing and does not follow from its ends")),
    }
}

fn tangential(ccw: bool, at: Point2, to: Point2, u: Vec2) -> Result<Points> {
    match arc::tangent_arc(at, u, to, SAME_POINT, SAME_POINT) {
        TangentArc::Arc { center, ccw: sense } if sense == ccw => Ok(sure(center)),
        TangentArc::Arc { .. } => Err(Fault::Contradiction("the tangential arc to its end turns the other way")),
        _ => Err(Fault::Impossible("its end lies straight ahead or behind")),
    }
}

/// The end of an arc about a known centre.
fn open_end(
    e: &Data,
    next: Option<&Data>,
    ccw: bool,
    at: Point2,
    center: Point2,
    (x, y): (Option<f64>, Option<f64>),
    rules: &Rules,
) -> Result<Points> {
    let radius = distance(center, at);
    if let Some(sweep) = e.sweep {
        return Ok(sure(center + turned(at - center, if ccw { sweep } else { -sweep })));
    }
    if let Some(u) = e.exit {
        return Ok(sure(leaving(center, radius, ccw, u)));
    }
    if x.is_some() || y.is_some() {
        let points = at_coordinate(center, radius, x, y, rules)
            .ok_or(Fault::Impossible("the circle does not reach the coordinate"))?;
        return Ok(both(if x.is_some() { Situation::EndAtX } else { Situation::EndAtY }, points));
    }
    let Some(next) = next else {
        return Err(Fault::Open("its end is not given, and no element follows that fixes it"));
    };
    match next.arc {
        None => end_on_line(e, next, ccw, at, center, radius, rules),
        Some(_) if rules.leaves_along => Err(NOT_FIXED),
        Some(sense) => end_on_arc(e, next, ccw == sense, center, radius, rules),
    }
}

/// Where a circle is left in the direction `u`: the radius there is that direction turned by a right angle.
fn leaving(center: Point2, radius: f64, ccw: bool, u: Vec2) -> Point2 {
    center + left(u) * if ccw { -radius } else { radius }
}

/// Where an arc about a known centre goes over into a line.
fn end_on_line(
    e: &Data,
    next: &Data,
    ccw: bool,
    at: Point2,
    center: Point2,
    radius: f64,
    rules: &Rules,
) -> Result<Points> {
    if let (Some(Entry::Along(u)), true) = (next.entry, rules.leaves_along) {
        return Ok(sure(leaving(center, radius, ccw, u)));
    }
    if let Some((q, w)) = next.fixed_line(at, None) {
        // A tangential line misses the circle by what the drawing rounds.
        let tol = if e.smooth { rules.smooth_touch } else { rules.touch };
        let miss = Fault::Impossible("it does not meet the next line");
        let [a, b] = intersect::line_circle(q, w, center, radius, tol).ok_or(miss)?;
        // A line that only touches gives its foot, which may lie off the circle.
        let on = |p: Point2| direction(p - center, SAME_POINT).map(|out| center + out * radius);
        let points = on(a).zip(on(b)).ok_or(miss)?;
        return Ok(both(Situation::LineAndCircle, points.into()));
    }
    if let (Some(Entry::Parallel(u)), true) = (next.entry, e.smooth) {
        return end_by_direction(next, u, ccw, center, radius);
    }
    match next.absolute_end() {
        Some(end) if next.entry.is_none() && e.smooth => tangent_point(end, center, radius, ccw, false).map(sure),
        _ => Err(NOT_FIXED),
    }
}

/// Where an arc about a known centre goes over into another one.
fn end_on_arc(e: &Data, next: &Data, same_sense: bool, center: Point2, radius: f64, rules: &Rules) -> Result<Points> {
    if let Some((other, r)) = next.fixed_circle(rules) {
        let points = intersect::circles(center, radius, other, r, SAME_POINT)
            .ok_or(Fault::Impossible("it does not meet the next arc"))?;
        return Ok(both(Situation::TwoCircles, points));
    }
    match (next.absolute_end(), next.radius) {
        (Some(end), Some(r)) if e.smooth && r > 0.0 => touching(center, radius, end, r, same_sense),
        (Some(_), _) if e.smooth => Err(Fault::Open("its end is not given, and the next arc has no radius")),
        _ => Err(NOT_FIXED),
    }
}

/// Where a circle goes over into a line along `u`, or against it, whose end has one coordinate: that tells which way it runs.
fn end_by_direction(next: &Data, u: Vec2, ccw: bool, center: Point2, radius: f64) -> Result<Points> {
    let foot = |way: Vec2| leaving(center, radius, ccw, way);
    let reaches = |way: Vec2| {
        let from = foot(way);
        let along = |goal: Option<f64>, start: f64, slope: f64| goal.is_none_or(|goal| (goal - start) * slope > 0.0);
        along(next.x.given(from.x), from.x, way.x) && along(next.y.given(from.y), from.y, way.y)
    };
    if next.x.given(0.0).is_none() && next.y.given(0.0).is_none() {
        return Err(Fault::Open("its end is not given, and the line after it has an angle and no end"));
    }
    match (reaches(u), reaches(-u)) {
        (false, false) => Err(Fault::Impossible("no line at the angle of the next element leaves it towards that end")),
        (true, false) => Ok(sure(foot(u))),
        (false, true) => Ok(sure(foot(-u))),
        (true, true) => Ok(both(Situation::EitherWay, [foot(u), foot(-u)])),
    }
}

/// Where a circle goes over into an arc of radius `r` that ends in `end`.
fn touching(c: Point2, radius: f64, end: Point2, r: f64, same_sense: bool) -> Result<Points> {
    let apart = if same_sense { (radius - r).abs() } else { radius + r };
    let none = Fault::Impossible("no arc of this radius goes from it to its end");
    let centers = intersect::circles(c, apart, end, r, SAME_POINT).ok_or(none)?;
    let sign = if same_sense && r > radius { -1.0 } else { 1.0 };
    let touch = |other: Point2| direction(other - c, SAME_POINT).map(|u| c + u * (sign * radius));
    match (touch(centers[0]), touch(centers[1])) {
        (Some(a), Some(b)) => Ok(both(Situation::TwoCircles, [a, b])),
        _ => Err(none),
    }
}

/// Where a line through `p` touches a circle so that it runs on in the sense of the arc. `into`: from `p` to the
/// circle, else from the circle to `p`.
pub(super) fn tangent_point(p: Point2, center: Point2, radius: f64, ccw: bool, into: bool) -> Result<Point2> {
    let v = p - center;
    let d = length(v);
    if d <= radius + SAME_POINT {
        return Err(Fault::Impossible("no line from this point touches the arc"));
    }
    // The radius to the touching point leans towards `p` by acos(r / d).
    let along = v / d * (radius * radius / d);
    let aside = left(v) / d * (radius * (d * d - radius * radius).sqrt() / d);
    let travel = |touch: Point2| if into { touch - p } else { p - touch };
    [center + along + aside, center + along - aside]
        .into_iter()
        .find(|touch| arc::tangent_at(*touch, center, ccw).is_some_and(|t| t.dot(&travel(*touch)) > 0.0))
        .ok_or(Fault::Impossible("no line from this point touches the arc"))
}
