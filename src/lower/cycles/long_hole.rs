//! Long holes: down at one end, along, down at the other end, and back.

use crate::diag::{Fault, codes};
use crate::ir::cycle::milling::Place;
use crate::ir::cycle::{Family, LongHole};

use super::cutter::Cutter;
use super::{CycleItem, Expand, Start};

impl Expand for LongHole {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3321::long_hole_makes_no_path(&fault))?;
        let levels = self.mill.heights.levels();
        let holes = self.in_order(start.at.in_plane(self.mill.plane));
        let mut cutter = Cutter::new(&self.mill, Place::HERE, start, out);
        for ends in holes {
            cutter.approach(ends[0]);
            for (at, level) in levels.iter().enumerate() {
                cutter.plunge(*level);
                cutter.line(ends[(at + 1) % 2], self.mill.feeds.plane);
            }
            cutter.retract();
        }
        if let Some(home) = self.home {
            cutter.rapid(home);
        }
        Ok(())
    }
}
