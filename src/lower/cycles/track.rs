//! What a turning cycle is made of: strokes in the plane of Z and X, and the view in which a cycle is
//! computed.

use crate::diag::Code;
use crate::geo::{Point2, Vec2};
use crate::ir::Feed;
use crate::ir::cycle::turning::Towards;
use crate::machine::Axis;

/// One movement of a cycle. Points are (Z, X) with X as a radius, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stroke {
    Rapid { to: Point2 },
    Line { to: Point2, feed: Feed },
    Arc { to: Point2, center: Point2, ccw: bool, feed: Feed },
    Thread { to: Point2, lead: f64, along: Axis },
    /// Wait, seconds.
    Dwell { seconds: f64 },
}

/// Why a cycle makes no path: code, message, and what to do.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    pub code: &'static Code,
    pub message: String,
    pub help: &'static str,
}

impl Failure {
    pub fn new(code: &'static Code, message: impl Into<String>, help: &'static str) -> Failure {
        Failure { code, message: message.into(), help }
    }
}

/// Takes the strokes of a cycle.
pub type Strokes<'a> = dyn FnMut(Stroke) + 'a;

impl Stroke {
    /// Where the tool stands after it; `None` for a dwell.
    pub fn end(&self) -> Option<Point2> {
        match *self {
            Stroke::Rapid { to } | Stroke::Line { to, .. } | Stroke::Arc { to, .. } | Stroke::Thread { to, .. } => {
                Some(to)
            }
            Stroke::Dwell { .. } => None,
        }
    }
}

/// The axes as a cycle sees them: it always cuts along `x` and feeds in towards lower `y`.
///
/// The four sides of a part (outside, bore, front and rear face) and both directions of cutting are one
/// case this way. Points of the view and of the part map to each other exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// The cutting axis is X.
    swap: bool,
    /// Sense of the cutting axis and of the infeed axis.
    along: f64,
    out: f64,
}

impl View {
    /// The view for `into`; `along` is the sense of the part's cutting axis that is to become positive.
    pub fn new(into: Towards, along: f64) -> View {
        let out = match into {
            Towards::MinusX | Towards::MinusZ => 1.0,
            Towards::PlusX | Towards::PlusZ => -1.0,
        };
        View { swap: !into.is_radial(), along: if along < 0.0 { -1.0 } else { 1.0 }, out }
    }

    /// A point of the part in the view.
    pub fn point(&self, p: Point2) -> Point2 {
        if self.swap { Point2::new(p.y * self.along, p.x * self.out) } else { Point2::new(p.x * self.along, p.y * self.out) }
    }

    /// A direction of the part in the view.
    pub fn vector(&self, v: Vec2) -> Vec2 {
        self.point(Point2::from(v)).coords
    }

    /// A coordinate of the infeed axis in the view.
    pub fn height(&self, coordinate: f64) -> f64 {
        coordinate * self.out
    }

    /// A point of the view on the part.
    pub fn part(&self, p: Point2) -> Point2 {
        let (along, out) = (p.x * self.along, p.y * self.out);
        if self.swap { Point2::new(out, along) } else { Point2::new(along, out) }
    }

    /// The cutting axis.
    pub fn axis(&self) -> Axis {
        if self.swap { Axis::X } else { Axis::Z }
    }

    /// Is the view a mirror image, so that arcs turn the other way?
    pub fn mirrors(&self) -> bool {
        (self.along * self.out < 0.0) != self.swap
    }

    /// A stroke of the view on the part.
    pub fn stroke(&self, stroke: Stroke) -> Stroke {
        match stroke {
            Stroke::Rapid { to } => Stroke::Rapid { to: self.part(to) },
            Stroke::Line { to, feed } => Stroke::Line { to: self.part(to), feed },
            Stroke::Arc { to, center, ccw, feed } => {
                Stroke::Arc { to: self.part(to), center: self.part(center), ccw: ccw != self.mirrors(), feed }
            }
            Stroke::Thread { to, lead, .. } => Stroke::Thread { to: self.part(to), lead, along: self.axis() },
            dwell @ Stroke::Dwell { .. } => dwell,
        }
    }
}

/// Sends strokes computed in a view and knows where the tool stands. Moves of no length are left out.
pub struct Track<'a> {
    view: View,
    at: Point2,
    out: &'a mut Strokes<'a>,
}

impl core::fmt::Debug for Track<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Track").field("view", &self.view).field("at", &self.at).finish_non_exhaustive()
    }
}

impl<'a> Track<'a> {
    /// A track from `from`, a point of the part.
    pub fn new(view: View, from: Point2, out: &'a mut Strokes<'a>) -> Track<'a> {
        Track { view, at: view.point(from), out }
    }

    /// Where the tool stands, in the view.
    pub fn at(&self) -> Point2 {
        self.at
    }

    pub fn rapid(&mut self, to: Point2) {
        self.send(to, Stroke::Rapid { to });
    }

    pub fn line(&mut self, to: Point2, feed: Feed) {
        self.send(to, Stroke::Line { to, feed });
    }

    pub fn arc(&mut self, to: Point2, center: Point2, ccw: bool, feed: Feed) {
        self.send(to, Stroke::Arc { to, center, ccw, feed });
    }

    pub fn thread(&mut self, to: Point2, lead: f64) {
        self.send(to, Stroke::Thread { to, lead, along: self.view.axis() });
    }

    pub fn dwell(&mut self, seconds: f64) {
        if seconds > 0.0 {
            (self.out)(Stroke::Dwell { seconds });
        }
    }

    fn send(&mut self, to: Point2, stroke: Stroke) {
        if to != self.at {
            self.at = to;
            (self.out)(self.view.stroke(stroke));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_map_back_exactly_and_know_mirrors() {
        let p = Point2::new(-3.25, 17.5);
        for into in [Towards::MinusX, Towards::PlusX, Towards::MinusZ, Towards::PlusZ] {
            for along in [1.0, -1.0] {
                let view = View::new(into, along);
                assert_eq!(view.part(view.point(p)), p);
                assert!(view.vector(into.unit()).y < 0.0, "{into:?}");
                let (a, b) = (view.vector(Vec2::x()), view.vector(Vec2::y()));
                assert_eq!(view.mirrors(), crate::geo::cross(a, b) < 0.0, "{into:?} {along}");
            }
        }
    }
}
