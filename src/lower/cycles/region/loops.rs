//! Rings at a distance from the walls, and which lie in which.

use std::panic::{AssertUnwindSafe, catch_unwind};

use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{PlineSource, PlineSourceMut, PlineVertex, Polyline};
use cavalier_contours::shape_algorithms::{IndexedPolyline, Shape, ShapeOffsetOptions};

use crate::geo::{Element, Point2, distance, turned};

use super::carriers::settled;
use super::walls::{Walls, point_at};

/// How much a ring may miss its distance, mm.
const MISSES: f64 = 1e-5;
/// Shorter elements are passed over, mm.
const NOTHING: f64 = 1e-7;
/// Largest sweep of a part of an arc.
const LARGEST: f64 = 3.0;

/// A closed ring.
#[derive(Debug, Clone)]
pub struct Loop {
    pub elements: Vec<Element>,
    line: Polyline<f64>,
}

/// What hangs together at a distance from the walls: a ring, and the rings around islands in it.
#[derive(Debug, Clone)]
pub struct Part {
    pub outer: Loop,
    /// Distance of its rings from the walls.
    pub away: f64,
    pub holes: Vec<Loop>,
    /// What of it lies deeper.
    pub inner: Vec<Part>,
    /// Of parts with nothing deeper.
    pub entry: Option<Entry>,
}

/// Where the tool is inserted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    pub at: Point2,
    /// Distance of the walls there.
    pub room: f64,
    /// From a start point that was asked for straight on to where there is most room.
    pub then: Option<Point2>,
    /// Where strokes to and fro end, which begin here.
    pub stroke: Option<Point2>,
}

/// Outline and islands, ready for rings.
#[derive(Debug)]
pub struct Area {
    shape: Shape<f64>,
}

impl Loop {
    /// Of a ring that was traced at a distance from the walls; `None` where it is not there.
    fn new(traced: &Polyline<f64>, distance: f64, walls: &Walls) -> Option<Loop> {
        let elements = settled(&elements(traced), distance, walls)?;
        let exact = elements.iter().all(|element| is_at(element, distance, walls));
        exact.then(|| Loop { line: polyline(&elements, true), elements })
    }

    /// Does the point lie inside?
    pub fn holds(&self, p: Point2) -> bool {
        self.line.winding_number(Vector2::new(p.x, p.y)) != 0
    }

    pub fn start(&self) -> Point2 {
        self.elements.first().map_or_else(Point2::origin, Element::from)
    }
}

impl Part {
    /// Does the point lie in it, and in no hole?
    pub fn holds(&self, p: Point2) -> bool {
        self.outer.holds(p) && !self.holes.iter().any(|hole| hole.holds(p))
    }

    pub fn loops(&self) -> impl Iterator<Item = &Loop> {
        core::iter::once(&self.outer).chain(&self.holes)
    }
}

impl Area {
    /// Of an outline and islands, in any sense.
    pub fn new(outline: &[Element], islands: &[Vec<Element>]) -> Area {
        let mut lines = vec![polyline(outline, true)];
        lines.extend(islands.iter().map(|island| polyline(island, false)));
        Area { shape: Shape::from_plines(lines) }
    }

    /// What the centre of the cutter may reach at `distance` from the walls; `None` where the rings are not at that distance.
    pub fn parts(&self, distance: f64, walls: &Walls) -> Option<Vec<Part>> {
        let shape =
            catch_unwind(AssertUnwindSafe(|| self.shape.parallel_offset(distance, &ShapeOffsetOptions::default())))
                .ok()?;
        let made = |lines: Vec<IndexedPolyline<f64>>| -> Option<Vec<Loop>> {
            let lines = lines.iter().map(|line| &line.polyline).filter(|line| !elements(line).is_empty());
            lines.map(|line| Loop::new(line, distance, walls)).collect()
        };
        let (outer, holes) = (made(shape.ccw_plines)?, made(shape.cw_plines)?);
        let mut parts: Vec<Part> = outer
            .into_iter()
            .map(|outer| Part { outer, away: distance, holes: Vec::new(), inner: Vec::new(), entry: None })
            .collect();
        for hole in holes {
            let at = hole.start();
            parts.iter_mut().find(|part| part.outer.holds(at))?.holes.push(hole);
        }
        parts.sort_by(|a, b| {
            let (a, b) = (a.outer.start(), b.outer.start());
            a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
        });
        Some(parts)
    }
}

/// Is every point that is looked at as far from the walls as it should be?
fn is_at(element: &Element, asked: f64, walls: &Walls) -> bool {
    [0.0, 0.2, 0.5, 0.8].into_iter().all(|part| (walls.distance(point_at(element, part)) - asked).abs() <= MISSES)
}

/// Twice the area that a closed chain goes around, above 0 counter-clockwise.
fn area(elements: &[Element]) -> f64 {
    let of = |element: &Element| {
        let (a, b) = (element.from(), element.to());
        let segment = match *element {
            Element::Line { .. } => 0.0,
            Element::Arc { center, sweep, from, .. } => {
                let radius = distance(from, center);
                radius * radius * (sweep - libm::sin(sweep))
            }
        };
        a.x * b.y - a.y * b.x + segment
    };
    elements.iter().map(of).sum()
}

fn polyline(elements: &[Element], ccw: bool) -> Polyline<f64> {
    let mut line = Polyline::new_closed();
    for element in elements.iter().filter(|element| element.length() > NOTHING) {
        match *element {
            Element::Line { from, .. } => line.add(from.x, from.y, 0.0),
            Element::Arc { from, center, sweep, .. } => {
                let count = libm::ceil(sweep.abs() / LARGEST).max(1.0);
                let bulge = libm::tan(sweep / count / 4.0);
                for i in 0..count as usize {
                    let p = center + turned(from - center, sweep * i as f64 / count);
                    line.add(p.x, p.y, bulge);
                }
            }
        }
    }
    if (area(elements) > 0.0) != ccw {
        line.invert_direction_mut();
    }
    line
}

fn elements(line: &Polyline<f64>) -> Vec<Element> {
    let vertices: Vec<PlineVertex<f64>> = line.iter_vertexes().collect();
    let next = |at: usize| vertices[(at + 1) % vertices.len()];
    let mut made: Vec<Element> = Vec::with_capacity(vertices.len());
    for (at, vertex) in vertices.iter().enumerate() {
        let from = made.last().map_or(Point2::new(vertex.x, vertex.y), Element::to);
        let to = Point2::new(next(at).x, next(at).y);
        if distance(from, to) <= NOTHING {
            continue;
        }
        let chord = to - from;
        made.push(if vertex.bulge.abs() < 1e-9 {
            Element::Line { from, to }
        } else {
            let bulge = vertex.bulge;
            let middle = from + chord / 2.0;
            let center = middle + crate::geo::left(chord) * ((1.0 - bulge * bulge) / (4.0 * bulge));
            Element::Arc { from, to, center, sweep: 4.0 * libm::atan(bulge) }
        });
    }
    made
}
