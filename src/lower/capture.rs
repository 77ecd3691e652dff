//! A contour that is described: its elements are kept instead of being carried out.
//!
//! It passes the same passes as every move, up to the corners; only what comes behind them is another. Frames are not
//! applied: the contour counts in the frame in which it was begun.

use crate::ir::captured::{Captured, CapturedElement, CapturedKind, Unfit};
use crate::ir::contour::CtxRef;
use crate::ir::motion::Path;
use crate::ir::{Origin, Pos};

use super::arcs::LastDirection;
use super::corner::Corners;
use super::step::{Checked, Step, plane_axes};

/// A contour while it is described, and what waits until it is complete.
#[derive(Debug)]
pub struct Recording {
    made: Captured,
    started: bool,
    limit: usize,
    unfit: Option<Unfit>,
    /// Findings in front of the description.
    errors: u32,
    before: SavedPasses,
}

/// State of the passes that a description leaves as it was.
#[derive(Debug, Default)]
pub struct SavedPasses {
    pub at: Pos,
    pub ctx: CtxRef,
    pub last: LastDirection,
    pub corners: Corners,
    pub chain: Checked,
}

impl Recording {
    pub fn new(limit: usize, errors: u32, before: SavedPasses) -> Recording {
        Recording { made: Captured::default(), started: false, limit, unfit: None, errors, before }
    }

    /// A finding about the contour was made.
    pub fn reported(&mut self) {
        self.unfit.get_or_insert(Unfit::Reported);
    }

    pub fn take(&mut self, step: &Step) {
        if self.unfit.is_none()
            && let Err(unfit) = self.add(step)
        {
            self.unfit = Some(unfit);
        }
    }

    fn add(&mut self, step: &Step) -> Result<(), Unfit> {
        let (plane, origin) = (step.ctx.plane, step.origin);
        if step.ctx.frame != self.before.ctx.frame {
            return Err(Unfit::Frame(origin));
        }
        if !self.started {
            return self.start(step);
        }
        if plane != self.made.plane || step.plane() != plane {
            return Err(Unfit::Plane(origin));
        }
        if step.mv.machine || step.leaves(plane) {
            return Err(Unfit::Leaves(origin));
        }
        if self.made.pieces.len() >= self.limit {
            return Err(Unfit::TooMany(origin));
        }
        let Some(element) = step.element(plane) else { return Err(Unfit::Leaves(origin)) };
        let kind = match step.mv.path {
            Path::Rapid => CapturedKind::Rapid,
            Path::Line(_) | Path::Arc(..) | Path::Carried { .. } => CapturedKind::Cut,
            Path::Thread { .. } => CapturedKind::Thread,
        };
        self.made.side = self.made.side.filter(|side| *side == step.mv.side);
        if element.length() > crate::geo::SAME_POINT {
            self.made.pieces.push(CapturedElement { element, kind, origin });
        }
        Ok(())
    }

    fn start(&mut self, step: &Step) -> Result<(), Unfit> {
        let plane = step.ctx.plane;
        let both = plane_axes(plane).iter().all(|axis| step.mv.axes.contains(axis));
        match step.mv.end.in_plane(plane).filter(|_| both && !step.mv.machine) {
            Some(_) if !step.mv.axes.without(plane_axes(plane)).is_empty() => Err(Unfit::Leaves(step.origin)),
            Some(at) => {
                self.started = true;
                (self.made.plane, self.made.start, self.made.side) = (plane, at, Some(step.mv.side));
                Ok(())
            }
            None => Err(Unfit::NoStart(step.origin)),
        }
    }

    /// The contour; a description without a move has no start.
    pub fn finish(self, errors: u32, origin: &Origin) -> (SavedPasses, Result<Captured, Unfit>) {
        let made = match self.unfit {
            Some(unfit) => Err(unfit),
            // Such as a corner that could not be cut.
            None if errors > self.errors => Err(Unfit::Reported),
            None if !self.started => Err(Unfit::NoStart(*origin)),
            None => Ok(self.made),
        };
        (self.before, made)
    }
}
