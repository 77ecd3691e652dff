//! What rings lie on: lines and circles that are computed from the walls alone.
//!
//! The crate that traces the rings takes its angles from the platform. Only which walls follow each other is taken from it; every
//! coordinate is computed here, so that the same contour gives the same bytes everywhere.

use crate::geo::{Element, Point2, Vec2, arc, cross, direction, distance, intersect, left};

use super::walls::{Walls, point_at};

/// How far a traced element may lie beside what it lies on, mm.
const BESIDE: f64 = 1e-5;
/// Lines and circles that miss each other by less touch, mm.
const TOUCH: f64 = 1e-6;
/// How far a traced point may lie from where it belongs, mm: where lines and circles touch it is hardly known.
const NEAR: f64 = 2e-2;
/// Traced elements that are shorter are passed over, mm.
const SHORT: f64 = 2e-4;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Carrier {
    Line { at: Point2, along: Vec2 },
    Circle { center: Point2, radius: f64 },
}

/// The ring that was traced at a distance from the walls, with the points where its carriers meet. `None` where what was traced does not
/// belong to the walls.
pub fn settled(traced: &[Element], asked: f64, walls: &Walls) -> Option<Vec<Element>> {
    let parts: Vec<(Carrier, Element)> = traced
        .iter()
        .filter(|element| element.length() > SHORT)
        .map(|element| Some((Carrier::of(element, asked, walls)?, *element)))
        .collect::<Option<_>>()?;
    let (first, last) = (parts.first()?, parts.last()?);
    if parts.iter().all(|(carrier, _)| *carrier == first.0) {
        let Carrier::Circle { center, radius } = first.0 else { return None };
        let Element::Arc { sweep, .. } = first.1 else { return None };
        let from = Point2::new(center.x + radius, center.y);
        return Some(vec![Element::Arc { from, to: from, center, sweep: core::f64::consts::TAU.copysign(sweep) }]);
    }
    // Elements on one carrier are one; the ring begins where two carriers meet.
    let begins = if first.0 == last.0 { parts.iter().position(|(carrier, _)| *carrier != first.0)? } else { 0 };
    let mut runs: Vec<(Carrier, Element)> = Vec::with_capacity(parts.len());
    for (carrier, element) in parts.iter().cycle().skip(begins).take(parts.len()) {
        match runs.last_mut() {
            Some((known, run)) if known == carrier => *run = joined(run, element),
            _ => runs.push((*carrier, *element)),
        }
    }
    let count = runs.len();
    let meets: Vec<Point2> =
        (0..count).map(|i| runs[i].0.meets(&runs[(i + 1) % count].0, runs[i].1.to())).collect::<Option<_>>()?;
    (0..count).map(|i| runs[i].0.between(meets[(i + count - 1) % count], meets[i], &runs[i].1)).collect()
}

/// Both on one carrier, one after the other.
fn joined(first: &Element, next: &Element) -> Element {
    match (*first, *next) {
        (Element::Arc { from, center, sweep, .. }, Element::Arc { to, sweep: more, .. }) => {
            Element::Arc { from, to, center, sweep: sweep + more }
        }
        _ => Element::Line { from: first.from(), to: next.to() },
    }
}

impl Carrier {
    /// The first wall, or end of one, beside which the element lies.
    fn of(element: &Element, asked: f64, walls: &Walls) -> Option<Carrier> {
        let points = [0.0, 0.5, 1.0].map(|part| point_at(element, part));
        let fits = |carrier: &Carrier| points.iter().all(|p| carrier.distance(*p) <= BESIDE);
        let round = matches!(element, Element::Arc { .. });
        let found =
            walls.elements().iter().find_map(|wall| Carrier::beside(wall, points[1], asked, round).filter(&fits));
        found.or_else(|| {
            let corners = walls.elements().iter().map(|wall| Carrier::Circle { center: wall.from(), radius: asked });
            corners.filter(|_| round).find(fits)
        })
    }

    /// What lies beside a wall, on the side of `p`.
    fn beside(wall: &Element, p: Point2, asked: f64, round: bool) -> Option<Carrier> {
        match *wall {
            Element::Line { from, to } if !round => {
                let along = direction(to - from, 0.0)?;
                let side = if cross(along, p - from) < 0.0 { -asked } else { asked };
                Some(Carrier::Line { at: from + left(along) * side, along })
            }
            Element::Arc { from, center, .. } if round => {
                let wall = distance(from, center);
                let radius = if distance(p, center) < wall { wall - asked } else { wall + asked };
                (radius > 0.0).then_some(Carrier::Circle { center, radius })
            }
            Element::Line { .. } | Element::Arc { .. } => None,
        }
    }

    fn distance(&self, p: Point2) -> f64 {
        match *self {
            Carrier::Line { at, along } => cross(along, p - at).abs(),
            Carrier::Circle { center, radius } => (distance(p, center) - radius).abs(),
        }
    }

    /// Where two of them meet, next to `p`.
    fn meets(&self, other: &Carrier, p: Point2) -> Option<Point2> {
        let found = match (*self, *other) {
            (Carrier::Line { at: a, along: u }, Carrier::Line { at: b, along: w }) => {
                intersect::lines(a, u, b, w, 1e-9).map(|(s, _)| a + u * s)
            }
            (Carrier::Line { at, along }, Carrier::Circle { center, radius })
            | (Carrier::Circle { center, radius }, Carrier::Line { at, along }) => {
                let foot = at + along * (center - at).dot(&along);
                let off = distance(foot, center) - radius;
                if off.abs() <= TOUCH {
                    Some(foot)
                } else {
                    intersect::line_circle(at, along, center, radius, BESIDE).map(|both| nearest(both, p))
                }
            }
            (Carrier::Circle { center: a, radius: ra }, Carrier::Circle { center: b, radius: rb }) => {
                let between = distance(a, b);
                let inner = (ra - rb).abs() - between;
                if (between - ra - rb).abs() <= TOUCH || inner.abs() <= TOUCH {
                    let outwards = inner.abs() <= TOUCH && ra < rb;
                    direction(b - a, 1e-9).map(|unit| a + unit * if outwards { -ra } else { ra })
                } else {
                    intersect::circles(a, ra, b, rb, BESIDE).map(|both| nearest(both, p))
                }
            }
        };
        found.filter(|found| distance(*found, p) <= NEAR)
    }

    /// The part of it from `from` to `to`, in the sense of what was traced.
    fn between(&self, from: Point2, to: Point2, traced: &Element) -> Option<Element> {
        let made = match (*self, *traced) {
            (Carrier::Circle { center, .. }, Element::Arc { sweep, .. }) => {
                Element::Arc { from, to, center, sweep: arc::sweep(from, to, center, sweep > 0.0) }
            }
            _ => Element::Line { from, to },
        };
        let turned = match (made, *traced) {
            (Element::Line { from, to }, Element::Line { from: a, to: b }) => (to - from).dot(&(b - a)) <= 0.0,
            _ => false,
        };
        ((made.length() - traced.length()).abs() <= 2.0 * NEAR && !turned).then_some(made)
    }
}

fn nearest([a, b]: [Point2; 2], p: Point2) -> Point2 {
    if distance(a, p) <= distance(b, p) { a } else { b }
}
