//! The contour stream.

use std::rc::Rc;

use crate::geo::{angle, distance};
use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::{Arc, ArcShape, Coords, Corner, CornerShape, CtxRef, Load, Move, Path, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Function, Origin, Pos, Tap};

use super::{Fault, MOST_TURNS, TOLERANCE, displaces, ensure, feed, finite, finite_pos, function, hold, lead, near};

/// Passes the items of a contour stream on and checks them.
pub struct Contour<'a> {
    out: &'a mut dyn Sink,
    check: Check,
}

impl std::fmt::Debug for Contour<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Contour").field("check", &self.check).finish_non_exhaustive()
    }
}

impl<'a> Contour<'a> {
    /// Checks a stream from its start, where nothing is known.
    pub fn new(out: &'a mut dyn Sink) -> Contour<'a> {
        Contour { out, check: Check::default() }
    }

    /// For items that go on under `ctx` where the tool stands already: `at`, in the programmed frame.
    pub fn standing(out: &'a mut dyn Sink, at: &Pos, ctx: &CtxRef) -> Contour<'a> {
        let check = Check { at: *at, ctx: Rc::clone(ctx), moved: true, ..Check::default() };
        Contour { out, check }
    }
}

/// What is known from the items so far.
#[derive(Debug, Default)]
pub(super) struct Check {
    at: Pos,
    ctx: CtxRef,
    moved: bool,
    /// Where the tool stood when the contour that is described was begun.
    described: Option<Pos>,
}

impl Check {
    fn enter(&mut self, ctx: &CtxRef) {
        if Rc::ptr_eq(&self.ctx, ctx) {
            return;
        }
        if self.ctx.frame != ctx.frame {
            self.at = ctx.frame.unapply(&self.ctx.frame.apply(&self.at));
        }
        self.ctx = Rc::clone(ctx);
    }

    /// A move: its numbers, and its arc against where the tool stands.
    pub(super) fn movement(&mut self, mv: &Move, ctx: &CtxRef) -> Result<(), Fault> {
        self.enter(ctx);
        self.moved = true;
        finite_pos(&mv.end)?;
        ensure(!mv.end.known().is_empty(), Fault::NoAxis)?;
        let mut end = self.at;
        end.update(&mv.end);
        match &mv.path {
            Path::Rapid => {}
            Path::Line(f) => feed(*f)?,
            Path::Thread(thread) => lead(thread.lead)?,
            Path::Arc(arc, f) => {
                feed(*f)?;
                shape(arc, &self.at, &end)?;
            }
        }
        match mv.coords {
            Coords::Frame => self.at = end,
            Coords::Machine => {
                ensure(matches!(mv.path, Path::Rapid | Path::Line(_)), Fault::Machine)?;
                self.at.clear();
            }
        }
        Ok(())
    }

    /// A corner: its size and feed. An undercut is checked where the corner is known.
    pub(super) fn corner(&mut self, corner: &Corner, ctx: &CtxRef) -> Result<(), Fault> {
        self.enter(ctx);
        corner.feed.map_or(Ok(()), feed)?;
        let size = match corner.shape {
            CornerShape::Rounding { radius: size }
            | CornerShape::Chamfer { side: size }
            | CornerShape::ChamferLength { length: size } => size,
            // Its shape is checked where the corner is known.
            CornerShape::Undercut(_) => return Ok(()),
        };
        finite(&[size])?;
        ensure(size > 0.0, Fault::Corner)
    }

    /// A function: its numbers, and what it leaves of the position.
    pub(super) fn function(&mut self, item: &Function, ctx: &CtxRef) -> Result<(), Fault> {
        self.enter(ctx);
        if displaces(item) {
            self.at.clear();
        }
        function(item)
    }

    /// A tap: it begins where the tool stands, and goes in and out.
    pub(super) fn tap(&mut self, tap: &Tap, ctx: &CtxRef) -> Result<(), Fault> {
        self.enter(ctx);
        self.moved = true;
        let starts = self.at.get(tap.axis).is_none_or(|at| near(at, tap.start));
        self.at.set(tap.axis, tap.end());
        ensure(starts && tap.check().is_ok(), Fault::Tap)
    }

    /// A cycle: only where it leaves the tool.
    pub(super) fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef) {
        self.enter(ctx);
        self.moved = true;
        self.at.update(&cycle.leaves(&self.at));
    }

    /// The position is not known any more.
    pub(super) fn lost(&mut self, ctx: &CtxRef) {
        self.enter(ctx);
        self.at.clear();
    }

    /// Axes stand here before the first move.
    pub(super) fn begins_at(&mut self, at: &Pos) -> Result<(), Fault> {
        self.at.update(at);
        finite_pos(at)?;
        ensure(!self.moved, Fault::Late)
    }

    /// Axes stand here although no move said so.
    pub(super) fn stands_at(&mut self, at: &Pos, ctx: &CtxRef) -> Result<(), Fault> {
        self.enter(ctx);
        self.at.update(at);
        finite_pos(at)
    }

    /// The description of a contour begins: it is not inside of another one.
    pub(super) fn contour_begins(&mut self, ctx: &CtxRef) -> Result<(), Fault> {
        self.enter(ctx);
        let before = std::mem::take(&mut self.at);
        ensure(self.described.replace(before).is_none(), Fault::Description)
    }

    /// It ends, and the tool stands where it stood before.
    pub(super) fn contour_ends(&mut self) -> Result<(), Fault> {
        self.at = self.described.take().ok_or(Fault::Description)?;
        Ok(())
    }
}

/// An arc as far as it is programmed: whether it exists is for lower to say.
fn shape(arc: &Arc, start: &Pos, end: &Pos) -> Result<(), Fault> {
    let ends = start.in_plane(arc.plane).zip(end.in_plane(arc.plane));
    ensure(f64::from(arc.turns) <= MOST_TURNS, Fault::Turns)?;
    let tolerance = |tol: f64| finite(&[tol]).and_then(|()| ensure(tol >= 0.0, Fault::Shape));
    match arc.shape {
        ArcShape::Center { center, tol, .. } => {
            finite(&[center.x, center.y])?;
            tolerance(tol)
        }
        ArcShape::Radius { radius, tol, .. } => {
            finite(&[radius])?;
            ensure(radius != 0.0, Fault::Shape)?;
            tolerance(tol)
        }
        ArcShape::Opening { sweep } => {
            finite(&[sweep.0])?;
            ensure(sweep.0 != 0.0 && sweep.0.abs() < 360.0, Fault::Shape)
        }
        ArcShape::Via { point } => finite(&[point.x, point.y]),
        ArcShape::Tangent => Ok(()),
        ArcShape::Sweep { center, sweep } => {
            finite(&[center.x, center.y, sweep.0])?;
            let turns = sweep.0.abs() / 360.0;
            ensure(sweep.0 != 0.0 && turns <= MOST_TURNS, Fault::Turns)?;
            let Some((from, to)) = ends else { return Ok(()) };
            let leads = angle::rotated(from, center, sweep);
            let tolerance = TOLERANCE * (1.0 + distance(from, center)) * (1.0 + turns);
            ensure(distance(leads, to) <= tolerance, Fault::Sweep)
        }
    }
}

impl Sink for Contour<'_> {
    fn movement(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin) {
        hold(self.check.movement(mv, ctx), mv);
        self.out.movement(mv, ctx, origin);
    }

    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin) {
        hold(self.check.corner(corner, ctx), corner);
        self.out.corner(corner, ctx, origin);
    }

    fn function(&mut self, item: &Function, ctx: &CtxRef, origin: &Origin) {
        hold(self.check.function(item, ctx), item);
        self.out.function(item, ctx, origin);
    }

    fn tap(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin) {
        hold(self.check.tap(tap, ctx), tap);
        self.out.tap(tap, ctx, origin);
    }

    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin) {
        self.check.cycle(cycle, ctx);
        self.out.cycle(cycle, ctx, origin);
    }

    fn lost(&mut self, ctx: &CtxRef, origin: &Origin) {
        self.check.lost(ctx);
        self.out.lost(ctx, origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        hold(self.check.begins_at(at), at);
        self.out.begins_at(at);
    }

    fn stands_at(&mut self, at: &Pos, ctx: &CtxRef, origin: &Origin) {
        hold(self.check.stands_at(at, ctx), at);
        self.out.stands_at(at, ctx, origin);
    }

    fn load(&self) -> Load {
        self.out.load()
    }

    fn contour_begins(&mut self, limit: usize, ctx: &CtxRef, origin: &Origin) {
        hold(self.check.contour_begins(ctx), origin);
        self.out.contour_begins(limit, ctx, origin);
    }

    fn contour_ends(&mut self, origin: &Origin) -> Result<Captured, Unfit> {
        hold(self.check.contour_ends(), origin);
        self.out.contour_ends(origin)
    }
}
