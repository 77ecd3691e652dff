//! The contour that cycle 25 follows: the first one of cycle 14, and what cycle 270 says of it.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use crate::diag::{Label, codes};

use super::cycles::DefinedCycle;
use super::cycles::data::{NamedContours, Train};
use super::{Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn train_of(&mut self, cycle: &DefinedCycle, named: &NamedContours) -> Outcome<Train> {
        if named.labels.len() > 1 {
            let found = codes::K2954::cycle_25_mills_first_contour_of_cycle().at(self.core.here.origin.loc);
            self.core.report(found.also(named.loc, Label::NamedHere));
        }
        let Some(label) = named.labels.first() else { return Err(Reported) };
        let contour = self.capture(label, cycle.loc)?;
        self.contours.check(self.view(), label, &contour)?;
        let Some(side) = contour.side else {
            let help = "write RL, RR or nothing into its first block, and nothing after it";
            return self.contours.fault(&self.core, label, "its side changes", help);
        };
        let data = self.contours.train.read(self.reading())?;
        Ok(Train { elements: contour.pieces.iter().map(|piece| piece.element).collect(), side, data })
    }
}
