//! Where axes stand as the configuration says, for a reader of plain G-code.

use crate::ir::Pos;
use crate::machine::Axis;
use crate::read::{Reader, SCALE};

use super::super::common::start::Start;
use super::Run;

/// The axes that have not moved stand where the configuration says.
pub(super) fn stand(reader: &mut Reader, start: &Start) {
    for (axis, place) in start.position().iter() {
        place_at(reader, axis, place);
    }
}

/// An axis stands there, in mm or degrees, although no line says so.
fn place_at(reader: &mut Reader, axis: Axis, place: f64) {
    let units = libm::rint(place * SCALE as f64);
    if units.abs() < 9e18 {
        reader.stand(axis.index(), units as i64);
    }
}

impl Run<'_> {
    /// The change is over: axes stand where the configuration says. The length of the tool is the receiver's, so machine
    /// coordinates say nothing of its tip.
    pub(super) fn stand_after_change(&mut self) -> Pos {
        let (after, in_machine) = self.start.after_change();
        if in_machine {
            return Pos::UNKNOWN;
        }
        for (axis, place) in after.iter() {
            place_at(&mut self.reader, axis, place);
        }
        after
    }
}
