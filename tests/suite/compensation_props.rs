//! Radius compensation of contours at random, judged by a geometry of its own: the tool centre keeps its distance, the
//! contour is finished everywhere, and what is refused does not fit.

mod contours;
mod peers;
mod plane;

use core::f64::consts::TAU;

use partc::files::NoFiles;
use partc::{Program, Settings, compile};

use super::common::settings;
use super::damage::Dice;
use super::meant::{Found, Way};
use super::reader;
use contours::Contour;
use plane::{Curve, P, apart, nearest, sub};

/// How much nearer than the radius a path may come before it is a damage, in mm.
const DAMAGE: f64 = 2e-3;

/// Units of the last place that printed lines and arcs may lose.
const LINE: f64 = 1.0;
const ARC: f64 = 2.0;

#[derive(Debug, Default)]
struct Tally {
    contours: u64,
    clean: u64,
    wide: u64,
    refused: u64,
    damaged: u64,
    both_ways: u64,
    /// Largest loss of a line and of an arc, in units of the last place.
    lost: [f64; 2],
}

impl Tally {
    fn add(&mut self, other: &Tally) {
        self.contours += other.contours;
        self.clean += other.clean;
        self.wide += other.wide;
        self.refused += other.refused;
        self.damaged += other.damaged;
        self.both_ways += other.both_ways;
        self.lost = [self.lost[0].max(other.lost[0]), self.lost[1].max(other.lost[1])];
    }
}

/// What came of a contour.
enum Made {
    Refused(&'static str),
    /// The path of the centre between its ends, the places of the tool axis, and whether a damage was reported.
    Path(Vec<Curve>, Vec<f64>, bool),
}

fn made(contour: &Contour, settings: &Settings, decimals: u8) -> Result<Made, String> {
    let text = contour.text();
    let program = Program::in_language("klartext", "C.H", text.as_bytes()).map_err(|e| e.to_string())?;
    let compiled = std::panic::catch_unwind(|| compile(&program, settings, &NoFiles));
    let outcome = compiled.map_err(|_| "the compiler panics".to_owned())?.map_err(|e| e.to_string())?;
    let codes: Vec<&'static str> = outcome.findings.iter().map(|found| found.code).collect();
    let Some(output) = outcome.text else {
        return match codes.iter().find(|code| matches!(**code, "G3201" | "G3202")) {
            Some(code) => Ok(Made::Refused(code)),
            None => Err(format!("{:?}", outcome.findings)),
        };
    };
    let moves = reader::read(&output, decimals)?;
    let (path, heights) = path_of(&moves, contour.plane).ok_or_else(|| format!("no path in\n{output}"))?;
    Ok(Made::Path(path, heights, codes.contains(&"G3211")))
}

/// The moves in the plane between the first point beside the contour and the last one.
pub fn path_of(moves: &[Found], plane: usize) -> Option<(Vec<Curve>, Vec<f64>)> {
    let [a, b, c] = [[0, 1, 2], [2, 0, 1], [1, 2, 0]][plane];
    let ways: Vec<&Way> =
        moves.iter().filter_map(|found| if let Found::Move(way, _) = found { Some(way) } else { None }).collect();
    let [_, entry, rest @ .., _] = ways.as_slice() else { return None };
    let place = |way: &Way| [way.end()[a], way.end()[b]];
    let mut at = place(entry);
    let (mut path, mut heights) = (Vec::new(), vec![entry.end()[c]]);
    for way in rest {
        let to = place(way);
        let arc = match way {
            Way::Arc { center, turns, .. } => {
                let (from, to) = (sub(at, *center), sub(to, *center));
                let side = f64::from(turns.signum());
                let angle = ((to[1].atan2(to[0]) - from[1].atan2(from[0])) * side).rem_euclid(TAU);
                let part = if angle < 1e-9 { TAU } else { angle };
                Some((*center, side * part))
            }
            Way::Rapid(_) | Way::Feed(_) => None,
        };
        if arc.is_some() || apart(at, to) > 0.0 {
            path.push(Curve { from: at, to, arc });
        }
        at = to;
        heights.push(way.end()[c]);
    }
    if path.is_empty() {
        path.push(Curve::line(at, at));
    }
    heights.dedup_by(|x, y| (*x - *y).abs() < 1e-9);
    Some((path, heights))
}

/// Judges a path; the answer is its largest loss in units of the last place, of lines and of arcs.
fn judge(
    contour: &Contour,
    path: &[Curve],
    heights: &[f64],
    damaged: bool,
    unit: f64,
) -> Result<([f64; 2], bool), String> {
    let (curves, d) = contour.on_machine();
    let r = d.abs();
    let wide = plane::is_wide(&curves, d);
    let ends = |point: P, wanted: P, what: &str| {
        let off = apart(point, wanted);
        if off <= 1.5 * unit + 1e-6 { Ok(()) } else { Err(format!("the {what} is off by {off}")) }
    };
    ends(path[0].from, curves[0].beside(0.0, d), "start")?;
    ends(path[path.len() - 1].to, curves[curves.len() - 1].beside(1.0, d), "end")?;
    let mut lost = [0.0_f64; 2];
    for piece in path {
        let fine = (piece.length() / (0.02 * r)).clamp(400.0, 40_000.0) as u32;
        let steps = if damaged { fine } else { 12 };
        for k in 0..=steps {
            let share = f64::from(k) / f64::from(steps);
            let short = r - nearest(&curves, piece.at(share));
            let kind = usize::from(piece.arc.is_some());
            lost[kind] = lost[kind].max(short);
        }
    }
    let most = lost[0].max(lost[1]);
    if damaged {
        if wide {
            return Err("a damage is reported, and nothing is near".to_owned());
        }
        return if most >= DAMAGE - 3.0 * unit - 1e-4 {
            Ok(([0.0; 2], wide))
        } else {
            Err(format!("a damage is reported, and {most} is the most"))
        };
    }
    let slack = if wide { 1e-6 } else { DAMAGE };
    for (kind, units) in [LINE, ARC].into_iter().enumerate() {
        if lost[kind] > units * unit + slack {
            return Err(format!("the path is {} too near, wide: {wide}", lost[kind]));
        }
    }
    touches(&curves, path, d, 3.0 * unit + 1e-4)?;
    climbs(&contour.heights(), heights, unit)?;
    let share = |kind: usize| if wide { lost[kind] / unit } else { 0.0 };
    Ok(([share(0), share(1)], wide))
}

/// The tool axis goes to each height in turn, and nowhere else but in between: a small helix is printed in parts.
fn climbs(wanted: &[f64], heights: &[f64], unit: f64) -> Result<(), String> {
    let near = |a: f64, b: f64| (a - b).abs() <= unit;
    let mut next = 0;
    for height in heights {
        let between = |low: f64, high: f64| (low.min(high)..=low.max(high)).contains(height);
        if wanted.get(next).is_some_and(|z| near(*z, *height)) {
            next += 1;
        } else if !(next > 0 && wanted.get(next).is_some_and(|z| between(wanted[next - 1], *z))) {
            return Err(format!("the tool axis goes {heights:?} instead of {wanted:?}"));
        }
    }
    if next == wanted.len() { Ok(()) } else { Err(format!("the tool axis ends {heights:?} instead of {wanted:?}")) }
}

/// Everything that a tool can reach from beside an element is reached.
fn touches(curves: &[Curve], path: &[Curve], d: f64, tolerance: f64) -> Result<(), String> {
    for (i, element) in curves.iter().enumerate() {
        if element.room(d) < 0.0 {
            continue;
        }
        for k in 0..=16 {
            let p = element.beside(f64::from(k) / 16.0, d);
            if nearest(curves, p) < d.abs() - 1e-7 {
                continue;
            }
            let off = nearest(path, p);
            if off > tolerance {
                return Err(format!("element {i} is not finished at {p:?}: the path passes at {off}"));
            }
        }
    }
    Ok(())
}

/// Every point of each path lies on the other.
pub fn same_points(one: &[Curve], other: &[Curve], tolerance: f64) -> Result<(), String> {
    for (a, b) in [(one, other), (other, one)] {
        for piece in a {
            for k in 0..=8 {
                let p = piece.at(f64::from(k) / 8.0);
                let off = nearest(b, p);
                if off > tolerance {
                    return Err(format!("{p:?} is off by {off}"));
                }
            }
        }
    }
    Ok(())
}

fn one(dice: &mut Dice, tally: &mut Tally) -> Result<(), Box<(Contour, String)>> {
    let contour = Contour::random(dice);
    let decimals = [3, 4, 6][dice.roll(3)];
    let unit = 0.1f64.powi(i32::from(decimals));
    let settings = settings(&format!("[output]\ndecimals = {decimals}\n[tools.1]\nradius = {:?}\n", contour.radius));
    tally.contours += 1;
    let fails = |why: String| Box::new((contour.clone(), why));
    let (curves, d) = contour.on_machine();
    let forward = made(&contour, &settings, decimals).map_err(fails)?;
    let backward = contour.reversed();
    let back = made(&backward, &settings, decimals).map_err(|why| Box::new((backward.clone(), why)))?;
    for (contour, made) in [(&contour, &forward), (&backward, &back)] {
        let fails = |why: String| Box::new((contour.clone(), why));
        match made {
            Made::Refused("G3201") => {
                tally.refused += 1;
                let least = curves.iter().map(|curve| curve.room(d)).fold(f64::INFINITY, f64::min);
                if least > 1e-9 {
                    return Err(fails(format!("G3201, and the smallest hollow arc leaves {least}")));
                }
            }
            Made::Refused(code) => {
                tally.refused += 1;
                if plane::is_wide(&curves, d) {
                    return Err(fails(format!("{code}, and the contour is wide")));
                }
            }
            Made::Path(path, heights, damaged) => {
                let (lost, wide) = judge(contour, path, heights, *damaged, unit).map_err(fails)?;
                tally.add(&Tally {
                    clean: u64::from(!damaged),
                    damaged: u64::from(*damaged),
                    wide: u64::from(wide),
                    lost,
                    ..Tally::default()
                });
            }
        }
    }
    if let (Made::Path(one, _, false), Made::Path(other, _, false)) = (&forward, &back) {
        tally.both_ways += 1;
        same_points(one, other, 3.0 * unit + 1e-5).map_err(fails)?;
    }
    Ok(())
}

/// Contours of one seed; the first one that fails, with its program.
fn run(seed: u64, count: u64) -> (Tally, Vec<String>) {
    let (mut tally, mut failures) = (Tally::default(), Vec::new());
    for i in 0..count {
        let mut dice = Dice((seed.wrapping_mul(1_000_003).wrapping_add(i) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..4 {
            dice.roll(2);
        }
        if let Err(failed) = one(&mut dice, &mut tally) {
            let (contour, why) = *failed;
            failures.push(format!("contour {i} of {seed}: {why}\nradius {}\n{}", contour.radius, contour.text()));
            if failures.len() >= 5 {
                break;
            }
        }
    }
    (tally, failures)
}

/// `PARTC_CONTOURS` says how many, `PARTC_CONTOURS_SEED` which.
#[test]
fn paths_beside_random_contours() {
    let from = |name: &str, or: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(or);
    let (count, seed) = (from("PARTC_CONTOURS", 800), from("PARTC_CONTOURS_SEED", 1));
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let parts: Vec<(Tally, Vec<String>)> = std::thread::scope(|scope| {
        let work = |k: u64| scope.spawn(move || run(seed * 64 + k, count.div_ceil(threads)));
        let parts: Vec<_> = (0..threads).map(work).collect();
        parts.into_iter().map(|part| part.join().expect("a part")).collect()
    });
    let mut tally = Tally::default();
    parts.iter().for_each(|(part, _)| tally.add(part));
    let failures: Vec<&str> = parts.iter().flat_map(|(_, list)| list).map(String::as_str).collect();
    println!("{tally:?}");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(tally.wide * 8 > tally.contours && tally.both_ways > 0, "{tally:?}");
}
