//! Areas in which a cutter found no path: another cycle there suffers only from that.

use crate::diag::Diagnostic;
use crate::geo::Element;
use crate::ir::cycle::pocket::Finish;
use crate::ir::cycle::{Cycle, Region};

/// An area whose refusal was reported.
#[derive(Debug)]
pub struct NoPath {
    outlines: Vec<Vec<Element>>,
    islands: Vec<Vec<Element>>,
    message: String,
    /// From the walls, of the paths that are not there.
    distances: Vec<f64>,
}

impl NoPath {
    pub fn of(cycle: &Cycle, found: &Diagnostic) -> Option<NoPath> {
        let region = area(cycle)?;
        let (outlines, islands) = (region.outlines.clone(), region.islands.clone());
        Some(NoPath { outlines, islands, message: found.message.clone(), distances: distances(region).collect() })
    }

    /// Is this refusal of a cycle one of the same area, for a path as near to its walls? Then what else the cycle makes is none
    /// that needs a word either.
    pub fn explains(&mut self, cycle: &Cycle, found: &Diagnostic) -> bool {
        let Some(region) = area(cycle) else { return false };
        let same = found.message == self.message
            && region.outlines == self.outlines
            && region.islands == self.islands
            && distances(region).any(|away| self.distances.contains(&away));
        if same {
            let more = distances(region).filter(|away| !self.distances.contains(away)).collect::<Vec<_>>();
            self.distances.extend(more);
        }
        same
    }
}

fn area(cycle: &Cycle) -> Option<&Region> {
    match cycle {
        Cycle::Region(region) => Some(region),
        Cycle::PilotHoles(holes) => Some(&holes.pocket),
        _ => None,
    }
}

/// How far from the walls the paths of a cycle run, and those of the cutter in front of it.
fn distances(region: &Region) -> impl Iterator<Item = f64> {
    let (radius, allowance, left) = (region.mill.radius, region.allowance, region.left);
    let rough = region.rough.then_some(radius + allowance);
    let floor = |finish: &Finish| finish.floor.then_some(radius + if finish.wall { left } else { allowance });
    let wall = |finish: &Finish| finish.wall.then_some(radius + left);
    let finish = region.finish.as_ref();
    let before = region.coarse.as_ref().map(|coarse| coarse.radius + coarse.allowance);
    [rough, finish.and_then(floor), finish.and_then(wall), before].into_iter().flatten()
}
