//! Moves: lines, threads, arcs, lines instead of arcs.

use crate::geo::tolerance;
use core::f64::consts::TAU;

use crate::diag::codes;
use crate::geo::{Point2, turned};
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Feed, Origin};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::target::{Form, Lead, Thread, Turns};

use super::super::arc::{self, Printed};
use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;

/// Most lines that replace an arc.
const MOST_CHORDS: f64 = 1e6;
/// Lines that stand for an arc leave it by at least so much of a unit.
const LEAST_ROOM: f64 = 0.1;
/// Such a line turns by a right angle at most: the cosine of half of it.
const STEEPEST: f64 = core::f64::consts::FRAC_1_SQRT_2;
/// What a number of turns may be off a whole one.
const WHOLE: f64 = 1e-12;

/// One block of an arc, all numbers in units.
pub(super) struct ArcBlock {
    pub printed: AxisSet,
    pub ends: [i64; AXES],
    /// From the start to the centre.
    pub offset: [i64; 2],
    pub turns: u32,
}

impl Printer<'_> {
    /// The axes of a straight move that change, or nothing. `lead` in units.
    pub(super) fn straight(&mut self, word: &str, mv: &Move, lead: Option<(u8, i64)>, origin: &Origin) {
        self.straight_block(word, mv, lead, origin);
    }

    /// [`Printer::straight`] where most moves come from.
    #[inline(always)]
    pub(super) fn straight_block(&mut self, word: &str, mv: &Move, lead: Option<(u8, i64)>, origin: &Origin) {
        let mut ends = [0; AXES];
        let mut changed = AxisSet::EMPTY;
        for axis in mv.axes.iter() {
            let Some(value) = mv.end.get(axis) else { continue };
            let Some(units) = self.places_of(axis).units(value) else { return self.unprintable(origin) };
            ends[axis.index()] = units;
            if mv.machine || !self.modal.says(axis, units) {
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
        let feed = match mv.path.feed() {
            Some(feed) if !self.modal.holds(feed) => match self.feed_word(feed, origin) {
                Ok(units) => units.map(|units| (units, self.feed_places(FeedKind::of(feed)))),
                Err(()) => return,
            },
            None if self.special && self.target.motion.rapid_at_feed => match self.rapid_feed(origin) {
                Some(feed) => Some(feed),
                None => return self.pretend(mv),
            },
            _ => None,
        };
        if self.special || mv.machine {
            if !self.may_be_straight(mv, changed, origin) {
                return;
            }
            if let Form::Dialog(dialog) = self.target.form {
                return self.dialog_straight(dialog, mv, (changed, &mut ends), feed, origin);
            }
        }
        if mv.machine {
            self.lines.text.word(self.target.motion.machine.unwrap_or_default());
        }
        self.lines.text.word(word);
        if self.compensation.waits {
            self.side_words();
        }
        let length = if self.length.waits { self.length_word(mv, changed) } else { None };
        let changed = if self.special { self.spelled_out(mv, changed, &mut ends) } else { changed };
        for axis in changed.iter() {
            self.lines.text.hot_number(axis.letter() as u8, ends[axis.index()], self.places_of(axis));
        }
        if let Some((address, tool)) = length {
            self.lines.text.whole(address, u64::from(tool));
        }
        if let Some((address, units)) = lead {
            self.lines.text.number(address, units, self.measures.lead);
        }
        if let Some((units, places)) = feed {
            self.lines.text.number(self.target.feed.address, units, places);
        }
        self.lines.end_line(origin);
        self.compensation.straight();
        if mv.machine {
            self.modal.forget(changed);
            self.length_again(origin);
        } else {
            self.modal.reach(changed, &ends);
        }
    }

    /// An axis with its coordinate in units.
    pub(super) fn axis_word(&mut self, axis: Axis, units: i64) {
        self.lines.text.number(axis.letter() as u8, units, self.places_of(axis));
    }

    /// A line in step with the spindle.
    pub(super) fn thread(&mut self, lead: f64, mv: &Move, origin: &Origin) {
        let Some(Thread { word, lead: form, stops }) = self.target.motion.thread else {
            self.deny(origin, codes::O9300::target_has_no_word_for_thread(&self.target.name));
            return self.pretend(mv);
        };
        let Some(address) = self.lead_address(form, mv) else {
            self.deny(origin, codes::O9322::target_has_no_word_for_thread_along(&self.target.name));
            return self.pretend(mv);
        };
        let programmed = lead;
        let lead = self.measures.lead.units(programmed).filter(|units| *units > 0);
        let Some(lead) = lead else {
            return self.say(origin, codes::O1003::lead_of_this_thread_prints_as_zero());
        };
        if !self.is_near("lead", programmed, lead, self.measures.lead, origin) {
            return self.pretend(mv);
        }
        if self.length.waits && mv.axes.contains(Axis::Z) {
            return self.lacks_form(mv, origin);
        }
        // Whether an F that is a lead counts the turn under a feed per minute, too, no manual at hand says.
        if address == self.target.feed.address
            && let Some(word) = self.target.feed.per_revolution
            && self.modal.feed_kind_changes(FeedKind::PerRevolution)
        {
            self.lines.words(word, origin);
        }
        let before = self.lines.lines();
        let behind_thread = self.thread.as_ref().is_some_and(|(at, lines)| at == self.modal.at() && *lines != before);
        if behind_thread && !stops {
            self.deny(origin, codes::O9325::target_has_no_word_for_thread(&self.target.name));
            return self.pretend(mv);
        }
        self.straight(word, mv, Some((address, lead)), origin);
        if self.lines.lines() == before && !self.diags.has_errors() {
            self.say(origin, codes::O1003::thread_has_no_length_that_can());
        }
        if !stops {
            self.thread = Some((*self.modal.at(), self.lines.lines()));
        }
        if address == self.target.feed.address {
            // The lead was an F.
            self.modal.forget_feed();
        }
    }

    /// The address that gives the lead of this thread.
    fn lead_address(&self, form: Lead, mv: &Move) -> Option<u8> {
        let moves = |axis: &Axis| {
            let units = mv.end.get(*axis).and_then(|value| self.places_of(*axis).units(value));
            units.is_some() && units != self.modal.place(*axis)
        };
        let mut moving = mv.axes.iter().filter(moves);
        match (form, moving.next(), moving.next()) {
            (Lead::Way(address), ..) | (Lead::OneAxis(address), _, None) => Some(address),
            (Lead::AlongZ(address), None | Some(Axis::Z), None) => Some(address),
            (Lead::OneAxis(_) | Lead::AlongZ(_), ..) => None,
        }
    }

    #[cold]
    pub(super) fn unprintable(&mut self, origin: &Origin) {
        self.lines.text.drop_line();
        self.say(origin, codes::O1002::number_of_this_block_is_too_large());
    }

    /// The F word where it changes; a change of its kind gets a line of its own.
    #[inline(never)]
    pub(super) fn feed_word(&mut self, feed: Feed, origin: &Origin) -> Result<Option<i64>, ()> {
        let kind = FeedKind::of(feed);
        let units = self.feed_places(kind).units(feed.value()).filter(|units| *units > 0);
        let Some(units) = units else {
            self.say(origin, codes::O1001::feed_prints_as_zero_or_not(&feed.value()));
            return Err(());
        };
        if !self.is_near(kind.name(), feed.value(), units, self.feed_places(kind), origin) {
            return Err(());
        }
        if self.modal.feed_kind_changes(kind) {
            self.lines.by_time = kind == FeedKind::InverseTime;
            match kind.word(&self.target.feed) {
                // In a dialog each feed says what it counts.
                Some(_) if matches!(self.target.form, Form::Dialog(_)) => {}
                Some(word) => self.lines.words(word, origin),
                None => {
                    let name = &self.target.name;
                    let fault = if kind == FeedKind::PerRevolution {
                        codes::O9301::target_has_no_word_for_feed_per_revolution(name)
                    } else {
                        codes::O9301::target_has_no_word_for_feed_by_time(name)
                    };
                    self.deny(origin, fault);
                }
            }
        }
        let changes = self.modal.feed_changes(feed, units);
        if !self.settings.modal {
            self.modal.forget_feed();
        }
        Ok((changes || !self.settings.modal).then_some(units))
    }

    pub(super) fn arc(&mut self, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        let (first, second, _) = arc.plane.axes();
        let grid = self.grid(arc.plane);
        let scale = self.places.scale() * grid.step as f64;
        let (x, y) = (Axis::ALL[first], Axis::ALL[second]);
        let from = self.modal.place(x).zip(self.modal.place(y));
        let (Some(to), Some(from)) = (mv.end.in_plane(arc.plane), from) else {
            // Only a refused block leaves an arc without a start, and that was reported.
            if !self.diags.has_errors() {
                self.say(origin, codes::O1002::start_of_this_arc_was_not_printed());
            }
            return;
        };
        let Some(to) = self.on_grid(arc.plane, to) else {
            return self.unprintable(origin);
        };
        let (Some(_), Some(_)) = (self.places.units(arc.center.x), self.places.units(arc.center.y)) else {
            return self.unprintable(origin);
        };
        let words = &self.target.arcs;
        let request = arc::Request {
            from: grid.of([from.0, from.1]),
            to,
            step: grid.step,
            center: Point2::new(arc.center.x * scale, arc.center.y * scale),
            sweep: arc.sweep,
            radius: crate::geo::distance(arc.from, arc.center) * scale,
            most_off: tolerance::ROUNDED_POINT * grid.step as f64 + tolerance::LEAVES * scale,
            tolerance: (words.tolerance * grid.step as f64).min(self.settings.arc_mismatch() * scale),
            least_radius: words.least_radius * scale,
            most_radius: words.most_radius * scale,
            least_chord: words.least_chord * scale,
        };
        let blocks = match self.target.form {
            Form::Dialog(dialog) if self.rises(arc, mv) => {
                if !dialog.helix.planes.contains(&arc.plane) {
                    return self.fall_back(true, arc, feed, mv, origin);
                }
                if !self.turns_exactly(&dialog.helix, &request) {
                    return self.chords(arc, feed, mv, origin);
                }
                1
            }
            Form::Words if !words.helices && self.rises(arc, mv) => return self.fall_back(true, arc, feed, mv, origin),
            Form::Words | Form::Dialog(_) if !words.planes.contains(&arc.plane) => {
                return self.fall_back(false, arc, feed, mv, origin);
            }
            Form::Words | Form::Dialog(_) if request.from == request.to => words.blocks(arc.sweep),
            Form::Words | Form::Dialog(_) => words.open_blocks(arc.sweep),
        };
        if blocks > 1 {
            return self.divided_arc(&request, blocks, arc, feed, mv, origin);
        }
        let (offset, turns) = match arc::fit(&request) {
            Printed::Arc { offset, turns } => (offset, turns),
            Printed::Nothing => {
                self.say(origin, codes::O4002::arc_is_shorter_than_last_printed_digit());
                let straight = Move { path: Path::Line(feed), ..*mv };
                return self.straight(self.target.motion.line, &straight, None, origin);
            }
            Printed::Lines => return self.chords(arc, feed, mv, origin),
            Printed::Off(off) => return self.off(off, arc, feed, mv, origin),
        };
        let Some((printed, ends)) = self.arc_ends(&request, arc, mv, origin) else { return };
        self.select_plane(arc.plane, origin);
        let Ok(units) = self.feed_word(feed, origin) else { return };
        let feed = units.map(|units| (units, self.feed_places(FeedKind::of(feed))));
        self.arc_block(arc, &ArcBlock { printed, ends, offset, turns }, feed, origin);
    }

    /// The axes that an arc prints, and their ends.
    fn arc_ends(
        &mut self,
        request: &arc::Request,
        arc: &Arc,
        mv: &Move,
        origin: &Origin,
    ) -> Option<(AxisSet, [i64; AXES])> {
        let (first, second, _) = arc.plane.axes();
        let mut ends = *self.modal.at();
        let mut printed = AxisSet::of(Axis::ALL[first]).union(AxisSet::of(Axis::ALL[second]));
        for axis in mv.axes.without(printed).iter() {
            let Some(units) = mv.end.get(axis).and_then(|value| self.places_of(axis).units(value)) else {
                self.unprintable(origin);
                return None;
            };
            if !self.modal.says(axis, units) {
                ends[axis.index()] = units;
                printed.insert(axis);
            }
        }
        let lacking = printed.without(self.axes);
        if !lacking.is_empty() {
            self.lacks_axes(lacking, mv, origin);
            return None;
        }
        if self.length.waits && printed.contains(Axis::Z) || self.measures.inches && self.turns_axes(printed) {
            self.lacks_form(mv, origin);
            return None;
        }
        [ends[first], ends[second]] = self.grid(arc.plane).places(request.to);
        Some((printed, ends))
    }

    fn arc_block(&mut self, arc: &Arc, block: &ArcBlock, feed: Option<(i64, Places)>, origin: &Origin) {
        if let Form::Dialog(dialog) = self.target.form {
            return self.dialog_arc(dialog, arc, block, feed, origin);
        }
        let ArcBlock { printed, mut ends, offset, turns } = *block;
        let printed = if self.settings.modal { printed } else { self.with_known(printed, &mut ends) };
        let words = &self.target.arcs;
        self.lines.text.word(if arc.sweep > 0.0 { words.counter_clockwise } else { words.clockwise });
        for axis in printed.iter() {
            self.axis_word(axis, ends[axis.index()]);
        }
        let (first, second, _) = arc.plane.axes();
        let step = self.grid(arc.plane).step;
        let mut offsets = [(first, offset[0] / step), (second, offset[1] / step)];
        offsets.sort_by_key(|(axis, _)| *axis);
        for (axis, units) in offsets {
            self.lines.text.number(words.center[axis], units, self.places);
        }
        match words.turns {
            Some(Turns::All(address)) if turns > 1 => drop(self.lines.text.whole(address, u64::from(turns))),
            Some(Turns::More(word)) if turns > 1 => {
                self.lines.text.valued(word, i64::from(turns) - 1, Places::new(0));
            }
            _ => {}
        }
        if let Some((units, places)) = feed {
            self.lines.text.number(self.target.feed.address, units, places);
        }
        self.lines.end_line(origin);
        self.modal.reach(printed, &ends);
    }

    /// An arc in several blocks of equal sweep, each with a printed start and end of its own.
    fn divided_arc(&mut self, request: &arc::Request, blocks: u32, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        if !self.knows_start(mv, origin) {
            return;
        }
        // All blocks have to fit before the first one is printed.
        let mut from = request.from;
        for block in 1..=blocks {
            let Some(part) = self.part(request, arc, from, block, blocks) else { return self.unprintable(origin) };
            match arc::fit(&part) {
                Printed::Arc { turns: 1, .. } => {}
                Printed::Off(off) => return self.off(off, arc, feed, mv, origin),
                Printed::Arc { .. } | Printed::Nothing | Printed::Lines => return self.chords(arc, feed, mv, origin),
            }
            from = part.to;
        }
        let Some((printed, last)) = self.arc_ends(request, arc, mv, origin) else { return };
        self.select_plane(arc.plane, origin);
        let feed = shared(feed, f64::from(blocks));
        let (first, second, _) = arc.plane.axes();
        let start = *self.modal.at();
        let mut from = request.from;
        for block in 1..=blocks {
            let Some(part) = self.part(request, arc, from, block, blocks) else { return };
            let Printed::Arc { offset, .. } = arc::fit(&part) else { return };
            let Ok(units) = self.feed_word(feed, origin) else { return };
            let feed = units.map(|units| (units, self.feed_places(FeedKind::of(feed))));
            let share = f64::from(block) / f64::from(blocks);
            let mut ends = last;
            for axis in printed.iter() {
                let (from, to) = (start[axis.index()], last[axis.index()]);
                ends[axis.index()] = from + libm::round((to - from) as f64 * share) as i64;
            }
            [ends[first], ends[second]] = self.grid(arc.plane).places(part.to);
            self.arc_block(arc, &ArcBlock { printed, ends, offset, turns: 1 }, feed, origin);
            from = part.to;
        }
    }

    /// One of the `blocks` parts of an arc; it starts where the one in front of it was printed to end.
    fn part(&self, whole: &arc::Request, arc: &Arc, from: [i64; 2], block: u32, blocks: u32) -> Option<arc::Request> {
        let share = f64::from(block) / f64::from(blocks);
        let end = arc.center + turned(arc.from - arc.center, arc.sweep * share);
        let turns = arc.sweep * share / TAU;
        let to = if block == blocks {
            whole.to
        } else if (libm::round(turns) - turns).abs() < WHOLE {
            whole.from
        } else {
            self.on_grid(arc.plane, end)?
        };
        Some(arc::Request { from, to, sweep: arc.sweep / f64::from(blocks), ..*whole })
    }

    /// An axis that goes along is divided from where it was printed to stand.
    fn knows_start(&self, mv: &Move, origin: &Origin) -> bool {
        let known = mv.axes.iter().all(|axis| self.modal.place(axis).is_some());
        if !known && !self.diags.has_errors() {
            self.say(origin, codes::O1002::axis_of_this_arc_starts_where_nothing());
        }
        known
    }

    /// Lines instead of an arc that the target cannot say, where the configuration allows them.
    #[cold]
    fn fall_back(&mut self, helix: bool, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        let Some(millionths) = self.settings.arc_fallback else { return self.lacks_arc(helix, mv, origin) };
        if !self.knows_start(mv, origin) {
            return;
        }
        let most = f64::from(millionths) * 1e-6;
        // The printed places are rounded, too.
        let unit = 1.0 / self.places.scale();
        let room = most - tolerance::ROUNDED_POINT * unit;
        if room < LEAST_ROOM * unit {
            return self.too_coarse(most - room, mv, origin);
        }
        let what = if helix { "the helix" } else { "the arc" };
        self.say(origin, codes::O4004::is_printed_as_lines_that_leave(&what, &most));
        self.lines(arc, feed, mv, (most - unit).max(0.5 * unit).min(room), origin);
    }

    /// An arc whose printed numbers are so many units off: lines, unless the places are too coarse for those as well.
    #[cold]
    fn off(&mut self, units: f64, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        let unit = 1.0 / self.places.scale();
        if unit > tolerance::LEAVES {
            return self.too_coarse(units * unit, mv, origin);
        }
        self.chords(arc, feed, mv, origin);
    }

    /// Straight lines instead of an arc that does not fit the printed grid.
    #[cold]
    fn chords(&mut self, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        if !self.knows_start(mv, origin) {
            return;
        }
        let radius = crate::geo::distance(arc.from, arc.center);
        let fault = if radius > self.target.arcs.most_radius {
            codes::O4001::arc_is_flatter_than_target_computes()
        } else {
            codes::O4001::arc_is_too_small_for_its_printed_numbers()
        };
        self.say(origin, fault);
        self.lines(arc, feed, mv, (0.5 / self.places.scale()).min(tolerance::LEAVES), origin);
    }

    /// Lines that leave the arc by so much at most.
    fn lines(&mut self, arc: &Arc, feed: Feed, mv: &Move, most: f64, origin: &Origin) {
        let radius = crate::geo::distance(arc.from, arc.center);
        // A chord leaves the arc by r·(1 - cos(a/2)).
        let step = 2.0 * libm::acos((1.0 - most / radius).max(STEEPEST));
        let count = libm::ceil(arc.sweep.abs() / step.max(1e-6)).clamp(1.0, MOST_CHORDS);
        let (x, y, _) = arc.plane.axes();
        let (x, y) = (Axis::ALL[x], Axis::ALL[y]);
        let start: Vec<(Axis, i64)> = mv.axes.iter().map(|axis| (axis, self.modal.at()[axis.index()])).collect();
        for i in 1..=count as u32 {
            let t = f64::from(i) / count;
            let mut point = *mv;
            point.path = Path::Line(shared(feed, count));
            if t < 1.0 {
                let p = arc.center + turned(arc.from - arc.center, arc.sweep * t);
                for &(axis, from) in &start {
                    let from = from as f64 / self.places_of(axis).scale();
                    let end = mv.end.get(axis).unwrap_or(from);
                    let value = if axis == x {
                        p.x
                    } else if axis == y {
                        p.y
                    } else {
                        from + (end - from) * t
                    };
                    point.end.set(axis, value);
                }
            }
            self.straight(self.target.motion.line, &point, None, origin);
        }
    }
}

/// The feed of one of `parts` equal parts: they share the time.
fn shared(feed: Feed, parts: f64) -> Feed {
    match feed {
        Feed::InverseTime(f) => Feed::InverseTime(f * parts),
        Feed::PerMinute(_) | Feed::PerRevolution(_) => feed,
    }
}
