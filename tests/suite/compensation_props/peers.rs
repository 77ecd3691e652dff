//! Others who compute paths beside contours: a library for closed ones, and LinuxCNC's own compensation.

use cavalier_contours::polyline::{PlineSource, PlineSourceMut, Polyline};
use core::f64::consts::PI;

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;
use partc::{Program, trace};
use serde_json::Value;

use super::super::common::{compile_bytes, settings};
use super::super::damage::Dice;
use super::super::reader;
use super::super::rs274::{self, Job};
use super::plane::{self, Curve, P, add, apart, left, towards};
use super::{path_of, same_points};

/// 4 mm, as the table of the interpreter counts: in inches.
const DIAMETER: &str = "0.157480314960629921";

/// A closed contour of lines and arcs, about a polygon whose corners lie around the origin; it begins within a line.
fn closed(dice: &mut Dice) -> Vec<Curve> {
    let real = |dice: &mut Dice, least: f64, most: f64| {
        least + (most - least) * dice.roll(1 << 20) as f64 / f64::from(1 << 20)
    };
    let n = 3 + dice.roll(6);
    let corners: Vec<P> = (0..n)
        .map(|i| {
            let angle = (i as f64 + real(dice, 0.2, 0.8)) / n as f64 * 2.0 * PI;
            add([0.0; 2], towards(angle), real(dice, 12.0, 40.0)).map(|v| (v * 1000.0).round() / 1000.0)
        })
        .collect();
    let mut contour = Vec::new();
    for i in 0..n {
        let (from, to) = (corners[i], corners[(i + 1) % n]);
        if i == 0 {
            let middle = add(from, plane::sub(to, from), 0.5);
            contour.push(Curve::line(middle, to));
        } else if dice.roll(2) == 0 {
            contour.push(Curve::line(from, to));
        } else {
            let sweep = real(dice, 0.1, 1.4) * if dice.roll(2) == 0 { 1.0 } else { -1.0 };
            let chord = plane::sub(to, from);
            let center = add(add(from, chord, 0.5), left(chord), 0.5 / (sweep / 2.0).tan());
            contour.push(Curve { from, to, arc: Some((center, sweep)) });
        }
    }
    let first = contour[0].from;
    contour.push(Curve::line(corners[0], first));
    contour
}

/// The contour in Klartext, from within its first line once around.
fn text(contour: &[Curve], left: bool) -> String {
    let start = contour[0].from;
    let far = add(start, plane::left(contour[0].heading(0.0)), if left { 30.0 } else { -30.0 });
    let place = |p: P| format!("X{:+.12} Y{:+.12}", p[0], p[1]);
    let side = if left { "RL" } else { "RR" };
    let mut text = format!(
        "0 BEGIN PGM C MM\nTOOL CALL 1 Z S1000\nL {} Z+5 R0 FMAX M3\nL {} {side} F500\n",
        place(far),
        place(start)
    );
    for curve in contour {
        text += &match curve.arc {
            None => format!("L {}\n", place(curve.to)),
            Some((center, sweep)) => {
                format!("CC {}\nC {} DR{}\n", place(center), place(curve.to), if sweep > 0.0 { '+' } else { '-' })
            }
        };
    }
    text + &format!("L {} R0\nEND PGM C MM\n", place(far))
}

/// What the library finds, if it is one path.
fn of_library(contour: &[Curve], d: f64) -> Option<Vec<Curve>> {
    let mut closed = Polyline::new_closed();
    for curve in contour {
        closed.add(curve.from[0], curve.from[1], curve.arc.map_or(0.0, |(_, sweep)| (sweep / 4.0).tan()));
    }
    let found = closed.parallel_offset(d);
    let [path] = found.as_slice() else { return None };
    let corners: Vec<(P, f64)> = path.iter_vertexes().map(|v| ([v.x, v.y], v.bulge)).collect();
    let curve = |i: usize| {
        let ((from, bulge), (to, _)) = (corners[i], corners[(i + 1) % corners.len()]);
        let sweep = 4.0 * bulge.atan();
        let chord = plane::sub(to, from);
        let center = add(add(from, chord, 0.5), left(chord), 0.5 / (sweep / 2.0).tan());
        Curve { from, to, arc: (bulge.abs() > 1e-12).then_some((center, sweep)) }
    };
    Some((0..corners.len()).map(curve).collect())
}

/// The path of the centre as it is before numbers are rounded to print them.
fn traced(text: &str, settings: &Settings) -> Option<Vec<Curve>> {
    let program = Program::in_language("klartext", "C.H", text.as_bytes()).ok()?;
    let outcome = trace(&program, settings, &partc::files::NoFiles).ok()?;
    let list = outcome.text?;
    let moves: Vec<Value> = list.lines().map(|line| serde_json::from_str(line).expect("a move")).collect();
    let [_, _, path @ .., _] = moves.as_slice() else { return None };
    let place = |p: &Value| Some([p["X"].as_f64()?, p["Y"].as_f64()?]);
    let curve = |mv: &Value| {
        let arc = place(&mv["center"]).zip(mv["sweep_deg"].as_f64().map(f64::to_radians));
        Some(Curve { from: place(&mv["start"])?, to: place(&mv["end"])?, arc })
    };
    path.iter().map(curve).collect()
}

#[test]
fn closed_contours_have_the_path_of_cavalier_contours() {
    let (mut compared, mut dice) = (0, Dice(0x00C0_FFEE));
    for _ in 0..400 {
        let contour = closed(&mut dice);
        let is_left = dice.roll(2) == 0;
        let radius = 0.5 + dice.roll(5000) as f64 / 1000.0;
        let d = if is_left { radius } else { -radius };
        let around: Vec<Curve> = contour[..contour.len() - 1].to_vec();
        if !plane::is_wide(&around, d) || contour.iter().any(|curve| curve.length() < 0.01) {
            continue;
        }
        let Some(wanted) = of_library(&contour, d) else { continue };
        let settings = settings(&format!("[tools.1]\nradius = {radius:?}\n"));
        let text = text(&contour, is_left);
        let compiled = compile_bytes("C.H", text.clone().into_bytes(), "klartext", &settings, &NoFiles);
        if compiled.codes().contains(&"G3211") || compiled.has_errors() {
            continue;
        }
        let path = traced(&text, &settings).expect("a path");
        assert!(apart(path[0].from, path[path.len() - 1].to) < 1e-6, "{text}");
        if let Err(why) = same_points(&path, &wanted, 1e-6) {
            panic!("{why}, radius {radius}\n{text}");
        }
        compared += 1;
    }
    println!("{compared} contours compared");
    assert!(compared > 100, "only {compared}");
}

/// From the end of the first element on LinuxCNC's compensation is the same: only its way to the contour is another.
#[test]
fn linuxcnc_compensates_alike() {
    if !rs274::available() {
        return;
    }
    let mut dice = Dice(0x0BAD_CAFE);
    let mut programs = Vec::new();
    while programs.len() < 120 {
        let contour = closed(&mut dice);
        let is_left = dice.roll(2) == 0;
        let d = if is_left { 2.0 } else { -2.0 };
        // Inside corners below 0.05 rad are none for LinuxCNC.
        let flat = |pair: &[Curve]| (1e-6..0.06).contains(&plane::turn(&pair[0], &pair[1]).abs());
        if !plane::is_wide(&contour[..contour.len() - 1], d) || contour.windows(2).any(flat) {
            continue;
        }
        let compile = |how: &str| {
            let settings = settings(&format!("[output]\ncompensation = \"{how}\"\n[tools.1]\nradius = 2.0\n"));
            compile_bytes("C.H", text(&contour, is_left).into_bytes(), "klartext", &settings, &NoFiles)
        };
        let (own, theirs) = (compile("resolve"), compile("control"));
        if !own.has_errors() && !theirs.has_errors() && !own.codes().contains(&"G3211") {
            programs.push((own.output, theirs.output, contour.len()));
        }
    }
    let jobs: Vec<Job<'_>> =
        programs.iter().map(|(_, theirs, _)| Job { program: theirs, diameter: DIAMETER }).collect();
    let (mut compared, mut refusals) = (0, Vec::new());
    for ((own, theirs, _), answer) in programs.iter().zip(rs274::interpret_all(&jobs)) {
        let found = match answer {
            Ok(found) => found,
            Err(why) => {
                refusals.push(why);
                continue;
            }
        };
        let own_moves = reader::read(own, 4).expect("a program");
        let (path, _) = path_of(&own_moves, 0).expect("a path");
        let (other, _) = path_of(&found, 0).expect("a path");
        // Where the first element ends.
        let Some(begin) = other.iter().position(|curve| apart(curve.to, path[0].to) < 3e-4) else {
            panic!("the first element ends elsewhere\n{own}\n{theirs}\n{other:?}")
        };
        if let Err(why) = same_points(&path[1..], &other[begin + 1..], 1e-3) {
            panic!("{why}\n{own}\n{theirs}");
        }
        compared += 1;
    }
    println!("{compared} of {} programs compared", programs.len());
    assert!(compared > 40, "only {compared}: {:?}", refusals.first());
}
