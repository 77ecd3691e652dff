//! The path of the cutter along the rings of a pocket.

use crate::geo::{Deg, Element, Point2, Vec2, left};
use crate::ir::Feed;
use crate::ir::cycle::Region;
use crate::ir::cycle::milling::{MOST_LEVELS, parts};
use crate::ir::cycle::pocket::{Finish, Insertion};

use super::course::{Course, Reach};
use super::loops::Loop;
use super::rooms::Entry;
use super::walls::Walls;
use super::{Cutter, NOTHING, SMALLEST_APPROACH, strokes};

pub struct Tool<'a> {
    region: &'a Region,
    walls: &'a Walls,
    pub cutter: Cutter<'a>,
    /// In which outline the tool works.
    outline: Option<usize>,
    /// The tool stands at the safety distance over the pocket.
    is_over: bool,
    /// The tool stands on a level.
    is_down: bool,
}

impl<'a> Tool<'a> {
    pub fn new(region: &'a Region, walls: &'a Walls, cutter: Cutter<'a>) -> Tool<'a> {
        Tool { region, walls, cutter, outline: None, is_over: false, is_down: false }
    }

    /// A room, level by level.
    pub fn rough(&mut self, course: &Course) {
        let heights = self.region.mill.heights;
        self.begin(course.outline);
        let mut from = heights.reference;
        for level in heights.levels() {
            if let Some(entry) = &course.entry {
                self.insert_into(entry, from, level);
            }
            self.cuts(course, (from, level), self.region.mill.feeds.plane);
            from = level;
        }
    }

    /// From one outline to the next the tool goes over the retract height.
    pub fn begin(&mut self, outline: usize) {
        if self.outline.replace(outline) != Some(outline) {
            self.is_over = false;
        }
    }

    /// The cuts of a level, and up from there; above it the ground is cleared down to another height.
    fn cuts(&mut self, course: &Course, (cleared, level): (f64, f64), feed: Feed) {
        let heights = self.region.mill.heights;
        for cut in &course.cuts {
            let (over, ground) = match &cut.reach {
                Reach::Floor(way) => {
                    self.cutter.follow(way, feed);
                    (None, level)
                }
                Reach::Over(place) => (Some(*place), level),
                Reach::Solid => (Some(cut.start()), cleared),
            };
            if let Some(place) = over {
                self.go_over(place);
                self.cutter.lift(heights.above_cleared(ground));
                self.cutter.plunge(level);
            }
            self.cutter.line(cut.start(), feed);
            self.cutter.follow(&cut.elements, feed);
            self.is_down = true;
        }
        self.up();
    }

    /// Up from a level, and to the safety distance.
    fn up(&mut self) {
        if std::mem::take(&mut self.is_down) {
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

    /// Into solid material, from one level to the next.
    fn insert_into(&mut self, entry: &Entry, from: f64, to: f64) {
        let heights = self.region.mill.heights;
        let begin = self.region.begin_of(entry);
        self.go_over(begin);
        if self.region.insertion == Insertion::Predrilled {
            self.cutter.lift(to);
        } else {
            self.cutter.lift(if from == heights.reference { heights.safe() } else { heights.above_cleared(from) });
            self.down(begin, entry, from, to);
        }
        self.is_down = true;
        self.go_on(entry, self.region.mill.feeds.plane);
    }

    /// From a start point that was asked for to where the rings begin.
    fn go_on(&mut self, entry: &Entry, feed: Feed) {
        if let Some(then) = entry.then {
            // Straight from the middle of the insertion, as it was found to be free.
            self.cutter.line(entry.at, feed);
            self.cutter.line(then, feed);
        }
    }

    fn down(&mut self, begin: Point2, entry: &Entry, from: f64, to: f64) {
        let feed = self.region.insertion_feed.unwrap_or(self.region.mill.feeds.depth);
        let ccw = self.region.counter_clockwise;
        match (self.region.insertion, entry.stroke) {
            (Insertion::Helix { pitch, .. }, _) if begin != entry.at => {
                self.cutter.plunge(from);
                let turns = parts((from - to).abs(), pitch).min(MOST_LEVELS) as u32;
                self.cutter.helix(entry.at, ccw, turns, to, feed);
                self.cutter.arc(begin, entry.at, ccw, feed);
            }
            (Insertion::Ramp { angle, .. }, Some(end)) => {
                self.cutter.plunge(from);
                self.sway(&Element::Line { from: begin, to: end }, (from, to), strokes_down(angle, from, to), feed);
            }
            _ => self.cutter.sink(to, feed),
        }
    }

    /// To and fro, once more on the level, and back to where it begins.
    fn sway(&mut self, there: &Element, (from, to): (f64, f64), strokes: impl Fn(f64) -> usize, feed: Feed) {
        let back = there.reversed();
        let strokes = strokes(there.length());
        for stroke in 1..=strokes + 1 {
            let done = stroke.min(strokes) as f64 / strokes as f64;
            let height = if stroke >= strokes { to } else { from + (to - from) * done };
            self.cutter.fall(if stroke % 2 == 1 { there } else { &back }, height, feed);
        }
        if strokes.is_multiple_of(2) {
            self.cutter.line(there.from(), feed);
        }
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
            self.is_down = true;
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
    pub fn floor(&mut self, course: &Course, finish: &Finish) {
        let heights = self.region.mill.heights;
        let cleared = if self.region.cleared { heights.rough_floor() } else { heights.reference };
        self.begin(course.outline);
        if let Some(entry) = &course.entry {
            self.go_over(entry.at);
            self.cutter.lift(heights.above_cleared(cleared));
            self.cutter.plunge(heights.depth);
            self.is_down = true;
            self.go_on(entry, finish.feed);
        }
        self.cuts(course, (cleared, heights.depth), finish.feed);
    }
}

/// How many strokes of a length lead down, no steeper than an angle.
fn strokes_down(angle: Deg, from: f64, to: f64) -> impl Fn(f64) -> usize {
    move |length| strokes((from - to).abs(), length, angle)
}
