//! Ruled surfaces: row beside row, each a straight line in space, joined along the edges.

use crate::diag::{Fault, codes};
use crate::geo::Element;
use crate::ir::Feed;
use crate::ir::cycle::milling::Place;
use crate::ir::cycle::ruled::Corner;
use crate::ir::cycle::{Family, Ruled};

use super::cutter::Cutter;
use super::{CycleItem, Expand, Start};

impl Expand for Ruled {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3331::surface_makes_no_path(&fault))?;
        let [mut at, _] = self.row(0);
        let mut cutter = Cutter::new(&self.mill, Place::HERE, start, out);
        cutter.approach(at.at);
        cutter.sink(at.height, self.first);
        let mut go = |to: Corner, feed: Feed| {
            if !to.is(&at) {
                cutter.fall(&Element::Line { from: at.at, to: to.at }, to.height, feed);
            }
            at = to;
        };
        for row in 0..self.rows {
            let feed = if row == 0 { self.first } else { self.mill.feeds.plane };
            for end in self.row(row) {
                go(end, feed);
            }
        }
        cutter.retract();
        Ok(())
    }
}
