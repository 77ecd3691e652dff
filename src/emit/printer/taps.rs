//! Holes that are tapped without a compensating chuck, each in the word of the target.

use crate::diag::fault::Asking;
use crate::diag::{Answer, Fault, codes};
use crate::geo::Plane;
use crate::geo::tolerance;
use crate::ir::function::{Function, Spindle, Turn};
use crate::ir::motion::{Path, Place};
use crate::ir::{Origin, Side, Tap};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::target::{RigidTap, TapCycle, TapPitch};

use super::super::modal::FeedKind;
use super::{HandChange, Printer};

/// Whole factors on the speed of the way back that a control takes.
const FACTORS: std::ops::RangeInclusive<f64> = 1.0..=9.0;
/// A detail for which many targets have no word.
const ANGLE: &str = "the angle of the spindle at which it begins";

/// Why the target cannot tap a hole. `None` where something was said already.
pub(super) type Unfit = Option<Fault>;

/// A tap as it is printed: coordinates along its axis in units.
pub(super) struct Hole<'t> {
    pub tap: &'t Tap,
    pub start: i64,
    /// Depth and return of each stroke.
    pub strokes: Vec<(i64, i64)>,
}

impl Printer<'_> {
    #[inline(never)]
    pub(super) fn print_tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        match self.tap(tap, place, origin) {
            Ok(()) => {
                // The control starts and stops the spindle by itself.
                self.spindle = HandChange::Stands;
                self.stated.by_tap = true;
                self.modal.forget_feed();
            }
            Err(unfit) => {
                if let Some(fault) = unfit {
                    self.deny(origin, fault);
                }
                self.pretend(&place.along(tap, tap.end(), Path::Rapid));
            }
        }
    }

    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) -> Result<(), Unfit> {
        let name = &self.target.name;
        let Some(words) = self.target.motion.rigid_tap else {
            return Err(Some(codes::O9340::target_has_no_word_for_tapping_without_chuck(name)));
        };
        if self.compensation.side != Side::None {
            return Err(Some(codes::O9341::target_has_no_word_for_tap_inside_compensation(name)));
        }
        if !self.axes.contains(tap.axis) || self.length.waits && tap.axis == Axis::Z {
            return Err(Some(codes::O9341::target_has_no_word_for_tap_along_axis_not_moved(name)));
        }
        if self.modal.cuts_at_speed {
            return Err(Some(codes::O9341::target_has_no_word_for_tap_at_cutting_speed(name)));
        }
        if let (true, Some(speed)) = (self.modal.cutting_speed, tap.speed_in) {
            self.print_function(&Function::Spindle(Spindle::Speed(speed)), origin);
        }
        let hole = self.hole(tap, origin)?;
        // Where somebody may have moved the axis, its place is said again.
        self.straight(self.target.motion.rapid, &place.along(tap, tap.start, Path::Rapid), None, origin);
        match words {
            RigidTap::Return { word, lead, factor } => self.returning_taps(&hole, (word, lead, factor), origin)?,
            RigidTap::Cycle(words) => self.tapping_cycles(&hole, &words, origin)?,
            RigidTap::InAndOut { ready, into, out, leads } => {
                let Some(lead) = leads.get(tap.axis.index()).copied() else {
                    return Err(Some(codes::O9341::target_has_no_word_for_tap_along_this_axis(name)));
                };
                self.taps_in_and_out(&hole, (ready, into, out, lead), origin)?;
            }
            RigidTap::Dialog(words) => self.dialog_taps(&hole, words, origin)?,
        }
        let mut ends = [0; AXES];
        ends[tap.axis.index()] = hole.strokes.last().map_or(hole.start, |(_, back)| *back);
        self.modal.reach(AxisSet::of(tap.axis), &ends);
        Ok(())
    }

    fn hole<'t>(&mut self, tap: &'t Tap, origin: &Origin) -> Result<Hole<'t>, Unfit> {
        let places = self.places_of(tap.axis);
        let start = places.units(tap.start);
        let strokes = tap.strokes.iter().map(|stroke| places.units(stroke.to).zip(places.units(stroke.back)));
        let (Some(start), Some(strokes)) = (start, strokes.collect::<Option<Vec<_>>>()) else {
            self.unprintable(origin);
            return Err(None);
        };
        let mut at = start;
        for (to, back) in &strokes {
            if *to == at || to == back {
                self.say(origin, codes::O1003::tap_has_no_length_that_can());
                return Err(None);
            }
            at = *back;
        }
        Ok(Hole { tap, start, strokes })
    }

    /// A word that comes back to where it began: what is left of the strokes.
    pub(super) fn returns(&self, hole: &Hole<'_>, origin: &Origin) -> Result<(), Unfit> {
        let Some(((_, last), others)) = hole.strokes.split_last() else { return Err(None) };
        if *last != hole.start {
            return Err(Some(codes::O9341::target_has_no_word_for_tap_that_ends_at_another_height(&self.target.name)));
        }
        if others.iter().any(|(_, back)| *back != hole.start) {
            self.told_of_tap(codes::O4007::chip_is_broken_within_hole(), origin);
        }
        Ok(())
    }

    fn told_of_tap(&self, asking: Asking, origin: &Origin) {
        if !self.settings.tapping_as_target {
            let fault = asking.answer(Answer::key("output", "tapping"));
            self.diags.push_once(fault.at(origin.loc).called(origin.call));
        }
    }

    /// Details of a tap for which the target has no word, and which do not change the thread.
    pub(super) fn leaves_out(&self, details: &[&str], origin: &Origin) {
        if let [others @ .., last] = details {
            let list = if others.is_empty() { (*last).to_owned() } else { format!("{} and {last}", others.join(", ")) };
            self.told_of_tap(codes::O4008::tap_of_target_has_no_word(&list), origin);
        }
    }

    /// What a word leaves out that cannot wait, or goes back at its own speed.
    pub(super) fn lost_details(&self, tap: &Tap, dwell: bool, factor: bool) -> Vec<&'static str> {
        let waits = dwell && tap.strokes.iter().any(|stroke| stroke.dwell > 0.0);
        let slower = factor && (tap.factor() - 1.0).abs() > tolerance::LOST;
        let again = (0..tap.strokes.len()).any(|stroke| tap.resumes(stroke).is_some());
        let details = [
            (waits, "the dwell at the bottom"),
            (slower, "the speed of the way out"),
            (again, "the speed of the way down through the thread"),
        ];
        details.into_iter().filter(|(lost, _)| *lost).map(|(_, what)| what).collect()
    }

    /// The speed of the way in, in units; said, where the target does not know it and `said`.
    pub(super) fn tap_speed(&mut self, tap: &Tap, said: bool, origin: &Origin) -> Result<Option<i64>, Unfit> {
        let Some(speed) = tap.speed_in else { return Ok(self.stated.speed) };
        let units = self.speed_units(speed, origin).ok_or(None)?;
        // On a lathe the first speed says that none is a cutting speed.
        if self.states_turns() || said && self.stated.speed != Some(units) {
            self.print_function(&Function::Spindle(Spindle::Speed(speed)), origin);
        }
        Ok(Some(units))
    }

    /// The pitch in units of its places, and that it is exact enough along the hole.
    pub(super) fn tap_lead(&self, tap: &Tap, origin: &Origin) -> Result<i64, Unfit> {
        let places = self.measures.lead;
        let Some(units) = places.units(tap.lead).filter(|units| *units > 0) else {
            self.say(origin, codes::O1003::pitch_of_this_tap_prints_as_zero());
            return Err(None);
        };
        if (units as f64 / places.scale() - tap.lead).abs() * tap.turns() > tolerance::PITCH_LEAVES {
            let asking = codes::O9341::target_has_no_word_for_this_pitch(&self.target.name);
            return Err(Some(asking.answer(Answer::key("output", "decimals"))));
        }
        Ok(units)
    }

    /// The spindle turns, and a block goes in and comes back.
    fn returning_taps(&mut self, hole: &Hole<'_>, words: (&str, u8, u8), origin: &Origin) -> Result<(), Unfit> {
        let (word, address, of_factor) = words;
        let tap = hole.tap;
        self.returns(hole, origin)?;
        let lead = self.tap_lead(tap, origin)?;
        let mut lost = self.lost_details(tap, true, false);
        // It begins at the mark of the spindle, each stroke anew.
        lost.extend(tap.orient.filter(|angle| angle % 360.0 != 0.0).map(|_| ANGLE));
        self.leaves_out(&lost, origin);
        self.tap_speed(tap, true, origin)?;
        if self.stated.turn != Some(tap.turn) {
            self.print_function(&Function::Spindle(Spindle::Start(tap.turn)), origin);
        }
        let factor = tap.factor();
        for (at, (to, _)) in hole.strokes.iter().enumerate() {
            if at > 0 && tap.pause > 0.0 {
                self.print_function(&Function::Dwell(tap.pause), origin);
            }
            let places = self.places_of(tap.axis);
            self.lines.text.word(word).number(tap.axis.letter() as u8, *to, places);
            self.lines.text.number(address, lead, self.measures.lead);
            if (factor - 1.0).abs() > tolerance::LOST
                && let Some(units) = self.measures.factor.units(factor)
            {
                self.lines.text.number(of_factor, units, self.measures.factor);
            }
            self.lines.end_line(origin);
        }
        Ok(())
    }

    /// A cycle for each stroke.
    fn tapping_cycles(&mut self, hole: &Hole<'_>, words: &TapCycle, origin: &Origin) -> Result<(), Unfit> {
        let tap = hole.tap;
        let word = self.cycle_word(tap, words)?;
        self.returns(hole, origin)?;
        let whole = libm::round(tap.factor());
        let fits = words.factor.filter(|_| (tap.factor() - whole).abs() <= tolerance::LOST && FACTORS.contains(&whole));
        let mut lost = self.lost_details(tap, words.dwell.is_none(), fits.is_none());
        lost.extend(tap.orient.map(|_| ANGLE));
        self.leaves_out(&lost, origin);
        if hole.strokes.len() > 1 {
            self.told_of_tap(codes::O4009::hole_is_tapped_in_steps(&hole.strokes.len(), &words.meets), origin);
        }
        let Some(speed) = self.tap_speed(tap, words.ready.is_none(), origin)? else {
            return Err(self.speed_not_known());
        };
        if !words.from_start {
            self.select_plane(Plane::Xy, origin);
        }
        let feed = self.tap_feed(tap, words.pitch, speed)?;
        let factor = fits.filter(|_| whole > 1.0).map(|address| (address, whole as u64));
        let cycle = Cycle { word, speed, feed, factor };
        // The dwell of the cycle that is on.
        let mut on: Option<f64> = None;
        for ((to, _), stroke) in hole.strokes.iter().zip(&tap.strokes) {
            if let Some(dwell) = on {
                if words.stays && tap.pause == 0.0 && dwell == stroke.dwell {
                    self.lines.text.number(tap.axis.letter() as u8, *to, self.places_of(tap.axis));
                    self.lines.end_line(origin);
                    continue;
                }
                self.lines.words(words.off, origin);
                if tap.pause > 0.0 {
                    self.print_function(&Function::Dwell(tap.pause), origin);
                }
            }
            self.tapping_cycle(hole, words, &cycle, (*to, stroke.dwell), origin);
            on = Some(stroke.dwell);
        }
        self.lines.words(words.off, origin);
        self.stated.turn = None;
        Ok(())
    }

    /// The lines that begin a cycle.
    fn tapping_cycle(
        &mut self,
        hole: &Hole<'_>,
        words: &TapCycle,
        cycle: &Cycle<'_>,
        (to, dwell): (i64, f64),
        origin: &Origin,
    ) {
        let (kind, feed) = cycle.feed;
        if self.modal.feed_kind_changes(kind)
            && let Some(word) = kind.word(&self.target.feed)
        {
            self.lines.by_time = false;
            self.lines.words(word, origin);
        }
        if let Some(ready) = words.ready {
            self.lines.text.word(ready).number(self.target.spindle.speed, cycle.speed, self.measures.speed);
            self.lines.end_line(origin);
            self.stated.speed = Some(cycle.speed);
        }
        self.cycle_words(hole, words, cycle.word, (to, dwell));
        if let Some((address, factor)) = cycle.factor {
            self.lines.text.whole(address, factor);
        }
        self.lines.text.number(self.target.feed.address, feed, self.feed_places(kind));
        self.lines.end_line(origin);
    }

    /// The words of a cycle but for those of its speeds.
    fn cycle_words(&mut self, hole: &Hole<'_>, words: &TapCycle, word: &str, (to, dwell): (i64, f64)) {
        let axis = hole.tap.axis;
        let places = self.places_of(axis);
        if let Some(level) = words.level {
            self.lines.text.word(level);
        }
        self.lines.text.word(word);
        for other in [Axis::X, Axis::Y] {
            if let Some(at) = self.modal.place(other).filter(|at| !words.from_start && self.modal.says(other, *at)) {
                self.axis_word(other, at);
            }
        }
        self.lines.text.number(axis.letter() as u8, to, places);
        self.lines.text.number(words.begins, if words.from_start { 0 } else { hole.start }, places);
        if let Some(address) = words.dwell
            && dwell > 0.0
            && let Some(units) = self.measures.time.units(dwell)
        {
            self.lines.text.whole(address, units.unsigned_abs());
        }
    }

    /// F of a tapping cycle, under the kind of feed in which the pitch is more exact.
    fn tap_feed(&self, tap: &Tap, pitch: TapPitch, speed: i64) -> Result<(FeedKind, i64), Unfit> {
        let turns = speed as f64 / self.measures.speed.scale();
        let as_feed = |kind: FeedKind, per: f64| {
            let places = self.feed_places(kind);
            let units = places.units(tap.lead * per).filter(|units| *units > 0)?;
            let off = (units as f64 / places.scale() / per - tap.lead).abs() * tap.turns();
            Some((kind, units, off))
        };
        let per_minute = as_feed(FeedKind::PerMinute, turns);
        let per_turn = as_feed(FeedKind::PerRevolution, 1.0);
        let best = match pitch {
            TapPitch::PerMinute => per_minute,
            TapPitch::PerRevolution => per_turn,
            TapPitch::Either => match (per_minute, per_turn) {
                (Some(minute), Some(turn)) if turn.2 + tolerance::LOST < minute.2 => Some(turn),
                (minute, turn) => minute.or(turn),
            },
        };
        match best {
            Some((kind, units, off)) if off <= tolerance::PITCH_LEAVES => Ok((kind, units)),
            _ => {
                let asking = codes::O9341::target_has_no_word_for_this_pitch_as_feed(&self.target.name);
                Err(Some(asking.answer(Answer::key("output", "decimals"))))
            }
        }
    }

    /// The spindle becomes an axis; in and out are blocks of their own.
    fn taps_in_and_out(
        &mut self,
        hole: &Hole<'_>,
        (ready, into, out, address): (&str, &str, &str, u8),
        origin: &Origin,
    ) -> Result<(), Unfit> {
        let tap = hole.tap;
        let lead = self.tap_lead(tap, origin)?;
        let lead = if tap.turn == Turn::Clockwise { lead } else { -lead };
        let Some(speed_in) = self.tap_speed(tap, false, origin)? else {
            return Err(self.speed_not_known());
        };
        let speed_out = match tap.speed_out {
            Some(speed) => self.speed_units(speed, origin).ok_or(None)?,
            None => speed_in,
        };
        let places = self.places_of(tap.axis);
        let (Some(angle), Some(resumes)) = (
            self.measures.angle.units(tap.orient.unwrap_or(0.0)),
            (0..tap.strokes.len())
                .map(|stroke| tap.resumes(stroke).map_or(Some(None), |to| places.units(to).map(Some)))
                .collect::<Option<Vec<_>>>(),
        ) else {
            self.unprintable(origin);
            return Err(None);
        };
        self.lines.text.valued(ready, angle, self.measures.angle);
        self.lines.end_line(origin);
        let letter = tap.axis.letter() as u8;
        // The first block states its speed.
        self.stated.speed = None;
        for (at, (to, back)) in hole.strokes.iter().enumerate() {
            if at > 0 && tap.pause > 0.0 {
                self.print_function(&Function::Dwell(tap.pause), origin);
            }
            let again = resumes[at].filter(|again| again != to).map(|again| (into, again, speed_out));
            for (word, end, speed) in again.into_iter().chain([(into, *to, speed_in)]) {
                self.synchronous(word, (letter, end), (address, lead), speed, origin);
            }
            if tap.strokes[at].dwell > 0.0 {
                self.print_function(&Function::Dwell(tap.strokes[at].dwell), origin);
            }
            self.synchronous(out, (letter, *back), (address, lead), speed_out, origin);
        }
        self.stated.turn = None;
        Ok(())
    }

    fn synchronous(
        &mut self,
        word: &str,
        (letter, end): (u8, i64),
        (address, lead): (u8, i64),
        speed: i64,
        origin: &Origin,
    ) {
        let places = Axis::of(letter).map_or(self.places, |axis| self.places_of(axis));
        self.lines.text.word(word).number(letter, end, places);
        self.lines.text.number(address, lead, self.measures.lead);
        if self.stated.speed.replace(speed) != Some(speed) {
            self.lines.text.number(self.target.spindle.speed, speed, self.measures.speed);
        }
        self.lines.end_line(origin);
    }

    /// The word of a cycle for the hand of a tap down Z.
    fn cycle_word(&self, tap: &Tap, words: &TapCycle) -> Result<&'static str, Unfit> {
        self.goes_down(tap)?;
        let word = match tap.turn {
            Turn::Clockwise => Some(words.right),
            Turn::CounterClockwise => words.left,
        };
        word.ok_or_else(|| Some(codes::O9341::target_has_no_word_for_left_hand_tap(&self.target.name)))
    }

    pub(super) fn goes_down(&self, tap: &Tap) -> Result<(), Unfit> {
        if tap.axis == Axis::Z && tap.outward() >= 0.0 {
            return Ok(());
        }
        Err(Some(codes::O9341::target_has_no_word_for_tap_in_another_direction(&self.target.name)))
    }

    #[cold]
    pub(super) fn speed_not_known(&self) -> Unfit {
        Some(codes::O9341::target_has_no_word_for_tap_at_speed_not_known(&self.target.name))
    }
}

/// What is the same in all strokes of a hole that a cycle taps.
struct Cycle<'w> {
    word: &'w str,
    speed: i64,
    feed: (FeedKind, i64),
    factor: Option<(u8, u64)>,
}
