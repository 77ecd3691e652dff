//! Where two elements meet: a point lies on both carriers, and on every line and circle that data says of it.

use crate::geo::{Point2, SAME_POINT, Vec2, cross, distance, intersect, left};

use super::state::{Fact, Known, View};
use super::{AGREES, Base, Made, ONE};

/// Elements of known extent that a joint looks past.
const MOST_RIGID: usize = 8;

/// Lines at a smaller angle run beside each other: where they meet is what arithmetic loses. In rad.
const ALONG: f64 = 1e-6;

/// Where a point can lie.
#[derive(Debug, Clone, Copy)]
pub(super) enum Locus {
    Point(Point2),
    /// A line; from the point on only where it is a ray.
    Line(Point2, Vec2, bool),
    Circle(Point2, f64),
}

impl Locus {
    fn shifted(self, by: Vec2) -> Locus {
        match self {
            Locus::Point(at) => Locus::Point(at + by),
            Locus::Line(at, u, ray) => Locus::Line(at + by, u, ray),
            Locus::Circle(center, radius) => Locus::Circle(center + by, radius),
        }
    }

    /// How far the point lies from it.
    pub fn miss(&self, p: Point2) -> f64 {
        match *self {
            Locus::Point(at) => distance(at, p),
            Locus::Line(at, u, true) if (p - at).dot(&u) < 0.0 => distance(at, p),
            Locus::Line(at, u, _) => cross(u, p - at).abs(),
            Locus::Circle(center, radius) => (distance(center, p) - radius).abs(),
        }
    }
}

/// The end of an element.
pub(super) fn end(view: &View<'_>, node: usize) -> Made {
    if view.end(node).is_some() {
        return Ok(Vec::new());
    }
    let loci = loci(view, node);
    if let Some(Locus::Point(at)) = loci.iter().find(|locus| matches!(locus, Locus::Point(_))) {
        return Ok(vec![Fact::End(*at)]);
    }
    for (i, a) in loci.iter().enumerate() {
        for b in &loci[i + 1..] {
            if let Some(points) = meet(a, b)? {
                let mut found: Vec<Point2> = Vec::new();
                for p in points {
                    if !found.iter().any(|old| distance(*old, p) <= ONE) {
                        found.push(p);
                    }
                }
                let misses = |p: &Point2| loci.iter().map(|locus| locus.miss(*p)).fold(0.0, f64::max);
                let least = found.iter().map(misses).fold(f64::INFINITY, f64::min);
                found.retain(|p| misses(p) <= AGREES);
                if found.is_empty() {
                    return Err(("its end cannot meet all of its data", Some(least)));
                }
                return Ok(found.into_iter().map(Fact::End).collect());
            }
        }
    }
    Ok(Vec::new())
}

/// All that is known of the end of an element, also past neighbours of known extent.
fn loci(view: &View<'_>, node: usize) -> Vec<Locus> {
    let mut list = Vec::new();
    own(view, node, true, &mut list);
    next(view, node, true, &mut list);
    // What is known of the next joints counts here, where the way to them is known.
    let (mut way, mut at) = (Vec2::zeros(), node);
    for _ in 0..MOST_RIGID {
        let Some((behind, _)) = view.next(at) else { break };
        let Some(by) = extent(view, behind) else { break };
        (way, at) = (way + by, behind);
        let from = list.len();
        match view.end(at) {
            Some(end) => list.push(Locus::Point(end)),
            None => {
                own(view, at, false, &mut list);
                next(view, at, true, &mut list);
            }
        }
        list[from..].iter_mut().for_each(|locus| *locus = locus.shifted(-way));
    }
    let (mut way, mut at) = (Vec2::zeros(), node);
    for _ in 0..MOST_RIGID {
        let Some(by) = extent(view, at) else { break };
        way += by;
        let from = list.len();
        match view.start(at) {
            Some(start) => list.push(Locus::Point(start)),
            None => {
                own(view, at - 1, true, &mut list);
                next(view, at - 1, false, &mut list);
            }
        }
        list[from..].iter_mut().for_each(|locus| *locus = locus.shifted(way));
        if at == 0 || view.start(at).is_some() {
            break;
        }
        at -= 1;
    }
    list
}

/// The way from start to end, where it is known although the element is not.
fn extent(view: &View<'_>, node: usize) -> Option<Vec2> {
    let of = view.node(node);
    if view.is_line(node) {
        return Some(of.entry? * view.item(node).length?);
    }
    Some((left(of.entry?) - left(of.exit?)) * of.rho?)
}

/// What the element itself says of its end. `carrier`: also that it lies on its line or circle.
fn own(view: &View<'_>, node: usize, carrier: bool, list: &mut Vec<Locus>) {
    written(&view.known_end(node), view.item(node).pole, list);
    let of = view.node(node);
    if let (Some(length), Some(start)) = (view.item(node).length, view.start(node)) {
        match of.entry.filter(|_| view.is_line(node)) {
            Some(u) => list.push(Locus::Point(start + u * length)),
            None => list.push(Locus::Circle(start, length)),
        }
    }
    if let (Some((center, rho)), Some(exit)) = (view.circle(node), of.exit) {
        list.push(Locus::Point(center - left(exit) * rho));
    }
    if let Some(at) = touching(view, node) {
        list.push(Locus::Point(at));
    } else if carrier {
        carrier_of(view, node, list);
    }
}

/// What the element behind says of it.
fn next(view: &View<'_>, node: usize, carrier: bool, list: &mut Vec<Locus>) {
    let Some((next, item)) = view.next(node) else { return };
    let of = view.node(next);
    if let (Some((center, rho)), Some(entry)) = (view.circle(next), of.entry) {
        list.push(Locus::Point(center - left(entry) * rho));
    }
    if carrier && !item.smooth {
        carrier_of(view, next, list);
    }
    let Some(end) = view.end(next) else { return };
    if let Some(length) = item.length {
        match of.entry.filter(|_| view.is_line(next)) {
            Some(u) => list.push(Locus::Point(end - u * length)),
            None => list.push(Locus::Circle(end, length)),
        }
    }
    let from_start = |given: Option<super::Given>| given.filter(|given| given.from == Base::Start);
    if let Some(given) = from_start(item.end.x) {
        list.push(Locus::Line(Point2::new(end.x - given.value, 0.0), Vec2::y(), false));
    }
    if let Some(given) = from_start(item.end.y) {
        list.push(Locus::Line(Point2::new(0.0, end.y - given.value), Vec2::x(), false));
    }
}

/// The lines and circles that coordinates make.
pub(super) fn written(known: &Known, pole: Point2, list: &mut Vec<Locus>) {
    if let (Some(x), Some(y)) = (known.x, known.y) {
        list.push(Locus::Point(Point2::new(x, y)));
    }
    if let (Some(radius), Some(ray)) = (known.radius, known.ray) {
        list.push(Locus::Point(pole + ray * radius));
    }
    if let Some(x) = known.x {
        list.push(Locus::Line(Point2::new(x, 0.0), Vec2::y(), false));
    }
    if let Some(y) = known.y {
        list.push(Locus::Line(Point2::new(0.0, y), Vec2::x(), false));
    }
    if let Some(radius) = known.radius {
        list.push(Locus::Circle(pole, radius.abs()));
    }
    if let Some(ray) = known.ray {
        list.push(Locus::Line(pole, ray, true));
    }
}

fn carrier_of(view: &View<'_>, node: usize, list: &mut Vec<Locus>) {
    if let Some((on, u)) = view.line(node) {
        list.push(Locus::Line(on, u, false));
    }
    if let Some((center, rho)) = view.circle(node) {
        list.push(Locus::Circle(center, rho.abs()));
    }
}

/// Where an element goes over into the next one without a corner.
fn touching(view: &View<'_>, node: usize) -> Option<Point2> {
    let next = view.smooth_next(node)?;
    let foot = |(center, rho): (Point2, f64), u: Vec2| center - left(u) * rho;
    match (view.circle(node), view.circle(next)) {
        (Some((a, ra)), Some((b, rb))) if (rb - ra).abs() > SAME_POINT => Some(a - (b - a) * (ra / (rb - ra))),
        (Some(circle), None) => view.line(next).map(|(_, u)| foot(circle, u)),
        (None, Some(circle)) => view.line(node).map(|(_, u)| foot(circle, u)),
        _ => None,
    }
}

/// Linear conditions that the start (true) or end of an element has to meet, but for those of its own carrier.
pub(super) fn border(view: &View<'_>, node: usize, at_start: bool) -> Vec<Locus> {
    let mut list = Vec::new();
    if at_start {
        match node.checked_sub(1) {
            Some(before) => own(view, before, true, &mut list),
            None => list.push(Locus::Point(view.window.at)),
        }
    } else {
        written(&view.known_end(node), view.item(node).pole, &mut list);
        next(view, node, true, &mut list);
    }
    list
}

/// Points of both; nothing where they run beside each other.
///
/// An error says that they miss each other.
fn meet(a: &Locus, b: &Locus) -> Result<Option<Vec<Point2>>, (&'static str, Option<f64>)> {
    let missed = |text, miss: f64| Err((text, Some(miss)));
    Ok(match (*a, *b) {
        (Locus::Point(_), _) | (_, Locus::Point(_)) => None,
        (Locus::Line(p, u, _), Locus::Line(q, w, _)) => {
            intersect::lines(p, u, q, w, ALONG).map(|(s, _)| vec![p + u * s])
        }
        (Locus::Line(p, u, _), Locus::Circle(center, radius))
        | (Locus::Circle(center, radius), Locus::Line(p, u, _)) => {
            match intersect::line_circle(p, u, center, radius, AGREES) {
                Some(points) => Some(points.into()),
                None => {
                    return missed(
                        "the line and the circle that its end lies on do not meet",
                        cross(u, center - p).abs() - radius,
                    );
                }
            }
        }
        (Locus::Circle(c, r), Locus::Circle(d, s)) => {
            let apart = distance(c, d);
            if apart <= AGREES {
                return Ok(None);
            }
            match intersect::circles(c, r, d, s, AGREES / 2.0) {
                Some(points) => Some(points.into()),
                None => {
                    return missed(
                        "the circles that its end lies on do not meet",
                        (apart - r - s).max((r - s).abs() - apart),
                    );
                }
            }
        }
    })
}
