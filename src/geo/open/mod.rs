//! Contour elements of which something is not known: every element that fits what is known of it, of its start and of
//! the elements that follow.
//!
//! In: numbers, and how exact they are. Out: solutions, each tagged with the choices that lead to it; which one is meant
//! is for the language that wrote the element. Angles are directions here, increments count from the start.
//!
//! [`solve`] completes an element from up to two others behind it, by the rules of a language that writes most of each
//! element. Contours of which every element may be open, in any number, are a [`window`]: there data of any kind counts
//! for any unknown, forwards and backwards.

mod arcs;
mod lines;
#[cfg(test)]
mod tests;
pub mod window;

use super::{Element, Point2, SAME_POINT, Vec2, arc, direction, distance, turned};

/// A coordinate of an end point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Coord {
    /// As it is, unless a direction says where it goes.
    #[default]
    Stay,
    /// Follows from something else.
    Open,
    At(f64),
    /// From the start.
    By(f64),
}

/// The direction in which an element begins; that of a line holds for all of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Entry {
    /// A unit vector; a line runs along it.
    Along(Vec2),
    /// A unit vector; a line runs along it or the other way.
    Parallel(Vec2),
    /// By this angle from the direction in which the element before ends, in rad.
    Turned(f64),
}

/// The centre of an arc.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Center {
    pub x: Option<f64>,
    pub y: Option<f64>,
    /// Counts from the zero point, not from the start of the arc.
    pub absolute: bool,
}

/// What is known of an element.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Data {
    /// Counter-clockwise; `None` for a line.
    pub arc: Option<bool>,
    pub x: Coord,
    pub y: Coord,
    pub entry: Option<Entry>,
    /// Direction of an arc at its end.
    pub exit: Option<Vec2>,
    /// Opening angle of an arc in rad.
    pub sweep: Option<f64>,
    /// Negative for an arc of more than half a turn.
    pub radius: Option<f64>,
    pub center: Center,
    /// Goes over into the next element without a corner, where that is not known otherwise.
    pub smooth: bool,
    /// How far the radii at both ends of an arc may differ, in mm.
    pub tolerance: f64,
}

/// Where an element starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    pub at: Point2,
    /// Direction in which the element before ends.
    pub dir: Option<Vec2>,
    /// The element goes on in it where nothing else is known.
    pub goes_on: bool,
}

/// How exact the numbers are, in mm, and what a language takes data to say.
#[derive(Debug, Clone, Copy)]
pub struct Rules {
    /// How far data that says the same twice may disagree; without a limit where the language compares afterwards.
    pub agrees: f64,
    /// By how much a line may miss a circle and still touch it.
    pub touch: f64,
    /// The same where the two go over into each other.
    pub smooth_touch: f64,
    /// By how much a circle of this radius may miss a coordinate and still reach it.
    pub reach: fn(f64) -> f64,
    /// By how much the ends of an arc may lie further apart than twice its radius; `None`: its own tolerance.
    pub chord: Option<f64>,
    /// One coordinate of a centre beside a radius is enough, and so is one of a line in front of a circle or along an
    /// axis: the program says which of two solutions it means.
    pub one_coordinate: bool,
    /// An arc whose end is open goes over into a line of known direction without a corner, and into nothing else.
    pub leaves_along: bool,
}

/// What there is to choose from; the first and the second solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Situation {
    /// Where a line meets a circle: in its order of travel.
    LineAndCircle,
    /// Where a line that ends at this first coordinate meets the circle of the next arc: the smaller other one first.
    LineToX,
    /// The same for the second coordinate.
    LineToY,
    /// The end of an arc with this first coordinate: the greater second one first.
    EndAtX,
    /// The end of an arc with this second coordinate: the greater first one first.
    EndAtY,
    /// Where two circles meet: the first left of the way between their centres.
    TwoCircles,
    /// Along a direction, or against it.
    EitherWay,
    /// The centre by its radius, one coordinate and the end of the arc: the greater other coordinate first.
    CenterByEnd,
    /// The same of the next arc.
    NextCenterByEnd,
    /// The centre by its radius, one coordinate and the start of the arc: the greater other coordinate first.
    CenterByStart,
    /// An arc by its radius: the shorter one is the first. Its sign says which, so that one is made.
    ShorterArc,
}

/// A choice that leads to a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tag {
    pub situation: Situation,
    pub second: bool,
    /// How far the two lie apart, in mm.
    pub apart: f64,
}

/// A complete element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved {
    pub from: Point2,
    pub to: Point2,
    /// Centre and counter-clockwise.
    pub arc: Option<(Point2, bool)>,
}

/// An element that fits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    pub solved: Solved,
    pub tags: [Option<Tag>; 2],
}

/// The elements that fit; at least one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solutions {
    first: Solution,
    others: [Option<Solution>; 3],
}

/// Why there is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// Data is missing.
    Open(&'static str),
    /// No such geometry exists.
    Impossible(&'static str),
    /// Data disagrees.
    Contradiction(&'static str),
}

/// A line that runs beside the next one and has no corner with it.
pub const PARALLEL: Fault = Fault::Impossible("it is parallel to the next line");
/// The radius is not the distance of the centre from the start.
pub const RADIUS_DIFFERS: Fault = Fault::Contradiction("its radius is not the distance of its centre from its start");
/// A radius and one coordinate of the centre.
pub const TOO_MUCH: Fault = Fault::Contradiction("its radius and a coordinate of its centre cannot stand together");
/// A line along an axis, and another value of the coordinate across.
pub const NEVER: Fault = Fault::Impossible("a line at this angle never reaches the coordinate");
/// The next element leaves the end open.
pub const NOT_FIXED: Fault = Fault::Open("its end is not given, and the next element does not fix it");

type Result<T> = core::result::Result<T, Fault>;

/// Everything that `e` can be.
///
/// # Errors
/// See [`Fault`].
pub fn solve(start: &Start, e: &Data, following: [Option<&Data>; 2], rules: &Rules) -> Result<Solutions> {
    match e.arc {
        None => lines::solve(start, e, following, rules),
        Some(ccw) => arcs::solve(start, e, ccw, following[0], rules),
    }
}

impl Coord {
    pub fn given(self, from: f64) -> Option<f64> {
        match self {
            Coord::At(v) => Some(v),
            Coord::By(d) => Some(from + d),
            Coord::Stay | Coord::Open => None,
        }
    }

    fn or_stay(self, from: f64) -> Option<f64> {
        if self == Coord::Stay { Some(from) } else { self.given(from) }
    }

    fn absolute(self) -> Option<f64> {
        if let Coord::At(v) = self { Some(v) } else { None }
    }
}

impl Solved {
    pub fn line(from: Point2, to: Point2) -> Solved {
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

    fn direction_at(&self, at: Point2) -> Option<Vec2> {
        match self.arc {
            None => direction(self.to - self.from, SAME_POINT),
            Some((center, ccw)) => arc::tangent_at(at, center, ccw),
        }
    }

    /// Direction of travel at the start; `None` for an element of no length.
    pub fn start_direction(&self) -> Option<Vec2> {
        self.direction_at(self.from)
    }

    /// Direction of travel at the end; `None` for an element of no length.
    pub fn end_direction(&self) -> Option<Vec2> {
        self.direction_at(self.to)
    }
}

impl Solutions {
    fn one(solved: Solved) -> Solutions {
        Solutions { first: Solution { solved, tags: [None; 2] }, others: [None; 3] }
    }

    /// Of solutions in the order of their tags; up to four.
    fn of(mut list: impl Iterator<Item = Solution>) -> Option<Solutions> {
        Some(Solutions { first: list.next()?, others: [list.next(), list.next(), list.next()] })
    }

    pub fn iter(&self) -> impl Iterator<Item = &Solution> {
        std::iter::once(&self.first).chain(self.others.iter().flatten())
    }

    /// The only one.
    pub fn single(&self) -> Option<Solution> {
        self.others[0].is_none().then_some(self.first)
    }
}

/// Both solutions of a situation.
fn both(situation: Situation, points: [Point2; 2]) -> [(Point2, Option<Tag>); 2] {
    let apart = distance(points[0], points[1]);
    [false, true].map(|second| (points[usize::from(second)], Some(Tag { situation, second, apart })))
}

impl Data {
    /// The direction in which it begins.
    fn along(&self, before: Option<Vec2>) -> Option<Vec2> {
        match self.entry? {
            Entry::Along(u) | Entry::Parallel(u) => Some(u),
            Entry::Turned(0.0) => before,
            Entry::Turned(angle) => before.map(|dir| turned(dir, angle)),
        }
    }

    fn absolute_end(&self) -> Option<Point2> {
        self.x.absolute().zip(self.y.absolute()).map(|(x, y)| Point2::new(x, y))
    }

    /// A line that is known without its start: a point of it and its direction. `near` may be any point, and `before` is
    /// the direction in which the element before it ends.
    fn fixed_line(&self, near: Point2, before: Option<Vec2>) -> Option<(Point2, Vec2)> {
        if self.arc.is_some() {
            return None;
        }
        let w = self.along(before)?;
        let through = match (self.x, self.y) {
            (Coord::At(x), Coord::At(y)) => Point2::new(x, y),
            _ if matches!(self.entry, Some(Entry::Parallel(_))) => return None,
            // The known coordinate of a line along the other axis.
            (Coord::At(x), _) if w.x.abs() <= FLAT => Point2::new(x, near.y),
            (_, Coord::At(y)) if w.y.abs() <= FLAT => Point2::new(near.x, y),
            // Its own way and its angle say how far it rises to its end, so where it starts.
            (Coord::By(d), Coord::At(y)) if w.x * d > FLAT && before.is_none_or(|u| u.y.abs() > FLAT) => {
                return Some((Point2::new(near.x, y - d * w.y / w.x), Vec2::x()));
            }
            _ => return None,
        };
        Some((through, w))
    }

    /// Centres and radius of an arc that are known without its start.
    fn fixed_circles(&self, rules: &Rules) -> Option<(Centers, f64)> {
        self.arc?;
        let center = Some(self.center).filter(|center| center.absolute)?;
        let end = self.absolute_end();
        if let (Some(x), Some(y)) = (center.x, center.y) {
            let center = Point2::new(x, y);
            let radius = self.radius.map(f64::abs).or(end.map(|end| distance(center, end)))?;
            return Some(([(center, None); 2], radius));
        }
        let end = end.filter(|_| rules.one_coordinate)?;
        let centers = arcs::beside(end, center.x, center.y, self.radius?, rules)?;
        Some((both(Situation::NextCenterByEnd, centers), self.radius?.abs()))
    }

    /// Centre and radius of an arc that are known without its start, where there is one only.
    fn fixed_circle(&self, rules: &Rules) -> Option<(Point2, f64)> {
        let ([(center, tag), _], radius) = self.fixed_circles(rules)?;
        tag.is_none().then_some((center, radius))
    }
}

/// Two centres, each with the situation that it comes from; the same twice where there is one only.
type Centers = [(Point2, Option<Tag>); 2];

/// Directions whose part across is less run along an axis.
const FLAT: f64 = 1e-9;
