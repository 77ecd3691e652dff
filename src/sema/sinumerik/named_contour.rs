//! Contours that cycles work along: where their blocks stand, and what they are once they ran.

use crate::ir::captured::Captured;
use crate::text::{Loc, Place};

/// Most elements of a contour, roundings and chamfers counted.
pub(super) const MOST_ELEMENTS: usize = 1000;

/// Where the blocks of a contour are.
#[derive(Debug, Clone)]
pub(super) struct ContourCall {
    /// The program that holds it.
    pub unit: usize,
    /// From this block up to this offset; `None` for the whole program.
    pub part: Option<(Place, u32)>,
    /// What the call names, for findings.
    pub name: String,
    /// The call.
    pub loc: Loc,
}

/// A contour that was run and checked for a cycle.
#[derive(Debug)]
pub(super) struct CalledContour {
    pub call: ContourCall,
    pub made: Captured,
}
