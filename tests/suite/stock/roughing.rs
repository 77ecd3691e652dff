//! Roughing of HEIDENHAIN controls: random calls of G81, G82, G810 to G829.

use core::fmt::Write;

use super::layers::{chance, contour, real, zero};
use super::removal::{
    Blank, Language, Made, PLUNGE, Part, Piece, ROUGH, Side, Step, Tally, UNLIMITED, made, run, steps, top,
};
use super::turning::P;
use crate::damage::Dice;

#[derive(Debug)]
struct Case {
    pieces: Vec<Piece>,
    side: Side,
    position: usize,
    nose: f64,
    /// Last digit of G81x and G82x, 0 along a finished part; `None` for G81 and G82 themselves.
    kind: Option<usize>,
    most: f64,
    along: f64,
    up: f64,
    /// H: 0 follows each cut, 1 the last one, 2 none.
    smoothing: usize,
    /// Q1: to the depth at feed.
    fed: bool,
    /// V1: back to the start.
    back: bool,
    /// The oversize stands in G57.
    apart: bool,
    /// The contour is written from its end.
    reversed: bool,
    clearance: f64,
    /// E: the plunge feed, 0, or missing.
    plunge: Option<f64>,
    /// Where the tool stands before, in the view.
    start: P,
}

/// Does a line go back over the one before? A fin without thickness is no part.
fn doubles_back(pieces: &[Piece]) -> bool {
    let way = |piece: &Piece| [piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]];
    pieces.windows(2).any(|pair| {
        let ([a, b], [c, d]) = (way(&pair[0]), way(&pair[1]));
        let straight = pair.iter().all(|piece| piece.arc.is_none());
        straight && (a * d - b * c).abs() < 1e-6 && a * c + b * d < 0.0
    })
}

impl Case {
    fn roll(dice: &mut Dice) -> Case {
        let radial = chance(dice, 60);
        let out = if chance(dice, 60) { 1.0 } else { -1.0 };
        let along = if chance(dice, 30) { 1.0 } else { -1.0 };
        let side = Side { radial, out, along, zero: zero(radial, out, along) };
        let kind = match dice.roll(8) {
            0 => None,
            // In a bore it needs one in the blank.
            1 | 2 if !radial || out > 0.0 => Some(0),
            _ => Some(7 + dice.roll(3)),
        };
        let mut pieces = if kind.is_some() {
            let (valleys, closes) = (chance(dice, if matches!(kind, Some(0 | 9)) { 70 } else { 30 }), chance(dice, 50));
            contour(dice, valleys, closes)
        } else {
            let (length, height) = (real(dice, 0.5, 40.0), real(dice, 0.5, 15.0));
            let line = |from, to| Piece { from, to, arc: None };
            vec![line([0.0, 0.0], [length, 0.0]), line([length, 0.0], [length, height])]
        };
        if kind.is_some() && pieces[0].to[0] > 0.0 && chance(dice, 15) {
            // A face in front of all.
            let high = real(dice, 0.5, 6.0);
            for piece in &mut pieces {
                let shift = |p: P| [p[0], p[1] + high];
                (piece.from, piece.to) = (shift(piece.from), shift(piece.to));
                piece.arc = piece.arc.map(|(c, ccw)| (shift(c), ccw));
            }
            pieces.insert(0, Piece { from: [0.0, 0.0], to: [0.0, high], arc: None });
        }
        if doubles_back(&pieces) {
            return Case::roll(dice);
        }
        let corners: Vec<usize> = side.positions().into_iter().filter(|position| *position <= 4).collect();
        let position = corners[if chance(dice, 80) { 0 } else { dice.roll(corners.len()) }];
        let nose = if kind.is_none() || chance(dice, 15) { 0.0 } else { real(dice, 0.1, 1.2) };
        let (along, up) = if chance(dice, 40) { (0.0, 0.0) } else { (real(dice, 0.0, 0.4), real(dice, 0.0, 0.4)) };
        let front = if chance(dice, 15) { 0.0 } else { -real(dice, 0.1, 5.0) };
        let above = if kind.is_none() || chance(dice, 15) { 0.0 } else { real(dice, 0.0, 3.0) };
        // A nose that lies ahead of its point reaches over the contour.
        let ahead = side.center(position, nose)[0] > 0.0;
        Case {
            start: [front, top(&pieces) + above + if ahead { up } else { 0.0 }],
            pieces,
            side,
            position,
            nose,
            kind,
            most: real(dice, 0.5, 4.0),
            along,
            up,
            smoothing: dice.roll(3),
            fed: chance(dice, 30),
            back: chance(dice, 50),
            apart: kind.is_none() || chance(dice, 40),
            reversed: chance(dice, 30),
            clearance: real(dice, 0.3, 2.0),
            plunge: [None, Some(0.0), Some(PLUNGE)][dice.roll(3)],
        }
    }

    fn text(&self) -> String {
        if self.kind == Some(0) {
            let contour = self.contour();
            return format!(
                "HEADER\n#UNIT METRIC\nFINISHED PART\n{contour}MACHINING\n{} NS10 NE{}\nEND\n",
                self.call(),
                9 + self.pieces.len()
            );
        }
        let contour = if self.kind.is_some() { self.contour() + "N9000 G80\n" } else { String::new() };
        format!("%1.nc\n{}\n{contour}END\n", self.call())
    }

    /// Tool, start, and the cycle itself.
    fn call(&self) -> String {
        let far = self.side.part([self.start[0] - 3.0, self.start[1] + 3.0]);
        let start = self.side.part(self.start);
        let mut text = format!(
            "N501 T1 G95 F{ROUGH} G97 S800 M3\nN502 G0 X{:.6} Z{:.6}\nN503 G0 X{:.6} Z{:.6}\nN504 G47 P{}\n",
            far[1], far[0], start[1], start[0], self.clearance
        );
        let (z, x) = if self.side.radial { (self.along, self.up) } else { (self.up, self.along) };
        if self.apart && (z > 0.0 || x > 0.0) {
            let sign = if self.kind.is_none() && self.side.radial && self.side.out < 0.0 { -1.0 } else { 1.0 };
            writeln!(text, "N505 G57 X{:.6} Z{z:.6}", sign * 2.0 * x).unwrap();
        }
        let base = if self.side.radial { 81 } else { 82 };
        let Some(kind) = self.kind else {
            let corner = self.side.part(self.pieces[0].to);
            let infeed = if self.side.radial { "I" } else { "K" };
            let (fed, back) = (u8::from(self.fed), u8::from(self.back));
            write!(text, "N506 G{base} X{:.6} Z{:.6} {infeed}{} Q{fed} V{back}", corner[1], corner[0], self.most)
                .unwrap();
            return text;
        };
        write!(text, "N506 G{base}{kind} P{} H{}", self.most, self.smoothing).unwrap();
        if !self.apart {
            write!(text, " I{:.6} K{z:.6}", 2.0 * x).unwrap();
        }
        if let (0 | 9, Some(feed)) = (kind, self.plunge) {
            write!(text, " E{feed}").unwrap();
        }
        text
    }

    /// From N9 on.
    fn contour(&self) -> String {
        let turned = |p: &Piece| Piece { from: p.to, to: p.from, arc: p.arc.map(|(c, ccw)| (c, !ccw)) };
        let list: Vec<Piece> =
            if self.reversed { self.pieces.iter().rev().map(turned).collect() } else { self.pieces.clone() };
        let first = self.side.part(list[0].from);
        let mut text = format!("N9 G0 X{:.6} Z{:.6}\n", first[1], first[0]);
        for (i, piece) in list.iter().enumerate() {
            let to = self.side.part(piece.to);
            let (code, radius) = match piece.arc {
                None => (1, String::new()),
                Some((c, ccw)) => {
                    let r = (c[0] - piece.from[0]).hypot(c[1] - piece.from[1]);
                    (if ccw != self.side.mirrors() { 3 } else { 2 }, format!(" R{r:.6}"))
                }
            };
            writeln!(text, "N{} G{code} X{:.6} Z{:.6}{radius}", 10 + i, to[1], to[0]).unwrap();
        }
        text
    }

    /// Falling parts are cut.
    fn plunges(&self) -> bool {
        match self.kind {
            Some(0) => self.plunge.is_some_and(|feed| feed > 0.0),
            Some(9) => self.plunge != Some(0.0),
            _ => false,
        }
    }

    fn config(&self) -> String {
        format!(
            "[machine]\nkind = \"lathe\"\n[output]\ndecimals = 6\n[tools.1]\nkind = \"turn\"\nradius = {:?}\norientation = {}\n",
            self.nose, self.position
        )
    }

    fn expected(&self) -> Part {
        let stays = self.kind.is_some() && self.smoothing == 2;
        Part {
            pieces: self.pieces.clone(),
            side: self.side,
            nose: self.nose,
            center: self.side.center(self.position, self.nose),
            relief: self.plunges(),
            along: self.along,
            up: self.up,
            around: 0.0,
            most: self.most,
            blank: Blank::Box { front: self.start[0], top: self.start[1] },
            limits: UNLIMITED,
            plunge: if self.plunge.is_none() { ROUGH / 2.0 } else { PLUNGE },
            beyond: -self.along,
            steps: Some(if stays { self.most } else { 0.0 }),
        }
    }

    /// Where the cuts begin or in the start itself.
    fn ends(&self, part: &Part, steps: &[Step]) -> Result<(), String> {
        let beside = match self.kind {
            None => !self.back,
            Some(kind) => kind == 7,
        };
        if !beside {
            return part.comes_back(steps);
        }
        let start = self.start[0] + part.center[0];
        let last = steps.last().map(|step| step.sweep.ends().1).ok_or("no move")?;
        if (last[0] - start).abs() < 1e-5 { Ok(()) } else { Err(format!("ends in {last:?}, not beside {start}")) }
    }
}

fn judge(case: &Case, tally: &mut Tally) -> Result<(), String> {
    let (text, moves, codes) = match made(Language::Turning, &case.text(), &case.config())? {
        Made::Moves { text, moves, codes } => (text, moves, codes),
        // The oversize fills the blank, the contour falls on the whole, steps stand in front of a relief cut.
        Made::Refused("G3046" | "T2025" | "G3047", _) => {
            tally.refused += 1;
            return Ok(());
        }
        // With nothing above the contour no side is told from the other.
        Made::Refused("G3302", _) if case.start[1] <= top(&case.pieces) => {
            tally.refused += 1;
            return Ok(());
        }
        Made::Refused(code, why) => return Err(format!("{code} {why}")),
    };
    let part = case.expected();
    let steps = steps(case.side, part.center, &moves);
    tally.cut += 1;
    tally.moves += steps.len() as u64;
    tally.valleys += u64::from(codes.contains(&"T2031"));
    part.cut(&steps).and_then(|()| case.ends(&part, &steps)).map_err(|why| format!("{why}\n{text}"))
}

/// The same with fewer elements, as long as it fails.
fn smaller(mut case: Case, mut why: String) -> (Case, String) {
    let mut at = 0;
    while case.kind.is_some() && at < case.pieces.len() && case.pieces.len() > 1 {
        let old = case.pieces.clone();
        let removed = case.pieces.remove(at);
        let shift = |p: P| [p[0] - removed.to[0] + removed.from[0], p[1] - removed.to[1] + removed.from[1]];
        for piece in &mut case.pieces[at..] {
            (piece.from, piece.to) = (shift(piece.from), shift(piece.to));
            piece.arc = piece.arc.map(|(c, ccw)| (shift(c), ccw));
        }
        match judge(&case, &mut Tally::default()) {
            Err(next) => why = next,
            Ok(()) => {
                case.pieces = old;
                at += 1;
            }
        }
    }
    (case, why)
}

/// `PARTC_ROUGHING` says how many, `PARTC_ROUGHING_SEED` which.
#[test]
fn random_contours_are_roughed_right() {
    run("ROUGHING", 200, |dice, tally| {
        let case = Case::roll(dice);
        judge(&case, tally).map_err(|why| {
            let (case, why) = smaller(case, why);
            format!("{why}\n{case:?}\n{}{}", case.config(), case.text())
        })
    });
}
