//! Ways from one ring to the next on the floor: straight, or along the ring that was cut last and then straight.
//!
//! Such a way keeps its distance from the walls. It leads through cleared ground, at most the radius of the cutter beside a ring that is cut, and only
//! its last part through what the ring that it leads to takes away.

use crate::geo::area::reversed;
use crate::geo::tolerance;
use crate::geo::{Element, Point2, distance};

use super::rooms::Room;
use super::walls::{Walls, point_at};

/// How far beside the radius a way counts as cleared, mm.
const SLACK: f64 = 1e-3;
/// By how many radii a way may be longer that leads to the joint of two elements: the ring is not divided there.
const STRETCH: f64 = 0.5;
/// Longest way along a ring, in radii: a longer one is shorter through the air.
const LONGEST: f64 = 30.0;
/// Most places from which a way along a ring is tried to lead off.
const MOST_PLACES: usize = 40;
/// Most ways through the air to a ring that are tried.
const MOST_WAYS: usize = 400;

/// A way to a ring.
#[derive(Debug, Clone)]
pub struct Link {
    pub ring: usize,
    /// Where it leads to, and the element of the ring there.
    pub element: usize,
    pub to: Point2,
    /// What is followed before it leads straight on.
    pub way: Vec<Element>,
    pub length: f64,
}

/// What of a room is cleared on a level.
pub struct Ground<'a> {
    room: &'a Room,
    walls: &'a Walls,
    radius: f64,
    cut: Vec<bool>,
}

impl<'a> Ground<'a> {
    pub fn new(room: &'a Room, walls: &'a Walls, radius: f64) -> Ground<'a> {
        Ground { room, walls, radius, cut: vec![false; room.rings.len()] }
    }

    pub fn cut(&mut self, ring: usize) {
        self.cut[ring] = true;
    }

    pub fn is_cut(&self, ring: usize) -> bool {
        self.cut[ring]
    }

    pub fn rings_cut(&self) -> impl Iterator<Item = usize> + '_ {
        self.cut.iter().enumerate().filter(|(_, cut)| **cut).map(|(ring, _)| ring)
    }

    /// The nearest of some rings to which a straight way leads; of equally near ones the deepest.
    pub fn straight_to(&self, from: Point2, rings: &[usize]) -> Option<Link> {
        rings.iter().fold(None, |best, ring| match self.straight(from, *ring) {
            Some(link) => Some(self.sooner(best, link)),
            None => best,
        })
    }

    fn sooner(&self, best: Option<Link>, next: Link) -> Link {
        let Some(best) = best else { return next };
        let depth = |link: &Link| self.room.rings[link.ring].depth;
        let equal = (next.length - best.length).abs() <= tolerance::SAME;
        let sooner = if equal { depth(&next) > depth(&best) } else { next.length < best.length };
        if sooner { next } else { best }
    }

    /// A straight way to a ring: to the joint of two elements where one is nearly as near, or to the nearest point.
    fn straight(&self, from: Point2, ring: usize) -> Option<Link> {
        let path = &self.room.rings[ring].path;
        let nearest = path.nearest(from);
        let longest = distance(from, nearest.1) + STRETCH * self.radius;
        let joints = path.joints().filter(|(_, p)| distance(from, *p) <= longest);
        let joint =
            joints.reduce(|a, b| if distance(from, b.1) < distance(from, a.1) - tolerance::SAME { b } else { a });
        let mut ends = joint.into_iter().chain([nearest]);
        let (element, to) = ends.find(|(_, to)| self.is_open(from, *to, ring))?;
        Some(Link { ring, element, to, way: Vec::new(), length: distance(from, to) })
    }

    /// Is a straight way to a ring free of walls, and cleared but for what the ring takes?
    fn is_open(&self, from: Point2, to: Point2, ring: usize) -> bool {
        let reach = self.radius + SLACK;
        let path = &self.room.rings[ring].path;
        let length = distance(from, to);
        let known = |p: Point2| {
            distance(p, to) <= reach
                || path.is_near(p, reach)
                || self.rings_cut().any(|ring| self.room.rings[ring].path.is_near(p, reach))
        };
        let count = libm::ceil(2.0 * length / self.radius).clamp(1.0, 1e5) as u32;
        let cleared = || (0..count).all(|i| known(from + (to - from) * (f64::from(i) / f64::from(count))));
        self.walls.is_free(from, to, self.room.least) && (length <= reach || cleared())
    }

    /// The shortest way along a closed path from its start, in its sense or against it, and straight on to one of some rings.
    pub fn along_to(&self, last: &[Element], rings: &[usize]) -> Option<Link> {
        let back = reversed(last);
        let mut places = Vec::new();
        for elements in [last, &back[..]] {
            let (mut way, mut length): (Vec<Element>, f64) = (Vec::new(), 0.0);
            for element in elements {
                for part in parts_of(element) {
                    length += part.length();
                    way.push(part);
                    if length <= LONGEST * self.radius {
                        places.push((joined(&way), length));
                    }
                }
            }
        }
        rings.iter().fold(None, |best, ring| match self.leading_off(&places, *ring) {
            Some(link) => Some(self.sooner(best, link)),
            None => best,
        })
    }

    /// From one of some places straight on to a ring.
    fn leading_off(&self, places: &[(Vec<Element>, f64)], ring: usize) -> Option<Link> {
        let path = &self.room.rings[ring].path;
        let mut tried: Vec<(f64, usize)> = Vec::with_capacity(places.len());
        for (at, (way, length)) in places.iter().enumerate() {
            let Some(end) = way.last().map(Element::to) else { continue };
            tried.push((length + path.away(end), at));
        }
        tried.sort_by(|a, b| rough(a.0).total_cmp(&rough(b.0)).then(a.1.cmp(&b.1)));
        let mut ways = tried.iter().take(MOST_PLACES).filter(|(length, _)| *length <= LONGEST * self.radius);
        ways.find_map(|(_, at)| {
            let (way, length) = &places[*at];
            let link = self.straight(way.last()?.to(), ring)?;
            Some(Link { length: length + link.length, way: way.clone(), ..link })
        })
    }

    /// The shortest straight way from a ring that is cut to one of some rings, and where it begins.
    pub fn over_to(&self, rings: &[usize]) -> Option<(Point2, Link)> {
        let mut best: Option<(Point2, Link)> = None;
        for ring in rings {
            let Some((from, link)) = self.link_from_cut(*ring) else { continue };
            let is_next = best.as_ref().is_none_or(|(_, best)| link.length < best.length - tolerance::SAME);
            if is_next {
                best = Some((from, link));
            }
        }
        best
    }

    fn link_from_cut(&self, ring: usize) -> Option<(Point2, Link)> {
        let path = &self.room.rings[ring].path;
        let points = |elements: &[Element]| elements.iter().flat_map(|e| [e.from(), e.middle()]).collect::<Vec<_>>();
        let mut ways: Vec<(Point2, (usize, Point2))> = Vec::new();
        for cut in self.rings_cut().filter(|cut| self.are_neighbours(*cut, ring)) {
            let cut = &self.room.rings[cut].path;
            ways.extend(points(&cut.elements).into_iter().map(|from| (from, path.nearest(from))));
            let ends = path.elements.iter().enumerate().flat_map(|(at, e)| [(at, e.from()), (at, e.middle())]);
            ways.extend(ends.map(|to| (cut.nearest(to.1).1, to)));
        }
        ways.sort_by(|a, b| rough(distance(a.0, a.1.1)).total_cmp(&rough(distance(b.0, b.1.1))));
        let mut ways = ways.into_iter().take(MOST_WAYS);
        let (from, (element, to)) = ways.find(|(from, (_, to))| self.is_open(*from, *to, ring))?;
        Some((from, Link { ring, element, to, way: Vec::new(), length: distance(from, to) }))
    }

    fn are_neighbours(&self, a: usize, b: usize) -> bool {
        let (a, b) = (self.room.rings[a].part, self.room.rings[b].part);
        let holder = |part: usize| self.room.parts[part].holder;
        a == b || holder(a) == Some(b) || holder(b) == Some(a)
    }
}

/// A length to compare by.
fn rough(length: f64) -> f64 {
    libm::floor(length * 1e5 + 0.57)
}

/// Halves of an element, quarters of a long arc.
fn parts_of(element: &Element) -> Vec<Element> {
    let count = match element {
        Element::Arc { sweep, .. } if sweep.abs() > core::f64::consts::PI => 8u32,
        _ => 2,
    };
    let point = |i: u32| match i {
        0 => element.from(),
        _ if i == count => element.to(),
        _ => point_at(element, f64::from(i) / f64::from(count)),
    };
    let part = |i: u32| match *element {
        Element::Line { .. } => Element::Line { from: point(i), to: point(i + 1) },
        Element::Arc { center, sweep, .. } => {
            Element::Arc { from: point(i), to: point(i + 1), center, sweep: sweep / f64::from(count) }
        }
    };
    (0..count).map(part).collect()
}

/// A way with the parts of each line and circle as one element.
fn joined(way: &[Element]) -> Vec<Element> {
    let mut made: Vec<Element> = Vec::with_capacity(way.len());
    for part in way {
        match (made.last_mut(), part) {
            (Some(Element::Line { from, to }), Element::Line { to: end, .. }) if is_straight(*from, *to, *end) => {
                *to = *end
            }
            (
                Some(Element::Arc { to, center, sweep, .. }),
                Element::Arc { to: end, center: about, sweep: more, .. },
            ) if center == about && (*sweep > 0.0) == (*more > 0.0) => {
                *to = *end;
                *sweep += more;
            }
            _ => made.push(*part),
        }
    }
    made
}

fn is_straight(a: Point2, b: Point2, c: Point2) -> bool {
    let (u, w) = (b - a, c - b);
    u.dot(&w) > 0.0 && crate::geo::cross(u, w).abs() <= 1e-9 * (1.0 + u.dot(&w))
}
