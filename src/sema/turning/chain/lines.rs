//! Lines with missing data.

use crate::geo::{Element, Point2, SAME_DIRECTION, SAME_POINT, Vec2, arc, corner, intersect, left};

use super::{AGREES, Fault, Partial, Result, Solved, backward_line, chosen, fixed_circle, leaning};

/// Completes a line.
pub(super) fn solve(
    e: &Partial,
    second: Option<&Partial>,
    third: Option<&Partial>,
    at: Point2,
    dir: Option<Vec2>,
) -> Result<Solved> {
    let (z, x) = (e.z.given(at.x), e.x.given(at.y));
    let Some(angle) = e.angle else {
        if let (Some(z), Some(x)) = (e.z.or_stay(at.x), e.x.or_stay(at.y)) {
            return Ok(Solved::line(at, Point2::new(z, x)));
        }
        return open_line(e, second, at, dir);
    };
    let u = leaning(angle);
    match (z, x) {
        (Some(z), Some(x)) => {
            let to = Point2::new(z, x);
            let off = crate::geo::cross(u, to - at).abs();
            if off > AGREES {
                return Err(Fault::Contradiction("the end point does not lie in the direction of the angle"));
            }
            Ok(Solved::line(at, to))
        }
        (Some(z), None) if u.x.abs() > SAME_DIRECTION => {
            Ok(Solved::line(at, Point2::new(z, at.y + (z - at.x) * (u.y / u.x))))
        }
        (None, Some(x)) if u.y.abs() > SAME_DIRECTION => {
            Ok(Solved::line(at, Point2::new(at.x + (x - at.y) * (u.x / u.y), x)))
        }
        (None, None) => ray(e, second, third, at, u),
        _ => Err(Fault::Impossible("a line at this angle never reaches the coordinate")),
    }
}

/// A line whose end is cut by the next element.
fn ray(e: &Partial, second: Option<&Partial>, third: Option<&Partial>, at: Point2, u: Vec2) -> Result<Solved> {
    let Some(next) = second else {
        return Err(Fault::Open("its end is not given, and no element follows that cuts it"));
    };
    if let Some((q, w)) = backward_line(next) {
        let Some((s, _)) = intersect::lines(at, u, q, w, SAME_DIRECTION) else {
            return Err(Fault::Impossible("it is parallel to the next line"));
        };
        return Ok(Solved::line(at, at + u * s));
    }
    if let Some((center, radius)) = fixed_circle(next) {
        let Some(points) = intersect::line_circle(at, u, center, radius, SAME_POINT) else {
            return Err(Fault::Impossible("it does not meet the next arc"));
        };
        return Ok(Solved::line(at, chosen(points, at, e.far)?));
    }
    if let (Some(ccw), Some(radius), Some(third)) = (next.arc, next.radius, third)
        && let Some((q, w)) = backward_line(third)
        && e.tangential
        && next.tangential
    {
        return Ok(Solved::line(at, fillet_start(at, u, q, w, radius, ccw)?));
    }
    Err(Fault::Open("its end is not given, and the next element does not fix it"))
}

/// Where the line from `at` along `u` goes over into an arc of `radius` that ends on the line through `q` along `w`.
fn fillet_start(at: Point2, u: Vec2, q: Point2, w: Vec2, radius: f64, ccw: bool) -> Result<Point2> {
    let Some((s, _)) = intersect::lines(at, u, q, w, SAME_DIRECTION) else {
        return Err(Fault::Impossible("the lines before and behind the arc are parallel"));
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
fn open_line(e: &Partial, second: Option<&Partial>, at: Point2, dir: Option<Vec2>) -> Result<Solved> {
    let (z, x) = (e.z.given(at.x), e.x.given(at.y));
    if let Some(u) = dir {
        match (z, x) {
            (Some(z), None) if u.x.abs() > SAME_DIRECTION => {
                return Ok(Solved::line(at, Point2::new(z, at.y + (z - at.x) * (u.y / u.x))));
            }
            (None, Some(x)) if u.y.abs() > SAME_DIRECTION => {
                return Ok(Solved::line(at, Point2::new(at.x + (x - at.y) * (u.x / u.y), x)));
            }
            _ => {}
        }
    }
    let Some(next) = second else { return Err(Fault::Open("its end is not given")) };
    if z.is_none()
        && x.is_none()
        && e.tangential
        && let (Some(ccw), Some((center, radius))) = (next.arc, fixed_circle(next))
    {
        let touch = tangent_point(at, center, radius, ccw, true)?;
        return Ok(Solved::line(at, touch));
    }
    Err(Fault::Open("its end is not given, and the next element does not fix it"))
}

/// Where a line through `p` touches a circle so that it runs on in the sense of the arc. `into`: from `p` to the
/// circle, else from the circle to `p`.
pub(super) fn tangent_point(p: Point2, center: Point2, radius: f64, ccw: bool, into: bool) -> Result<Point2> {
    let v = p - center;
    let d = crate::geo::length(v);
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
