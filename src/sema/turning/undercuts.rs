//! Undercuts in inside corners (G25-Geo, G85): forms U, DIN 509 E and F, DIN 76, in the corner between two elements.
//!
//! Source: T 6.3 (docs/sources.md). All lengths in mm; depths are radius values.

use crate::diag::{Fault, codes};
use crate::geo::undercut::{self, Allowance, Corner, Placed, Reference, Shape, place};
use crate::geo::{Deg, Element, Point2, SAME_DIRECTION, Vec2, direction, distance};
use crate::ir::undercut::{internal_depth, thread_length};
use crate::machine::Undercuts;
use crate::machine::undercut::ThreadLength;
use crate::standard::{SAME, din76};

use super::chain::Solved;
use super::element_data::Transition;

/// Why a size is missing.
type Missing = fn() -> Fault;

/// An undercut with all its sizes, or why they are missing. Which of the two is cut follows from the corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Undercut {
    pub outside: Result<Shape, Missing>,
    pub inside: Result<Shape, Missing>,
    /// Outer edge of a groove (form U), which is cut as any other corner of the contour is.
    pub edge: Option<Transition>,
}

impl From<Shape> for Undercut {
    fn from(shape: Shape) -> Undercut {
        Undercut { outside: Ok(shape), inside: Ok(shape), edge: None }
    }
}

/// The words of a thread undercut; what is missing follows from the pitch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Thread {
    pub pitch: Option<f64>,
    pub depth: Option<f64>,
    pub width: Option<f64>,
    pub radius: Option<f64>,
    pub slope: f64,
}

/// An undercut between two elements.
#[derive(Debug, Clone)]
pub(super) struct Made {
    /// Where the first element ends and the second begins.
    pub leaves: Point2,
    pub joins: Point2,
    /// How the first element goes over into the undercut.
    pub edge: Transition,
    /// Each with what happens at its end.
    pub elements: Vec<(Element, Transition)>,
}

/// Form E and the thread undercuts: slope, floor, quarter arc to the shoulder.
pub(super) fn square(depth: f64, width: f64, radius: f64, slope: f64) -> Shape {
    Shape::Square { length: width, depth, entry: Deg(slope), entry_radius: radius, corner_radius: radius }
}

/// Radius of the DIN 76 undercut of this width.
pub(super) fn radius_of_width(tables: &Undercuts, width: f64, inside: bool) -> Option<f64> {
    let longest = |row: &din76::Row| if inside { row.c.g2 } else { row.a.g2 };
    tables.threads().iter().find(|row| (longest(row) - width).abs() < SAME).map(|row| row.radius)
}

impl Thread {
    pub fn sized(&self, tables: &Undercuts) -> Undercut {
        Undercut { outside: self.shape(tables, false), inside: self.shape(tables, true), edge: None }
    }

    /// The manuals print the greatest length, and the depth inside from the nominal diameter, which the contour does not hold.
    fn shape(&self, tables: &Undercuts, inside: bool) -> Result<Shape, Missing> {
        let row = self.pitch.and_then(|pitch| tables.thread(pitch));
        let missing: Missing = codes::T3004::size_of_thread_undercut_is_missing;
        let radius = self.radius.or(row.map(|row| row.radius)).ok_or(missing);
        let table = row.and_then(|row| match (inside, tables.internal_depth) {
            (false, _) => Some(row.external / 2.0),
            (true, rule) => rule.map(|rule| internal_depth(rule, row)),
        });
        let depth = self.depth.or(table).ok_or(if row.is_some() {
            codes::T3004::depth_of_thread_undercut_in_bore
        } else {
            missing
        });
        let depth = depth?;
        let of_row = |row: &din76::Row| {
            let rule = tables.thread_length.unwrap_or(ThreadLength::Longest);
            thread_length(rule, if inside { row.c } else { row.a }, depth, Deg(self.slope))
        };
        let width = self.width.or(row.map(of_row)).ok_or(missing)?;
        Ok(square(depth, width, radius?, self.slope))
    }
}

/// Puts the undercut between the reference element, parallel to Z, and the shoulder, parallel to X, in either order.
pub(super) fn build(undercut: &Undercut, before: &Solved, after: Option<&Solved>) -> Result<Made, Fault> {
    let Some(after) = after else { return Err(codes::T3004::no_element_follows_undercut()) };
    let straight = |line: &Solved| direction(line.to - line.from, 0.0).filter(|_| line.arc.is_none());
    let (Some(u), Some(w)) = (straight(before), straight(after)) else {
        return Err(codes::T3004::undercut_stands_between_two_lines());
    };
    // The manuals name no angle by which the lines may lean.
    let up = match (along_z(u) && along_x(w), along_x(u) && along_z(w)) {
        (true, _) => w,
        (_, true) => -u,
        _ => return Err(codes::T3004::undercut_stands_between_line_along_z_and_one_along_x()),
    };
    let shape = if up.y > 0.0 { undercut.outside } else { undercut.inside }.map_err(|missing| missing())?;
    slope_fits(&shape)?;
    let corner = Corner { from: before.from, at: before.to, to: after.to };
    let placed =
        place(&shape, &corner, Reference::First, Allowance::default()).map_err(|fault| refusal(&shape, fault))?;
    // Neither longer than the lines, nor further below the corner than the shoulder is high.
    let room = |p: Point2, end: Point2| distance(p, corner.at) <= distance(corner.at, end) + 1e-6;
    if !room(placed.leave, corner.from) || !room(placed.join, corner.to) {
        return Err(codes::T3004::undercut_has_no_room());
    }
    made(placed, undercut.edge, corner.at)
}

/// The slope, and the rounding between it and the floor, which is never made smaller.
fn slope_fits(shape: &Shape) -> Result<(), Fault> {
    let (Shape::Square { length, depth, entry, entry_radius, .. }
    | Shape::Recessed { length, depth, entry, entry_radius, .. }) = *shape
    else {
        return Ok(());
    };
    let (sin, cos) = entry.sin_cos();
    if !(sin > 0.0 && cos > 0.0) {
        return Err(codes::T3004::slope_of_undercut());
    }
    // tan(W/2) = sin W / (1 + cos W)
    let rises = entry_radius * sin / (1.0 + cos) * sin;
    if rises > depth + 1e-9 || length <= depth * cos / sin {
        Err(codes::T3004::radius_does_not_fit_into_undercut())
    } else {
        Ok(())
    }
}

fn refusal(shape: &Shape, fault: undercut::Fault) -> Fault {
    use undercut::Fault::{Angle, Degenerate, Dimension, NotSquare, OtherTooShort, ReferenceTooShort, TooNarrow};
    match (fault, shape) {
        (Degenerate | NotSquare { .. }, _) => codes::T3004::undercut_stands_between_two_lines(),
        (ReferenceTooShort { .. } | OtherTooShort { .. }, _) => codes::T3004::undercut_has_no_room(),
        (Angle, Shape::Square { .. }) => codes::T3004::slope_of_undercut(),
        (TooNarrow, Shape::Square { .. }) => codes::T3004::undercut_is_too_narrow(),
        (TooNarrow, Shape::Groove { .. }) => codes::T3004::radius_does_not_fit_into_undercut(),
        (Angle | TooNarrow | Dimension, _) => codes::T3004::sizes_of_undercut_do_not_fit(),
    }
}

/// A groove ends on the shoulder at the level of the cylinder: what of the face lies below it belongs to the groove.
fn made(placed: Placed, edge: Option<Transition>, corner: Point2) -> Result<Made, Fault> {
    let Placed { leave, join, elements, orientation, .. } = placed;
    let sharp = |element: Element| (element, Transition::Sharp);
    let mut made = Made {
        leaves: leave,
        joins: join,
        edge: Transition::Sharp,
        elements: elements.into_iter().map(sharp).collect(),
    };
    let Some(edge) = edge else { return Ok(made) };
    let wall = if orientation.first_leads { made.elements.first() } else { made.elements.last() };
    if matches!(edge, Transition::Rounding(_) | Transition::Chamfer(_))
        && !matches!(wall, Some((Element::Line { .. }, _)))
    {
        return Err(codes::T3004::radius_does_not_fit_into_undercut());
    }
    if orientation.first_leads {
        made.edge = edge;
        made.elements.push(sharp(Element::Line { from: join, to: corner }));
        made.joins = corner;
    } else {
        if let Some((_, transition)) = made.elements.last_mut() {
            *transition = edge;
        }
        made.elements.insert(0, sharp(Element::Line { from: corner, to: leave }));
        made.leaves = corner;
    }
    Ok(made)
}

fn along_z(u: Vec2) -> bool {
    u.y.abs() <= SAME_DIRECTION
}

fn along_x(u: Vec2) -> bool {
    u.x.abs() <= SAME_DIRECTION
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::undercut::Edge;
    use crate::ir::undercut::form_f;
    use crate::machine::undercut::InternalDepth;

    fn shoulder(r: f64) -> (Solved, Solved) {
        let p = Point2::new;
        let before = Solved { from: p(0.0, r), to: p(-30.0, r), arc: None };
        let after = Solved { from: p(-30.0, r), to: p(-30.0, r + 20.0), arc: None };
        (before, after)
    }

    /// X as a diameter and Z of the ends.
    fn ends(undercut: &Undercut, r: f64) -> Vec<(f64, f64)> {
        let (before, after) = shoulder(r);
        let made = build(undercut, &before, Some(&after)).unwrap();
        let start = std::iter::once(made.leaves);
        start.chain(made.elements.iter().map(|(e, _)| e.to())).map(|p| (2.0 * p.y, p.x)).collect()
    }

    fn near(found: &[(f64, f64)], expected: &[(f64, f64)]) {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (a, b) in found.iter().zip(expected) {
            assert!((a.0 - b.0).abs() < 1e-4 && (a.1 - b.1).abs() < 1e-4, "{found:?}");
        }
    }

    #[test]
    fn worked_example_7() {
        let tables = Undercuts::default();
        let e = Undercut::from(square(0.3, 2.5, 0.6, 15.0));
        near(&ends(&e, 20.0), &[(40.0, -27.5), (39.4409, -28.5433), (39.4, -28.6986), (39.4, -29.4), (40.6, -30.0)]);
        let f = Undercut::from(form_f(tables.size(0.6, 0.3).unwrap()));
        near(&ends(&f, 20.0)[3..], &[(39.4, -29.6), (40.767, -30.1942), (43.5301, -30.0)]);
        let g = PITCH.sized(&tables);
        near(&ends(&g, 10.0), &[(20.0, -24.8), (17.9144, -26.6062), (17.7, -27.0062), (17.7, -29.2), (19.3, -30.0)]);
    }

    const PITCH: Thread = Thread { pitch: Some(1.5), depth: None, width: None, radius: None, slope: din76::ENTRY };

    #[test]
    fn the_same_undercut_from_the_other_side() {
        let e = Undercut::from(square(0.3, 2.5, 0.6, 15.0));
        let (before, after) = shoulder(20.0);
        let there = build(&e, &before, Some(&after)).unwrap();
        let turn = |s: Solved| Solved { from: s.to, to: s.from, arc: None };
        let back = build(&e, &turn(after), Some(&turn(before))).unwrap();
        assert_eq!((there.leaves, there.joins), (back.joins, back.leaves));
        assert_eq!(there.elements.len(), back.elements.len());
    }

    #[test]
    fn sizes_by_the_words_and_the_table() {
        let mut tables = Undercuts::default();
        assert_eq!(PITCH.sized(&tables).outside, Ok(square(1.15, 5.2, 0.8, 30.0)));
        // Inside the depth is missing, until the configuration says from where it counts.
        assert!(PITCH.sized(&tables).inside.is_err());
        let inside = Thread { depth: Some(1.0), ..PITCH };
        assert_eq!(inside.sized(&tables).inside, Ok(square(1.0, 7.8, 0.8, 30.0)));
        tables.internal_depth = Some(InternalDepth::Bore);
        assert_eq!(PITCH.sized(&tables).inside, Ok(square(0.25, 7.8, 0.8, 30.0)));
        tables.thread_length = Some(ThreadLength::Shortest);
        let Ok(Shape::Square { length, .. }) = PITCH.sized(&tables).outside else { panic!("a shape") };
        assert!((length - 3.2 - 1.15 / libm::tan(30f64.to_radians())).abs() < 1e-12);
        assert!(Thread { pitch: Some(1.6), ..PITCH }.sized(&tables).outside.is_err());
        // The width 5.2 is that of the pitch 1.5 outside and of the pitch 1 inside.
        assert_eq!((radius_of_width(&tables, 5.2, false), radius_of_width(&tables, 5.2, true)), (Some(0.8), Some(0.6)));
    }

    #[test]
    fn refusals() {
        let (before, after) = shoulder(20.0);
        let fails = |shape: Shape| build(&shape.into(), &before, Some(&after)).expect_err("refused");
        assert_eq!(fails(square(0.3, 2.5, 0.6, 90.0)), codes::T3004::slope_of_undercut());
        assert_eq!(fails(square(0.3, 2.5, 0.6, 0.0)), codes::T3004::slope_of_undercut());
        assert_eq!(fails(square(0.3, 2.5, 10.0, 15.0)), codes::T3004::radius_does_not_fit_into_undercut());
        assert_eq!(fails(square(0.3, 1.3, 0.6, 15.0)), codes::T3004::undercut_is_too_narrow());
        assert_eq!(fails(square(-0.3, 2.5, 0.6, 15.0)), codes::T3004::radius_does_not_fit_into_undercut());
        let groove = Shape::Groove { width: 2.0, depth: 0.5, edge: Edge::Sharp, radius: 1.0 };
        assert_eq!(fails(groove), codes::T3004::radius_does_not_fit_into_undercut());
        assert_eq!(fails(square(0.3, 35.0, 0.6, 15.0)), codes::T3004::undercut_has_no_room());
    }

    /// A groove ends at the corner, the face goes on from there.
    #[test]
    fn a_groove_goes_up_to_the_corner() {
        let groove = Shape::Groove { width: 3.0, depth: 1.0, edge: Edge::Sharp, radius: 0.3 };
        let found = ends(&Undercut { edge: Some(Transition::Sharp), ..groove.into() }, 20.0);
        near(&found[..2], &[(40.0, -27.0), (38.6, -27.0)]);
        near(&found[found.len() - 2..], &[(38.6, -30.0), (40.0, -30.0)]);
    }
}
