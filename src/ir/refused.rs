//! Where in the contour stream the first error lies.
//!
//! Pictures and lists of moves of a refused program go on behind it, and say from where on they are not whole. A remark in the
//! stream says it in its order: what `lower` held back at that moment still comes in front of it.

use crate::diag::Diags;

use super::captured::{Captured, Unfit};
use super::contour::{Corner, CtxRef, Load, Move, Sink};
use super::cycle::Cycle;
use super::{Function, Origin, Pos, Remark, Tap};

/// Hands everything to `next`, and a remark in front of the first item that follows an error.
pub struct Remarks<'a> {
    diags: &'a Diags,
    next: &'a mut dyn Sink,
    said: bool,
    /// A contour is described: nothing of it is carried out.
    describes: bool,
}

impl<'a> Remarks<'a> {
    /// Remarks on the errors that `diags` gets from here on, and on those that it has.
    pub fn new(diags: &'a Diags, next: &'a mut dyn Sink) -> Remarks<'a> {
        Remarks { diags, next, said: false, describes: false }
    }

    #[inline]
    fn look(&mut self, ctx: &CtxRef, origin: &Origin) {
        if !self.said && !self.describes && self.diags.has_failed() {
            self.said = true;
            self.next.function(&Function::Remark(Remark::Refused), ctx, origin);
        }
    }
}

impl Sink for Remarks<'_> {
    fn movement(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.next.movement(mv, ctx, origin);
    }

    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.next.corner(corner, ctx, origin);
    }

    fn function(&mut self, function: &Function, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.next.function(function, ctx, origin);
    }

    fn tap(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.next.tap(tap, ctx, origin);
    }

    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.next.cycle(cycle, ctx, origin);
    }

    fn lost(&mut self, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.next.lost(ctx, origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.next.begins_at(at);
    }

    fn stands_at(&mut self, at: &Pos, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.next.stands_at(at, ctx, origin);
    }

    fn load(&self) -> Load {
        self.next.load()
    }

    fn contour_begins(&mut self, limit: usize, ctx: &CtxRef, origin: &Origin) {
        self.look(ctx, origin);
        self.describes = true;
        self.next.contour_begins(limit, ctx, origin);
    }

    fn contour_ends(&mut self, origin: &Origin) -> Result<Captured, Unfit> {
        self.describes = false;
        self.next.contour_ends(origin)
    }
}
