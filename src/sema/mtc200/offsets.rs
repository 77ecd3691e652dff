//! Zero offsets and machine positions: G50 to G59, G74.
//!
//! Offsets of X are radius values under diameter programming, and all follow G70 and G71. Source: M 6.4 (docs/sources.md).

use std::rc::Rc;

use nalgebra::Matrix3;

use crate::diag::{Answer, codes};
use crate::ir::contour::Ctx;
use crate::ir::{Frame, Function, Pos};
use crate::machine::axis::AXES;
use crate::machine::options::mtc200::{G52, Reading, ShiftedIncrement};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::By;
use crate::sema::run::OffsetName;
use crate::text::Span;

use super::g_functions::G;
use super::g_functions::Offset;
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

    /// The program has said a number of this axis.
    pub fn is_written(&self, axis: Axis) -> bool {
        self.written.contains(axis)
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
}

impl Run<'_> {
    /// G53 to G59.
    pub(super) fn set_offset(&mut self, offset: Offset, span: Span) -> Outcome {
        if self.st.offsets.offset == offset {
            return Ok(());
        }
        if self.st.compensation.is_on() {
            return self.core.refuse(span, codes::P1003::zero_offset_changes_under_path_compensation());
        }
        if offset == Offset::Machine && self.st.offsets.shift != [0.0; AXES] {
            return self.core.refuse(span, codes::M2101::g53_while_offset_of_g50_or_g51());
        }
        match (self.st.offsets.offset, offset) {
            (Offset::Start, Offset::Work(number)) => self.core.moves_before_offset(number, span),
            (Offset::Start, _) => {}
            _ => self.st.position.end_start(),
        }
        self.st.offsets.offset = offset;
        if let Offset::Work(number) = offset {
            let word = format!("G{}", 53 + u32::from(number));
            self.core.prints_offset(OffsetName::Fixed(&word), number, span)?;
            self.function(Function::WorkOffset(number));
        }
        self.st.forget(self.st.position.at().known());
        if offset != Offset::Machine {
            if self.core.job.settings.control.mtc200.g91_after_offset == ShiftedIncrement::WithOffset {
                self.st.offsets.shifted = self.st.offsets.shifted.union(self.st.offsets.written);
            }
            self.st.position.take_start(&self.st.ctx.frame);
        }
        self.st.corners.cannot_follow();
        Ok(())
    }

    #[cold]
    pub(super) fn offset_is_certain(&mut self, span: Span) -> Outcome {
        if self.st.offsets.offset != Offset::Reset {
            return Ok(());
        }
        self.core.refuse(span, codes::M2102::zero_offset_after_jmp_depends_on_machine())
    }

    /// G50, G51, G52.
    pub(super) fn programmed_offset(&mut self, g: G, w: &Words, span: Span) -> Outcome {
        if w.axes.known().is_empty() {
            return self.core.refuse(span, codes::P1004::offset_names_no_axis());
        }
        if self.st.compensation.is_on() {
            return self.core.refuse(span, codes::P1003::zero_offset_changes_under_path_compensation());
        }
        if self.st.offsets.offset == Offset::Machine {
            return self.core.refuse(span, codes::M2101::programmed_offset_while_g53_is_active());
        }
        let mut values = [0.0; AXES];
        for (axis, value) in w.axes.iter() {
            values[axis.index()] = self.radius_length(axis, value, w.axes_span)?;
        }
        let named = w.axes.known();
        let mut shift = self.st.offsets.shift;
        match g {
            G::ShiftTo => {
                if self.st.offsets.added {
                    self.reading(Reading::G50, span, codes::P8106::g50_replaces_everything);
                }
                if let Some(axis) = Axis::ALL.into_iter().find(|a| shift[a.index()] != 0.0 && !named.contains(*a)) {
                    let letter = axis.letter();
                    return self.core.refuse(span, codes::M2014::g50_does_not_say_whether_keeps(&letter));
                }
                shift = values;
            }
            G::ShiftBy => add(&mut shift, &values),
            _ => match self.core.job.settings.control.mtc200.g52 {
                G52::Refuse => {
                    return self.core.refuse(
                        span,
                        codes::M9006::meaning_of_g52_is_not_known().answer(Answer::key("control", "g52")),
                    );
                }
                G52::Shift => add(&mut shift, &values),
                G52::Position => {
                    for axis in named.iter() {
                        let i = axis.index();
                        shift[i] += self.position_of(axis, w.axes_span)? - values[i];
                    }
                }
            },
        }
        self.st.offsets.added = g != G::ShiftTo;
        self.put_in_force(shift, span)
    }

    /// A length that is never a diameter.
    fn radius_length(&mut self, axis: Axis, value: f64, span: Span) -> Outcome<f64> {
        let length = self.length(axis, value, span)?;
        Ok(if axis == Axis::X && self.st.diameter { 2.0 * length } else { length })
    }

    /// The zero point moves, the tool does not.
    fn put_in_force(&mut self, shift: [f64; AXES], span: Span) -> Outcome {
        let Some(frame) = Frame::new(Matrix3::identity(), shift) else {
            return self.core.refuse(span, codes::P2022::offset_is_too_large());
        };
        self.st.position.keep_programmed();
        self.st.position.through_frame(&self.st.ctx.frame, &frame);
        for axis in Axis::ALL {
            if shift[axis.index()] != self.st.offsets.shift[axis.index()] {
                self.st.offsets.shifted.insert(axis);
            }
        }
        self.st.offsets.shift = shift;
        self.st.ctx = Rc::new(Ctx { plane: self.st.plane, frame, compensation: self.st.ctx.compensation.clone() });
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
            match self.core.job.settings.control.mtc200.home.get(&axis) {
                Some(home) => end.set(axis, *home),
                None => {
                    return self.core.refuse(
                        span,
                        codes::M9005::home_position_of_is_known(&letter)
                            .answer(Answer::entry("control", "home", letter)),
                    );
                }
            }
        }
        self.machine_position(end, None);
        Ok(())
    }

    /// A new tool has its tip elsewhere.
    pub(super) fn forget_tip(&mut self) {
        self.st.forget(AxisSet::MAIN);
        self.st.position.leave_start(AxisSet::MAIN);
        let loc = self.core.here.origin.loc;
        self.st.position.hide(AxisSet::MAIN, By::ToolChange, loc);
    }

    /// The change is over: axes stand where the configuration says. How machine coordinates take the length of a tool is not
    /// documented.
    pub(super) fn stand_after_change(&mut self) {
        let (after, in_machine) = self.st.position.after_change();
        if in_machine {
            return;
        }
        let ctx = Rc::clone(&self.st.ctx);
        let known = self.st.position.stand_in_offset(&after, &ctx.frame);
        self.st.offsets.arrive(known.known());
        self.core.stands_at(&known, &ctx);
    }
}

fn add(shift: &mut [f64; AXES], values: &[f64; AXES]) {
    for (sum, value) in shift.iter_mut().zip(values) {
        *sum += value;
    }
}
