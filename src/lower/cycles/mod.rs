//! Cycles become moves: one file per family.

// The enums matched here belong to one family each.
#![allow(clippy::wildcard_enum_match_arm)]

pub mod drilling;
pub mod finishing;
pub mod infeed;
pub mod recess;
pub mod roughing;
#[cfg(test)]
mod simulate;
pub mod slope;
pub mod thread;
pub mod track;
pub mod undercut;
pub mod valley;

use crate::diag::{Diagnostic, codes};
use crate::geo::Plane;
use crate::ir::contour::{CtxRef, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Function, Origin, Pos};
use crate::machine::Axis;

use track::{Failure, Stroke};

/// Sends what `cycle` does to `out`, starting in `start` (programmed frame).
///
/// # Errors
/// Arguments that describe no safe path.
pub fn expand(
    cycle: &Cycle,
    start: &Pos,
    ctx: &CtxRef,
    origin: &Origin,
    out: &mut dyn Sink,
) -> Result<(), Box<Diagnostic>> {
    if let Cycle::Drilling(hole) = cycle {
        let (first, second, third) = ctx.plane.axes();
        let axes = [Axis::ALL[first], Axis::ALL[second], Axis::ALL[third]];
        let mut send = |part: drilling::Part| match part {
            drilling::Part::Move(mv) => out.movement(&mv, ctx, origin),
            drilling::Part::Function(function) => out.function(&function, ctx, origin),
        };
        return drilling::expand(hole, start, axes, &mut send).map_err(|failure| report(failure, origin));
    }
    let mut send = |stroke: Stroke| match stroke {
        Stroke::Dwell { seconds } => out.function(&Function::Dwell(seconds), ctx, origin),
        Stroke::Move(path) => out.movement(&path.movement(), ctx, origin),
    };
    let Some(from) = start.in_plane(Plane::Zx) else {
        let message = "the cycle starts where the tool stands, but its position in X and Z is not known";
        return Err(report(Failure::new(codes::G3043, message, "position X and Z in front of the cycle"), origin));
    };
    match cycle {
        Cycle::Finishing(cycle) => finishing::expand(cycle, from, &mut send),
        Cycle::RecessTurning(cycle) => recess::expand(cycle, from, &mut send),
        Cycle::Roughing(cycle) => roughing::expand(cycle, from, &mut send),
        Cycle::Thread(cycle) => thread::expand(cycle, from, &mut send),
        Cycle::Undercut(cycle) => undercut::expand(cycle, from, &mut |mv| out.movement(mv, ctx, origin)),
        // Done above: a hole needs no position in the turning plane.
        Cycle::Drilling(_) => Ok(()),
    }
    .map_err(|failure| report(failure, origin))
}

fn report(failure: Failure, origin: &Origin) -> Box<Diagnostic> {
    let found = Diagnostic::new(failure.code, origin.loc, failure.message);
    Box::new(found.called(origin.call).help(failure.help))
}
