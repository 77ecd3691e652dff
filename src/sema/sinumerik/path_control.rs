//! Exact stop and smoothing: G60, G9, G64 and its kin, ADIS, CTOL, CYCLE832.
//!
//! Source: S 2.14 and 3 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::function::PathControl;
use crate::parser::sinumerik::ast::{Block, Formula, Op};
use crate::text::Span;

use super::g_groups::{ActiveCodes, GCode, Group};
use super::vocabulary::Address;
use super::words::Words;
use super::{Channel, Core, Outcome, Run};

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

impl Run<'_> {
    /// CYCLE832(S_TOL, S_TOLM, …): a tolerance of the contour, or none.
    pub(super) fn high_speed_settings(
        &mut self,
        formulas: &[Formula],
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let mut given = formulas.iter().filter(|formula| !formula.is_missing());
        let first = formulas.first().filter(|formula| !formula.is_missing());
        let tolerance = match first {
            Some(formula) => self.number(*formula, block, text)?,
            None => 0.0,
        };
        let off = match formulas.get(1).filter(|formula| !formula.is_missing()) {
            None => false,
            // The modes have names, which the control defines.
            Some(formula) => match block.formula(*formula) {
                [Op::Name(name, _)] if self.channel.core.symbols.name(*name).starts_with('_') => {
                    self.channel.core.symbols.name(*name) == "_OFF"
                }
                _ => self.number(*formula, block, text)? == 0.0,
            },
        };
        if tolerance < 0.0 {
            return self.channel.core.refuse(span, codes::S2045::cycle832_with_tolerance(&tolerance));
        }
        if given.nth(1).is_some() {
            self.channel.core.dynamics_are_left_out(span);
        }
        let unit = self.channel.st.codes.length_unit();
        let smoothing = &mut self.channel.st.smoothing;
        smoothing.cycle = (tolerance > 0.0 && !off).then_some(tolerance * unit);
        if smoothing.cycle.is_none() {
            // Which code of the group holds now is a matter of the machine builder.
            (smoothing.said, smoothing.tolerance) = (false, 0.0);
        }
        self.channel.send_smoothing();
        Ok(())
    }
}
