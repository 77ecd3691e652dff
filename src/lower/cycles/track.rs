//! What a turning cycle is made of: strokes in the plane of Z and X, and the view in which a cycle is
//! computed.

use crate::geo::{Element, Plane, Point2, Vec2};
use crate::ir::contour::{self, ArcShape, Coords};
use crate::ir::cycle::turning::Towards;
use crate::ir::{Feed, Pos, Side};
use crate::machine::Axis;

/// What a cycle does next. Points are (Z, X) with X as a radius, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stroke {
    Move(Move),
    /// Wait, seconds.
    Dwell {
        seconds: f64,
    },
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    pub to: Point2,
    pub path: Path,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    Rapid,
    Line { feed: Feed },
    Arc { center: Point2, ccw: bool, feed: Feed },
    Thread { lead: f64, along: Axis },
}

/// Takes the strokes of a cycle.
pub type Strokes<'a> = dyn FnMut(Stroke) + 'a;

impl Move {
    /// The movement in the programmed frame.
    pub fn movement(&self) -> contour::Move {
        let path = match self.path {
            Path::Rapid => contour::Path::Rapid,
            Path::Line { feed } => contour::Path::Line(feed),
            Path::Arc { center, ccw, feed } => {
                let shape = ArcShape::Center { center, ccw, tol: ARC_TOLERANCE };
                contour::Path::Arc(contour::Arc { plane: Plane::Zx, shape, turns: 0 }, feed)
            }
            Path::Thread { lead, along } => contour::Path::Thread(contour::Thread { lead, along: Some(along) }),
        };
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(Plane::Zx, self.to);
        contour::Move { end, path, side: Side::None, coords: Coords::Frame }
    }
}

/// What arithmetic may lose at an arc that a cycle computed, mm.
const ARC_TOLERANCE: f64 = 1e-6;

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

    /// The part as it is, for cycles that follow a contour.
    pub fn plain() -> View {
        View { swap: false, along: 1.0, out: 1.0 }
    }

    /// A point of the part in the view.
    pub fn point(&self, p: Point2) -> Point2 {
        if self.swap {
            Point2::new(p.y * self.along, p.x * self.out)
        } else {
            Point2::new(p.x * self.along, p.y * self.out)
        }
    }

    /// An element of the part in the view.
    pub fn element(&self, element: &Element) -> Element {
        self.mapped(element, |p| self.point(p))
    }

    /// An element of the view on the part.
    pub fn element_on_part(&self, element: &Element) -> Element {
        self.mapped(element, |p| self.part(p))
    }

    fn mapped(&self, element: &Element, point: impl Fn(Point2) -> Point2) -> Element {
        match *element {
            Element::Line { from, to } => Element::Line { from: point(from), to: point(to) },
            Element::Arc { from, to, center, sweep } => Element::Arc {
                from: point(from),
                to: point(to),
                center: point(center),
                sweep: if self.mirrors() { -sweep } else { sweep },
            },
        }
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

    /// A move of the view on the part.
    pub fn on_part(&self, mv: Move) -> Move {
        let path = match mv.path {
            Path::Arc { center, ccw, feed } => {
                Path::Arc { center: self.part(center), ccw: ccw != self.mirrors(), feed }
            }
            straight @ (Path::Rapid | Path::Line { .. } | Path::Thread { .. }) => straight,
        };
        Move { to: self.part(mv.to), path }
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
        self.send(to, Path::Rapid);
    }

    pub fn line(&mut self, to: Point2, feed: Feed) {
        self.send(to, Path::Line { feed });
    }

    pub fn arc(&mut self, to: Point2, center: Point2, ccw: bool, feed: Feed) {
        self.send(to, Path::Arc { center, ccw, feed });
    }

    pub fn thread(&mut self, to: Point2, lead: f64) {
        self.send(to, Path::Thread { lead, along: self.view.axis() });
    }

    pub fn dwell(&mut self, seconds: f64) {
        if seconds > 0.0 {
            (self.out)(Stroke::Dwell { seconds });
        }
    }

    fn send(&mut self, to: Point2, path: Path) {
        if to != self.at {
            self.at = to;
            (self.out)(Stroke::Move(self.view.on_part(Move { to, path })));
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
