//! A contour that a cycle works along is described, not carried out.
//!
//! Its blocks run as any others; what the machine under them counts of moves stays as it was.

use crate::ir::Origin;
use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::CtxRef;

use super::Language;
use super::chosen_tool::ChosenTool;
use super::core::Core;

/// What the machine had counted when the description began.
#[derive(Debug)]
#[must_use]
pub struct Counted {
    moved: bool,
    chosen_tool: ChosenTool,
}

impl<L: Language> Core<'_, L> {
    /// Moves are described from here on, at most `most`.
    pub fn contour_begins(&mut self, most: usize, ctx: &CtxRef) -> Counted {
        self.out.contour_begins(most, ctx, &self.here.origin);
        Counted { moved: self.moved, chosen_tool: self.chosen_tool }
    }

    /// The contour is described, for the block at `origin`.
    pub fn contour_ends(&mut self, before: Counted, origin: &Origin) -> Result<Captured, Unfit> {
        Counted { moved: self.moved, chosen_tool: self.chosen_tool } = before;
        self.out.contour_ends(origin)
    }
}
