//! Paths along contours at random: open ones with roundings, and closed ones from outside and inside.

use std::fmt::Write as _;

use partc::Settings;

use super::super::damage::Dice;
use super::milling::{Cut, EXACT, Stock, track_of};
use super::pockets::{FINISH, PLUNGE, ROUGH, finishing, number};

/// How much nearer than asked a path may come: what the contour loses where its roundings are computed.
const NEARER: f64 = 2e-5;

type P = [f64; 2];

/// A piece of a contour: a line, or an arc about a centre within the angle of its two ends.
#[derive(Debug, Clone, Copy)]
struct Piece {
    from: P,
    to: P,
    center: Option<P>,
}

#[derive(Debug)]
struct Case {
    language: &'static str,
    text: String,
    pieces: Vec<Piece>,
    corners: Vec<P>,
    closed: bool,
    /// 41 left, 42 right, 40 on the contour.
    side: usize,
    /// The cutter goes round outside of a closed contour.
    outside: bool,
    radius: f64,
    depth: f64,
    step: f64,
    wall: f64,
    floor: f64,
    finish: bool,
}

fn away(a: P, b: P) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

impl Piece {
    fn distance(&self, p: P) -> f64 {
        let (a, b) = (self.from, self.to);
        let Some(c) = self.center else {
            let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
            let t = (((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            return (p[0] - a[0] - t * dx).hypot(p[1] - a[1] - t * dy);
        };
        // The smaller of the two arcs: on the far side of its chord, seen from the centre, within both radii.
        let cross = |u: P, v: P| (u[0] - c[0]) * (v[1] - c[1]) - (u[1] - c[1]) * (v[0] - c[0]);
        let turn = cross(a, b).signum();
        if cross(a, p) * turn >= 0.0 && cross(p, b) * turn >= 0.0 {
            return (away(p, c) - away(a, c)).abs();
        }
        away(p, a).min(away(p, b))
    }
}

impl Case {
    fn distance(&self, p: P) -> f64 {
        self.pieces.iter().map(|piece| piece.distance(p)).fold(f64::MAX, f64::min)
    }

    fn holds(&self, p: P) -> bool {
        let sides = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        let crossed = sides.filter(|(a, b)| {
            (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        });
        crossed.count() % 2 == 1
    }

    /// The least distance of the way from the contour; below 0 on the wrong side of a closed one.
    fn least(&self, cut: &Cut) -> f64 {
        let count = if cut.is_vertical() { 1 } else { 24 };
        let points = (0..=count).map(|i| cut.at(f64::from(i) / f64::from(count)));
        let room =
            |p: P| if self.closed && self.holds(p) == self.outside { -self.distance(p) } else { self.distance(p) };
        points.map(|p| room([p[0], p[1]])).fold(f64::MAX, f64::min)
    }

    /// Cuts a block and says what is wrong; false where the cutter was said to have no path.
    fn judge(&self, settings: &Settings, shift: f64) -> Result<bool, String> {
        let cuts = match track_of(self.language, &self.text, settings) {
            Ok(cuts) => cuts,
            Err(codes) if codes.iter().all(|code| code.starts_with("G3")) => return Ok(false),
            Err(codes) => return Err(format!("refused: {codes:?}")),
        };
        let cell = self.radius / 4.0;
        let around = 4.0 * self.radius + 30.0;
        let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
        for p in &self.corners {
            for i in 0..2 {
                low[i] = low[i].min(p[i] - around - shift * cell);
                high[i] = high[i].max(p[i] + around);
            }
        }
        let mut stock = Stock::new(low, high, cell);
        let rough_floor = -self.depth + self.floor;
        for (cut, finishing) in cuts.iter().zip(finishing(&cuts)) {
            let lowest = cut.from[2].min(cut.to[2]);
            let (wall, deepest) = if finishing { (0.0, -self.depth) } else { (self.wall, rough_floor) };
            if self.side != 40 && lowest < 0.0 && self.least(cut) < self.radius + wall - NEARER {
                let least = self.least(cut);
                return Err(format!("gouges the contour: {least} of {} at {cut:?}", self.radius + wall));
            }
            if lowest < deepest - EXACT {
                return Err(format!("gouges the floor: {lowest} of {deepest} at {cut:?}"));
            }
            let met = stock.cut(cut, self.radius);
            if cut.is_rapid() && met.depth > EXACT {
                return Err(format!("rapid traverse through {:?}: {cut:?}", met.at));
            }
            if !finishing && met.depth > self.step + EXACT {
                return Err(format!("an infeed of {}: {cut:?}", met.depth));
            }
        }
        self.complete(&stock)?;
        match cuts.last() {
            Some(last) if last.to[2] == 10.0 => Ok(true),
            last => Err(format!("ends below the retract height: {last:?}")),
        }
    }

    /// All that lies within the cutter's diameter beside the contour is cut.
    fn complete(&self, stock: &Stock) -> Result<(), String> {
        let (wall, floor) = if self.finish { (0.0, -self.depth) } else { (self.wall, -self.depth + self.floor) };
        let centre = if self.side == 40 { 0.0 } else { self.radius + wall };
        for (p, top) in stock.columns().filter(|(_, top)| *top > floor + EXACT) {
            let distance = self.distance(p);
            if (distance - centre).abs() > self.radius - 1e-3 || self.side == 40 && distance > self.radius - 1e-3 {
                continue;
            }
            // Where the contour bends the cutter may not reach, and at its ends it begins.
            let near = self.corners.iter().any(|corner| away(*corner, p) < 4.0 * (self.radius + wall) + 6.0);
            // The way to a closed contour and from it meet at its first corner, which the cutter does not go round.
            let begins = self.closed && away(self.corners[0], p) < 2.0 * (2.0 * self.radius + self.wall);
            let reached = match (self.closed, self.side) {
                _ if begins => false,
                (_, 40) => !near,
                (true, _) => self.holds(p) != self.outside && (self.outside || !near),
                (false, _) => !near && self.is_on_side(p),
            };
            if reached {
                return Err(format!(
                    "the column at {p:?}, {distance} beside the contour, ends at {top}, not at {floor}"
                ));
            }
        }
        Ok(())
    }

    fn is_on_side(&self, p: P) -> bool {
        let nearest = self.pieces.iter().min_by(|a, b| a.distance(p).total_cmp(&b.distance(p)));
        let Some(Piece { from: a, to: b, center: None }) = nearest else { return false };
        let cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        (cross > 0.0) == (self.side == 41)
    }
}

/// A contour through `corners` with a rounding at each in between, as it is written, and as it is.
fn rounded(corners: &[P], rounding: f64, klartext: bool) -> (String, Vec<Piece>) {
    let line = |[x, y]: P, rounding: f64| match (klartext, rounding > 0.0) {
        (true, true) => format!("L X{x:+} Y{y:+}\nRND R{rounding}\n"),
        (true, false) => format!("L X{x:+} Y{y:+}\n"),
        (false, true) => format!("G1 X{x} Y{y} RND={rounding}\n"),
        (false, false) => format!("G1 X{x} Y{y}\n"),
    };
    let mut text = String::new();
    let mut pieces = Vec::new();
    let mut at = corners[0];
    for i in 1..corners.len() {
        let (a, b) = (corners[i - 1], corners[i]);
        let unit = |a: P, b: P| [(b[0] - a[0]) / away(a, b), (b[1] - a[1]) / away(a, b)];
        let u = unit(a, b);
        if i + 1 == corners.len() || rounding == 0.0 {
            text += &line(b, 0.0);
            pieces.push(Piece { from: at, to: b, center: None });
            at = b;
            continue;
        }
        text += &line(b, rounding);
        let v = unit(b, corners[i + 1]);
        let cross = u[0] * v[1] - u[1] * v[0];
        let turn = cross.atan2(u[0] * v[0] + u[1] * v[1]);
        let t = rounding * (turn.abs() / 2.0).tan();
        let (p, q) = ([b[0] - t * u[0], b[1] - t * u[1]], [b[0] + t * v[0], b[1] + t * v[1]]);
        let side = turn.signum() * rounding;
        pieces.push(Piece { from: at, to: p, center: None });
        pieces.push(Piece { from: p, to: q, center: Some([p[0] - u[1] * side, p[1] + u[0] * side]) });
        at = q;
    }
    (text, pieces)
}

/// What is milled, without the program that says so.
fn shape(dice: &mut Dice, klartext: bool) -> (Case, String, P) {
    let radius = number(dice, 1.0, 6.0);
    let depth = number(dice, 1.0, 10.0);
    let step = number(dice, depth / 4.0, depth * 1.2);
    let some = |dice: &mut Dice, high: f64| if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, high) };
    let (wall, floor) = (some(dice, 0.5 * radius), some(dice, 0.4 * depth));
    let round = |v: f64| (v * 1000.0).round() / 1000.0;
    let closed = dice.roll(2) == 0;
    let far = |dice: &mut Dice| number(dice, 12.0, 45.0);
    let mut corners: Vec<P> = Vec::new();
    let mut rounding = 0.0;
    if closed {
        // On a circle: convex.
        let (count, size) = (3 + dice.roll(6), far(dice));
        let start = number(dice, 0.0, 360.0);
        for i in 0..count {
            let angle = (start + 360.0 * (i as f64 + number(dice, -0.2, 0.2)) / count as f64).to_radians();
            corners.push([round(size * angle.cos()), round(size * angle.sin())]);
        }
        if dice.roll(2) == 0 {
            corners.reverse();
        }
    } else {
        let mut heading = number(dice, 0.0, 360.0);
        let mut at = [0.0; 2];
        corners.push(at);
        for _ in 0..1 + dice.roll(4) {
            let way = far(dice);
            let (sin, cos) = heading.to_radians().sin_cos();
            at = [round(at[0] + way * cos), round(at[1] + way * sin)];
            corners.push(at);
            heading += number(dice, -75.0, 75.0);
        }
        rounding = if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.5, 6.0) };
    }
    let around: Vec<P> =
        if closed { corners.iter().chain(corners.first()).copied().collect() } else { corners.clone() };
    let (contour, pieces) = rounded(&around, rounding, klartext);
    let twice: f64 = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    let side = 40 + dice.roll(3);
    let outside = (twice > 0.0) == (side == 42);
    let finish = !klartext && dice.roll(2) == 0;
    let (wall, floor) = (if klartext && side == 40 { 0.0 } else { wall }, if klartext { 0.0 } else { floor });
    let language = if klartext { "klartext" } else { "sinumerik" };
    let text = String::new();
    let start = around[0];
    let case =
        Case { language, text, pieces, corners, closed, side, outside, radius, depth, step, wall, floor, finish };
    (case, contour, start)
}

fn random(dice: &mut Dice) -> Case {
    let (case, contour, start) = shape(dice, false);
    let Case { side, finish, radius, depth, step, wall, floor, .. } = case;
    let way = |dice: &mut Dice| {
        let shape = if side == 40 { 1 } else { 1 + dice.roll(3) };
        (shape + 10 * dice.roll(2), number(dice, 0.5, 2.0 * radius))
    };
    let ((comes, come), (goes, go)) = (way(dice), way(dice));
    let digits = 10 * dice.roll(2) + 100 * dice.roll(4);
    let clearance = number(dice, 0.5, 4.0);
    let mut text = format!("G17 G90 G71\n$TC_DP6[1,1]={radius}\nT1 D1\nM6\nS3000 M3\nG0 X7 Y3 Z50\n");
    let calls: &[(usize, f64)] = if finish { &[(1, ROUGH), (2, FINISH)] } else { &[(1, ROUGH)] };
    for (unit, feed) in calls {
        let _ = writeln!(
            text,
            "CYCLE72(\"E_A:E_E\",10,0,{clearance},{},{step},{wall},{floor},{feed},{PLUNGE},{},{side},{comes},{come},{feed},{goes},{go})",
            -depth,
            unit + digits
        );
    }
    let _ = write!(text, "M30\nE_A:\nG0 X{} Y{}\n{contour}E_E:\n", start[0], start[1]);
    let wall = if side == 40 { 0.0 } else { wall };
    Case { text, wall, ..case }
}

/// Cycle 25, with cycle 270 or without it.
fn contour_train(dice: &mut Dice) -> Case {
    let (case, contour, start) = shape(dice, true);
    let Case { side, radius, depth, step, wall, .. } = case;
    let mut text =
        format!("BEGIN PGM P MM\nTOOL DEF 1 L+0 R+{radius}\nTOOL CALL 1 Z S3000\nL X+7 Y+3 Z+50 R0 FMAX M3\n");
    text += "CYCL DEF 14.0 CONTOUR GEOMETRY\nCYCL DEF 14.1 CONTOUR LABEL 1\n";
    let way = dice.roll(2) == 0;
    if way {
        let form = if side == 40 { 2 } else { 1 + dice.roll(3) };
        let (size, angle, length) =
            (number(dice, 0.5, 2.0 * radius), number(dice, 20.0, 200.0), number(dice, 0.5, 2.0 * radius));
        let _ =
            writeln!(text, "CYCL DEF 270 WAYS Q390={form} Q391={} Q392={size} Q393={angle} Q394={length}", side - 40);
    }
    let kind = if side == 40 { ["+1", "+0"][dice.roll(2)] } else { ["+1", "-1", "+0"][dice.roll(3)] };
    let _ = writeln!(
        text,
        "CYCL DEF 25 TRAIN Q1={} Q3={wall} Q5=+0 Q7=+10 Q10={step} Q11={PLUNGE} Q12={ROUGH} Q15={kind}\nCYCL CALL",
        -depth
    );
    let word = ["", " RL", " RR"][side - 40];
    let _ = write!(text, "M30\nLBL 1\nL X{:+} Y{:+}{word}\n{contour}LBL 0\nEND PGM P MM\n", start[0], start[1]);
    Case { text, ..case }
}

#[test]
fn contour_trains_at_random_keep_the_properties_of_cycles() {
    let settings = Settings::default();
    super::milling::many("PARTC_TRAINS", 60, |dice, shift| {
        let case = contour_train(dice);
        case.judge(&settings, shift).map_err(|why| format!("{why}\n{}{case:?}", case.text))
    });
}

#[test]
fn paths_at_random_keep_the_properties_of_cycles() {
    let settings = Settings::default();
    super::milling::many("PARTC_PATHS", 60, |dice, shift| {
        let case = random(dice);
        case.judge(&settings, shift).map_err(|why| format!("{why}\n{}{case:?}", case.text))
    });
}
