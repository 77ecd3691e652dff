//! Where axes stand behind a tool change, and behind moves in machine coordinates, as far as the configuration says.
//!
//! A work offset counts from the basic frame, and that from the machine zero; `[datums]` has both. Source: S 4.7 and 4.8
//! (docs/sources.md).

use std::fmt::Display;

use crate::diag::{Fault, codes};
use crate::geo::{Plane, Point2};
use crate::ir::Pos;
use crate::machine::{Axis, AxisSet, Settings};
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::sema::run::place::{ACTIVE, BASIC, Lack, Unknown, out_of_machine, zero};
use crate::text::Loc;

use super::machine_place::ToolLength;
use super::offsets::{Outer, offset_word};
use super::{Channel, Core, Outcome, Reported, State};

impl State {
    /// The machine coordinate of the zero that positions in the frame of the program count from.
    fn zero(&self, settings: &Settings, axis: Axis) -> Result<f64, Lack> {
        let offsets = &self.offsets;
        let word;
        let names: &[&str] = match offsets.outer() {
            _ if self.transformation.is_some() || self.orientation.is_disturbed() => return Err(Lack::Nothing),
            Outer::Printed(number) => {
                word = offset_word(number);
                &[&word, BASIC]
            }
            Outer::Basic if offsets.is_basic_said() => &[BASIC],
            Outer::Basic => &[ACTIVE],
            Outer::Machine => &[],
            Outer::Unrelated => return Err(Lack::Nothing),
        };
        zero(&settings.datums, names, axis).map_err(|name| Lack::Datum(name.to_owned()))
    }

    /// What lies between the machine coordinate of an axis, where the spindle nose or the turret stands, and the place of the tip.
    fn zero_in_machine(&self, settings: &Settings, axis: Axis) -> Result<f64, Lack> {
        let zero = self.zero(settings, axis)?;
        if !self.tool_axes().contains(axis) {
            return Ok(zero);
        }
        match self.active_length(settings) {
            ToolLength::Off => Ok(zero),
            ToolLength::Known(length) => Ok(zero + length),
            ToolLength::Unknown if self.machine.lathe => Err(Lack::Nothing),
            ToolLength::Unknown => Err(Lack::Length(self.tool.active())),
        }
    }

    /// An error where the position of an axis is needed and not known.
    pub(super) fn no_position<T>(
        &self,
        core: &Core<'_>,
        axis: Axis,
        place: impl Into<Where>,
        fault: impl FnOnce(&dyn Display, &dyn Display) -> Fault,
    ) -> Outcome<T> {
        let lack = || self.zero_in_machine(core.job.settings, axis).err().unwrap_or(Lack::Nothing);
        let unknown = Unknown { position: &self.position, axis, lack: &lack, otherwise: "" };
        core.position_unknown(place, unknown, fault)
    }

    /// Do positions without the frame of the program count in a work offset of the machine?
    fn counts_from_a_work_offset(&self) -> bool {
        self.transformation.is_none()
            && !self.orientation.is_disturbed()
            && !self.offsets.in_machine()
            && self.frames.settable().is_none_or(|frame| *frame == super::frames::FrameValue::default())
    }

    pub(super) fn unknown_axis<T>(&self, core: &Core<'_>, axis: Axis, place: impl Into<Where>) -> Outcome<T> {
        if self.position.is_lost(axis) {
            return Err(Reported);
        }
        self.no_position(core, axis, place, codes::P2001::where_axis_stands_is_not_known)
    }

    /// The tip of another tool, or edge, stands elsewhere.
    pub(super) fn forget_tip(&mut self, loc: Loc, by: By) {
        let [_, _, third] = self.roles();
        let lathe = self.machine.lathe;
        let axes = match by {
            // The changer moves an axis of the machine, and with it all those of the plane.
            By::ToolChange if self.frames.is_tilted() => AxisSet::MAIN,
            _ if lathe => [Axis::X, Axis::Z].into_iter().collect(),
            _ => AxisSet::of(third),
        };
        self.position.forget_tip(axes, by, loc);
    }

    /// Where the tool stands in a plane.
    pub(super) fn stands_in(&self, core: &Core<'_>, plane: Plane, place: impl Into<Where>) -> Outcome<Point2> {
        let (first, second, _) = plane.axes();
        match self.position.in_plane(plane) {
            Some(at) => Ok(at),
            None if self.position.get(Axis::ALL[first]).is_none() => self.unknown_axis(core, Axis::ALL[first], place),
            None => self.unknown_axis(core, Axis::ALL[second], place),
        }
    }
}

impl Channel<'_> {
    /// A machine move led the axes of `end` there, and the tip to the coordinates of `tip`.
    pub(super) fn moved_by_machine(&mut self, end: &Pos, tip: &Pos) {
        let (ctx, loc) = (self.st.ctx.clone(), self.core.here.origin.loc);
        self.st.position.moved_by_machine(end, &ctx.frame, loc);
        // Each coordinate of a tilted plane depends on each axis of the machine.
        if self.st.frames.is_tilted() && !end.known().common(AxisSet::MAIN).is_empty() {
            self.st.position.forget(AxisSet::MAIN);
            self.st.position.hide(AxisSet::MAIN, By::Machine(None), loc);
        }
        let places = out_of_machine(end, |axis, value| match tip.get(axis) {
            Some(tip) => Some(tip - self.st.zero(self.core.job.settings, axis).ok()?),
            None => Some(value - self.st.zero_in_machine(self.core.job.settings, axis).ok()?),
        });
        self.stand(&places);
    }

    /// The change is over: axes stand where the configuration says.
    pub(super) fn stand_after_change(&mut self) {
        let (after, in_machine) = self.st.position.after_change();
        let places = match in_machine {
            true => out_of_machine(&after, |axis, value| {
                Some(value - self.st.zero_in_machine(self.core.job.settings, axis).ok()?)
            }),
            false if self.st.counts_from_a_work_offset() => after,
            false => return,
        };
        self.stand(&places);
    }

    fn stand(&mut self, places: &Pos) {
        if self.st.side() != crate::ir::Side::None || self.capture.is_some() {
            return;
        }
        self.core.stand(&mut self.st.position, places, &self.st.ctx);
    }
}
