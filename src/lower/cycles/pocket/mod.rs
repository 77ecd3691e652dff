//! Pockets and slots: insertion, rings from inside out, level by level; then the wall, then the floor.

mod area;
mod helical;
#[cfg(test)]
mod tests;

use crate::diag::{Fault, codes};
use crate::geo::{Deg, Element, Point2, left};
use crate::ir::Feed;
use crate::ir::cycle::Family;
use crate::ir::cycle::milling::{MOST_LEVELS, Place, parts};
use crate::ir::cycle::pocket::{Finish, Insertion, LevelChange, Pocket, Shape, Strategy, WallApproach};

use super::cutter::Cutter;
use super::{CycleItem, Expand, Start};
use area::{Area, Ring, reversed};

/// Smaller arcs of approach are straight lines, mm.
const SMALLEST_APPROACH: f64 = 0.1;

impl Expand for Pocket {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3321::pocket_makes_no_path(&fault))?;
        let rough = self.rough.then(|| Area::new(self, self.rough_distance()));
        if let Some(area) = &rough
            && let Insertion::Ramp { angle, .. } = self.insertion
            && strokes(self.level_step(), area.sway.length(), angle) > MOST_LEVELS
        {
            return Err(endless_strokes());
        }
        let Some(first) = self.places.first() else { return Ok(()) };
        let mut tool = Tool { pocket: self, cutter: Cutter::new(&self.mill, *first, start, out), is_over: false };
        for (at, place) in self.places.iter().enumerate() {
            tool.cutter.go_on_at(*place);
            if let Some(feed) = self.transfer.filter(|_| at > 0) {
                tool.cutter.arc(self.shape.entry(), Point2::origin(), true, feed);
            }
            match (&rough, self.strategy) {
                (Some(area), Strategy::Levels) => tool.rough(area),
                (Some(area), Strategy::Helix) => tool.rough_on_helices(area),
                (None, _) => {}
            }
            if let Some(finish) = &self.finish {
                tool.finish(finish);
            }
            tool.cutter.retract();
            tool.is_over = false;
        }
        if let Some(home) = self.home {
            tool.cutter.go_on_at(Place::HERE);
            tool.cutter.rapid(home);
        }
        Ok(())
    }
}

/// Strokes of this length that fall by at most `angle`, from one level to the next; an angle of 0 asks for one.
pub fn strokes(step: f64, length: f64, angle: Deg) -> usize {
    parts(step, length * libm::tan(angle.radians()))
}

pub fn endless_strokes() -> Fault {
    codes::G3321::angle_of_insertion_is_so_small()
}

impl Pocket {
    fn level_step(&self) -> f64 {
        let heights = &self.mill.heights;
        (heights.reference - heights.rough_floor()).abs() / heights.levels().len() as f64
    }
}

struct Tool<'a> {
    pocket: &'a Pocket,
    cutter: Cutter<'a>,
    /// The tool stands at the safety distance over the place.
    is_over: bool,
}

impl Tool<'_> {
    fn rough(&mut self, area: &Area) {
        let heights = self.pocket.mill.heights;
        let feed = self.pocket.mill.feeds.plane;
        let mut from = heights.reference;
        for level in heights.levels() {
            let point = self.insertion_point(area, level);
            if from == heights.reference {
                self.go_over(point);
            } else {
                self.next(area, point, from);
            }
            self.insert(area, from, level);
            if matches!(self.pocket.insertion, Insertion::Strokes { .. }) {
                continue;
            }
            self.rings(area, feed, |pocket, ring| pocket.is_cleared(ring.half, ring.corner, level));
            from = level;
        }
        match self.pocket.between {
            _ if matches!(self.pocket.insertion, Insertion::Strokes { .. }) => {
                self.half_a_stroke(area, feed);
                self.cutter.lift(heights.safe());
            }
            LevelChange::Straight => {
                self.back(area, area.entry, feed);
                self.cutter.lift(heights.safe());
            }
            LevelChange::Lifted => {
                self.off_the_ring(area);
                self.cutter.lift(heights.safe());
                self.cutter.rapid(area.entry);
            }
        }
    }

    /// From the end of the level `from` over `point`.
    fn next(&mut self, area: &Area, point: Point2, from: f64) {
        let heights = self.pocket.mill.heights;
        match self.pocket.between {
            LevelChange::Straight => self.back(area, point, self.pocket.mill.feeds.plane),
            LevelChange::Lifted => {
                self.off_the_ring(area);
                // The straight way back leads over the material inside a bow.
                let is_bow = matches!(self.pocket.shape, Shape::Bow { .. });
                self.cutter.lift(if is_bow { heights.safe() } else { heights.above_cleared(from) });
                self.cutter.rapid(point);
                self.cutter.lift(heights.above_cleared(from));
            }
        }
    }

    /// Off the last ring on a quarter of a circle.
    fn off_the_ring(&mut self, area: &Area) {
        let pocket = self.pocket;
        let room = pocket.shape.room(pocket.rough_distance()).least();
        let radius = pocket.approach_radius().min(room);
        let Some(ring) = area.rings.last().filter(|_| radius >= SMALLEST_APPROACH) else { return };
        let Some(along) = ring.elements.first().and_then(Element::start_direction) else { return };
        let ccw = pocket.counter_clockwise;
        let inward = if ccw { left(along) } else { -left(along) };
        let center = ring.start() + inward * radius;
        self.cutter.arc(center + along * radius, center, ccw, pocket.mill.feeds.plane);
    }

    /// Over `point`, at the safety distance above the surface.
    fn go_over(&mut self, point: Point2) {
        if std::mem::replace(&mut self.is_over, true) {
            self.cutter.rapid(point);
        } else {
            self.cutter.approach(point);
        }
    }

    /// Where the way to a level begins.
    fn insertion_point(&self, area: &Area, level: f64) -> Point2 {
        match self.pocket.insertion {
            Insertion::Helix { radius, .. } if !self.enters_cleared(level) => area.entry + self.helix_arm(area, radius),
            Insertion::Ramp { .. } | Insertion::Strokes { .. } if !self.enters_cleared(level) => area.sway.from(),
            _ => area.entry,
        }
    }

    /// Is the entry free down to this level?
    fn enters_cleared(&self, level: f64) -> bool {
        self.pocket.is_cleared([0.0; 2], 0.0, level)
    }

    /// From the entry to the start of the helix: on the long axis.
    fn helix_arm(&self, area: &Area, radius: f64) -> crate::geo::Vec2 {
        let along = area.sway.start_direction().unwrap_or_else(crate::geo::Vec2::x);
        along * self.pocket.helix_radius(radius)
    }

    /// From one level to the next, over the insertion point.
    fn insert(&mut self, area: &Area, from: f64, to: f64) {
        let heights = &self.pocket.mill.heights;
        let feed = self.pocket.mill.feeds.depth;
        if self.enters_cleared(to) {
            self.cutter.lift(heights.above_cleared(to));
            return self.cutter.plunge(to);
        }
        match self.pocket.insertion {
            Insertion::Predrilled => self.cutter.lift(to),
            Insertion::Vertical => self.cutter.plunge(to),
            Insertion::Helix { radius, pitch } => {
                let arm = self.helix_arm(area, radius);
                self.cutter.plunge(from);
                if crate::geo::length(arm) < SMALLEST_APPROACH {
                    return self.cutter.plunge(to);
                }
                let (center, ccw) = (area.entry, self.pocket.counter_clockwise);
                let turns = parts((from - to).abs(), pitch).min(MOST_LEVELS) as u32;
                self.cutter.helix(center, ccw, turns, to, feed);
                self.cutter.arc(center + arm, center, ccw, feed);
            }
            Insertion::Ramp { angle, .. } => {
                self.cutter.plunge(from);
                let strokes = strokes((from - to).abs(), area.sway.length(), angle);
                let height = |stroke: usize| from + (to - from) * stroke as f64 / strokes as f64;
                self.sway(&area.sway, (1..strokes).map(height).chain([to]), feed);
            }
            Insertion::Strokes { fall } => {
                let feed = self.pocket.mill.feeds.plane;
                self.cutter.sink(from, feed);
                self.sway(&area.sway, heights.levels_to(to, fall).into_iter(), feed);
            }
        }
    }

    /// To and fro along `line`, down to these heights, one stroke more on the last of them.
    fn sway(&mut self, line: &Element, heights: impl Iterator<Item = f64>, feed: Feed) {
        let back = reversed(line);
        let mut ways = [line, &back].into_iter().cycle();
        let mut last = None;
        // The last height ends the pairs, so that no way is lost.
        for (height, way) in heights.zip(ways.by_ref()) {
            self.cutter.fall(way, height, feed);
            last = Some(height);
        }
        if let (Some(way), Some(height)) = (ways.next(), last) {
            self.cutter.fall(way, height, feed);
        }
    }

    /// From the end of the last stroke to the middle of the slot.
    fn half_a_stroke(&mut self, area: &Area, feed: Feed) {
        let Some(core) = &area.core else { return };
        let way = if self.cutter.stands_at(core.to()) { reversed(core) } else { *core };
        self.cutter.element(&way.ending_at(way.middle()), feed);
    }

    /// From the last ring to `point` on cleared ground: along an arc of the middle line, which alone lies open there.
    fn back(&mut self, area: &Area, point: Point2, feed: Feed) {
        if let Some(core @ Element::Arc { .. }) = &area.core {
            self.cutter.line(core.to(), feed);
            self.cutter.element(&reversed(core), feed);
        }
        self.cutter.line(point, feed);
    }

    /// The innermost line, and the rings from inside out.
    fn rings(&mut self, area: &Area, feed: Feed, skip: impl Fn(&Pocket, &Ring) -> bool) {
        let from_inside = !area.rings.first().is_some_and(|ring| skip(self.pocket, ring));
        if let Some(core) = area.core.as_ref().filter(|core| from_inside && !self.cutter.stands_at(core.to())) {
            self.cutter.line(core.from(), feed);
            self.cutter.element(core, feed);
        }
        for ring in area.rings.iter().filter(|ring| !skip(self.pocket, ring)) {
            self.cutter.line(ring.start(), feed);
            self.cutter.follow(&ring.elements, feed);
        }
    }

    fn finish(&mut self, finish: &Finish) {
        if let Some(speed) = finish.speed {
            self.cutter.speed(speed.finishing);
        }
        let distance = self.pocket.mill.radius;
        let last = Area::new(self.pocket, if finish.wall { distance } else { self.pocket.rough_distance() });
        if finish.wall && self.pocket.strategy == Strategy::Helix {
            self.finish_on_helix(finish, &last);
        } else {
            if finish.wall {
                self.wall(finish, &last);
            }
            if finish.floor {
                self.floor(finish, &last);
            }
        }
        if let Some(after) = finish.speed.and_then(|speed| speed.after) {
            self.cutter.speed(after);
        }
    }

    /// The wall, down to what is left for the floor.
    fn wall(&mut self, finish: &Finish, area: &Area) {
        let heights = &self.pocket.mill.heights;
        let roughed = self.pocket.rough && self.pocket.between == LevelChange::Lifted;
        let mut above = heights.safe();
        for level in heights.levels_to(heights.rough_floor(), finish.step) {
            if roughed {
                above = heights.above_cleared(level);
            }
            match area.rings.last() {
                Some(ring) => self.wall_at(area, ring, (above, level), finish.feed),
                None => self.line_at(area, above, level, finish.feed),
            }
            self.cutter.lift(heights.safe());
            above = heights.above_cleared(level);
        }
        self.cutter.rapid(area.entry);
    }

    /// Onto the wall and off it on arcs that touch it.
    fn wall_at(&mut self, area: &Area, ring: &Ring, (above, level): (f64, f64), feed: Feed) {
        let (Some(first), radius) = (ring.elements.first(), self.pocket.approach_radius()) else { return };
        let Some(along) = first.start_direction() else { return };
        let (touch, ccw) = (ring.start(), self.pocket.counter_clockwise);
        let inward = if ccw { left(along) } else { -left(along) };
        let center = touch + inward * radius;
        let semicircle = self.pocket.finish.is_some_and(|finish| finish.onto == WallApproach::Semicircle);
        let (from, to) = match radius < SMALLEST_APPROACH {
            true => (center, center),
            false if semicircle => (center + inward * radius, center + inward * radius),
            false => (center - along * radius, center + along * radius),
        };
        // In the middle all is cleared, beside the wall there may be an allowance.
        let down = match self.pocket.between {
            LevelChange::Straight => from,
            LevelChange::Lifted => area.core.as_ref().map_or(area.entry, Element::to),
        };
        self.over(down, above);
        self.cutter.plunge(level);
        self.cutter.line(from, feed);
        if radius < SMALLEST_APPROACH {
            self.cutter.line(touch, feed);
            self.cutter.follow(&ring.elements, feed);
            return self.cutter.line(to, feed);
        }
        self.cutter.arc(touch, center, ccw, feed);
        self.cutter.follow(&ring.elements, feed);
        self.cutter.arc(to, center, ccw, feed);
    }

    /// The wall of a slot that is as wide as the cutter.
    fn line_at(&mut self, area: &Area, above: f64, level: f64, feed: Feed) {
        self.over(area.entry, above);
        self.cutter.plunge(level);
        if let Some(core) = &area.core {
            self.cutter.line(core.from(), feed);
            self.cutter.element(core, feed);
        }
    }

    /// At the safety distance over `point`, and down through what is cleared.
    fn over(&mut self, point: Point2, above: f64) {
        self.go_over(point);
        self.cutter.lift(above);
    }

    /// The floor, from inside out.
    fn floor(&mut self, finish: &Finish, area: &Area) {
        let heights = &self.pocket.mill.heights;
        let (above, inserts) = (heights.rough_floor(), finish.inserts);
        let point = if inserts { self.insertion_point(area, heights.depth) } else { area.entry };
        self.over(point, heights.above_cleared(above));
        if inserts {
            self.insert(area, above, heights.depth);
        } else {
            self.cutter.plunge(heights.depth);
        }
        self.rings(area, finish.feed, |_, _| false);
        self.back(area, area.entry, finish.feed);
        self.cutter.lift(heights.safe());
    }
}
