//! The cutter of a milling cycle: sends moves of a shape at its place, and knows where the tool stands.

use std::rc::Rc;

use crate::diag::Fault;
use crate::geo::{Element, Point2, distance};
use crate::ir::contour::{Arc, ArcShape, Coords, Move, Path};
use crate::ir::cycle::Drilling;
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::function::Spindle;
use crate::ir::{Compensation, Feed, Function, Pos, Side};

use super::{CycleItem, Expand, Start};

/// What arithmetic may lose at an arc that a cycle computed, mm.
const ARC_TOLERANCE: f64 = 1e-6;
/// Arcs with a shorter chord are lines, mm: what is printed would not tell them from full circles.
const SHORTEST_ARC: f64 = 1e-3;
/// Moves shorter than this are left out, mm.
const NOTHING: f64 = 1e-9;

/// Sends moves; points are those of the shape, heights those of the tool axis.
pub struct Cutter<'a> {
    mill: &'a Mill,
    place: Place,
    /// In the plane, not at the place.
    at: Option<Point2>,
    height: Option<f64>,
    /// Where the last move along the tool axis at rapid traverse ends, which was not sent yet: it may go on.
    lifting: Option<f64>,
    out: &'a mut dyn FnMut(CycleItem),
}

/// A contour beside which the cutter works.
#[derive(Debug, Clone)]
pub struct Beside {
    pub side: Side,
    pub rules: Rc<Compensation>,
}

/// How the cutter gets along a contour.
#[derive(Debug, Clone, Copy)]
pub enum Way {
    Rapid,
    Line(Feed),
    /// The end may lie `tol` mm beside the circle.
    Arc {
        center: Point2,
        ccw: bool,
        tol: f64,
        feed: Feed,
    },
}

impl core::fmt::Debug for Cutter<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Cutter").field("at", &self.at).field("height", &self.height).finish_non_exhaustive()
    }
}

impl<'a> Cutter<'a> {
    pub fn new(mill: &'a Mill, place: Place, start: &Start, out: &'a mut dyn FnMut(CycleItem)) -> Cutter<'a> {
        let (at, height) = (start.at.in_plane(mill.plane), start.at.get(mill.axis()));
        Cutter { mill, place, at, height, lifting: None, out }
    }

    /// The shape lies at another place now.
    pub fn go_on_at(&mut self, place: Place) {
        self.place = place;
    }

    /// How every milling cycle begins a place: up to the retract height if the tool stands below it, over `to`, and down to
    /// the safety distance above the surface.
    pub fn approach(&mut self, to: Point2) {
        self.rise();
        self.rapid(to);
        self.lift(self.mill.heights.safe());
    }

    /// Up to the retract height if the tool stands below it.
    pub fn rise(&mut self) {
        let heights = &self.mill.heights;
        // Where the tool may stand anywhere, the retract height is the one that is free.
        if !self.height.is_some_and(|height| (height - heights.retract) * heights.outward() >= -NOTHING) {
            self.lift(heights.retract);
        }
    }

    /// Does the tool stand above `height`, out of the material?
    pub fn is_above(&self, height: f64) -> bool {
        self.height.is_none_or(|at| (at - height) * self.mill.heights.outward() > NOTHING)
    }

    /// Does the tool stand below `height`?
    pub fn is_below(&self, height: f64) -> bool {
        self.height.is_some_and(|at| (at - height) * self.mill.heights.outward() < -NOTHING)
    }

    /// How every milling cycle ends a place.
    pub fn retract(&mut self) {
        self.lift(self.mill.heights.retract);
        self.go_on();
    }

    /// Along the tool axis at rapid traverse, out of the material or through what is cleared.
    pub fn lift(&mut self, height: f64) {
        let Some(now) = self.height.filter(|now| (*now - height).abs() > NOTHING) else {
            if self.height.is_none() {
                (self.height, self.lifting) = (Some(height), Some(height));
            }
            return;
        };
        let outwards = (height - now) * self.mill.heights.outward() > 0.0;
        if self.lifting.is_some() && !outwards {
            self.go_on();
        }
        (self.height, self.lifting) = (Some(height), Some(height));
    }

    /// Sends the move along the tool axis that waits.
    fn go_on(&mut self) {
        if let Some(height) = self.lifting.take() {
            self.send(None, Some(height), Path::Rapid);
        }
    }

    /// In the plane at rapid traverse.
    pub fn rapid(&mut self, to: Point2) {
        self.straight(to, Path::Rapid);
    }

    /// Along the tool axis at the feed for the depth.
    pub fn plunge(&mut self, height: f64) {
        self.sink(height, self.mill.feeds.depth);
    }

    /// Along the tool axis at `feed`.
    pub fn sink(&mut self, height: f64, feed: Feed) {
        if self.height.is_none_or(|now| (now - height).abs() > NOTHING) {
            self.go_on();
            self.height = Some(height);
            self.send(None, Some(height), Path::Line(feed));
        }
    }

    /// In the plane beside the material, at `feed` or at rapid traverse.
    pub fn go(&mut self, to: Point2, feed: Option<Feed>) {
        match feed {
            Some(feed) => self.line(to, feed),
            None => self.rapid(to),
        }
    }

    /// Along the tool axis beside the material, at `feed` or at rapid traverse.
    pub fn go_down(&mut self, height: f64, feed: Option<Feed>) {
        match feed {
            Some(feed) => self.sink(height, feed),
            None => self.lift(height),
        }
    }

    /// Drills where the cutter stands.
    ///
    /// # Errors
    /// Data that make no hole.
    pub fn drill(&mut self, hole: &Drilling, start: &Start) -> Result<(), Fault> {
        // The hole begins with its own way to its start plane.
        self.lifting = None;
        self.height = Some(hole.levels.retract);
        hole.expand(start, self.out)
    }

    /// In the plane at `feed`.
    pub fn line(&mut self, to: Point2, feed: Feed) {
        self.straight(to, Path::Line(feed));
    }

    /// About `center` to `to`; a full circle where the tool stands there.
    pub fn arc(&mut self, to: Point2, center: Point2, ccw: bool, feed: Feed) {
        let end = self.place.point(to);
        let gap = self.at.map_or(f64::INFINITY, |at| distance(at, end));
        if gap > NOTHING && gap < SHORTEST_ARC {
            return self.line(to, feed);
        }
        self.round(end, None, center, (ccw, 0), feed);
    }

    /// Whole turns about `center`, evenly down to `height`.
    pub fn helix(&mut self, center: Point2, ccw: bool, turns: u32, height: f64, feed: Feed) {
        let Some(at) = self.at.filter(|_| turns > 0) else { return };
        self.height = Some(height);
        self.round(at, Some(height), center, (ccw, turns - 1), feed);
    }

    /// Turns about `center`, and on to `to`, evenly down to `height`.
    pub fn spiral(&mut self, to: Point2, center: Point2, turns: (bool, u32), height: f64, feed: Feed) {
        self.height = Some(height);
        self.round(self.place.point(to), Some(height), center, turns, feed);
    }

    /// An element that begins where the tool stands.
    pub fn element(&mut self, element: &Element, feed: Feed) {
        match *element {
            Element::Line { to, .. } => self.line(to, feed),
            Element::Arc { to, center, sweep, .. } => self.arc(to, center, sweep > 0.0, feed),
        }
    }

    /// An element on which the tool falls evenly to `height`.
    pub fn fall(&mut self, element: &Element, height: f64, feed: Feed) {
        let end = self.place.point(element.to());
        match *element {
            Element::Line { .. } => {
                self.go_on();
                (self.at, self.height) = (Some(end), Some(height));
                self.send(Some(end), Some(height), Path::Line(feed));
            }
            Element::Arc { center, sweep, .. } => {
                self.height = Some(height);
                self.round(end, Some(height), center, (sweep > 0.0, 0), feed);
            }
        }
    }

    pub fn speed(&mut self, speed: f64) {
        self.go_on();
        (self.out)(CycleItem::Function(Function::Spindle(Spindle::Speed(speed))));
    }

    /// Does the tool stand over this point?
    pub fn stands_at(&self, point: Point2) -> bool {
        self.at.is_some_and(|at| distance(at, self.place.point(point)) <= NOTHING)
    }

    /// Elements one after the other, the first one from where the tool stands.
    pub fn follow(&mut self, elements: &[Element], feed: Feed) {
        for element in elements {
            self.element(element, feed);
        }
    }

    /// To a point of the contour, or to a height, with the cutter on one side of the contour; the path of its centre follows
    /// from the rules.
    pub fn beside(&mut self, contour: &Beside, to: Option<Point2>, height: Option<f64>, way: Way) {
        self.go_on();
        let end = to.map(|to| self.place.point(to));
        let path = match way {
            Way::Rapid => Path::Rapid,
            Way::Line(feed) => Path::Line(feed),
            Way::Arc { center, ccw, tol, feed } => {
                let shape = ArcShape::Center { center: self.place.point(center), ccw, tol: tol + ARC_TOLERANCE };
                Path::Arc(Arc { plane: self.mill.plane, shape, turns: 0 }, feed)
            }
        };
        let mv = self.to(end, height, path, contour.side);
        (self.at, self.height) = (end.or(self.at), height.or(self.height));
        (self.out)(CycleItem::Beside(mv, Rc::clone(&contour.rules)));
    }

    fn straight(&mut self, to: Point2, path: Path) {
        let end = self.place.point(to);
        if self.at.is_some_and(|at| distance(at, end) <= NOTHING) {
            return;
        }
        self.go_on();
        self.at = Some(end);
        self.send(Some(end), None, path);
    }

    /// To `end`, a point of the plane; the sense, and turns on top.
    fn round(&mut self, end: Point2, height: Option<f64>, center: Point2, (ccw, turns): (bool, u32), feed: Feed) {
        self.go_on();
        let shape = ArcShape::Center { center: self.place.point(center), ccw, tol: ARC_TOLERANCE };
        self.at = Some(end);
        self.send(Some(end), height, Path::Arc(Arc { plane: self.mill.plane, shape, turns }, feed));
    }

    fn send(&mut self, point: Option<Point2>, height: Option<f64>, path: Path) {
        let mv = self.to(point, height, path, Side::None);
        (self.out)(CycleItem::Move(mv));
    }

    fn to(&self, point: Option<Point2>, height: Option<f64>, path: Path, side: Side) -> Move {
        let mut end = Pos::UNKNOWN;
        if let Some(point) = point {
            end.set_in_plane(self.mill.plane, point);
        }
        if let Some(height) = height {
            end.set(self.mill.axis(), height);
        }
        Move { end, path, side, coords: Coords::Frame }
    }
}
