//! Rings at a distance from the walls, and which lie in which.

use std::panic::{AssertUnwindSafe, catch_unwind};

use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{PlineSource, PlineSourceMut, PlineVertex, Polyline};
use cavalier_contours::shape_algorithms::{IndexedPolyline, Shape, ShapeOffsetOptions};

use crate::geo::area::is_counter_clockwise;
use crate::geo::{Element, Point2, distance, turned};

use super::carriers::settled;
use super::rest::Meets;
use super::walls::{Walls, nearest_on, point_at};

/// How much a ring may miss its distance, mm.
const MISSES: f64 = 1e-5;
/// Shorter elements are passed over, mm.
const NOTHING: f64 = 1e-7;
/// Points nearer than this to the start of an element are that start, mm.
const SNAPS: f64 = 1e-3;
/// Largest sweep of a part of an arc.
const LARGEST: f64 = 3.0;

/// A closed ring.
#[derive(Debug, Clone)]
pub struct Loop {
    pub elements: Vec<Element>,
    /// What of it a cutter before this one left.
    pub meets: Meets,
    line: Polyline<f64>,
}

/// What hangs together at a distance from the walls: a ring, and the rings around islands in it.
#[derive(Debug, Clone)]
pub struct Part {
    pub outer: Loop,
    /// Which of the outlines it lies in.
    pub outline: usize,
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

/// Outlines and islands, ready for rings.
#[derive(Debug)]
pub struct Area {
    shape: Shape<f64>,
    outlines: Vec<Polyline<f64>>,
}

impl Loop {
    /// Of a ring that was traced at a distance from the walls; `None` where it is not there.
    fn new(traced: &Polyline<f64>, distance: f64, walls: &Walls) -> Option<Loop> {
        let elements = settled(&elements(traced), distance, walls)?;
        let exact = elements.iter().all(|element| is_at(element, distance, walls));
        exact.then(|| Loop { line: polyline(&elements, true), elements, meets: Meets::Everywhere })
    }

    /// Does the point lie inside?
    pub fn holds(&self, p: Point2) -> bool {
        self.line.winding_number(Vector2::new(p.x, p.y)) != 0
    }

    pub fn start(&self) -> Point2 {
        self.elements.first().map_or_else(Point2::origin, Element::from)
    }

    /// The nearest point, and the element it lies on; the start of an element where that is as good.
    pub fn nearest(&self, p: Point2) -> (usize, Point2) {
        let found = self.elements.iter().enumerate().map(|(at, element)| (at, nearest_on(p, element)));
        let nearest = found.min_by(|a, b| distance(a.1, p).total_cmp(&distance(b.1, p)));
        let Some((at, point)) = nearest else { return (0, self.start()) };
        let next = (at + 1) % self.elements.len().max(1);
        match (self.elements.get(at), self.elements.get(next)) {
            (Some(this), _) if distance(this.from(), point) < SNAPS => (at, this.from()),
            (Some(this), Some(next_one)) if distance(this.to(), point) < SNAPS => (next, next_one.from()),
            _ => (at, point),
        }
    }

    /// Distance of a point from the ring.
    pub fn away(&self, p: Point2) -> f64 {
        distance(p, self.nearest(p).1)
    }

    pub fn middle_of_longest(&self) -> Option<(usize, Point2)> {
        let longest = self.elements.iter().enumerate().max_by(|a, b| a.1.length().total_cmp(&b.1.length()));
        longest.map(|(at, element)| (at, element.middle()))
    }

    /// The ring from a point of an element on, as it runs or the other way.
    pub fn beginning_at(&self, element: usize, at: Point2, as_it_runs: bool) -> Vec<Element> {
        let (before, after) = self.elements.split_at(element.min(self.elements.len()));
        let Some((first, after)) = after.split_first() else { return Vec::new() };
        let whole = first.from() == at;
        let begins = if whole { *first } else { first.starting_at(at) };
        let ends = (!whole).then(|| first.ending_at(at));
        let parts = [begins].into_iter().chain(after.iter().copied()).chain(before.iter().copied()).chain(ends);
        let parts = parts.filter(|part| part.length() > 1e-6);
        if as_it_runs {
            parts.collect()
        } else {
            let mut turned: Vec<Element> = parts.map(|part| part.reversed()).collect();
            turned.reverse();
            turned
        }
    }
}

impl Part {
    /// Does the tool go down into it, and not to a ring that begins in cleared ground?
    pub fn is_inserted(&self) -> bool {
        self.inner.is_empty() && matches!(self.outer.meets, Meets::Everywhere)
    }

    /// Does the point lie in it, and in no hole?
    pub fn holds(&self, p: Point2) -> bool {
        self.outer.holds(p) && !self.holes.iter().any(|hole| hole.holds(p))
    }

    pub fn loops(&self) -> impl Iterator<Item = &Loop> {
        core::iter::once(&self.outer).chain(&self.holes)
    }
}

impl Area {
    /// Of outlines and islands, in any sense.
    pub fn new(outlines: &[Vec<Element>], islands: &[Vec<Element>]) -> Area {
        let outlines: Vec<Polyline<f64>> = outlines.iter().map(|outline| polyline(outline, true)).collect();
        let islands = islands.iter().map(|island| polyline(island, false));
        Area { shape: Shape::from_plines(outlines.iter().cloned().chain(islands)), outlines }
    }

    /// The outline around a point.
    fn outline_of(&self, p: Point2) -> Option<usize> {
        self.outlines.iter().position(|outline| outline.winding_number(Vector2::new(p.x, p.y)) != 0)
    }

    /// Does the cutter find room in each of the outlines?
    pub fn has_all(&self, parts: &[Part]) -> bool {
        (0..self.outlines.len()).all(|outline| parts.iter().any(|part| part.outline == outline))
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
            .map(|outer| {
                let outline = self.outline_of(outer.start())?;
                Some(Part { outer, outline, away: distance, holes: Vec::new(), inner: Vec::new(), entry: None })
            })
            .collect::<Option<_>>()?;
        for hole in holes {
            let at = hole.start();
            parts.iter_mut().find(|part| part.outer.holds(at))?.holes.push(hole);
        }
        parts.sort_by(|a, b| {
            let (p, q) = (a.outer.start(), b.outer.start());
            a.outline.cmp(&b.outline).then(p.x.total_cmp(&q.x)).then(p.y.total_cmp(&q.y))
        });
        Some(parts)
    }
}

/// Is every point that is looked at as far from the walls as it should be?
fn is_at(element: &Element, asked: f64, walls: &Walls) -> bool {
    [0.0, 0.2, 0.5, 0.8].into_iter().all(|part| (walls.distance(point_at(element, part)) - asked).abs() <= MISSES)
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
    if is_counter_clockwise(elements) != ccw {
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
