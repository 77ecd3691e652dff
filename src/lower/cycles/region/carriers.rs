//! What rings lie on: lines and circles that are computed from the walls alone.
//!
//! The crate that traces the rings takes its angles from the platform. Only which walls follow each other is taken from it; every
//! coordinate is computed here, so that the same contour gives the same bytes everywhere.

use crate::geo::{Element, Point2, Vec2, arc, cross, direction, distance, intersect, left};

use super::walls::{Walls, point_at};

/// How far a traced element may lie beside what it lies on, mm.
const BESIDE: f64 = 1e-5;
/// What arithmetic loses of it, mm.
const EXACTLY: f64 = 1e-7;
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
    let mut runs: Vec<Run> = Vec::with_capacity(parts.len());
    for (carrier, element) in parts.iter().cycle().skip(begins).take(parts.len()) {
        match runs.last_mut() {
            Some(run) if run.on == *carrier => run.goes_on(element),
            _ => runs.push(Run::new(*carrier, element)),
        }
    }
    let count = runs.len();
    let meets: Vec<Point2> = (0..count)
        .map(|i| {
            let (on, next, p) = (&runs[i].on, &runs[(i + 1) % count].on, runs[i].to);
            on.meets(next, p).or_else(|| on.passes_into(next, p, asked, walls))
        })
        .collect::<Option<_>>()?;
    (0..count).map(|i| runs[i].between(meets[(i + count - 1) % count], meets[i])).collect()
}

/// Traced elements on one carrier, one after the other. Each of them may have a centre of its own next to that of the carrier.
struct Run {
    on: Carrier,
    from: Point2,
    to: Point2,
    length: f64,
    /// Of the longest of its elements.
    is_ccw: bool,
    longest: f64,
}

impl Run {
    fn new(on: Carrier, element: &Element) -> Run {
        let mut run =
            Run { on, from: element.from(), to: element.to(), length: 0.0, is_ccw: false, longest: f64::NEG_INFINITY };
        run.goes_on(element);
        run
    }

    fn goes_on(&mut self, element: &Element) {
        let length = element.length();
        self.to = element.to();
        self.length += length;
        if length > self.longest {
            self.longest = length;
            self.is_ccw = matches!(element, Element::Arc { sweep, .. } if *sweep > 0.0);
        }
    }

    /// The part of the carrier from `from` to `to`; `None` where it is not what was traced.
    fn between(&self, from: Point2, to: Point2) -> Option<Element> {
        let (made, turned) = match self.on {
            Carrier::Circle { center, .. } => {
                (Element::Arc { from, to, center, sweep: arc::sweep(from, to, center, self.is_ccw) }, false)
            }
            Carrier::Line { .. } => (Element::Line { from, to }, (to - from).dot(&(self.to - self.from)) <= 0.0),
        };
        ((made.length() - self.length).abs() <= 2.0 * NEAR && !turned).then_some(made)
    }
}

impl Carrier {
    /// The first wall, or else end of one, beside which the element lies: exactly, or nearly.
    fn of(element: &Element, asked: f64, walls: &Walls) -> Option<Carrier> {
        let points = [0.0, 0.5, 1.0].map(|part| point_at(element, part));
        let round = matches!(element, Element::Arc { .. });
        let found = |beside: f64| {
            let fits = |carrier: &Carrier| points.iter().all(|p| carrier.distance(*p) <= beside);
            let wall = |wall| Carrier::beside(wall, points[1], asked, round).filter(&fits);
            let corner = |wall: &Element| Carrier::Circle { center: wall.from(), radius: asked };
            let corners = || walls.elements().iter().map(corner).filter(|_| round).find(fits);
            walls.elements().iter().find_map(wall).or_else(corners)
        };
        found(EXACTLY).or_else(|| found(BESIDE))
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

    /// Where both run on into each other beside a corner of the walls that hardly turns: drawings round tangential joints. Where they
    /// meet is not known there, and of no account.
    fn passes_into(&self, next: &Carrier, p: Point2, asked: f64, walls: &Walls) -> Option<Point2> {
        let corners = walls.elements().iter().map(Element::from);
        let feet =
            corners.filter(|corner| (distance(*corner, p) - asked).abs() <= BESIDE).map(|corner| self.foot(corner));
        feet.flatten().find(|foot| distance(*foot, p) <= NEAR && next.distance(*foot) <= TOUCH)
    }

    /// The point of it next to `p`.
    fn foot(&self, p: Point2) -> Option<Point2> {
        match *self {
            Carrier::Line { at, along } => Some(at + along * (p - at).dot(&along)),
            Carrier::Circle { center, radius } => direction(p - center, 1e-9).map(|unit| center + unit * radius),
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
}

fn nearest([a, b]: [Point2; 2], p: Point2) -> Point2 {
    if distance(a, p) <= distance(b, p) { a } else { b }
}
