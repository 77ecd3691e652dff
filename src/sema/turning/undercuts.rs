//! Undercuts in inside corners (G25-Geo, G85): forms U, DIN 509 E and F, DIN 76, and the tables of their sizes.
//!
//! Source: reference section 6.3 and worked example 7. All lengths in mm; depths are radius values.

use crate::geo::{Deg, Element, Point2, SAME_DIRECTION, Vec2, direction, distance};

use super::chain::Solved;
use super::contour::minor_arc;
use super::coordinates::Transition;

/// An undercut with all its sizes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Undercut {
    /// Upright wall, base corners of radius `base`, outer edge.
    U { depth: f64, width: f64, base: f64, edge: Transition },
    /// DIN 509 E and DIN 76: slope of `slope` degrees, floor, quarter arc to the shoulder.
    E { depth: f64, width: f64, radius: f64, slope: f64 },
    /// DIN 509 F: goes `face` deep into the shoulder and leaves it at `lean` degrees.
    F { depth: f64, width: f64, radius: f64, slope: f64, face: f64, lean: f64 },
    /// DIN 76: like E; what is missing follows from the pitch, and from whether the corner lies outside or inside.
    Thread { pitch: Option<f64>, depth: Option<f64>, width: Option<f64>, radius: Option<f64>, slope: f64 },
}

/// Elements, each with what happens at its end.
type Pieces = Vec<(Element, Transition)>;

/// An undercut between two elements.
#[derive(Debug, Clone)]
pub(super) struct Made {
    /// Where the first element ends and the second begins.
    pub leaves: Point2,
    pub joins: Point2,
    /// How the first element goes over into the undercut.
    pub edge: Transition,
    pub elements: Pieces,
}

/// How closely a size or diameter is that of a table, mm.
const SAME: f64 = 1e-9;

/// Sizes of DIN 509: largest diameter, depth, width, radius, depth in the face.
const DIN_509: &[[f64; 5]] = &[
    [1.6, 0.1, 0.5, 0.1, 0.1],
    [3.0, 0.1, 1.0, 0.2, 0.1],
    [10.0, 0.2, 2.0, 0.2, 0.1],
    [18.0, 0.2, 2.0, 0.6, 0.1],
    [80.0, 0.3, 2.5, 0.6, 0.2],
    [f64::INFINITY, 0.4, 4.0, 1.0, 0.3],
];

/// The coarser sizes of G85 on the 4110.
const DIN_509_BASIC: &[[f64; 5]] =
    &[[18.0, 0.25, 2.0, 0.6, 0.1], [80.0, 0.35, 2.5, 0.6, 0.2], [f64::INFINITY, 0.45, 4.0, 1.0, 0.3]];

/// Slope and lean of DIN 509, slope of DIN 76, in degrees.
pub(super) const SLOPE_509: f64 = 15.0;
pub(super) const LEAN_509: f64 = 8.0;
pub(super) const SLOPE_76: f64 = 30.0;

/// Sizes of DIN 76: pitch; external groove as a diameter amount, width, radius; internal the same.
const DIN_76: &[[f64; 7]] = &[
    [0.2, 0.3, 0.7, 0.1, 0.1, 1.2, 0.1],
    [0.25, 0.4, 0.9, 0.12, 0.1, 1.4, 0.12],
    [0.3, 0.5, 1.05, 0.16, 0.1, 1.6, 0.16],
    [0.35, 0.6, 1.2, 0.16, 0.2, 1.9, 0.16],
    [0.4, 0.7, 1.4, 0.2, 0.2, 2.2, 0.2],
    [0.45, 0.7, 1.6, 0.2, 0.3, 2.4, 0.2],
    [0.5, 0.8, 1.75, 0.2, 0.3, 2.7, 0.2],
    [0.6, 1.0, 2.1, 0.4, 0.3, 3.3, 0.4],
    [0.7, 1.1, 2.45, 0.4, 0.3, 3.8, 0.4],
    [0.75, 1.2, 2.6, 0.4, 0.3, 4.0, 0.4],
    [0.8, 1.3, 2.8, 0.4, 0.3, 4.2, 0.4],
    [1.0, 1.6, 3.5, 0.6, 0.5, 5.2, 0.6],
    [1.25, 2.0, 4.4, 0.6, 0.5, 6.7, 0.6],
    [1.5, 2.3, 5.2, 0.8, 0.5, 7.8, 0.8],
    [1.75, 2.6, 6.1, 1.0, 0.5, 9.1, 1.0],
    [2.0, 3.0, 7.0, 1.0, 0.5, 10.3, 1.0],
    [2.5, 3.6, 8.7, 1.2, 0.5, 13.0, 1.2],
    [3.0, 4.4, 10.5, 1.6, 0.5, 15.2, 1.6],
    [3.5, 5.0, 12.0, 1.6, 0.5, 17.7, 1.6],
    [4.0, 5.7, 14.0, 2.0, 0.5, 20.0, 2.0],
    [4.5, 6.4, 16.0, 2.0, 0.5, 23.0, 2.0],
    [5.0, 7.0, 17.5, 2.5, 0.5, 26.0, 2.5],
    [5.5, 7.7, 19.0, 3.2, 0.5, 28.0, 3.2],
    [6.0, 8.3, 21.0, 3.2, 0.5, 30.0, 3.2],
];

/// Depth, width, radius and face depth of DIN 509 for a diameter.
pub(super) fn din_509(diameter: f64) -> [f64; 4] {
    sizes(DIN_509, |limit| diameter <= limit)
}

/// The same of the table of G85 on the 4110; `upper`: a diameter at a limit belongs to the row above it.
pub(super) fn din_509_of_g85(diameter: f64, upper: bool) -> [f64; 4] {
    // What arithmetic loses in a diameter is no diameter of its own.
    let nearly = if upper { -SAME } else { SAME };
    sizes(DIN_509_BASIC, |limit| diameter <= limit + nearly)
}

/// Is the diameter one that the table of G85 leaves out?
pub(super) fn is_limit_of_g85(diameter: f64) -> bool {
    DIN_509_BASIC.iter().any(|row| (row[0] - diameter).abs() <= SAME)
}

fn sizes(table: &[[f64; 5]], holds: impl Fn(f64) -> bool) -> [f64; 4] {
    let row = table.iter().find(|row| holds(row[0])).or(table.last());
    row.map_or([0.0; 4], |row| [row[1], row[2], row[3], row[4]])
}

/// Depth, width and radius of an external DIN 76 undercut for a pitch; `None` for a pitch that is not in the table.
pub(super) fn din_76_external(pitch: f64) -> Option<[f64; 3]> {
    let row = DIN_76.iter().find(|row| (row[0] - pitch).abs() < SAME)?;
    Some([row[1] / 2.0, row[2], row[3]])
}

/// Width and radius of an internal DIN 76 undercut for a pitch. Its depth counts from the nominal diameter, which the contour
/// does not hold.
pub(super) fn din_76_internal(pitch: f64) -> Option<[f64; 2]> {
    let row = DIN_76.iter().find(|row| (row[0] - pitch).abs() < SAME)?;
    Some([row[5], row[6]])
}

/// Radius of the DIN 76 undercut of this width.
pub(super) fn din_76_radius(width: f64, inside: bool) -> Option<f64> {
    let at = if inside { 5 } else { 2 };
    DIN_76.iter().find(|row| (row[at] - width).abs() < SAME).map(|row| row[at + 1])
}

/// Puts the undercut between the reference element, parallel to Z, and the shoulder, parallel to X, in either order.
pub(super) fn build(undercut: &Undercut, before: &Solved, after: Option<&Solved>) -> Result<Made, &'static str> {
    let Some(after) = after else { return Err("no element follows the undercut") };
    let corner = before.to;
    let straight = |line: &Solved| direction(line.to - line.from, 0.0).filter(|_| line.arc.is_none());
    let (Some(u), Some(w)) = (straight(before), straight(after)) else {
        return Err("an undercut stands between two lines");
    };
    if along_z(u) && along_x(w) {
        let made = shape(&sized(undercut, w)?, corner, -u, w)?;
        return fitting(made, before, after);
    }
    if along_x(u) && along_z(w) {
        let made = turned_around(shape(&sized(undercut, -u)?, corner, w, -u)?);
        return fitting(made, before, after);
    }
    Err("an undercut stands between a line parallel to Z and one parallel to X")
}

/// The undercut with all its sizes; `up` points along the shoulder away from the cylinder.
fn sized(undercut: &Undercut, up: Vec2) -> Result<Undercut, &'static str> {
    let Undercut::Thread { pitch, depth, width, radius, slope } = *undercut else { return Ok(*undercut) };
    let missing =
        "a size of the thread undercut is missing: give I, K and R, or a pitch FP that is in the table of DIN 76";
    let inside = "the depth of a thread undercut in a bore counts from the nominal diameter, which FP does not give: program I \
                  with (nominal diameter + value of DIN 76 - bore) / 2";
    let row = if up.y > 0.0 {
        pitch.and_then(din_76_external).map(|[i, k, r]| (Some(i), k, r))
    } else {
        pitch.and_then(din_76_internal).map(|[k, r]| (None, k, r))
    };
    let width = width.or(row.map(|(_, k, _)| k)).ok_or(missing)?;
    let radius = radius.or(row.map(|(_, _, r)| r)).ok_or(missing)?;
    let table = row.and_then(|(i, _, _)| i);
    let depth = depth.or(table).ok_or(if row.is_some() { inside } else { missing })?;
    Ok(Undercut::E { depth, width, radius, slope })
}

fn along_z(u: Vec2) -> bool {
    u.y.abs() <= SAME_DIRECTION
}

fn along_x(u: Vec2) -> bool {
    u.x.abs() <= SAME_DIRECTION
}

fn fitting(made: Made, before: &Solved, after: &Solved) -> Result<Made, &'static str> {
    let room = |p: Point2, line: &Solved, end: Point2| distance(p, end) <= distance(line.from, line.to) + 1e-6;
    if room(made.leaves, before, before.to) && room(made.joins, after, after.from) {
        return Ok(made);
    }
    Err("the undercut is wider than the element before it, or higher than the shoulder")
}

fn turned_around(made: Made) -> Made {
    let mut transitions: Vec<Transition> = made.elements.iter().map(|(_, transition)| *transition).collect();
    // A transition stands at the end of its element: going back it stands at the end of the element behind.
    transitions.pop();
    transitions.insert(0, made.edge);
    let elements = made.elements.iter().zip(transitions).rev();
    let back = |element: Element| match element {
        Element::Line { from, to } => Element::Line { from: to, to: from },
        Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
    };
    Made {
        leaves: made.joins,
        joins: made.leaves,
        edge: Transition::Sharp,
        elements: elements.map(|((element, _), transition)| (back(*element), transition)).collect(),
    }
}

/// The undercut from the cylinder to the shoulder. `away` points along the cylinder away from the shoulder, `up` along
/// the shoulder away from the cylinder.
fn shape(undercut: &Undercut, corner: Point2, away: Vec2, up: Vec2) -> Result<Made, &'static str> {
    let p = |a: f64, h: f64| corner + away * a + up * h;
    let line = |from, to| Element::Line { from, to };
    let sharp = Transition::Sharp;
    match *undercut {
        Undercut::U { depth, width, base, edge } => {
            let round = if base > 0.0 { Transition::Rounding(base) } else { sharp };
            if base * 2.0 > width || base > depth {
                return Err("the radius does not fit into the undercut");
            }
            let top = p(0.0, 0.0);
            let mut elements = vec![(line(p(width, 0.0), p(width, -depth)), round)];
            elements.push((line(p(width, -depth), p(0.0, -depth)), round));
            elements.push((line(p(0.0, -depth), top), sharp));
            Ok(Made { leaves: p(width, 0.0), joins: top, edge, elements })
        }
        Undercut::E { depth, width, radius, slope } => {
            let (mut elements, floor) = slope_and_fillet(&p, depth, width, radius, slope)?;
            let end = p(radius, -depth);
            if floor < radius - 1e-9 {
                return Err("the undercut is too narrow for its radius");
            }
            elements.push((line(p(floor, -depth), end), sharp));
            let top = p(0.0, radius - depth);
            elements.push((minor_arc(end, top, p(radius, radius - depth)), sharp));
            Ok(Made { leaves: p(width, 0.0), joins: top, edge: sharp, elements })
        }
        Undercut::Thread { .. } => Err("a size of the thread undercut is missing"),
        Undercut::F { depth, width, radius, slope, face, lean } => {
            let (mut elements, floor) = slope_and_fillet(&p, depth, width, radius, slope)?;
            let (sin, cos) = Deg(lean).sin_cos();
            let (a, h) = (radius - face - radius * cos, radius - depth + radius * sin);
            if sin <= 0.0 || cos <= 0.0 || a >= 0.0 || floor < radius - face {
                return Err("the sizes of the undercut do not fit together");
            }
            let end = p(radius - face, -depth);
            elements.push((line(p(floor, -depth), end), sharp));
            elements.push((minor_arc(end, p(a, h), p(radius - face, radius - depth)), sharp));
            let top = p(0.0, h - a * cos / sin);
            elements.push((line(p(a, h), top), sharp));
            Ok(Made { leaves: p(width, 0.0), joins: top, edge: sharp, elements })
        }
    }
}

/// The slope and the fillet to the floor, and where the floor begins.
fn slope_and_fillet(
    p: &impl Fn(f64, f64) -> Point2,
    depth: f64,
    width: f64,
    radius: f64,
    slope: f64,
) -> Result<(Pieces, f64), &'static str> {
    let (sin, cos) = Deg(slope).sin_cos();
    if !(sin > 0.0 && cos > 0.0) {
        return Err("the slope of an undercut lies between 0 and 90 degrees");
    }
    // tan(W/2) = sin W / (1 + cos W)
    let tangent = radius * sin / (1.0 + cos);
    let sharp = width - depth * cos / sin;
    let (a, h) = (sharp + tangent * cos, -depth + tangent * sin);
    if h > 1e-9 || sharp <= 0.0 {
        return Err("the radius does not fit into the undercut");
    }
    let floor = sharp - tangent;
    let mut elements = vec![(Element::Line { from: p(width, 0.0), to: p(a, h) }, Transition::Sharp)];
    if radius > 0.0 {
        elements.push((minor_arc(p(a, h), p(floor, -depth), p(floor, radius - depth)), Transition::Sharp));
    }
    Ok((elements, floor))
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let e = Undercut::E { depth: 0.3, width: 2.5, radius: 0.6, slope: 15.0 };
        near(&ends(&e, 20.0), &[(40.0, -27.5), (39.4409, -28.5433), (39.4, -28.6986), (39.4, -29.4), (40.6, -30.0)]);
        let f = Undercut::F { depth: 0.3, width: 2.5, radius: 0.6, slope: 15.0, face: 0.2, lean: 8.0 };
        near(&ends(&f, 20.0)[3..], &[(39.4, -29.6), (40.767, -30.1942), (43.5301, -30.0)]);
        let [depth, width, radius] = din_76_external(1.5).unwrap();
        let g = Undercut::E { depth, width, radius, slope: 30.0 };
        near(&ends(&g, 10.0), &[(20.0, -24.8), (17.9144, -26.6062), (17.7, -27.0062), (17.7, -29.2), (19.3, -30.0)]);
    }

    #[test]
    fn the_same_undercut_from_the_other_side() {
        let e = Undercut::E { depth: 0.3, width: 2.5, radius: 0.6, slope: 15.0 };
        let (before, after) = shoulder(20.0);
        let there = build(&e, &before, Some(&after)).unwrap();
        let turn = |s: Solved| Solved { from: s.to, to: s.from, arc: None };
        let back = build(&e, &turn(after), Some(&turn(before))).unwrap();
        assert_eq!((there.leaves, there.joins), (back.joins, back.leaves));
        assert_eq!(there.elements.len(), back.elements.len());
    }

    #[test]
    fn tables() {
        assert_eq!(din_509(40.0), [0.3, 2.5, 0.6, 0.2]);
        assert_eq!(din_509(18.0), [0.2, 2.0, 0.6, 0.1]);
        assert_eq!(din_509_of_g85(18.0, false), [0.25, 2.0, 0.6, 0.1]);
        assert_eq!(din_509_of_g85(18.0, true), [0.35, 2.5, 0.6, 0.2]);
        assert_eq!(din_509_of_g85(80.0, false), [0.35, 2.5, 0.6, 0.2]);
        assert_eq!(din_509_of_g85(80.0, true), [0.45, 4.0, 1.0, 0.3]);
        assert_eq!((is_limit_of_g85(18.0), is_limit_of_g85(18.001)), (true, false));
        // The width 5.2 is that of the pitch 1.5 outside and of the pitch 1 inside.
        assert_eq!((din_76_radius(5.2, false), din_76_radius(5.2, true)), (Some(0.8), Some(0.6)));
        assert_eq!(din_76_external(1.6), None);
    }
}
