//! Where the axes stand before the first block, as `[start]` of the configuration says.
//!
//! The positions are those that the program would write there: they count in the work offset that is selected before
//! the axis moves. What changes the tip of the tool, or moves the axis in machine coordinates, ends them.

use crate::diag::{Answer, Help, codes};
use crate::ir::Pos;
use crate::machine::{Axis, AxisSet, Settings};

/// The positions at the start, and the axes that may still stand there.
#[derive(Debug, Clone, Default)]
pub struct Start {
    at: Pos,
    /// Axes that moved, or whose tool tip changed.
    touched: AxisSet,
    /// Where a tool change leaves axes, and whether in machine coordinates.
    after: Pos,
    after_in_machine: bool,
    /// Axes whose place the configuration says, but for another tool than the one in the spindle.
    changed: AxisSet,
}

impl Start {
    /// The positions of `[start]`; under `diameter` X is one.
    pub fn new(settings: &Settings, diameter: bool) -> Start {
        let radius = |axis, value| if diameter && axis == Axis::X { value / 2.0 } else { value };
        let mut at = Pos::UNKNOWN;
        for (&axis, &value) in &settings.start {
            at.set(axis, radius(axis, value));
        }
        let mut after = Pos::UNKNOWN;
        let change = &settings.machine.after_tool_change;
        for (&axis, &value) in &change.at {
            after.set(axis, radius(axis, value));
        }
        Start { at, after, after_in_machine: change.machine, ..Start::default() }
    }

    /// Takes over positions for axes that have none.
    pub fn complete(&mut self, axis: Axis, value: f64) {
        if self.at.get(axis).is_none() {
            self.at.set(axis, value);
        }
    }

    /// Where the axes stand that were not touched, in mm (X: radius) and degrees.
    pub fn position(&self) -> Pos {
        self.at
    }

    /// Where a tool change leaves axes, in mm (X: radius) and degrees, and whether in machine coordinates.
    pub fn after_change(&self) -> (Pos, bool) {
        (self.after, self.after_in_machine)
    }

    /// These axes do not stand at the start any more.
    #[inline]
    pub fn touch(&mut self, axes: AxisSet) {
        self.touched = self.touched.union(axes);
        if !self.at.known().is_empty() {
            for axis in axes.iter() {
                self.at.forget(axis);
            }
        }
    }

    /// The tip of another tool stands elsewhere along this axis.
    pub fn change_tip(&mut self, axis: Axis) {
        if self.at.get(axis).is_some() {
            self.changed.insert(axis);
        }
        self.touch(AxisSet::of(axis));
    }

    /// A work offset is selected in place of another one: the positions counted in that.
    pub fn end(&mut self) {
        self.touch(self.at.known());
    }

    /// What else to do where the position of an axis is not known, as a help goes on: the key that would say it; `changed`: because
    /// the tool was changed.
    pub fn or_say(&self, axis: Axis, changed: bool) -> Help {
        let letter = axis.letter();
        let of_another = if self.changed.contains(axis) {
            codes::P2001::start_says_it_of_tool_before(&letter)
        } else {
            String::new()
        };
        let help = Help::from(of_another);
        if changed && self.after.get(axis).is_none() {
            let key = Answer::entry("machine", "after_tool_change", letter);
            return help.or(key.help(codes::P2001::or_say_where_it_stands_after_change(&letter)));
        }
        if changed || self.touched.contains(axis) {
            return help;
        }
        help.or(Answer::key("start", letter).help(codes::P2001::or_say_where_it_stands_at_start(&letter)))
    }
}
