//! CT: circles that go on in the direction of the block before.
//!
//! Source: S 2.3 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::geo::arc::{
    Closing, TangentArc, center_by_opening, center_by_radius, centered_between, closing, tangent_arc, tangent_at,
    through,
};
use crate::geo::{Plane, Point2, SAME_POINT, Vec2, direction, length};
use crate::ir::Pos;
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::machine::AxisSet;
use crate::sema::common::position::Position;
use crate::sema::run::Where;

use super::circle::{SAME, end_in};
use super::vocabulary::Address;
use super::words::Words;
use super::{Channel, Core, Outcome};

/// The last block that travelled, as far as its direction at the end can be told here.
#[derive(Debug, Clone, Copy, Default)]
pub(super) enum Heading {
    /// Nothing travelled yet.
    #[default]
    None,
    /// A straight line from here.
    Line(Pos),
    Arc {
        plane: Plane,
        center: Point2,
        ccw: bool,
    },
    /// The way of the block, in the coordinates of a frame that has changed since: the tangent is changed with it.
    Behind {
        way: [Option<f64>; 3],
        /// More than the zero has moved.
        turned: bool,
    },
    /// The contour itself tells it later.
    Later,
    /// The same, and the frame has changed since.
    TooLate,
}

/// What is known of the tangent in front of CT.
enum Tangent {
    Known(Vec2),
    Later,
    /// Why there is none.
    Missing(Fault),
}

impl Heading {
    fn tangent_in(&self, plane: Plane, start: Point2) -> Tangent {
        match *self {
            Heading::None => Tangent::Missing(codes::S3008::no_block_gives_direction()),
            Heading::Later => Tangent::Later,
            Heading::Arc { plane: other, center, ccw } if other == plane => {
                tangent_at(start, center, ccw).map_or(Tangent::Later, Tangent::Known)
            }
            Heading::Arc { .. } => Tangent::Later,
            Heading::TooLate => Tangent::Missing(codes::S3008::frame_changed_behind_cycle()),
            Heading::Behind { way, .. } => {
                let (first, second, _) = plane.axes();
                match (way.get(first).copied().flatten(), way.get(second).copied().flatten()) {
                    (Some(x), Some(y)) => tangent_along(Vec2::new(x, y)),
                    _ => Tangent::Missing(codes::S3008::block_before_starts_at_unknown_place()),
                }
            }
            Heading::Line(from) => {
                let Some(way) = from.in_plane(plane).map(|from| start - from) else {
                    return Tangent::Missing(codes::S3008::block_before_starts_at_unknown_place());
                };
                tangent_along(way)
            }
        }
    }

    /// The frame changes: the tangent is changed with it, so that it keeps its coordinates. To be called while the
    /// position is still that in the old frame.
    pub fn across_frames(&self, position: &Position, turned: bool) -> Heading {
        let mut way = [None; 3];
        match *self {
            Heading::Line(from) => {
                for (axis, part) in AxisSet::MAIN.iter().zip(&mut way) {
                    *part = position.get(axis).zip(from.get(axis)).map(|(to, from)| to - from);
                }
                Heading::Behind { way, turned }
            }
            Heading::Arc { plane, center, ccw } => {
                let end = position.in_plane(plane);
                let Some(tangent) = end.and_then(|at| tangent_at(at, center, ccw)) else { return Heading::TooLate };
                let (first, second, _) = plane.axes();
                way[first] = Some(tangent.x);
                way[second] = Some(tangent.y);
                Heading::Behind { way, turned }
            }
            Heading::Behind { way, turned: before } => Heading::Behind { way, turned: before || turned },
            Heading::Later => Heading::TooLate,
            other => other,
        }
    }

    /// The direction behind an arc from where the tool stands.
    pub(super) fn behind(arc: &Arc, position: &Position, end: &Pos) -> Heading {
        let plane = arc.plane;
        let (Some(from), Some(to)) = (position.in_plane(plane), end.in_plane(plane)) else {
            return Heading::Later;
        };
        let found = match arc.shape {
            ArcShape::Center { center, ccw, .. } if closing(to - from) != Closing::Open => Some((center, ccw)),
            // The control moves the centre to the same distance from both ends.
            ArcShape::Center { center, ccw, .. } => Some((centered_between(from, to, center), ccw)),
            ArcShape::Sweep { center, sweep } => Some((center, sweep.0 > 0.0)),
            ArcShape::Radius { radius, ccw, tol } => {
                center_by_radius(from, to, radius, ccw, SAME, tol).map(|center| (center, ccw))
            }
            ArcShape::Opening { sweep } => {
                center_by_opening(from, to, sweep.radians(), SAME).map(|center| (center, sweep.0 > 0.0))
            }
            ArcShape::Via { point } => through(from, point, to, SAME),
            ArcShape::Tangent => None,
        };
        found.map_or(Heading::Later, |(center, ccw)| Heading::Arc { plane, center, ccw })
    }

    /// The arc, as far as it can be told here. Alarm 14045.
    fn arc_to(
        &self,
        core: &Core<'_>,
        plane: Plane,
        start: Point2,
        to: Point2,
        turns: u32,
    ) -> Outcome<Option<TangentArc>> {
        let tangent = match self.tangent_in(plane, start) {
            Tangent::Known(tangent) => tangent,
            Tangent::Later => return Ok(None),
            Tangent::Missing(fault) => return core.refuse(Where::Block, fault),
        };
        match tangent_arc(start, tangent, to, SAME, 1e-9 * length(to - start)) {
            TangentArc::Behind => core.refuse(Where::Block, codes::S3008::end_lies_straight_behind_start()),
            TangentArc::Line if turns > 0 => core.refuse(Where::Block, codes::S3008::straight_line_has_no_turns()),
            found => Ok(Some(found)),
        }
    }

    /// A move from where the tool stands is sent out.
    #[inline]
    pub(super) fn follow(&mut self, position: &Position, end: &Pos, path: &Path) {
        match path {
            Path::Arc(arc, _) => *self = Heading::behind(arc, position, end),
            _ => {
                let at = position.at();
                let travels = AxisSet::MAIN.iter().any(|axis| end.get(axis).is_some_and(|to| at.get(axis) != Some(to)));
                if travels {
                    *self = Heading::Line(*at);
                }
            }
        }
    }

    /// The direction of the contour where it ends.
    pub(super) fn direction_at(&self, plane: Plane, at: Point2) -> Option<Vec2> {
        match *self {
            Heading::Line(from) => from.in_plane(plane).and_then(|from| direction(at - from, SAME_POINT)),
            Heading::Arc { plane: other, center, ccw } if other == plane => tangent_at(at, center, ccw),
            _ => None,
        }
    }
}

impl Channel<'_> {
    /// CT
    pub(super) fn tangent_block(&mut self, w: &mut Words) -> Outcome {
        let plane = self.st.plane();
        let feed = self.cutting_feed(w)?;
        let turns = w.turns(&self.core)?;
        let start = self.st.start_in(&self.core, plane, w)?;
        let polar = w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some();
        let mut end = if polar { self.st.polar_end(&mut self.core, w)? } else { self.st.targets(&self.core, w)? };
        let to = end_in(&end, plane, start);
        end.set_in_plane(plane, to);
        let tangential = Arc { plane, shape: ArcShape::Tangent, turns };
        if self.st.pair.is_open() || self.st.offsets.in_machine() {
            return self.send_arc(&end, tangential, feed, Where::Block);
        }
        let known = self.st.heading.arc_to(&self.core, plane, start, to, turns)?;
        let frame_changed = matches!(self.st.heading, Heading::Behind { .. });
        if let Heading::Behind { turned: true, .. } = self.st.heading {
            self.core.say_once(Where::Block, codes::S8042::frame_has_turned_since_block_in_front());
        }
        match known {
            Some(TangentArc::Arc { center, ccw }) if frame_changed => {
                let shape = ArcShape::Center { center, ccw, tol: SAME };
                self.send_arc(&end, Arc { plane, shape, turns }, feed, Where::Block)
            }
            Some(TangentArc::Line | TangentArc::Nothing) if frame_changed => {
                self.send(&end, Path::Line(feed));
                Ok(())
            }
            _ => {
                self.send_arc(&end, tangential, feed, Where::Block)?;
                if let Some(TangentArc::Arc { center, ccw }) = known {
                    self.st.heading = Heading::Arc { plane, center, ccw };
                }
                Ok(())
            }
        }
    }
}

/// The direction of a way in the plane.
fn tangent_along(way: Vec2) -> Tangent {
    let size = length(way);
    if size > SAME {
        Tangent::Known(way / size)
    } else {
        Tangent::Missing(codes::S3008::block_before_runs_across_plane())
    }
}
