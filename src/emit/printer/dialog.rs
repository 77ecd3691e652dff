//! Blocks of a dialog: each begins with what it does, names its axes with their signs, and ends with how fast. Arcs are
//! around a centre that a block of its own states, helices turn by an angle.

use core::f64::consts::TAU;

use crate::diag::codes;
use crate::geo::{Point2, arc as geometry};
use crate::ir::Origin;
use crate::ir::motion::{Arc, Move, Path};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::target::{Dialog, HelixWords};

use super::super::arc::{self, Printed};
use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;
use super::moves::ArcBlock;

/// Degrees of a turn.
const TURN: f64 = 360.0;

impl Printer<'_> {
    pub(super) fn dialog_straight(
        &mut self,
        dialog: &Dialog,
        mv: &Move,
        (changed, ends): (AxisSet, &mut [i64; AXES]),
        feed: Option<(i64, Places)>,
        origin: &Origin,
    ) {
        let changed = self.spelled_out(mv, changed, ends);
        let rapid = matches!(mv.path, Path::Rapid);
        let motion = &self.target.motion;
        self.lines.text.word(if rapid { motion.rapid } else { motion.line });
        for axis in changed.iter() {
            self.lines.text.hot_number(axis.letter() as u8, ends[axis.index()], self.places_of(axis));
        }
        if rapid || !self.settings.modal || !self.modal.dialog.uncompensated {
            self.lines.text.word(dialog.uncompensated);
            self.modal.dialog.uncompensated = true;
        }
        if rapid {
            self.lines.text.word(dialog.rapid);
        } else {
            self.dialog_feed(feed);
        }
        if mv.machine {
            self.lines.text.word(motion.machine.unwrap_or_default());
        }
        self.lines.end_line(origin);
        if mv.machine {
            self.modal.forget(changed);
        } else {
            self.modal.reach(changed, ends);
        }
    }

    /// Words of axes, each with `front` in front of its letter.
    fn signed_axes(&mut self, axes: AxisSet, ends: &[i64; AXES], front: &str) {
        for axis in axes.iter() {
            let (units, places) = (ends[axis.index()], self.places_of(axis));
            if front.is_empty() {
                self.lines.text.number(axis.letter() as u8, units, places);
            } else {
                self.lines.text.word(front).raw(&[axis.letter() as u8]).signed(units, places);
            }
        }
    }

    /// Does an axis beside the plane of the arc move with it?
    pub(super) fn rises(&self, arc: &Arc, mv: &Move) -> bool {
        let (first, second, _) = arc.plane.axes();
        let beside = |axis: &Axis| ![first, second].contains(&axis.index());
        mv.axes.iter().filter(beside).any(|axis| {
            let units = mv.end.get(axis).and_then(|value| self.places_of(axis).units(value));
            units.is_none_or(|units| !self.modal.says(axis, units))
        })
    }

    /// Does the angle of a helix lead as exactly to its end as the end is printed?
    pub(super) fn turns_exactly(&self, words: &HelixWords, request: &arc::Request) -> bool {
        let Printed::Arc { offset, turns } = arc::fit(request) else { return true };
        let radius = libm::hypot(offset[0] as f64, offset[1] as f64) / self.places.scale();
        request.from == request.to
            || radius <= words.most_radius && angle(request.from, request.to, offset, turns, request.sweep, words) != 0
    }

    pub(super) fn dialog_arc(
        &mut self,
        dialog: &Dialog,
        arc: &Arc,
        block: &ArcBlock,
        feed: Option<(i64, Places)>,
        origin: &Origin,
    ) {
        let ArcBlock { printed, ends, offset, .. } = *block;
        let (first, second, _) = arc.plane.axes();
        let at = *self.modal.at();
        let center = [at[first] + offset[0], at[second] + offset[1]];
        let plane: AxisSet = [first, second].into_iter().map(|axis| Axis::ALL[axis]).collect();
        if !self.settings.modal || self.modal.dialog.center != Some((arc.plane, center)) {
            self.modal.dialog.center = Some((arc.plane, center));
            let mut place = at;
            [place[first], place[second]] = center;
            self.lines.text.word(dialog.center);
            self.signed_axes(plane, &place, "");
            self.lines.end_line(origin);
        }
        if printed == plane {
            self.lines.text.word(dialog.arc);
            self.signed_axes(plane, &ends, "");
            self.sense(arc);
            self.dialog_feed(feed);
            self.lines.end_line(origin);
        } else {
            self.dialog_helix(&dialog.helix, arc, block, feed, origin);
        }
        self.modal.reach(printed, &ends);
    }

    /// The whole angle and the way of the third axis, in blocks of so many turns; then a line to where the angle leads
    /// all but exactly.
    fn dialog_helix(
        &mut self,
        words: &HelixWords,
        arc: &Arc,
        block: &ArcBlock,
        feed: Option<(i64, Places)>,
        origin: &Origin,
    ) {
        let ArcBlock { printed, ends, offset, turns } = *block;
        let (first, second, _) = arc.plane.axes();
        let at = *self.modal.at();
        let (from, to) = ([at[first], at[second]], [ends[first], ends[second]]);
        let plane: AxisSet = [first, second].into_iter().map(|axis| Axis::ALL[axis]).collect();
        let beside = printed.without(plane);
        let all = angle(from, to, offset, turns, arc.sweep, words);
        let places = Places::new(words.places);
        let most = words.most_turns * (TURN * places.scale()) as i64;
        let (mut turned, mut gone, mut feed) = (0, [0; AXES], feed);
        while turned < all.abs() {
            let part = most.min(all.abs() - turned);
            turned += part;
            let mut ways = [0; AXES];
            for axis in beside.iter().map(Axis::index) {
                let share = turned as f64 / all.abs() as f64;
                ways[axis] = libm::round((ends[axis] - at[axis]) as f64 * share) as i64 - gone[axis];
                gone[axis] += ways[axis];
            }
            self.lines.text.word(words.word).word(words.angle).signed(part * all.signum(), places);
            self.signed_axes(beside, &ways, words.way);
            self.sense(arc);
            self.dialog_feed(feed.take());
            self.lines.end_line(origin);
        }
        if from != to {
            self.lines.text.word(self.target.motion.line);
            self.signed_axes(plane, &ends, "");
            self.lines.end_line(origin);
        }
    }

    fn sense(&mut self, arc: &Arc) {
        let words = &self.target.arcs;
        self.lines.text.word(if arc.sweep > 0.0 { words.counter_clockwise } else { words.clockwise });
    }

    #[inline]
    fn dialog_feed(&mut self, feed: Option<(i64, Places)>) {
        let Some((units, places)) = feed else { return };
        match self.target.feed.per_revolution {
            Some(word) if self.modal.has_feed_kind(FeedKind::PerRevolution) => {
                self.lines.text.valued(word, units, places);
            }
            _ => self.lines.text.hot_number(self.target.feed.address, units, places),
        }
    }

    /// The block of a tool, or of the speed alone.
    pub(super) fn dialog_tool(&mut self, dialog: &Dialog, number: Option<u32>, origin: &Origin) {
        self.lines.text.word(dialog.tool);
        if let Some(number) = number {
            self.tool_word(number, origin);
        }
        self.lines.text.word(dialog.tool_axis);
        if let Some(units) = self.modal.dialog.speed {
            self.lines.text.number(self.target.spindle.speed, units, self.measures.speed);
        }
        // Whether a feed holds behind it is a matter of the control.
        self.modal.forget_feed();
    }

    /// The block that selects a work offset.
    pub(super) fn dialog_offset(&mut self, dialog: &Dialog, number: u8, word: &str, origin: &Origin) {
        self.say(origin, codes::O4003::work_offset_is_printed_as_preset(&number, &word));
        let [begin, behind] = dialog.offset;
        self.lines.words(begin, origin);
        self.lines.continued(format!("  {word} {behind}").as_bytes(), origin);
        self.modal.dialog.center = None;
    }
}

/// What a helix turns by, in units of the last place of its angle: on the printed numbers, with its whole turns.
fn angle(from: [i64; 2], to: [i64; 2], offset: [i64; 2], turns: u32, sweep: f64, words: &HelixWords) -> i64 {
    let turn = TURN * Places::new(words.places).scale();
    let sign = if sweep > 0.0 { 1 } else { -1 };
    let turn_units = turn as i64;
    if from == to {
        return sign * i64::from(turns) * turn_units;
    }
    let at = |p: [i64; 2]| Point2::new(p[0] as f64, p[1] as f64);
    let center = at([from[0] + offset[0], from[1] + offset[1]]);
    let part = geometry::sweep(at(from), at(to), center, sweep > 0.0).abs();
    sign * (libm::round(part / TAU * turn) as i64 + i64::from(turns - 1) * turn_units)
}
