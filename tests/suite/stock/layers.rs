//! Stock removal along contours: random calls of CYCLE95 and CYCLE952.

use core::fmt::Write;

use super::removal::{
    Blank, FINISH, Language, Limits, Made, PLUNGE, Part, Piece, ROUGH, Side, Tally, UNLIMITED, made, run, steps, top,
};
use super::turning::P;
use crate::damage::Dice;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cycle {
    Classic,
    /// With the cylinder of the blank so much larger along x and y.
    Cylinder,
    /// An allowance on the contour.
    Allowance,
    /// A contour of its own.
    Outline,
}

#[derive(Debug)]
struct Case {
    pieces: Vec<Piece>,
    side: Side,
    position: usize,
    cycle: Cycle,
    nose: f64,
    most: f64,
    along: f64,
    up: f64,
    around: f64,
    /// 1 rough, 2 finish after roughing, 3 both.
    operation: usize,
    /// The trace does not overlap.
    steps: bool,
    relief: bool,
    blank: P,
    /// The blank counts from zero, not from the contour.
    absolute: bool,
    outline: Vec<P>,
    limits: Limits,
    lift: f64,
    offset: f64,
    chip: f64,
    by_tip: bool,
    by_edges: bool,
    /// The contour is written from its end.
    reversed: bool,
    /// Where the tool stands before, in the view.
    start: P,
}

pub fn real(dice: &mut Dice, low: f64, high: f64) -> f64 {
    let v = low + (high - low) * dice.roll(10_001) as f64 / 10_000.0;
    (v * 1e3).round() / 1e3
}

pub fn chance(dice: &mut Dice, percent: usize) -> bool {
    dice.roll(100) < percent
}

impl Case {
    fn roll(dice: &mut Dice) -> Case {
        let cycle = [Cycle::Classic, Cycle::Cylinder, Cycle::Allowance, Cycle::Outline][dice.roll(4)];
        let classic = cycle == Cycle::Classic;
        let radial = chance(dice, 50);
        let out = if chance(dice, 50) || (classic && !radial) { 1.0 } else { -1.0 };
        let along = if chance(dice, if classic && radial { 0 } else { 40 }) { 1.0 } else { -1.0 };
        let side = Side { radial, out, along, zero: zero(radial, out, along) };
        let positions = side.positions();
        let position = positions[if chance(dice, 50) { 0 } else { dice.roll(positions.len()) }];
        let nose = if chance(dice, 15) { 0.0 } else { real(dice, 0.1, 1.2) };
        let (along, up) = if chance(dice, 30) { (0.0, 0.0) } else { (real(dice, 0.0, 0.4), real(dice, 0.0, 0.4)) };
        let around = if chance(dice, 40) { real(dice, 0.0, 0.4) } else { 0.0 };
        // CYCLE952 has one of them.
        let (along, up, around) = if classic || around == 0.0 { (along, up, around) } else { (0.0, 0.0, around) };
        let valleys = chance(dice, 45);
        let closes = classic && chance(dice, 70);
        let pieces = contour(dice, valleys, closes);
        let blank = [real(dice, 0.0, 3.0), real(dice, 0.0, 3.0)];
        let limits = if !classic && chance(dice, 35) { limits(dice, &pieces, blank) } else { UNLIMITED };
        let high = top(&pieces);
        let end = pieces.last().map_or(0.0, |piece| piece.to[0]);
        let start = match dice.roll(5) {
            0 => [-real(dice, 10.0, 20.0), real(dice, -3.0, high + 10.0)],
            1 => [real(dice, -10.0, end + 5.0), high + real(dice, 8.0, 15.0)],
            _ => [-12.0, high + 12.0],
        };
        Case {
            side,
            position,
            cycle,
            nose,
            most: real(dice, 0.5, 4.0),
            along,
            up,
            around,
            operation: 1 + dice.roll(3),
            steps: chance(dice, 30),
            relief: classic || chance(dice, 70),
            blank,
            absolute: chance(dice, 40),
            outline: outline(dice, &pieces),
            limits,
            lift: real(dice, 0.3, 1.5),
            offset: real(dice, 0.3, 2.0),
            chip: if chance(dice, 15) { real(dice, 0.5, 6.0) } else { 0.0 },
            by_tip: chance(dice, 15),
            by_edges: chance(dice, 15),
            reversed: chance(dice, 25),
            start,
            pieces,
        }
    }

    fn text(&self) -> String {
        let mut text = String::from("G18 G90 DIAMON G95 F0.5\nT1 D1\nS1000 M3\n");
        let start = self.side.part(self.start);
        writeln!(text, "G0 X{:.6} Z{:.6}", start[1], start[0]).unwrap();
        let operations = if self.operation == 2 { vec![1, 2] } else { vec![self.operation] };
        for operation in operations {
            if self.cycle == Cycle::Classic {
                self.classic(&mut text, operation)
            } else {
                self.stored(&mut text, operation)
            }
        }
        text.push_str("GOTOF SCHLUSS\n");
        if self.cycle == Cycle::Outline {
            let line: Vec<Piece> =
                self.outline.windows(2).map(|pair| Piece { from: pair[0], to: pair[1], arc: None }).collect();
            self.blocks(&mut text, &line, ["BA", "BE"]);
        }
        self.blocks(&mut text, &self.pieces, ["KA", "KE"]);
        text.push_str("SCHLUSS: M30\n");
        text
    }

    /// Allowances along Z and X.
    fn allowances(&self) -> (f64, f64) {
        if self.side.radial { (self.along, self.up) } else { (self.up, self.along) }
    }

    fn classic(&self, text: &mut String, operation: usize) {
        let (z, x) = self.allowances();
        let base = match (self.side.radial, self.side.out > 0.0, self.side.along < 0.0) {
            (true, true, _) => 1,
            (true, false, _) => 3,
            (false, _, true) => 2,
            (false, _, false) => 4,
        };
        let vari = base + [0, 4, 8][operation - 1] + if self.steps { 200 } else { 0 };
        let dwell = if self.chip > 0.0 { 0.5 } else { 0.0 };
        writeln!(
            text,
            "CYCLE95(\"KA:KE\",{},{z},{x},{},{ROUGH},{PLUNGE},{FINISH},{vari},{dwell},{},{})",
            self.most, self.around, self.chip, self.lift
        )
        .unwrap();
    }

    /// CYCLE952 as control editors store it.
    fn stored(&self, text: &mut String, operation: usize) {
        let side = self.side;
        let (z, x) = self.allowances();
        let outside = side.out > 0.0;
        let (units, to, way) = if side.radial {
            (1, if outside { 1 } else { 2 }, if side.along < 0.0 { 3 } else { 4 })
        } else {
            (2, if outside { 3 } else { 4 }, if side.along < 0.0 { 1 } else { 2 })
        };
        let relief = if self.relief { 1 } else { 2 };
        let around = usize::from(self.around > 0.0);
        let vari = format!("{relief}1{around}{to}{way}{operation}{units}");
        let kind = match self.cycle {
            Cycle::Outline => 3,
            Cycle::Allowance => 2,
            _ => 1,
        };
        // The corner of the blank in front of the cuts.
        let corner = side.part([-self.blank[0], top(&self.pieces) + self.blank[1]]);
        let (bz, bx, mode) = match (side.radial, self.absolute && kind == 1) {
            (_, true) => (corner[0], corner[1], 0),
            (true, _) => (self.blank[0], self.blank[1], 110),
            (false, _) => (self.blank[1], self.blank[0], 110),
        };
        let (limits, gmode) = self.limits_written();
        let feed = if operation == 2 { FINISH } else { ROUGH };
        if self.cycle == Cycle::Outline {
            text.push_str("CYCLE62(,2,\"BA\",\"BE\")\n");
        }
        writeln!(text, "CYCLE62(,2,\"KA\",\"KE\")").unwrap();
        writeln!(
            text,
            "CYCLE952(\"P\",,\"\",{vari},{feed},{PLUNGE},0,{},0,0,{x},{z},{},0,{kind},{bx:.6},{bz:.6},{limits},,,,,{},1,,{gmode},12,{mode},1,0,{FINISH})",
            self.most, self.around, self.chip
        )
        .unwrap();
    }

    /// XA, ZA, XB, ZB and the digits that make them valid.
    fn limits_written(&self) -> (String, usize) {
        let Limits { near, far, bottom, top } = self.limits;
        let side = self.side;
        let cut = [near, far].map(|x| x.is_finite().then(|| side.cut(x)));
        let depth = [bottom, top].map(|y| y.is_finite().then(|| side.depth(y)));
        let (z, x) = if side.radial { (cut, depth) } else { (depth, cut) };
        let list = [x[0].map(|v| 2.0 * v), z[0], x[1].map(|v| 2.0 * v), z[1]];
        if list.iter().all(Option::is_none) {
            return ("20,0,80,-78".to_owned(), 0);
        }
        let digits = list.iter().zip([1, 10, 100, 1000]).map(|(v, n)| if v.is_some() { n } else { 0 }).sum::<usize>();
        let shown: Vec<String> = list.iter().map(|v| v.map_or("7".to_owned(), |v| format!("{v:.6}"))).collect();
        (shown.join(","), digits * 10_000 + 1000)
    }

    /// A contour between two labels.
    fn blocks(&self, text: &mut String, pieces: &[Piece], [first, last]: [&str; 2]) {
        let turned = |p: &Piece| Piece { from: p.to, to: p.from, arc: p.arc.map(|(c, ccw)| (c, !ccw)) };
        let list: Vec<Piece> = if self.reversed { pieces.iter().rev().map(turned).collect() } else { pieces.to_vec() };
        let begin = self.side.part(list[0].from);
        writeln!(text, "{first}: G0 X{:.6} Z{:.6}", begin[1], begin[0]).unwrap();
        for (i, piece) in list.iter().enumerate() {
            let mark = if i + 1 == list.len() { format!("{last}: ") } else { String::new() };
            let to = self.side.part(piece.to);
            match piece.arc {
                None => writeln!(text, "{mark}G1 X{:.6} Z{:.6}", to[1], to[0]).unwrap(),
                Some((center, ccw)) => {
                    let (from, c) = (self.side.part(piece.from), self.side.part(center));
                    // Seen with Z to the right and X up, G3 is counter-clockwise.
                    let code = if ccw != self.side.mirrors() { 3 } else { 2 };
                    let (i, k) = ((c[1] - from[1]) / 2.0, c[0] - from[0]);
                    writeln!(text, "{mark}G{code} X{:.6} Z{:.6} I{i:.6} K{k:.6}", to[1], to[0]).unwrap();
                }
            }
        }
    }

    fn config(&self) -> String {
        format!(
            "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ndecimals = 6\n[cycles]\ncycle95_rough = \"{}\"\n\
             release_distance = {:?}\nblank_offset = {:?}\ncut_segmentation = \"{}\"\n\
             [tools.1]\nradius = {:?}\norientation = {}\n",
            if self.by_tip { "tip" } else { "compensated" },
            self.lift,
            self.offset,
            if self.by_edges { "edge" } else { "uniform" },
            self.nose,
            self.position
        )
    }

    fn expected(&self) -> Part {
        let high = top(&self.pieces);
        Part {
            pieces: self.pieces.clone(),
            side: self.side,
            nose: self.nose,
            center: self.side.center(self.position, self.nose),
            relief: self.relief,
            along: self.along,
            up: self.up,
            around: self.around,
            most: self.most,
            blank: match self.cycle {
                Cycle::Classic => Blank::Box { front: 0.0, top: high },
                Cycle::Cylinder => Blank::Box { front: -self.blank[0], top: high + self.blank[1] },
                Cycle::Allowance => Blank::On { along: self.blank[0], up: self.blank[1] },
                Cycle::Outline => Blank::Line(self.outline.clone()),
            },
            limits: self.limits,
            plunge: PLUNGE,
            beyond: self.nose,
            steps: (!(self.by_tip && self.cycle == Cycle::Classic)).then_some(0.0),
        }
    }
}

/// The origin of the view on the part.
pub fn zero(radial: bool, out: f64, along: f64) -> P {
    match (radial, out > 0.0, along > 0.0) {
        (true, true, _) => [0.0, 20.0],
        (true, false, _) => [0.0, 80.0],
        (false, _, false) => [90.0, 0.0],
        (false, _, true) => [10.0, 0.0],
    }
}

/// Borders: in front of the blank, in the contour, above its deepest cut, below the blank.
fn limits(dice: &mut Dice, pieces: &[Piece], blank: P) -> Limits {
    let (high, end) = (top(pieces), pieces.last().map_or(0.0, |piece| piece.to[0]));
    let mut limits = UNLIMITED;
    if chance(dice, 70) {
        limits.far = real(dice, 0.4 * end, 1.1 * end);
        limits.near = -blank[0] - real(dice, 0.0, 5.0);
    }
    if chance(dice, 70) {
        limits.bottom = if chance(dice, 50) { real(dice, -5.0, 0.0) } else { real(dice, 0.0, 0.5 * high) };
        limits.top = real(dice, 0.6 * high, 1.3 * high) + 0.5;
    }
    limits
}

/// A blank about the contour: it begins in front and lies above.
fn outline(dice: &mut Dice, pieces: &[Piece]) -> Vec<P> {
    let (high, end) = (top(pieces), pieces.last().map_or(0.0, |piece| piece.to[0]));
    let front = -real(dice, 0.0, 3.0);
    let mut list = vec![[front, -1.0]];
    let mut at = [front, 0.5 * high + real(dice, 0.5, 3.0)];
    list.push(at);
    while at[0] < end {
        let next = (at[0] + real(dice, 1.0, 15.0)).min(end);
        // Never below the contour.
        let needed = pieces
            .iter()
            .filter(|p| p.from[0] <= next + 1e-9)
            .flat_map(Piece::points)
            .map(|p| p[1])
            .fold(0.0, f64::max)
            + real(dice, 0.5, 3.0);
        let level = at[1].max(needed);
        if level > at[1] + 1e-9 {
            list.push([at[0], level]);
        }
        at = [next, if chance(dice, 30) { level + real(dice, 0.1, 2.0) } else { level }];
        list.push(at);
    }
    list.iter().map(|p| [(p[0] * 1e3).round() / 1e3, (p[1] * 1e3).round() / 1e3]).collect()
}

/// A contour that rises on the whole, from the origin on.
pub fn contour(dice: &mut Dice, valleys: bool, closes: bool) -> Vec<Piece> {
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

fn judge(case: &Case, tally: &mut Tally) -> Result<(), String> {
    let (text, moves, codes) = match made(Language::Sinumerik, &case.text(), &case.config())? {
        Made::Moves { text, moves, codes } => (text, moves, codes),
        // A blank that the allowance fills, a contour that meets itself, an area that begins in the blank, a start in it.
        Made::Refused("G3046" | "S2091" | "G3303" | "G3301", _) => {
            tally.refused += 1;
            return Ok(());
        }
        Made::Refused(code, why) => return Err(format!("{code} {why}")),
    };
    let part = case.expected();
    let steps = steps(case.side, part.center, &moves);
    tally.cut += 1;
    tally.moves += steps.len() as u64;
    tally.valleys += u64::from(codes.contains(&"S8211"));
    part.check(&steps).map_err(|why| format!("{why}\n{text}"))
}

/// The same with fewer elements, as long as it fails.
fn smaller(mut case: Case, mut why: String) -> (Case, String) {
    let mut at = 0;
    while at < case.pieces.len() && case.pieces.len() > 3 && case.cycle != Cycle::Outline {
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
    run("LAYERS", 200, |dice, tally| {
        let case = Case::roll(dice);
        judge(&case, tally).map_err(|why| {
            let (case, why) = smaller(case, why);
            format!("{why}\n{case:?}\n{}{}", case.config(), case.text())
        })
    });
}
