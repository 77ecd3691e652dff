//! Path elements with missing data: each is completed from its start, its own words and up to two elements behind it.
//!
//! Points are (Z, X) with X as a radius. A line stands at `angle` to the negative Z axis: it leaves its start along
//! (-cos A, sin A) or the other way. Source: reference sections 5 and 6.2, "Solving unknowns".

mod arcs;
mod lines;

use crate::geo::{Deg, Element, Point2, SAME_POINT, Vec2, arc, direction, distance};

/// How far data that says the same twice may disagree, in mm: drawings round to 0.01 and less.
pub(super) const AGREES: f64 = 0.02;
/// Elements that may wait for each other.
const MOST: usize = 3;

/// A coordinate as programmed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Coord {
    /// Not written: stays as it is, unless an angle says where it goes.
    #[default]
    Missing,
    /// `?`
    Unknown,
    At(f64),
    By(f64),
}

impl Coord {
    fn given(self, from: f64) -> Option<f64> {
        match self {
            Coord::At(v) => Some(v),
            Coord::By(d) => Some(from + d),
            Coord::Missing | Coord::Unknown => None,
        }
    }

    fn or_stay(self, from: f64) -> Option<f64> {
        if self == Coord::Missing { Some(from) } else { self.given(from) }
    }

    fn absolute(self) -> Option<f64> {
        if let Coord::At(v) = self { Some(v) } else { None }
    }
}

/// Centre of an arc as programmed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Center {
    pub z: Option<f64>,
    pub x: Option<f64>,
    /// Counts from the workpiece zero, not from the start of the arc.
    pub absolute: bool,
}

/// An element as programmed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Partial {
    /// Counter-clockwise; `None` for a line.
    pub arc: Option<bool>,
    pub z: Coord,
    pub x: Coord,
    pub angle: Option<f64>,
    pub radius: Option<f64>,
    pub center: Center,
    /// The solution that lies further from the start.
    pub far: bool,
    /// Goes over into the next element without a corner, where that is not known otherwise.
    pub tangential: bool,
    /// How far the radii at both ends of an arc may differ, in mm.
    pub tolerance: f64,
}

impl Default for Partial {
    fn default() -> Partial {
        Partial {
            arc: None,
            z: Coord::default(),
            x: Coord::default(),
            angle: None,
            radius: None,
            center: Center::default(),
            far: false,
            tangential: false,
            tolerance: AGREES,
        }
    }
}

/// A complete element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Solved {
    pub from: Point2,
    pub to: Point2,
    /// Centre and counter-clockwise.
    pub arc: Option<(Point2, bool)>,
}

impl Solved {
    fn line(from: Point2, to: Point2) -> Solved {
        Solved { from, to, arc: None }
    }

    pub fn element(&self) -> Element {
        let (from, to) = (self.from, self.to);
        match self.arc {
            None => Element::Line { from, to },
            Some((center, ccw)) => Element::Arc { from, to, center, sweep: self.sweep(center, ccw) },
        }
    }

    fn sweep(&self, center: Point2, ccw: bool) -> f64 {
        if distance(self.from, self.to) <= SAME_POINT {
            return if ccw { core::f64::consts::TAU } else { -core::f64::consts::TAU };
        }
        arc::sweep(self.from, self.to, center, ccw)
    }

    /// Direction of travel at the end; `None` for an element of no length.
    pub fn end_direction(&self) -> Option<Vec2> {
        match self.arc {
            None => direction(self.to - self.from, SAME_POINT),
            Some((center, ccw)) => arc::tangent_at(self.to, center, ccw),
        }
    }
}

/// Why an element cannot be completed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Fault {
    /// Data is missing.
    Open(&'static str),
    /// No such geometry exists.
    Impossible(&'static str),
    /// Data disagrees.
    Contradiction(&'static str),
}

type Result<T> = core::result::Result<T, Fault>;

/// Elements that wait for each other, each with what else is known of its block.
#[derive(Debug)]
pub(super) struct Chain<T> {
    queue: Vec<(Partial, T)>,
}

impl<T> Default for Chain<T> {
    fn default() -> Chain<T> {
        Chain { queue: Vec::new() }
    }
}

impl<T> Chain<T> {
    pub fn is_empty(&self) -> bool {
        self.queue.is_empty()
    }

    pub fn clear(&mut self) {
        self.queue.clear();
    }

    pub fn push(&mut self, partial: Partial, tag: T) {
        self.queue.push((partial, tag));
    }

    /// The first element, if it can be completed by now. It starts in `at`; `dir` is the direction to continue in,
    /// if there is one. `closed`: nothing more will come.
    ///
    /// # Errors
    /// The fault, and the element it is about.
    pub fn next(
        &mut self,
        at: Point2,
        dir: Option<Vec2>,
        closed: bool,
    ) -> core::result::Result<Option<(Solved, T)>, (Fault, T)> {
        let Some((first, _)) = self.queue.first() else { return Ok(None) };
        let second = self.queue.get(1).map(|(partial, _)| partial);
        let third = self.queue.get(2).map(|(partial, _)| partial);
        let result = solve(first, second, third, at, dir);
        if let Err(Fault::Open(_)) = result
            && !closed
            && self.queue.len() < MOST
        {
            return Ok(None);
        }
        let (_, tag) = self.queue.remove(0);
        match result {
            Ok(solved) => Ok(Some((solved, tag))),
            Err(fault) => Err((fault, tag)),
        }
    }
}

/// Completes `e` from its start and the elements behind it.
fn solve(
    e: &Partial,
    second: Option<&Partial>,
    third: Option<&Partial>,
    at: Point2,
    dir: Option<Vec2>,
) -> Result<Solved> {
    match e.arc {
        None => lines::solve(e, second, third, at, dir),
        Some(ccw) => arcs::solve(e, second, ccw, at, dir),
    }
}

/// Direction of a line at `angle` to the negative Z axis.
fn leaning(angle: f64) -> Vec2 {
    let (sin, cos) = Deg(angle).sin_cos();
    Vec2::new(-cos, sin)
}

/// Of two solutions the one nearer to `from`, or the further one.
fn chosen(points: [Point2; 2], from: Point2, far: bool) -> Result<Point2> {
    let [a, b] = points;
    // The start itself is no solution.
    match (distance(a, from) <= SAME_POINT, distance(b, from) <= SAME_POINT) {
        (true, true) => Err(Fault::Impossible("it ends where it starts")),
        (true, false) => Ok(b),
        (false, true) => Ok(a),
        (false, false) => {
            let (near, other) = (distance(a, from), distance(b, from));
            if (near - other).abs() <= SAME_POINT && distance(a, b) > AGREES {
                return Err(Fault::Open("two solutions lie equally far from its start, so Q tells nothing"));
            }
            Ok(if (near <= other) == far { b } else { a })
        }
    }
}

/// A line that is known without its start: through its end at its angle.
fn backward_line(e: &Partial) -> Option<(Point2, Vec2)> {
    let end = Point2::new(e.z.absolute()?, e.x.absolute()?);
    (e.arc.is_none()).then_some(())?;
    Some((end, leaning(e.angle?)))
}

/// Centre and radius of an arc that are known without its start.
fn fixed_circle(e: &Partial) -> Option<(Point2, f64)> {
    e.arc?;
    let center = Some(e.center).filter(|c| c.absolute)?;
    let center = Point2::new(center.z?, center.x?);
    let radius = match (e.radius, e.z.absolute(), e.x.absolute()) {
        (Some(radius), _, _) => radius.abs(),
        (None, Some(z), Some(x)) => distance(center, Point2::new(z, x)),
        _ => return None,
    };
    Some((center, radius))
}

#[cfg(test)]
mod tests;
