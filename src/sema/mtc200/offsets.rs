//! Zero offsets and machine positions: G50 to G59, G74.
//!
//! Offsets of X are radius values under diameter programming, and all follow G70 and G71. Source: M 6.4 (docs/sources.md).

use std::rc::Rc;

use nalgebra::Matrix3;

use crate::diag::{Answer, Fault, codes};
use crate::ir::contour::Ctx;
use crate::ir::{Frame, Function, Pos};
use crate::machine::axis::AXES;
use crate::machine::options::mtc200::{G52, Reading, ShiftedIncrement};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::position::Position;
use crate::sema::run::OffsetName;
use crate::text::Span;

pub(super) use super::g_functions::Offset;

use super::g_functions::G;
use super::words::Words;
use super::{Outcome, Run};

/// Work offset and programmed offsets.
#[derive(Debug, Clone, Copy)]
pub(super) struct OffsetState {
    offset: Offset,
    /// G50, G51 and G52 together, radius values.
    shift: [f64; AXES],
    /// A part of `shift` comes from G51 or G52.
    added: bool,
    /// Axes whose offset changed since they moved.
    shifted: AxisSet,
    /// Axes of which the program, or the start, has said a number.
    written: AxisSet,
}

impl OffsetState {
    /// Of axes in `written` the start has said a number.
    pub fn new(written: AxisSet) -> OffsetState {
        OffsetState { offset: Offset::Start, shift: [0.0; AXES], added: false, shifted: AxisSet::EMPTY, written }
    }

    #[inline]
    pub fn offset(&self) -> Offset {
        self.offset
    }

    /// The offset of this axis changed since it moved.
    #[inline]
    pub fn is_shifted(&self, axis: Axis) -> bool {
        self.shifted.contains(axis)
    }

    /// These axes move.
    #[inline]
    pub fn arrive(&mut self, axes: AxisSet) {
        self.written = self.written.union(axes);
        self.shifted = self.shifted.without(axes);
    }

    /// Another program begins, which has said no number yet.
    pub fn forget_written(&mut self) {
        self.written = AxisSet::EMPTY;
    }

    /// Which offset is in force depends on the machine.
    pub fn reset(&mut self) {
        self.offset = Offset::Reset;
    }

    /// May `offset` be selected?
    fn may_become(&self, offset: Offset, compensated: bool) -> Result<(), Fault> {
        if compensated {
            return Err(codes::P1003::zero_offset_changes_under_path_compensation());
        }
        if offset == Offset::Machine && self.shift != [0.0; AXES] {
            return Err(codes::M2101::g53_while_offset_of_g50_or_g51());
        }
        Ok(())
    }

    /// May G50, G51 or G52 of a block stand here?
    fn may_shift(&self, named: AxisSet, compensated: bool) -> Result<(), Fault> {
        if named.is_empty() {
            return Err(codes::P1004::offset_names_no_axis());
        }
        if compensated {
            return Err(codes::P1003::zero_offset_changes_under_path_compensation());
        }
        if self.offset == Offset::Machine {
            return Err(codes::M2101::programmed_offset_while_g53_is_active());
        }
        Ok(())
    }

    /// The offsets together behind G50, G51 or G52 with these values; G52 shifts by them.
    fn shifted_by(&self, g: G, values: [f64; AXES], named: AxisSet) -> Result<[f64; AXES], Fault> {
        if g != G::ShiftTo {
            return Ok(std::array::from_fn(|i| self.shift[i] + values[i]));
        }
        match Axis::ALL.into_iter().find(|a| self.shift[a.index()] != 0.0 && !named.contains(*a)) {
            Some(axis) => Err(codes::M2014::g50_does_not_say_whether_keeps(&axis.letter())),
            None => Ok(values),
        }
    }

    /// The zero point moves.
    fn put_in_force(&mut self, shift: [f64; AXES], added: bool) {
        for axis in Axis::ALL.into_iter().filter(|axis| shift[axis.index()] != self.shift[axis.index()]) {
            self.shifted.insert(axis);
        }
        (self.shift, self.added) = (shift, added);
    }

    /// The number of the program that an increment is added to, behind a changed offset; where the axis stands without one.
    #[inline]
    pub fn counts_from(&self, axis: Axis, position: &Position, way: ShiftedIncrement) -> Result<Option<f64>, Fault> {
        if !self.is_shifted(axis) {
            return Ok(None);
        }
        match way {
            ShiftedIncrement::Increment => Ok(None),
            ShiftedIncrement::WithOffset => Ok(position.programmed(axis).filter(|_| self.written.contains(axis))),
            ShiftedIncrement::Refuse => Err(may_count_from_either(axis)),
        }
    }

    /// An arc under G91 behind a changed offset starts where the tool stands only in one of the two readings.
    pub fn starts_arc(&self, axes: [Axis; 2], way: ShiftedIncrement) -> Result<(), Fault> {
        match axes.into_iter().find(|axis| self.is_shifted(*axis)) {
            Some(axis) if way != ShiftedIncrement::Increment => Err(may_count_from_either(axis)),
            _ => Ok(()),
        }
    }
}

/// An increment right behind a changed offset: from the tool, or from the last programmed position?
#[cold]
fn may_count_from_either(axis: Axis) -> Fault {
    codes::M2018::is_incremental_its_zero_offset_changed_since(&axis.letter())
        .answer(Answer::key("control", "g91_after_offset"))
}

impl Run<'_> {
    /// G53 to G59.
    pub(super) fn set_offset(&mut self, offset: Offset, span: Span) -> Outcome {
        let before = self.st.offsets.offset;
        if before == offset {
            return Ok(());
        }
        self.core.accept(span, self.st.offsets.may_become(offset, self.st.compensation.is_on()))?;
        match (before, offset) {
            (Offset::Start, Offset::Work(number)) => self.core.moves_before_offset(number, span),
            (Offset::Start, _) => {}
            _ => self.st.position.end_start(),
        }
        self.st.offsets.offset = offset;
        if let Offset::Work(number) = offset {
            let word = format!("G{}", 53 + u32::from(number));
            self.core.prints_offset(OffsetName::Fixed(&word), number, span)?;
            self.core.send_function(&Function::WorkOffset(number), &self.st.ctx);
        }
        self.st.forget(self.st.position.at().known());
        if offset != Offset::Machine {
            let offsets = &mut self.st.offsets;
            if self.core.job.settings.control.mtc200.g91_after_offset == ShiftedIncrement::WithOffset {
                offsets.shifted = offsets.shifted.union(offsets.written);
            }
            self.st.position.take_start(&self.st.ctx.frame);
        }
        self.st.corners.cannot_follow();
        Ok(())
    }

    /// G50, G51, G52: the zero point moves, the tool does not.
    pub(super) fn programmed_offset(&mut self, g: G, w: &Words, span: Span) -> Outcome {
        let named = w.axes.known();
        self.core.accept(span, self.st.offsets.may_shift(named, self.st.compensation.is_on()))?;
        let mut values = [0.0; AXES];
        for (axis, value) in w.axes.iter() {
            values[axis.index()] = self.core.accept(w.axes_span, self.st.dimensions.radius_length(axis, value))?;
        }
        match (g, self.core.job.settings.control.mtc200.g52) {
            (G::ShiftTo, _) if self.st.offsets.added => {
                self.core.reading(Reading::G50, span, codes::P8106::g50_replaces_everything);
            }
            (G::Name, G52::Refuse) => {
                let asking = codes::M9006::meaning_of_g52_is_not_known();
                return self.core.refuse(span, asking.answer(Answer::key("control", "g52")));
            }
            (G::Name, G52::Position) => {
                for axis in named.iter() {
                    let at = self.core.stands(&self.st.position, axis, w.axes_span)?;
                    values[axis.index()] = at - values[axis.index()];
                }
            }
            _ => {}
        }
        let shift = self.core.accept(span, self.st.offsets.shifted_by(g, values, named))?;
        let Some(frame) = Frame::new(Matrix3::identity(), shift) else {
            return self.core.refuse(span, codes::P2022::offset_is_too_large());
        };
        self.st.position.keep_programmed();
        self.st.position.through_frame(&self.st.ctx.frame, &frame);
        self.st.offsets.put_in_force(shift, g != G::ShiftTo);
        self.st.ctx = Rc::new(Ctx { frame, ..(*self.st.ctx).clone() });
        self.st.corners.cannot_follow();
        Ok(())
    }

    /// G74: the named axes go to their home position.
    pub(super) fn home(&mut self, w: &Words, span: Span) -> Outcome {
        if w.axes.known().is_empty() {
            return self.core.refuse(span, codes::P1004::g74_names_no_axis());
        }
        if self.st.compensation.is_on() || self.st.corners.is_open() {
            return self.core.refuse(span, codes::P1003::g74_inside_compensated_contour_or_corner());
        }
        let mut end = Pos::UNKNOWN;
        for (axis, value) in w.axes.iter() {
            let letter = axis.letter();
            if value != 0.0 {
                return self.core.refuse(w.axes_span, codes::P1003::only_names_its_axis_beside_g74(&letter));
            }
            let Some(home) = self.core.job.settings.control.mtc200.home.get(&axis) else {
                let asking = codes::M9005::home_position_of_is_known(&letter);
                return self.core.refuse(span, asking.answer(Answer::entry("control", "home", letter)));
            };
            end.set(axis, *home);
        }
        self.machine_position(end, None);
        Ok(())
    }
}
