//! Circular pockets on helices: circle by circle from inside out, each down to the floor.

use crate::geo::Point2;
use crate::ir::Feed;
use crate::ir::cycle::milling::{MOST_LEVELS, parts};
use crate::ir::cycle::pocket::Finish;

use super::area::Area;
use super::{SMALLEST_APPROACH, Tool};

impl Tool<'_> {
    pub(super) fn rough_on_helices(&mut self, area: &Area) {
        let heights = self.pocket.mill.heights;
        let feed = self.pocket.mill.feeds.plane;
        if area.rings.is_empty() {
            self.go_over(area.entry);
            self.cutter.plunge(heights.rough_floor());
        }
        for ring in &area.rings {
            let at = ring.start();
            self.go_over(at);
            self.cutter.plunge(heights.reference);
            self.turn_down(at, heights.rough_floor(), feed);
            self.off_the_wall(at, feed);
            self.cutter.lift(heights.safe());
        }
        self.cutter.lift(heights.safe());
        self.cutter.rapid(area.entry);
    }

    /// The wall on one helix; then the floor from outside in, or off the wall.
    pub(super) fn finish_on_helix(&mut self, finish: &Finish, area: &Area) {
        let heights = self.pocket.mill.heights;
        let floor = if finish.floor { heights.depth } else { heights.rough_floor() };
        let at = area.rings.last().map_or(area.entry, |ring| ring.start());
        let arm = self.approach_arm(at);
        self.go_over(at - arm.0 - arm.1);
        self.cutter.plunge(heights.reference);
        if arm.0.x > 0.0 {
            self.cutter.arc(at, at - arm.0, self.pocket.counter_clockwise, finish.feed);
        }
        self.turn_down(at, floor, finish.feed);
        if finish.floor {
            for ring in area.rings.iter().rev().skip(1) {
                self.cutter.line(ring.start(), finish.feed);
                self.cutter.follow(&ring.elements, finish.feed);
            }
            self.cutter.line(area.entry, finish.feed);
        } else {
            self.off_the_wall(at, finish.feed);
        }
        self.cutter.lift(heights.safe());
        self.cutter.rapid(area.entry);
    }

    /// Whole turns about the centre down to `floor`, and a full circle there.
    fn turn_down(&mut self, at: Point2, floor: f64, feed: Feed) {
        let heights = self.pocket.mill.heights;
        let (center, ccw) = (Point2::origin(), self.pocket.counter_clockwise);
        if crate::geo::distance(at, center) < SMALLEST_APPROACH / 2.0 {
            // Straight down, but no deeper at a time than turns would lead.
            for level in heights.levels_to(floor, heights.step) {
                self.cutter.plunge(level);
                if at.x > 1e-3 {
                    self.cutter.arc(at, center, ccw, feed);
                }
            }
            return;
        }
        let turns = parts((heights.reference - floor).abs(), heights.step).min(MOST_LEVELS) as u32;
        self.cutter.helix(center, ccw, turns, floor, feed);
        self.cutter.arc(at, center, ccw, feed);
    }

    fn off_the_wall(&mut self, at: Point2, feed: Feed) {
        let arm = self.approach_arm(at);
        if arm.0.x == 0.0 {
            return;
        }
        self.cutter.arc(at - arm.0 + arm.1, at - arm.0, self.pocket.counter_clockwise, feed);
    }

    /// From the centre of the arc of approach to the wall, and along the wall; of no length where there is no room.
    fn approach_arm(&self, at: Point2) -> (crate::geo::Vec2, crate::geo::Vec2) {
        let radius = self.pocket.approach_radius().min(at.x);
        let radius = if radius < SMALLEST_APPROACH { 0.0 } else { radius };
        let sense = if self.pocket.counter_clockwise { 1.0 } else { -1.0 };
        (crate::geo::Vec2::new(radius, 0.0), crate::geo::Vec2::new(0.0, radius * sense))
    }
}
