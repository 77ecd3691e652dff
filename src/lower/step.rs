//! A path element whose geometry is complete, still in programmed coordinates.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Element, Plane};
use crate::ir::contour::{CtxRef, FARTHEST};
use crate::ir::motion::{Move, Path};
use crate::ir::{Function, Origin, Pos, verify};
use crate::machine::{Axis, AxisSet};

use super::at;

/// What comes out of the pass over corners.
#[derive(Debug)]
pub enum Event<'s> {
    Step(&'s Step),
    Function(&'s Function, Origin),
}

/// Coordinates up to here keep all digits that a step promises, in mm.
pub const FAR: f64 = 1e4;

/// One element from `start` to the end of `mv`.
#[derive(Debug, Clone, Default)]
pub struct Step {
    pub start: Pos,
    /// The move in the frame of `ctx`. Its `axes` are those the program named.
    pub mv: Move,
    pub ctx: CtxRef,
    pub origin: Origin,
}

impl Step {
    /// The element as seen in `plane`; `None` if an end is not known there or an arc lies in another plane.
    #[inline]
    pub fn element(&self, plane: Plane) -> Option<Element> {
        let from = self.start.in_plane(plane)?;
        let to = self.mv.end.in_plane(plane)?;
        match &self.mv.path {
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => {
                Some(Element::Line { from, to })
            }
            Path::Arc(arc, _) if arc.plane == plane => {
                Some(Element::Arc { from, to, center: arc.center, sweep: arc.sweep })
            }
            Path::Arc(..) => None,
        }
    }

    /// Does the frame leave the move as it is?
    #[inline]
    pub fn is_in_workpiece(&self) -> bool {
        self.mv.machine || self.ctx.frame.is_identity()
    }

    /// Checks what a step promises by itself.
    pub fn check(&self) {
        let kept = verify::element(&self.start, &self.mv);
        debug_assert!(kept.is_ok(), "{kept:?}: {self:?}");
    }

    /// Looks whether the numbers are so large that computing with them lost what a step promises. `origin` asked for it.
    ///
    /// # Errors
    /// O1002.
    #[inline]
    pub fn is_exact(&self, origin: Origin) -> Result<(), Box<Diagnostic>> {
        let centre = match &self.mv.path {
            Path::Arc(arc, _) => arc.center.x.abs().max(arc.center.y.abs()),
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => 0.0,
        };
        if self.mv.end.exceeds(FAR) || self.start.exceeds(FAR) || centre.is_nan() || centre > FAR {
            return exact_far_out(&self.start, &self.mv, origin);
        }
        Ok(())
    }

    /// Plane of an arc, or the working plane.
    #[inline]
    pub fn plane(&self) -> Plane {
        match &self.mv.path {
            Path::Arc(arc, _) => arc.plane,
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => self.mv.plane,
        }
    }

    /// Is the start known in the working plane?
    pub fn start_is_known(&self) -> bool {
        self.start.in_plane(self.ctx.plane).is_some()
    }

    /// Does this straight element stay where `before` ends, under the same conditions?
    #[inline]
    pub fn rests_behind(&self, before: &Step) -> bool {
        let still =
            self.mv.axes.iter().all(|axis| self.start.get(axis).is_some_and(|at| self.mv.end.get(axis) == Some(at)));
        still
            && matches!(self.mv.path, Path::Rapid | Path::Line(_))
            && !self.mv.machine
            && !before.mv.machine
            && self.mv.side == before.mv.side
            && self.mv.plane == before.mv.plane
            && std::rc::Rc::ptr_eq(&self.ctx, &before.ctx)
    }

    /// Does an axis outside `plane` move?
    #[inline]
    pub fn leaves(&self, plane: Plane) -> bool {
        let others = self.mv.axes.without(plane_axes(plane));
        others.iter().any(|axis| self.start.get(axis) != self.mv.end.get(axis))
    }
}

/// The same for a move of which it is known that its numbers are large.
///
/// # Errors
/// O1002.
#[cold]
pub fn exact_far_out(start: &Pos, mv: &Move, origin: Origin) -> Result<(), Box<Diagnostic>> {
    // A line loses nothing.
    let straight = matches!(mv.path, Path::Rapid | Path::Line(_));
    if !mv.end.exceeds(FARTHEST) && (straight || verify::element(start, mv).is_ok()) {
        return Ok(());
    }
    Err(Box::new(at(origin, codes::O1002::number_of_this_block_is_too_large_to())))
}

/// Checks steps between the passes: each starts where the one before ended, as long as the frame stays.
#[derive(Debug, Default)]
pub struct Checked {
    chain: verify::Chain,
    ctx: CtxRef,
}

impl Checked {
    pub fn step(&mut self, step: &Step) {
        if !std::rc::Rc::ptr_eq(&self.ctx, &step.ctx) {
            self.chain.lost();
            self.ctx = std::rc::Rc::clone(&step.ctx);
        }
        let kept = self.chain.take(&step.start, &step.mv);
        debug_assert!(kept.is_ok(), "{kept:?}: {step:?}");
    }

    pub fn event(&mut self, event: &Event<'_>) {
        match event {
            Event::Step(step) => self.step(step),
            Event::Function(function, _) => self.chain.function(function),
        }
    }

    /// The position is not known any more.
    pub fn lost(&mut self) {
        self.chain.lost();
    }
}

/// Axes of a plane as a set.
#[inline]
pub fn plane_axes(plane: Plane) -> AxisSet {
    let (_, _, third) = plane.axes();
    AxisSet::MAIN.without(AxisSet::of(Axis::ALL[third]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::Point2;
    use crate::ir::Feed;
    use crate::ir::motion::Arc;

    #[test]
    fn an_arc_is_an_element_of_its_own_plane_only() {
        let start = Pos::of_main([10.0, 20.0, 0.0], AxisSet::MAIN);
        let end = Pos::of_main([0.0, 20.0, 10.0], AxisSet::MAIN);
        // A quarter about the origin of ZX.
        let sweep = -core::f64::consts::FRAC_PI_2;
        let arc = Arc { plane: Plane::Zx, from: Point2::new(0.0, 10.0), center: Point2::origin(), sweep };
        let path = Path::Arc(arc, Feed::PerMinute(100.0));
        let step = Step { start, mv: Move { end, axes: AxisSet::MAIN, path, ..Move::default() }, ..Step::default() };
        assert!(matches!(step.element(Plane::Zx), Some(Element::Arc { .. })));
        assert_eq!(step.element(Plane::Xy), None);
        assert_eq!(step.element(Plane::Yz), None);
        let straight = Step { mv: Move { path: Path::Rapid, ..step.mv }, ..step };
        assert!(matches!(straight.element(Plane::Xy), Some(Element::Line { .. })));
    }
}
