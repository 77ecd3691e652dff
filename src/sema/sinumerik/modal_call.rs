//! MCALL: what runs after every block that moves.

use crate::text::Loc;

use super::cycle_call::ModalCycle;
use super::vars::Argument;

/// A program that runs behind every positioning block.
#[derive(Debug, Clone)]
struct ModalProgram {
    unit: usize,
    arguments: Vec<Argument>,
}

/// What runs after every block that moves: MCALL.
#[derive(Debug, Clone, Default)]
pub(super) struct ModalCall {
    program: Option<ModalProgram>,
    cycle: Option<Box<ModalCycle>>,
    /// Where the call stands.
    site: Loc,
    /// The last call was refused.
    lost: bool,
}

impl ModalCall {
    #[inline]
    pub fn is_on(&self) -> bool {
        self.cycle.is_some() || self.program.is_some()
    }

    pub fn is_lost(&self) -> bool {
        self.lost
    }

    #[inline]
    pub fn cycle(&self) -> Option<&ModalCycle> {
        self.cycle.as_deref()
    }

    /// The cycle cannot be drilled, which was reported.
    pub fn refuse_cycle(&mut self) {
        if let Some(cycle) = &mut self.cycle {
            cycle.refuse();
        }
    }

    /// A cycle takes the place of what ran.
    pub fn set_cycle(&mut self, cycle: Box<ModalCycle>) {
        (self.program, self.cycle) = (None, Some(cycle));
    }

    /// The program and its arguments.
    pub fn program(&self) -> Option<(usize, &[Argument])> {
        self.program.as_ref().map(|program| (program.unit, &program.arguments[..]))
    }

    /// A program takes the place of what ran.
    pub fn set_program(&mut self, unit: usize, arguments: Vec<Argument>) {
        (self.program, self.cycle) = (Some(ModalProgram { unit, arguments }), None);
    }

    /// A call stands at `site`, and counts as refused until it [stands](ModalCall::stands).
    pub fn begin(&mut self, site: Loc) {
        (self.site, self.lost) = (site, true);
    }

    pub fn stands(&mut self) {
        self.lost = false;
    }

    pub fn site(&self) -> Loc {
        self.site
    }

    /// Nothing runs any more.
    pub fn end(&mut self) {
        (self.program, self.cycle) = (None, None);
    }
}
