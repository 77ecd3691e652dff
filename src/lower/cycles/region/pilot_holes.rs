//! Pilot holes: one at each place where the cutter goes straight down into solid material.

use crate::diag::{Fault, codes};
use crate::ir::cycle::milling::Place;
use crate::ir::cycle::{Family, PilotHoles};

use super::loops::Area;
use super::walls::Walls;
use super::{CycleItem, Expand, Start};
use crate::lower::cycles::cutter::Cutter;

impl Expand for PilotHoles {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3321::pilot_holes_makes_no_path(&fault))?;
        let pocket = &self.pocket.on_grid();
        let walls = Walls::new(pocket.walls().copied().collect());
        let least = pocket.mill.radius + pocket.allowance;
        let rooms = pocket.rooms(&Area::new(&pocket.outlines, &pocket.islands), &walls, least)?;
        let courses = pocket.courses(&rooms, &walls);
        let mut cutter = Cutter::new(&pocket.mill, Place::HERE, start, out);
        for place in pocket.places(&courses) {
            cutter.rise();
            cutter.rapid(place);
            cutter.drill(&self.hole, start)?;
        }
        Ok(())
    }
}
