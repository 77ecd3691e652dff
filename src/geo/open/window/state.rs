//! What is known of the elements of a window, in one of its branches.

use std::collections::VecDeque;

use crate::geo::{Deg, Point2, Vec2, direction, distance};

use super::{Base, Given, Item, ONE, Place, Serial, Shape, Window, is_one};
use crate::geo::open::Solved;

/// What is known of an element.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Node {
    /// Of an arc: counter-clockwise.
    pub ccw: bool,
    /// Directions of travel at its ends; a line has one.
    pub entry: Option<Vec2>,
    pub exit: Option<Vec2>,
    /// Radius, positive counter-clockwise.
    pub rho: Option<f64>,
    pub center: Option<Point2>,
    /// A point of a line whose direction is known.
    pub on: Option<Point2>,
    pub end: Option<Point2>,
    /// It is complete, and all its data is met.
    pub checked: bool,
}

/// Something new about an element.
#[derive(Debug, Clone, Copy)]
pub(super) enum Fact {
    Entry(Vec2),
    Exit(Vec2),
    Radius(f64),
    Circle(Point2, f64),
    Line(Point2, Vec2),
    End(Point2),
    Checked,
}

/// One branch.
#[derive(Debug, Clone, Default)]
pub(super) struct State {
    pub nodes: VecDeque<Node>,
}

impl State {
    pub fn add(&mut self, ccw: bool) {
        self.nodes.push_back(Node { ccw, ..Node::default() });
    }

    /// The last arc turns the other way.
    pub fn turn_last(&mut self) {
        if let Some(last) = self.nodes.back_mut() {
            last.ccw = !last.ccw;
        }
    }

    pub fn pop(&mut self) {
        self.nodes.pop_front();
    }

    pub fn set(&mut self, node: usize, fact: Fact) {
        let Some(node) = self.nodes.get_mut(node) else { return };
        match fact {
            Fact::Entry(u) => node.entry = Some(u),
            Fact::Exit(u) => node.exit = Some(u),
            Fact::Radius(rho) => node.rho = Some(rho),
            Fact::Circle(center, rho) => (node.center, node.rho) = (Some(center), Some(rho)),
            Fact::Line(on, u) => (node.on, node.entry, node.exit) = (Some(on), Some(u), Some(u)),
            Fact::End(end) => node.end = Some(end),
            Fact::Checked => node.checked = true,
        }
    }

    pub fn is_complete(&self, node: usize) -> bool {
        self.nodes.get(node).is_some_and(|node| node.checked)
    }

    /// The first element that is not complete, or their number.
    pub fn first_open(&self) -> usize {
        self.nodes.iter().position(|node| !node.checked).unwrap_or(self.nodes.len())
    }

    /// Both are complete and the same.
    pub fn is_same(&self, other: &State) -> bool {
        let same = |(a, b): (&Node, &Node)| {
            let solved = |node: &Node| {
                let to = node.end.filter(|_| node.checked)?;
                Some(Solved { from: to, to, arc: node.center.map(|center| (center, node.ccw)) })
            };
            solved(a).zip(solved(b)).is_some_and(|(a, b)| is_one(&a, &b))
        };
        self.nodes.len() == other.nodes.len() && self.nodes.iter().zip(&other.nodes).all(same)
    }
}

/// A window in one of its states.
#[derive(Debug, Clone, Copy)]
pub(super) struct View<'a> {
    pub window: &'a Window,
    pub state: &'a State,
}

/// A point as far as it is known: in coordinates, and about the pole.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Known {
    pub x: Option<f64>,
    pub y: Option<f64>,
    pub radius: Option<f64>,
    /// Direction from the pole.
    pub ray: Option<Vec2>,
}

impl View<'_> {
    pub fn item(&self, node: usize) -> &Item {
        &self.window.items[node]
    }

    pub fn node(&self, node: usize) -> &Node {
        &self.state.nodes[node]
    }

    pub fn is_line(&self, node: usize) -> bool {
        self.item(node).shape == Shape::Line
    }

    /// The element behind, if there is one.
    pub fn next(&self, node: usize) -> Option<(usize, &Item)> {
        self.window.items.get(node + 1).map(|item| (node + 1, item))
    }

    /// The element behind, if it goes on without a corner.
    pub fn smooth_next(&self, node: usize) -> Option<usize> {
        self.next(node).filter(|(_, item)| item.smooth).map(|(next, _)| next)
    }

    pub fn start(&self, node: usize) -> Option<Point2> {
        if node == 0 { Some(self.window.at) } else { self.node(node - 1).end }
    }

    pub fn end(&self, node: usize) -> Option<Point2> {
        self.node(node).end
    }

    /// Direction in which the element before ends.
    pub fn before(&self, node: usize) -> Option<Vec2> {
        if node == 0 { self.window.before } else { self.node(node - 1).exit }
    }

    /// A line, by a point and its direction.
    pub fn line(&self, node: usize) -> Option<(Point2, Vec2)> {
        let of = self.node(node);
        of.on.zip(of.entry).filter(|_| self.is_line(node))
    }

    /// A circle, by its centre and its radius with sign.
    pub fn circle(&self, node: usize) -> Option<(Point2, f64)> {
        let of = self.node(node);
        of.center.zip(of.rho)
    }

    /// The element with this number where it still waits.
    pub fn waiting(&self, serial: Serial) -> Option<usize> {
        serial.checked_sub(self.window.first).filter(|node| *node < self.window.items.len())
    }

    fn old(&self, serial: Serial) -> Option<&super::Settled> {
        self.window.settled.iter().find(|old| old.serial == serial)
    }

    pub fn end_of(&self, serial: Serial) -> Option<Point2> {
        match self.waiting(serial) {
            Some(node) => self.end(node),
            None => self.old(serial).map(|old| old.solved.to),
        }
    }

    pub fn start_of(&self, serial: Serial) -> Option<Point2> {
        match self.waiting(serial) {
            Some(node) => self.start(node),
            None => self.old(serial).map(|old| old.solved.from),
        }
    }

    pub fn exit_of(&self, serial: Serial) -> Option<Vec2> {
        match self.waiting(serial) {
            Some(node) => self.node(node).exit,
            None => self.old(serial).map(|old| old.exit),
        }
    }

    /// A point of the line that runs along the end of an element.
    pub fn point_of(&self, serial: Serial) -> Option<Point2> {
        match self.waiting(serial) {
            Some(node) => self.line(node).map(|(on, _)| on).or(self.end(node)),
            None => self.old(serial).map(|old| old.solved.to),
        }
    }

    /// The centre of an arc, the end of a line.
    pub fn center_of(&self, serial: Serial) -> Option<Point2> {
        match self.waiting(serial) {
            Some(node) if self.is_line(node) => self.end(node),
            Some(node) => self.node(node).center,
            None => self.old(serial).map(|old| old.solved.arc.map_or(old.solved.to, |(center, _)| center)),
        }
    }

    /// Does everything that the element refers to stand?
    pub fn has_references(&self, node: usize) -> bool {
        let item = self.item(node);
        let place = |place: &Place, of: fn(&Self, Serial) -> Option<Point2>| {
            [place.x, place.y, place.radius, place.angle].iter().flatten().all(|given| match given.from {
                Base::Element(serial) => of(self, serial).is_some(),
                Base::Zero | Base::Start => true,
            })
        };
        let angle = match item.angle {
            Some(Given { from: Base::Element(serial), .. }) => self.exit_of(serial).is_some(),
            Some(Given { from: Base::Start, .. }) => self.before(node).is_some(),
            _ => true,
        };
        let parallel = item.parallel.is_none_or(|(of, _)| self.exit_of(of).is_some() && self.point_of(of).is_some());
        let closes = item.closes.is_none_or(|of| self.start_of(of).is_some());
        place(&item.end, Self::end_of) && place(&item.center, Self::center_of) && angle && parallel && closes
    }

    /// The direction that the angle of the element says.
    pub fn written_direction(&self, node: usize) -> Option<Vec2> {
        let given = self.item(node).angle?;
        let from = match given.from {
            Base::Zero => Vec2::x(),
            Base::Start => self.before(node)?,
            Base::Element(serial) => self.exit_of(serial)?,
        };
        Some(spun(from, given.value))
    }

    /// What its own coordinates say of its end.
    pub fn written_end(&self, node: usize) -> Known {
        self.known(node, &self.item(node).end, Self::end_of)
    }

    pub fn known_end(&self, node: usize) -> Known {
        let item = self.item(node);
        let mut known = self.written_end(node);
        if let Some(at) = item.closes.and_then(|serial| self.start_of(serial)) {
            (known.x, known.y) = (Some(at.x), Some(at.y));
        }
        known
    }

    pub fn known_center(&self, node: usize) -> Known {
        self.known(node, &self.item(node).center, Self::center_of)
    }

    fn known(&self, node: usize, place: &Place, of: fn(&Self, Serial) -> Option<Point2>) -> Known {
        let pole = self.item(node).pole;
        let value = |given: Option<Given>, measure: fn(Point2, Point2) -> Option<f64>| {
            let given = given?;
            let base = match given.from {
                Base::Zero => return Some(given.value),
                Base::Start => self.start(node)?,
                Base::Element(serial) => of(self, serial)?,
            };
            Some(measure(base, pole)? + given.value)
        };
        let ray = value(place.angle, |at, pole| direction(at - pole, ONE).map(|u| Deg::of(u).0));
        Known {
            x: value(place.x, |at, _| Some(at.x)),
            y: value(place.y, |at, _| Some(at.y)),
            radius: value(place.radius, |at, pole| Some(distance(at, pole))),
            ray: ray.map(|angle| Deg(angle).unit()),
        }
    }
}

/// `v` turned counter-clockwise by degrees, exact where a drawing expects it.
pub(super) fn spun(v: Vec2, degrees: f64) -> Vec2 {
    let turn = Deg(degrees).unit();
    Vec2::new(v.x * turn.x - v.y * turn.y, v.x * turn.y + v.y * turn.x)
}
