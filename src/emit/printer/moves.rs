//! Moves: lines, threads, arcs, lines instead of arcs.

use crate::diag::codes;
use crate::geo::{Point2, turned};
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Feed, Origin};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};

use super::super::arc::{self, Printed};
use super::super::modal::FeedKind;
use super::Printer;

/// Most lines that replace an arc.
const MOST_CHORDS: f64 = 10_000.0;

impl Printer<'_> {
    /// The axes of a straight move that change, or nothing. `lead` in units.
    pub(super) fn straight(&mut self, word: &str, mv: &Move, lead: Option<(u8, i64)>, origin: &Origin) {
        let mut ends = [0; AXES];
        let mut changed = AxisSet::EMPTY;
        for axis in mv.axes.iter() {
            let Some(value) = mv.end.get(axis) else { continue };
            let Some(units) = self.places.units(value) else { return self.unprintable(origin) };
            ends[axis.index()] = units;
            if mv.machine || !self.modal.says(axis, units) {
                changed.insert(axis);
            }
        }
        if changed.is_empty() {
            return;
        }
        let Ok(feed) = mv.path.feed().map_or(Ok(None), |feed| self.feed_word(feed, origin)) else { return };
        if mv.machine {
            self.page.text.word(self.target.motion.machine);
        }
        self.page.text.word(word);
        for axis in changed.iter() {
            self.axis_word(axis, ends[axis.index()]);
        }
        if let Some((address, units)) = lead {
            self.page.text.number(address, units, self.places);
        }
        if let Some(units) = feed {
            self.page.text.number(self.target.feed.address, units, self.places);
        }
        self.page.end_line(origin);
        self.compensation.straight();
        if mv.machine {
            self.modal.forget(changed);
        } else {
            self.modal.reach(changed, &ends);
        }
    }

    /// An axis with its coordinate in units.
    #[inline]
    fn axis_word(&mut self, axis: Axis, units: i64) {
        let units = if self.diameter && axis == Axis::X { 2 * units } else { units };
        self.page.text.number(axis.letter() as u8, units, self.places);
    }

    /// A line in step with the spindle.
    pub(super) fn thread(&mut self, lead: f64, mv: &Move, origin: &Origin) {
        let Some((word, address)) = self.target.motion.thread else {
            return self.lacks(codes::O9001, origin, "threads");
        };
        let lead = self.places.units(lead).filter(|units| *units > 0);
        let Some(lead) = lead else {
            return self.report(codes::O1003, origin, "the lead of this thread prints as zero or not at all");
        };
        let before = self.page.lines();
        self.straight(word, mv, Some((address, lead)), origin);
        if self.page.lines() == before && !self.diags.has_errors() {
            self.report(codes::O1003, origin, "the thread has no length that can be printed");
        }
    }

    #[cold]
    pub(super) fn unprintable(&mut self, origin: &Origin) {
        self.page.text.drop_line();
        self.report(codes::O1002, origin, "a number of this block is too large to print");
    }

    /// The F word where it changes; a change of its kind gets a line of its own.
    #[inline]
    fn feed_word(&mut self, feed: Feed, origin: &Origin) -> Result<Option<i64>, ()> {
        let units = self.places.units(feed.value()).filter(|units| *units > 0);
        let Some(units) = units else {
            self.report(codes::O1001, origin, &format!("the feed {} prints as zero or not at all", feed.value()));
            return Err(());
        };
        let kind = FeedKind::of(feed);
        if self.modal.feed_kind_changes(kind) {
            let Some(word) = kind.word(&self.target.feed) else {
                self.lacks(codes::O9001, origin, "this kind of feed");
                return Err(());
            };
            self.page.words(word, origin);
        }
        Ok(self.modal.feed_changes(kind, units).then_some(units))
    }

    pub(super) fn arc(&mut self, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        let (first, second, _) = arc.plane.axes();
        let scale = self.places.scale();
        let (x, y) = (Axis::ALL[first], Axis::ALL[second]);
        let from = self.modal.place(x).zip(self.modal.place(y));
        let (Some(to), Some(from)) = (mv.end.in_plane(arc.plane), from) else {
            // Only a refused block leaves an arc without a start, and that was reported.
            if !self.diags.has_errors() {
                self.report(codes::O1002, origin, "the start of this arc was not printed");
            }
            return;
        };
        let (Some(to_x), Some(to_y)) = (self.places.units(to.x), self.places.units(to.y)) else {
            return self.unprintable(origin);
        };
        let (Some(_), Some(_)) = (self.places.units(arc.center.x), self.places.units(arc.center.y)) else {
            return self.unprintable(origin);
        };
        let words = &self.target.arcs;
        let request = arc::Request {
            from: [from.0, from.1],
            to: [to_x, to_y],
            center: Point2::new(arc.center.x * scale, arc.center.y * scale),
            sweep: arc.sweep,
            tolerance: words.tolerance,
            least_radius: words.least_radius * scale,
        };
        let (offset, turns) = match arc::fit(&request) {
            Printed::Arc { offset, turns } => (offset, turns),
            Printed::Nothing => {
                self.report(codes::O4002, origin, "the arc is shorter than the last printed digit and is left out");
                let straight = Move { path: Path::Line(feed), ..*mv };
                return self.straight(self.target.motion.line, &straight, None, origin);
            }
            Printed::Lines => return self.chords(arc, feed, mv, origin),
        };
        self.select_plane(arc.plane, origin);
        let Ok(feed) = self.feed_word(feed, origin) else { return };
        let mut ends = *self.modal.at();
        let mut printed = AxisSet::of(x).union(AxisSet::of(y));
        for axis in mv.axes.without(printed).iter() {
            let Some(units) = mv.end.get(axis).and_then(|value| self.places.units(value)) else {
                return self.unprintable(origin);
            };
            if !self.modal.says(axis, units) {
                ends[axis.index()] = units;
                printed.insert(axis);
            }
        }
        (ends[first], ends[second]) = (to_x, to_y);
        self.page.text.word(if arc.sweep > 0.0 { words.counter_clockwise } else { words.clockwise });
        for axis in printed.iter() {
            self.axis_word(axis, ends[axis.index()]);
        }
        let mut offsets = [(first, offset[0]), (second, offset[1])];
        offsets.sort_by_key(|(axis, _)| *axis);
        for (axis, units) in offsets {
            self.page.text.number(words.center[axis], units, self.places);
        }
        if let (Some(address), true) = (words.turns, turns > 1) {
            self.page.text.whole(address, u64::from(turns));
        }
        if let Some(units) = feed {
            self.page.text.number(self.target.feed.address, units, self.places);
        }
        self.page.end_line(origin);
        self.modal.reach(printed, &ends);
    }

    /// Straight lines instead of an arc that does not fit the printed grid.
    #[cold]
    fn chords(&mut self, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        self.report(codes::O4001, origin, "the arc is too small for its printed numbers and is printed as lines");
        let radius = crate::geo::distance(arc.from, arc.center);
        let unit = 1.0 / self.places.scale();
        // A chord leaves the arc by r·(1 - cos(a/2)).
        let step = 2.0 * libm::acos((1.0 - unit / (2.0 * radius)).max(0.0));
        let count = libm::ceil(arc.sweep.abs() / step.max(1e-6)).clamp(1.0, MOST_CHORDS);
        let (x, y, _) = arc.plane.axes();
        let (x, y) = (Axis::ALL[x], Axis::ALL[y]);
        let start: Vec<(Axis, i64)> = mv.axes.iter().map(|axis| (axis, self.modal.at()[axis.index()])).collect();
        for i in 1..=count as u32 {
            let t = f64::from(i) / count;
            let mut point = *mv;
            // Equal chords share the time.
            point.path = Path::Line(match feed {
                Feed::InverseTime(f) => Feed::InverseTime(f * count),
                Feed::PerMinute(_) | Feed::PerRevolution(_) => feed,
            });
            if t < 1.0 {
                let p = arc.center + turned(arc.from - arc.center, arc.sweep * t);
                for &(axis, from) in &start {
                    let from = from as f64 * unit;
                    let end = mv.end.get(axis).unwrap_or(from);
                    let value = match axis {
                        _ if axis == x => p.x,
                        _ if axis == y => p.y,
                        _ => from + (end - from) * t,
                    };
                    point.end.set(axis, value);
                }
            }
            self.straight(self.target.motion.line, &point, None, origin);
        }
    }
}
