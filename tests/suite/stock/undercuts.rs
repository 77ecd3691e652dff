//! Undercut cycles: random calls of CYCLE94, CYCLE96 and CYCLE940 with a nose, judged by a shape of their own.
//!
//! The shape is made of the formulas of the standards. The nose never comes nearer to it than it is round, touches all of it, leaves
//! what an allowance asks for, travels at rapid in no material, and goes down by the infeed.

mod shape;

use super::layers::{chance, real};
use super::removal::{Language, Made, Side, Step, Tally, made, run, steps};
use super::turning::{P, Stock, Sweep};
use crate::damage::Dice;

use shape::{Outline, Shape};

/// What the nose may come too near, or leave, mm.
const NEAR: f64 = 0.006;
/// Between the places of a move that are looked at, mm.
const PACE: f64 = 0.004;
/// Between the columns of the stock, mm.
const COLUMN: f64 = 0.02;
const FEED: f64 = 0.1;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Cycle {
    ByDiameter,
    ByThread,
    New,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Leave {
    Around(f64),
    /// Along Z and X (radius).
    Along(f64, f64),
}

#[derive(Debug)]
struct Case {
    cycle: Cycle,
    form: char,
    /// 0 outside +Z, 1 outside -Z, 2 inside +Z, 3 inside -Z.
    place: usize,
    diameter: f64,
    z: f64,
    /// `_PITI`.
    index: usize,
    shape: Shape,
    /// On the cylinder (radius) and on the face.
    raised: P,
    clearance: f64,
    /// Height of the face over the corner.
    face: Option<f64>,
    kind: usize,
    most: f64,
    leave: Leave,
    position: usize,
    nose: f64,
    /// Where the tool stands, in the frame of the corner.
    start: P,
}

/// Up to this diameter: radius, depth, length, depth behind the face.
const SIZES: [(f64, [f64; 4]); 4] = [
    (10.0, [0.4, 0.2, 2.0, 0.1]),
    (18.0, [0.6, 0.2, 2.0, 0.1]),
    (80.0, [0.6, 0.3, 2.5, 0.2]),
    (1e3, [1.0, 0.4, 4.0, 0.3]),
];
/// The sizes of CYCLE940.
const LISTED: [[f64; 4]; 10] = [
    [0.6, 0.3, 2.5, 0.2],
    [1.0, 0.4, 4.0, 0.3],
    [1.0, 0.2, 2.5, 0.1],
    [1.6, 0.3, 4.0, 0.2],
    [2.5, 0.4, 5.0, 0.3],
    [4.0, 0.5, 7.0, 0.3],
    [0.4, 0.2, 2.0, 0.1],
    [0.6, 0.2, 2.0, 0.1],
    [0.1, 0.1, 0.5, 0.1],
    [0.2, 0.1, 1.0, 0.1],
];
/// Of DIN 76: coarse diameter, `_PITI`, pitch, outside less, radius, inside more, and g1, g2 of A, B, C, D.
const THREADS: [(f64, usize, [f64; 4], [P; 4]); 6] = [
    (6.0, 11, [1.0, 1.6, 0.6, 0.5], [[2.1, 3.5], [1.1, 2.5], [4.0, 5.2], [2.5, 3.7]]),
    (10.0, 13, [1.5, 2.3, 0.8, 0.5], [[3.2, 5.2], [1.8, 3.8], [6.0, 7.8], [3.8, 5.6]]),
    (16.0, 15, [2.0, 3.0, 1.0, 0.5], [[4.5, 7.0], [2.5, 5.0], [8.0, 10.3], [5.0, 7.3]]),
    (20.0, 16, [2.5, 3.6, 1.2, 0.5], [[5.6, 8.7], [3.2, 6.3], [10.0, 13.0], [6.3, 9.3]]),
    (24.0, 17, [3.0, 4.4, 1.6, 0.5], [[6.7, 10.5], [3.7, 7.5], [12.0, 15.2], [7.5, 10.7]]),
    (36.0, 19, [4.0, 5.7, 2.0, 0.5], [[9.0, 14.0], [5.0, 10.0], [16.0, 20.0], [10.0, 14.0]]),
];
const CORE: f64 = 1.082_532;

/// A thread undercut; `form` counts from A.
fn thread(row: usize, form: usize, entry: f64) -> Shape {
    let (_, _, [pitch, less, radius, more], lengths) = THREADS[row];
    let depth = if form < 2 { less / 2.0 } else { (CORE * pitch + more) / 2.0 };
    let slope = if entry == 90.0 { 0.0 } else { depth / entry.to_radians().tan() };
    let [g1, g2] = lengths[form];
    Shape { length: (g1 + slope + g2) / 2.0, depth, entry, radii: [radius; 2], behind: None }
}

fn size([radius, depth, length, behind]: [f64; 4], form: char) -> Shape {
    Shape { length, depth, entry: 15.0, radii: [radius; 2], behind: (form == 'F').then_some(behind) }
}

/// Diameter, `_PITI` and shape of a form.
fn sized(dice: &mut Dice, cycle: Cycle, form: char, inside: bool) -> (f64, usize, Shape) {
    let row = dice.roll(THREADS.len());
    let mut diameter = if inside { real(dice, 60.0, 120.0) } else { real(dice, 3.0, 120.0) };
    let (index, shape) = match form {
        'E' | 'F' if cycle == Cycle::New => {
            let index = dice.roll(LISTED.len());
            (index, size(LISTED[index], form))
        }
        'E' | 'F' => {
            let row = SIZES.iter().find(|(upto, _)| diameter <= *upto).expect("a size");
            (0, size(row.1, form))
        }
        'T' => (0, Shape::free(dice)),
        letter => {
            let entry = if cycle == Cycle::ByThread || chance(dice, 40) { 30.0 } else { real(dice, 30.0, 90.0) };
            if cycle == Cycle::ByThread {
                diameter = THREADS[row].0;
            }
            (THREADS[row].1, thread(row, letter as usize - 'A' as usize, entry))
        }
    };
    (diameter, index, shape)
}

impl Case {
    fn roll(dice: &mut Dice) -> Case {
        let cycle = [Cycle::ByDiameter, Cycle::ByThread, Cycle::New, Cycle::New, Cycle::New][dice.roll(5)];
        let place = dice.roll(4);
        let inside = place >= 2;
        let threads = if inside { ['C', 'D'] } else { ['A', 'B'] };
        let form = match cycle {
            Cycle::ByDiameter => ['E', 'F'][dice.roll(2)],
            Cycle::ByThread => threads[dice.roll(2)],
            Cycle::New => ['E', 'F', threads[0], threads[1], 'T', 'T'][dice.roll(6)],
        };
        let (diameter, index, shape) = sized(dice, cycle, form, inside);
        let new = cycle == Cycle::New;
        let threaded = !matches!(form, 'E' | 'F');
        let raised = match form {
            'E' if new && chance(dice, 40) => [real(dice, 0.05, 0.3), 0.0],
            'F' if new && chance(dice, 40) => [real(dice, 0.05, 0.3), real(dice, 0.0, 0.2)],
            _ => [0.0; 2],
        };
        let leave = match dice.roll(3) {
            0 => Leave::Along(0.0, 0.0),
            1 => Leave::Around(real(dice, 0.05, 0.4).min(shape.depth / 2.0)),
            _ => Leave::Along(real(dice, 0.0, 0.3), real(dice, 0.0, 0.3).min(shape.depth / 2.0)),
        };
        let most = real(dice, 0.2, 2.0);
        let kind = if new && threaded { 1 + dice.roll(3) } else { 2 };
        let least = shape.radii.into_iter().filter(|r| *r > 0.0).fold(f64::INFINITY, f64::min);
        let least = if least.is_finite() { least } else { 1.0 };
        let nose = match dice.roll(20) {
            0 => 0.0,
            1..=3 => least,
            4 => least + real(dice, 0.05, 0.5),
            _ => real(dice, 0.02, 1.0) * least,
        };
        let mut case = Case {
            cycle,
            form,
            place,
            diameter,
            z: real(dice, -80.0, 20.0),
            index,
            shape,
            raised,
            clearance: if new { real(dice, 0.3, 3.0) } else { 1.0 },
            face: None,
            kind,
            most,
            leave,
            position: 0,
            nose: (nose * 1e4).round() / 1e4,
            start: [0.0; 2],
        };
        if new && chance(dice, 70) {
            let least = case.outline().join()[1].max(0.0);
            case.face = Some(((least + real(dice, 0.0, 7.0).powi(2) / 8.0) * 1e3).ceil() / 1e3);
        }
        let positions: Vec<usize> = (1..=9).filter(|k| case.side().center(*k, 1.0).iter().all(|v| *v >= 0.0)).collect();
        let corner = positions.iter().copied().find(|k| case.side().center(*k, 1.0) == [1.0, 1.0]).expect("a corner");
        case.position = if chance(dice, 70) { corner } else { positions[dice.roll(positions.len())] };
        let high = if inside { case.radius() - 1.0 } else { 30.0 };
        case.start = [real(dice, 30.0, 60.0), real(dice, 5.0, high.max(6.0))];
        case
    }

    fn radius(&self) -> f64 {
        match (self.cycle, self.form) {
            (Cycle::ByThread, 'C' | 'D') => {
                let row = THREADS.iter().find(|row| row.0 == self.diameter).expect("a thread");
                (self.diameter - CORE * row.2[0]) / 2.0
            }
            _ => self.diameter / 2.0,
        }
    }

    /// The frame of the corner: along the cylinder and along the face.
    fn side(&self) -> Side {
        let along = if self.place.is_multiple_of(2) { -1.0 } else { 1.0 };
        Side { radial: true, out: if self.place < 2 { 1.0 } else { -1.0 }, along, zero: [self.z, self.radius()] }
    }

    fn outline(&self) -> Outline {
        self.shape.outline(self.raised, [0.0; 2], self.face.unwrap_or(f64::INFINITY))
    }

    fn call(&self) -> String {
        let Case { diameter, z, form, .. } = self;
        let edge = [4, 3, 1, 2][self.place];
        let explicit = if self.position == edge { String::new() } else { format!(",{edge}") };
        match self.cycle {
            Cycle::ByDiameter => return format!("CYCLE94({diameter},{z},\"{form}\"{explicit})"),
            Cycle::ByThread => return format!("CYCLE96({diameter},{z},\"{form}\"{explicit})"),
            Cycle::New => {}
        }
        let [x, along] = self.raised;
        let face = self.face.map_or(String::new(), |n| format!("{:.6}", 2.0 * self.side().depth(n)));
        let head = format!("CYCLE940({diameter},{z},\"{form}\",{},{},{FEED}", self.place, self.clearance);
        if matches!(form, 'E' | 'F') {
            let along = if *form == 'F' { along.to_string() } else { String::new() };
            return format!("{head},,{x},{along},,,,{face},,,,,{},,,2,11)", self.index);
        }
        let (all, fal_x, fal_z) = match self.leave {
            Leave::Around(all) => (all, 0.0, 0.0),
            Leave::Along(z, x) => (0.0, x, z),
        };
        let rough = if self.kind == 2 { ",,,".to_owned() } else { format!("{},{all},{fal_x},{fal_z}", self.most) };
        let entry = self.shape.entry;
        let free = if *form == 'T' {
            let [a, b] = self.shape.radii;
            format!(
                "{},{},{a},{b},{entry},{face},{rough},,,,2,{}",
                self.shape.depth,
                self.shape.length,
                thousands(all) + 11
            )
        } else {
            format!(",,,,{entry},{face},{rough},{},,,2,{}", self.index, thousands(all))
        };
        format!("{head},{},{free})", self.kind)
    }

    fn program(&self) -> String {
        let [z, x] = self.side().part(self.start);
        format!("T1 D1\nG18 G90 DIAMON\nG95 F{FEED} S500 M3\nG0 X{x:.6} Z{z:.6}\n{}\nM30\n", self.call())
    }

    fn settings(&self) -> String {
        format!(
            "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ndecimals = 6\n[tools.1]\nradius = {:?}\norientation = {}\n",
            self.nose, self.position
        )
    }

    /// Is the finished undercut rounder than the nose?
    fn takes_the_nose(&self, radii: [f64; 2]) -> bool {
        self.kind == 1 || radii.iter().all(|r| *r == 0.0 || *r > self.nose - 1e-6)
    }
}

fn thousands(all: f64) -> usize {
    if all > 0.0 { 1000 } else { 0 }
}

/// The place of a move of the nose centre at which it is nearest to the shape, and how near: `round` and less matter.
fn nearest(outline: &Outline, sweep: &Sweep, round: f64) -> (f64, P) {
    let Sweep::Line(a, b) = *sweep else {
        let (a, b) = sweep.ends();
        let count = (((b[0] - a[0]).hypot(b[1] - a[1]) / PACE) as usize).clamp(20, 2000);
        let places = sweep.points(count).into_iter().map(|p| (outline.distance(p), p));
        return places.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, a));
    };
    let long = (b[0] - a[0]).hypot(b[1] - a[1]);
    let (mut at, mut least) = (0.0, (outline.distance(b), b));
    while at < long {
        let p = [a[0] + (b[0] - a[0]) * at / long, a[1] + (b[1] - a[1]) * at / long];
        let distance = outline.distance(p);
        if distance < least.0 {
            least = (distance, p);
        }
        // On a way so long nothing comes nearer than that.
        at += (distance - round).max(PACE);
    }
    least
}

/// What a nose may not come nearer to than its radius and this.
struct Kept {
    outline: Outline,
    by: f64,
}

fn kept(case: &Case) -> Kept {
    let finished = Kept { outline: case.outline(), by: 0.0 };
    if case.kind != 1 {
        return finished;
    }
    match case.leave {
        Leave::Around(by) => Kept { by, ..finished },
        Leave::Along(z, x) => {
            let nearer = Shape { length: case.shape.length - 2.0 * z, ..case.shape };
            let outline = nearer.outline(case.raised, [z, x], case.face.unwrap_or(f64::INFINITY));
            Kept { outline, by: 0.0 }
        }
    }
}

/// No move comes too near.
fn clear(case: &Case, steps: &[Step]) -> Result<(), String> {
    let kept = kept(case);
    for (n, step) in steps.iter().enumerate() {
        let (distance, at) = nearest(&kept.outline, &step.sweep, case.nose + kept.by);
        let inside = step.sweep.points(6).iter().any(|p| kept.outline.is_inside(*p));
        if distance < case.nose + kept.by - NEAR || inside {
            return Err(format!("move {n} {step:?} is {distance} off the shape at {at:?}, the nose is {}", case.nose));
        }
    }
    Ok(())
}

/// All of the finished undercut is touched.
fn complete(case: &Case, steps: &[Step]) -> Result<(), String> {
    let cuts: Vec<&Sweep> = steps.iter().filter(|step| !step.rapid).map(|step| &step.sweep).collect();
    for p in case.outline().samples(case.nose) {
        let near = cuts.iter().map(|sweep| shape::to_sweep(sweep, p)).fold(f64::INFINITY, f64::min);
        if near > case.nose + NEAR {
            return Err(format!("{} stands at {p:?}", near - case.nose));
        }
    }
    Ok(())
}

/// Rapid moves in no material, and level cuts as deep as asked for.
fn removal(case: &Case, steps: &[Step]) -> Result<(), String> {
    let [cylinder, face] = case.raised;
    let surface = |s: f64| if s < face { 1e3 } else { cylinder };
    let mut stock = Stock::new(-4.007, 70.0, COLUMN, surface);
    // The finishing cut takes the allowance.
    let finish = steps.iter().rposition(|step| !step.rapid).unwrap_or(0);
    let finish = steps[..finish].iter().rposition(|step| step.rapid).unwrap_or(0);
    for (n, step) in steps.iter().enumerate() {
        let most = if case.kind == 2 || n > finish { f64::INFINITY } else { case.most + 1e-4 };
        let (a, b) = step.sweep.ends();
        let level = (a[1] - b[1]).abs() < 1e-6 && matches!(step.sweep, Sweep::Line(..));
        let (low, high) = (a[0].min(b[0]), a[0].max(b[0]));
        let mut cuts = Vec::new();
        let mut fault = None;
        stock.swept(&step.sweep, case.nose, |i, y| {
            let (s, now) = (stock.place(i), stock.heights[i]);
            // The column beside an upright face is half in it.
            if step.rapid && y < now - NEAR && y < stock.heights[(i + 1).min(stock.heights.len() - 1)] - NEAR {
                fault.get_or_insert(format!("rapid in stock at {s}: {y} under {now}"));
            }
            if !step.rapid && level && now < 1e2 && s > low && s < high && now - y > most {
                fault.get_or_insert(format!("{} deep at {s}, the infeed is {most}", now - y));
            }
            if !step.rapid && y < now {
                cuts.push((i, y));
            }
        });
        if let Some(fault) = fault {
            return Err(format!("move {n} {step:?}: {fault}"));
        }
        for (i, y) in cuts {
            stock.heights[i] = y;
        }
        if !step.rapid && (step.feed - FEED).abs() > 1e-9 {
            return Err(format!("feed {}", step.feed));
        }
    }
    Ok(())
}

fn one(dice: &mut Dice, tally: &mut Tally) -> Result<(), String> {
    let case = Case::roll(dice);
    let (program, settings) = (case.program(), case.settings());
    let shown = |why: String| format!("{why}\n{settings}{program}{case:?}");
    let made = made(Language::Sinumerik, &program, &settings).map_err(shown)?;
    let shown = |why: String| format!("{why}\n{settings}{program}{case:?}");
    let nearer = match case.leave {
        _ if case.kind == 2 => 0.0,
        Leave::Around(by) => 2.0 * by,
        Leave::Along(z, _) => 2.0 * z,
    };
    let rough = Shape { length: case.shape.length - nearer, ..case.shape };
    let fits = rough.fits();
    let moves = match made {
        Made::Refused("G3049", _)
            if !case.takes_the_nose(case.shape.cut_radii()) || !fits || rough.is_tight(case.nose) =>
        {
            tally.refused += 1;
            return Ok(());
        }
        Made::Refused("G3041" | "P2090", _) if !fits => {
            tally.refused += 1;
            return Ok(());
        }
        Made::Refused("G3048", _) if case.clearance > 0.1 * case.shape.length => {
            tally.refused += 1;
            return Ok(());
        }
        Made::Refused(code, text) => return Err(shown(format!("refused: {code} {text}"))),
        Made::Moves { moves, .. } => moves,
    };
    if !case.takes_the_nose(case.shape.cut_radii()) {
        return Err(shown("a nose that is too large is taken".to_owned()));
    }
    let center = case.side().center(case.position, case.nose);
    let list = steps(case.side(), center, &moves);
    let judged = clear(&case, &list).and_then(|()| removal(&case, &list));
    let judged = judged.and_then(|()| if case.kind == 1 { Ok(()) } else { complete(&case, &list) });
    judged.map_err(shown)?;
    let last = list.last().map(|step| step.sweep.ends().1).unwrap_or_default();
    let home = [case.start[0] + center[0], case.start[1] + center[1]];
    if (last[0] - home[0]).abs() > 1e-5 || (last[1] - home[1]).abs() > 1e-5 {
        return Err(format!("ends in {last:?}\n{program}"));
    }
    tally.cut += 1;
    tally.moves += list.len() as u64;
    Ok(())
}

/// `PARTC_UNDERCUTS` says how many, `PARTC_UNDERCUTS_SEED` which.
#[test]
fn random_undercuts() {
    run("UNDERCUTS", 300, one);
}
