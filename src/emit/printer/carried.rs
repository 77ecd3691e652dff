//! Moves of the machine's axes that make a contour seen in others: each has the F by which the tool follows the contour at
//! its programmed feed.

use crate::diag::codes;
use crate::geo::tolerance;
use crate::ir::motion::Move;
use crate::ir::{Feed, Origin};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::target::Measure;

use super::super::modal::FeedKind;
use super::Printer;

/// Where X goes little and the workpiece turns far, F is small. Below so many units of the last place it is too coarse; then a way of
/// [`tolerance::STEP_ASIDE`], or of one unit, follows in a block of its own.
const COARSE: i64 = 100;

impl Printer<'_> {
    /// A part of `length` mm at `feed` along the contour. F is computed from the printed numbers.
    #[cold]
    pub(super) fn carried(&mut self, feed: f64, length: f64, mv: &Move, origin: &Origin) {
        let mut ends = [0; AXES];
        let mut changed = AxisSet::EMPTY;
        for axis in mv.axes.iter() {
            let Some(units) = mv.end.get(axis).and_then(|value| self.places_of(axis).units(value)) else {
                return self.unprintable(origin);
            };
            ends[axis.index()] = units;
            if !self.modal.says(axis, units) {
                changed.insert(axis);
            }
        }
        if changed.is_empty() {
            return;
        }
        let lacking = changed.without(self.axes);
        if !lacking.is_empty() {
            return self.lacks_axes(lacking, mv, origin);
        }
        if self.measures.inches || self.length.waits && changed.contains(Axis::Z) {
            return self.lacks_form(mv, origin);
        }
        // A change of the kind of feed has a line of its own.
        if self.feed_word(Feed::PerMinute(1.0), origin).is_err() {
            return;
        }
        let rotary: AxisSet = changed.iter().filter(|axis| axis.is_rotary()).collect();
        let linear = changed.without(rotary);
        let (way, turn) = (self.way(linear, &ends), self.way(rotary, &ends));
        let small = (1.0 / self.places.scale()).max(tolerance::STEP_ASIDE);
        let coarse =
            self.feed_places(FeedKind::PerMinute).units(feed * way / length).is_none_or(|units| units < COARSE);
        if turn > 0.0 && way > 0.0 && way <= small && coarse {
            self.carried_line(rotary, &ends, feed * turn / length, origin);
            return self.carried_line(linear, &ends, feed, origin);
        }
        let feed = match self.target.feed.measure {
            // The target measures the contour itself.
            _ if turn == 0.0 => feed,
            Measure::Linear if way == 0.0 => feed * turn / length,
            Measure::Linear => feed * way / length,
        };
        self.carried_line(changed, &ends, feed, origin);
    }

    fn carried_line(&mut self, axes: AxisSet, ends: &[i64; AXES], feed: f64, origin: &Origin) {
        let Some(units) = self.feed_places(FeedKind::PerMinute).units(feed).filter(|units| *units > 0) else {
            return self.say(origin, codes::O1001::feed_prints_as_zero_or_not(&feed));
        };
        if !self.is_near("feed", feed, units, self.feed_places(FeedKind::PerMinute), origin) {
            return;
        }
        self.lines.text.word(self.target.motion.line);
        for axis in axes.iter() {
            self.axis_word(axis, ends[axis.index()]);
        }
        self.lines.text.number(self.target.feed.address, units, self.feed_places(FeedKind::PerMinute));
        self.lines.end_line(origin);
        self.compensation.straight();
        self.modal.forget_feed();
        self.modal.reach(axes, ends);
    }

    /// How far `axes` go to `ends`, as printed.
    fn way(&self, axes: AxisSet, ends: &[i64; AXES]) -> f64 {
        let of = |axis: Axis| match self.modal.place(axis) {
            Some(place) => (ends[axis.index()] - place) as f64 / self.places_of(axis).scale(),
            None => 0.0,
        };
        libm::sqrt(axes.iter().map(|axis| of(axis) * of(axis)).sum())
    }
}
