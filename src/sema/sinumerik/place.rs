//! Where axes stand behind a tool change, and behind moves in machine coordinates, as far as the configuration says.
//!
//! A work offset counts from the basic frame, and that from the machine zero; `[datums]` has both. Source: S 4.7 and 4.8
//! (docs/sources.md).

use std::fmt::Display;

use crate::diag::Fault;
use crate::ir::Pos;
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::sema::run::place::{ACTIVE, BASIC, Lack, Unknown, out_of_machine, zero};

use super::machine_place::ToolLength;
use super::offsets::{Outer, offset_word};
use super::{Channel, Outcome};

impl Channel<'_> {
    /// The machine coordinate of the zero that positions in the frame of the program count from.
    fn zero(&self, axis: Axis) -> Result<f64, Lack> {
        let offsets = &self.st.offsets;
        let word;
        let names: &[&str] = match offsets.outer() {
            _ if self.st.transformation.is_some() => return Err(Lack::Nothing),
            Outer::Printed(number) => {
                word = offset_word(number);
                &[&word, BASIC]
            }
            Outer::Basic if offsets.is_basic_said() => &[BASIC],
            Outer::Basic => &[ACTIVE],
            Outer::Machine => &[],
            Outer::Unrelated => return Err(Lack::Nothing),
        };
        zero(&self.core.job.settings.datums, names, axis).map_err(|name| Lack::Datum(name.to_owned()))
    }

    /// What lies between the machine coordinate of an axis, where the spindle nose or the turret stands, and the place of the tip.
    fn zero_in_machine(&self, axis: Axis) -> Result<f64, Lack> {
        let zero = self.zero(axis)?;
        if !self.st.tool_axes().contains(axis) {
            return Ok(zero);
        }
        match self.active_length() {
            ToolLength::Off => Ok(zero),
            ToolLength::Known(length) => Ok(zero + length),
            ToolLength::Unknown if self.st.machine.lathe => Err(Lack::Nothing),
            ToolLength::Unknown => Err(Lack::Length(self.st.tool.active())),
        }
    }

    /// A machine move led the axes of `end` there, and the tip to the coordinates of `tip`.
    pub(super) fn moved_by_machine(&mut self, end: &Pos, tip: &Pos) {
        let (ctx, loc) = (self.st.ctx.clone(), self.core.here.origin.loc);
        self.st.position.moved_by_machine(end, &ctx.frame, loc);
        let places = out_of_machine(end, |axis, value| match tip.get(axis) {
            Some(tip) => Some(tip - self.zero(axis).ok()?),
            None => Some(value - self.zero_in_machine(axis).ok()?),
        });
        self.stand(&places);
    }

    /// The tip of another tool, or edge, stands elsewhere.
    pub(super) fn forget_tip(&mut self, by: By) {
        let [_, _, third] = self.st.roles();
        let lathe = self.st.machine.lathe;
        let axes = if lathe { [Axis::X, Axis::Z].into_iter().collect() } else { AxisSet::of(third) };
        let loc = self.core.here.origin.loc;
        self.st.position.forget_tip(axes, by, loc);
    }

    /// The change is over: axes stand where the configuration says.
    pub(super) fn stand_after_change(&mut self) {
        let (after, in_machine) = self.st.position.after_change();
        let places = match in_machine {
            true => out_of_machine(&after, |axis, value| Some(value - self.zero_in_machine(axis).ok()?)),
            false if self.counts_from_a_work_offset() => after,
            false => return,
        };
        self.stand(&places);
    }

    /// Do positions without the frame of the program count in a work offset of the machine?
    fn counts_from_a_work_offset(&self) -> bool {
        self.st.transformation.is_none()
            && !self.st.offsets.in_machine()
            && self.st.frames.settable().is_none_or(|frame| *frame == super::frames::FrameValue::default())
    }

    fn stand(&mut self, places: &Pos) {
        if self.st.side() != crate::ir::Side::None || self.is_capturing() {
            return;
        }
        self.core.stand(&mut self.st.position, places, &self.st.ctx);
    }

    /// An error where the position of an axis is needed and not known.
    pub(super) fn no_position<T>(
        &self,
        axis: Axis,
        place: impl Into<Where>,
        fault: impl FnOnce(&dyn Display, &dyn Display) -> Fault,
    ) -> Outcome<T> {
        let lack = || self.zero_in_machine(axis).err().unwrap_or(Lack::Nothing);
        let unknown = Unknown { position: &self.st.position, axis, lack: &lack, otherwise: "" };
        self.core.position_unknown(place, unknown, fault)
    }
}
