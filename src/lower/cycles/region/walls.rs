//! How far the walls are.

use crate::geo::{Element, Point2, arc, distance};

/// Distance of `p` from an element.
pub fn to_element(p: Point2, element: &Element) -> f64 {
    let ends = || distance(p, element.from()).min(distance(p, element.to()));
    match *element {
        Element::Line { from, to } => {
            let way = to - from;
            let square = way.norm_squared();
            if square == 0.0 {
                return ends();
            }
            let part = ((p - from).dot(&way) / square).clamp(0.0, 1.0);
            distance(p, from + way * part)
        }
        Element::Arc { from, center, sweep, .. } => {
            let to_center = distance(p, center);
            let turn = arc::sweep(from, p, center, sweep > 0.0).abs();
            if to_center == 0.0 || turn <= sweep.abs() || sweep.abs() >= core::f64::consts::TAU - 1e-9 {
                (to_center - distance(from, center)).abs()
            } else {
                ends()
            }
        }
    }
}

/// The point of an element that is nearest to `p`.
pub fn nearest_on(p: Point2, element: &Element) -> Point2 {
    let (from, to) = (element.from(), element.to());
    let end = if distance(p, from) <= distance(p, to) { from } else { to };
    match *element {
        Element::Line { from, to } => {
            let way = to - from;
            let square = way.norm_squared();
            if square == 0.0 { from } else { from + way * ((p - from).dot(&way) / square).clamp(0.0, 1.0) }
        }
        Element::Arc { from, center, sweep, .. } => {
            let (out, radius) = (p - center, distance(from, center));
            let turn = arc::sweep(from, p, center, sweep > 0.0).abs();
            match crate::geo::direction(out, 1e-12) {
                Some(unit) if turn <= sweep.abs() => center + unit * radius,
                _ => end,
            }
        }
    }
}

/// The walls of a pocket.
#[derive(Debug, Clone)]
pub struct Walls {
    elements: Vec<Element>,
}

impl Walls {
    pub fn new(elements: Vec<Element>) -> Walls {
        Walls { elements }
    }

    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// Distance of the nearest wall.
    pub fn distance(&self, p: Point2) -> f64 {
        self.elements.iter().map(|element| to_element(p, element)).fold(f64::INFINITY, f64::min)
    }

    /// Does a straight way keep this distance from all walls?
    pub fn is_free(&self, from: Point2, to: Point2, least: f64) -> bool {
        let way = to - from;
        let length = crate::geo::length(way);
        let mut at = 0.0;
        loop {
            let room = self.distance(from + way * if length > 0.0 { at / length } else { 0.0 }) - least;
            if room < -SLACK {
                return false;
            }
            if at >= length {
                return true;
            }
            // Nothing within the room can come nearer than asked.
            at = (at + room.max(STEP)).min(length);
        }
    }
}

/// A point after a part of the way.
pub fn point_at(element: &Element, part: f64) -> Point2 {
    match *element {
        Element::Line { from, to } => from + (to - from) * part,
        Element::Arc { from, center, sweep, .. } => center + crate::geo::turned(from - center, sweep * part),
    }
}

/// What arithmetic may lose.
const SLACK: f64 = 1e-5;
/// Shortest step along a way that is checked, mm.
const STEP: f64 = 0.02;
