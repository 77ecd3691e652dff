//! Pilot holes: one at each place where the pocket will be entered.

use crate::diag::codes;
use crate::geo::Point2;
use crate::ir::cycle::milling::Place;
use crate::ir::cycle::{Family, PilotHoles};

use super::loops::{Area, Part};
use super::walls::Walls;
use super::{CycleItem, Expand, Failure, Start, entry_of};
use crate::lower::cycles::cutter::Cutter;

impl Expand for PilotHoles {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Failure> {
        let help = "check the contour, the data of the cutter that roughs it, and the allowances";
        self.check().map_err(|fault| Failure::new(codes::G3321, fault.to_string(), help))?;
        let pocket = &self.pocket;
        let walls = Walls::new(pocket.walls().copied().collect());
        let least = pocket.mill.radius + pocket.allowance;
        let parts = pocket.rings(&Area::new(&pocket.outlines, &pocket.islands), &walls, least)?;
        let mut places = Vec::new();
        for part in &parts {
            entries(part, least, &mut places);
        }
        let mut cutter = Cutter::new(&pocket.mill, Place::HERE, start, out);
        for place in places {
            cutter.rise();
            cutter.rapid(place);
            cutter.drill(&self.hole, start)?;
        }
        Ok(())
    }
}

/// In the order in which the pocket is cut.
fn entries(part: &Part, least: f64, places: &mut Vec<Point2>) {
    for inner in &part.inner {
        entries(inner, least, places);
    }
    if part.inner.is_empty() {
        places.push(entry_of(part, least).at);
    }
}
