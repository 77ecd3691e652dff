//! Arcs with missing data.

use crate::geo::arc::{self, TangentArc};
use crate::geo::{Point2, SAME_POINT, Vec2, direction, distance, intersect, left};

use super::lines::tangent_point;
use super::{AGREES, Fault, Partial, Result, Solved, backward_line, chosen, fixed_circle, leaning};

/// Completes an arc.
pub(super) fn solve(e: &Partial, second: Option<&Partial>, ccw: bool, at: Point2, dir: Option<Vec2>) -> Result<Solved> {
    if let (Some(z), Some(x)) = (e.z.or_stay(at.x), e.x.or_stay(at.y)) {
        return closed_arc(e, ccw, at, Point2::new(z, x), dir);
    }
    let center = open_center(e, ccw, at, dir)?;
    let radius = distance(center, at);
    let (z, x) = (e.z.or_stay(at.x), e.x.or_stay(at.y));
    let to = match (z, x) {
        (Some(z), None) => on_circle(Point2::new(z, at.y), Vec2::y(), center, radius, at, e.far)?,
        (None, Some(x)) => on_circle(Point2::new(at.x, x), Vec2::x(), center, radius, at, e.far)?,
        _ => arc_end(e, second, ccw, at, center, radius)?,
    };
    Ok(Solved { from: at, to, arc: Some((center, ccw)) })
}

fn on_circle(p: Point2, u: Vec2, center: Point2, radius: f64, at: Point2, far: bool) -> Result<Point2> {
    match intersect::line_circle(p, u, center, radius, SAME_POINT) {
        Some(points) => chosen(points, at, far),
        None => Err(Fault::Impossible("the circle does not reach the coordinate")),
    }
}

/// Centre of an arc whose end is not given.
fn open_center(e: &Partial, ccw: bool, at: Point2, dir: Option<Vec2>) -> Result<Point2> {
    let base = if e.center.absolute { Point2::origin() } else { at };
    if let (Some(z), Some(x)) = (e.center.z, e.center.x) {
        let center = base + Vec2::new(z, x);
        let r = distance(center, at);
        if r <= SAME_POINT {
            return Err(Fault::Impossible("its centre is its start"));
        }
        if e.radius.is_some_and(|radius| (radius.abs() - r).abs() > e.tolerance) {
            return Err(Fault::Contradiction("R is not the distance of the centre from the start"));
        }
        return Ok(center);
    }
    match (e.radius, dir) {
        (Some(radius), Some(u)) if radius > 0.0 => Ok(at + left(u) * if ccw { radius } else { -radius }),
        _ => Err(Fault::Open("neither its end nor its centre is known")),
    }
}

/// Where an arc about a known centre goes over into the next element.
fn arc_end(
    e: &Partial,
    second: Option<&Partial>,
    ccw: bool,
    at: Point2,
    center: Point2,
    radius: f64,
) -> Result<Point2> {
    let Some(next) = second else {
        return Err(Fault::Open("its end is not given, and no element follows that fixes it"));
    };
    if let Some((q, w)) = backward_line(next) {
        // A tangential line misses the circle by what the drawing rounds.
        let tol = if e.tangential { AGREES } else { SAME_POINT };
        return on_circle_near(q, w, center, radius, at, e.far, tol);
    }
    if let (None, Some(angle), true) = (next.arc, next.angle, e.tangential) {
        return end_by_direction(next, leaning(angle), ccw, center, radius, at, e.far);
    }
    let end = next.z.absolute().zip(next.x.absolute()).map(|(z, x)| Point2::new(z, x));
    match (next.arc, end) {
        (None, Some(end)) if next.angle.is_none() && e.tangential => tangent_point(end, center, radius, ccw, false),
        (Some(_), _) if fixed_circle(next).is_some() => {
            let Some((other, r)) = fixed_circle(next) else { return Err(Fault::Open("its end is not given")) };
            match intersect::circles(center, radius, other, r, SAME_POINT) {
                Some(points) => chosen(points, at, e.far),
                None => Err(Fault::Impossible("it does not meet the next arc")),
            }
        }
        (Some(sense), Some(end)) if e.tangential => match next.radius {
            Some(r) if r > 0.0 => touching(center, radius, end, r, ccw == sense, at, e.far),
            _ => Err(Fault::Open("its end is not given, and the next arc has no radius")),
        },
        _ => Err(Fault::Open("its end is not given, and the next element does not fix it")),
    }
}

fn on_circle_near(p: Point2, u: Vec2, center: Point2, radius: f64, at: Point2, far: bool, tol: f64) -> Result<Point2> {
    let Some([a, b]) = intersect::line_circle(p, u, center, radius, tol) else {
        return Err(Fault::Impossible("it does not meet the next line"));
    };
    // A line that only touches gives its foot, which may lie off the circle.
    let point = chosen([a, b], at, far)?;
    match direction(point - center, SAME_POINT) {
        Some(out) => Ok(center + out * radius),
        None => Err(Fault::Impossible("it does not meet the next line")),
    }
}

/// Where a circle goes over into a line along `u`, or against it, whose end has one coordinate: that tells which way it runs.
fn end_by_direction(
    next: &Partial,
    u: Vec2,
    ccw: bool,
    center: Point2,
    radius: f64,
    at: Point2,
    far: bool,
) -> Result<Point2> {
    // The radius to the end is the direction of travel turned by a right angle.
    let foot = |way: Vec2| center + left(way) * if ccw { -radius } else { radius };
    let reaches = |way: &Vec2| {
        let from = foot(*way);
        let along = |goal: Option<f64>, start: f64, slope: f64| goal.is_none_or(|goal| (goal - start) * slope > 0.0);
        along(next.z.given(from.x), from.x, way.x) && along(next.x.given(from.y), from.y, way.y)
    };
    if next.z.given(0.0).is_none() && next.x.given(0.0).is_none() {
        return Err(Fault::Open("its end is not given, and the line behind it has an angle and no end"));
    }
    match [u, -u].into_iter().filter(reaches).map(foot).collect::<Vec<_>>()[..] {
        [] => Err(Fault::Impossible("no line at the angle of the next element leaves it towards that end")),
        [end] => Ok(end),
        [a, b, ..] => chosen([a, b], at, far),
    }
}

/// Where a circle goes over into an arc of radius `r` that ends in `end`.
fn touching(c: Point2, radius: f64, end: Point2, r: f64, same_sense: bool, at: Point2, far: bool) -> Result<Point2> {
    let apart = if same_sense { (radius - r).abs() } else { radius + r };
    let none = Fault::Impossible("no arc of this radius goes from it to its end");
    let Some(centers) = intersect::circles(c, apart, end, r, SAME_POINT) else { return Err(none) };
    let sign = if same_sense && r > radius { -1.0 } else { 1.0 };
    let touch = |other: Point2| direction(other - c, SAME_POINT).map(|u| c + u * (sign * radius));
    match (touch(centers[0]), touch(centers[1])) {
        (Some(a), Some(b)) => chosen([a, b], at, far),
        _ => Err(none),
    }
}

/// An arc whose end is given.
fn closed_arc(e: &Partial, ccw: bool, at: Point2, to: Point2, dir: Option<Vec2>) -> Result<Solved> {
    let base = if e.center.absolute { Point2::origin() } else { at };
    let (cz, cx) = (e.center.z.map(|z| base.x + z), e.center.x.map(|x| base.y + x));
    let same = distance(at, to) <= SAME_POINT;
    let center = match (cz, cx, e.radius) {
        (Some(z), Some(x), radius) => {
            let center = Point2::new(z, x);
            if radius.is_some_and(|radius| (radius.abs() - distance(center, at)).abs() > e.tolerance) {
                return Err(Fault::Contradiction("R is not the distance of the centre from the start"));
            }
            center
        }
        _ if same => return Err(Fault::Impossible("it ends where it starts, and its centre is not given")),
        (None, None, Some(radius)) => match arc::center_by_radius(at, to, radius, ccw, SAME_POINT, e.tolerance) {
            Some(center) => center,
            None => return Err(Fault::Impossible("its radius is too small for the distance of its ends")),
        },
        (None, None, None) => return tangential(ccw, at, to, dir),
        (z, x, None) => between(at, to, z, x)?,
        (_, _, Some(_)) => return Err(Fault::Contradiction("R and I or K cannot stand together")),
    };
    Ok(Solved { from: at, to, arc: Some((center, ccw)) })
}

/// The centre of which one coordinate is known, as far from both ends.
fn between(at: Point2, to: Point2, z: Option<f64>, x: Option<f64>) -> Result<Point2> {
    let open = Fault::Open("one coordinate of its centre is missing and does not follow from its ends");
    let v = to - at;
    let middle = at + v / 2.0;
    // (C - M)·v = 0
    match (z, x) {
        (Some(z), None) if v.y.abs() > SAME_POINT => Ok(Point2::new(z, middle.y - (z - middle.x) * v.x / v.y)),
        (None, Some(x)) if v.x.abs() > SAME_POINT => Ok(Point2::new(middle.x - (x - middle.y) * v.y / v.x, x)),
        _ => Err(open),
    }
}

fn tangential(ccw: bool, at: Point2, to: Point2, dir: Option<Vec2>) -> Result<Solved> {
    let Some(u) = dir else {
        return Err(Fault::Open("neither its centre nor its radius is given, and it is tangential to nothing"));
    };
    match arc::tangent_arc(at, u, to, SAME_POINT, SAME_POINT) {
        TangentArc::Arc { center, ccw: sense } if sense == ccw => Ok(Solved { from: at, to, arc: Some((center, ccw)) }),
        TangentArc::Arc { .. } => Err(Fault::Contradiction("the tangential arc to its end turns the other way")),
        _ => Err(Fault::Impossible("its end lies straight ahead or behind")),
    }
}
