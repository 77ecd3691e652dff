//! Moves of the machine's axes that make a contour seen in others: each has the F by which the tool follows the contour at
//! its programmed feed.

use crate::diag::codes;
use crate::ir::motion::Move;
use crate::ir::{Feed, Origin};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::target::Measure;

use super::super::number::Places;
use super::Printer;

/// Places of an F below 1: where X goes little and the workpiece turns far, F is small.
const FINE: u8 = 6;

impl Printer<'_> {
    /// A part of `length` mm at `feed` along the contour. F is computed from the printed numbers.
    #[cold]
    pub(super) fn carried(&mut self, feed: f64, length: f64, mv: &Move, origin: &Origin) {
        let mut ends = [0; AXES];
        let mut changed = AxisSet::EMPTY;
        for axis in mv.axes.iter() {
            let Some(units) = mv.end.get(axis).and_then(|value| self.places.units(value)) else {
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
        let feed = match self.measured(changed, &ends) {
            Some(way) => feed * way / length,
            None => feed,
        };
        // A change of the kind of feed has a line of its own.
        if self.feed_word(Feed::PerMinute(1.0), origin).is_err() {
            return;
        }
        let places = if feed < 1.0 { Places::new(FINE) } else { self.places };
        let Some(f) = places.units(feed).filter(|units| *units > 0) else {
            return self.report(codes::O1001, origin, &format!("the feed {feed} prints as zero or not at all"));
        };
        self.page.text.word(self.target.motion.line);
        for axis in changed.iter() {
            self.axis_word(axis, ends[axis.index()]);
        }
        self.page.text.number(self.target.feed.address, f, places);
        self.page.end_line(origin);
        self.compensation.straight();
        self.modal.forget_feed();
        self.modal.reach(changed, &ends);
    }

    /// How far the target measures the way to `ends`; `None` where it measures the contour itself, because no rotary axis
    /// moves.
    fn measured(&self, changed: AxisSet, ends: &[i64; AXES]) -> Option<f64> {
        let way = |rotary: bool| {
            let of = |axis: Axis| match self.modal.place(axis) {
                Some(place) => (ends[axis.index()] - place) as f64 / self.places.scale(),
                None => 0.0,
            };
            let axes = changed.iter().filter(|axis| axis.is_rotary() == rotary);
            libm::sqrt(axes.map(|axis| of(axis) * of(axis)).sum())
        };
        let (linear, rotary) = (way(false), way(true));
        match self.target.feed.measure {
            _ if rotary == 0.0 => None,
            Measure::Linear if linear == 0.0 => Some(rotary),
            Measure::Linear => Some(linear),
        }
    }
}
