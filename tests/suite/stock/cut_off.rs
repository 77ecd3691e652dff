//! Cut-off: random calls of CYCLE92, judged by a bar of their own.

use super::grooves::Tool;
use super::layers::{chance, real};
use super::removal::{LOST, Language, Made, Tally, made, run};
use super::turning::{P, Stock};
use crate::damage::Dice;
use crate::meant::{Found, Way};

const FAST: f64 = 0.12;
const SLOW: f64 = 0.04;
const STEP: f64 = 0.01;
/// Pieces of an arc.
const PIECES: usize = 200;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Edge {
    Sharp,
    Round(f64),
    Chamfer(f64),
}

#[derive(Debug)]
struct Case {
    /// Z of the face, and radii: bar, reduced feed, end.
    face: f64,
    bar: f64,
    reduced: f64,
    end: f64,
    edge: Edge,
    clearance: f64,
    width: f64,
    nose: f64,
    plus: bool,
    /// The printed point counts for the face.
    by_tip: bool,
    start: P,
}

impl Case {
    fn roll(dice: &mut Dice) -> Case {
        let width = real(dice, 1.0, 6.0);
        let bar = real(dice, 5.0, 60.0);
        let end = real(dice, -0.6, 0.7 * bar);
        let reduced = end.max(0.0) + real(dice, 0.0, 0.9) * (0.95 * bar - end.max(0.0));
        let size = real(dice, 0.05, 0.6 * (bar - reduced).min(8.0));
        let edge = [Edge::Sharp, Edge::Round(size), Edge::Chamfer(size)][dice.roll(3)];
        let round = |v: f64| (v * 1e3).round() / 1e3;
        let nose = [0.0, (width * 500.0).floor() / 1e3, real(dice, 0.05, width / 4.0), real(dice, 0.05, width / 4.0)]
            [dice.roll(4)];
        let start = if chance(dice, 50) {
            [real(dice, -60.0, 40.0), bar + real(dice, 3.0, 30.0)]
        } else {
            [real(dice, 12.0, 40.0), real(dice, 0.0, bar + 20.0)]
        };
        Case {
            face: real(dice, -50.0, -10.0),
            bar,
            reduced: round(reduced),
            end,
            edge,
            clearance: real(dice, 0.2, 3.0),
            width,
            nose,
            plus: chance(dice, 50),
            by_tip: chance(dice, 30),
            start,
        }
    }

    fn text(&self) -> String {
        let (size, mode) = match self.edge {
            Edge::Sharp => (0.0, 0),
            Edge::Round(size) => (size, 0),
            Edge::Chamfer(size) => (size, 10_000),
        };
        format!(
            "T1 D1\nG18 G90 DIAMON\nG95 F0.3 S800 M3\nG0 X{:.6} Z{:.6}\nCYCLE92({:.6},{},{:.6},{:.6},{size},{},0,0,3,{FAST},{SLOW},300,,0,,2,{mode})\nM30\n",
            2.0 * self.start[1],
            self.start[0],
            2.0 * self.bar,
            self.face,
            2.0 * self.reduced,
            2.0 * self.end,
            self.clearance
        )
    }

    fn config(&self) -> String {
        format!(
            "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ndecimals = 6\n[cycles]\ncutoff_reference = \"{}\"\n\
             [tools.1]\nwidth = {:?}\nradius = {:?}\norientation = {}\n",
            if self.by_tip { "tip" } else { "workpiece" },
            self.width,
            self.nose,
            if self.plus { 4 } else { 3 }
        )
    }

    /// Z of the face that is made.
    fn made_face(&self) -> f64 {
        if self.by_tip && !self.plus { self.face + self.width } else { self.face }
    }

    /// Height of the workpiece `beside` its face.
    fn height(&self, beside: f64) -> f64 {
        match self.edge {
            Edge::Chamfer(c) if beside < c => self.bar - c + beside,
            Edge::Round(r) if beside < r => self.bar - r + (r * r - (r - beside).powi(2)).max(0.0).sqrt(),
            _ => self.bar,
        }
    }
}

/// Points of the edge towards -Z.
fn points(way: &Way, from: P, shift: f64) -> Vec<P> {
    let end = way.end();
    let Way::Arc { center, turns, plane, .. } = way else { return vec![[end[2] + shift, end[0]]] };
    let c = if plane[0] == 2 { [center[0] + shift, center[1]] } else { [center[1] + shift, center[0]] };
    let to = [end[2] + shift, end[0]];
    let angle = |p: P| (p[1] - c[1]).atan2(p[0] - c[0]);
    let ccw = (*turns > 0) == (plane[0] == 2);
    let turn = (angle(to) - angle(from)).rem_euclid(core::f64::consts::TAU);
    let turn = if ccw { turn } else { turn - core::f64::consts::TAU };
    let r = (from[0] - c[0]).hypot(from[1] - c[1]);
    let at = |k: usize| angle(from) + turn * k as f64 / PIECES as f64;
    (1..=PIECES).map(|k| [c[0] + r * at(k).cos(), c[1] + r * at(k).sin()]).collect()
}

fn judge(case: &Case, tally: &mut Tally) -> Result<(), String> {
    let (text, moves) = match made(Language::Sinumerik, &case.text(), &case.config())? {
        Made::Moves { text, moves, .. } => (text, moves),
        Made::Refused(_, why) if why.contains("reach below the diameter") => {
            tally.refused += 1;
            return Ok(());
        }
        Made::Refused(code, why) => return Err(format!("{code} {why}")),
    };
    tally.cut += 1;
    let face = case.made_face();
    let mut stock = Stock::new(-80.0, 5.0, STEP, |z| if z < 0.0 { case.bar } else { f64::NEG_INFINITY });
    let tool = Tool { width: case.width, nose: case.nose };
    let shift = if case.plus { -case.width } else { 0.0 };
    let mut at: Option<P> = None;
    for (n, found) in moves.iter().enumerate() {
        let Found::Move(way, how) = found else { continue };
        let Some(mut from) = at else {
            at = Some([way.end()[2] + shift, way.end()[0]]);
            continue;
        };
        tally.moves += 1;
        let rapid = matches!(way, Way::Rapid(_));
        let fail = |why: String| Err(format!("move {n} {way:?}: {why}\n{text}"));
        for to in points(way, from, shift) {
            for i in 0..stock.heights.len() {
                let z = stock.place(i);
                if z < from[0].min(to[0]) || z > from[0].max(to[0]) + case.width {
                    continue;
                }
                let Some(y) = tool.lowest(from, to, z).filter(|y| *y < stock.heights[i] - LOST) else { continue };
                let beside = z - face;
                if rapid {
                    return fail(format!("rapid {} deep at {z}", stock.heights[i] - y));
                }
                // Upright ends of roundings: a little along is much in depth.
                if beside > LOST && y < case.height((beside - 1e-3).max(0.0)) - 1e-3 {
                    return fail(format!("gouge of {} beside the face by {beside}", case.height(beside) - y));
                }
                if beside < -case.width - LOST {
                    return fail(format!("cuts the rest of the bar at {z}"));
                }
                let slow = y < case.reduced - LOST;
                let feed = how.feed.map_or(0.0, |(_, feed)| feed);
                if feed != FAST && feed != SLOW || slow && feed != SLOW && from[1].min(to[1]) < case.reduced - LOST {
                    return fail(format!("feed {feed} at radius {y}"));
                }
                stock.heights[i] = y;
            }
            from = to;
        }
        at = Some(from);
    }
    // The edge and the cut are done.
    for i in 0..stock.heights.len() {
        let beside = stock.place(i) - face;
        let wanted = if beside > 0.0 {
            // The corner of the tool leaves what its disc does not reach at the sharp ends of a chamfer.
            case.height(beside) + 1e-3
        } else if beside > -case.width + case.nose && beside < -case.nose {
            case.end + 1e-3
        } else {
            continue;
        };
        let reach = if beside > 0.0 { 0.0 } else { LOST };
        if stock.heights[i] > wanted + reach && stock.place(i) < -STEP {
            return Err(format!("{} left beside the face by {beside}\n{text}", stock.heights[i] - wanted));
        }
    }
    let end = at.unwrap_or([0.0; 2]);
    let wanted = [face - case.width, case.bar + case.clearance];
    if (end[0] - wanted[0]).abs() > 1e-5 || (end[1] - wanted[1]).abs() > 1e-5 {
        return Err(format!("ends at {end:?}, not {wanted:?}\n{text}"));
    }
    Ok(())
}

/// `PARTC_CUTOFFS` says how many, `PARTC_CUTOFFS_SEED` which.
#[test]
fn random_bars_are_cut_off() {
    run("CUTOFFS", 100, |dice, tally| {
        let case = Case::roll(dice);
        judge(&case, tally).map_err(|why| format!("{why}\n{case:?}\n{}{}", case.config(), case.text()))
    });
}
