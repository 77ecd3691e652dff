//! Undercuts and recesses of turned contours against a model of the part: every cut along a form lies inside of the part
//! without the form, or on its surface; where it would lie in the air, the form is refused.

use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// Printed coordinates have four decimals.
const NEAR: f64 = 2e-4;

/// Largest base radius of the undercuts of this test, mm.
const FILLET: f64 = 0.8;

type Point = (f64, f64);

/// A contour: points as (Z, X diameter), the material outside of it or towards the axis, where the tool stands.
struct Part {
    name: &'static str,
    points: &'static [Point],
    bore: bool,
    tool: Point,
    /// Places of inner corners and of outer ones.
    inner: &'static [usize],
    outer: &'static [usize],
}

const PARTS: &[Part] = &[
    Part {
        name: "shaft with a face",
        points: &[(0.0, 0.0), (0.0, 40.0), (-30.0, 40.0), (-30.0, 60.0), (-50.0, 60.0)],
        bore: false,
        tool: (3.0, 66.0),
        inner: &[2],
        outer: &[1, 3],
    },
    Part {
        name: "shaft with a collar",
        points: &[(0.0, 40.0), (-10.0, 40.0), (-10.0, 70.0), (-30.0, 70.0), (-30.0, 40.0), (-50.0, 40.0)],
        bore: false,
        tool: (3.0, 76.0),
        inner: &[1, 4],
        outer: &[2, 3],
    },
    Part {
        name: "stepped bore",
        points: &[(0.0, 60.0), (-20.0, 60.0), (-20.0, 40.0), (-50.0, 40.0)],
        bore: true,
        tool: (3.0, 30.0),
        inner: &[1],
        outer: &[2],
    },
    Part {
        name: "chamber of a bore",
        points: &[(0.0, 40.0), (-20.0, 40.0), (-20.0, 60.0), (-50.0, 60.0), (-50.0, 40.0), (-60.0, 40.0)],
        bore: true,
        tool: (3.0, 30.0),
        inner: &[2, 3],
        outer: &[1, 4],
    },
];

const UNDERCUTS: &[&str] = &[
    "H4 I0.5 K3 R0.3",
    "H4 I0.5 K3",
    "H4 I1 K3 R0.3 P0.4",
    "H4 I0.5 K3 P-0.4",
    "H0",
    "H5",
    "H5 I0.4 K4 R0.6 W20",
    "H6",
    "H6 P0.3 A10",
    "H7 I1.15 K5.2 R0.8",
    "H7 I1.15 K5.2 R0.8 W45",
];

/// The program that finishes the contour, with `form` behind the element that ends in the point `at`.
fn program(part: &Part, backwards: bool, at: usize, form: &str) -> String {
    let mut points: Vec<Point> = part.points.to_vec();
    let mut at = at;
    if backwards {
        points.reverse();
        at = points.len() - 1 - at;
    }
    let bore = if part.bore { "BLANK\nN1 G20 X100 Z70 K1 I39\n" } else { "" };
    let mut text = format!("HEADER\n#UNIT METRIC\n{bore}FINISHED PART\nN10 G0 X{} Z{}\n", points[0].1, points[0].0);
    for (i, point) in points.iter().enumerate().skip(1) {
        text.push_str(&format!("N{} G1 X{} Z{}\n", 10 + i, point.1, point.0));
        if i == at {
            text.push_str(&format!("N90 {form}\n"));
        }
    }
    // Beside the start of the contour.
    let tool = if backwards { (points[0].0 - 3.0, part.tool.1) } else { part.tool };
    text.push_str(&format!(
        "MACHINING\nN100 T1 G95 F0.2 G97 S800 M3\nN101 G0 X{} Z{}\nN102 G890 NS11 NE{} E0.1 O1 H4\nEND\n",
        tool.1,
        tool.0,
        9 + points.len()
    ));
    text
}

/// Is the point inside of the polygon or on it?
fn inside(polygon: &[Point], p: Point) -> bool {
    let mut odd = false;
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let way = (b.0 - a.0, b.1 - a.1);
        let length = (way.0 * way.0 + way.1 * way.1).sqrt();
        let along = ((p.0 - a.0) * way.0 + (p.1 - a.1) * way.1) / length;
        let along = along.clamp(0.0, length);
        let foot = (a.0 + way.0 / length * along, a.1 + way.1 / length * along);
        if (p.0 - foot.0).hypot(p.1 - foot.1) <= NEAR {
            return true;
        }
        if (a.1 > p.1) != (b.1 > p.1) && p.0 < a.0 + (p.1 - a.1) / way.1 * way.0 {
            odd = !odd;
        }
    }
    odd
}

/// The part without forms, X as radii: the contour, closed far away in the material.
fn material(part: &Part) -> Vec<Point> {
    let far = if part.bore { 1e3 } else { -1e3 };
    let mut polygon: Vec<Point> = part.points.iter().map(|p| (p.0, p.1 / 2.0)).collect();
    // Beyond the ends the part goes on.
    let (first, last) = (polygon[0], polygon[polygon.len() - 1]);
    polygon.insert(0, (first.0, far));
    polygon.push((last.0, far));
    polygon
}

/// Points along the cuts from the first to the last point of the contour, X as radii.
fn cuts(output: &str) -> Vec<Point> {
    let mut at = (0.0, 0.0);
    let mut list: Vec<Vec<Point>> = Vec::new();
    for line in output.lines() {
        let word = |letter: char| {
            line.split(' ').find_map(|w| w.strip_prefix(letter)).map(|v| v.parse::<f64>().expect("a number"))
        };
        let kind = line.split(' ').next().unwrap_or_default();
        let to = (word('Z').unwrap_or(at.0), word('X').unwrap_or(at.1));
        match kind {
            "G1" => list.push(
                (0..=8)
                    .map(|k| f64::from(k) / 8.0)
                    .map(|t| (at.0 + (to.0 - at.0) * t, at.1 + (to.1 - at.1) * t))
                    .collect(),
            ),
            "G2" | "G3" => {
                let center = (at.0 + word('K').expect("a centre"), at.1 + word('I').expect("a centre"));
                let (a, b) = ((at.1 - center.1).atan2(at.0 - center.0), (to.1 - center.1).atan2(to.0 - center.0));
                let tau = std::f64::consts::TAU;
                let sweep = if kind == "G3" { (b - a).rem_euclid(tau) } else { -(a - b).rem_euclid(tau) };
                let r = (at.0 - center.0).hypot(at.1 - center.1);
                list.push(
                    (0..=16)
                        .map(|k| a + sweep * f64::from(k) / 16.0)
                        .map(|w| (center.0 + r * w.cos(), center.1 + r * w.sin()))
                        .collect(),
                );
            }
            _ => {}
        }
        at = to;
    }
    // The first line leads down to the contour.
    list.into_iter().skip(1).flatten().collect()
}

fn compiled(text: &str) -> super::common::Compiled {
    // A nose of no radius: its point goes along the forms themselves.
    let settings = settings("[tools.1]\nradius = 0.0\n");
    compile_bytes("A.nc", text.as_bytes().to_vec(), "heidenhain-turning", &settings, &NoFiles)
}

/// The form is cut inside of the part, and deeper than the plain contour at least at one place.
fn check_cut(part: &Part, text: &str) {
    let compiled = compiled(text);
    assert!(!compiled.has_errors(), "{}: {text}{:#?}", part.name, compiled.rendered);
    let polygon = material(part);
    let points = cuts(&compiled.output);
    for p in &points {
        // A radius that is larger than the depth leaves a fillet in its inner corner (worked example 7: X40.6 above X40).
        let fillet = part.inner.iter().any(|at| {
            let corner = part.points[*at];
            (p.0 - corner.0).hypot(p.1 - corner.1 / 2.0) < FILLET
        });
        assert!(fillet || inside(&polygon, *p), "{}: {p:?} lies in the air\n{text}{}", part.name, compiled.output);
    }
    let contour: Vec<Point> = part.points.iter().map(|p| (p.0, p.1 / 2.0)).collect();
    let off = |p: &Point| {
        contour.windows(2).all(|w| {
            let way = (w[1].0 - w[0].0, w[1].1 - w[0].1);
            ((p.0 - w[0].0) * way.1 - (p.1 - w[0].1) * way.0).abs() / way.0.hypot(way.1) > 0.05
        })
    };
    assert!(points.iter().any(off), "{}: nothing is cut off\n{text}", part.name);
}

fn check_refused(part: &Part, text: &str) {
    let compiled = compiled(text);
    let codes = compiled.codes();
    let refused = codes.iter().any(|code| matches!(*code, "T3050" | "T3004"));
    assert!(refused && compiled.output.is_empty(), "{}: {text}{:#?}", part.name, compiled.rendered);
}

#[test]
fn undercuts_relieve_inner_corners_and_are_refused_at_outer_ones() {
    for part in PARTS {
        for form in UNDERCUTS {
            for backwards in [false, true] {
                for at in part.inner {
                    check_cut(part, &program(part, backwards, *at, &format!("G25 {form}")));
                }
                for at in part.outer {
                    check_refused(part, &program(part, backwards, *at, &format!("G25 {form}")));
                }
            }
        }
    }
}

/// Part, element that ends in this point, recess into the material, the same out of it.
const RECESSES: &[(usize, usize, &str, &str)] = &[
    (0, 2, "G22 Z-10 I34 K-16 B-0.5 R0.4", "G22 Z-10 I46 K-16 B-0.5 R0.4"),
    (0, 2, "G22 Z-10 II-6 KI-6", "G22 Z-10 II6 KI-6"),
    (0, 1, "G22 X20 I30 K-3", "G22 X20 I30 K3"),
    (1, 2, "G22 X50 II6 KI-2", "G22 X50 II6 KI2"),
    (2, 1, "G22 Z-5 I66 K-10", "G22 Z-5 I54 K-10"),
    (0, 2, "G23 H0 Z-15 U34 K6", "G23 H0 Z-15 U46 K6"),
    (2, 1, "G23 H0 Z-10 U66 K6 A30 R0.5", "G23 H0 Z-10 U54 K6 A30 R0.5"),
];

#[test]
fn recesses_go_into_the_material_and_are_refused_out_of_it() {
    for &(part, at, cut, ring) in RECESSES {
        let part = &PARTS[part];
        for backwards in [false, true] {
            // The element that ends in a point begins there in the other direction.
            let at = if backwards { at - 1 } else { at };
            check_cut(part, &program(part, backwards, at, cut));
            check_refused(part, &program(part, backwards, at, ring));
        }
    }
}

/// I of G23 counts to the right of the element, above 0: on a cone, seen in both directions.
#[test]
fn a_recess_in_a_cone_follows_the_sign_of_its_depth() {
    let cone = Part {
        name: "cone",
        points: &[(0.0, 40.0), (-30.0, 60.0), (-40.0, 60.0)],
        bore: false,
        tool: (3.0, 66.0),
        inner: &[],
        outer: &[],
    };
    for backwards in [false, true] {
        let (at, left) = if backwards { (0, "I2") } else { (1, "I-2") };
        let right = if backwards { "I-2" } else { "I2" };
        check_cut(&cone, &program(&cone, backwards, at, &format!("G23 H0 Z-15 {left} K5 A20 R0.3 B-0.3 P0.3")));
        check_refused(&cone, &program(&cone, backwards, at, &format!("G23 H0 Z-15 {right} K5 A20 R0.3")));
    }
}
