//! Stock removal in layers: random contours and calls of CYCLE95, CYCLE951 and CYCLE952, judged by a stock of their own.
//!
//! No gouge, no rapid traverse in material, complete, infeed bounded, each feed where it belongs, and back where it began.

use core::fmt::Write;

use partc::files::NoFiles;
use partc::{Program, compile};

use super::turning::{P, Stock, Sweep, reachable};
use crate::common::settings;
use crate::damage::Dice;
use crate::meant::{Found, How, Way};
use crate::reader;

const STEP: f64 = 0.03;
/// What six printed decimals and the columns of steep walls may lose, mm.
const LOST: f64 = 2e-5;
const ROUGH: f64 = 0.25;
const PLUNGE: f64 = 0.15;
const FINISH: f64 = 0.1;

/// An element of the contour: from, to, and the centre with the sense for an arc.
#[derive(Debug, Clone, Copy)]
struct Piece {
    from: P,
    to: P,
    arc: Option<(P, bool)>,
}

/// How the part is seen: cuts along +x, infeed along -y.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    LongOutside,
    LongInside,
    FaceInwards,
    FaceOutwards,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cycle {
    Classic,
    /// With the cylinder of the blank so much larger along x and y.
    Cylinder,
    /// An allowance on the contour.
    Allowance,
}

#[derive(Debug)]
struct Case {
    pieces: Vec<Piece>,
    side: Side,
    cycle: Cycle,
    nose: f64,
    most: f64,
    along: f64,
    up: f64,
    around: f64,
    /// 1 rough, 2 finish, 3 both.
    operation: usize,
    steps: bool,
    relief: bool,
    blank: P,
    lift: f64,
}

fn real(dice: &mut Dice, low: f64, high: f64) -> f64 {
    let v = low + (high - low) * dice.roll(10_001) as f64 / 10_000.0;
    (v * 1e3).round() / 1e3
}

fn chance(dice: &mut Dice, percent: usize) -> bool {
    dice.roll(100) < percent
}

impl Case {
    fn roll(dice: &mut Dice) -> Case {
        let side = [Side::LongOutside, Side::LongInside, Side::FaceInwards, Side::FaceOutwards][dice.roll(4)];
        let cycle = [Cycle::Classic, Cycle::Cylinder, Cycle::Allowance][dice.roll(3)];
        let nose = if chance(dice, 15) { 0.0 } else { real(dice, 0.1, 1.2) };
        let both = chance(dice, 40);
        let (along, up) = if chance(dice, 30) { (0.0, 0.0) } else { (real(dice, 0.0, 0.4), real(dice, 0.0, 0.4)) };
        let around = if cycle == Cycle::Classic && both { real(dice, 0.0, 0.4) } else { 0.0 };
        let valleys = chance(dice, 45);
        let pieces = contour(dice, valleys, cycle == Cycle::Classic);
        Case {
            pieces,
            side,
            cycle,
            nose,
            most: real(dice, 0.5, 4.0),
            along,
            up,
            around,
            operation: [1, 3, 3][dice.roll(3)],
            steps: chance(dice, 30),
            relief: cycle == Cycle::Classic || chance(dice, 70),
            blank: [real(dice, 0.0, 3.0), real(dice, 0.0, 3.0)],
            lift: real(dice, 0.3, 1.5),
        }
    }

    fn top(&self) -> f64 {
        self.pieces.iter().flat_map(|p| p.points()).map(|p| p[1]).fold(0.0, f64::max)
    }

    fn end(&self) -> P {
        self.pieces.last().map_or([0.0, 0.0], |piece| piece.to)
    }

    /// A point of the view on the part: Z and X as a diameter.
    fn part(&self, p: P) -> P {
        match self.side {
            Side::LongOutside => [-p[0], 2.0 * (20.0 + p[1])],
            Side::LongInside => [-p[0], 2.0 * (80.0 - p[1])],
            Side::FaceInwards => [p[1], 2.0 * (90.0 - p[0])],
            Side::FaceOutwards => [p[1], 2.0 * (10.0 + p[0])],
        }
    }

    fn view(&self, z: f64, x: f64) -> P {
        match self.side {
            Side::LongOutside => [-z, x / 2.0 - 20.0],
            Side::LongInside => [-z, 80.0 - x / 2.0],
            Side::FaceInwards => [90.0 - x / 2.0, z],
            Side::FaceOutwards => [x / 2.0 - 10.0, z],
        }
    }

    fn mirrors(&self) -> bool {
        // (Z, X) to the view; arcs of the view turn the other way on the part.
        matches!(self.side, Side::LongOutside | Side::FaceOutwards)
    }

    /// From the tip to the nose centre in the view.
    fn center(&self) -> P {
        [-self.nose, self.nose]
    }

    fn allowances(&self) -> (f64, f64) {
        // Along Z and X.
        match self.side {
            Side::LongOutside | Side::LongInside => (self.along, self.up),
            _ => (self.up, self.along),
        }
    }

    fn text(&self) -> String {
        let mut text = String::from("G18 G90 DIAMON G95 F0.5\nT1 D1\nS1000 M3\n");
        let start = self.part([-12.0, self.top() + 12.0]);
        let (z, x) = self.allowances();
        writeln!(text, "G0 X{:.6} Z{:.6}", start[1], start[0]).unwrap();
        match self.cycle {
            Cycle::Classic => {
                let base = match self.side {
                    Side::LongOutside => 1,
                    Side::FaceInwards => 2,
                    Side::LongInside => 3,
                    Side::FaceOutwards => 4,
                };
                let vari = base + [0, 0, 4, 8][self.operation] + if self.steps { 200 } else { 0 };
                writeln!(
                    text,
                    "CYCLE95(\"KA:KE\",{},{z},{x},{},{ROUGH},{PLUNGE},{FINISH},{vari},0,0,{})",
                    self.most, self.around, self.lift
                )
                .unwrap();
            }
            Cycle::Cylinder | Cycle::Allowance => {
                let (units, way, side) = match self.side {
                    Side::LongOutside => (1, 3, 1),
                    Side::LongInside => (1, 3, 2),
                    Side::FaceInwards => (2, 1, 3),
                    Side::FaceOutwards => (2, 2, 3),
                };
                let relief = if self.relief { 1 } else { 2 };
                let vari = format!("{relief}10{side}{way}{}{units}", self.operation);
                let (bz, bx) = match self.side {
                    Side::LongOutside | Side::LongInside => (self.blank[0], self.blank[1]),
                    _ => (self.blank[1], self.blank[0]),
                };
                let kind = if self.cycle == Cycle::Cylinder { 1 } else { 2 };
                let feed = if self.operation == 2 { FINISH } else { ROUGH };
                writeln!(text, "CYCLE62(,2,\"KA\",\"KE\")").unwrap();
                writeln!(
                    text,
                    "CYCLE952(\"P\",,\"\",{vari},{feed},{PLUNGE},0,{},0,0,{x},{z},0,0,{kind},{bx},{bz},,,,,,,,,0,1,,0,12,110,1,0,{FINISH})",
                    self.most
                )
                .unwrap();
            }
        }
        text.push_str("GOTOF SCHLUSS\n");
        let first = self.part(self.pieces[0].from);
        writeln!(text, "KA: G0 X{:.6} Z{:.6}", first[1], first[0]).unwrap();
        for (i, piece) in self.pieces.iter().enumerate() {
            let mark = if i + 1 == self.pieces.len() { "KE: " } else { "" };
            let to = self.part(piece.to);
            match piece.arc {
                None => writeln!(text, "{mark}G1 X{:.6} Z{:.6}", to[1], to[0]).unwrap(),
                Some((center, ccw)) => {
                    let (from, c) = (self.part(piece.from), self.part(center));
                    // Seen with Z to the right and X up, G3 is counter-clockwise.
                    let code = if ccw != self.mirrors() { 3 } else { 2 };
                    writeln!(
                        text,
                        "{mark}G{code} X{:.6} Z{:.6} I{:.6} K{:.6}",
                        to[1],
                        to[0],
                        (c[1] - from[1]) / 2.0,
                        c[0] - from[0]
                    )
                    .unwrap();
                }
            }
        }
        text.push_str("SCHLUSS: M30\n");
        text
    }

    /// Height of the finished contour: over `x`, the higher one at a wall.
    fn finished(&self, x: f64) -> f64 {
        let mut high = f64::NEG_INFINITY;
        for piece in &self.pieces {
            let (a, b) = (piece.from, piece.to);
            if x < a[0] - 1e-9 || x > b[0] + 1e-9 {
                continue;
            }
            high = high.max(match piece.arc {
                None if b[0] - a[0] < 1e-12 => a[1].max(b[1]),
                None => a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0),
                Some((c, ccw)) => {
                    let r = (a[0] - c[0]).hypot(a[1] - c[1]);
                    let up = (r * r - (x - c[0]).powi(2)).max(0.0).sqrt();
                    c[1] + if ccw { -up } else { up }
                }
            });
        }
        high
    }

    /// Greatest height of the contour in the cell about `x`.
    fn cell(&self, x: f64) -> f64 {
        let inside = |p: &P| (p[0] - x).abs() <= STEP;
        let corners = self.pieces.iter().flat_map(|p| [p.from, p.to]).filter(inside).map(|p| p[1]);
        corners.fold(self.finished(x), f64::max)
    }

    /// Without what lies behind higher parts, where it is left standing.
    fn kept(&self, columns: &Stock, of: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut list: Vec<f64> = (0..columns.heights.len()).map(|i| of(columns.place(i))).collect();
        if !self.relief {
            let mut high = f64::NEG_INFINITY;
            for y in &mut list {
                high = high.max(*y);
                *y = high;
            }
        }
        list
    }
}

impl Piece {
    fn points(&self) -> Vec<P> {
        match self.arc {
            None => vec![self.from, self.to],
            Some((center, ccw)) => Sweep::Arc(self.from, self.to, center, ccw).points(8),
        }
    }
}

/// A contour that rises on the whole, from the origin on.
fn contour(dice: &mut Dice, valleys: bool, closes: bool) -> Vec<Piece> {
    let mut list: Vec<Piece> = Vec::new();
    let mut at = [0.0, 0.0];
    let add = |list: &mut Vec<Piece>, at: &mut P, by: P, arc: Option<(P, bool)>| {
        let to = [((at[0] + by[0]) * 1e3).round() / 1e3, ((at[1] + by[1]) * 1e3).round() / 1e3];
        if to != *at {
            list.push(Piece { from: *at, to, arc: arc.map(|(c, ccw)| ([at[0] + c[0], at[1] + c[1]], ccw)) });
            *at = to;
        }
    };
    for _ in 0..2 + dice.roll(6) {
        match dice.roll(if valleys { 11 } else { 7 }) {
            0 | 1 => add(&mut list, &mut at, [real(dice, 0.2, 9.0), 0.0], None),
            2 => add(&mut list, &mut at, [0.0, real(dice, 0.2, 5.0)], None),
            3 | 4 => add(&mut list, &mut at, [real(dice, 0.2, 8.0), real(dice, 0.2, 5.0)], None),
            5 => {
                let r = real(dice, 0.2, 4.0);
                add(&mut list, &mut at, [r, r], Some(([r, 0.0], false)));
            }
            6 => {
                let r = real(dice, 0.2, 4.0);
                add(&mut list, &mut at, [r, r], Some(([0.0, r], true)));
            }
            7 => {
                // A cone down, a floor and a wall up.
                let deep = real(dice, 0.3, 4.0);
                add(&mut list, &mut at, [real(dice, 0.3, 6.0), -deep], None);
                add(&mut list, &mut at, [real(dice, 0.5, 8.0), 0.0], None);
                add(&mut list, &mut at, [0.0, real(dice, 0.2, 5.0)], None);
            }
            8 => {
                let r = real(dice, 0.3, 3.0);
                add(&mut list, &mut at, [r, -r], Some(([r, 0.0], true)));
                add(&mut list, &mut at, [real(dice, 0.2, 4.0), 0.0], None);
                add(&mut list, &mut at, [real(dice, 0.2, 3.0), real(dice, 0.2, 5.0)], None);
            }
            9 => {
                let r = real(dice, 0.3, 3.0);
                add(&mut list, &mut at, [r, -r], Some(([0.0, -r], false)));
                add(&mut list, &mut at, [real(dice, 0.2, 4.0), 0.0], None);
            }
            _ => {
                add(&mut list, &mut at, [0.0, -real(dice, 0.2, 3.0)], None);
                add(&mut list, &mut at, [real(dice, 0.3, 5.0), 0.0], None);
            }
        }
    }
    // At least three blocks, and something to cut.
    let top = list.iter().map(|p| p.to[1]).fold(0.0, f64::max);
    if closes || chance(dice, 60) {
        let missing = top - at[1];
        add(&mut list, &mut at, [0.0, missing.max(0.0) + real(dice, 1.0, 4.0)], None);
    }
    while list.len() < 3 {
        add(&mut list, &mut at, [real(dice, 0.5, 2.0), 0.0], None);
    }
    list
}

/// A move that was found, in the view, of the nose centre.
struct Step {
    sweep: Sweep,
    rapid: bool,
    feed: f64,
}

fn steps(case: &Case, moves: &[Found]) -> Vec<Step> {
    let (mut at, mut list) = (None::<P>, Vec::new());
    let by = case.center();
    let seen = |z: f64, x: f64| {
        let p = case.view(z, 2.0 * x);
        [p[0] + by[0], p[1] + by[1]]
    };
    for found in moves {
        let Found::Move(way, How { feed, .. }) = found else { continue };
        let end = way.end();
        let to = seen(end[2], end[0]);
        if let Some(from) = at {
            let sweep = match way {
                Way::Arc { plane, center, turns, .. } => {
                    let center = if plane[0] == 2 { seen(center[0], center[1]) } else { seen(center[1], center[0]) };
                    let ccw = (*turns > 0) == (plane[0] == 2);
                    Sweep::Arc(from, to, center, ccw != case.mirrors())
                }
                _ => Sweep::Line(from, to),
            };
            list.push(Step { sweep, rapid: matches!(way, Way::Rapid(_)), feed: feed.map_or(0.0, |(_, value)| value) });
        }
        at = Some(to);
    }
    list
}

/// What became of a case.
#[derive(Debug, Default)]
struct Tally {
    cut: u64,
    refused: u64,
    valleys: u64,
    moves: u64,
}

fn judge(case: &Case, tally: &mut Tally) -> Result<(), String> {
    let text = case.text();
    let config = format!(
        "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ndecimals = 6\n[tools.1]\nradius = {}\norientation = {}\n",
        case.nose,
        match case.side {
            Side::LongOutside | Side::FaceInwards => 3,
            Side::LongInside | Side::FaceOutwards => 2,
        }
    );
    let settings = settings(&config);
    let program = Program::in_language("sinumerik", "C.MPF", text.as_bytes()).map_err(|e| e.to_string())?;
    let compiled = std::panic::catch_unwind(|| compile(&program, &settings, &NoFiles));
    let outcome = compiled.map_err(|_| "the compiler panics".to_owned())?.map_err(|e| e.to_string())?;
    let Some(output) = outcome.text else {
        // A blank that the allowance fills, and a contour that meets itself.
        let code = outcome.findings.iter().find(|f| f.severity == partc::diagnostics::Severity::Error).map(|f| f.code);
        return match code {
            Some("G3046" | "S2091") => {
                tally.refused += 1;
                Ok(())
            }
            _ => Err(format!("{:?}", outcome.findings)),
        };
    };
    let moves = reader::read(&output, 6)?;
    let steps = steps(case, &moves);
    tally.cut += 1;
    tally.moves += steps.len() as u64;
    tally.valleys += u64::from(outcome.findings.iter().any(|f| f.code == "S8211"));
    check(case, &steps).map_err(|why| format!("{why}\n{output}"))
}

/// The stock before the cycle.
fn blank(case: &Case, columns: &Stock, kept: &[f64]) -> Vec<f64> {
    let end = case.end();
    let top = case.top();
    (0..columns.heights.len())
        .map(|i| {
            let x = columns.place(i);
            match case.cycle {
                Cycle::Classic if x < 0.0 => f64::NEG_INFINITY,
                Cycle::Classic => top,
                Cycle::Cylinder if x < -case.blank[0] => f64::NEG_INFINITY,
                Cycle::Cylinder => top + case.blank[1],
                Cycle::Allowance if x < -case.blank[0] || x > end[0] => f64::NEG_INFINITY,
                Cycle::Allowance => grown(columns, kept, i, case.blank[0]) + case.blank[1],
            }
        })
        .collect()
}

/// Greatest height within a distance.
fn grown(columns: &Stock, heights: &[f64], i: usize, by: f64) -> f64 {
    let n = (by / columns.step).floor() as usize;
    heights[i.saturating_sub(n)..(i + n + 1).min(heights.len())].iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// The finished shape with the allowances.
fn with_allowances(case: &Case, columns: &Stock, kept: &[f64], more: f64) -> Vec<f64> {
    let wide = |by: f64| if by > 0.0 { by + more } else { 0.0 };
    let boxed: Vec<f64> = (0..kept.len()).map(|i| grown(columns, kept, i, wide(case.along)) + case.up).collect();
    let n = (wide(case.around) / columns.step).floor() as isize;
    let at = |i: isize| boxed[i.clamp(0, boxed.len() as isize - 1) as usize];
    (0..boxed.len() as isize)
        .map(|i| {
            (-n..=n)
                .map(|k| {
                    let off = k as f64 * columns.step;
                    at(i + k) + (case.around * case.around - off * off).max(0.0).sqrt()
                })
                .fold(f64::NEG_INFINITY, f64::max)
        })
        .collect()
}

fn check(case: &Case, steps: &[Step]) -> Result<(), String> {
    let end = case.end();
    let (left, right) = (-6.0 + STEP * 0.37, end[0] + 4.0);
    let mut stock = Stock::new(left, right, STEP, |_| f64::NEG_INFINITY);
    let own: Vec<f64> = (0..stock.heights.len()).map(|i| case.finished(stock.place(i))).collect();
    let kept = case.kept(&stock, |x| case.finished(x));
    // What may stand counts the corners between two columns.
    let high = case.kept(&stock, |x| case.cell(x));
    stock.heights = blank(case, &stock, &own);
    let left_over = with_allowances(case, &stock, &kept, 0.0);
    let first_finish = steps.iter().position(|s| !s.rapid && s.feed == FINISH).unwrap_or(steps.len());
    // Levels of the cuts in the main part.
    let mut deepest = f64::INFINITY;
    for (n, step) in steps.iter().enumerate() {
        let finishing = n >= first_finish;
        let limit = if finishing { &kept } else { &left_over };
        let mut fault = None;
        let (mut deep, mut touched) = (0.0f64, false);
        let mut cuts: Vec<(usize, f64)> = Vec::new();
        stock.swept(&step.sweep, case.nose, |i, y| {
            let x = stock.place(i);
            let near = |d: isize| limit[(i as isize + d).clamp(0, limit.len() as isize - 1) as usize];
            let floor = near(0).min(near(1)).min(near(-1));
            if x >= 0.0 && x <= end[0] && y < floor - LOST - 1e-3 * f64::from(u8::from(case.around > 0.0 && !finishing))
            {
                fault.get_or_insert(format!("gouge of {} at {x}", floor - y));
            }
            if y < stock.heights[i] - LOST {
                touched = true;
                if step.rapid {
                    fault.get_or_insert(format!("rapid {} deep in stock at {x}", stock.heights[i] - y));
                }
                if stock.heights[i] > f64::NEG_INFINITY {
                    deep = deep.max(stock.heights[i] - y);
                }
            }
            if !step.rapid {
                cuts.push((i, y));
            }
        });
        if let Some(fault) = fault {
            return Err(format!("move {n} {:?} rapid {}: {fault}", step.sweep, step.rapid));
        }
        for (i, y) in cuts {
            stock.heights[i] = stock.heights[i].min(y);
        }
        let (a, b) = step.sweep.ends();
        let level = (a[1] - b[1]).abs() < 1e-9 && matches!(step.sweep, Sweep::Line(..));
        if touched && level && step.feed == ROUGH && !finishing && deep > case.most + case.nose + 1e-4 {
            return Err(format!("move {n} {:?}: {deep} deep, infeed {}", step.sweep, case.most));
        }
        if touched && step.feed == PLUNGE && b[1] > a[1] + 1e-9 {
            return Err(format!("move {n} {:?} goes up at the plunge feed", step.sweep));
        }
        if touched && ![ROUGH, PLUNGE, FINISH].contains(&step.feed) {
            return Err(format!("move {n} has the feed {}", step.feed));
        }
        deepest = deepest.min(b[1]);
    }
    let finished = first_finish < steps.len();
    let stands = if finished { high } else { with_allowances(case, &stock, &high, STEP) };
    complete(case, &stock, &stands, finished)?;
    let (first, last) = (steps.first().map(|s| s.sweep.ends().1), steps.last().map(|s| s.sweep.ends().1));
    match (first, last) {
        (Some(a), Some(b)) if (a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5 => Ok(()),
        _ => Err(format!("begins in {first:?} and ends in {last:?}")),
    }
}

/// What stands afterwards is what the nose cannot reach.
fn complete(case: &Case, stock: &Stock, wanted: &[f64], finished: bool) -> Result<(), String> {
    let end = case.end();
    let mut floor = stock.clone();
    floor.heights = (0..wanted.len())
        .map(|i| {
            let x = stock.place(i);
            // In front of the contour nothing holds the nose, behind its end a wall.
            if x < 0.0 {
                wanted[i].max(-50.0)
            } else if x > end[0] + case.nose {
                1e3
            } else {
                wanted[i]
            }
        })
        .collect();
    // In front it goes on as it begins.
    let first = floor.heights.iter().position(|y| *y > -40.0).unwrap_or(0);
    for i in 0..first {
        floor.heights[i] = floor.heights[first];
    }
    for i in 1..floor.heights.len() {
        if floor.place_in(&stock.left, i) > end[0] && floor.heights[i] < 0.0 {
            floor.heights[i] = floor.heights[i - 1];
        }
    }
    let best = reachable(&floor, case.nose);
    let margin = case.nose + case.along + case.around + 0.2;
    for (i, y) in stock.heights.iter().enumerate() {
        let x = stock.place(i);
        if x < margin || x > end[0] - margin {
            continue;
        }
        let near = (-2isize..=2).map(|d| best[(i as isize + d).clamp(0, best.len() as isize - 1) as usize]);
        let most = near.fold(f64::NEG_INFINITY, f64::max);
        if *y > most + 0.05 {
            return Err(format!("{} stands at {x}, finished {finished}", y - most));
        }
    }
    Ok(())
}

impl Stock {
    fn place_in(&self, left: &f64, i: usize) -> f64 {
        left + i as f64 * self.step
    }
}

fn run(seed: u64, count: u64) -> (Tally, Vec<String>) {
    let (mut tally, mut failures) = (Tally::default(), Vec::new());
    for i in 0..count {
        let mut dice = Dice((seed.wrapping_mul(1_000_003).wrapping_add(i) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..4 {
            dice.roll(2);
        }
        let case = Case::roll(&mut dice);
        if let Err(why) = judge(&case, &mut tally) {
            let (case, why) = smaller(case, why);
            failures.push(format!("case {i} of {seed}: {why}\n{case:?}\n{}", case.text()));
            if failures.len() >= 4 {
                break;
            }
        }
    }
    (tally, failures)
}

/// The same with fewer elements, as long as it fails.
fn smaller(mut case: Case, mut why: String) -> (Case, String) {
    let mut at = 0;
    while at < case.pieces.len() && case.pieces.len() > 3 {
        let removed = case.pieces.remove(at);
        let by = [removed.to[0] - removed.from[0], removed.to[1] - removed.from[1]];
        let shift = |p: P, sign: f64| [p[0] + sign * by[0], p[1] + sign * by[1]];
        let turn = |case: &mut Case, sign: f64| {
            for piece in &mut case.pieces[at..] {
                piece.from = shift(piece.from, sign);
                piece.to = shift(piece.to, sign);
                piece.arc = piece.arc.map(|(c, ccw)| (shift(c, sign), ccw));
            }
        };
        turn(&mut case, -1.0);
        match judge(&case, &mut Tally::default()) {
            Err(next) => why = next,
            Ok(()) => {
                turn(&mut case, 1.0);
                case.pieces.insert(at, removed);
                at += 1;
            }
        }
    }
    (case, why)
}

/// `PARTC_LAYERS` says how many, `PARTC_LAYERS_SEED` which.
#[test]
fn random_contours_are_cut_right() {
    let from = |name: &str, or: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(or);
    let (count, seed) = (from("PARTC_LAYERS", 200), from("PARTC_LAYERS_SEED", 1));
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let parts: Vec<(Tally, Vec<String>)> = std::thread::scope(|scope| {
        let work = |k: u64| scope.spawn(move || run(seed * 64 + k, count.div_ceil(threads)));
        let parts: Vec<_> = (0..threads).map(work).collect();
        parts.into_iter().map(|part| part.join().expect("a part")).collect()
    });
    let sum = |of: fn(&Tally) -> u64| parts.iter().map(|(tally, _)| of(tally)).sum::<u64>();
    println!(
        "{} cut, {} with relief cuts, {} refused, {} moves",
        sum(|t| t.cut),
        sum(|t| t.valleys),
        sum(|t| t.refused),
        sum(|t| t.moves)
    );
    let failures: Vec<&str> = parts.iter().flat_map(|(_, list)| list).map(String::as_str).collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(sum(|t| t.cut) * 2 > count);
}
