//! Cycles become moves: one file per family.

use crate::diag::Diagnostic;
use crate::ir::contour::{CtxRef, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Origin, Pos};

/// Sends what `cycle` does to `out`, starting in `start` (programmed frame).
///
/// # Errors
/// Arguments that describe no safe path.
pub fn expand(
    cycle: &Cycle,
    _start: &Pos,
    _ctx: &CtxRef,
    _origin: &Origin,
    _out: &mut dyn Sink,
) -> Result<(), Box<Diagnostic>> {
    match *cycle {}
}
