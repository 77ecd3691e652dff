//! The area that the centre of the cutter may reach, as rings from inside out.

use crate::geo::tolerance;
use crate::geo::{Element, Point2, arc, turned};
use crate::ir::cycle::milling::parts;
use crate::ir::cycle::pocket::{Insertion, Pocket, Room, Shape, Strategy};

/// Widest step between rings, in radii of the cutter: at the corner of a ring a step of 1 + 1/√2 leaves no point.
const WIDEST: f64 = 1.7;
/// Between circles there is no corner.
const WIDEST_ROUND: f64 = 1.95;

/// A closed path, in the sense in which the tool goes round.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    pub elements: Vec<Element>,
    /// Half sizes and corner radius, where it lies about the centre.
    pub half: [f64; 2],
    pub corner: f64,
}

/// How an area is cleared.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// Where the tool is inserted.
    pub entry: Point2,
    /// The innermost ring, where that is a line or an arc; none for a point.
    pub core: Option<Element>,
    /// Along it the tool goes to and fro while it is inserted.
    pub sway: Element,
    /// From inside out. Each begins where a straight line from the one before, or from the end of the core, leads to it.
    pub rings: Vec<Ring>,
}

impl Ring {
    /// Where it begins and ends.
    pub fn start(&self) -> Point2 {
        self.elements.first().map_or_else(Point2::origin, Element::from)
    }
}

impl Area {
    /// The area at `distance` from the wall.
    pub fn new(pocket: &Pocket, distance: f64) -> Area {
        let (width, radius) = (pocket.width, pocket.mill.radius);
        let mut area = match (pocket.shape, pocket.shape.room(distance)) {
            (Shape::Rectangle { corner, .. }, Room::Rectangle(half)) => {
                rectangle(half, (corner - distance).max(0.0), width.min(WIDEST * radius), radius)
            }
            (Shape::Slot { from, to, .. }, Room::Around(half)) => {
                let core = Element::Line { from: Point2::new(from, 0.0), to: Point2::new(to, 0.0) };
                along(core, half, width.min(WIDEST * radius))
            }
            (Shape::Bow { radius: about, sweep, .. }, Room::Around(half)) => {
                let from = Point2::new(about, 0.0);
                let to = Point2::from(turned(from.coords, sweep.radians()));
                let core = Element::Arc { from, to, center: Point2::origin(), sweep: sweep.radians() };
                along(core, half, width.min(WIDEST * radius))
            }
            (_, Room::Around(half)) => {
                // A helix leaves the core that the cutter does not reach.
                let widest = if pocket.strategy == Strategy::Helix { 1.0 } else { WIDEST_ROUND };
                circle(half, width.min(widest * radius))
            }
            (_, Room::Rectangle(half)) => rectangle(half, 0.0, width.min(WIDEST * radius), radius),
        };
        if let Insertion::Ramp { stroke: Some(stroke), .. } = pocket.insertion
            && let Shape::Rectangle { .. } | Shape::Circle { .. } = pocket.shape
        {
            area.sway = shortened(&area.sway, stroke);
        }
        if !pocket.counter_clockwise {
            for ring in &mut area.rings {
                ring.elements = ring.elements.iter().rev().map(reversed).collect();
            }
        }
        area
    }
}

/// A line about the origin, at most `stroke` long.
fn shortened(line: &Element, stroke: f64) -> Element {
    let part = (stroke / line.length().max(tolerance::SAME)).min(1.0);
    Element::Line { from: line.from() * part, to: line.to() * part }
}

/// The element from its end to its start.
pub fn reversed(element: &Element) -> Element {
    match *element {
        Element::Line { from, to } => Element::Line { from: to, to: from },
        Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
    }
}

/// A closed path through `corners`, whose arcs are given by their centres; counter-clockwise.
struct Path {
    at: Point2,
    elements: Vec<Element>,
}

impl Path {
    fn from(at: Point2) -> Path {
        Path { at, elements: Vec::with_capacity(9) }
    }

    fn line(&mut self, to: Point2) {
        if crate::geo::distance(self.at, to) > tolerance::SAME {
            self.elements.push(Element::Line { from: self.at, to });
            self.at = to;
        }
    }

    fn arc(&mut self, to: Point2, center: Point2, ccw: bool) {
        if crate::geo::distance(self.at, center) > tolerance::SAME {
            let sweep = arc::sweep(self.at, to, center, ccw);
            self.elements.push(Element::Arc { from: self.at, to, center, sweep });
            self.at = to;
        }
    }
}

/// Circles about the centre.
fn circle(room: f64, most: f64) -> Area {
    let count = if room > tolerance::SAME { parts(room, most) } else { 0 };
    let ring = |i: usize| {
        let radius = room * i as f64 / count as f64;
        let from = Point2::new(radius, 0.0);
        let elements = vec![Element::Arc { from, to: from, center: Point2::origin(), sweep: core::f64::consts::TAU }];
        Ring { elements, half: [radius; 2], corner: radius }
    };
    let half = room.max(0.0);
    Area {
        entry: Point2::origin(),
        core: None,
        sway: Element::Line { from: Point2::new(-half, 0.0), to: Point2::new(half, 0.0) },
        rings: (1..=count).map(ring).collect(),
    }
}

/// Rectangles about a line on the long axis. They begin where the long axis meets them.
fn rectangle(half: [f64; 2], corner: f64, most: f64, radius: f64) -> Area {
    let upright = half[1] > half[0];
    let (long, short) = (half[0].max(half[1]).max(0.0), half[0].min(half[1]).max(0.0));
    let count = if short > tolerance::SAME { parts(short, most) } else { 0 };
    let step = if count == 0 { 0.0 } else { short / count as f64 };
    let ring = |j: usize| {
        let (x, y) = (long - j as f64 * step, short - j as f64 * step);
        let corner = (corner - j as f64 * step).clamp(0.0, x.min(y));
        let mut path = Path::from(Point2::new(x, 0.0));
        for (p, center, to) in [
            ([x, y - corner], [x - corner, y - corner], [x - corner, y]),
            ([corner - x, y], [corner - x, y - corner], [-x, y - corner]),
            ([-x, corner - y], [corner - x, corner - y], [corner - x, -y]),
            ([x - corner, -y], [x - corner, corner - y], [x, corner - y]),
        ] {
            path.line(p.into());
            path.arc(to.into(), center.into(), true);
        }
        path.line(Point2::new(x, 0.0));
        let elements = path.elements.iter().map(|element| standing(element, upright)).collect();
        Ring { elements, half: if upright { [y, x] } else { [x, y] }, corner }
    };
    let q = long - short;
    let line = |q: f64| standing(&Element::Line { from: Point2::new(-q, 0.0), to: Point2::new(q, 0.0) }, upright);
    Area {
        entry: Point2::origin(),
        core: (q > tolerance::SAME).then(|| line(q)),
        sway: line(if q > radius / 2.0 { q } else { (radius / 2.0).min(long) }),
        rings: (0..count).rev().map(ring).collect(),
    }
}

/// A quarter turn where the long axis is the second one.
fn standing(element: &Element, upright: bool) -> Element {
    if !upright {
        return *element;
    }
    let turn = |p: Point2| Point2::new(-p.y, p.x);
    match *element {
        Element::Line { from, to } => Element::Line { from: turn(from), to: turn(to) },
        Element::Arc { from, to, center, sweep } => {
            Element::Arc { from: turn(from), to: turn(to), center: turn(center), sweep }
        }
    }
}

/// Rings about a middle line, round at its ends. They begin at the tip behind its end.
fn along(core: Element, room: f64, most: f64) -> Area {
    let count = if room > tolerance::SAME { parts(room, most) } else { 0 };
    let ring = |i: usize| Ring { elements: about(&core, room * i as f64 / count as f64), half: [0.0; 2], corner: 0.0 };
    Area { entry: core.from(), core: Some(core), sway: core, rings: (1..=count).map(ring).collect() }
}

/// The closed path at a distance from a middle line.
fn about(core: &Element, distance: f64) -> Vec<Element> {
    let (Some(first), Some(last)) = (core.start_direction(), core.end_direction()) else { return Vec::new() };
    let (from, to) = (core.from(), core.to());
    let left = |p: Point2, u| p + crate::geo::left(u) * distance;
    let right = |p: Point2, u| p - crate::geo::left(u) * distance;
    let tip = to + last * distance;
    let mut path = Path::from(tip);
    path.arc(left(to, last), to, true);
    match *core {
        Element::Line { .. } => path.line(left(from, first)),
        Element::Arc { center, sweep, .. } => path.arc(left(from, first), center, sweep < 0.0),
    }
    path.arc(right(from, first), from, true);
    match *core {
        Element::Line { .. } => path.line(right(to, last)),
        Element::Arc { center, sweep, .. } => path.arc(right(to, last), center, sweep > 0.0),
    }
    path.arc(tip, to, true);
    path.elements
}
