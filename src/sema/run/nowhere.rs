//! A sink for a run of which only the findings count.

use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::{Corner, CtxRef, Load, Move, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Function, Origin, Pos, Tap};

/// Takes everything and keeps nothing.
pub struct Nowhere;

impl Sink for Nowhere {
    fn movement(&mut self, _: &Move, _: &CtxRef, _: &Origin) {}

    fn corner(&mut self, _: &Corner, _: &CtxRef, _: &Origin) {}

    fn function(&mut self, _: &Function, _: &CtxRef, _: &Origin) {}

    fn tap(&mut self, _: &Tap, _: &CtxRef, _: &Origin) {}

    fn cycle(&mut self, _: &Cycle, _: &CtxRef, _: &Origin) {}

    fn lost(&mut self, _: &CtxRef, _: &Origin) {}

    fn begins_at(&mut self, _: &Pos) {}

    fn stands_at(&mut self, _: &Pos, _: &CtxRef, _: &Origin) {}

    fn load(&self) -> Load {
        Load::default()
    }

    fn contour_begins(&mut self, _: usize, _: &CtxRef, _: &Origin) {}

    fn contour_ends(&mut self, _: &Origin) -> Result<Captured, Unfit> {
        Ok(Captured::default())
    }
}
