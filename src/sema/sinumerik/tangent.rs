//! CT: circles that go on in the direction of the block before.
//!
//! Source: reference section 2.3.

use crate::diag::codes;
use crate::geo::arc::{TangentArc, tangent_arc, tangent_at};
use crate::geo::{Plane, Point2, Vec2, length};
use crate::ir::Pos;
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::machine::AxisSet;
use crate::text::Span;

use super::circle::SAME;
use super::vocabulary::Address;
use super::words::Words;
use super::{Outcome, Run};

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
    /// The contour itself tells it later.
    Later,
}

/// What is known of the tangent in front of CT.
enum Tangent {
    Known(Vec2),
    Later,
    /// Why there is none.
    Missing(&'static str),
}

impl Run<'_> {
    /// CT
    pub(super) fn tangent_block(&mut self, w: &mut Words) -> Outcome {
        let plane = self.st.plane();
        let feed = self.path_feed(w, false)?;
        let turns = self.turns(w)?;
        let start = self.start_in(plane, w)?;
        let polar = w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some();
        let mut end = if polar { self.polar_end(w)? } else { self.targets(w)? };
        let to = self.end_in(&end, plane, start);
        end.set_in_plane(plane, to);
        if self.pending.is_none() && !self.st.machine_coordinates {
            self.check_tangent(plane, start, to, turns)?;
        }
        self.send_arc(&end, Arc { plane, shape: ArcShape::Tangent, turns }, feed, Span::default())
    }

    /// Alarm 14045.
    fn check_tangent(&self, plane: Plane, start: Point2, to: Point2, turns: u32) -> Outcome {
        let tangent = match self.tangent_in(plane, start) {
            Tangent::Known(tangent) => tangent,
            Tangent::Later => return Ok(()),
            Tangent::Missing(why) => return self.no_tangent(why, "put a line or arc of the plane in front of CT"),
        };
        match tangent_arc(start, tangent, to, SAME, 1e-9 * length(to - start)) {
            TangentArc::Behind => {
                self.no_tangent("the end point lies straight behind the start", "give the end point to one side")
            }
            TangentArc::Line if turns > 0 => {
                self.no_tangent("CT is a straight line here, which has no turns", "leave TURN= out")
            }
            _ => Ok(()),
        }
    }

    fn no_tangent(&self, why: &str, help: &str) -> Outcome {
        self.fail_help(codes::S3008, 14045, Span::default(), why, help)
    }

    fn tangent_in(&self, plane: Plane, start: Point2) -> Tangent {
        match self.st.heading {
            Heading::None => Tangent::Missing("no block in front of CT gives a direction"),
            Heading::Later => Tangent::Later,
            Heading::Arc { plane: other, center, ccw } if other == plane => {
                tangent_at(start, center, ccw).map_or(Tangent::Later, Tangent::Known)
            }
            Heading::Arc { .. } => Tangent::Later,
            Heading::Line(from) => {
                let Some(way) = from.in_plane(plane).map(|from| start - from) else {
                    return Tangent::Missing("the block in front of CT starts at a place that is not known");
                };
                let size = length(way);
                if size > SAME {
                    Tangent::Known(way / size)
                } else {
                    Tangent::Missing("the block in front of CT runs at a right angle to the plane")
                }
            }
        }
    }

    /// Notes where a block that is sent out travels.
    #[inline]
    pub(super) fn note_heading(&mut self, end: &Pos, path: &Path) {
        match path {
            Path::Arc(Arc { plane, shape: ArcShape::Center { center, ccw, .. }, .. }) => {
                self.st.heading = Heading::Arc { plane: *plane, center: *center, ccw: *ccw };
            }
            Path::Arc(_) => self.st.heading = Heading::Later,
            _ => {
                let at = &self.st.pos;
                let travels = AxisSet::MAIN.iter().any(|axis| end.get(axis).is_some_and(|to| at.get(axis) != Some(to)));
                if travels {
                    self.st.heading = Heading::Line(*at);
                }
            }
        }
    }
}
