//! Drilling, boring and tapping become moves of the drilling axis.

mod hole;
mod pecking;

use crate::diag::{Fault, codes};
use crate::ir::cycle::Family;
use crate::ir::cycle::drilling::{Drilling, DrillingFault, Method, Tap};
use crate::ir::function::Spindle;
use crate::ir::{Function, Pos};
use crate::machine::Axis;

use super::{CycleItem, Expand, Start};
use hole::Hole;

impl Expand for Drilling {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        expand(self, &start.at, start.axes, out)
    }
}

/// Sends the parts of a hole at `start`.
///
/// # Errors
/// G3041 for arguments that make no hole, G3040 for steps without end.
fn expand(drilling: &Drilling, start: &Pos, axes: [Axis; 3], out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
    drilling.check().map_err(fault)?;
    let levels = &drilling.levels;
    if levels.outward() == 0.0 {
        // The standard cycles drill nothing where depth and surface are the same.
        return Ok(());
    }
    // All depths are known before the tool moves.
    let depths = match &drilling.method {
        Method::Peck(peck) => pecking::steps(levels, peck).map_err(fault)?,
        Method::Tap(Tap { step: Some(step), .. }) => {
            pecking::depths(levels, step.way, step.degression).map_err(fault)?
        }
        _ => vec![levels.depth],
    };
    let mut hole = Hole { drilling, levels, out };
    hole.rapid(levels.start_plane());
    if let Method::Deep(deep) = &drilling.method {
        hole.deep(deep);
        hole.rapid(levels.retract);
        return Ok(());
    }
    hole.enter();
    match &drilling.method {
        Method::Drill { dwell } => {
            hole.cut(levels.depth, drilling.feed);
            hole.dwell(*dwell);
        }
        Method::Through { dwell, height, feed } => {
            hole.cut(*height, drilling.feed);
            hole.cut(levels.depth, *feed);
            hole.dwell(*dwell);
        }
        Method::Peck(peck) => hole.peck(peck, &depths),
        Method::Tap(tap) => hole.tap(tap, &depths),
        Method::Ream { dwell, back } => {
            hole.cut(levels.depth, drilling.feed);
            hole.dwell(*dwell);
            hole.cut(levels.start_plane(), *back);
        }
        Method::Deep(_) => {}
        Method::Bore(bore) => return hole.bore(bore, start, axes),
        Method::BoreWithStop { dwell, turn } => {
            hole.cut(levels.depth, drilling.feed);
            hole.dwell(*dwell);
            hole.spindle(Spindle::Stop);
            (hole.out)(CycleItem::Function(Function::Stop));
            hole.rapid(levels.retract);
            hole.spindle(Spindle::Start(*turn));
            return Ok(());
        }
    }
    hole.rapid(levels.retract);
    Ok(())
}

fn fault(fault: DrillingFault) -> Fault {
    match fault {
        DrillingFault::TooManyPecks => codes::G3040::drilling_makes_too_many_steps(&fault),
        _ => codes::G3041::drilling_makes_no_path(&fault),
    }
}

#[cfg(test)]
mod tests;
