//! What some straight moves need besides their axes and their feed: the length of the tool, all words, a closer look.

use crate::diag::codes;
use crate::ir::Origin;
use crate::ir::motion::{Move, Path};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::target::{Length, LengthNumber, LengthWords};

use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;

impl Printer<'_> {
    /// Looks at a straight move that is not as most are; false if it is refused.
    #[cold]
    pub(super) fn may_be_straight(&mut self, mv: &Move, changed: AxisSet, origin: &Origin) -> bool {
        let fed = !matches!(mv.path, Path::Rapid);
        if mv.machine && (self.target.motion.machine.is_none() || fed && !self.target.motion.machine_feed) {
            let name = &self.target.name;
            let fault = if fed {
                codes::O9321::target_has_no_word_for_move_in_machine_coordinates_at_feed(name)
            } else {
                codes::O9321::target_has_no_word_for_machine_coordinates(name)
            };
            self.deny(origin, fault);
            self.pretend(mv);
            return false;
        }
        if mv.machine {
            self.leave_plane(origin);
        }
        if let (true, Length::Words(words)) = (mv.machine && self.length.tool > 0, self.target.tool.length)
            && self.target.motion.machine_drops_length
            && let Some(off) = words.off
        {
            self.lines.words(off, origin);
        }
        if fed && self.measures.inches && self.turns_axes(changed) {
            self.lacks_form(mv, origin);
            return false;
        }
        true
    }

    /// The feed of rapid traverse, where that goes at the last one. Whether it holds on is a matter of the build.
    #[cold]
    pub(super) fn rapid_feed(&mut self, origin: &Origin) -> Option<(i64, Places)> {
        let Some(feed) = self.settings.rapid_feed else {
            self.lacks_rapid_feed(origin);
            return None;
        };
        self.modal.forget_feed();
        let places = self.feed_places(FeedKind::PerMinute);
        let units = places.units(f64::from(feed));
        if units.is_none() {
            self.unprintable(origin);
        }
        units.map(|units| (units, places))
    }

    pub(super) fn turns_axes(&self, changed: AxisSet) -> bool {
        changed.iter().any(Axis::is_rotary)
    }

    /// Axes of a block that says all words.
    #[cold]
    pub(super) fn spelled_out(&self, mv: &Move, changed: AxisSet, ends: &mut [i64; AXES]) -> AxisSet {
        if self.settings.modal || mv.machine { changed } else { self.with_known(changed, ends) }
    }

    /// `axes` and the main axes of which the target knows where they stand.
    pub(super) fn with_known(&self, axes: AxisSet, ends: &mut [i64; AXES]) -> AxisSet {
        let mut all = axes;
        for axis in AxisSet::MAIN.without(axes).iter() {
            let place = self.modal.place(axis).filter(|place| self.modal.says(axis, *place));
            if let Some(place) = place {
                ends[axis.index()] = place;
                all.insert(axis);
            }
        }
        all
    }

    /// The length of the tool in front of a move along Z: prints its word, gives its address and number.
    #[cold]
    pub(super) fn length_word(&mut self, mv: &Move, changed: AxisSet) -> Option<(u8, u32)> {
        let Length::Words(LengthWords { on, number: LengthNumber::Tool(address), .. }) = self.target.tool.length else {
            return None;
        };
        if mv.machine || !changed.contains(Axis::Z) {
            return None;
        }
        (self.length.waits, self.length.counts) = (false, true);
        self.lines.text.word(on);
        Some((address, self.length.tool))
    }

    /// Behind a move in machine coordinates the length of the tool counts again.
    pub(super) fn length_again(&mut self, origin: &Origin) {
        let Length::Words(words) = self.target.tool.length else { return };
        if self.length.tool == 0 {
            return;
        }
        // Some controls have dropped it.
        self.length.waits |= words.with_move;
        if self.target.motion.machine_drops_length {
            self.lines.words(words.on, origin);
        }
    }
}
