//! MCALL: what runs after every block that moves.

use crate::geo::Plane;
use crate::ir::cycle::Drilling;
use crate::ir::function::Turn;
use crate::sema::cycle::given::Given;
use crate::sema::run::Site;
use crate::text::Loc;

use super::vars::Argument;

/// A drilling cycle that runs behind every positioning block.
#[derive(Debug, Clone)]
pub(super) struct ModalCycle {
    pub hole: Drilling,
    pub given: Given,
    /// Where MCALL stands.
    pub here: Site,
    /// The spindle as the hole was made of it: a dwell in turns, a tap and a feed of its own depend on it.
    pub spindle: SpindleState,
    /// The feed is the one that is modal when the hole is drilled.
    pub feed_of_block: bool,
    /// Plane and unit of the call: the axis and the lengths of the hole were taken under them.
    pub under: (Plane, f64),
    /// Why it cannot be drilled was reported.
    pub refused: bool,
}

/// What holes take from the spindle: speed, sense, whether the speed follows the diameter, whether feeds count per turn; and
/// the tool and its edge, whose tip a depth may count for.
pub(super) type SpindleState = (Option<f64>, Option<Turn>, bool, bool, Option<u32>, Option<u32>);

impl ModalCycle {
    /// Why it cannot be drilled was reported.
    pub fn refuse(&mut self) {
        self.refused = true;
    }
}

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
