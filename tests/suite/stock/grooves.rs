//! Grooves: random calls of CYCLE93 and CYCLE930, judged by a stock and a shape of their own.
//!
//! No gouge, no rapid traverse in material, complete but for the corners of the tool, each plunge as deep as erosion allows,
//! infeed bounded, one feed, and the same path from wherever the tool comes.

mod shape;

use partc::files::NoFiles;
use partc::{Program, compile};

use crate::common::settings;
use crate::damage::Dice;
use crate::meant::{Found, How, Way};
use crate::reader;

pub use shape::Tool;
use shape::{Corner, P, PIECES, SIDE, Shape, Wall};

/// What six printed decimals may lose, mm.
const LOST: f64 = 2e-5;
/// What chords of an arc lose, mm.
const CHORD: f64 = 2e-3;
const FEED: f64 = 0.08;

#[derive(Debug)]
struct Case {
    new: bool,
    side: usize,
    width: f64,
    depth: f64,
    /// Degrees; pairs begin at the reference point.
    angles: [f64; 2],
    outer: [Corner; 2],
    inner: [Corner; 2],
    tool: f64,
    nose: f64,
    plus: bool,
    floor: f64,
    flanks: f64,
    infeed: f64,
    copies: usize,
}

fn real(dice: &mut Dice, low: f64, high: f64) -> f64 {
    let v = low + (high - low) * dice.roll(10_001) as f64 / 10_000.0;
    (v * 1e3).round() / 1e3
}

fn chance(dice: &mut Dice, percent: usize) -> bool {
    dice.roll(100) < percent
}

fn corner(dice: &mut Dice, most: f64) -> Corner {
    match dice.roll(4) {
        0 => Corner::Round(real(dice, 0.05, most)),
        1 => Corner::Chamfer(real(dice, 0.05, most)),
        _ => Corner::Sharp,
    }
}

impl Case {
    fn roll(dice: &mut Dice) -> Case {
        let new = chance(dice, 50);
        let tool = real(dice, 1.0, 6.0);
        let nose = match dice.roll(10) {
            0 => 0.0,
            1 => tool / 2.0,
            _ => real(dice, 0.05, tool / 4.0),
        };
        let width = if chance(dice, 5) { tool } else { real(dice, 1.01 * tool, 8.0 * tool) };
        let depth = real(dice, 0.5, 12.0);
        let angle = |dice: &mut Dice| if chance(dice, 40) { 0.0 } else { real(dice, 0.5, 45.0) };
        let angles = [angle(dice), angle(dice)];
        let outer = [corner(dice, depth / 2.0), corner(dice, depth / 2.0)];
        let inner = [corner(dice, depth.min(width) / 2.5), corner(dice, depth.min(width) / 2.5)];
        let floor = if chance(dice, 30) { 0.0 } else { real(dice, 0.0, 0.3) };
        let flanks = if new || chance(dice, 50) { floor } else { real(dice, 0.0, 0.3) };
        Case {
            new,
            side: 1 + dice.roll(8),
            width,
            depth,
            angles,
            outer,
            inner,
            tool,
            nose,
            plus: chance(dice, 50),
            floor,
            flanks,
            infeed: if chance(dice, 30) { 0.0 } else { real(dice, 0.3, 4.0) },
            copies: if new && chance(dice, 10) { 2 } else { 1 },
        }
    }

    fn is_radial(&self) -> bool {
        self.side % 2 == 1
    }

    /// Surface on the infeed axis, and the way out of the material.
    fn surface(&self) -> (f64, f64) {
        match self.side {
            1 | 5 => (40.0, 1.0),
            3 | 7 => (60.0, -1.0),
            6 | 8 => (-7.0, 1.0),
            _ => (-50.0, -1.0),
        }
    }

    fn towards_plus(&self) -> bool {
        matches!(self.side, 1 | 3 | 4 | 8)
    }

    fn reference(&self) -> f64 {
        if self.is_radial() { -30.0 } else { 150.0 }
    }

    /// From the programmed point to the edge towards minus.
    fn edge(&self) -> f64 {
        if self.plus { -self.tool } else { 0.0 }
    }

    fn orientation(&self) -> usize {
        match (self.side, self.plus) {
            (1 | 5, false) => 3,
            (1 | 5, true) => 4,
            (3 | 7, false) => 2,
            (3 | 7, true) => 1,
            (6 | 8, false) => 3,
            (6 | 8, true) => 2,
            (_, false) => 4,
            (_, true) => 1,
        }
    }

    fn distance(&self) -> f64 {
        // The rim of the one stays outside of what is judged of the other.
        let way = self.width + 2.0 * self.depth + 3.0 + self.outer.map(Corner::size).iter().sum::<f64>();
        if self.towards_plus() { way } else { -way }
    }

    fn call(&self, operation: usize) -> String {
        let radial = self.is_radial();
        let (surface, _) = self.surface();
        let (spd, spl) = if radial { (2.0 * surface, self.reference()) } else { (2.0 * self.reference(), surface) };
        let [a, b] = self.angles;
        let size = |corner: Corner, sign: f64| match corner {
            Corner::Sharp => 0.0,
            Corner::Round(r) => r,
            Corner::Chamfer(c) => sign * c,
        };
        let head = format!("{spd},{spl},{}", self.width);
        if !self.new {
            let [o1, o2] = self.outer.map(|c| size(c, -1.0));
            let [i1, i2] = self.inner.map(|c| size(c, -1.0));
            return format!(
                "CYCLE93({head},{},0,{a},{b},{o1},{o2},{i1},{i2},{},{},{},0,{})",
                self.depth,
                self.floor,
                self.flanks,
                self.infeed,
                10 + self.side
            );
        }
        let corners = [self.outer[0], self.inner[0], self.inner[1], self.outer[1]];
        let digits: usize = corners
            .iter()
            .zip([1, 10, 100, 1000])
            .map(|(c, n)| if matches!(c, Corner::Chamfer(_)) { n } else { 0 })
            .sum();
        let [o1, i1, i2, o2] = corners.map(|c| size(c, 1.0));
        format!(
            "CYCLE930({head},,{},,0,{a},{b},{o1},{i1},{i2},{o2},{},{},1,{},,{},{},,1,,,2,{})",
            self.depth,
            self.floor,
            self.infeed,
            10_000 + 100 * self.side + 10 * operation,
            self.copies,
            self.distance(),
            digits * 1000 + 10
        )
    }

    fn program(&self, start: (f64, f64)) -> String {
        let calls = match (self.new, self.side % 3) {
            (true, 0) => format!("{}\n{}", self.call(1), self.call(2)),
            _ => self.call(3),
        };
        format!("T1 D1\nG18 G90 DIAMON\nG95 F{FEED} S500 M3\nG0 X{} Z{}\n{calls}\nM30\n", start.0, start.1)
    }

    fn settings(&self) -> String {
        format!(
            "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ndecimals = 6\n[cycles]\ngroove_dwell = false\n\
             [tools.1]\nwidth = {:?}\nradius = {:?}\norientation = {}\n",
            self.tool,
            self.nose,
            self.orientation()
        )
    }

    /// Walls from the left, and the reference rim.
    fn walls(&self) -> [Wall; 2] {
        let wall = |at: usize| {
            let angle = self.angles[at].to_radians();
            Wall { sin: angle.sin(), cos: angle.cos(), outer: self.outer[at], inner: self.inner[at] }
        };
        if self.towards_plus() { [wall(0), wall(1)] } else { [wall(1), wall(0)] }
    }

    fn start(&self) -> (f64, f64) {
        match self.side {
            1 | 5 => (100.0, 5.0),
            3 | 7 => (110.0, 5.0),
            6 | 8 => (320.0, 5.0),
            _ => (320.0, -60.0),
        }
    }

    /// The allowance on the flanks, or what the tool leaves room for.
    fn left_on_flanks(&self) -> f64 {
        let tan: f64 = self.angles.iter().map(|a| a.to_radians().tan()).sum();
        let cos: f64 = self.angles.iter().map(|a| 1.0 / a.to_radians().cos()).sum();
        self.flanks.min(((self.width - self.tool + self.floor * tan) / cos).max(0.0))
    }

    /// Width of the floor between its corners, with walls moved together.
    fn square_floor(&self, walls: [f64; 2]) -> f64 {
        let taken = |wall: &Wall| match wall.inner {
            Corner::Sharp => 0.0,
            Corner::Chamfer(c) => c,
            Corner::Round(r) => r * (1.0 - wall.sin) / wall.cos,
        };
        self.width - walls[0] - walls[1] - self.walls().iter().map(taken).sum::<f64>()
    }

    fn top(&self) -> f64 {
        self.width + self.depth * self.angles.iter().map(|a| a.to_radians().tan()).sum::<f64>()
    }

    fn left(&self) -> f64 {
        if self.towards_plus() { self.reference() } else { self.reference() - self.top() }
    }
}

impl Shape {
    fn of(case: &Case) -> Shape {
        Shape { walls: case.walls().map(|wall| wall.line(case.depth)), left: case.left(), top: case.top() }
    }
}

struct Stock {
    left: f64,
    step: f64,
    heights: Vec<f64>,
}

struct Judge<'c> {
    case: &'c Case,
    shape: Shape,
    rough: Shape,
    tool: Tool,
    stock: Stock,
    at: P,
    /// What roughing leaves everywhere.
    left: f64,
    finishing: bool,
}

/// A move in the view: rapid or not, and the points of the left edge it goes through.
type Step = (bool, Vec<P>, How);

impl Judge<'_> {
    fn columns(&self, points: &[P], inside: f64) -> std::ops::Range<usize> {
        let low = points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min) + inside;
        let high = points.iter().map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max) + self.tool.width - inside;
        let first = ((low - self.stock.left) / self.stock.step).ceil().max(0.0) as usize;
        let last = ((high - self.stock.left) / self.stock.step).floor();
        let last = if last < 0.0 { 0 } else { (last as usize + 1).min(self.stock.heights.len()) };
        first..last.max(first)
    }

    fn place(&self, i: usize) -> f64 {
        self.stock.left + i as f64 * self.stock.step
    }

    fn take(&mut self, rapid: bool, points: &[P], how: &How) -> Result<f64, String> {
        let mut from = self.at;
        let mut deepest = 0.0_f64;
        for to in points {
            for i in self.columns(&[from, *to], SIDE) {
                let x = self.place(i);
                let Some(y) = self.tool.lowest(from, *to, x) else { continue };
                let now = self.stock.heights[i];
                if y >= now - LOST && (rapid || y >= now) {
                    continue;
                }
                if rapid {
                    return Err(format!("rapid in stock at {x}: {y} under {now}"));
                }
                let floor =
                    [x - SIDE, x, x + SIDE].map(|x| self.shape.height(x)).into_iter().fold(f64::INFINITY, f64::min);
                if y < floor - LOST && self.shape.distance([x, y]) > LOST {
                    return Err(format!("gouge at {x}: {y} under {floor}"));
                }
                deepest = deepest.max(now - y);
                self.stock.heights[i] = y;
            }
            from = *to;
        }
        self.at = from;
        match how.feed {
            Some((_, feed)) if !rapid && (feed - FEED).abs() > 1e-9 => Err(format!("feed {feed}")),
            None if !rapid => Err("no feed".to_owned()),
            _ => Ok(deepest),
        }
    }

    /// A stroke straight down: as deep as the whole edge may go, or, in steps, not deeper.
    fn eroded(&self, to: P, whole: bool) -> Result<(), String> {
        let (a, b) = (to[0], to[0] + self.tool.width);
        let height = |x: f64| self.rough.rolled(x, self.left);
        let mut most = height(a + SIDE).max(height(b - SIDE));
        for i in 1..40 {
            most = most.max(height(a + self.tool.width * f64::from(i) / 40.0));
        }
        // On steep walls a little along is much in depth.
        let beside = [a - 2.0 * SIDE, b + 2.0 * SIDE].map(height).into_iter().fold(most, f64::max).min(0.0);
        if to[1] < most - CHORD || (whole && to[1] > beside + CHORD) {
            return Err(format!("plunge at {} to {}: erosion says {most} to {beside}", to[0], to[1]));
        }
        Ok(())
    }

    /// Roughing leaves the allowance everywhere.
    fn allowance(&self) -> Result<(), String> {
        for (i, h) in self.stock.heights.iter().enumerate().filter(|(_, h)| **h < 0.0) {
            let distance = self.shape.distance([self.place(i), *h]);
            if distance < self.left - CHORD {
                return Err(format!("roughing at {} {h} leaves {distance}, not {}", self.place(i), self.left));
            }
        }
        // And no more of it, but for the corners of the tool.
        self.down_to(&self.rough, self.left)
    }

    fn complete(&self) -> Result<(), String> {
        self.down_to(&self.shape, 0.0)
    }

    /// Nothing stands above a shape by more than `around` and what the corners of the tool leave.
    fn down_to(&self, shape: &Shape, around: f64) -> Result<(), String> {
        let reach = (self.case.nose + around) * std::f64::consts::SQRT_2 - self.case.nose + 1e-3;
        // Above the inner corners nothing is left at all.
        let inner = self.case.inner.map(Corner::size).into_iter().fold(0.0, f64::max);
        let foot = 0.05 + inner + self.case.nose + around + (self.case.floor - self.left).max(0.0) - self.case.depth;
        for (i, h) in self.stock.heights.iter().enumerate() {
            let x = self.place(i);
            let [a, b] = self.shape.seen(x);
            if a < 0.0 || b < 0.0 {
                continue;
            }
            let target = [x - SIDE, x + SIDE].map(|x| shape.height(x)).into_iter().fold(f64::NEG_INFINITY, f64::max);
            if *h <= target + CHORD {
                continue;
            }
            let distance = shape.distance([x, *h]);
            let most = if *h > foot { around + 2.0 * CHORD } else { reach.max(CHORD) };
            if distance > most {
                return Err(format!("{distance} left at {x} {h}, the shape is {target}, {around} around it"));
            }
        }
        Ok(())
    }
}

fn points(case: &Case, moves: &[Found]) -> Vec<Step> {
    let (surface, out) = case.surface();
    let seen = |x: f64, z: f64| -> P {
        let (along, height) = if case.is_radial() { (z, x) } else { (x, z) };
        [along + case.edge(), (height - surface) * out]
    };
    let mut list = Vec::new();
    let mut at = [0.0; 2];
    for found in moves {
        let Found::Move(way, how) = found else { continue };
        let end = way.end();
        let points = match way {
            Way::Arc { plane, center, turns, end } => {
                let (c, to) = ([center[0], center[1]], [end[plane[0]], end[plane[1]]]);
                let from = if plane[0] == 2 { [at[1], at[0]] } else { at };
                let r = (from[0] - c[0]).hypot(from[1] - c[1]);
                let angle = |p: P| (p[1] - c[1]).atan2(p[0] - c[0]);
                let mut sweep = angle(to) - angle(from);
                let tau = core::f64::consts::TAU;
                if *turns > 0 && sweep <= 0.0 {
                    sweep += tau;
                }
                if *turns < 0 && sweep >= 0.0 {
                    sweep -= tau;
                }
                let point = |i: usize| {
                    let t = angle(from) + sweep * i as f64 / PIECES as f64;
                    let p = if i == PIECES { to } else { [c[0] + r * t.cos(), c[1] + r * t.sin()] };
                    if plane[0] == 2 { seen(p[1], p[0]) } else { seen(p[0], p[1]) }
                };
                (1..=PIECES).map(point).collect()
            }
            Way::Rapid(_) | Way::Feed(_) => vec![seen(end[0], end[2])],
        };
        at = [end[0], end[2]];
        list.push((matches!(way, Way::Rapid(_)), points, *how));
    }
    list
}

/// The blocks of moves at feed between rapid moves: first and behind the last.
fn blocks(steps: &[Step]) -> Vec<(usize, usize)> {
    let mut list = Vec::new();
    let mut start = None;
    for (i, (rapid, ..)) in steps.iter().enumerate() {
        match (rapid, start) {
            (false, None) => start = Some(i),
            (true, Some(from)) => {
                list.push((from, i));
                start = None;
            }
            _ => {}
        }
    }
    list
}

/// False for a call that is refused for a reason.
fn judge(case: &Case, twice: bool) -> Result<bool, String> {
    let start = case.start();
    let Some(moves) = made(case, start)? else { return Ok(false) };
    let steps = points(case, &moves);
    let shape = Shape::of(case);
    let flanks = case.left_on_flanks();
    let walls = case.walls().map(|wall| (flanks - case.floor * wall.sin) / wall.cos);
    let around = case.floor.min(flanks);
    let further = case.walls().map(|wall| (flanks - around - (case.floor - around) * wall.sin) / wall.cos);
    let rough = shape.moved(further, case.floor - around);
    let (left, top) = (shape.left - 2.0, shape.top);
    let step = (top / 400.0).max(0.01);
    let tool = Tool { width: case.tool, nose: case.nose };
    let stock = Stock { left, step, heights: vec![0.0; ((top + 4.0) / step) as usize] };
    let at = steps.first().and_then(|(_, points, _)| points.last()).copied().ok_or("no move")?;
    let one = case.copies == 1;
    let mut judge = Judge { case, shape, rough, tool, stock, at, left: around, finishing: !one };
    // The last two are the halves of finishing.
    let blocks = blocks(&steps);
    let halves = blocks.len().checked_sub(2).and_then(|at| blocks.get(at)).ok_or("no finishing")?.0;
    let square = case.square_floor(walls) >= case.tool - 1e-9;
    for (k, (rapid, points, how)) in steps.iter().enumerate().skip(1) {
        if k == halves && !judge.finishing {
            judge.allowance()?;
        }
        judge.finishing |= k >= halves;
        let from = judge.at;
        let deepest = judge.take(*rapid, points, how)?;
        let block = blocks.iter().find(|(first, end)| (*first..*end).contains(&k));
        let straight = block.is_some_and(|(first, end)| {
            steps[*first..*end].iter().flat_map(|(_, points, _)| points).all(|p| (p[0] - from[0]).abs() < LOST)
        });
        if judge.finishing || !straight {
            continue;
        }
        let most = match (case.infeed, case.new) {
            (0.0, _) => f64::INFINITY,
            (infeed, false) => infeed,
            // In turns: two infeeds; the rest at once.
            (_, true) => f64::INFINITY,
        };
        if deepest > most + 1e-4 {
            return Err(format!("{deepest} deep at {}, more than {most}", from[0]));
        }
        if square {
            judge.eroded(points[points.len() - 1], case.infeed == 0.0)?;
        }
    }
    if one {
        judge.complete()?;
    }
    // The path does not depend on where the tool comes from.
    if twice {
        let other = (if case.is_radial() { start.0 } else { 2.0 }, if case.is_radial() { -200.0 } else { start.1 });
        let other = made(case, other)?.map(|moves| points(case, &moves)).unwrap_or_default();
        let tail = |list: &[Step]| -> Vec<Vec<P>> {
            let from = blocks_start(list);
            list[from..].iter().map(|(_, points, _)| points.clone()).collect()
        };
        if tail(&steps) != tail(&other) {
            return Err("another start makes another path".to_owned());
        }
    }
    Ok(true)
}

fn blocks_start(steps: &[Step]) -> usize {
    steps.iter().position(|(rapid, ..)| !rapid).unwrap_or(steps.len())
}

/// The moves; `None` for a call that is refused for a reason.
fn made(case: &Case, start: (f64, f64)) -> Result<Option<Vec<Found>>, String> {
    let text = case.program(start);
    let settings = settings(&case.settings());
    let program = Program::in_language("sinumerik", "G.MPF", text.as_bytes()).map_err(|e| e.to_string())?;
    let compiled = std::panic::catch_unwind(|| compile(&program, &settings, &NoFiles));
    let outcome = compiled.map_err(|_| "the compiler panics".to_owned())?.map_err(|e| e.to_string())?;
    let Some(output) = outcome.text else {
        let reasons = ["61603", "does not reach the floor", "61010"];
        let known = outcome.findings.iter().any(|found| reasons.iter().any(|reason| found.message.contains(reason)));
        return if known { Ok(None) } else { Err(format!("{:?}", outcome.findings)) };
    };
    Ok(Some(reader::read(&output, 6)?))
}

/// `PARTC_GROOVES` says how many, `PARTC_GROOVES_SEED` which.
#[test]
fn random_grooves() {
    let from = |name: &str, or: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(or);
    let (count, seed) = (from("PARTC_GROOVES", 100), from("PARTC_GROOVES_SEED", 1));
    let (mut cut, mut failures) = (0_u64, Vec::new());
    for i in 0..count {
        let mut dice = Dice((seed.wrapping_mul(1_000_003).wrapping_add(i) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..4 {
            dice.roll(2);
        }
        let case = Case::roll(&mut dice);
        match judge(&case, i % 10 == 0) {
            Ok(made) => cut += u64::from(made),
            Err(why) => {
                failures.push(format!(
                    "groove {i} of {seed}: {why}\n{}{}",
                    case.settings(),
                    case.program((100.0, 5.0))
                ));
                if failures.len() >= 4 {
                    break;
                }
            }
        }
    }
    println!("{cut} of {count} grooves cut");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(cut * 3 > count * 2, "{cut} of {count}");
}
