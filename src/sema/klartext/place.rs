//! Where axes stand behind a tool change and behind M91, as far as the configuration says.
//!
//! `[machine] after_tool_change` counts in the datum in force, or from the machine zero; `[datums]` says where the datum
//! lies. Machine coordinates are those of the spindle nose: the length of the tool does not count in them. Source: K 1.5
//! and 4.2 (docs/sources.md).

use std::fmt::Display;

use crate::diag::{Answer, Fault, codes};
use crate::ir::Pos;
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::sema::run::place::{ACTIVE, Lack, Unknown, out_of_machine, zero};

use super::active_tool::ActiveTool;
use super::words::Words;
use super::{Outcome, Run};

/// The name under `[datums]` of the place that M92 counts from.
const BUILDERS: &str = "M92";

impl ActiveTool {
    /// Length that printed coordinates count with: that of the tool table. DL of a TOOL CALL is part of the coordinates
    /// ([`Run::update_frame`]).
    fn printed_length(&self) -> Option<f64> {
        self.length.map(|length| length + self.table_deltas[0])
    }
}

impl Run<'_> {
    /// The name under `[datums]` of the datum in force: the work offset that its preset is printed as.
    fn datum_name(&self) -> String {
        let Some(row) = self.st.frames.preset_row() else { return ACTIVE.to_owned() };
        match self.core.job.settings.datums.presets.get(&row).map_or(row, |offset| u32::from(*offset)) {
            number @ 1..=6 => format!("G{}", 53 + number),
            number @ 7..=9 => format!("G59.{}", number - 6),
            number => format!("G54.1 P{}", number.saturating_sub(9)),
        }
    }

    /// What lies between the machine coordinate of an axis and its printed place in the datum.
    fn zero_in_machine(&self, axis: Axis) -> Result<f64, Lack> {
        let frames = &self.st.frames;
        if frames.transform().is_turned_as_a_whole() || frames.transform().turn.0 != 0.0 {
            return Err(Lack::Nothing);
        }
        let name = self.datum_name();
        let zero = zero(&self.core.job.settings.datums, &[&name], axis).map_err(|name| Lack::Datum(name.to_owned()))?;
        if axis != self.st.axis() {
            return Ok(zero);
        }
        let tool = self.st.tool.active();
        match tool.and_then(ActiveTool::printed_length) {
            Some(length) => Ok(zero + length),
            None => Err(Lack::Length(tool.and_then(|tool| tool.own))),
        }
    }

    /// The machine coordinate at which an axis stands: named by an M91, or out of its place in the datum.
    pub(super) fn machine_coordinate(&self, axis: Axis) -> Option<f64> {
        match (self.st.position.get(axis), self.st.position.hidden(axis)) {
            (Some(at), _) => {
                let mut place = Pos::UNKNOWN;
                place.set(axis, at);
                let frame = &self.st.ctx.frame;
                let at = if frame.is_shift() {
                    frame.apply(&place).get(axis)
                } else {
                    frame.apply(self.st.position.at()).get(axis)
                };
                Some(at? + self.zero_in_machine(axis).ok()?)
            }
            (None, Some((By::Machine(value), _))) => value,
            (None, _) => None,
        }
    }

    /// These axes went to machine coordinates: their places are known where the datum is.
    pub(super) fn moved_by_machine(&mut self, end: &Pos) {
        let loc = self.core.here.origin.loc;
        self.st.moved_by_machine(end, loc);
        self.stand_in_machine(end);
    }

    /// Machine coordinates of the axes that the next datum finds where they stand: not of those that never moved, which
    /// `[start]` tells in that datum, nor of those that somebody may have moved.
    pub(super) fn machine_coordinates(&self) -> Pos {
        let position = &self.st.position;
        let start = position.start();
        let mut known = Pos::UNKNOWN;
        for axis in AxisSet::MAIN.iter() {
            let open = position.may_be_moved(axis) || position.stands_beside(AxisSet::of(axis));
            match self.machine_coordinate(axis) {
                Some(value) if start.get(axis).is_none() && !open => known.set(axis, value),
                _ => {}
            }
        }
        known
    }

    /// Axes stand at machine coordinates: their places are known where the datum is.
    pub(super) fn stand_in_machine(&mut self, at: &Pos) {
        let places = out_of_machine(at, |axis, value| Some(value - self.zero_in_machine(axis).ok()?));
        self.stand(&places);
    }

    /// The change is over: axes stand where the configuration says.
    pub(super) fn stand_after_change(&mut self) {
        let (after, in_machine) = self.st.position.after_change();
        let places = match in_machine {
            true => out_of_machine(&after, |axis, value| Some(value - self.zero_in_machine(axis).ok()?)),
            false => self.printed(after),
        };
        self.stand(&places);
    }

    /// Places that the control shows in the datum, as they are printed: with the oversize DL of TOOL CALL.
    fn printed(&self, mut places: Pos) -> Pos {
        let axis = self.st.axis();
        let oversize = self.st.tool.active().map_or(0.0, |tool| tool.call_deltas[0]);
        match places.get(axis) {
            Some(shown) if oversize != 0.0 => places.set(axis, shown + oversize),
            _ => {}
        }
        places
    }

    fn stand(&mut self, places: &Pos) {
        // What compensates holds back a move; what is only described stands nowhere.
        if self.st.compensation.is_on() || self.is_capturing() {
            return;
        }
        let known = self.core.stand(&mut self.st.position, places, &self.st.ctx);
        self.st.polar.forget_last_of(known.known());
    }

    /// The new length of the tool counts from here on, or the change moved the axis.
    pub(super) fn forget_tip(&mut self) {
        let (axes, loc) = (AxisSet::of(self.st.axis()), self.core.here.origin.loc);
        self.st.position.forget_tip(axes, By::ToolChange, loc);
        self.st.position.not_lost(axes);
        self.st.polar.forget_last_of(axes);
    }

    /// M92: machine coordinates of an end point that counts from a place of the machine builder.
    pub(super) fn by_builders_datum(&self, w: &Words) -> Outcome<Pos> {
        let span = w.any_m(&[92]).map_or(w.axes_span, |m| m.span);
        if w.has_m(91) {
            return self.core.refuse(span, codes::K9008::m91_m92_count_from_two_places());
        }
        let mut end = Pos::UNKNOWN;
        for (axis, value) in w.axes.iter() {
            match zero(&self.core.job.settings.datums, &[BUILDERS], axis) {
                Ok(zero) => end.set(axis, zero + value),
                Err(name) => {
                    return self.core.refuse(
                        span,
                        codes::K9008::m92_counts_from_position_that_machine_builder(&axis.letter(), &name)
                            .answer(Answer::datum(name)),
                    );
                }
            }
        }
        Ok(end)
    }

    /// An error where the position of an axis is needed and not known; `fault` makes it of the axis and why.
    pub(super) fn unknown_position<T>(
        &self,
        axis: Axis,
        place: impl Into<Where>,
        fault: impl FnOnce(&dyn Display, &dyn Display) -> Fault,
    ) -> Outcome<T> {
        let lack = || self.zero_in_machine(axis).err().unwrap_or(Lack::Nothing);
        let unknown = Unknown { position: &self.st.position, axis, lack: &lack, otherwise: " here" };
        self.core.position_unknown(place, unknown, fault)
    }
}
