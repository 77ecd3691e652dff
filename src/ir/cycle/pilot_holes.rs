//! Arguments of pilot holes: where a pocket along a contour will be entered.

use core::fmt;

use crate::ir::Pos;

use super::drilling::{Drilling, DrillingFault};
use super::region::{Region, RegionFault};
use super::{Family, drilling};

/// A hole at each place where the cutter of a pocket is inserted.
#[derive(Debug, Clone, PartialEq)]
pub struct PilotHoles {
    /// As it will be roughed, by the cutter that roughs it.
    pub pocket: Box<Region>,
    /// Drilled at each place, along the tool axis of the pocket.
    pub hole: Drilling,
}

/// Arguments that make no holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PilotFault {
    /// The pocket that will be roughed.
    Pocket(RegionFault),
    /// The hole that is drilled.
    Hole(DrillingFault),
}

impl fmt::Display for PilotFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PilotFault::Pocket(fault) => fault.fmt(f),
            PilotFault::Hole(fault) => fault.fmt(f),
        }
    }
}

impl Family for PilotHoles {
    type Fault = PilotFault;

    fn check(&self) -> Result<(), PilotFault> {
        self.pocket.check().map_err(PilotFault::Pocket)?;
        self.hole.check().map_err(PilotFault::Hole)
    }

    fn moves(&self) -> f64 {
        self.pocket.moves() + drilling::MOST_PECKS as f64
    }

    /// Above the last hole, whose place only the path of the pocket knows.
    fn leaves(&self, at: &mut Pos) {
        self.pocket.leaves(at);
    }
}
