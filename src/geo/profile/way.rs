//! Ways along an outline: legs that are lines or arcs.

use crate::geo::{Element, Point2, SAME_POINT, arc, cross, distance, length};

use super::piece::{Curve, Piece, SAME_CURVE};

/// Legs shorter than this are left out, mm.
const SHORTEST_LEG: f64 = 2e-7;

/// Arcs with a shorter chord are lines, mm.
const SHORTEST_ARC: f64 = 1.5 * arc::NEARLY_ONE_POINT;

/// A leg of a way along the outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Leg {
    Line { to: Point2 },
    Arc { to: Point2, center: Point2, ccw: bool },
}

impl Leg {
    pub fn to(&self) -> Point2 {
        match *self {
            Leg::Line { to } | Leg::Arc { to, .. } => to,
        }
    }
}

/// Legs under way.
pub(super) struct Way {
    pub(super) at: Point2,
    /// Start of the leg that was made last.
    from: Point2,
    pub(super) legs: Vec<Leg>,
    /// The circle of the last leg, to go on along it.
    circle: Option<(Point2, bool)>,
}

impl Way {
    pub(super) fn new(start: Point2) -> Way {
        Way { at: start, from: start, legs: Vec::new(), circle: None }
    }

    pub(super) fn line(&mut self, to: Point2) {
        if distance(self.at, to) <= SHORTEST_LEG {
            return;
        }
        // A line that goes straight on is one leg.
        let straight = matches!(self.legs.last(), Some(Leg::Line { .. })) && {
            let (a, b) = (self.at - self.from, to - self.at);
            cross(a, b).abs() <= SAME_CURVE * length(a).max(length(b)).max(1.0) && a.dot(&b) > 0.0
        };
        if straight {
            self.legs.pop();
        } else {
            self.from = self.at;
        }
        self.legs.push(Leg::Line { to });
        self.at = to;
        self.circle = None;
    }

    /// On a piece, from where the way stands to a point of it.
    pub(super) fn along(&mut self, piece: &Piece, to: Point2) {
        let Curve::Circle { center, upper, .. } = piece.curve else { return self.line(to) };
        if distance(self.at, to) <= SHORTEST_LEG {
            return;
        }
        if self.circle.is_some_and(|circle| piece.same_circle(circle)) {
            self.legs.pop();
        } else {
            self.from = self.at;
        }
        // A short arc on the outside becomes its tangents, one on the inside its chord: both leave material.
        if distance(self.from, to) > SHORTEST_ARC {
            self.legs.push(Leg::Arc { to, center, ccw: !upper });
            self.circle = Some((center, upper));
        } else {
            let (a, b) = (self.from - center, to - center);
            let (square, reach) = (a.dot(&a), a.dot(&a) + a.dot(&b));
            if upper && distance(self.from, to) > SAME_POINT && reach > square / 2.0 {
                self.legs.push(Leg::Line { to: center + (a + b) * (square / reach) });
            }
            self.legs.push(Leg::Line { to });
            self.circle = None;
        }
        self.at = to;
    }

    pub(super) fn done(self) -> Vec<Leg> {
        self.legs
    }
}

/// The elements of a way.
pub fn elements(start: Point2, legs: &[Leg]) -> Vec<Element> {
    let starts = std::iter::once(start).chain(legs.iter().map(Leg::to));
    let element = |(from, leg): (Point2, &Leg)| match *leg {
        Leg::Line { to } => Element::Line { from, to },
        Leg::Arc { to, center, ccw } => Element::Arc { from, to, center, sweep: arc::sweep(from, to, center, ccw) },
    };
    starts.zip(legs).map(element).collect()
}

/// A way run through backwards, from its end.
pub fn backwards(start: Point2, legs: &[Leg]) -> Vec<Leg> {
    let ends = std::iter::once(start).chain(legs.iter().map(Leg::to)).take(legs.len());
    let mut back: Vec<Leg> = legs
        .iter()
        .zip(ends)
        .map(|(leg, to)| match *leg {
            Leg::Line { .. } => Leg::Line { to },
            Leg::Arc { center, ccw, .. } => Leg::Arc { to, center, ccw: !ccw },
        })
        .collect();
    back.reverse();
    back
}

/// A way seen from behind: `x` changes its sign.
pub fn mirrored(legs: &[Leg]) -> Vec<Leg> {
    let mirror = |p: Point2| Point2::new(-p.x, p.y);
    let leg = |leg: &Leg| match *leg {
        Leg::Line { to } => Leg::Line { to: mirror(to) },
        Leg::Arc { to, center, ccw } => Leg::Arc { to: mirror(to), center: mirror(center), ccw: !ccw },
    };
    legs.iter().map(leg).collect()
}
