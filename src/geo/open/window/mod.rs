//! Contour elements that can only be solved together: lines and arcs with any data that fixes them, in the smallest window
//! that balances.
//!
//! In: elements in their order, each with what is known of it ([`Item`]). Out: elements that are the same in every
//! solution that is left ([`Window::settle`]), or why there is none or more than one ([`Window::close`]).
//!
//! Known are points (the joints of the elements), directions, and carriers: the line or circle that an element lies on.
//! Each rule makes one of them from others, in closed form, with all its solutions; where there are several, the state
//! of the window branches, and a branch dies where data contradicts it. A carrier is *oriented*: a circle has the radius
//! ρ, positive counter-clockwise, a line is a circle of no curvature. Two of them touch in the direction of travel where
//! `left(u)·C − left(u)·P = ρ` (line and circle) or `|C1 − C2| = |ρ1 − ρ2|` (two circles); a point is a circle of radius 0.

mod carriers;
mod check;
mod choice;
mod count;
mod directions;
mod joints;
mod state;
#[cfg(test)]
mod tests;

use crate::geo::tolerance;
use std::collections::VecDeque;

use super::Solved;
use crate::geo::{Point2, Vec2, distance};

use state::{Fact, State, View};

/// How far data may disagree, in mm.
const AGREES: f64 = 0.001;
/// The same for directions, in rad: 0.001°.
const AGREES_TURN: f64 = 1.75e-5;
/// Solutions that lie closer together are one, in mm.
const ONE: f64 = tolerance::SAME;
/// Branches that are kept at most.
pub const MOST_STATES: usize = 64;
/// Elements that may wait at most.
pub const MOST_ITEMS: usize = 64;
/// Elements that data may refer back to.
pub const MOST_BACK: usize = 64;

/// Number of an element, counted over the whole contour.
pub type Serial = usize;

/// What a value counts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    /// The zero point, the pole or the first axis.
    Zero,
    /// The start of the element; the direction in which the one before ends.
    Start,
    /// The end of another element, or its direction there; for a centre the centre of an arc.
    Element(Serial),
}

/// A value and what it counts from; mm or degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Given {
    pub value: f64,
    pub from: Base,
}

/// What is known of a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Place {
    pub x: Option<Given>,
    pub y: Option<Given>,
    /// About the pole.
    pub radius: Option<Given>,
    pub angle: Option<Given>,
}

/// What the element is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Shape {
    #[default]
    Line,
    /// Counter-clockwise, if that is known.
    Arc(Option<bool>),
}

/// The angle of an arc at its end, in degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EndAngle {
    /// Of the radius to the end, from the first axis.
    At(f64),
    /// Between the radii to start and end; not negative.
    Swept(f64),
}

/// What is known of an element.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Item {
    pub shape: Shape,
    /// Begins in the direction in which the element before ends.
    pub smooth: bool,
    pub end: Place,
    pub center: Place,
    /// What polar values count from.
    pub pole: Point2,
    /// Of a line; of an arc at its start.
    pub angle: Option<Given>,
    /// From the start to the end.
    pub length: Option<f64>,
    /// Above zero.
    pub radius: Option<f64>,
    pub end_angle: Option<EndAngle>,
    /// Points of the line or circle, also beyond the ends of the element.
    pub through: [Option<Point2>; 3],
    /// A point at this distance from the line or circle.
    pub beside: Option<(Point2, f64)>,
    /// Runs along the end of another element or the other way, at this distance from it.
    pub parallel: Option<(Serial, Option<f64>)>,
    /// Ends where this element starts.
    pub closes: Option<Serial>,
    /// The solution that the program asks for.
    pub select: Option<u32>,
}

/// A complete element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settled {
    pub serial: Serial,
    pub solved: Solved,
    /// Directions of travel at its ends.
    entry: Vec2,
    exit: Vec2,
}

/// Why the contour has no solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// So many data are missing from this element on; none for a contour that balances and that no rule constructs.
    Open { serial: Serial, missing: usize },
    /// No such element exists; by how much data is missed.
    Impossible { serial: Serial, why: &'static str, miss: Option<f64> },
    /// There are more solutions than are kept, or more elements wait for each other.
    TooMany { serial: Serial },
}

/// What is left at the end.
#[derive(Debug, Clone, PartialEq)]
pub enum Closed {
    /// One solution; the elements for which the choice of the program was taken as it was observed at controls.
    One { observed: Vec<Serial> },
    /// Several: the first element in which they differ, and how.
    Several { serial: Serial, candidates: Vec<Solved> },
}

/// A contour under way.
#[derive(Debug, Clone)]
pub struct Window {
    at: Point2,
    /// Direction in which the element before the contour ends.
    before: Option<Vec2>,
    items: VecDeque<Item>,
    /// Number of the first item.
    first: Serial,
    states: Vec<State>,
    settled: VecDeque<Settled>,
    observed: Vec<Serial>,
}

impl Window {
    pub fn new(at: Point2, before: Option<Vec2>) -> Window {
        Window {
            at,
            before,
            items: VecDeque::new(),
            first: 0,
            states: vec![State::default()],
            settled: VecDeque::new(),
            observed: Vec::new(),
        }
    }

    /// The contour goes on from another place; what was settled can still be referred to.
    pub fn restart(&mut self, at: Point2, before: Option<Vec2>) {
        (self.at, self.before) = (at, before);
        self.first += self.items.len();
        self.items.clear();
        self.states = vec![State::default()];
        self.observed.clear();
    }

    /// The number of the next element.
    pub fn next_serial(&self) -> Serial {
        self.first + self.items.len()
    }

    /// Can data refer to this element?
    pub fn knows(&self, serial: Serial) -> bool {
        serial >= self.first && serial < self.next_serial() || self.settled.iter().any(|old| old.serial == serial)
    }

    /// Is this element an arc?
    pub fn is_arc(&self, serial: Serial) -> bool {
        match serial.checked_sub(self.first).and_then(|at| self.items.get(at)) {
            Some(item) => item.shape != Shape::Line,
            None => self.settled.iter().any(|old| old.serial == serial && old.solved.arc.is_some()),
        }
    }

    /// The next element.
    ///
    /// # Errors
    /// See [`Fault`].
    pub fn push(&mut self, item: Item) -> Result<(), Fault> {
        if self.items.len() == MOST_ITEMS {
            return Err(Fault::TooMany { serial: self.first });
        }
        self.items.push_back(item);
        for state in &mut self.states {
            state.add(match item.shape {
                Shape::Line => true,
                Shape::Arc(ccw) => ccw.unwrap_or(true),
            });
        }
        if item.shape == Shape::Arc(None) {
            let mut others = self.states.clone();
            others.iter_mut().for_each(State::turn_last);
            self.states.append(&mut others);
        }
        self.go_on()
    }

    /// The program asks for this solution of the last element. Without effect where that is settled.
    pub fn select(&mut self, solution: u32) {
        if let Some(item) = self.items.back_mut() {
            item.select = Some(solution);
        }
    }

    /// Applies all rules to all states.
    fn go_on(&mut self) -> Result<(), Fault> {
        let mut open = std::mem::take(&mut self.states);
        open.reverse();
        let mut fault: Option<Fault> = None;
        let mut made = 0;
        while let Some(mut state) = open.pop() {
            made += 1;
            match self.propagate(&mut state) {
                Ok(None) => self.keep(state),
                Ok(Some((node, facts))) => {
                    for fact in facts.into_iter().rev() {
                        let mut branch = state.clone();
                        branch.set(node, fact);
                        open.push(branch);
                    }
                }
                // What went furthest says most.
                Err(why) => fault = Some(fault.filter(|old| old.serial() >= why.serial()).unwrap_or(why)),
            }
            if self.states.len() + open.len() > MOST_STATES {
                // The choices of the program thin them out, where there are any.
                self.states.append(&mut open);
                self.choose_first();
                if self.states.len() > MOST_STATES / 2 {
                    return Err(Fault::TooMany { serial: self.first });
                }
                open = std::mem::take(&mut self.states);
                open.reverse();
            }
            if made > 16 * MOST_STATES {
                return Err(Fault::TooMany { serial: self.first });
            }
        }
        match (self.states.is_empty(), fault) {
            (true, Some(fault)) => Err(fault),
            (true, None) => Err(Fault::TooMany { serial: self.first }),
            (false, _) => Ok(()),
        }
    }

    /// Keeps a state unless it is known already.
    fn keep(&mut self, state: State) {
        if !self.states.iter().any(|old| old.is_same(&state)) {
            self.states.push(state);
        }
    }

    /// Applies the rules that have one result, until none is left; then the first that has several, if there is one.
    fn propagate(&self, state: &mut State) -> Result<Option<(usize, Vec<Fact>)>, Fault> {
        loop {
            let (mut moved, mut branch) = (false, None);
            for node in state.first_open()..self.items.len() {
                for rule in RULES {
                    let view = View { window: self, state };
                    let facts = rule(&view, node).map_err(|(why, miss)| {
                        let serial = self.first + node;
                        Fault::Impossible { serial, why, miss }
                    })?;
                    match facts.len() {
                        0 => {}
                        1 => {
                            state.set(node, facts[0]);
                            moved = true;
                        }
                        _ if branch.is_none() => branch = Some((node, facts)),
                        _ => {}
                    }
                }
            }
            if !moved {
                return Ok(branch);
            }
        }
    }

    /// The first element, if it is complete and the same in all that is left.
    pub fn settle(&mut self) -> Option<Settled> {
        let first = self.settled_node(0)?;
        for state in &mut self.states {
            state.pop();
        }
        self.items.pop_front();
        self.first += 1;
        (self.at, self.before) = (first.solved.to, Some(first.exit));
        if self.settled.len() == MOST_BACK {
            self.settled.pop_front();
        }
        self.settled.push_back(first);
        Some(first)
    }

    /// The first elements that [`Window::settle`] gives.
    pub fn ready(&self) -> usize {
        (0..self.items.len()).take_while(|node| self.settled_node(*node).is_some()).count()
    }

    fn settled_node(&self, node: usize) -> Option<Settled> {
        self.lacks(node).is_none().then_some(())?;
        let first = self.complete(self.states.first()?, node)?;
        let same = |state: &State| self.complete(state, node).is_some_and(|other| is_one(&first.solved, &other.solved));
        self.states.iter().all(same).then_some(first)
    }

    /// How many data the elements up to this one and any behind it lack by their number. Whatever the rules make of data
    /// that depends on each other, fewer data than unknowns determine nothing.
    fn lacks(&self, node: usize) -> Option<usize> {
        let (mut unknowns, mut equations, mut least) = (0, 0, usize::MAX);
        for (at, item) in self.items.iter().enumerate() {
            unknowns += item.unknowns();
            equations += item.equations();
            if at >= node {
                least = least.min(unknowns.saturating_sub(equations));
            }
        }
        Some(least).filter(|least| *least > 0)
    }

    fn complete(&self, state: &State, node: usize) -> Option<Settled> {
        state.is_complete(node).then_some(())?;
        let view = View { window: self, state };
        let of = view.node(node);
        let arc = of.center.map(|center| (center, of.ccw));
        let solved = Solved { from: view.start(node)?, to: of.end?, arc };
        Some(Settled { serial: self.first + node, solved, entry: of.entry?, exit: of.exit? })
    }

    /// Where this element ends if its angle is read in another way; `None` where nothing fits then.
    pub fn read_otherwise(&self, serial: Serial, angle: EndAngle) -> Option<Point2> {
        let mut other = Window { items: VecDeque::new(), states: vec![State::default()], ..self.clone() };
        for item in &self.items {
            let end_angle = if other.next_serial() == serial { Some(angle) } else { item.end_angle };
            other.push(Item { end_angle, ..*item }).ok()?;
        }
        let node = serial.checked_sub(self.first)?;
        other.states.iter().find_map(|state| other.complete(state, node)).map(|found| found.solved.to)
    }

    /// Every end that this element can have, as far as it is known.
    pub fn ends_of(&self, serial: Serial) -> Vec<Point2> {
        let Some(node) = serial.checked_sub(self.first) else { return Vec::new() };
        self.states.iter().filter_map(|state| state.nodes.get(node)?.end).collect()
    }

    /// Nothing more follows. `observed`: where several solutions are left, the choice of the program counts as it was observed.
    ///
    /// # Errors
    /// See [`Fault`].
    pub fn close(&mut self, observed: bool) -> Result<Closed, Fault> {
        if let Some(state) = self.states.iter().min_by_key(|state| state.first_open())
            && state.first_open() < self.items.len()
        {
            let open = state.first_open();
            let missing = count::missing(&View { window: self, state }, open);
            return Err(Fault::Open { serial: self.first + open, missing });
        }
        if let Some(missing) = self.items.len().checked_sub(1).and_then(|last| self.lacks(last)) {
            return Err(Fault::Open { serial: self.first, missing });
        }
        while observed && self.states.len() > 1 && self.choose_first() {}
        if self.ready() == self.items.len() {
            return Ok(Closed::One { observed: std::mem::take(&mut self.observed) });
        }
        let node = self.ready();
        let mut candidates: Vec<Solved> = Vec::new();
        for found in self.states.iter().filter_map(|state| self.complete(state, node)) {
            if !candidates.iter().any(|old| is_one(old, &found.solved)) {
                candidates.push(found.solved);
            }
        }
        Ok(Closed::Several { serial: self.first + node, candidates })
    }
}

/// Makes facts of a node from what is known; several where it has several solutions.
///
/// An error says that no such element exists.
type Rule = fn(&View<'_>, usize) -> Made;
/// Facts, or why there is none and by how much data is missed.
type Made = Result<Vec<Fact>, (&'static str, Option<f64>)>;

const RULES: [Rule; 6] =
    [joints::end, directions::entry, directions::exit, carriers::radius, carriers::carrier, check::complete];

fn is_one(a: &Solved, b: &Solved) -> bool {
    let near = |a: Point2, b: Point2| distance(a, b) <= ONE;
    near(a.from, b.from)
        && near(a.to, b.to)
        && match (a.arc, b.arc) {
            (Some((a, ccw)), Some((b, other))) => near(a, b) && ccw == other,
            (None, None) => true,
            _ => false,
        }
}

impl Fault {
    /// The element it is about.
    pub fn serial(&self) -> Serial {
        match *self {
            Fault::Open { serial, .. } | Fault::Impossible { serial, .. } | Fault::TooMany { serial } => serial,
        }
    }
}

impl Place {
    fn count(&self) -> usize {
        [self.x, self.y, self.radius, self.angle].iter().flatten().count()
    }
}

impl Item {
    /// Its end, and the centre of an arc without its radius, which follows from the start.
    fn unknowns(&self) -> usize {
        let own = if self.shape == Shape::Line { 2 } else { 3 };
        own - usize::from(self.smooth)
    }

    fn equations(&self) -> usize {
        let one = usize::from;
        self.end.count()
            + self.center.count()
            + one(self.angle.is_some())
            + one(self.length.is_some())
            + one(self.radius.is_some())
            + one(self.end_angle.is_some())
            + self.through.iter().flatten().count()
            + one(self.beside.is_some())
            + self.parallel.map_or(0, |(_, apart)| 1 + one(apart.is_some()))
            + 2 * one(self.closes.is_some())
    }
}
