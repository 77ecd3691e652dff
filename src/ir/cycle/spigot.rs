//! Arguments of spigots: a shape that stays, around which the tool goes in closed circuits, level by level.

use core::fmt;

use crate::geo::{Deg, Element, Point2, Vec2, arc};
use crate::ir::{Feed, Pos};
use crate::machine::options::cycles::MultiEdgeStart;

use super::Family;
use super::milling::{Mill, MillFault, Place, parts};

/// Most edges of a spigot.
pub const MOST_EDGES: u32 = 1000;
/// Most circuits of a level; more is a lost decimal point.
const MOST_CIRCUITS: f64 = 10_000.0;
/// Sizes that differ by less are equal, mm.
const SAME: f64 = 1e-9;

/// A spigot. The tool goes down beside it on its first axis. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spigot {
    /// Plane, heights, cutter and feeds.
    pub mill: Mill,
    /// The middle of the spigot, and its own first axis.
    pub place: Place,
    /// The finished outline.
    pub shape: Shape,
    /// Sense in which the tool goes round, seen against the plane normal.
    pub counter_clockwise: bool,
    /// Allowance on the wall that roughing leaves, 0 or more.
    pub allowance: f64,
    /// The stock around the finished outline.
    pub blank: Blank,
    /// Greatest width of a cut, above 0, at most the diameter of the cutter; one circuit without it.
    pub width: Option<f64>,
    /// Roughing goes down to the floor, not only to the allowance on it.
    pub finishes_floor: bool,
    /// The blank is roughed down to the allowances.
    pub rough: bool,
    /// The finishing cuts after roughing; `None` for none.
    pub finish: Option<Finish>,
}

/// What is cut after roughing: the wall first, then the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finish {
    /// The wall is cut, down to what roughing leaves on the floor.
    pub wall: bool,
    /// The floor is cut to its depth, in the circuits of roughing.
    pub floor: bool,
    /// Feed in the plane, above 0.
    pub feed: Feed,
    /// Greatest infeed in depth along the wall, mm; 0 for one cut.
    pub step: f64,
}

/// What stands around the finished outline. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blank {
    /// How far it reaches along the first axis, from the middle of the spigot, 0 or more.
    pub reach: f64,
    /// How far it stands out beyond the outline where that is most; 0 or less for not at all.
    pub stock: f64,
    /// The edge of the cutter goes down so far beside it, 0 or more.
    pub aside: f64,
}

/// How far a rectangular blank stands out in mm beyond a rectangle with round corners where that is most: at its
/// corner, where it reaches `over` mm further along both axes; `corner` is the radius of the rounding.
pub fn stock_at_corner(over: [f64; 2], corner: f64) -> f64 {
    let [x, y] = over;
    if x > -corner && y > -corner { libm::hypot(x + corner, y + corner) - corner } else { x.max(y) }
}

/// The finished outline about its middle. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// By `radius`, above 0.
    Circle { radius: f64 },
    /// Half the sizes along both axes, `half`, above 0, and the radius of the corners, `corner`, 0 to half of the
    /// smaller size.
    Rectangle { half: [f64; 2], corner: f64 },
    /// So many equal `edges`, 3 to [`MOST_EDGES`], at a distance of `apothem` from the middle, above 0; `starts` says
    /// how it is turned.
    Polygon { edges: u32, apothem: f64, starts: Starts },
}

/// What of a polygon lies on the first axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Starts {
    /// The middle of an edge.
    Edge,
    /// A corner.
    Corner,
}

impl From<MultiEdgeStart> for Starts {
    fn from(start: MultiEdgeStart) -> Starts {
        match start {
            MultiEdgeStart::Edge => Starts::Edge,
            MultiEdgeStart::Corner => Starts::Corner,
        }
    }
}

/// Arguments that make no spigot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpigotFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// The allowance or the blank is below 0 or no number.
    Number,
    /// The spigot has no size.
    Size,
    /// The radius of the corners is larger than half of a side.
    Corner,
    /// Less than 3 edges, or more than [`MOST_EDGES`].
    Edges,
    /// The width of a cut is not above 0, or larger than the cutter.
    Width,
    /// A level has more than [`MOST_CIRCUITS`] circuits.
    TooManyCircuits,
}

impl fmt::Display for SpigotFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SpigotFault::Mill(fault) => return fault.fmt(f),
            SpigotFault::Number => "a size, blank or allowance is below 0, or no number",
            SpigotFault::Size => "the spigot has no size",
            SpigotFault::Corner => "the radius of the corners is larger than half of a side",
            SpigotFault::Edges => "a spigot has 3 edges at least, and 1000 at most",
            SpigotFault::Width => "the width of a cut is 0, or larger than the cutter",
            SpigotFault::TooManyCircuits => "the width of a cut is so small that the circuits do not end",
        })
    }
}

impl Shape {
    /// How far it reaches along the first axis, from the middle, mm.
    pub fn reach(&self) -> f64 {
        match *self {
            Shape::Circle { radius } => radius,
            Shape::Rectangle { half, .. } => half[0],
            Shape::Polygon { apothem, starts: Starts::Edge, .. } => apothem,
            Shape::Polygon { edges, apothem, starts: Starts::Corner } => apothem / half_angle(edges).sin_cos().1,
        }
    }

    /// Distance of its nearest side from the middle, mm.
    pub fn least(&self) -> f64 {
        match *self {
            Shape::Circle { radius } => radius,
            Shape::Rectangle { half, .. } => half[0].min(half[1]),
            Shape::Polygon { apothem, .. } => apothem,
        }
    }

    /// The circuit at `distance` mm from the outline, counter-clockwise from the first axis on, in the axes of the
    /// spigot.
    pub fn circuit(&self, distance: f64) -> Vec<Element> {
        match *self {
            Shape::Circle { radius } => {
                let from = Point2::new(radius + distance, 0.0);
                let sweep = core::f64::consts::TAU;
                vec![Element::Arc { from, to: from, center: Point2::origin(), sweep }]
            }
            Shape::Rectangle { half: [x, y], corner } => {
                let normals = [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0), Vec2::new(-1.0, 0.0), Vec2::new(0.0, -1.0)];
                let vertices = [(x, y), (-x, y), (-x, -y), (x, -y)].map(|(x, y)| Point2::new(x, y));
                let round = Round { corner, distance };
                round.edge_first(Point2::new(x + distance, 0.0), &normals, &vertices)
            }
            Shape::Polygon { edges, apothem, starts } => {
                let half = half_angle(edges);
                let unit = |angle: f64| {
                    let (sin, cos) = Deg(angle).sin_cos();
                    Vec2::new(cos, sin)
                };
                let radius = apothem / half.sin_cos().1;
                let turn = 2.0 * half.0;
                let shift = if starts == Starts::Edge { 0.0 } else { half.0 };
                let normals: Vec<Vec2> = (0..edges).map(|i| unit(shift + f64::from(i) * turn)).collect();
                let vertices: Vec<Point2> = (0..edges)
                    .map(|i| Point2::origin() + unit(shift + half.0 + f64::from(i) * turn) * radius)
                    .collect();
                let round = Round { corner: 0.0, distance };
                match starts {
                    Starts::Edge => round.edge_first(Point2::new(apothem + distance, 0.0), &normals, &vertices),
                    Starts::Corner => round.corner_first(&normals, &vertices),
                }
            }
        }
    }
}

/// Half of the angle that an edge takes, seen from the middle.
fn half_angle(edges: u32) -> Deg {
    Deg(180.0 / f64::from(edges))
}

/// A circuit around corners: each gets an arc about it, or about the middle of its rounding.
struct Round {
    corner: f64,
    distance: f64,
}

impl Round {
    /// The arc about the corner `at` from the normal of one edge to that of the next.
    fn arc(&self, at: Point2, normals: [Vec2; 2]) -> Element {
        let [a, b] = normals;
        let center = at - (a + b) * (self.corner / (1.0 + a.dot(&b)));
        let radius = self.corner + self.distance;
        let (from, to) = (center + a * radius, center + b * radius);
        Element::Arc { from, to, center, sweep: arc::sweep(from, to, center, true) }
    }

    /// `vertices[i]` lies between the edges of `normals[i]` and the next one; the start lies on the first edge.
    fn edge_first(&self, start: Point2, normals: &[Vec2], vertices: &[Point2]) -> Vec<Element> {
        let mut elements = Vec::with_capacity(2 * vertices.len() + 1);
        let mut at = start;
        for (i, vertex) in vertices.iter().enumerate() {
            let arc = self.arc(*vertex, [normals[i], normals[(i + 1) % normals.len()]]);
            elements.push(Element::Line { from: at, to: arc.from() });
            at = arc.to();
            elements.push(arc);
        }
        elements.push(Element::Line { from: at, to: start });
        elements
    }

    /// The last vertex lies on the first axis: the circuit starts in the middle of its arc.
    fn corner_first(&self, normals: &[Vec2], vertices: &[Point2]) -> Vec<Element> {
        let count = vertices.len();
        let arcs: Vec<Element> = (0..count)
            .map(|i| self.arc(vertices[(i + count - 1) % count], [normals[(i + count - 1) % count], normals[i]]))
            .collect();
        let Some(first) = arcs.first() else { return Vec::new() };
        let middle = first.middle();
        let mut elements = vec![first.starting_at(middle)];
        let mut at = first.to();
        for arc in arcs.iter().skip(1) {
            elements.push(Element::Line { from: at, to: arc.from() });
            elements.push(*arc);
            at = arc.to();
        }
        elements.push(Element::Line { from: at, to: first.from() });
        elements.push(first.ending_at(middle));
        elements
    }
}

impl Spigot {
    /// Distances of the circuits of the cutter's centre from the finished outline, in mm, from outside in.
    pub fn distances(&self) -> Vec<f64> {
        self.distances_to(self.allowance)
    }

    /// The same, down to this allowance on the wall.
    pub fn distances_to(&self, allowance: f64) -> Vec<f64> {
        let innermost = allowance + self.mill.radius;
        let Some(width) = self.width else { return vec![innermost] };
        let way = self.blank.stock.max(0.0);
        let count = parts(way, width);
        (0..count).rev().map(|j| innermost + way * j as f64 / count as f64).collect()
    }

    /// Where the tool goes down, beside the blank, on the first axis of the spigot.
    pub fn entry(&self) -> Point2 {
        let outermost = self.distances().first().map_or(0.0, |distance| self.shape.reach() + distance);
        let Blank { reach, aside, .. } = self.blank;
        let clear = reach + self.mill.radius + aside;
        let x = if clear > outermost + SAME { clear } else { outermost + 2.0 * aside };
        Point2::new(x, 0.0)
    }

    /// Heights of the levels of roughing, from the first cut to the last.
    pub fn levels(&self) -> Vec<f64> {
        let heights = &self.mill.heights;
        if self.finishes_floor { heights.levels_to(heights.depth, heights.step) } else { heights.levels() }
    }
}

impl Family for Spigot {
    type Fault = SpigotFault;

    fn check(&self) -> Result<(), SpigotFault> {
        self.mill.check().map_err(SpigotFault::Mill)?;
        let unsigned = |v: f64| v >= 0.0 && v.is_finite();
        let positive = |v: f64| v > 0.0 && v.is_finite();
        let Blank { reach, stock, aside } = self.blank;
        if ![self.allowance, reach, aside].into_iter().all(unsigned) || !stock.is_finite() {
            return Err(SpigotFault::Number);
        }
        match self.shape {
            Shape::Circle { radius } if !positive(radius) => return Err(SpigotFault::Size),
            Shape::Rectangle { half, .. } if !half.into_iter().all(positive) => return Err(SpigotFault::Size),
            Shape::Rectangle { half, corner } if !unsigned(corner) || corner > half[0].min(half[1]) + SAME => {
                return Err(SpigotFault::Corner);
            }
            Shape::Polygon { edges, .. } if !(3..=MOST_EDGES).contains(&edges) => return Err(SpigotFault::Edges),
            Shape::Polygon { apothem, .. } if !positive(apothem) => return Err(SpigotFault::Size),
            Shape::Circle { .. } | Shape::Rectangle { .. } | Shape::Polygon { .. } => {}
        }
        match self.width {
            Some(width) if width <= 0.0 || width > 2.0 * self.mill.radius + SAME => Err(SpigotFault::Width),
            Some(width) if stock.max(reach) / width > MOST_CIRCUITS => Err(SpigotFault::TooManyCircuits),
            Some(_) | None => Ok(()),
        }
    }

    fn moves(&self) -> f64 {
        let elements = match self.shape {
            Shape::Circle { .. } => 1.0,
            Shape::Rectangle { .. } => 9.0,
            Shape::Polygon { edges, .. } => 2.0 * f64::from(edges) + 1.0,
        };
        let circuits = self.distances().len() as f64;
        let finishing = self.finish.map_or(0.0, |finish| {
            circuits + self.mill.heights.levels_to(self.mill.heights.depth, finish.step).len() as f64
        });
        (elements + 2.0) * (circuits * self.levels().len() as f64 + finishing)
    }

    /// Above where it went down.
    fn leaves(&self, at: &mut Pos) {
        self.mill.leaves_above(self.place.point(self.entry()), at);
    }
}
