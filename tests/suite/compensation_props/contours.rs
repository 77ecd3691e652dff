//! Contours at random, as Klartext programs.

use core::f64::consts::{PI, TAU};
use core::fmt::Write as _;

use super::super::damage::Dice;
use super::plane::{Curve, Map, P, add, apart, dot, left, norm, sub, towards, turn, unit};

/// Letters of the plane, of the axis that is perpendicular to it.
pub const PLANES: [[char; 3]; 3] = [['X', 'Y', 'Z'], ['Z', 'X', 'Y'], ['Y', 'Z', 'X']];

/// How an element is written, and what follows it.
#[derive(Debug, Clone)]
struct Element {
    curve: Curve,
    /// Way of the tool axis along it.
    rise: f64,
    /// `RND` or `CHF` behind it.
    corner: Option<Corner>,
    /// A plunge behind it.
    plunge: Option<f64>,
}

#[derive(Debug, Clone, Copy)]
enum Corner {
    Rounding(f64),
    Chamfer(f64),
}

#[derive(Debug, Clone)]
pub struct Contour {
    elements: Vec<Element>,
    pub left: bool,
    pub radius: f64,
    pub plane: usize,
    pub map: Map,
    transformed: bool,
    /// Decimals of the program.
    digits: usize,
    start: P,
    end: P,
}

fn real(dice: &mut Dice, least: f64, most: f64) -> f64 {
    least + (most - least) * dice.roll(1 << 24) as f64 / f64::from(1 << 24)
}

fn rounded(p: P, digits: usize) -> P {
    p.map(|v| number(v, digits))
}

fn number(v: f64, digits: usize) -> f64 {
    format!("{v:.digits$}").parse().expect("a number")
}

impl Contour {
    pub fn random(dice: &mut Dice) -> Contour {
        let digits = if dice.roll(3) == 0 { 3 } else { 9 };
        let mut elements: Vec<Element> = Vec::new();
        let mut heading = real(dice, -PI, PI);
        let mut at = rounded([real(dice, -50.0, 50.0), real(dice, -50.0, 50.0)], digits);
        for _ in 0..1 + dice.roll(7) {
            let turn = match dice.roll(8) {
                0 | 1 => 0.0,
                2 => [PI / 2.0, -PI / 2.0][dice.roll(2)],
                3 => real(dice, -3.0, 3.0),
                _ => real(dice, -2.0, 2.0),
            };
            heading += turn;
            let curve =
                if dice.roll(2) == 0 { line(dice, at, heading, digits) } else { arc(dice, at, heading, digits) };
            let Some(curve) = curve else { continue };
            let rise = if dice.roll(6) == 0 { number(real(dice, -3.0, 3.0), 3) } else { 0.0 };
            let plunge = (dice.roll(12) == 0).then(|| number(real(dice, -3.0, 3.0), 3));
            let out = curve.heading(1.0);
            (at, heading) = (curve.to, out[1].atan2(out[0]));
            elements.push(Element { curve, rise, corner: None, plunge });
        }
        if elements.is_empty() {
            elements.push(Element {
                curve: Curve::line(at, [at[0] + 10.0, at[1]]),
                rise: 0.0,
                corner: None,
                plunge: None,
            });
        }
        corners(dice, &mut elements);
        let transformed = dice.roll(3) == 0;
        let map = if transformed {
            let angle = number([0.0, 90.0, real(dice, -360.0, 360.0)][dice.roll(3)], 3);
            let shift = [real(dice, -99.0, 99.0), real(dice, -99.0, 99.0)].map(|v| number(v, 3));
            Map { shift, mirror: [dice.roll(2) == 0, dice.roll(2) == 0], angle: angle.to_radians() }
        } else {
            Map { shift: [0.0; 2], mirror: [false; 2], angle: 0.0 }
        };
        let mut contour = Contour {
            elements,
            left: dice.roll(2) == 0,
            radius: 1.0,
            plane: dice.roll(3),
            map,
            transformed,
            digits,
            start: [0.0; 2],
            end: [0.0; 2],
        };
        contour.radius = contour.some_radius(dice);
        contour.borders(dice);
        contour
    }

    /// Mostly one that fits into all hollow arcs, at times exactly the smallest of them.
    fn some_radius(&self, dice: &mut Dice) -> f64 {
        let side = if self.left { 1.0 } else { -1.0 };
        let hollow = self.programmed().into_iter().filter_map(|curve| {
            curve.arc.filter(|(_, sweep)| sweep * side > 0.0).map(|(center, _)| apart(curve.from, center))
        });
        let least = hollow.fold(f64::INFINITY, f64::min);
        match dice.roll(12) {
            0 if least < 12.0 => number(least, 6),
            1 => number(real(dice, 0.2, 12.0), 3),
            _ => number(real(dice, 0.2, least.min(6.0)), 3).max(0.1),
        }
    }

    /// Where the ways to the contour and from it begin and end.
    fn borders(&mut self, dice: &mut Dice) {
        let (first, last) = (self.elements[0].curve, self.elements[self.elements.len() - 1].curve);
        let far = |p: P, dice: &mut Dice| add(p, towards(real(dice, -PI, PI)), real(dice, 30.0, 60.0));
        (self.start, self.end) = (rounded(far(first.from, dice), 3), rounded(far(last.to, dice), 3));
    }

    /// The same contour from its end to its start, on the other side.
    pub fn reversed(&self) -> Contour {
        let mut other = self.clone();
        other.elements.reverse();
        let n = other.elements.len();
        for (i, element) in other.elements.iter_mut().enumerate() {
            element.curve = element.curve.reversed();
            element.rise = -element.rise;
            // What stood behind an element stands behind its neighbour now.
            let before = (i + 1 < n).then(|| &self.elements[n - 2 - i]);
            element.corner = before.and_then(|e| e.corner);
            element.plunge = before.and_then(|e| e.plunge).map(|z| -z);
        }
        other.left = !self.left;
        (other.start, other.end) = (self.end, self.start);
        other
    }

    /// The contour with its corners cut, as it is programmed.
    fn programmed(&self) -> Vec<Curve> {
        let mut out: Vec<Curve> = Vec::new();
        let mut from = self.elements[0].curve.from;
        for (i, element) in self.elements.iter().enumerate() {
            let mut curve = Curve { from, ..element.curve };
            let after = self.elements.get(i + 1).map(|next| next.curve);
            from = curve.to;
            if let (Some(corner), Some(next)) = (element.corner, after) {
                let (a, b) = (curve.heading(1.0), next.heading(0.0));
                let turn = turn(&curve, &next);
                let cut = match corner {
                    Corner::Rounding(r) => r * (turn.abs() / 2.0).tan(),
                    Corner::Chamfer(side) => side,
                };
                let (p, q) = (add(curve.to, a, -cut), add(curve.to, b, cut));
                curve.to = p;
                out.push(curve);
                out.push(match corner {
                    Corner::Rounding(r) => {
                        Curve { from: p, to: q, arc: Some((add(p, left(a), r * turn.signum()), turn)) }
                    }
                    Corner::Chamfer(_) => Curve::line(p, q),
                });
                from = q;
            } else {
                out.push(curve);
            }
        }
        out
    }

    /// The contour as it lies on the machine, and the signed distance of the tool centre.
    pub fn on_machine(&self) -> (Vec<Curve>, f64) {
        let curves = self.programmed().iter().map(|curve| curve.mapped(&self.map)).collect();
        (curves, self.radius * if self.left { 1.0 } else { -1.0 } * self.map.sign())
    }

    /// Places of the tool axis, one after the other.
    pub fn heights(&self) -> Vec<f64> {
        let mut z = 5.0;
        let mut list = vec![z];
        for element in &self.elements {
            list.push(z + element.rise);
            z += element.rise + element.plunge.unwrap_or(0.0);
            list.push(z);
        }
        list.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        list
    }

    pub fn text(&self) -> String {
        let [a, b, c] = PLANES[self.plane];
        let n = self.digits;
        let place = |p: P| format!("{a}{:+.n$} {b}{:+.n$}", p[0], p[1]);
        let mut text = format!("0 BEGIN PGM C MM\nTOOL CALL 1 {c} S1000\n");
        if self.transformed {
            let Map { shift, mirror, angle } = self.map;
            let axes: String = [a, b].iter().zip(mirror).filter(|(_, on)| *on).map(|(c, _)| format!(" {c}")).collect();
            let _ = write!(
                text,
                "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 {a}{:+} {b}{:+}\nCYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1{axes}\n\
                 CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{:+.3}\n",
                shift[0],
                shift[1],
                angle.to_degrees(),
            );
        }
        let first = self.elements[0].curve.from;
        let side = if self.left { "RL" } else { "RR" };
        let _ = write!(text, "L {} {c}+5 R0 FMAX M3\nL {} {side} F500\n", place(self.start), place(first));
        for element in &self.elements {
            let rise = if element.rise == 0.0 { String::new() } else { format!(" I{c}{:+}", element.rise) };
            let _ = match element.curve.arc {
                None => writeln!(text, "L {}{rise}", place(element.curve.to)),
                Some((center, sweep)) => {
                    let sign = if sweep > 0.0 { '+' } else { '-' };
                    if element.rise != 0.0 {
                        let (x, y) = (center[0], center[1]);
                        let angle = sweep.to_degrees();
                        writeln!(text, "CC {a}{x:+.12} {b}{y:+.12}\nCP IPA{angle:+.12}{rise} DR{sign}")
                    } else if n == 3 {
                        let r = apart(element.curve.from, center) * if sweep.abs() > PI { -1.0 } else { 1.0 };
                        writeln!(text, "CR {} R{r:+.3} DR{sign}", place(element.curve.to))
                    } else {
                        writeln!(text, "CC {}\nC {} DR{sign}", place(center), place(element.curve.to))
                    }
                }
            };
            if let Some(corner) = element.corner {
                let _ = match corner {
                    Corner::Rounding(r) => writeln!(text, "RND R{r}"),
                    Corner::Chamfer(side) => writeln!(text, "CHF {side}"),
                };
            }
            if let Some(way) = element.plunge {
                let _ = writeln!(text, "L I{c}{way:+}");
            }
        }
        let _ = write!(text, "L {} R0\nEND PGM C MM\n", place(self.end));
        text
    }
}

fn line(dice: &mut Dice, from: P, heading: f64, digits: usize) -> Option<Curve> {
    let length = if dice.roll(5) == 0 { real(dice, 0.05, 2.0) } else { real(dice, 1.0, 40.0) };
    let to = rounded(add(from, towards(heading), length), digits);
    (apart(from, to) > 0.02).then(|| Curve::line(from, to))
}

fn arc(dice: &mut Dice, from: P, heading: f64, digits: usize) -> Option<Curve> {
    let side = if dice.roll(2) == 0 { 1.0 } else { -1.0 };
    let radius = if dice.roll(5) == 0 { real(dice, 0.1, 2.0) } else { real(dice, 1.0, 30.0) };
    let sweep = side * if dice.roll(5) == 0 { real(dice, 3.4, 5.8) } else { real(dice, 0.1, 2.8) };
    if digits == 9 {
        let center = rounded(add(from, left(towards(heading)), radius * side), digits);
        let out = sub(from, center);
        let (sin, cos) = sweep.sin_cos();
        let to = rounded([center[0] + out[0] * cos - out[1] * sin, center[1] + out[0] * sin + out[1] * cos], digits);
        return (apart(from, to) > 0.02).then(|| Curve {
            from,
            to,
            arc: Some((center, swept(from, to, center, side))),
        });
    }
    // By its radius: the centre follows from what is written.
    let radius = number(radius, digits);
    let center = add(from, left(towards(heading)), radius * side);
    let angle = (heading - side * PI / 2.0) + sweep;
    let to = rounded(add(center, towards(angle), radius), digits);
    let chord = apart(from, to);
    if chord < 0.05 || chord > 1.99 * radius {
        return None;
    }
    let middle = add(from, sub(to, from), 0.5);
    let high = (radius * radius - chord * chord / 4.0).sqrt() * if sweep.abs() > PI { -side } else { side };
    let center = add(middle, left(unit(sub(to, from))), high);
    Some(Curve { from, to, arc: Some((center, swept(from, to, center, side))) })
}

fn swept(from: P, to: P, center: P, side: f64) -> f64 {
    let (a, b) = (sub(from, center), sub(to, center));
    let angle = dot(left(a), b).atan2(dot(a, b)) * side;
    angle.rem_euclid(TAU) * side
}

/// Roundings and chamfers between lines.
fn corners(dice: &mut Dice, elements: &mut [Element]) {
    let mut taken = 0.0;
    for i in 1..elements.len() {
        let (before, after) = (elements[i - 1].curve, elements[i].curve);
        let angle = turn(&before, &after).abs();
        let room = (before.length() - taken).min(after.length() / 2.0);
        taken = 0.0;
        let fits = before.arc.is_none() && after.arc.is_none() && (0.2..2.6).contains(&angle) && room > 0.5;
        // A plunge stands behind the corner, not in front of it.
        if !fits
            || elements[i - 1].plunge.is_some()
            || elements[i - 1].rise != 0.0
            || elements[i].rise != 0.0
            || dice.roll(3) > 0
        {
            continue;
        }
        let cut = room * real(dice, 0.2, 0.9);
        let corner = if dice.roll(2) == 0 {
            Corner::Rounding(number(cut / (angle / 2.0).tan(), 3).max(0.001))
        } else {
            Corner::Chamfer(number(cut, 3))
        };
        taken = after.length() / 2.0;
        elements[i - 1].corner = Some(corner);
    }
    debug_assert!(elements.iter().all(|e| norm(e.curve.from).is_finite()));
}
