//! The blank as lines: what is seen of it from the side of the view.

use crate::geo::{Point2, Vec2, cross};
use crate::ir::Blank;
use crate::machine::Axis;

use super::canvas::Part;
use super::rect::Rect;
use super::svg::show;
use super::view::View;

/// Chords of a circle that is seen aslant, and lines along its barrel.
const CHORDS: u32 = 72;
const LINES: u32 = 4;

/// Its edges.
pub(super) fn edges(blank: &Blank, view: View) -> Vec<Part> {
    let mut edges = Edges { view, parts: Vec::new() };
    match *blank {
        Blank::Cuboid { low, high } => edges.cuboid(low, high),
        Blank::Round { axis, radius, bore, low, high } => {
            edges.round(axis, radius, low, high);
            if bore > 0.0 {
                edges.round(axis, bore, low, high);
            }
        }
    }
    edges.parts
}

/// The rectangle that holds it.
pub(super) fn take(blank: &Blank, view: View, rect: &mut Rect) {
    for part in edges(blank, view) {
        match part {
            Part::Move(p) | Part::Line(p) => rect.take(p),
            Part::Arc { center, to, .. } => {
                let radius = (to - center).norm();
                rect.take(center - Vec2::new(radius, radius));
                rect.take(center + Vec2::new(radius, radius));
            }
            Part::Close => {}
        }
    }
}

/// What it is, and with `dimensions` how large.
pub(super) fn name(blank: &Blank, dimensions: bool) -> String {
    if !dimensions {
        return "blank".to_owned();
    }
    match *blank {
        Blank::Cuboid { low, high } => {
            let sides: Vec<String> = low.iter().zip(&high).map(|(low, high)| show(high - low)).collect();
            format!("blank {}", sides.join(" x "))
        }
        Blank::Round { radius, bore, low, high, .. } => {
            let bore = if bore > 0.0 { format!(" / ⌀{}", show(2.0 * bore)) } else { String::new() };
            format!("blank ⌀{}{bore} x {}", show(2.0 * radius), show(high - low))
        }
    }
}

struct Edges {
    view: View,
    parts: Vec<Part>,
}

impl Edges {
    fn at(&self, place: [f64; 3]) -> Point2 {
        let sum = |sum: Vec2, (axis, value): (&Axis, f64)| sum + self.view.way(*axis) * value;
        Point2::from(Axis::ALL.iter().zip(place).fold(Vec2::new(0.0, 0.0), sum))
    }

    fn line(&mut self, from: [f64; 3], to: [f64; 3]) {
        self.parts.extend([Part::Move(self.at(from)), Part::Line(self.at(to))]);
    }

    fn cuboid(&mut self, low: [f64; 3], high: [f64; 3]) {
        if !self.view.is_iso() {
            return self.rectangle(self.at(low), self.at(high));
        }
        for axis in 0..3 {
            let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
            for corner in 0..4 {
                let mut from = low;
                from[second] = if corner & 1 == 0 { low[second] } else { high[second] };
                from[third] = if corner & 2 == 0 { low[third] } else { high[third] };
                let mut to = from;
                to[axis] = high[axis];
                self.line(from, to);
            }
        }
    }

    fn rectangle(&mut self, low: Point2, high: Point2) {
        self.parts.extend([
            Part::Move(low),
            Part::Line(Point2::new(high.x, low.y)),
            Part::Line(high),
            Part::Line(Point2::new(low.x, high.y)),
            Part::Close,
        ]);
    }

    fn round(&mut self, axis: Axis, radius: f64, low: f64, high: f64) {
        let along = axis.index() % 3;
        let (second, third) = ((along + 1) % 3, (along + 2) % 3);
        let place = |along_it: f64, u: f64, v: f64| {
            let mut place = [0.0; 3];
            (place[along], place[second], place[third]) = (along_it, u, v);
            place
        };
        let ways = (self.view.way(Axis::ALL[second]), self.view.way(Axis::ALL[third]));
        if self.view.is_iso() {
            return self.barrel(radius, (low, high), place);
        }
        let seen = cross(ways.0, ways.1);
        if seen == 0.0 {
            // From the side: one of the two other axes is seen.
            return self.rectangle(self.at(place(low, -radius, -radius)), self.at(place(high, radius, radius)));
        }
        let (from, half) = (self.at(place(0.0, radius, 0.0)), core::f64::consts::PI * seen);
        let (to, center) = (self.at(place(0.0, -radius, 0.0)), self.at([0.0; 3]));
        self.parts.extend([
            Part::Move(from),
            Part::Arc { center, sweep: half, to },
            Part::Arc { center, sweep: half, to: from },
        ]);
    }

    fn barrel(&mut self, radius: f64, (low, high): (f64, f64), place: impl Fn(f64, f64, f64) -> [f64; 3]) {
        let around = |of: u32, all: u32| {
            let angle = core::f64::consts::TAU * f64::from(of) / f64::from(all);
            (radius * libm::cos(angle), radius * libm::sin(angle))
        };
        for end in [low, high] {
            for chord in 0..=CHORDS {
                let (u, v) = around(chord % CHORDS, CHORDS);
                let p = self.at(place(end, u, v));
                self.parts.push(if chord == 0 { Part::Move(p) } else { Part::Line(p) });
            }
        }
        for line in 0..LINES {
            let (u, v) = around(line, LINES);
            self.line(place(low, u, v), place(high, u, v));
        }
    }
}
