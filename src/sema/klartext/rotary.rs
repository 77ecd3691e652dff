//! Rotary and parallel axes: whole turns, the short way of M126, M94, and what transformations forbid.
//!
//! Source: K 2.14 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Deg;
use crate::ir::Pos;
use crate::machine::{Axis, AxisSet};
use crate::sema::common::position::Position;
use crate::text::Span;

use super::words::Words;
use super::{Outcome, Run};

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

    pub fn has_moved(&self, axis: Axis) -> bool {
        self.moved.contains(axis)
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
}

impl RotaryState {
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
}

impl Run<'_> {
    #[cold]
    pub(super) fn rare_axes(&mut self, w: &Words, mut end: Pos, cuts: bool) -> Outcome<Pos> {
        self.no_rotary_move_under_turn(end.known(), w.axes_span)?;
        for axis in end.known().without(AxisSet::MAIN).iter() {
            if !axis.is_rotary() {
                if let Some(what) = self.st.frames.transform().touches_parallel(axis) {
                    return self.core.refuse(w.axes_span, codes::K2506::moves_while_is_active(&axis.letter(), &what));
                }
                continue;
            }
            if self.st.feed.at_surface && cuts {
                return self.core.refuse(w.axes_span, codes::K2509::moves_at_feed_under_m116(&axis.letter()));
            }
            self.st.rotary.moves(axis);
            if w.incremental.contains(axis) {
                self.check_tip(w, axis, end.get(axis))?;
                // Counted from a position that holds the whole turns already.
                self.check_increment(w, axis)?;
                continue;
            }
            let target = end.get(axis).unwrap_or(0.0);
            let target = self.rotary_target(axis, target, w.axes_span);
            self.check_tip(w, axis, Some(target))?;
            end.set(axis, target);
        }
        Ok(end)
    }

    /// M126 and an increment of more than half a turn contradict each other.
    fn check_increment(&mut self, w: &Words, axis: Axis) -> Outcome {
        let step = w.axes.get(axis).unwrap_or(0.0);
        if !self.st.rotary.short_way || step.abs() <= 180.0 {
            return Ok(());
        }
        self.core.refuse(w.axes_span, codes::K9008::under_m126_it_is_open_whether_i(&axis.letter(), &step))
    }

    /// Where a rotary axis goes in unbroken degrees, so that the output turns the same way.
    pub(super) fn rotary_target(&mut self, axis: Axis, target: f64, span: Span) -> f64 {
        let offset = &mut self.st.rotary.offset[axis.index() - Axis::A.index()];
        let Some(from) = self.st.position.get(axis) else {
            *offset = 0.0;
            return target;
        };
        if self.st.rotary.short_way {
            // `from` already holds the whole turns.
            let ahead = Deg(target - from).normal().0;
            if ahead == 180.0 {
                let found = codes::K2510::goes_half_turn(&axis.letter()).at(self.core.loc(span));
                self.core.report(found.help("program M127 if the sense of rotation matters"));
            }
            let step = if ahead > 180.0 { ahead - 360.0 } else { ahead };
            *offset = from + step - target;
            return from + step;
        }
        target + *offset
    }
}
