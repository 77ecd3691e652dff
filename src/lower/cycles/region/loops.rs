//! Rings at a distance from the walls, and which lie in which.

use crate::geo::tolerance;
use std::panic::{AssertUnwindSafe, catch_unwind};

use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{PlineSource, PlineSourceMut, PlineVertex, Polyline};
use cavalier_contours::shape_algorithms::{IndexedPolyline, Shape, ShapeOffsetOptions};

use crate::geo::area::is_counter_clockwise;
use crate::geo::element::quarters;
use crate::geo::{Element, Point2, distance, grid, turned};

use super::carriers::settled;
use super::walls::{Walls, nearest_on, point_at, to_element};

/// How much a ring may miss its distance, mm.
const MISSES: f64 = 1e-5;
/// Shorter elements are passed over, mm.
const NOTHING: f64 = 1e-7;
/// Points nearer than this to the start of an element are that start, mm.
const SNAPS: f64 = 1e-3;
/// Elements that meet under less go on into each other, rad.
const SMOOTH: f64 = 1e-3;
/// Largest sweep of a part of an arc.
const LARGEST: f64 = 3.0;

/// Where a ring meets material.
#[derive(Debug, Clone, Default)]
pub enum Meets {
    /// Nothing was cleared before, or nothing along the ring.
    #[default]
    Everywhere,
    Nowhere,
    /// Chains of it that begin and end in cleared ground, in its sense.
    Along(Vec<Vec<Element>>),
}

/// A closed ring.
#[derive(Debug, Clone)]
pub struct Loop {
    pub elements: Vec<Element>,
    /// What of it a cutter before this one left.
    pub meets: Meets,
    line: Polyline<f64>,
    low: Point2,
    high: Point2,
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
}

/// A place, and its distance from the walls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    pub at: Point2,
    pub room: f64,
}

/// Outlines and islands, ready for rings.
#[derive(Debug)]
pub struct Area {
    fields: Vec<Field>,
}

/// An outline with its islands.
#[derive(Debug)]
struct Field {
    shape: Shape<f64>,
}

impl Loop {
    /// Of a ring that was traced at a distance from the walls; `None` where it is not there.
    fn new(traced: &Polyline<f64>, distance: f64, walls: &Walls) -> Option<Loop> {
        let mut elements = settled(&elements(traced), distance, walls)?;
        if !elements.iter().all(|element| is_at(element, distance, walls)) {
            return None;
        }
        // Where it was begun to be traced is of no account.
        let starts = elements.iter().enumerate();
        let first = starts.min_by(|a, b| grid::before(a.1.from(), b.1.from())).map_or(0, |(at, _)| at);
        elements.rotate_left(first);
        let (low, high) = extent(&elements);
        Some(Loop { line: polyline(&elements, true), elements, meets: Meets::Everywhere, low, high })
    }

    /// Smallest and largest coordinates.
    pub fn extent(&self) -> (Point2, Point2) {
        (self.low, self.high)
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
        let nearer = |best: (usize, Point2), next: (usize, Point2)| {
            if distance(next.1, p) < distance(best.1, p) - tolerance::SAME { next } else { best }
        };
        let Some((at, point)) = found.reduce(nearer) else { return (0, self.start()) };
        let next = (at + 1) % self.elements.len().max(1);
        match (self.elements.get(at), self.elements.get(next)) {
            (Some(this), _) if distance(this.from(), point) < SNAPS => (at, this.from()),
            (Some(this), Some(next_one)) if distance(this.to(), point) < SNAPS => (next, next_one.from()),
            _ => (at, point),
        }
    }

    /// Distance of a point from the ring.
    pub fn away(&self, p: Point2) -> f64 {
        self.elements.iter().map(|element| to_element(p, element)).fold(f64::INFINITY, f64::min)
    }

    /// Is a point within `reach` of the ring?
    pub fn is_near(&self, p: Point2, reach: f64) -> bool {
        let beside = |v: f64, low: f64, high: f64| v < low - reach || v > high + reach;
        let far = beside(p.x, self.low.x, self.high.x) || beside(p.y, self.low.y, self.high.y);
        !far && self.elements.iter().any(|element| to_element(p, element) <= reach)
    }

    pub fn middle_of_longest(&self) -> Option<(usize, Point2)> {
        let elements = self.elements.iter().enumerate();
        let longest = elements.reduce(|a, b| if b.1.length() > a.1.length() + tolerance::SAME { b } else { a });
        longest.map(|(at, element)| (at, element.middle()))
    }

    /// Starts of elements that go on from the one before without a corner.
    pub fn joints(&self) -> impl Iterator<Item = (usize, Point2)> + '_ {
        let count = self.elements.len();
        let smooth = move |at: usize| {
            let before = self.elements[(at + count - 1) % count].end_direction();
            let (Some(u), Some(w)) = (before, self.elements[at].start_direction()) else { return false };
            u.dot(&w) > 0.0 && crate::geo::cross(u, w).abs() < SMOOTH
        };
        (0..count).filter(move |at| smooth(*at)).map(|at| (at, self.elements[at].from()))
    }

    /// The ring from a point of an element on, as it runs or the other way.
    pub fn beginning_at(&self, element: usize, at: Point2, as_it_runs: bool) -> Vec<Element> {
        let mut made = match self.elements[..] {
            // A circle begins anywhere.
            [Element::Arc { from, to, center, sweep }] if from == to => {
                vec![Element::Arc { from: at, to: at, center, sweep }]
            }
            _ => self.parts_from(element, at),
        };
        if !as_it_runs {
            made = made.iter().rev().map(Element::reversed).collect();
        }
        made
    }

    fn parts_from(&self, element: usize, at: Point2) -> Vec<Element> {
        let (before, after) = self.elements.split_at(element.min(self.elements.len()));
        let Some((first, after)) = after.split_first() else { return Vec::new() };
        let whole = first.from() == at;
        let begins = if whole { *first } else { first.starting_at(at) };
        let ends = (!whole).then(|| first.ending_at(at));
        let parts = [begins].into_iter().chain(after.iter().copied()).chain(before.iter().copied()).chain(ends);
        parts.filter(|part| part.length() > 1e-6).collect()
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
    /// Of outlines and islands, in any sense.
    pub fn new(outlines: &[Vec<Element>], islands: &[Vec<Element>]) -> Area {
        let islands: Vec<Polyline<f64>> = islands.iter().map(|island| polyline(island, false)).collect();
        let field = |outline: &Vec<Element>| {
            let outline = polyline(outline, true);
            let inside = |island: &&Polyline<f64>| {
                island.iter_vertexes().next().is_none_or(|p| outline.winding_number(Vector2::new(p.x, p.y)) != 0)
            };
            let islands: Vec<Polyline<f64>> = islands.iter().filter(inside).cloned().collect();
            Field { shape: Shape::from_plines(core::iter::once(outline).chain(islands)) }
        };
        Area { fields: outlines.iter().map(field).collect() }
    }

    /// Does the cutter find room in each of the outlines?
    pub fn has_all(&self, parts: &[Part]) -> bool {
        (0..self.fields.len()).all(|outline| parts.iter().any(|part| part.outline == outline))
    }

    /// What the centre of the cutter may reach at `distance` from the walls; `None` where the rings are not at that distance.
    pub fn parts(&self, distance: f64, walls: &Walls) -> Option<Vec<Part>> {
        let mut made = Vec::new();
        for outline in 0..self.fields.len() {
            made.extend(self.parts_of(outline, distance, walls)?);
        }
        Some(made)
    }

    /// The same in one of the outlines.
    pub fn parts_of(&self, outline: usize, distance: f64, walls: &Walls) -> Option<Vec<Part>> {
        let shape = &self.fields.get(outline)?.shape;
        let shape =
            catch_unwind(AssertUnwindSafe(|| shape.parallel_offset(distance, &ShapeOffsetOptions::default()))).ok()?;
        let made = |lines: Vec<IndexedPolyline<f64>>| -> Option<Vec<Loop>> {
            let lines = lines.iter().map(|line| &line.polyline).filter(|line| !elements(line).is_empty());
            let loops = lines.map(|line| Loop::new(line, distance, walls));
            let mut loops = loops.collect::<Option<Vec<Loop>>>()?;
            loops.sort_by(|a, b| grid::before(a.start(), b.start()));
            Some(loops)
        };
        let (outer, holes) = (made(shape.ccw_plines)?, made(shape.cw_plines)?);
        let part = |outer| Part { outer, outline, away: distance, holes: Vec::new() };
        let mut parts: Vec<Part> = outer.into_iter().map(part).collect();
        for hole in holes {
            let at = hole.start();
            parts.iter_mut().find(|part| part.outer.holds(at))?.holes.push(hole);
        }
        Some(parts)
    }
}

/// Smallest and largest coordinates of elements, arcs counted by their whole way.
fn extent(elements: &[Element]) -> (Point2, Point2) {
    let points = elements.iter().flat_map(quarters).flat_map(|piece| [piece.from(), piece.to()]);
    let none = (Point2::new(f64::MAX, f64::MAX), Point2::new(f64::MIN, f64::MIN));
    points.fold(none, |(low, high), p| {
        (Point2::new(low.x.min(p.x), low.y.min(p.y)), Point2::new(high.x.max(p.x), high.y.max(p.y)))
    })
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
