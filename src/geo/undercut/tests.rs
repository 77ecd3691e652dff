//! The worked examples, and what holds for every undercut.

use proptest::prelude::*;

use super::*;
use crate::geo::arc;

const E: Shape = Shape::Square { length: 2.5, depth: 0.3, entry: Deg(15.0), entry_radius: 0.6, corner_radius: 0.6 };
const F: Shape = Shape::Recessed {
    length: 2.5,
    depth: 0.3,
    entry: Deg(15.0),
    entry_radius: 0.6,
    corner_radius: 0.6,
    face_depth: 0.2,
    face_angle: Deg(8.0),
};

/// A corner from Z and X, X as a diameter, as drawings have it.
fn corner(from: (f64, f64), at: (f64, f64), to: (f64, f64)) -> Corner {
    let p = |(z, x): (f64, f64)| Point2::new(z, x / 2.0);
    Corner { from: p(from), at: p(at), to: p(to) }
}

fn at(shape: &Shape, corner: &Corner) -> Placed {
    place(shape, corner, Reference::First, Allowance::default()).expect("an undercut")
}

fn number(v: f64) -> String {
    let text = format!("{v:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The undercut as the examples print it: Z, X as a diameter, K and I as absolute Z and diameter.
fn words(placed: &Placed) -> Vec<String> {
    let point = |p: Point2| format!("Z{} X{}", number(p.x), number(2.0 * p.y));
    let mut list = vec![format!("G1 {}", point(placed.leave))];
    for element in &placed.elements {
        list.push(match *element {
            Element::Line { to, .. } => format!("G1 {}", point(to)),
            Element::Arc { to, center, sweep, .. } => {
                let word = if sweep > 0.0 { "G3" } else { "G2" };
                format!("{word} {} K{} I{}", point(to), number(center.x), number(2.0 * center.y))
            }
        });
    }
    list
}

#[test]
fn form_e_outside_as_computed_by_hand() {
    let placed = at(&E, &corner((-52.0, 65.0), (-75.0, 65.0), (-75.0, 80.0)));
    assert_eq!(
        words(&placed),
        [
            "G1 Z-72.5 X65",
            "G1 Z-73.5433 X64.4409",
            "G2 Z-73.6986 X64.4 K-73.6986 I65.6",
            "G1 Z-74.4 X64.4",
            "G2 Z-75 X65.6 K-74.4 I65.6",
        ]
    );
    assert_eq!(placed.join, Point2::new(-75.0, 32.8));
    let placed = at(&E, &corner((-60.0, 65.0), (-20.0, 65.0), (-20.0, 80.0)));
    assert_eq!(
        words(&placed),
        [
            "G1 Z-22.5 X65",
            "G1 Z-21.4567 X64.4409",
            "G3 Z-21.3014 X64.4 K-21.3014 I65.6",
            "G1 Z-20.6 X64.4",
            "G3 Z-20 X65.6 K-20.6 I65.6",
        ]
    );
}

#[test]
fn form_e_inside_as_computed_by_hand() {
    assert_eq!(
        words(&at(&E, &corner((0.0, 40.0), (-30.0, 40.0), (-30.0, 20.0)))),
        [
            "G1 Z-27.5 X40",
            "G1 Z-28.5433 X40.5591",
            "G3 Z-28.6986 X40.6 K-28.6986 I39.4",
            "G1 Z-29.4 X40.6",
            "G3 Z-30 X39.4 K-29.4 I39.4",
        ]
    );
}

#[test]
fn form_f_in_all_orientations_as_computed_by_hand() {
    let cases = [
        (
            corner((0.0, 50.2), (-50.0, 50.2), (-50.0, 65.0)),
            [
                "G1 Z-47.5 X50.2",
                "G1 Z-48.5433 X49.6409",
                "G2 Z-48.6986 X49.6 K-48.6986 I50.8",
                "G1 Z-49.6 X49.6",
                "G2 Z-50.1942 X50.967 K-49.6 I50.8",
                "G1 Z-50 X53.7301",
            ],
        ),
        (
            corner((-60.0, 50.2), (-20.0, 50.2), (-20.0, 65.0)),
            [
                "G1 Z-22.5 X50.2",
                "G1 Z-21.4567 X49.6409",
                "G3 Z-21.3014 X49.6 K-21.3014 I50.8",
                "G1 Z-20.4 X49.6",
                "G3 Z-19.8058 X50.967 K-20.4 I50.8",
                "G1 Z-20 X53.7301",
            ],
        ),
        (
            corner((0.0, 40.0), (-30.0, 40.0), (-30.0, 20.0)),
            [
                "G1 Z-27.5 X40",
                "G1 Z-28.5433 X40.5591",
                "G3 Z-28.6986 X40.6 K-28.6986 I39.4",
                "G1 Z-29.6 X40.6",
                "G3 Z-30.1942 X39.233 K-29.6 I39.4",
                "G1 Z-30 X36.4699",
            ],
        ),
        (
            corner((-60.0, 40.0), (-30.0, 40.0), (-30.0, 20.0)),
            [
                "G1 Z-32.5 X40",
                "G1 Z-31.4567 X40.5591",
                "G2 Z-31.3014 X40.6 K-31.3014 I39.4",
                "G1 Z-30.4 X40.6",
                "G2 Z-29.8058 X39.233 K-30.4 I39.4",
                "G1 Z-30 X36.4699",
            ],
        ),
    ];
    for (corner, lines) in cases {
        assert_eq!(words(&at(&F, &corner)), lines);
    }
}

#[test]
fn thread_undercuts_as_computed_by_hand() {
    let thread = |length, depth, entry, radius| Shape::Square {
        length,
        depth,
        entry: Deg(entry),
        entry_radius: radius,
        corner_radius: radius,
    };
    let outside = corner((0.0, 20.0), (-30.0, 20.0), (-30.0, 30.0));
    // M20 x 2.5, form A, entry 30, 60 and 90 degrees, and form B.
    let length = |g1: f64, g2: f64, depth: f64, entry: f64| (g1 + g2 + depth / libm::tan(entry.to_radians())) / 2.0;
    let lines = words(&at(&thread(length(5.6, 8.7, 1.8, 30.0), 1.8, 30.0, 1.2), &outside));
    assert_eq!(
        lines,
        [
            "G1 Z-21.2912 X20",
            "G1 Z-24.1304 X16.7215",
            "G2 Z-24.7304 X16.4 K-24.7304 I18.8",
            "G1 Z-28.8 X16.4",
            "G2 Z-30 X18.8 K-28.8 I18.8",
        ]
    );
    let lines = words(&at(&thread(length(5.6, 8.7, 1.8, 60.0), 1.8, 60.0, 1.2), &outside));
    assert_eq!(lines[..3], ["G1 Z-22.3304 X20", "G1 Z-23.0232 X17.6", "G2 Z-24.0624 X16.4 K-24.0624 I18.8"]);
    let lines = words(&at(&thread(7.15, 1.8, 90.0, 1.2), &outside));
    assert_eq!(lines[..3], ["G1 Z-22.85 X20", "G1 Z-22.85 X18.8", "G2 Z-24.05 X16.4 K-24.05 I18.8"]);
    let lines = words(&at(&thread(length(3.2, 6.3, 1.8, 30.0), 1.8, 30.0, 1.2), &outside));
    assert_eq!(lines[..3], ["G1 Z-23.6912 X20", "G1 Z-26.5304 X16.7215", "G2 Z-27.1304 X16.4 K-27.1304 I18.8"]);
    // M20 x 2.5 inside, form C.
    let depth = (1.08253 * 2.5 + 0.5) / 2.0;
    let inside = corner((0.0, 20.0 - 1.08253 * 2.5), (-30.0, 20.0 - 1.08253 * 2.5), (-30.0, 12.0));
    assert_eq!(
        words(&at(&thread(length(10.0, 13.0, depth, 30.0), depth, 30.0, 1.2), &inside)),
        [
            "G1 Z-17.1116 X17.2937",
            "G1 Z-19.6099 X20.1785",
            "G3 Z-20.2099 X20.5 K-20.2099 I18.1",
            "G1 Z-28.8 X20.5",
            "G3 Z-30 X18.1 K-28.8 I18.1",
        ]
    );
    // M20 x 1.5 by its width, after the other manual: I 1.15, K 5.2, R 0.8, W 30.
    assert_eq!(
        words(&at(&thread(5.2, 1.15, 30.0, 0.8), &outside)),
        [
            "G1 Z-24.8 X20",
            "G1 Z-26.6062 X17.9144",
            "G2 Z-27.0062 X17.7 K-27.0062 I19.3",
            "G1 Z-29.2 X17.7",
            "G2 Z-30 X19.3 K-29.2 I19.3",
        ]
    );
}

/// Allowance 0.1 on the cylinder: the slope gets longer, all the rest stays on the finished part.
#[test]
fn grinding_allowance_as_computed_by_hand() {
    let raised = corner((0.0, 72.211), (-31.0, 72.211), (-31.0, 100.0));
    let allowance = Allowance { reference: 0.1, other: 0.0 };
    let lines = words(&place(&F, &raised, Reference::First, allowance).expect("an undercut"));
    assert_eq!((lines[0].as_str(), lines[5].as_str()), ("G1 Z-28.1268 X72.211", "G1 Z-31 X75.5411"));
    assert!(lines[2].contains("X71.411") && lines[3].contains("X71.411"), "{lines:?}");
}

#[test]
fn other_forms() {
    // Form U: 3 wide, 1 deep, edge chamfer 0.2, floor radius 0.4.
    let edge = Edge::Chamfer(0.2);
    let groove = Shape::Groove { width: 3.0, depth: 1.0, edge, radius: 0.4 };
    let outside = corner((0.0, 40.0), (-30.0, 40.0), (-30.0, 60.0));
    assert_eq!(
        words(&at(&groove, &outside)),
        [
            "G1 Z-26.8 X40",
            "G1 Z-27 X39.6",
            "G1 Z-27 X38.8",
            "G2 Z-27.4 X38 K-27.4 I38.8",
            "G1 Z-29.6 X38",
            "G2 Z-30 X38.8 K-29.6 I38.8",
        ]
    );
    // Form H: 30 degrees over 3 mm reach 1.7321 deep; the rounding of 1 there.
    let lines = words(&at(&Shape::Slope { length: 3.0, entry: Deg(30.0), radius: 1.0 }, &outside));
    assert_eq!(lines, ["G1 Z-27 X40", "G1 Z-28.5 X38.2679", "G2 Z-30 X40 K-29 I40"]);
    // Form K: 1 deep along 45 degrees, radius 0.4, opening 60: flanks at 15 and 75 degrees.
    let wedge = Shape::Wedge { depth: 1.0, radius: 0.4, opening: Deg(60.0), axis: Deg(45.0) };
    let placed = at(&wedge, &outside);
    let Element::Arc { center, .. } = placed.elements[1] else { panic!("{placed:?}") };
    let deepest = distance(center, Point2::new(-30.0, 20.0)) + 0.4;
    assert!((deepest - 1.0).abs() < 1e-12, "{placed:?}");
    assert!((placed.leave.x + 30.0 - (placed.join.y - 20.0)).abs() < 1e-12, "symmetric: {placed:?}");
}

#[test]
fn the_face_can_be_the_reference() {
    // The mirror image in the bisector of the corner: Z and X change places.
    let outside = corner((0.0, 40.0), (-30.0, 40.0), (-30.0, 60.0));
    let placed = place(&E, &outside, Reference::Second, Allowance::default()).expect("an undercut");
    assert_eq!(
        words(&placed),
        [
            "G1 Z-29.7 X40",
            "G2 Z-30.3 X41.2 K-29.7 I41.2",
            "G1 Z-30.3 X42.6028",
            "G2 Z-30.2796 X42.9134 K-29.7 I42.6028",
            "G1 Z-30 X45",
        ]
    );
}

#[test]
fn a_taper_within_three_degrees_meets_its_lines() {
    // A taper of 1.7899 degrees as of pipe threads: 1 in 16 on diameter.
    let taper = corner((0.0, 40.0), (-32.0, 42.0), (-32.0, 60.0));
    let placed = at(&E, &taper);
    assert!(placed.leans);
    let on_line = 21.0 - (placed.leave.x + 32.0) / 32.0 - placed.leave.y;
    assert!(on_line.abs() < 1e-12, "{placed:?}");
    let steep = corner((0.0, 40.0), (-32.0, 44.0), (-32.0, 60.0));
    assert!(matches!(place(&E, &steep, Reference::First, Allowance::default()), Err(Fault::NotSquare { .. })));
}

#[test]
fn every_fault_has_its_case() {
    let outside = corner((0.0, 40.0), (-30.0, 40.0), (-30.0, 60.0));
    let fault =
        |shape: Shape, corner: Corner| place(&shape, &corner, Reference::First, Allowance::default()).unwrap_err();
    let square =
        |length, depth, entry, r| Shape::Square { length, depth, entry: Deg(entry), entry_radius: r, corner_radius: r };
    assert_eq!(fault(square(2.5, f64::NAN, 15.0, 0.6), outside), Fault::Dimension);
    assert_eq!(fault(square(2.5, 0.0, 15.0, 0.6), outside), Fault::Dimension);
    assert_eq!(fault(square(2.5, 0.3, 0.0, 0.6), outside), Fault::Angle);
    assert_eq!(fault(square(2.5, 0.3, 91.0, 0.6), outside), Fault::Angle);
    // Values that a lost decimal point makes: no panic, no number that is none.
    for shape in [square(1e300, 1e300, 15.0, 1e300), square(2.5, 0.3, 1e-300, 0.6), square(1e-300, 1e-300, 90.0, 1e300)]
    {
        let placed = place(&shape, &outside, Reference::First, Allowance::default());
        let finite = |p: Point2| p.x.is_finite() && p.y.is_finite();
        assert!(placed.is_err() || placed.is_ok_and(|placed| finite(placed.leave) && finite(placed.join)));
    }
    assert_eq!(
        fault(Shape::Wedge { depth: 1.0, radius: 0.2, opening: Deg(90.0), axis: Deg(45.0) }, outside),
        Fault::Angle
    );
    assert_eq!(fault(square(1.2, 0.3, 15.0, 0.6), outside), Fault::TooNarrow);
    assert_eq!(fault(E, corner((-30.0, 40.0), (-30.0, 40.0), (-30.0, 60.0))), Fault::Degenerate);
    assert!(matches!(fault(E, corner((0.0, 40.0), (-30.0, 40.0), (-60.0, 40.0))), Fault::NotSquare { .. }));
    assert!(matches!(fault(E, corner((-28.0, 40.0), (-30.0, 40.0), (-30.0, 60.0))), Fault::ReferenceTooShort { .. }));
    assert!(matches!(fault(F, corner((0.0, 40.0), (-30.0, 40.0), (-30.0, 43.0))), Fault::OtherTooShort { .. }));
    // A radius that is larger than the wall becomes as large as the wall.
    let placed = at(&square(5.0, 0.5, 90.0, 1.0), &outside);
    assert!(placed.reduced.is_some_and(|r| (r - 0.5).abs() < 1e-12));
}

fn shape() -> impl Strategy<Value = Shape> {
    let entry = (15.0f64..=90.0).prop_map(Deg);
    (2.0f64..6.0, 0.2f64..1.2, entry, 0.1f64..0.8, 0.1f64..0.8, any::<bool>()).prop_map(
        |(extra, depth, entry, r1, r2, both)| {
            let length = depth / tan(entry) + extra;
            let (entry_radius, corner_radius) = (r1, r2);
            if both {
                let (face_depth, face_angle) = (depth / 2.0, Deg(8.0));
                Shape::Recessed { length, depth, entry, entry_radius, corner_radius, face_depth, face_angle }
            } else {
                Shape::Square { length, depth, entry, entry_radius, corner_radius }
            }
        },
    )
}

/// Joins within the rounding error of the coordinates.
fn smooth(placed: &Placed, after: Vec2) -> Result<(), TestCaseError> {
    let mut p = placed.leave;
    // The edge in which the undercut begins is no joint.
    let mut dir: Option<(Vec2, bool)> = None;
    for element in placed.elements.iter().chain([&Element::Line { from: placed.join, to: placed.join + after }]) {
        prop_assert!(distance(p, element.from()) < 1e-9);
        let is_arc = matches!(element, Element::Arc { .. });
        if let (Some((last, was_arc)), Some(start)) = (dir, element.start_direction())
            && (is_arc || was_arc)
        {
            prop_assert!((last - start).norm() < 1e-6, "{element:?}: {last:?} {start:?}");
        }
        dir = element.end_direction().map(|d| (d, is_arc));
        p = element.to();
    }
    Ok(())
}

/// Least coordinate along `axis` that the undercut reaches.
fn least(placed: &Placed, axis: Vec2) -> f64 {
    placed
        .elements
        .iter()
        .flat_map(|element| (0..=64).map(move |i| along(element, f64::from(i) / 64.0)))
        .map(|p| p.coords.dot(&axis))
        .fold(f64::INFINITY, f64::min)
}

fn along(element: &Element, t: f64) -> Point2 {
    match *element {
        Element::Line { from, to } => from + (to - from) * t,
        Element::Arc { from, center, sweep, .. } => center + crate::geo::turned(from - center, sweep * t),
    }
}

proptest! {
    #[test]
    fn undercuts_join_tangentially_and_keep_their_depth(shape in shape(), z in -500i32..0, x in 20i32..300) {
        let (z, x) = (f64::from(z), f64::from(x));
        let corner = Corner { from: Point2::new(z + 20.0, x), at: Point2::new(z, x), to: Point2::new(z, x + 20.0) };
        let placed = place(&shape, &corner, Reference::First, Allowance::default());
        prop_assume!(placed != Err(Fault::TooNarrow));
        let placed = placed.expect("an undercut");
        smooth(&placed, Vec2::y())?;
        let deepest = least(&placed, Vec2::y()) - x;
        prop_assert!((deepest + shape.depth()).abs() < 1e-6 && deepest >= -shape.depth() - 1e-9, "{deepest}");
        let behind = if let Shape::Recessed { face_depth, .. } = shape { face_depth } else { 0.0 };
        let furthest = least(&placed, Vec2::x()) - z;
        prop_assert!(furthest >= -behind - 1e-9 && furthest <= -behind + 1e-3, "{furthest} {behind}");
        for element in &placed.elements {
            if let Element::Arc { from, to, center, sweep } = *element {
                let r = distance(from, center);
                prop_assert!((r - distance(to, center)).abs() < 1e-9);
                prop_assert!((arc::sweep(from, to, center, sweep > 0.0) - sweep).abs() < 1e-9);
            }
        }
    }

    /// A mirrored corner gets the mirrored undercut, bit by bit, and the other direction the same backwards.
    #[test]
    fn mirrored_corners_get_mirrored_undercuts(shape in shape(), z in -500i32..0, x in 20i32..300) {
        let (z, x) = (f64::from(z), f64::from(x));
        let c = Corner { from: Point2::new(z + 20.0, x), at: Point2::new(z, x), to: Point2::new(z, x + 20.0) };
        let go = |c: &Corner| place(&shape, c, Reference::First, Allowance::default());
        let Ok(plain) = go(&c) else { return Ok(()) };
        let mirrors: [fn(Point2) -> Point2; 3] =
            [|p| Point2::new(-p.x, p.y), |p| Point2::new(p.x, -p.y), |p| Point2::new(-p.x, -p.y)];
        for (i, m) in mirrors.into_iter().enumerate() {
            let there = go(&Corner { from: m(c.from), at: m(c.at), to: m(c.to) }).expect("mirrored");
            prop_assert_eq!((there.leave, there.join), (m(plain.leave), m(plain.join)));
            for (a, b) in plain.elements.iter().zip(&there.elements) {
                prop_assert_eq!((m(a.from()), m(a.to())), (b.from(), b.to()));
                if let (Element::Arc { sweep: a, center: ca, .. }, Element::Arc { sweep: b, center: cb, .. }) = (a, b) {
                    prop_assert_eq!(m(*ca), *cb);
                    prop_assert_eq!(*b, if i == 2 { *a } else { -a });
                }
            }
        }
        let back = go(&Corner { from: c.to, at: c.at, to: c.from }).expect("backwards");
        prop_assert_eq!((back.leave, back.join), (plain.join, plain.leave));
        let turned: Vec<_> = back.elements.iter().rev().map(reversed).collect();
        prop_assert_eq!(turned, plain.elements);
    }
}

#[test]
fn numbers_out_of_range_are_told_apart() {
    let wedge =
        |depth, radius, opening, axis| Shape::Wedge { depth, radius, opening: Deg(opening), axis: Deg(axis) }.check();
    assert_eq!(wedge(1.0, 1.0, 30.0, 45.0), Ok(()));
    for (depth, radius) in [(0.0, 0.0), (1.0, -0.1), (1.0, 1.1), (f64::INFINITY, 0.5), (1.0, f64::NAN)] {
        assert_eq!(wedge(depth, radius, 30.0, 45.0), Err(Fault::Dimension), "{depth} {radius}");
    }
    // Each flank lies half the opening beside the axis: one would point out of the corner.
    for (opening, axis) in [(0.0, 45.0), (30.0, 15.0), (30.0, 10.0), (30.0, 75.0), (30.0, 80.0)] {
        assert_eq!(wedge(1.0, 0.5, opening, axis), Err(Fault::Angle), "{opening} {axis}");
    }
    let slope = |length, entry, radius| Shape::Slope { length, entry: Deg(entry), radius }.check();
    assert_eq!(slope(2.0, 89.9, 0.0), Ok(()));
    assert_eq!(slope(2.0, 90.0, 0.0), Err(Fault::Angle));
    assert_eq!(slope(2.0, 0.0, 0.0), Err(Fault::Angle));
    assert_eq!(slope(2.0, 30.0, f64::INFINITY), Err(Fault::Dimension));
    assert_eq!(slope(f64::INFINITY, 30.0, 0.0), Err(Fault::Dimension));
    let square =
        |entry| Shape::Square { length: 2.5, depth: 0.3, entry: Deg(entry), entry_radius: 0.6, corner_radius: 0.6 };
    assert_eq!(square(90.0).check(), Ok(()));
    assert_eq!(square(90.1).check(), Err(Fault::Angle));
    let groove = |radius, edge| Shape::Groove { width: 2.0, depth: 1.0, edge, radius }.check();
    assert_eq!(groove(0.0, Edge::Chamfer(0.0)), Ok(()));
    assert_eq!(groove(f64::INFINITY, Edge::Sharp), Err(Fault::Dimension));
    assert_eq!(groove(0.0, Edge::Round(-0.1)), Err(Fault::Dimension));
    let Shape::Recessed { length, depth, entry, entry_radius, corner_radius, face_depth, .. } = F else { panic!() };
    for face_angle in [Deg(0.0), Deg(90.0)] {
        let shape = Shape::Recessed { length, depth, entry, entry_radius, corner_radius, face_depth, face_angle };
        assert_eq!(shape.check(), Err(Fault::Angle));
    }
}

#[test]
fn every_length_is_scaled_and_no_angle() {
    let twice = |shape: Shape| shape.scaled(2.0);
    assert_eq!(
        twice(E),
        Shape::Square { length: 5.0, depth: 0.6, entry: Deg(15.0), entry_radius: 1.2, corner_radius: 1.2 }
    );
    let (entry, face_angle) = (Deg(15.0), Deg(8.0));
    let grown = Shape::Recessed {
        length: 5.0,
        depth: 0.6,
        entry,
        entry_radius: 1.2,
        corner_radius: 1.2,
        face_depth: 0.4,
        face_angle,
    };
    assert_eq!(twice(F), grown);
    for (edge, grown) in
        [(Edge::Sharp, Edge::Sharp), (Edge::Round(0.2), Edge::Round(0.4)), (Edge::Chamfer(0.3), Edge::Chamfer(0.6))]
    {
        assert_eq!(
            twice(Shape::Groove { width: 2.0, depth: 1.0, edge, radius: 0.25 }),
            Shape::Groove { width: 4.0, depth: 2.0, edge: grown, radius: 0.5 }
        );
    }
    let slope = Shape::Slope { length: 2.0, entry, radius: 0.75 };
    assert_eq!(twice(slope), Shape::Slope { length: 4.0, entry, radius: 1.5 });
    let (opening, axis) = (Deg(30.0), Deg(45.0));
    let wedge = Shape::Wedge { depth: 1.5, radius: 0.25, opening, axis };
    assert_eq!(twice(wedge), Shape::Wedge { depth: 3.0, radius: 0.5, opening, axis });
}
