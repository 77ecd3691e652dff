//! Faces and mantles at random, read back from the printed X, Z, C and F: the machine stays within the tolerance of the
//! programmed contour, meets its ends, and follows it at the programmed feed.

use core::f64::consts::{PI, TAU};

use partc::files::NoFiles;
use partc::{Program, Settings, compile};

use super::common::settings;
use super::damage::Dice;
use super::meant::{Found, Kind, Way};
use super::reader;

/// How far a path may leave the contour, and what rounding of X and C adds at a radius of 150, in mm.
const OFF: f64 = 0.005 + 2e-4;
/// How far an end may lie from where it was programmed, by rounding alone.
const END: f64 = 2e-4;
/// Programmed feed.
const FEED: f64 = 200.0;
/// Diameter of the mantle.
const MANTLE: f64 = 80.0;

type P = [f64; 3];

/// An element of the plane, and its way in Z.
#[derive(Debug, Clone, Copy)]
struct Element {
    from: P,
    to: P,
    /// Centre and signed sweep.
    arc: Option<([f64; 2], f64)>,
}

impl Element {
    fn at(&self, t: f64) -> P {
        let line = |i: usize| self.from[i] + (self.to[i] - self.from[i]) * t;
        match self.arc {
            None => [line(0), line(1), line(2)],
            Some((c, sweep)) => {
                let (x, y) = (self.from[0] - c[0], self.from[1] - c[1]);
                let (sin, cos) = (sweep * t).sin_cos();
                [c[0] + x * cos - y * sin, c[1] + x * sin + y * cos, line(2)]
            }
        }
    }

    fn length(&self) -> f64 {
        let rise = self.to[2] - self.from[2];
        match self.arc {
            None => (self.to[0] - self.from[0]).hypot(self.to[1] - self.from[1]).hypot(rise),
            Some((c, sweep)) => ((self.from[0] - c[0]).hypot(self.from[1] - c[1]) * sweep).hypot(rise),
        }
    }

    /// Does it pass the axis of rotation too closely, by far or by a little?
    fn closest(&self) -> f64 {
        (0..=4000).map(|i| self.at(f64::from(i) / 4000.0)).map(|p| p[0].hypot(p[1])).fold(f64::INFINITY, f64::min)
    }
}

fn block(element: &Element, axes: [char; 2], centre: [char; 2], rapid: bool) -> String {
    let [x, y, z] = element.to;
    let [a, b] = axes;
    let rest = ['X', 'Y', 'Z'].into_iter().find(|axis| !axes.contains(axis)).expect("a third axis");
    match element.arc {
        None if rapid => format!("G0 {a}{x:.4} {b}{y:.4} {rest}{z:.4}\n"),
        None => format!("G1 {a}{x:.4} {b}{y:.4} {rest}{z:.4}\n"),
        Some((c, sweep)) => {
            let g = if sweep > 0.0 { "G3" } else { "G2" };
            let [i, j] = [c[0] - element.from[0], c[1] - element.from[1]];
            format!("{g} {a}{x:.9} {b}{y:.9} {rest}{z:.4} {}{i:.9} {}{j:.9}\n", centre[0], centre[1])
        }
    }
}

/// From 0 to 1.
fn share(dice: &mut Dice) -> f64 {
    dice.roll(1_000_001) as f64 / 1e6
}

fn rounded(v: f64) -> f64 {
    (v * 1e3).round() / 1e3
}

/// Elements one behind the other, in two coordinates of up to `size` and one of depth.
fn contour(dice: &mut Dice, size: f64, near_pole: bool, depth: f64) -> Vec<Element> {
    let coordinate = |dice: &mut Dice| rounded((share(dice) * 2.0 - 1.0) * size);
    let mut from = [coordinate(dice), coordinate(dice), rounded(depth)];
    let mut made = Vec::new();
    for _ in 0..=dice.roll(6) {
        let mut to = [coordinate(dice), coordinate(dice), from[2]];
        if near_pole && dice.roll(3) == 0 {
            to = [rounded(from[0] * -0.5 + share(dice)), rounded(from[1] * -0.5 + share(dice)), from[2]];
        }
        if dice.roll(3) == 0 {
            to[2] = rounded(depth - 2.0 * share(dice));
        }
        let mut element = Element { from, to, arc: None };
        if dice.roll(2) == 0 {
            let c = [coordinate(dice), coordinate(dice)];
            let sweep = (share(dice) * 2.0 - 1.0) * TAU * 0.95;
            element.arc = Some((c, sweep));
            let end = element.at(1.0);
            element.to = [end[0], end[1], to[2]];
            if sweep.abs() < 0.05 || (from[0] - c[0]).hypot(from[1] - c[1]) < 0.5 {
                continue;
            }
        }
        if element.length() < 0.01 {
            continue;
        }
        made.push(element);
        from = element.to;
    }
    made
}

/// The blocks behind the position at the start, with X, Z and C, and their time in minutes.
fn read(text: &str, settings: &Settings) -> Result<Vec<(P, Option<f64>)>, String> {
    let program = Program::in_language("sinumerik", "F.MPF", text.as_bytes()).map_err(|e| e.to_string())?;
    let outcome = compile(&program, settings, &NoFiles).map_err(|e| e.to_string())?;
    let Some(output) = outcome.text else { return Err(format!("{:?}", outcome.findings)) };
    let mut at: Option<P> = None;
    let mut moves: Vec<(P, Option<f64>)> = Vec::new();
    for found in reader::read(&output, 4)? {
        let Found::Move(way, how) = found else { continue };
        let end = match way {
            Way::Rapid(end) | Way::Feed(end) => [end[0], end[2], end[5]],
            Way::Arc { .. } => return Err(format!("an arc in\n{output}")),
        };
        let time = how.feed.and_then(|(kind, feed)| {
            let from = at?;
            let linear = (end[0] - from[0]).hypot(end[1] - from[1]);
            let measured = if linear > 0.0 { linear } else { (end[2] - from[2]).abs() };
            assert_eq!(kind, Kind::PerMinute);
            Some(measured / feed)
        });
        // A step of X or Z that would make F too coarse has a block of its own.
        let step = at.map(|at| (end[0] - at[0]).hypot(end[1] - at[1])).filter(|step| *step > 0.0);
        if step.is_some_and(|step| step < 0.00051)
            && at.is_some_and(|at| at[2] == end[2])
            && let Some((before, spent)) = moves.last_mut()
        {
            *before = end;
            *spent = spent.zip(time).map(|(a, b)| a + b);
        } else {
            moves.push((end, time));
        }
        at = Some(end);
    }
    Ok(moves)
}

/// Follows the elements with the printed moves; `place` leads from X, Z and C to the plane.
fn follow(elements: &[Element], moves: &[(P, Option<f64>)], place: &dyn Fn(P) -> P, rapid: bool) -> Result<(), String> {
    let apart = |a: P, b: P| (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
    let mut moves = moves.iter();
    let mut at = moves.next().ok_or("no first place")?.0;
    for element in elements {
        // The parts of an element are even: how many there are shows where it ends.
        let rest: Vec<_> = moves.as_slice().to_vec();
        let count = (1..=rest.len())
            .find(|n| {
                apart(place(rest[n - 1].0), element.to) <= END
                    && (1..*n).all(|i| apart(place(rest[i - 1].0), element.at(i as f64 / *n as f64)) <= END)
            })
            .ok_or_else(|| format!("nothing ends at {:?}", element.to))?;
        let mut time = 0.0;
        for part in 0..count {
            let (end, needs) = *moves.next().ok_or("no move")?;
            for look in 0..=32 {
                let u = f64::from(look) / 32.0;
                let made = place([0, 1, 2].map(|i| at[i] + (end[i] - at[i]) * u));
                let wanted = element.at((part as f64 + u) / count as f64);
                if apart(made, wanted) > OFF {
                    return Err(format!("{:.5} mm off at {wanted:?}", apart(made, wanted)));
                }
            }
            time += needs.unwrap_or(0.0);
            at = end;
        }
        let wanted = element.length() / FEED;
        if !rapid && (time - wanted).abs() > wanted * 2e-3 {
            return Err(format!("{time} minutes instead of {wanted} for {element:?}"));
        }
    }
    match moves.next() {
        None => Ok(()),
        Some(more) => Err(format!("one move more: {more:?}")),
    }
}

fn polar() -> Settings {
    settings("[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[cycles]\ntransmit = \"polar\"\n")
}

fn rounds() -> u64 {
    std::env::var("PARTC_CONTOURS").ok().and_then(|n| n.parse().ok()).unwrap_or(150)
}

#[test]
fn a_face_is_followed_within_its_tolerance_at_its_feed() {
    let settings = polar();
    let (mut made, mut refused) = (0, 0);
    for round in 0..rounds() {
        let mut dice = Dice(0x9E37_79B9_7F4A_7C15 ^ round);
        let elements = contour(&mut dice, 40.0, true, -1.0);
        let Some(first) = elements.first() else { continue };
        let rapid = elements.iter().all(|element| element.arc.is_none()) && round % 2 == 0;
        let [x, y, z] = first.from;
        let mut text = format!("G18 G90 G94 DIAMOF F{FEED}\nTRANSMIT\nG17\nG0 X{x} Y{y} Z{z}\n");
        elements.iter().for_each(|element| text += &block(element, ['X', 'Y'], ['I', 'J'], rapid));
        text += "TRAFOOF\nM30\n";
        let closest = elements.iter().map(Element::closest).fold(f64::INFINITY, f64::min);
        let place = |[x, z, c]: P| [x * c.to_radians().cos(), x * c.to_radians().sin(), z];
        match read(&text, &settings) {
            Err(found) if closest < 0.0125 && found.contains("G3337") => refused += 1,
            Err(found) => panic!("round {round}: {found}\n{text}"),
            Ok(_) if closest < 0.0075 => panic!("round {round}: passes the pole at {closest}\n{text}"),
            Ok(moves) => {
                if let Err(why) = follow(&elements, &moves, &place, rapid) {
                    panic!("round {round}: {why}\n{text}");
                }
                made += 1;
            }
        }
    }
    assert!(made > rounds() / 2, "{made} made, {refused} refused");
}

#[test]
fn a_mantle_is_followed_within_its_tolerance_at_its_feed() {
    let settings = polar();
    for round in 0..rounds() {
        let mut dice = Dice(0x9E37_79B9_7F4A_7C15 ^ round);
        // Y and Z of the plane, and X.
        let elements = contour(&mut dice, 60.0, false, 38.0);
        let Some(first) = elements.first() else { continue };
        let [y, z, x] = first.from;
        let mut text = format!("G18 G90 G94 DIAMOF F{FEED}\nTRACYL({MANTLE})\nG19\nG0 X{x} Y{y} Z{z}\n");
        elements.iter().for_each(|element| text += &block(element, ['Y', 'Z'], ['J', 'K'], false));
        text += "TRAFOOF\nM30\n";
        let place = |[x, z, c]: P| [c * PI * MANTLE / 360.0, z, x];
        let moves = read(&text, &settings).unwrap_or_else(|found| panic!("round {round}: {found}\n{text}"));
        if let Err(why) = follow(&elements, &moves, &place, false) {
            panic!("round {round}: {why}\n{text}");
        }
    }
}
