//! Path elements with missing data: each is completed from its start, its own words and up to two elements behind it.
//!
//! Points are (Z, X) with X as a radius. A line stands at `angle` to the negative Z axis: it leaves its start along
//! (-cos A, sin A) or the other way. Source: reference sections 5 and 6.2, "Solving unknowns".

use crate::geo::arc::{self, TangentArc};
use crate::geo::corner;
use crate::geo::{Deg, Element, Point2, SAME_DIRECTION, SAME_POINT, Vec2, direction, distance, intersect, left};

/// How far data that says the same twice may disagree, in mm: drawings round to 0.01 and less.
pub(super) const AGREES: f64 = 0.02;
/// Elements that may wait for each other.
const MOST: usize = 3;

/// A coordinate as programmed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Coord {
    /// Not written: stays as it is, unless an angle says where it goes.
    #[default]
    Missing,
    /// `?`
    Unknown,
    At(f64),
    By(f64),
}

impl Coord {
    fn given(self, from: f64) -> Option<f64> {
        match self {
            Coord::At(v) => Some(v),
            Coord::By(d) => Some(from + d),
            Coord::Missing | Coord::Unknown => None,
        }
    }

    fn or_stay(self, from: f64) -> Option<f64> {
        if self == Coord::Missing { Some(from) } else { self.given(from) }
    }

    fn absolute(self) -> Option<f64> {
        if let Coord::At(v) = self { Some(v) } else { None }
    }
}

/// Centre of an arc as programmed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Center {
    pub z: Option<f64>,
    pub x: Option<f64>,
    /// Counts from the workpiece zero, not from the start of the arc.
    pub absolute: bool,
}

/// An element as programmed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Partial {
    /// Counter-clockwise; `None` for a line.
    pub arc: Option<bool>,
    pub z: Coord,
    pub x: Coord,
    pub angle: Option<f64>,
    pub radius: Option<f64>,
    pub center: Center,
    /// The solution that lies further from the start.
    pub far: bool,
    /// Goes over into the next element without a corner, where that is not known otherwise.
    pub tangential: bool,
}

/// A complete element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Solved {
    pub from: Point2,
    pub to: Point2,
    /// Centre and counter-clockwise.
    pub arc: Option<(Point2, bool)>,
}

impl Solved {
    fn line(from: Point2, to: Point2) -> Solved {
        Solved { from, to, arc: None }
    }

    pub fn element(&self) -> Element {
        let (from, to) = (self.from, self.to);
        match self.arc {
            None => Element::Line { from, to },
            Some((center, ccw)) => Element::Arc { from, to, center, sweep: self.sweep(center, ccw) },
        }
    }

    fn sweep(&self, center: Point2, ccw: bool) -> f64 {
        if distance(self.from, self.to) <= SAME_POINT {
            return if ccw { core::f64::consts::TAU } else { -core::f64::consts::TAU };
        }
        arc::sweep(self.from, self.to, center, ccw)
    }

    /// Direction of travel at the end; `None` for an element of no length.
    pub fn end_direction(&self) -> Option<Vec2> {
        match self.arc {
            None => direction(self.to - self.from, SAME_POINT),
            Some((center, ccw)) => arc::tangent_at(self.to, center, ccw),
        }
    }
}

/// Why an element cannot be completed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Fault {
    /// Data is missing.
    Open(&'static str),
    /// No such geometry exists.
    Impossible(&'static str),
    /// Data disagrees.
    Contradiction(&'static str),
}

type Result<T> = core::result::Result<T, Fault>;

/// Elements that wait for each other, each with what else is known of its block.
#[derive(Debug)]
pub(super) struct Chain<T> {
    queue: Vec<(Partial, T)>,
}

impl<T> Default for Chain<T> {
    fn default() -> Chain<T> {
        Chain { queue: Vec::new() }
    }
}

impl<T> Chain<T> {
    pub fn is_empty(&self) -> bool {
        self.queue.is_empty()
    }

    pub fn clear(&mut self) {
        self.queue.clear();
    }

    pub fn push(&mut self, partial: Partial, tag: T) {
        self.queue.push((partial, tag));
    }

    /// The first element, if it can be completed by now. It starts in `at`; `dir` is the direction to continue in,
    /// if there is one. `closed`: nothing more will come.
    ///
    /// # Errors
    /// The fault, and the element it is about.
    pub fn next(
        &mut self,
        at: Point2,
        dir: Option<Vec2>,
        closed: bool,
    ) -> core::result::Result<Option<(Solved, T)>, (Fault, T)> {
        let Some((first, _)) = self.queue.first() else { return Ok(None) };
        let second = self.queue.get(1).map(|(partial, _)| partial);
        let third = self.queue.get(2).map(|(partial, _)| partial);
        let result = solve(first, second, third, at, dir);
        if let Err(Fault::Open(_)) = result
            && !closed
            && self.queue.len() < MOST
        {
            return Ok(None);
        }
        let (_, tag) = self.queue.remove(0);
        match result {
            Ok(solved) => Ok(Some((solved, tag))),
            Err(fault) => Err((fault, tag)),
        }
    }
}

/// Completes `e` from its start and the elements behind it.
fn solve(
    e: &Partial,
    second: Option<&Partial>,
    third: Option<&Partial>,
    at: Point2,
    dir: Option<Vec2>,
) -> Result<Solved> {
    match e.arc {
        None => line(e, second, third, at, dir),
        Some(ccw) => solve_arc(e, second, ccw, at, dir),
    }
}

/// Direction of a line at `angle` to the negative Z axis.
fn leaning(angle: f64) -> Vec2 {
    let (sin, cos) = Deg(angle).sin_cos();
    Vec2::new(-cos, sin)
}

fn line(
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
fn tangent_point(p: Point2, center: Point2, radius: f64, ccw: bool, into: bool) -> Result<Point2> {
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

/// Of two solutions the one nearer to `from`, or the further one.
fn chosen(points: [Point2; 2], from: Point2, far: bool) -> Result<Point2> {
    let [a, b] = points;
    // The start itself is no solution.
    match (distance(a, from) <= SAME_POINT, distance(b, from) <= SAME_POINT) {
        (true, true) => Err(Fault::Impossible("it ends where it starts")),
        (true, false) => Ok(b),
        (false, true) => Ok(a),
        (false, false) => {
            let (near, other) = (distance(a, from), distance(b, from));
            if (near - other).abs() <= SAME_POINT && distance(a, b) > AGREES {
                return Err(Fault::Open("two solutions lie equally far from its start, so Q tells nothing"));
            }
            Ok(if (near <= other) == far { b } else { a })
        }
    }
}

/// A line that is known without its start: through its end at its angle.
fn backward_line(e: &Partial) -> Option<(Point2, Vec2)> {
    let end = Point2::new(e.z.absolute()?, e.x.absolute()?);
    (e.arc.is_none()).then_some(())?;
    Some((end, leaning(e.angle?)))
}

/// Centre and radius of an arc that are known without its start.
fn fixed_circle(e: &Partial) -> Option<(Point2, f64)> {
    e.arc?;
    let center = Some(e.center).filter(|c| c.absolute)?;
    let center = Point2::new(center.z?, center.x?);
    let radius = match (e.radius, e.z.absolute(), e.x.absolute()) {
        (Some(radius), _, _) => radius.abs(),
        (None, Some(z), Some(x)) => distance(center, Point2::new(z, x)),
        _ => return None,
    };
    Some((center, radius))
}

fn solve_arc(e: &Partial, second: Option<&Partial>, ccw: bool, at: Point2, dir: Option<Vec2>) -> Result<Solved> {
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
        if e.radius.is_some_and(|radius| (radius.abs() - r).abs() > AGREES) {
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
            if radius.is_some_and(|radius| (radius.abs() - distance(center, at)).abs() > AGREES) {
                return Err(Fault::Contradiction("R is not the distance of the centre from the start"));
            }
            center
        }
        _ if same => return Err(Fault::Impossible("it ends where it starts, and its centre is not given")),
        (None, None, Some(radius)) => match arc::center_by_radius(at, to, radius, ccw, SAME_POINT, AGREES) {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, z: f64) -> Point2 {
        Point2::new(z, x / 2.0)
    }

    fn run(start: Point2, elements: &[Partial]) -> Vec<Point2> {
        let mut chain = Chain::default();
        for e in elements {
            chain.push(*e, ());
        }
        let (mut at, mut dir, mut ends) = (start, None, Vec::new());
        while !chain.is_empty() {
            let (solved, ()) = chain.next(at, dir, true).unwrap().unwrap();
            at = solved.to;
            dir = solved.end_direction();
            ends.push(at);
        }
        ends
    }

    fn near(a: Point2, b: Point2) {
        assert!(distance(a, b) < 1e-4, "{a:?} {b:?}");
    }

    fn line_to(x: f64, z: f64) -> Partial {
        Partial { x: Coord::At(x / 2.0), z: Coord::At(z), tangential: true, ..Partial::default() }
    }

    #[test]
    fn a_line_by_angle() {
        // Worked example 10: from X20 Z-12, Z-24 A20 reaches X28.7353.
        let e = Partial { z: Coord::At(-24.0), angle: Some(20.0), ..Partial::default() };
        near(run(p(20.0, -12.0), &[e])[0], p(28.7353, -24.0));
        // X100 A80 from X90 leans towards -Z.
        let e = Partial { x: Coord::At(50.0), angle: Some(80.0), ..Partial::default() };
        near(run(p(90.0, -12.0), &[e])[0], p(100.0, -12.8816));
    }

    #[test]
    fn two_lines_by_their_angles() {
        let first = Partial { angle: Some(0.0), ..Partial::default() };
        let second = Partial { angle: Some(45.0), ..line_to(60.0, -50.0) };
        near(run(p(20.0, 0.0), &[first, second])[0], p(20.0, -30.0));
    }

    #[test]
    fn a_line_cut_by_a_circle_near_and_far() {
        // Circle about X0 Z-50 with radius 25; the line X30 cuts it at Z-30 and Z-70.
        let arc = Partial {
            arc: Some(true),
            radius: Some(25.0),
            center: Center { z: Some(-50.0), x: Some(0.0), absolute: true },
            ..line_to(50.0, -50.0)
        };
        let ray = |far| Partial { angle: Some(0.0), far, ..Partial::default() };
        near(run(p(30.0, 0.0), &[ray(false), arc])[0], p(30.0, -30.0));
        near(run(p(30.0, 0.0), &[ray(true), arc])[0], p(30.0, -70.0));
    }

    #[test]
    fn a_fillet_between_two_lines() {
        // Corner at X20 Z-30, radius 5 into the shoulder: Z-25, then X30 Z-30.
        let ray = Partial { angle: Some(0.0), tangential: true, ..Partial::default() };
        let arc = Partial {
            arc: Some(false),
            x: Coord::Unknown,
            z: Coord::Unknown,
            radius: Some(5.0),
            tangential: true,
            ..Partial::default()
        };
        let wall = Partial { angle: Some(90.0), ..line_to(60.0, -30.0) };
        let ends = run(p(20.0, 0.0), &[ray, arc, wall]);
        near(ends[0], p(20.0, -25.0));
        near(ends[1], p(30.0, -30.0));
    }

    #[test]
    fn arcs_of_the_640_manual_go_over_into_each_other() {
        // `G12 X? Z? R15` behind a known direction, `G13 X25 Z-30 R30` behind it.
        let first = Partial {
            arc: Some(false),
            x: Coord::Unknown,
            z: Coord::Unknown,
            radius: Some(15.0),
            tangential: true,
            ..Partial::default()
        };
        let second = Partial { arc: Some(true), radius: Some(30.0), ..line_to(80.0, -40.0) };
        let solved = {
            let mut chain = Chain::default();
            chain.push(first, ());
            chain.push(second, ());
            let one = chain.next(p(40.0, 0.0), Some(Vec2::new(-1.0, 0.0)), true).unwrap().unwrap().0;
            let two = chain.next(one.to, one.end_direction(), true).unwrap().unwrap().0;
            [one, two]
        };
        let (c, _) = solved[1].arc.unwrap();
        let start = arc::tangent_at(solved[1].from, c, true).unwrap();
        assert!((start - solved[0].end_direction().unwrap()).norm() < 1e-9, "{solved:?}");
    }

    #[test]
    fn a_missing_centre_coordinate_follows_from_the_end() {
        // `G3 X20 Z-41.6241 I-14.5` from Z-23.8759: radius 17.
        let e = Partial {
            arc: Some(true),
            center: Center { x: Some(-14.5), ..Center::default() },
            ..line_to(20.0, -41.6241)
        };
        let mut chain = Chain::default();
        chain.push(e, ());
        let (c, _) = chain.next(p(20.0, -23.8759), None, true).unwrap().unwrap().0.arc.unwrap();
        assert!((distance(c, p(20.0, -23.8759)) - 17.0).abs() < 1e-4);
    }
}
