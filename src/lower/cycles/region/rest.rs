//! What a coarser cutter left of a pocket: of the rings only those parts are cut that meet material.

use crate::geo::Element;
use crate::ir::cycle::region::Coarse;

use super::loops::{Area, Meets, Part};
use super::rooms::Room;
use super::walls::{Walls, point_at};

/// Steps in which is looked along a ring: parts of what the coarser cutter is larger by, shortest and longest, mm.
const STEPS: f64 = 8.0;
const SHORTEST: f64 = 0.05;
const LONGEST: f64 = 0.25;
/// Along a wall both cutters touch it; what stands out by less is nothing, mm.
const NOTHING: f64 = 1e-4;

/// What a coarser cutter cleared.
pub struct Cleared {
    /// What its centre reached.
    parts: Vec<Part>,
    /// By how much it is larger.
    larger: f64,
    /// Parts of a ring that lie nearer to each other are one, mm.
    gap: f64,
    step: f64,
}

impl Cleared {
    /// By a cutter before one of `radius`; `None` where its rings are not at their distance from the walls.
    pub fn new(coarse: &Coarse, radius: f64) -> Option<Cleared> {
        let walls = Walls::new(coarse.outlines.iter().chain(&coarse.islands).flatten().copied().collect());
        let area = Area::new(&coarse.outlines, &coarse.islands);
        let larger = coarse.radius - radius;
        Some(Cleared {
            parts: area.parts(coarse.radius + coarse.allowance, &walls)?,
            larger,
            gap: 2.0 * radius,
            step: (larger / STEPS).clamp(SHORTEST, LONGEST),
        })
    }

    /// Finds for all rings where they meet material.
    pub fn look_along(&self, rooms: &mut [Room]) {
        for ring in rooms.iter_mut().flat_map(|room| &mut room.rings) {
            ring.path.meets = self.along(&ring.path.elements);
        }
    }

    /// How far the cutter reaches out of cleared ground; below 0 in it.
    fn beyond(&self, p: crate::geo::Point2) -> f64 {
        let rings = self.parts.iter().flat_map(Part::loops);
        let nearest = rings.map(|ring| ring.away(p)).fold(f64::INFINITY, f64::min);
        let inside = self.parts.iter().any(|part| part.holds(p));
        (if inside { -nearest } else { nearest }) - self.larger
    }

    fn along(&self, ring: &[Element]) -> Meets {
        let mut steps: Vec<(usize, Element)> = Vec::new();
        for (at, element) in ring.iter().enumerate() {
            steps.extend(divided(element, self.step).into_iter().map(|part| (at, part)));
        }
        // What stands out most does so at the ends of elements and in the middle of arcs, which are among the points.
        let clear: Vec<bool> = steps.iter().map(|(_, part)| self.beyond(part.from()) <= NOTHING).collect();
        let count = steps.len();
        let needed: Vec<bool> = (0..count).map(|i| !(clear[i] && clear[(i + 1) % count])).collect();
        let needed = self.without_gaps(&steps, needed);
        let Some(begin) = needed.iter().position(|needed| !needed) else { return Meets::Everywhere };
        if !needed.contains(&true) {
            return Meets::Nowhere;
        }
        let mut chains: Vec<Vec<Element>> = Vec::new();
        let mut last = None;
        for i in (0..count).map(|i| (begin + i) % count) {
            let (at, part) = steps[i];
            match (needed[i], last) {
                (false, _) => last = None,
                (true, None) => {
                    chains.push(vec![part]);
                    last = Some(at);
                }
                (true, Some(before)) => {
                    if let Some(chain) = chains.last_mut() {
                        match chain.last_mut().filter(|_| before == at) {
                            Some(element) => *element = joined(element, &part),
                            None => chain.push(part),
                        }
                    }
                    last = Some(at);
                }
            }
        }
        Meets::Along(chains)
    }

    /// Short ways through cleared ground are gone at the feed, but for the last one of a ring.
    fn without_gaps(&self, steps: &[(usize, Element)], needed: Vec<bool>) -> Vec<bool> {
        let count = steps.len();
        let Some(first) = needed.iter().position(|needed| *needed) else { return needed };
        let (mut made, mut gap, mut length) = (needed.clone(), Vec::new(), 0.0);
        for i in (1..=count).map(|i| (first + i) % count) {
            if !needed[i] {
                gap.push(i);
                length += steps[i].1.length();
                continue;
            }
            if length <= self.gap {
                gap.iter().for_each(|i| made[*i] = true);
            }
            gap.clear();
            length = 0.0;
        }
        if made.contains(&false) { made } else { needed }
    }
}

/// Equal parts of an element.
fn divided(element: &Element, most: f64) -> Vec<Element> {
    let count = 2 * libm::ceil(element.length() / most / 2.0).clamp(1.0, 1e5) as u32;
    let at = |i: u32| match i {
        0 => element.from(),
        _ if i == count => element.to(),
        _ => point_at(element, f64::from(i) / f64::from(count)),
    };
    let part = |i: u32| match *element {
        Element::Line { .. } => Element::Line { from: at(i), to: at(i + 1) },
        Element::Arc { center, sweep, .. } => {
            Element::Arc { from: at(i), to: at(i + 1), center, sweep: sweep / f64::from(count) }
        }
    };
    (0..count).map(part).collect()
}

/// Two parts of one element, the second one from where the first ends.
fn joined(first: &Element, next: &Element) -> Element {
    match (*first, *next) {
        (Element::Arc { from, center, sweep, .. }, Element::Arc { to, sweep: more, .. }) => {
            Element::Arc { from, to, center, sweep: sweep + more }
        }
        _ => Element::Line { from: first.from(), to: next.to() },
    }
}
