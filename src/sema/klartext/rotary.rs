//! Rotary and parallel axes: whole turns, the short way of M126, M94, and what transformations forbid.
//!
//! Source: K 2.14 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Deg;
use crate::ir::Frame;
use crate::machine::{Axis, AxisSet};
use crate::sema::common::position::Position;
use crate::text::Span;

use super::words::Words;
use super::{Core, Outcome, Reported};

/// Rotary axes.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RotaryState {
    /// M126: they take the short way.
    pub short_way: bool,
    /// Whole turns between the printed and the programmed position of A, B, C, in degrees.
    offset: [f64; 3],
    /// Those that the program moved.
    moved: AxisSet,
    /// M128: the tool tip stays where it is when they turn.
    pub follows_tip: bool,
}

impl RotaryState {
    /// Whole turns in degrees that only the output counts; 0 for linear axes.
    pub fn turns_of(&self, axis: Axis) -> f64 {
        if axis.is_rotary() { self.offset[axis.index() - Axis::A.index()] } else { 0.0 }
    }

    #[inline]
    pub fn moves(&mut self, axis: Axis) {
        self.moved.insert(axis);
    }

    /// The printed position of these axes is that of the machine.
    pub fn forget_turns(&mut self, axes: AxisSet) {
        for axis in axes.iter().filter(|axis| axis.is_rotary()) {
            self.offset[axis.index() - Axis::A.index()] = 0.0;
        }
    }

    /// A cycle of the machine turned them.
    pub fn turned_by_machine(&mut self, axes: AxisSet) {
        self.moved = self.moved.union(axes);
        self.forget_turns(axes);
    }

    /// A plane has ended, and they turned back.
    pub fn stand_at_zero(&mut self) {
        self.moved = AxisSet::EMPTY;
        self.offset = [0.0; 3];
    }

    /// M94: the display of rotary axes is taken below 360 degrees; the axes do not move. False if none was beyond.
    pub fn reduce(&mut self, position: &Position, axes: AxisSet) -> bool {
        let mut reduced = false;
        for axis in [Axis::A, Axis::B, Axis::C] {
            if !axes.is_empty() && !axes.contains(axis) {
                continue;
            }
            if let Some(at) = position.get(axis) {
                let offset = &mut self.offset[axis.index() - Axis::A.index()];
                let shown = at - *offset;
                *offset = at - shown % 360.0;
                reduced |= shown % 360.0 != shown;
            }
        }
        reduced
    }

    /// Does every rotary axis that the program moved stand at zero?
    pub fn stands_upright(&self, position: &Position, frame: &Frame) -> bool {
        let at = frame.apply(position.at());
        [Axis::A, Axis::B, Axis::C]
            .into_iter()
            .filter(|axis| self.moved.contains(*axis))
            .all(|axis| at.get(axis).is_some_and(|angle| (angle - self.turns_of(axis)) % 360.0 == 0.0))
    }

    /// M126 and an increment of more than half a turn contradict each other.
    pub fn check_increment(&self, core: &Core<'_>, w: &Words, axis: Axis) -> Outcome {
        let step = w.axes.get(axis).unwrap_or(0.0);
        if !self.short_way || step.abs() <= 180.0 {
            return Ok(());
        }
        core.refuse(w.axes_span, codes::K9008::under_m126_it_is_open_whether_i(&axis.letter(), &step))
    }

    /// Where a rotary axis goes in unbroken degrees, so that the output turns the same way.
    pub fn target(&mut self, core: &Core<'_>, position: &Position, axis: Axis, target: f64, span: Span) -> f64 {
        let offset = &mut self.offset[axis.index() - Axis::A.index()];
        let Some(from) = position.get(axis) else {
            *offset = 0.0;
            return target;
        };
        if self.short_way {
            // `from` already holds the whole turns.
            let ahead = Deg(target - from).normal().0;
            if ahead == 180.0 {
                let fault = codes::K2510::goes_half_turn(&axis.letter());
                core.say(span, fault.help("program M127 if the sense of rotation matters"));
            }
            let step = if ahead > 180.0 { ahead - 360.0 } else { ahead };
            *offset = from + step - target;
            return from + step;
        }
        target + *offset
    }

    /// Under M128 a rotary axis that turns takes the other axes along.
    pub fn check_tip(
        &self,
        core: &Core<'_>,
        position: &Position,
        axis: Axis,
        target: Option<f64>,
        span: Span,
    ) -> Outcome {
        if !self.follows_tip || (target.is_some() && target == position.get(axis)) {
            return Ok(());
        }
        if position.is_lost(axis) {
            return Err(Reported);
        }
        core.refuse(span, codes::K9008::under_m128_tool_tip_stays_while_turns(&axis.letter()))
    }
}
