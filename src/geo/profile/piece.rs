//! Pieces of an outline: lines and halves of circles over some width.

use crate::geo::{Point2, Vec2, direction, distance, intersect};

/// Curves closer than this are one, mm.
pub(super) const SAME_CURVE: f64 = 1e-9;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Curve {
    Line,
    /// The upper or the lower half of a circle.
    Circle {
        center: Point2,
        radius: f64,
        upper: bool,
    },
}

/// A part of the outline over some width; it runs one way in height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub(super) from: Point2,
    pub(super) to: Point2,
    pub(super) curve: Curve,
    pub(super) source: usize,
}

impl Piece {
    pub(super) fn y(&self, x: f64) -> f64 {
        if x <= self.from.x {
            return self.from.y;
        }
        if x >= self.to.x {
            return self.to.y;
        }
        match self.curve {
            Curve::Line => self.from.y + (self.to.y - self.from.y) * ((x - self.from.x) / (self.to.x - self.from.x)),
            Curve::Circle { center, radius, upper } => {
                let off = x - center.x;
                let high = (radius * radius - off * off).max(0.0).sqrt();
                center.y + if upper { high } else { -high }
            }
        }
    }

    /// Where it reaches a height between those of its ends.
    pub(super) fn x(&self, y: f64) -> f64 {
        let place = match self.curve {
            Curve::Line if self.from.y == self.to.y => self.from.x,
            Curve::Line => self.from.x + (self.to.x - self.from.x) * ((y - self.from.y) / (self.to.y - self.from.y)),
            Curve::Circle { center, radius, .. } => {
                let off = y - center.y;
                let wide = (radius * radius - off * off).max(0.0).sqrt();
                let right = (self.from.x + self.to.x) / 2.0 > center.x;
                center.x + if right { wide } else { -wide }
            }
        };
        place.clamp(self.from.x, self.to.x)
    }

    pub(super) fn part(&self, from: f64, to: f64) -> Piece {
        let at = |x: f64| Point2::new(x.clamp(self.from.x, self.to.x), self.y(x));
        Piece { from: at(from), to: at(to), ..*self }
    }

    pub(super) fn moved(&self, by: Vec2, source: usize) -> Piece {
        let curve = match self.curve {
            Curve::Line => Curve::Line,
            Curve::Circle { center, radius, upper } => Curve::Circle { center: center + by, radius, upper },
        };
        Piece { from: self.from + by, to: self.to + by, curve, source }
    }

    pub(super) fn mirrored(&self) -> Piece {
        let mirror = |p: Point2| Point2::new(-p.x, p.y);
        let curve = match self.curve {
            Curve::Line => Curve::Line,
            Curve::Circle { center, radius, upper } => Curve::Circle { center: mirror(center), radius, upper },
        };
        Piece { from: mirror(self.to), to: mirror(self.from), curve, source: self.source }
    }

    pub(super) fn same_circle(&self, other: (Point2, bool)) -> bool {
        matches!(self.curve, Curve::Circle { center, upper, .. } if distance(center, other.0) < SAME_CURVE && upper == other.1)
    }

    /// Places where both may meet.
    pub(super) fn meets(&self, other: &Piece) -> [f64; 2] {
        let unit = |p: &Piece| direction(p.to - p.from, 0.0).unwrap_or_default();
        let pair = |hits: Option<[Point2; 2]>| hits.map_or([f64::NAN; 2], |[a, b]| [a.x, b.x]);
        match (self.curve, other.curve) {
            (Curve::Line, Curve::Line) => {
                let (u, w) = (unit(self), unit(other));
                let hit = intersect::lines(self.from, u, other.from, w, 1e-13);
                [hit.map_or(f64::NAN, |(s, _)| self.from.x + u.x * s), f64::NAN]
            }
            (Curve::Line, Curve::Circle { center, radius, .. }) => {
                pair(intersect::line_circle(self.from, unit(self), center, radius, 0.0))
            }
            (Curve::Circle { center, radius, .. }, Curve::Line) => {
                pair(intersect::line_circle(other.from, unit(other), center, radius, 0.0))
            }
            (Curve::Circle { center: a, radius: r, .. }, Curve::Circle { center: b, radius: s, .. }) => {
                pair(intersect::circles(a, r, b, s, 0.0))
            }
        }
    }
}
