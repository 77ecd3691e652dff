//! The contour that is programmed under compensation, as far as a departure has to know it.

use crate::diag::codes;
use crate::geo::{self, Plane, Point2, SAME_POINT, Vec2, arc};
use crate::ir::compensation::{FeedAt, Inside, Outside, Search};
use crate::ir::contour::{Arc, ArcShape, CtxRef, Path};
use crate::ir::{Compensation, Pos, Side};
use crate::sema::common::compensation::compensate;
use crate::sema::common::plane::plane_axes;

use super::words::Words;
use super::{Core, Outcome};

/// The last move in the working plane, for its direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct LastMove {
    from: Point2,
    pub to: Point2,
    plane: Plane,
    path: Path,
    /// Where a tangential arc begins: the direction of the element before.
    entering: Option<Vec2>,
}

/// The contour under way, or the one that the tool still stands beside.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contour {
    /// [`Side::None`] behind an approach with R0.
    pub side: Side,
    /// More than the way to it was programmed.
    pub begun: bool,
    pub last: Option<LastMove>,
}

/// Does the block change what is made of the corner at its end?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum OwnCorner {
    #[default]
    No,
    /// Yes, and no element was sent yet.
    Waits,
    Sent,
}

impl LastMove {
    /// Behind `before`, which a tangential arc goes on from.
    pub fn new(from: Point2, to: Point2, plane: Plane, path: Path, before: Option<LastMove>) -> LastMove {
        let entering = match path {
            Path::Arc(Arc { shape: ArcShape::Tangent, .. }, _) => before.and_then(|before| before.direction(false)),
            Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Thread(_) => None,
        };
        LastMove::entered(from, to, plane, path, entering)
    }

    /// With the direction in which a tangential arc begins.
    pub fn entered(from: Point2, to: Point2, plane: Plane, path: Path, entering: Option<Vec2>) -> LastMove {
        LastMove { from, to, plane, path, entering }
    }

    #[inline]
    pub fn straight(from: Point2, to: Point2, plane: Plane) -> LastMove {
        LastMove { from, to, plane, path: Path::Rapid, entering: None }
    }

    /// Direction of travel at the start or the end.
    pub fn direction(&self, at_start: bool) -> Option<Vec2> {
        let at = if at_start { self.from } else { self.to };
        match self.path {
            Path::Line(_) | Path::Rapid => geo::direction(self.to - self.from, SAME_POINT),
            Path::Arc(Arc { plane, .. }, _) if plane != self.plane => None,
            Path::Arc(Arc { shape, .. }, _) => match shape {
                ArcShape::Center { center, ccw, .. } => arc::tangent_at(at, center, ccw),
                ArcShape::Sweep { center, sweep } => arc::tangent_at(at, center, sweep.0 > 0.0),
                ArcShape::Radius { radius, ccw, tol } => {
                    let center = arc::center_by_radius(self.from, self.to, radius, ccw, SAME_POINT, tol)?;
                    arc::tangent_at(at, center, ccw)
                }
                ArcShape::Tangent if at_start => self.entering,
                // The chord halves the turn of an arc.
                ArcShape::Tangent => {
                    let (along, t) = (self.to - self.from, self.entering?);
                    let half = libm::atan2(geo::cross(t, along), t.dot(&along));
                    Some(geo::turned(t, 2.0 * half))
                }
                ArcShape::Opening { .. } | ArcShape::Via { .. } => None,
            },
            Path::Thread(_) => None,
        }
    }
}

impl Contour {
    pub fn new(side: Side) -> Contour {
        Contour { side, begun: false, last: None }
    }
}

/// The contour under way, what M functions make of its corners, and how far is looked ahead in it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ContourState {
    pub now: Option<Contour>,
    /// M97, M98 or M197 of the block in hand.
    pub own_corner: OwnCorner,
    /// Blocks that M120 looks ahead.
    pub look_ahead: u32,
}

/// A move through the working plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<'m> {
    pub plane: Plane,
    /// From where to where, if the start is known.
    pub way: Option<[Point2; 2]>,
    pub end: &'m Pos,
    pub path: &'m Path,
}

impl Step<'_> {
    /// Does it change the place in the plane?
    #[inline]
    pub fn moves(&self) -> bool {
        match self.way {
            Some([from, to]) => from != to || matches!(self.path, Path::Arc(arc, _) if arc.plane == self.plane),
            None => self.names_plane(),
        }
    }

    fn names_plane(&self) -> bool {
        !self.end.known().common(plane_axes(self.plane)).is_empty()
    }
}

impl ContourState {
    /// A move of a contour of this side, or one that leads away from it.
    pub fn follow(&mut self, side: Side, step: &Step<'_>) {
        if side == Side::None && self.now.is_some_and(|contour| contour.side != Side::None) {
            // A block that names the plane leads to its end, even from beside it.
            if step.names_plane() {
                self.now = None;
            }
            return;
        }
        if !step.moves() {
            return;
        }
        if self.own_corner == OwnCorner::Waits {
            self.own_corner = OwnCorner::Sent;
        }
        let begun = self.now.is_some();
        let contour = self.now.get_or_insert(Contour::new(side));
        contour.begun = begun;
        contour.last = match (step.way, step.path) {
            (Some([from, to]), Path::Rapid | Path::Line(_)) => Some(LastMove::straight(from, to, step.plane)),
            (Some([from, to]), Path::Arc(..) | Path::Thread(_)) => {
                Some(LastMove::new(from, to, step.plane, *step.path, contour.last))
            }
            (None, _) => None,
        };
    }

    /// The corner at the end of the block in hand is made in another way.
    pub fn shape_corner(&mut self, ctx: &mut CtxRef, (outside, inside): (Option<Outside>, Option<Inside>)) {
        let Some(rules) = ctx.compensation.as_deref().copied() else { return };
        let (outside, inside) = (outside.unwrap_or(rules.outside), inside.unwrap_or(rules.inside));
        compensate(ctx, Compensation { outside, inside, own_corner: outside != Outside::default(), ..rules });
        self.own_corner = OwnCorner::Waits;
    }

    /// M120: the blocks that are looked ahead from here on.
    pub fn look_ahead(&mut self, ctx: &mut CtxRef, blocks: u32) {
        self.look_ahead = blocks;
        if let Some(rules) = ctx.compensation.as_deref().copied() {
            compensate(ctx, Compensation { search: self.search(), ..rules });
        }
    }

    fn search(&self) -> Search {
        Search { elements: self.look_ahead, bottlenecks: self.look_ahead > 0 }
    }

    /// What holds from block to block, with F where it counts.
    pub fn modal_rules(&self, ctx: &mut CtxRef, feed: FeedAt) {
        if let Some(rules) = ctx.compensation.as_deref().copied() {
            let (search, outside, inside) = (self.search(), Outside::default(), Inside::default());
            compensate(ctx, Compensation { search, outside, inside, feed, own_corner: false, ..rules });
        }
    }

    /// The block of M97, M98 or M197 is over.
    #[cold]
    pub fn end_own_corner(&mut self, core: &Core<'_>, ctx: &mut CtxRef, feed: FeedAt, w: &Words) -> Outcome {
        let own = std::mem::take(&mut self.own_corner);
        self.modal_rules(ctx, feed);
        match w.any_m(&[97, 98, 197]) {
            Some(m) if own == OwnCorner::Waits => core.refuse(m.span, codes::K2607::m_acts_on_corner_at_end(&m.number)),
            _ => Ok(()),
        }
    }
}
