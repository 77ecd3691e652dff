//! The course through a room: in which order its rings are cut, and how the cutter gets from one to the next. All levels are alike.
//!
//! From where the tool goes down the rings are cut from inside out, the nearest one next. A part of the room that becomes narrow in between is
//! reached over the ring around both, and is cut from outside in.

use crate::geo::area::reversed;
use crate::geo::tolerance;
use crate::geo::{Element, Point2, Vec2, direction, distance};
use crate::ir::cycle::Region;

use super::links::Ground;
use super::loops::Meets;
use super::rooms::{Entry, Room};
use super::walls::{Walls, nearest_on};

/// Parts of rings that begin within so many radii follow each other.
const LONGEST_LINK: f64 = 2.5;
/// How far a point beside a ring may lie from the ring there, mm.
const BESIDE: f64 = 1e-3;

/// What the cutter does on a level.
#[derive(Debug)]
pub struct Course {
    pub outline: usize,
    /// Where it goes down into solid material; nowhere where a larger cutter cleared ground before.
    pub entry: Option<Entry>,
    pub cuts: Vec<Cut>,
}

/// A ring, or a part of one.
#[derive(Debug)]
pub struct Cut {
    pub reach: Reach,
    pub elements: Vec<Element>,
}

/// How the cutter gets to the beginning of a cut.
#[derive(Debug, PartialEq)]
pub enum Reach {
    /// On the floor, along this and straight on.
    Floor(Vec<Element>),
    /// Through the air to a place over cleared ground, down, and straight on.
    Over(Point2),
    /// Through the air, and down into solid material.
    Solid,
}

impl Cut {
    pub fn start(&self) -> Point2 {
        self.elements.first().map_or_else(Point2::origin, Element::from)
    }
}

struct Planner<'a> {
    room: &'a Room,
    region: &'a Region,
    walls: &'a Walls,
    ground: Ground<'a>,
    /// Parts that have rings beside one that is cut.
    touched: Vec<bool>,
    at: Option<Point2>,
    /// The ring that was cut last, from where the tool stands.
    last: Vec<Element>,
    cuts: Vec<Cut>,
}

impl Course {
    /// Through a room from a place to which the tool comes when it was inserted.
    pub fn new(room: &Room, region: &Region, walls: &Walls, from: Point2) -> Course {
        let mut planner = Planner {
            room,
            region,
            walls,
            ground: Ground::new(room, walls, region.mill.radius),
            touched: vec![false; room.parts.len()],
            at: None,
            last: Vec::new(),
            cuts: Vec::with_capacity(room.rings.len()),
        };
        let solid = room.is_solid();
        if solid {
            planner.at = Some(from);
            planner.touched[room.entry.part] = true;
        } else {
            planner.chains();
        }
        while planner.next_ring() {}
        Course { outline: room.outline, entry: solid.then_some(room.entry), cuts: planner.cuts }
    }
}

impl Room {
    /// Did no cutter before this one clear anything along its rings?
    pub fn is_solid(&self) -> bool {
        self.rings.iter().all(|ring| matches!(ring.path.meets, Meets::Everywhere))
    }
}

impl Planner<'_> {
    /// Cuts the next ring; false where all are cut.
    fn next_ring(&mut self) -> bool {
        let open: Vec<usize> = (0..self.room.rings.len())
            .filter(|ring| !self.ground.is_cut(*ring) && self.touched[self.room.rings[*ring].part])
            .collect();
        let from_here = self.at.and_then(|at| self.ground.straight_to(at, &open));
        let short = LONGEST_LINK * self.region.mill.radius;
        let on_floor = match from_here {
            Some(link) if link.length <= short => Some(link),
            other => {
                let along = self.ground.along_to(&self.last, &open);
                other.into_iter().chain(along).reduce(|a, b| if b.length < a.length - tolerance::SAME { b } else { a })
            }
        };
        if let Some(link) = on_floor {
            self.cut(link.ring, link.element, link.to, Reach::Floor(link.way));
        } else if let Some((from, link)) = self.ground.over_to(&open) {
            self.cut(link.ring, link.element, link.to, Reach::Over(from));
        } else {
            // Where no way leads to any of them, the deepest one is first.
            let left = (0..self.room.rings.len()).filter(|ring| !self.ground.is_cut(*ring));
            let deeper = |a: usize, b: usize| if self.room.rings[b].depth > self.room.rings[a].depth { b } else { a };
            let Some(ring) = left.reduce(deeper) else { return false };
            self.cut(ring, 0, self.room.rings[ring].path.start(), Reach::Solid);
        }
        true
    }

    fn cut(&mut self, ring: usize, element: usize, start: Point2, reach: Reach) {
        let as_it_runs = self.region.counter_clockwise != self.is_outside_in(ring);
        let elements = self.room.rings[ring].path.beginning_at(element, start, as_it_runs);
        self.is_cut(ring);
        self.at = Some(start);
        self.last.clone_from(&elements);
        self.cuts.push(Cut { reach, elements });
    }

    fn is_cut(&mut self, ring: usize) {
        self.ground.cut(ring);
        let part = self.room.rings[ring].part;
        let Some(around) = self.room.parts.get(part) else { return };
        for part in around.inner.iter().copied().chain(around.holder).chain([part]) {
            self.touched[part] = true;
        }
    }

    /// Is the material that the ring meets on its inner side? Then the tool climbs the other way round.
    fn is_outside_in(&self, ring: usize) -> bool {
        let this = &self.room.rings[ring];
        let inner = |other: usize| {
            let part = self.room.rings[other].part;
            part == this.part || self.room.parts[part].holder == Some(this.part)
        };
        if this.depth == 0 || self.ground.rings_cut().any(inner) {
            return false;
        }
        let Some((_, middle)) = this.path.middle_of_longest() else { return false };
        let feet = self.walls.elements().iter().map(|wall| nearest_on(middle, wall));
        let foot = feet.reduce(|a, b| if distance(b, middle) < distance(a, middle) { b } else { a });
        let towards = foot.and_then(|foot| direction(foot - middle, 1e-9)).unwrap_or_else(Vec2::zeros);
        let outer = self.ground.rings_cut().map(|other| &self.room.rings[other]);
        let mut outer = outer.filter(|outer| outer.depth + 1 == this.depth);
        outer.any(|outer| outer.path.is_near(middle + towards * (this.away - outer.away), BESIDE))
    }

    /// The parts of rings that a larger cutter left: from each one on to one that begins nearby, so that a corner is finished before the next.
    fn chains(&mut self) {
        let mut waiting: Vec<Vec<Element>> = Vec::new();
        for (at, ring) in self.room.rings.iter().enumerate() {
            match &ring.path.meets {
                Meets::Everywhere => continue,
                Meets::Nowhere => {}
                Meets::Along(chains) => {
                    let ccw = self.region.counter_clockwise;
                    waiting.extend(chains.iter().map(|chain| if ccw { chain.clone() } else { reversed(chain) }));
                }
            }
            self.is_cut(at);
        }
        let start = |chain: &Vec<Element>| chain.first().map_or_else(Point2::origin, Element::from);
        let near =
            |at: Point2, to: Point2| distance(at, to) <= LONGEST_LINK * self.region.mill.radius + tolerance::SAME;
        while !waiting.is_empty() {
            let next = self.at.and_then(|at| waiting.iter().position(|chain| near(at, start(chain))));
            let elements = waiting.remove(next.unwrap_or(0));
            let begin = start(&elements);
            let free = self.at.is_some_and(|at| near(at, begin) && self.walls.is_free(at, begin, self.room.least));
            let reach = if free { Reach::Floor(Vec::new()) } else { Reach::Over(begin) };
            self.at = elements.last().map(Element::to);
            self.cuts.push(Cut { reach, elements });
        }
    }
}
