//! Undercuts: what relieves the inside corner between a cylinder and a face.
//!
//! An undercut is a polygon with rounded corners in a frame of its own corner: `s` runs from the corner along
//! the reference line (the cylinder), `n` from the corner along the other line (the face). `n < 0` lies
//! inside the material of the cylinder, `s < 0` inside that of the face.
//!
//! ```text
//!            n
//!      face  |
//!            |                  cylinder
//!            |            P0 ____________ s
//!            |            /
//!            \_________ /  entry angle
//!            P2       P1
//! ```

use super::corner::{self, Cut};
use super::{Deg, Element, Point2, SAME_POINT, Vec2, cross, distance, intersect};

/// Largest angle in degrees by which the lines at an undercut may lean out of their axes.
pub const LEAN: f64 = 3.0;

/// How much a part may fall short of its roundings, in mm.
const SHORT: f64 = 1e-6;

/// Outer edge of a groove.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Edge {
    #[default]
    Sharp,
    /// Radius in mm.
    Round(f64),
    /// Length cut off each side in mm.
    Chamfer(f64),
}

/// An undercut with its dimensions; lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// Entry slope, floor, square face: form E, thread undercuts.
    Square {
        /// From the corner to the start of the slope on the reference line.
        length: f64,
        depth: f64,
        /// Between slope and reference line, over 0 to 90.
        entry: Deg,
        /// Between slope and floor.
        entry_radius: f64,
        /// Between floor and face.
        corner_radius: f64,
    },
    /// As `Square`, and the face is relieved as well: form F.
    Recessed {
        length: f64,
        depth: f64,
        entry: Deg,
        entry_radius: f64,
        corner_radius: f64,
        /// By how much the deepest point of the corner rounding lies behind the face.
        face_depth: f64,
        /// Between the relief of the face and the face.
        face_angle: Deg,
    },
    /// Rectangular groove beside the face: form U.
    Groove {
        width: f64,
        depth: f64,
        edge: Edge,
        /// In both corners of the floor.
        radius: f64,
    },
    /// A slope down to the face and a rounding between them: form H.
    Slope { length: f64, entry: Deg, radius: f64 },
    /// A wedge with a round bottom into the corner: form K.
    Wedge {
        /// From the corner to the deepest point, along the axis of the wedge.
        depth: f64,
        radius: f64,
        /// Between the flanks.
        opening: Deg,
        /// Between the axis of the wedge and the reference line.
        axis: Deg,
    },
}

/// Which of the two lines carries the slope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Reference {
    /// The line along the first axis of the plane: the cylinder of a turned part.
    #[default]
    First,
    /// The line along the second axis: the undercut relieves the face.
    Second,
}

/// Where an undercut lies: how the lines leave the corner, and which comes first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orientation {
    /// Sense in which the line along the first axis leaves the corner: 1 or -1.
    pub first: f64,
    /// Sense in which the line along the second axis leaves the corner: 1 outside, -1 inside a turned part.
    pub second: f64,
    /// The line along the first axis is travelled before the other.
    pub first_leads: bool,
}

/// Why there is no such undercut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// A length, depth or radius is negative, zero where it must not be, or not finite.
    Dimension,
    /// An angle is out of range.
    Angle,
    /// A line has no length.
    Degenerate,
    /// The lines are not one along each axis, within [`LEAN`]: the direction in degrees that is off.
    NotSquare { direction: Deg },
    /// Slope, floor and roundings do not fit into the undercut.
    TooNarrow,
    /// The reference line is shorter than the undercut.
    ReferenceTooShort { needs: f64, has: f64 },
    /// The other line is shorter than the undercut.
    OtherTooShort { needs: f64, has: f64 },
}

/// An undercut in its corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Where the element before ends now.
    pub leave: Point2,
    /// Where the element behind starts now.
    pub join: Point2,
    /// From `leave` to `join`, in the direction of travel.
    pub elements: Vec<Element>,
    pub orientation: Orientation,
    /// A line leans out of its axis, so that the undercut departs from its standard.
    pub leans: bool,
    /// The radius between slope and floor did not fit and became this.
    pub reduced: Option<f64>,
}

#[derive(Debug, Clone, Copy)]
struct Vertex {
    at: Point2,
    edge: Edge,
}

/// Two lines that meet in a corner: where the first starts, the corner, where the second ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    pub from: Point2,
    pub at: Point2,
    pub to: Point2,
}

/// What is left on the finished part at the corner: the lines of the contour lie this much outside it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Allowance {
    /// On the reference line.
    pub reference: f64,
    /// On the other line.
    pub other: f64,
}

impl Shape {
    /// Checks the numbers, without a corner.
    ///
    /// # Errors
    /// `Dimension`, `Angle`, `TooNarrow`.
    pub fn check(&self) -> Result<(), Fault> {
        let positive = |v: f64| v > 0.0 && v.is_finite();
        let length = |v: f64| v >= 0.0 && v.is_finite();
        let entry_good = |Deg(a): Deg| a > 0.0 && a <= 90.0;
        let (lengths, angles) = match *self {
            Shape::Square { length: l, depth, entry, entry_radius, corner_radius } => {
                (positive(l) && positive(depth) && length(entry_radius) && length(corner_radius), entry_good(entry))
            }
            Shape::Recessed { length: l, depth, entry, entry_radius, corner_radius, face_depth, face_angle } => (
                positive(l) && positive(depth) && length(entry_radius) && length(corner_radius) && positive(face_depth),
                entry_good(entry) && face_angle.0 > 0.0 && face_angle.0 < 90.0,
            ),
            Shape::Groove { width, depth, edge, radius } => {
                let edge = match edge {
                    Edge::Sharp => 0.0,
                    Edge::Round(v) | Edge::Chamfer(v) => v,
                };
                (positive(width) && positive(depth) && length(radius) && length(edge), true)
            }
            Shape::Slope { length: l, entry, radius } => {
                (positive(l) && length(radius), entry.0 > 0.0 && entry.0 < 90.0)
            }
            Shape::Wedge { depth, radius, opening, axis } => (
                positive(depth) && length(radius) && radius <= depth,
                opening.0 > 0.0 && axis.0 - opening.0 / 2.0 > 0.0 && axis.0 + opening.0 / 2.0 < 90.0,
            ),
        };
        match (lengths, angles) {
            (false, _) => Err(Fault::Dimension),
            (_, false) => Err(Fault::Angle),
            _ => Ok(()),
        }
    }

    /// All lengths times `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Shape {
        let edge = |edge: Edge| match edge {
            Edge::Sharp => Edge::Sharp,
            Edge::Round(v) => Edge::Round(factor * v),
            Edge::Chamfer(v) => Edge::Chamfer(factor * v),
        };
        let mut made = *self;
        match &mut made {
            Shape::Square { length, depth, entry_radius, corner_radius, .. } => {
                for v in [length, depth, entry_radius, corner_radius] {
                    *v *= factor;
                }
            }
            Shape::Recessed { length, depth, entry_radius, corner_radius, face_depth, .. } => {
                for v in [length, depth, entry_radius, corner_radius, face_depth] {
                    *v *= factor;
                }
            }
            Shape::Groove { width, depth, edge: outer, radius } => {
                *outer = edge(*outer);
                for v in [width, depth, radius] {
                    *v *= factor;
                }
            }
            Shape::Slope { length, radius, .. } => {
                *length *= factor;
                *radius *= factor;
            }
            Shape::Wedge { depth, radius, .. } => {
                *depth *= factor;
                *radius *= factor;
            }
        }
        made
    }

    /// How deep it reaches under the reference line, measured at the corner.
    pub fn depth(&self) -> f64 {
        match *self {
            Shape::Square { depth, .. } | Shape::Recessed { depth, .. } | Shape::Groove { depth, .. } => depth,
            Shape::Slope { length, entry, .. } => length * tan(entry),
            Shape::Wedge { depth, .. } => depth,
        }
    }

    /// The corners of the polygon, from the reference line to the other one. `lines` are the two lines as
    /// they leave the corner, in the frame of the undercut.
    fn polygon(&self, reference: (Point2, Vec2), other: (Point2, Vec2)) -> Option<(Vec<Vertex>, Option<f64>)> {
        let sharp = |at| Vertex { at, edge: Edge::Sharp };
        let round = |at, r| Vertex { at, edge: if r > 0.0 { Edge::Round(r) } else { Edge::Sharp } };
        let meet = |p, u, (q, w): (Point2, Vec2)| intersect::lines(p, u, q, w, 1e-9).map(|(s, _)| p + u * s);
        match *self {
            Shape::Square { length, depth, entry, entry_radius, corner_radius } => {
                let (p0, p1) = slope(length, depth, entry, reference)?;
                let p2 = meet(p1, Vec2::new(-1.0, 0.0), other).filter(|p2| p2.x < p1.x)?;
                let (r1, reduced) = fitting(entry_radius, entry, distance(p0, p1));
                Some((vec![sharp(p0), round(p1, r1), round(p2, corner_radius)], reduced))
            }
            Shape::Recessed { length, depth, entry, entry_radius, corner_radius, face_depth, face_angle } => {
                let (p0, p1) = slope(length, depth, entry, reference)?;
                let (sin, cos) = face_angle.sin_cos();
                // The rounding touches the floor and the relief of the face; its deepest point lies `face_depth`
                // behind the face, so its centre at s = r - face_depth. The corner of floor and relief is the
                // tangent length r·(1 + sin A)/cos A behind the centre.
                let behind = face_depth - corner_radius + corner_radius * (1.0 + sin) / cos;
                let p2 = Point2::new(-behind, -depth);
                // A slope longer than the undercut would turn the floor around.
                if p2.x >= p1.x {
                    return None;
                }
                let p3 = meet(p2, Vec2::new(sin, cos), other)?;
                let (r1, reduced) = fitting(entry_radius, entry, distance(p0, p1));
                Some((vec![sharp(p0), round(p1, r1), round(p2, corner_radius), sharp(p3)], reduced))
            }
            Shape::Groove { width, depth, edge, radius } => {
                let (p0, p1) = slope(width, depth, Deg(90.0), reference)?;
                let p2 = meet(p1, Vec2::new(-1.0, 0.0), other).filter(|p2| p2.x < p1.x)?;
                Some((vec![Vertex { at: p0, edge }, round(p1, radius), round(p2, radius)], None))
            }
            Shape::Slope { length, entry, radius } => {
                let (p0, _) = slope(length, 1.0, entry, reference)?;
                let (sin, cos) = entry.sin_cos();
                let p1 = meet(p0, Vec2::new(-cos, -sin), other)?;
                Some((vec![sharp(p0), round(p1, radius)], None))
            }
            Shape::Wedge { depth, radius, opening, axis } => {
                let half = Deg(opening.0 / 2.0);
                let apex = Point2::origin() - axis.unit() * (depth - radius + radius / half.sin_cos().0);
                let p0 = meet(apex, Deg(axis.0 - half.0).unit(), reference)?;
                let p2 = meet(apex, Deg(axis.0 + half.0).unit(), other)?;
                Some((vec![sharp(p0), round(apex, radius), sharp(p2)], None))
            }
        }
    }
}

/// Start of the entry slope on the reference line, and its end on the floor.
fn slope(length: f64, depth: f64, entry: Deg, reference: (Point2, Vec2)) -> Option<(Point2, Point2)> {
    let (sin, cos) = entry.sin_cos();
    let foot = Point2::new(length - depth * cos / sin, -depth);
    let (s, _) = intersect::lines(foot, Vec2::new(cos, sin), reference.0, reference.1, 1e-9)?;
    (s > 0.0).then(|| (foot + Vec2::new(cos, sin) * s, foot))
}

/// The radius, or the largest one whose tangent fits on a slope of this length.
fn fitting(radius: f64, entry: Deg, length: f64) -> (f64, Option<f64>) {
    let tangent = radius * tan(Deg(entry.0 / 2.0));
    if tangent <= length + SHORT {
        return (radius, None);
    }
    let fits = length / tan(Deg(entry.0 / 2.0));
    (fits, Some(fits))
}

fn tan(angle: Deg) -> f64 {
    let (sin, cos) = angle.sin_cos();
    sin / cos
}

impl Orientation {
    /// Reads the orientation of a corner.
    ///
    /// # Errors
    /// `Degenerate`, `NotSquare`.
    pub fn of(corner: &Corner) -> Result<Orientation, Fault> {
        let (Some(u), Some(w)) = (
            super::direction(corner.at - corner.from, SAME_POINT),
            super::direction(corner.to - corner.at, SAME_POINT),
        ) else {
            return Err(Fault::Degenerate);
        };
        let off = |v: Vec2, which: Vec2| {
            let angle = Deg::from_radians(libm::atan2(v.dot(&super::left(which)).abs(), v.dot(&which).abs())).0;
            angle > LEAN + 1e-9
        };
        let first_leads = u.x.abs() >= u.y.abs();
        let (along, across) = if first_leads { (Vec2::x(), Vec2::y()) } else { (Vec2::y(), Vec2::x()) };
        for (v, axis) in [(u, along), (w, across)] {
            if off(v, axis) {
                return Err(Fault::NotSquare { direction: Deg::of(v) });
            }
        }
        let (first, second) = if first_leads { (-u.x, w.y) } else { (w.x, -u.y) };
        Ok(Orientation { first: first.signum(), second: second.signum(), first_leads })
    }
}

/// Puts `shape` into a corner. What is before and behind the corner is cut back to where the undercut begins.
///
/// # Errors
/// See [`Fault`].
pub fn place(shape: &Shape, corner: &Corner, reference: Reference, allowance: Allowance) -> Result<Placed, Fault> {
    shape.check()?;
    let orientation = Orientation::of(corner)?;
    let frame = Frame::new(corner.at, orientation, reference, allowance);
    let leads = orientation.first_leads == (reference == Reference::First);
    let (far, near) = if leads { (corner.from, corner.to) } else { (corner.to, corner.from) };
    let (at, start, end) = (frame.inward(corner.at), frame.inward(far), frame.inward(near));
    let away = |p: Point2| super::direction(p - at, SAME_POINT).ok_or(Fault::Degenerate);
    let lines = ((at, away(start)?), (at, away(end)?));
    let (has_start, has_end) = (distance(at, start), distance(at, end));
    let (polygon, reduced) = shape.polygon(lines.0, lines.1).ok_or(Fault::TooNarrow)?;
    // Ends of the lines that are far enough away; whether the lines are is looked at afterwards.
    let beyond = |vertex: Option<&Vertex>, line: (Point2, Vec2)| {
        let Some(Vertex { at, edge }) = vertex else { return line.0 };
        let size = match *edge {
            Edge::Sharp => 0.0,
            Edge::Round(r) | Edge::Chamfer(r) => r,
        };
        line.0 + line.1 * (2.0 * distance(line.0, *at) + 4.0 * size + 1.0)
    };
    let start = beyond(polygon.first(), lines.0);
    let end = beyond(polygon.last(), lines.1);
    let elements = rounded(start, &polygon, end)?;
    let finite = |p: Point2| p.x.is_finite() && p.y.is_finite();
    if !elements.iter().all(|element| finite(element.from()) && finite(element.to())) {
        return Err(Fault::Dimension);
    }
    // The first and the last element are what is left of the lines.
    let leave = elements.first().map_or(start, Element::to);
    let join = elements.last().map_or(end, Element::from);
    let needs = |p: Point2, line: (Point2, Vec2)| (p - line.0).dot(&line.1);
    let (needs_start, needs_end) = (needs(leave, lines.0), needs(join, lines.1));
    if needs_start > has_start + SHORT {
        return Err(Fault::ReferenceTooShort { needs: needs_start, has: has_start });
    }
    if needs_end > has_end + SHORT {
        return Err(Fault::OtherTooShort { needs: needs_end, has: has_end });
    }
    let inner = elements.get(1..elements.len().saturating_sub(1)).unwrap_or_default();
    let mapped = inner.iter().map(|element| frame.outward(element));
    let elements = if leads { mapped.collect() } else { mapped.rev().map(|e| reversed(&e)).collect() };
    let (leave, join) = if leads { (leave, join) } else { (join, leave) };
    let leans = [lines.0.1.y, lines.1.1.x].iter().any(|off| off.abs() > 1e-9);
    Ok(Placed { leave: frame.point(leave), join: frame.point(join), elements, orientation, leans, reduced })
}

/// The corners of the undercut before they are rounded, in the direction of travel, each with its radius.
///
/// # Errors
/// See [`Fault`]; room is not looked at.
pub fn vertices(
    shape: &Shape,
    corner: &Corner,
    reference: Reference,
    allowance: Allowance,
) -> Result<Vec<(Point2, f64)>, Fault> {
    shape.check()?;
    let orientation = Orientation::of(corner)?;
    let frame = Frame::new(corner.at, orientation, reference, allowance);
    let leads = orientation.first_leads == (reference == Reference::First);
    let (far, near) = if leads { (corner.from, corner.to) } else { (corner.to, corner.from) };
    let at = frame.inward(corner.at);
    let away = |p: Point2| super::direction(frame.inward(p) - at, SAME_POINT).ok_or(Fault::Degenerate);
    let (polygon, _) = shape.polygon((at, away(far)?), (at, away(near)?)).ok_or(Fault::TooNarrow)?;
    let placed = polygon.iter().map(|vertex| {
        let radius = match vertex.edge {
            Edge::Sharp => 0.0,
            Edge::Round(r) | Edge::Chamfer(r) => r,
        };
        (frame.point(vertex.at), radius)
    });
    let mut list: Vec<_> = placed.collect();
    if !leads {
        list.reverse();
    }
    Ok(list)
}

/// The polygon from a point of the one line to a point of the other, its corners rounded. The first and the
/// last element are the lines; they may run backwards if there is no room.
fn rounded(start: Point2, polygon: &[Vertex], end: Point2) -> Result<Vec<Element>, Fault> {
    let mut elements = Vec::with_capacity(2 * polygon.len() + 1);
    let mut from = start;
    let mut corner_before = start;
    for (i, vertex) in polygon.iter().enumerate() {
        let next = polygon.get(i + 1).map_or(end, |v| v.at);
        let before = Element::Line { from: corner_before, to: vertex.at };
        let after = Element::Line { from: vertex.at, to: next };
        let cut = match vertex.edge {
            Edge::Sharp => Ok(Cut { leave: vertex.at, join: vertex.at, arc: None }),
            // Whether there is room is decided below, where both ends of a line are known.
            Edge::Round(radius) => corner::rounding(&before, &after, radius, f64::INFINITY),
            Edge::Chamfer(side) => corner::chamfer(&before, &after, side, f64::INFINITY),
        };
        let Ok(cut) = cut else { return Err(Fault::TooNarrow) };
        let room = (cut.leave - from).dot(&(vertex.at - corner_before));
        if i > 0 && room < -SHORT * distance(vertex.at, corner_before) {
            return Err(Fault::TooNarrow);
        }
        if i == 0 || distance(from, cut.leave) > SAME_POINT {
            elements.push(Element::Line { from, to: cut.leave });
        }
        if distance(cut.leave, cut.join) > SAME_POINT {
            elements.push(match cut.arc {
                Some((center, ccw)) => Element::Arc {
                    from: cut.leave,
                    to: cut.join,
                    center,
                    sweep: super::arc::sweep(cut.leave, cut.join, center, ccw),
                },
                None => Element::Line { from: cut.leave, to: cut.join },
            });
        }
        from = cut.join;
        corner_before = vertex.at;
    }
    elements.push(Element::Line { from, to: end });
    Ok(elements)
}

fn reversed(element: &Element) -> Element {
    match *element {
        Element::Line { from, to } => Element::Line { from: to, to: from },
        Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
    }
}

/// From the frame of the undercut to the plane and back. Only signs change, so a mirrored corner gets the
/// mirrored numbers.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    origin: Point2,
    along: Vec2,
    across: Vec2,
}

impl Frame {
    pub fn new(corner: Point2, orientation: Orientation, reference: Reference, allowance: Allowance) -> Frame {
        let (first, second) = (Vec2::new(orientation.first, 0.0), Vec2::new(0.0, orientation.second));
        let (along, across) = match reference {
            Reference::First => (first, second),
            Reference::Second => (second, first),
        };
        // The finished part lies inside the contour.
        let origin = corner - across * allowance.reference - along * allowance.other;
        Frame { origin, along, across }
    }

    /// A point of the undercut in the plane.
    pub fn point(&self, p: Point2) -> Point2 {
        self.origin + self.along * p.x + self.across * p.y
    }

    /// A point of the plane in the undercut.
    pub fn inward(&self, p: Point2) -> Point2 {
        let v = p - self.origin;
        Point2::new(v.dot(&self.along), v.dot(&self.across))
    }

    /// Does the frame turn counter-clockwise arcs into clockwise ones?
    pub fn flips(&self) -> bool {
        cross(self.along, self.across) < 0.0
    }

    fn outward(&self, element: &Element) -> Element {
        match *element {
            Element::Line { from, to } => Element::Line { from: self.point(from), to: self.point(to) },
            Element::Arc { from, to, center, sweep } => Element::Arc {
                from: self.point(from),
                to: self.point(to),
                center: self.point(center),
                sweep: if self.flips() { -sweep } else { sweep },
            },
        }
    }
}

#[cfg(test)]
mod tests;
