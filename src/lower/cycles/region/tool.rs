//! The path of the cutter along the rings of a pocket.

use crate::geo::area::reversed;
use crate::geo::{Element, Point2, Vec2, distance, left};
use crate::ir::Feed;
use crate::ir::cycle::Region;
use crate::ir::cycle::milling::{MOST_LEVELS, parts};
use crate::ir::cycle::pocket::{Finish, Insertion};

use super::loops::{Entry, Loop, Part};
use super::rest::Meets;
use super::walls::Walls;
use super::{Cutter, NOTHING, SMALLEST_APPROACH, entry_of, strokes};

/// Links longer than so many widths of a cut are ways through the air.
const LONGEST_LINK: f64 = 2.5;

/// Where the cutter went down into solid material.
#[derive(Default)]
pub struct Places {
    pub at: Vec<Point2>,
    /// Also straight down to a ring that no way leads to.
    pub is_plunged: bool,
}

pub struct Tool<'a> {
    region: &'a Region,
    walls: &'a Walls,
    pub cutter: Cutter<'a>,
    /// In which outline the tool works.
    outline: Option<usize>,
    /// The tool stands at the safety distance over the pocket.
    is_over: bool,
    /// Rings that are cut on this level.
    cut: Vec<Loop>,
    /// What is cleared in front of this level.
    cleared: f64,
    /// Where the tool stands on this level; `None` above it.
    at: Option<Point2>,
    /// Parts of rings that wait to be cut, from inside out.
    chains: Vec<Vec<Element>>,
    pub places: Places,
}

impl<'a> Tool<'a> {
    pub fn new(region: &'a Region, walls: &'a Walls, cutter: Cutter<'a>) -> Tool<'a> {
        Tool {
            region,
            walls,
            cutter,
            outline: None,
            is_over: false,
            cut: Vec::new(),
            cleared: region.mill.heights.reference,
            at: None,
            chains: Vec::new(),
            places: Places::default(),
        }
    }

    pub fn rough(&mut self, parts: &[Part]) {
        let heights = self.region.mill.heights;
        for part in parts {
            self.begin(part);
            let mut from = heights.reference;
            for level in heights.levels() {
                self.level(
                    part,
                    self.region.mill.radius + self.region.allowance,
                    from,
                    level,
                    self.region.mill.feeds.plane,
                );
                from = level;
            }
        }
    }

    /// From one outline to the next the tool goes over the retract height.
    pub fn begin(&mut self, part: &Part) {
        if self.outline.replace(part.outline) != Some(part.outline) {
            self.is_over = false;
        }
    }

    /// A part on one level: what lies deeper, then its own rings.
    pub fn level(&mut self, part: &Part, least: f64, from: f64, to: f64, feed: Feed) {
        self.cut.clear();
        self.cleared = from;
        self.part(part, least, from, to, feed);
        self.cut_chains(least, to, feed);
        self.up();
    }

    fn part(&mut self, part: &Part, least: f64, from: f64, to: f64, feed: Feed) {
        for inner in &part.inner {
            self.part(inner, least, from, to, feed);
        }
        if part.is_inserted() {
            self.insert_into(part, least, from, to);
        }
        for ring in part.loops() {
            match &ring.meets {
                Meets::Everywhere => {
                    self.cut_chains(least, to, feed);
                    self.ring(ring, least, to, feed);
                }
                Meets::Nowhere => self.cut.push(ring.clone()),
                Meets::Along(chains) => {
                    let ccw = self.region.counter_clockwise;
                    self.chains.extend(chains.iter().map(|chain| if ccw { chain.clone() } else { reversed(chain) }));
                    self.cut.push(ring.clone());
                }
            }
        }
    }

    /// The parts of rings that wait: from each one on to one that begins nearby, so that a corner is finished before the next.
    fn cut_chains(&mut self, least: f64, level: f64, feed: Feed) {
        let heights = self.region.mill.heights;
        while !self.chains.is_empty() {
            let start = |chain: &Vec<Element>| chain.first().map_or_else(Point2::origin, Element::from);
            let near = |at: Point2, to: Point2| distance(at, to) <= LONGEST_LINK * self.region.mill.radius;
            let next = self.at.and_then(|at| self.chains.iter().position(|chain| near(at, start(chain))));
            let chain = self.chains.remove(next.unwrap_or(0));
            let begin = start(&chain);
            if self.at.is_some_and(|at| near(at, begin) && self.walls.is_free(at, begin, least)) {
                self.cutter.line(begin, feed);
            } else {
                self.go_over(begin);
                self.cutter.lift(heights.above_cleared(level));
                self.cutter.plunge(level);
            }
            self.cutter.follow(&chain, feed);
            self.at = chain.last().map(Element::to);
        }
    }

    /// Up from a level, and to the safety distance.
    fn up(&mut self) {
        if self.at.take().is_some() {
            let heights = &self.region.mill.heights;
            self.cutter.lift(if self.region.lifts_high { heights.retract } else { heights.safe() });
        }
    }

    fn go_over(&mut self, point: Point2) {
        self.up();
        if std::mem::replace(&mut self.is_over, true) {
            self.cutter.rapid(point);
            self.cutter.lift(self.region.mill.heights.safe());
        } else {
            self.cutter.approach(point);
        }
    }

    /// Into a part that has nothing deeper, from one level to the next.
    fn insert_into(&mut self, part: &Part, least: f64, from: f64, to: f64) {
        let heights = self.region.mill.heights;
        let entry = entry_of(part, least);
        let arm = self.region.helix_arm(entry.room, least);
        let arm = if arm < SMALLEST_APPROACH { 0.0 } else { arm };
        let begin = Point2::new(entry.at.x + arm, entry.at.y);
        self.places.at.push(begin);
        self.go_over(begin);
        if self.region.insertion == Insertion::Predrilled {
            self.cutter.lift(to);
        } else {
            self.cutter.lift(if from == heights.reference { heights.safe() } else { heights.above_cleared(from) });
            self.cutter.plunge(from);
            self.down(begin, &entry, arm, from, to);
        }
        self.at = Some(begin);
        self.go_on(&entry, self.region.mill.feeds.plane);
    }

    /// From a start point that was asked for to where the rings begin.
    fn go_on(&mut self, entry: &Entry, feed: Feed) {
        if let Some(then) = entry.then {
            // Straight from the middle of the insertion, as it was found to be free.
            self.cutter.line(entry.at, feed);
            self.cutter.line(then, feed);
            self.at = Some(then);
        }
    }

    fn down(&mut self, begin: Point2, entry: &Entry, arm: f64, from: f64, to: f64) {
        let feed = self.region.insertion_feed.unwrap_or(self.region.mill.feeds.depth);
        let ccw = self.region.counter_clockwise;
        match (self.region.insertion, entry.stroke) {
            (Insertion::Helix { pitch, .. }, _) if arm > 0.0 => {
                let turns = parts((from - to).abs(), pitch).min(MOST_LEVELS) as u32;
                self.cutter.helix(entry.at, ccw, turns, to, feed);
                self.cutter.arc(begin, entry.at, ccw, feed);
            }
            (Insertion::Sway { angle, .. }, Some(end)) => {
                let there = Element::Line { from: begin, to: end };
                let back = there.reversed();
                let strokes = strokes((from - to).abs(), there.length(), angle);
                for stroke in 1..=strokes + 1 {
                    let done = stroke.min(strokes) as f64 / strokes as f64;
                    let height = if stroke >= strokes { to } else { from + (to - from) * done };
                    self.cutter.fall(if stroke % 2 == 1 { &there } else { &back }, height, feed);
                }
                if strokes.is_multiple_of(2) {
                    self.cutter.line(begin, feed);
                }
            }
            _ => self.cutter.sink(to, feed),
        }
    }

    /// A ring of a level, from where the tool stands or from a ring that is cut.
    fn ring(&mut self, ring: &Loop, least: f64, level: f64, feed: Feed) {
        let longest = LONGEST_LINK * self.region.mill.radius;
        let free = |from: Point2, to: Point2| distance(from, to) <= longest && self.walls.is_free(from, to, least);
        let from_here = self.at.map(|at| (at, ring.nearest(at))).filter(|(at, (_, to))| free(*at, *to));
        let from_cut = || {
            let starts = self.cut.iter().flat_map(|cut| cut.elements.iter().flat_map(|e| [e.from(), e.middle()]));
            let links = starts.map(|from| (from, ring.nearest(from)));
            let mut links: Vec<_> = links.filter(|(from, (_, to))| distance(*from, *to) <= longest).collect();
            links.sort_by(|a, b| distance(a.0, a.1.1).total_cmp(&distance(b.0, b.1.1)));
            links.into_iter().find(|(from, (_, to))| free(*from, *to))
        };
        let to_ring = || {
            let points = ring.elements.iter().enumerate();
            let points = points.flat_map(|(at, e)| [(at, e.from()), (at, e.middle())]);
            let links = points.flat_map(|to| self.cut.iter().map(move |cut| (cut.nearest(to.1).1, to)));
            let mut links: Vec<_> = links.filter(|(from, (_, to))| distance(*from, *to) <= longest).collect();
            links.sort_by(|a, b| distance(a.0, a.1.1).total_cmp(&distance(b.0, b.1.1)));
            links.into_iter().find(|(from, (_, to))| free(*from, *to))
        };
        let known = from_here.or_else(from_cut).or_else(to_ring);
        let cleared = if known.is_some() { level } else { self.cleared };
        if known.is_none() {
            self.places.at.push(ring.start());
            self.places.is_plunged = true;
        }
        let (from, (element, to)) = known.unwrap_or_else(|| (ring.start(), (0, ring.start())));
        if self.at != Some(from) {
            let heights = self.region.mill.heights;
            self.go_over(from);
            self.cutter.lift(heights.above_cleared(cleared));
            self.cutter.plunge(level);
        }
        self.cutter.line(to, feed);
        let elements = ring.beginning_at(element, to, self.region.counter_clockwise);
        self.cutter.follow(&elements, feed);
        self.at = Some(to);
        self.cut.push(ring.clone());
    }

    /// A wall, level by level.
    pub fn wall(&mut self, ring: &Loop, finish: &Finish, arc: f64) {
        let heights = self.region.mill.heights;
        let ccw = self.region.counter_clockwise;
        let Some((element, touch)) = ring.middle_of_longest() else { return };
        let elements = ring.beginning_at(element, touch, ccw);
        let Some(along) = elements.first().and_then(Element::start_direction) else { return };
        let inward = if ccw { left(along) } else { -left(along) };
        let radius = self.approach_radius(touch, inward, along, arc);
        let (center, from, to) = (
            touch + inward * radius,
            touch + inward * radius - along * radius,
            touch + inward * radius + along * radius,
        );
        let mut above = heights.safe();
        for level in heights.levels_to(heights.rough_floor(), finish.step) {
            self.go_over(from);
            self.cutter.lift(above);
            self.cutter.plunge(level);
            if radius > 0.0 {
                self.cutter.arc(touch, center, ccw, finish.feed);
            }
            self.cutter.follow(&elements, finish.feed);
            if radius > 0.0 {
                self.cutter.arc(to, center, ccw, finish.feed);
            }
            self.at = Some(to);
            above = heights.above_cleared(level);
        }
        self.up();
    }

    /// The radius of an arc onto the wall that stays between the walls; 0 where none does.
    fn approach_radius(&self, touch: Point2, inward: Vec2, along: Vec2, arc: f64) -> f64 {
        let mut radius = arc.max(self.region.allowance);
        while radius >= SMALLEST_APPROACH {
            let center = touch + inward * radius;
            // The arcs lie on a circle that touches the wall: there is room where its centre has it.
            let ends = [center - along * radius, center + along * radius, center];
            let least = self.region.mill.radius + self.region.left;
            if self.walls.distance(center) >= least + radius - NOTHING
                && ends.iter().all(|p| self.walls.distance(*p) >= least)
            {
                return radius;
            }
            radius /= 2.0;
        }
        0.0
    }

    /// The floor at its depth.
    pub fn floor(&mut self, part: &Part, finish: &Finish) {
        let heights = self.region.mill.heights;
        let least = self.region.mill.radius + if finish.wall { self.region.left } else { self.region.allowance };
        self.cut.clear();
        self.cleared = if self.region.cleared { heights.rough_floor() } else { heights.reference };
        self.floor_of(part, least, self.cleared, finish.feed);
        self.up();
    }

    fn floor_of(&mut self, part: &Part, least: f64, above: f64, feed: Feed) {
        let heights = self.region.mill.heights;
        for inner in &part.inner {
            self.floor_of(inner, least, above, feed);
        }
        if part.inner.is_empty() {
            let entry = entry_of(part, least);
            self.go_over(entry.at);
            self.cutter.lift(heights.above_cleared(above));
            self.cutter.plunge(heights.depth);
            self.at = Some(entry.at);
            self.go_on(&entry, feed);
        }
        for ring in part.loops() {
            self.ring(ring, least, heights.depth, feed);
        }
    }
}
