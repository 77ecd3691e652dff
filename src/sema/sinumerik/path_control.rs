//! Exact stop and smoothing: G60, G9, G64 and its kin, ADIS, CTOL, CYCLE832.
//!
//! Source: S 2.14 and 3 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::function::PathControl;

use super::g_groups::{ActiveCodes, GCode, Group};
use super::vocabulary::Address;
use super::words::Words;
use super::{Channel, Core};

/// What the program says of corners.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Smoothing {
    /// A code of group 10 was programmed: which one holds before is machine data.
    said: bool,
    /// ADIS and CTOL in mm; what is not above zero says nothing.
    distance: f64,
    tolerance: f64,
    /// The tolerance of CYCLE832, up to the next code of the group.
    cycle: Option<f64>,
    /// G9 stands in this block.
    block: bool,
    /// What was handed on last.
    sent: Option<PathControl>,
}

impl Smoothing {
    /// What holds under these codes; `None` where the program says nothing that can be known.
    fn mode(&self, codes: &ActiveCodes) -> Option<PathControl> {
        if self.block {
            return Some(PathControl::Exact);
        }
        let within = |mm: f64| (mm > 0.0).then_some(PathControl::Within(mm));
        if let Some(tolerance) = self.cycle {
            return within(tolerance);
        }
        match codes.of(Group::ExactStop) {
            _ if !self.said => None,
            GCode::G60 => Some(PathControl::Exact),
            GCode::G64 => Some(PathControl::Unbounded),
            // Without a distance it is G64.
            GCode::G641 if self.distance > 0.0 => Some(PathControl::Before(self.distance)),
            GCode::G641 => Some(PathControl::Unbounded),
            GCode::G642 | GCode::G643 | GCode::G645 => within(self.tolerance),
            // G644 rounds as the dynamics of the axes have it.
            _ => None,
        }
    }

    /// What SAVE brings back beside the codes.
    pub fn restore(&mut self, saved: Smoothing) {
        (self.said, self.cycle) = (saved.said, saved.cycle);
    }

    /// The words of a block that say how corners are taken.
    pub fn program(&mut self, core: &Core<'_>, codes_on: &ActiveCodes, w: &Words) {
        let unit = codes_on.length_unit();
        let code = w.code_of(Group::ExactStop);
        if code.is_some() {
            (self.said, self.cycle) = (true, None);
        }
        if let Some(distance) = w.smoothing.distance {
            self.distance = distance * unit;
        }
        if let Some(tolerance) = w.smoothing.tolerance {
            self.tolerance = tolerance * unit;
        }
        self.block = w.code_of(Group::ExactStopBlock).is_some() && may_move(w);
        if let Some((code, span)) = code
            && matches!(code.index, 4..)
            && self.mode(codes_on).is_none()
        {
            core.say_once(span, codes::S8002::rounds_corners_by_machine_data(&code.word()));
        }
    }

    /// Behind its block, G9 counts no longer. True where it stood there.
    #[inline]
    pub fn block_ends(&mut self) -> bool {
        std::mem::take(&mut self.block)
    }
}

impl Channel<'_> {
    /// CYCLE832: a tolerance of the contour in the unit of the program, or none.
    pub(super) fn smooth_by_cycle(&mut self, tolerance: Option<f64>) {
        let unit = self.st.codes.length_unit();
        let smoothing = &mut self.st.smoothing;
        smoothing.cycle = tolerance.filter(|tolerance| *tolerance > 0.0).map(|tolerance| tolerance * unit);
        if smoothing.cycle.is_none() {
            // Which code of the group holds now is a matter of the machine builder.
            (smoothing.said, smoothing.tolerance) = (false, 0.0);
        }
        self.send_smoothing();
    }

    /// Hands on how corners are taken, where it changed. A contour that is only described says nothing of it.
    pub(super) fn send_smoothing(&mut self) {
        let mode = self.st.smoothing.mode(&self.st.codes);
        if mode != self.st.smoothing.sent && self.capture.is_none() {
            self.st.smoothing.sent = mode;
            self.function(Function::PathControl(mode));
        }
    }
}

/// Words for which a block may move.
const MOVING: [Address; 9] = [
    Address::Ap,
    Address::Rp,
    Address::Ang,
    Address::I,
    Address::J,
    Address::K,
    Address::Cr,
    Address::Ar,
    Address::Turn,
];

/// In a block that moves no axis, G9 stops nothing.
fn may_move(w: &Words) -> bool {
    !w.axes.is_empty() || !w.beside.positioning.is_empty() || MOVING.iter().any(|word| w.get(*word).is_some())
}
