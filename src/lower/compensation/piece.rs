//! Pieces of the path of the tool centre while their ends are not settled.

use std::rc::Rc;

use crate::geo::joint::Headings;
use crate::geo::{Element, Plane, Point2, Vec2, distance, joint};
use crate::ir::compensation::{Compensation, FeedAt, Outside};
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Function, Origin, Pos};
use crate::machine::AxisSet;

use super::super::step::plane_axes;
use super::bounds::Seen;

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
    /// Directions of the programmed element.
    pub headings: Headings,
    /// The path of the centre: its start is settled.
    pub curve: Element,
    /// Where the path leaves it; `None` for its end.
    pub stop: Option<Point2>,
    /// Part of the plain parallel: an element, or the arc about a corner.
    pub regular: bool,
    /// Joined to the one before as the plain parallel is: tangentially, at the crossing of lines, or by an arc about the
    /// corner.
    pub joined: bool,
    pub seen: Seen,
    /// The move that is printed, with the curve put in.
    pub mv: Move,
    pub origin: Origin,
    pub rules: Rc<Compensation>,
    pub items: Vec<Item>,
}

impl Piece {
    /// Its path ends where it was left.
    #[inline]
    pub fn settle(&mut self) {
        if let Some(p) = self.stop.take() {
            match &mut self.curve {
                Element::Line { to, .. } => *to = p,
                Element::Arc { .. } => self.curve = joint::up_to_point(&self.curve, p),
            }
        }
    }

    /// Its path begins at `p`.
    #[inline]
    pub fn begin_at(&mut self, p: Point2) {
        match &mut self.curve {
            Element::Line { from, .. } => *from = p,
            Element::Arc { .. } => self.curve = joint::from_point(&self.curve, p),
        }
    }

    pub fn end(&self) -> Point2 {
        self.stop.unwrap_or_else(|| self.curve.to())
    }

    /// Makes the move the one that is printed, from `at` along its settled path.
    #[inline]
    pub fn lead_along(&mut self, at: &Pos) {
        let (plane, shift) = (self.mv.plane, self.rules.nose);
        if self.kind == Kind::Joint {
            self.mv.end = *at;
        }
        self.mv.end.set_in_plane(plane, self.end() - shift);
        self.mv.axes = self.mv.axes.union(plane_axes(plane));
        self.mv.side = crate::ir::Side::None;
        match (self.curve, self.mv.path) {
            (Element::Line { .. }, Path::Rapid | Path::Line(_)) => {}
            (Element::Arc { from, center, sweep, .. }, Path::Line(feed) | Path::Arc(_, feed)) => {
                let feed = feed.with_value(feed.value() * self.feed_factor());
                self.mv.path = Path::Arc(Arc { plane, from: from - shift, center: center - shift, sweep }, feed);
            }
            // An arc without a feed is refused before it becomes a piece.
            (_, path) => self.mv.path = Path::straight(path.feed()),
        }
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
            FeedAt::Centre | FeedAt::CentreInstead(_) => 1.0,
        }
    }

    /// Nothing yet, to be filled in.
    pub fn blank(rules: &Rc<Compensation>) -> Box<Piece> {
        let nowhere = Element::Line { from: Point2::origin(), to: Point2::origin() };
        Box::new(Piece {
            kind: Kind::Joint,
            index: 0,
            contour: nowhere,
            headings: Headings::default(),
            curve: nowhere,
            stop: None,
            regular: false,
            joined: false,
            seen: Seen::default(),
            mv: Move::default(),
            origin: Origin::default(),
            rules: Rc::clone(rules),
            items: Vec::new(),
        })
    }

    /// Makes this a piece between `last` and `next`, which it takes its feed from.
    fn lead_between(&mut self, last: &Piece, next: &Piece, curve: Element) {
        let corner = last.contour.to();
        self.kind = Kind::Joint;
        self.index = last.index;
        self.contour = Element::Line { from: corner, to: corner };
        self.headings = Headings::default();
        self.curve = curve;
        self.stop = None;
        (self.regular, self.joined, self.seen) = (false, false, Seen::default());
        self.mv.plane = last.mv.plane;
        self.mv.axes = plane_axes(last.mv.plane);
        self.mv.path = Path::straight(next.mv.path.feed().or(last.mv.path.feed()));
        self.mv.machine = false;
        self.origin = next.origin;
    }

    /// A piece between this one and `next`, which it takes its feed from.
    pub fn joint_to(&self, next: &Piece, curve: Element) -> Box<Piece> {
        let mut made = Piece::blank(&next.rules);
        made.lead_between(self, next, curve);
        made
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

/// Pieces that were printed, to be filled in again: none is allocated for each block.
#[derive(Debug, Default)]
pub struct PiecePool {
    // They go from hand to hand, as they are.
    #[allow(clippy::vec_box)]
    pieces: Vec<Box<Piece>>,
}

impl PiecePool {
    /// A piece to be filled in, all but its rules.
    #[inline]
    pub fn take(&mut self, rules: &Rc<Compensation>) -> Box<Piece> {
        let Some(mut piece) = self.pieces.pop() else { return Piece::blank(rules) };
        if !Rc::ptr_eq(&piece.rules, rules) {
            piece.rules = Rc::clone(rules);
        }
        piece
    }

    /// A piece between two others, as [`Piece::joint_to`] makes it.
    pub fn joint(&mut self, last: &Piece, next: &Piece, curve: Element) -> Box<Piece> {
        let mut made = self.take(&next.rules);
        made.lead_between(last, next, curve);
        made
    }

    /// A piece without items.
    #[inline]
    pub fn put(&mut self, piece: Box<Piece>) {
        self.pieces.push(piece);
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
