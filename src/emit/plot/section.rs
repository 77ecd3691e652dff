//! The finished part of a turned contour as a half section below the turning centre: edges, and hatching where it is cut through.
//!
//! In: the contours that cycles work down to, or else the compensated ones, as (Z, radius). Nothing is taken from the path of the
//! tool: what a program does not describe is not drawn. What two contours say of the same place is what is left by both.

use crate::geo::element::quarters;
use crate::geo::{Element, Point2, SAME_POINT, cross, direction, distance, turned};
use crate::ir::Side;
use crate::ir::cycle::turning::Towards;

/// Chords of a quarter circle.
const CHORDS: u32 = 8;
/// Contours that are looked at.
const MOST: usize = 64;
/// Points of all of them.
const MOST_POINTS: usize = 2000;
/// Sides that one line may meet; of what is more intricate nothing can be seen.
const MOST_CROSSINGS: usize = 200;
/// Hatch lines over the size of the part.
const LINES: f64 = 60.0;

/// Contours of a turned part.
#[derive(Debug, Default)]
pub(super) struct Parts {
    contours: Vec<Contour>,
    /// The compensated contour that goes on.
    beside: Vec<Element>,
    side: Side,
    along: Vec<Contour>,
}

#[derive(Debug, Clone, PartialEq)]
struct Contour {
    elements: Vec<Element>,
    into: Towards,
}

/// What is drawn, with the radius downwards.
#[derive(Debug, Default)]
pub(super) struct Section {
    pub edges: Vec<Element>,
    pub hatch: Vec<(Point2, Point2)>,
}

impl Parts {
    /// The finished contour of a cycle that cuts it `into` the material.
    pub(super) fn finished(&mut self, elements: Vec<Element>, into: Towards) {
        let contour = Contour { elements, into };
        if self.contours.len() < MOST && !self.contours.iter().any(|known| known.is_like(&contour)) {
            self.contours.push(contour);
        }
    }

    /// An element of a compensated contour.
    pub(super) fn beside(&mut self, element: Element, side: Side) {
        let joins = self.beside.last().is_some_and(|last| distance(last.to(), element.from()) <= SAME_POINT);
        if !joins || side != self.side {
            self.close();
        }
        self.side = side;
        if self.beside.len() < MOST_POINTS {
            self.beside.push(element);
        }
    }

    /// The compensated contour ends here.
    pub(super) fn close(&mut self) {
        let elements = std::mem::take(&mut self.beside);
        let (Some(first), Some(last)) = (elements.first(), elements.last()) else { return };
        let way = last.to().x - first.from().x;
        // The tool is above what it cuts outside and below what it cuts inside.
        let into = if (way < 0.0) == (self.side == Side::Right) { Towards::MinusX } else { Towards::PlusX };
        let contour = Contour { elements, into };
        if way.abs() > SAME_POINT && self.along.len() < MOST && !self.along.iter().any(|known| known.is_like(&contour))
        {
            self.along.push(contour);
        }
    }

    /// The half section. Contours of cycles say more than compensated paths, which begin and end beside the part.
    pub(super) fn section(mut self) -> Section {
        self.close();
        let contours = if self.contours.is_empty() { self.along } else { self.contours };
        let mut points = 0;
        let outlines: Vec<Outline> = contours
            .iter()
            .map(Outline::of)
            .take_while(|outline| {
                points += outline.points.len();
                points <= MOST_POINTS
            })
            .collect();
        let Some(limits) = Limits::of(&outlines) else { return Section::default() };
        let bodies = outlines.iter().filter_map(|outline| outline.body(&limits)).collect();
        let holes = outlines.iter().filter_map(|outline| outline.hole(&limits)).collect();
        let solid = Solid { bodies, holes };
        let edges =
            outlines.iter().flat_map(|outline| outline.edges(&solid, limits.size)).map(|e| mirrored(&e)).collect();
        let down = |p: Point2| Point2::new(p.x, -p.y);
        Section { edges, hatch: solid.hatch(&limits).into_iter().map(|(a, b)| (down(a), down(b))).collect() }
    }
}

impl Contour {
    /// The same in either direction.
    fn is_like(&self, other: &Contour) -> bool {
        let near = |a: Point2, b: Point2| distance(a, b) <= 1e-4;
        let same = |a: &Element, b: &Element| near(a.from(), b.from()) && near(a.to(), b.to());
        let forward = self.elements.iter().zip(&other.elements).all(|(a, b)| same(a, b));
        let backward = self.elements.iter().rev().zip(&other.elements).all(|(a, b)| same(&a.reversed(), b));
        self.elements.len() == other.elements.len() && (forward || backward)
    }
}

fn mirrored(element: &Element) -> Element {
    let down = |p: Point2| Point2::new(p.x, -p.y);
    match *element {
        Element::Line { from, to } => Element::Line { from: down(from), to: down(to) },
        Element::Arc { from, to, center, sweep } => {
            Element::Arc { from: down(from), to: down(to), center: down(center), sweep: -sweep }
        }
    }
}

/// A contour with its arcs as chords.
#[derive(Debug)]
struct Outline<'a> {
    contour: &'a Contour,
    points: Vec<Point2>,
}

/// How far the picture of the part reaches.
#[derive(Debug)]
struct Limits {
    low: Point2,
    high: Point2,
    size: f64,
    /// Something says how thick the part is.
    outside: bool,
}

impl Limits {
    fn of(outlines: &[Outline<'_>]) -> Option<Limits> {
        let mut rect = super::rect::Rect::default();
        outlines.iter().flat_map(|outline| &outline.points).for_each(|p| rect.take(*p));
        let (low, high) = rect.0?;
        let size = (high - low).amax().max(high.y);
        let outside = outlines.iter().any(|outline| outline.contour.into != Towards::PlusX);
        (size > SAME_POINT && size.is_finite()).then_some(Limits { low, high, size, outside })
    }
}

impl Outline<'_> {
    fn of(contour: &Contour) -> Outline<'_> {
        let mut points: Vec<Point2> = contour.elements.first().map(|first| first.from()).into_iter().collect();
        for piece in contour.elements.iter().flat_map(quarters) {
            if let Element::Arc { from, center, sweep, .. } = piece {
                points.extend(
                    (1..CHORDS).map(|i| center + turned(from - center, sweep * f64::from(i) / f64::from(CHORDS))),
                );
            }
            points.push(piece.to());
        }
        Outline { contour, points }
    }

    /// The contour and the way from its end to its start at `level` of the radius or of Z.
    fn closed(&self, level: f64) -> Option<Vec<Point2>> {
        let (first, last) = (*self.points.first()?, *self.points.last()?);
        let at =
            |p: Point2| if self.contour.into.is_radial() { Point2::new(p.x, level) } else { Point2::new(level, p.y) };
        Some(self.points.iter().copied().chain([at(last), at(first)]).collect())
    }

    /// Material under the contour: to the centre, to the outside, or to the far end.
    fn body(&self, limits: &Limits) -> Option<Vec<Point2>> {
        match self.contour.into {
            Towards::MinusX => self.closed(0.0),
            Towards::PlusX if limits.outside => None,
            // How thick the part is nobody says.
            Towards::PlusX => self.closed(limits.high.y + 0.1 * limits.size),
            Towards::MinusZ => self.closed(limits.low.x),
            Towards::PlusZ => self.closed(limits.high.x),
        }
    }

    /// What is cut away above it.
    fn hole(&self, limits: &Limits) -> Option<Vec<Point2>> {
        match self.contour.into {
            Towards::MinusX => self.closed(limits.high.y + limits.size),
            Towards::PlusX => self.closed(0.0),
            Towards::MinusZ => self.closed(limits.high.x + limits.size),
            Towards::PlusZ => self.closed(limits.low.x - limits.size),
        }
    }

    /// The parts of the contour that are edges: with material on one side.
    fn edges(&self, solid: &Solid, size: f64) -> Vec<Element> {
        let aside = 1e-4 * size;
        let is_edge = |element: &Element| {
            let middle = element.middle();
            let Some(way) = element.ending_at(middle).end_direction() else { return false };
            let normal = crate::geo::left(way) * aside;
            let sides = [middle + normal, middle - normal];
            let [a, b] = sides.map(|p| solid.holds(p));
            // A face at the end of what is described has material on a side of which nothing is said.
            a != b || sides.iter().any(|p| !solid.says(*p))
        };
        let pieces = self.contour.elements.iter().flat_map(|element| solid.cut(element));
        pieces.filter(|piece| piece.length() > SAME_POINT && is_edge(piece)).collect()
    }
}

/// Polygons of material without those that were cut away.
#[derive(Debug)]
struct Solid {
    bodies: Vec<Vec<Point2>>,
    holes: Vec<Vec<Point2>>,
}

impl Solid {
    fn holds(&self, p: Point2) -> bool {
        self.bodies.iter().any(|body| is_inside(body, p)) && !self.holes.iter().any(|hole| is_inside(hole, p))
    }

    /// Is anything said of this place?
    fn says(&self, p: Point2) -> bool {
        self.bodies.iter().chain(&self.holes).any(|polygon| is_inside(polygon, p))
    }

    fn sides(&self) -> impl Iterator<Item = (Point2, Point2)> {
        self.bodies
            .iter()
            .chain(&self.holes)
            .flat_map(|polygon| polygon.iter().zip(polygon.iter().cycle().skip(1)).map(|(a, b)| (*a, *b)))
    }

    /// A line in the pieces into which other contours divide it; arcs stay whole.
    fn cut(&self, element: &Element) -> Vec<Element> {
        let Element::Line { from, to } = *element else { return vec![*element] };
        let mut places: Vec<f64> = self.sides().filter_map(|side| crossing((from, to), side)).collect();
        if places.len() > MOST_CROSSINGS / 10 {
            return vec![*element];
        }
        places.extend([0.0, 1.0]);
        places.sort_unstable_by(f64::total_cmp);
        let at = |t: f64| from + (to - from) * t;
        places.windows(2).map(|pair| Element::Line { from: at(pair[0]), to: at(pair[1]) }).collect()
    }

    /// Lines at 45 degrees where there is material.
    fn hatch(&self, limits: &Limits) -> Vec<(Point2, Point2)> {
        let step = limits.size / LINES * core::f64::consts::SQRT_2;
        let top = limits.high.y + 0.2 * limits.size;
        let (first, last) = (limits.low.x - top, limits.high.x);
        let count = ((last - first) / step).clamp(0.0, 10.0 * LINES) as u32;
        let mut lines = Vec::new();
        for i in 0..=count {
            let z = first + f64::from(i) * step;
            let (from, to) = (Point2::new(z, 0.0), Point2::new(z + top, top));
            let mut places: Vec<f64> = self.sides().filter_map(|side| crossing((from, to), side)).collect();
            if places.len() > MOST_CROSSINGS {
                continue;
            }
            places.extend([0.0, 1.0]);
            places.sort_unstable_by(f64::total_cmp);
            let at = |t: f64| from + (to - from) * t;
            // Neighbours that are both hatched are one line.
            let mut open: Option<f64> = None;
            for pair in places.windows(2) {
                let is_solid = pair[1] - pair[0] > 1e-9 && self.holds(at((pair[0] + pair[1]) / 2.0));
                let is_nothing = pair[1] - pair[0] <= 1e-9;
                match open {
                    None if is_solid => open = Some(pair[0]),
                    Some(begin) if !is_solid && !is_nothing => {
                        lines.push((at(begin), at(pair[0])));
                        open = None;
                    }
                    None | Some(_) => {}
                }
            }
            lines.extend(open.map(|begin| (at(begin), to)));
        }
        lines
    }
}

/// Where on the line, 0 to 1, it meets the side.
fn crossing((from, to): (Point2, Point2), (a, b): (Point2, Point2)) -> Option<f64> {
    let (way, side) = (to - from, b - a);
    let turn = cross(way, side);
    if turn.abs() <= 1e-12 * way.norm() * side.norm() {
        // Of a side along the line its ends count.
        let unit = direction(way, 0.0)?;
        let off = cross(unit, a - from).abs();
        return (off <= 1e-9).then(|| (a - from).dot(&way) / way.norm_squared()).filter(|t| (0.0..=1.0).contains(t));
    }
    let (t, u) = (cross(a - from, side) / turn, cross(a - from, way) / turn);
    ((0.0..=1.0).contains(&t) && (-1e-9..=1.0 + 1e-9).contains(&u)).then_some(t)
}

/// By the number of sides that a ray to the right meets.
fn is_inside(polygon: &[Point2], p: Point2) -> bool {
    let mut inside = false;
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            inside = !inside;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(points: &[(f64, f64)]) -> Vec<Element> {
        let points: Vec<Point2> = points.iter().map(|(z, x)| Point2::new(*z, *x)).collect();
        points.windows(2).map(|pair| Element::Line { from: pair[0], to: pair[1] }).collect()
    }

    fn area(section: &Section, step: f64) -> f64 {
        section.hatch.iter().map(|(a, b)| distance(*a, *b)).sum::<f64>() * step
    }

    #[test]
    fn a_shaft_with_a_groove_and_a_bore_is_hatched_where_material_is_left() {
        let mut parts = Parts::default();
        parts.finished(chain(&[(0.0, 10.0), (-30.0, 10.0), (-30.0, 20.0), (-60.0, 20.0)]), Towards::MinusX);
        // Roughing and finishing name the same contour.
        parts.finished(chain(&[(-60.0, 20.0), (-30.0, 20.0), (-30.0, 10.0), (0.0, 10.0)]), Towards::MinusX);
        parts.finished(chain(&[(-40.0, 20.0), (-40.0, 15.0), (-50.0, 15.0), (-50.0, 20.0)]), Towards::MinusX);
        parts.finished(chain(&[(0.0, 5.0), (-20.0, 5.0), (-20.0, 0.0)]), Towards::PlusX);
        assert_eq!(parts.contours.len(), 3);
        let section = parts.section();
        // 30 x 10 + 30 x 20 - 10 x 5 - 20 x 5; lines are 1 mm apart.
        let counted = area(&section, 1.0);
        assert!((counted - 750.0).abs() < 8.0, "{counted}");
        assert!(section.hatch.iter().all(|(a, b)| a.y <= 0.0 && b.y <= 0.0), "below the centre");
        // The edge over the groove is gone.
        let over = |e: &Element| e.from().y == -20.0 && e.to().y == -20.0 && e.middle().x == -45.0;
        assert!(!section.edges.iter().any(over), "{:?}", section.edges);
        let lengths: f64 = section.edges.iter().map(Element::length).sum();
        // 30 + 10 + 20 + groove 20 + bore 25.
        assert!((lengths - 105.0).abs() < 1e-6, "{lengths} {:?}", section.edges);
    }

    #[test]
    fn a_shoulder_at_the_end_of_a_contour_is_an_edge() {
        for (into, points) in [
            (Towards::MinusX, [(0.0, 10.0), (-30.0, 10.0), (-30.0, 20.0)]),
            (Towards::PlusX, [(0.0, 20.0), (-30.0, 20.0), (-30.0, 10.0)]),
        ] {
            let mut parts = Parts::default();
            parts.finished(chain(&points), into);
            let lengths: f64 = parts.section().edges.iter().map(Element::length).sum();
            assert!((lengths - 40.0).abs() < 1e-6, "{into:?} {lengths}");
        }
    }

    #[test]
    fn the_side_of_the_tool_says_where_the_material_is() {
        for (side, z, into) in [
            (Side::Right, -10.0, Towards::MinusX),
            (Side::Left, -10.0, Towards::PlusX),
            (Side::Left, 10.0, Towards::MinusX),
            (Side::Right, 10.0, Towards::PlusX),
        ] {
            let mut parts = Parts::default();
            chain(&[(0.0, 5.0), (z, 5.0)]).into_iter().for_each(|e| parts.beside(e, side));
            parts.close();
            assert_eq!(parts.along.first().map(|contour| contour.into), Some(into), "{side:?} {z}");
        }
    }
}
