//! Pockets along a contour with islands: rings at growing distances from the walls, cut from inside out.

mod carriers;
mod loops;
mod pilot_holes;
mod rest;
mod walls;

use crate::diag::codes;
use crate::geo::area::reversed;
use crate::geo::{Deg, Element, Point2, Vec2, distance, left};
use crate::ir::Feed;
use crate::ir::cycle::milling::{MOST_LEVELS, Place, parts};
use crate::ir::cycle::pocket::{Finish, Insertion, Onto};
use crate::ir::cycle::{Family, Region};

use super::cutter::Cutter;
use super::pocket::{endless_strokes, strokes};
use super::track::Failure;
use super::{CycleItem, Expand, Start};
use loops::{Area, Entry, Loop, Part};
use rest::{Cleared, Meets};
use walls::{Walls, roomiest};

/// Rooms for less than this are none, mm.
const NOTHING: f64 = 1e-4;
/// Radius of the arc on which a wall is approached, mm; it becomes smaller where the walls are near.
const APPROACH: f64 = 2.0;
const SMALLEST_APPROACH: f64 = 0.1;
/// Directions in which strokes to and fro are tried.
const STROKE_DIRECTIONS: u32 = 72;
/// How much the room of a place may lose against the step of the rings, mm.
const ROOM: f64 = 5e-3;
/// Links longer than so many widths of a cut are ways through the air.
const LONGEST_LINK: f64 = 2.5;

impl Expand for Region {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Failure> {
        let help = "check the contour, the data of the cutter, and the allowances";
        self.check().map_err(|fault| Failure::new(codes::G3321, fault.to_string(), help))?;
        let walls = Walls::new(self.walls().copied().collect());
        let area = Area::new(&self.outlines, &self.islands);
        let radius = self.mill.radius;
        // All rings are known before the tool moves.
        let mut rough = match self.rough {
            true => self.rings(&area, &walls, radius + self.allowance)?,
            false => Vec::new(),
        };
        if let Some(coarse) = &self.coarse {
            Cleared::new(coarse, radius).ok_or_else(unproved)?.look_along(&mut rough);
        }
        let floor = match self.finish {
            Some(Finish { floor: true, wall, .. }) => {
                self.rings(&area, &walls, radius + if wall { self.left } else { self.allowance })?
            }
            _ => Vec::new(),
        };
        let wall = match self.finish {
            Some(Finish { wall: true, .. }) => area.parts(radius + self.left, &walls).ok_or_else(unproved)?,
            _ => Vec::new(),
        };
        if self.finish.is_some_and(|finish| finish.wall) && !area.has_all(&wall) {
            return Err(no_room());
        }
        for part in &rough {
            self.check_insertion(part, radius + self.allowance)?;
        }
        if self.insertion != Insertion::Vertical && self.insertion != Insertion::Predrilled {
            // A cutter that cannot go straight down must not have to.
            let mut nothing = |_: CycleItem| ();
            let mut tool = Tool::new(self, &walls, Cutter::new(&self.mill, Place::HERE, start, &mut nothing));
            tool.rough(&rough);
            if tool.is_plunged {
                return Err(no_insertion("a ring of the pocket can only be reached straight down"));
            }
        }
        let mut tool = Tool::new(self, &walls, Cutter::new(&self.mill, Place::HERE, start, out));
        tool.rough(&rough);
        if let Some(finish) = &self.finish {
            if let Some(speed) = finish.speed {
                tool.cutter.speed(speed.finishing);
            }
            for part in &wall {
                let most = match finish.onto {
                    Onto::Quarter(most) => Some(self.widest_arc(part, &walls).min(most)),
                    Onto::Usual | Onto::Semicircle => None,
                };
                tool.begin(part);
                for ring in part.loops() {
                    tool.wall(ring, finish, most.unwrap_or(APPROACH));
                }
            }
            for part in &floor {
                tool.begin(part);
                tool.floor(part, finish);
            }
            if let Some(after) = finish.speed.and_then(|speed| speed.after) {
                tool.cutter.speed(after);
            }
        }
        tool.cutter.retract();
        Ok(())
    }
}

fn no_room() -> Failure {
    Failure::new(
        codes::G3321,
        "the cutter finds no room between the walls of the contour",
        "take a smaller cutter, or a smaller allowance",
    )
}

fn start_point() -> Failure {
    Failure::new(
        codes::G3321,
        "from the start point no straight way leads between the walls to where the rings begin",
        "give a start point farther from the walls, or leave the choice to the cycle",
    )
}

fn no_insertion(what: &str) -> Failure {
    Failure::new(codes::G3321, what, "take a smaller cutter, or go straight down, which needs a cutter that can plunge")
}

fn unproved() -> Failure {
    Failure::new(
        codes::G3321,
        "the rings along the contour do not keep their distance from it",
        "move an end point of the contour a little, or take another infeed in the plane",
    )
}

impl Region {
    /// Parts of the area at `least` from the walls, with all that lies deeper.
    fn rings(&self, area: &Area, walls: &Walls, least: f64) -> Result<Vec<Part>, Failure> {
        let roots = area.parts(least, walls).ok_or_else(unproved)?;
        if !area.has_all(&roots) {
            return Err(no_room());
        }
        let mut most = 0.0f64;
        for root in &roots {
            most = most.max(entry(root, walls).ok_or_else(unproved)?.room - least);
        }
        // Every point between two rings is at most a step from the outer one: a step of a radius leaves nothing.
        let count = parts(most, self.width.min(self.mill.radius));
        let step = most / count as f64;
        let mut levels = vec![roots];
        for j in 1..count {
            levels.push(area.parts(least + step * j as f64, walls).ok_or_else(unproved)?);
        }
        let mut inner: Vec<Part> = Vec::new();
        while let Some(mut outer) = levels.pop() {
            for part in inner {
                let at = part.outer.start();
                outer.iter_mut().find(|holder| holder.holds(at)).ok_or_else(unproved)?.inner.push(part);
            }
            inner = outer;
        }
        let mut taken = self.start.is_none();
        for part in &mut inner {
            self.enter(part, walls, (least, step), &mut taken)?;
        }
        if taken { Ok(inner) } else { Err(start_point()) }
    }

    /// Half of the room that the cutter has between the walls of a part.
    fn widest_arc(&self, part: &Part, walls: &Walls) -> f64 {
        entry(part, walls).map_or(0.0, |entry| (entry.room - part.away) / 2.0)
    }

    /// Radius of the helix at a place that is `room` from the walls; 0 for one straight down.
    fn helix_arm(&self, room: f64, least: f64) -> f64 {
        match self.insertion {
            Insertion::Helix { radius, .. } => radius.min(room - least).min(self.mill.radius).max(0.0),
            Insertion::Predrilled | Insertion::Vertical | Insertion::Sway { .. } | Insertion::Strokes { .. } => 0.0,
        }
    }

    /// The longest way from a place on which strokes to and fro keep off the walls, up to two diameters of the cutter.
    fn stroke(&self, from: Point2, walls: &Walls, least: f64) -> Option<Point2> {
        let lengths = [4.0, 3.0, 2.0, 1.0, 0.5, 0.25].map(|part| part * self.mill.radius);
        lengths.into_iter().find_map(|length| {
            let ends = (0..STROKE_DIRECTIONS).map(|i| {
                let (sin, cos) = Deg(360.0 * f64::from(i) / f64::from(STROKE_DIRECTIONS)).sin_cos();
                Point2::new(from.x + length * cos, from.y + length * sin)
            });
            ends.into_iter().find(|end| walls.is_free(from, *end, least))
        })
    }

    /// Is there room for the insertion, and does it end?
    fn check_insertion(&self, part: &Part, least: f64) -> Result<(), Failure> {
        for inner in &part.inner {
            self.check_insertion(inner, least)?;
        }
        let Some(entry) = part.entry.filter(|_| part.is_inserted()) else { return Ok(()) };
        let step = self.mill.heights.way() / self.mill.heights.levels().len() as f64;
        match (self.insertion, entry.stroke) {
            (Insertion::Helix { radius, .. }, _)
                if radius >= SMALLEST_APPROACH && self.helix_arm(entry.room, least) < SMALLEST_APPROACH =>
            {
                Err(no_insertion("the walls leave no room for the helix"))
            }
            (Insertion::Sway { .. }, None) => Err(no_insertion("the walls leave no room for strokes to and fro")),
            (Insertion::Sway { angle, .. }, Some(end))
                if strokes(step, distance(entry.at, end), angle) > MOST_LEVELS =>
            {
                Err(endless_strokes())
            }
            _ => Ok(()),
        }
    }

    /// Finds where the tool is inserted into the parts that have nothing deeper. The start point counts for the first of them that
    /// is reached from there.
    fn enter(&self, part: &mut Part, walls: &Walls, ways: (f64, f64), taken: &mut bool) -> Result<(), Failure> {
        let (least, step) = ways;
        for inner in &mut part.inner {
            self.enter(inner, walls, ways, taken)?;
        }
        if !part.inner.is_empty() {
            return Ok(());
        }
        let found = entry(part, walls).ok_or_else(unproved)?;
        // With more room than a step there is a ring inside, or something would stay in the middle.
        if found.room > part.away + step + ROOM {
            return Err(unproved());
        }
        let stroke = |from: Point2| match self.insertion {
            Insertion::Sway { .. } if self.rough => self.stroke(from, walls, least),
            _ => None,
        };
        part.entry = Some(Entry { stroke: stroke(found.at), ..found });
        let (Some(start), false) = (self.start, *taken) else { return Ok(()) };
        let then = (!part.holds(start)).then_some(found.at);
        if then.is_none_or(|then| walls.is_free(start, then, least)) {
            part.entry = Some(Entry { at: start, room: walls.distance(start), then, stroke: stroke(start) });
            *taken = true;
        }
        Ok(())
    }
}

/// The point of a part that is farthest from the walls, and how far it is.
fn entry(part: &Part, walls: &Walls) -> Option<Entry> {
    let points = part.outer.elements.iter().flat_map(|element| [element.from(), element.middle()]);
    let (mut low, mut high) = (Point2::new(f64::MAX, f64::MAX), Point2::new(f64::MIN, f64::MIN));
    for p in points {
        low = Point2::new(low.x.min(p.x), low.y.min(p.y));
        high = Point2::new(high.x.max(p.x), high.y.max(p.y));
    }
    let found = roomiest(low, high, |p| if part.holds(p) { walls.distance(p) } else { -part.outer.away(p) });
    found.map(|(at, room)| Entry { at, room, then: None, stroke: None })
}

fn entry_of(part: &Part, least: f64) -> Entry {
    part.entry.unwrap_or(Entry { at: part.outer.start(), room: least, then: None, stroke: None })
}

struct Tool<'a> {
    region: &'a Region,
    walls: &'a Walls,
    cutter: Cutter<'a>,
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
    /// The tool went straight down to a ring in material.
    is_plunged: bool,
}

impl<'a> Tool<'a> {
    fn new(region: &'a Region, walls: &'a Walls, cutter: Cutter<'a>) -> Tool<'a> {
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
            is_plunged: false,
        }
    }

    fn rough(&mut self, parts: &[Part]) {
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
    fn begin(&mut self, part: &Part) {
        if self.outline.replace(part.outline) != Some(part.outline) {
            self.is_over = false;
        }
    }

    /// A part on one level: what lies deeper, then its own rings.
    fn level(&mut self, part: &Part, least: f64, from: f64, to: f64, feed: Feed) {
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
        let known = from_here.or_else(from_cut);
        let cleared = if known.is_some() { level } else { self.cleared };
        self.is_plunged |= known.is_none();
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
    fn wall(&mut self, ring: &Loop, finish: &Finish, arc: f64) {
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
    fn floor(&mut self, part: &Part, finish: &Finish) {
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
