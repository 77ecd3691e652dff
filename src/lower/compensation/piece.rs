//! Pieces of the path of the tool centre while their ends are not settled.

use std::rc::Rc;

use crate::geo::{Element, Plane, Point2, Vec2, distance, joint};
use crate::ir::compensation::{Compensation, FeedAt, Outside};
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Function, Origin, Pos};
use crate::machine::AxisSet;

use super::super::step::plane_axes;

/// What a piece is of the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The way to the contour; its curve is what a search may meet, and is not travelled.
    Entry,
    /// An element of the contour.
    Element,
    /// An element that leaves no room for the tool: nothing of it is left.
    Gone,
    /// What is put between two elements.
    Joint,
    /// The end of the contour prolonged; never travelled.
    Exit,
}

impl Kind {
    pub fn is_of_contour(self) -> bool {
        matches!(self, Kind::Element | Kind::Gone)
    }
}

/// What happens where a piece ends.
#[derive(Debug, Clone)]
pub enum Item {
    Function(Function, Origin),
    /// A move that leaves the plane alone.
    Move(Move, Origin),
}

#[derive(Debug, Clone)]
pub struct Piece {
    pub kind: Kind,
    /// Place in the contour; that of a joint is the one of the element before.
    pub index: u32,
    /// The programmed element; a joint has its corner.
    pub contour: Element,
    /// The path of the centre: its start is settled.
    pub curve: Element,
    /// Where the path leaves it; `None` for its end.
    pub stop: Option<Point2>,
    /// The move that is printed, with the curve put in.
    pub mv: Move,
    pub origin: Origin,
    pub rules: Rc<Compensation>,
    pub items: Vec<Item>,
}

impl Piece {
    /// What is travelled of it.
    pub fn travelled(&self) -> Element {
        match self.stop {
            Some(p) => joint::up_to_point(&self.curve, p),
            None => self.curve,
        }
    }

    pub fn end(&self) -> Point2 {
        self.stop.unwrap_or_else(|| self.curve.to())
    }

    /// The printed move from `at` along `curve`.
    pub fn printed(&self, curve: &Element, at: &Pos) -> Move {
        let (plane, shift) = (self.mv.plane, self.rules.nose);
        let mut mv = self.mv;
        if self.kind == Kind::Joint {
            mv.end = *at;
        }
        mv.end.set_in_plane(plane, curve.to() - shift);
        mv.axes = mv.axes.union(plane_axes(plane));
        mv.side = crate::ir::Side::None;
        let feed = self.mv.path.feed().map(|feed| feed.with_value(feed.value() * self.feed_factor()));
        mv.path = match (*curve, feed) {
            (Element::Arc { from, center, sweep, .. }, Some(feed)) => {
                Path::Arc(Arc { plane, from: from - shift, center: center - shift, sweep }, feed)
            }
            // An arc without a feed is refused before it becomes a piece.
            _ => Path::straight(feed),
        };
        mv
    }

    /// How much faster than the contour the centre travels.
    fn feed_factor(&self) -> f64 {
        let (Element::Arc { from, center, .. }, Element::Arc { from: own, .. }) = (self.contour, self.curve) else {
            return 1.0;
        };
        let factor = distance(own, center) / distance(from, center);
        match self.rules.feed {
            FeedAt::Contour => factor,
            FeedAt::HollowContour => factor.min(1.0),
            FeedAt::Centre | FeedAt::CentreInstead => 1.0,
        }
    }

    /// A piece between this one and `next`, which it takes its feed from.
    pub fn joint_to(&self, next: &Piece, curve: Element) -> Piece {
        let corner = self.contour.to();
        let plane = self.mv.plane;
        let feed = next.mv.path.feed().or(self.mv.path.feed());
        let mv = Move { axes: plane_axes(plane), path: Path::straight(feed), ..self.mv };
        Piece {
            kind: Kind::Joint,
            index: self.index,
            contour: Element::Line { from: corner, to: corner },
            curve,
            stop: None,
            mv,
            origin: next.origin,
            rules: Rc::clone(&next.rules),
            items: Vec::new(),
        }
    }

    /// What is left of an element that is left out: the motion of the axes outside of its plane.
    pub fn other_axes(&self) -> Option<Item> {
        let axes = self.mv.axes.without(plane_axes(self.mv.plane));
        let mv = Move { axes, path: Path::straight(self.mv.path.feed()), ..self.mv };
        (self.kind.is_of_contour() && !axes.is_empty()).then_some(Item::Move(mv, self.origin))
    }

    /// May its end be prolonged at the next joint?
    pub fn may_grow(&self) -> bool {
        self.rules.outside != Outside::default()
    }

    pub fn has_feed(&self) -> bool {
        self.mv.path.feed().is_some()
    }
}

/// `mv` at the place in `plane` where the tool stands in truth.
pub fn aside(mv: &Move, at: &Pos, plane: Plane) -> Move {
    let mut mv = *mv;
    mv.side = crate::ir::Side::None;
    if !mv.machine
        && let Some(p) = at.in_plane(plane)
    {
        mv.end.set_in_plane(plane, p);
    }
    mv
}

/// `mv` moved by `by` in its plane.
pub fn moved(mv: &Move, by: Vec2) -> Move {
    let mut mv = *mv;
    let plane = mv.plane;
    if let Some(p) = mv.end.in_plane(plane) {
        mv.end.set_in_plane(plane, p + by);
    }
    mv.axes = mv.axes.union(plane_axes(plane));
    mv.side = crate::ir::Side::None;
    if let Path::Arc(arc, _) = &mut mv.path {
        arc.from += by;
        arc.center += by;
    }
    mv
}

/// Both axes of the plane belong to `mv`, as far as their places are known.
pub fn with_plane(mv: &Move, plane: Plane) -> Move {
    let both: AxisSet = plane_axes(plane).common(mv.end.known());
    Move { axes: mv.axes.union(both), ..*mv }
}
