//! The cuts from the blank down to the contour.

use crate::diag::Fault;
use crate::geo::arc::NEARLY_ONE_POINT;
use crate::geo::profile::{LEVEL, Leg};
use crate::geo::{Point2, distance};
use crate::ir::cycle::layers::{ChipBreaking, Interruption, Trace};

use super::Cutter;

impl Cutter<'_> {
    /// # Errors
    /// None yet; relief cuts have some.
    pub(super) fn rough(&mut self) -> Result<(), Fault> {
        let region = self.region;
        for pair in region.levels.windows(2) {
            let (before, y) = (pair[0], pair[1]);
            self.cut(y, before);
        }
        if region.layers.trace == Trace::Last {
            self.along_contour();
        }
        Ok(())
    }

    /// To where a cut at the height `y` begins, which ends at `hit`; returns the place.
    fn enter(&mut self, y: f64, hit: f64, front: f64) -> f64 {
        let layers = self.region.layers;
        // Who begins at a corner stands clear already.
        let entry = if self.corner().is_some() { 0.0 } else { layers.clearance.entry };
        let clear = front - entry - self.region.nose();
        let begin = if hit > clear + LEVEL { clear } else { hit - layers.clearance.entry };
        self.rapid_x(begin);
        match self.corner().and_then(|corner| corner.infeed) {
            Some(feed) => self.line(Point2::new(begin, y), feed),
            None => self.rapid_y(y),
        }
        begin
    }

    /// Off the contour and back to where the cut began.
    fn back_to(&mut self, begin: f64) {
        let layers = self.region.layers;
        let way = layers.clearance.lift;
        // Who begins at a corner goes back no farther.
        let back = if self.corner().is_some() { way.min(self.at.x - begin) } else { way };
        self.lift(way, back, layers.feeds.rough);
        self.rapid_x(begin);
    }

    /// Once along the contour with its allowances, as far as the cuts go.
    fn along_contour(&mut self) {
        let region = self.region;
        let (floor, crest) = (region.floor(), region.crest);
        let place = |height: f64| region.rough.first_above(height, f64::NEG_INFINITY);
        let (Some(hit), Some(end)) = (place(floor), place(crest)) else { return };
        let feed = region.layers.feeds.rough;
        let begin = self.enter(floor, hit, region.front);
        self.line(Point2::new(hit, floor), feed);
        self.legs(&region.rough.climb(self.at, crest), feed);
        self.line(Point2::new(end.max(self.at.x), self.at.y), feed);
        self.back_to(begin);
    }

    /// One cut at the height `y`, with the way up to the cut before.
    fn cut(&mut self, y: f64, before: f64) {
        let region = self.region;
        let layers = region.layers;
        let place = |height: f64| region.rough.first_above(height, f64::NEG_INFINITY);
        let (Some(hit), Some(stop)) = (place(y), place(before)) else { return };
        let Some(front) = region.blank.first_above(y, f64::NEG_INFINITY) else { return };
        if front >= stop + region.nose() - LEVEL {
            // There is nothing between this cut and the one before.
            return;
        }
        let begin = self.enter(y, hit, front);
        self.straight(hit);
        if matches!(layers.trace, Trace::Level | Trace::Overlapping) {
            let start = self.at;
            self.legs(&region.rough.climb(start, before), layers.feeds.rough);
        }
        if layers.trace == Trace::Overlapping {
            self.overlap();
        }
        self.back_to(begin);
    }

    /// Level to `x`, with the interruptions that break the chip.
    pub(super) fn straight(&mut self, x: f64) {
        let feed = self.region.layers.feeds.rough;
        if let Some(ChipBreaking { every, by }) = self.region.layers.chips {
            let from = self.at;
            let cuts = super::infeed_steps(x - from.x, every);
            for k in 1..cuts {
                let place = Point2::new(from.x + every * k as f64, from.y);
                self.line(place, feed);
                match by {
                    Interruption::Dwell(seconds) => self.track.dwell(seconds),
                    Interruption::Retract(way) => {
                        self.rapid_x((place.x - way).max(from.x));
                        self.line(place, feed);
                    }
                }
            }
        }
        self.line(Point2::new(x, self.at.y), feed);
    }

    /// One nose radius farther along the contour, which the cuts before have freed.
    fn overlap(&mut self) {
        let region = self.region;
        let mut rest = region.nose();
        let (start, top) = (self.at, region.top());
        let mut from = start;
        let mut legs = Vec::new();
        for leg in region.rough.climb(start, top) {
            let to = leg.to();
            let length = match leg {
                Leg::Line { .. } => distance(from, to),
                Leg::Arc { center, .. } => arc_length(from, to, center),
            };
            if length >= rest {
                legs.extend(shortened(leg, from, rest, length));
                break;
            }
            legs.push(leg);
            rest -= length;
            from = to;
        }
        self.legs(&legs, region.layers.feeds.rough);
    }
}

fn arc_length(from: Point2, to: Point2, center: Point2) -> f64 {
    let radius = distance(from, center);
    2.0 * radius * libm::asin((distance(from, to) / (2.0 * radius)).min(1.0))
}

/// The first part of a leg.
fn shortened(leg: Leg, from: Point2, way: f64, length: f64) -> Option<Leg> {
    // What is shorter might be taken for a full circle.
    if way <= 2.0 * NEARLY_ONE_POINT {
        return None;
    }
    Some(match leg {
        Leg::Line { to } => Leg::Line { to: from + (to - from) * (way / length) },
        Leg::Arc { center, ccw, .. } => {
            let turn = way / distance(from, center);
            let to = center + crate::geo::turned(from - center, if ccw { turn } else { -turn });
            Leg::Arc { to, center, ccw }
        }
    })
}
