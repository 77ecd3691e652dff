//! Spigots with sizes and blanks at random: the same properties, column by column.

use std::fmt::Write as _;

use partc::Settings;

use super::super::common::settings;
use super::super::damage::Dice;
use super::milling::{Cut, EXACT, NOTHING, Stock, beside, track};
use super::pockets::{FINISH, PLUNGE, ROUGH, finishing, number};

/// A finished outline, or that of a blank, about its own origin.
#[derive(Debug, Clone)]
pub(super) enum Outline {
    Rectangle { half: [f64; 2], corner: f64 },
    Circle { radius: f64 },
    Polygon { corners: Vec<[f64; 2]> },
}

#[derive(Debug)]
struct Case {
    text: String,
    outline: Outline,
    blank: Outline,
    at: [f64; 2],
    turn: f64,
    radius: f64,
    depth: f64,
    step: f64,
    wall: f64,
    floor: f64,
    finish: bool,
    /// What of a multi-edge lies on the first axis.
    starts: usize,
}

impl Outline {
    /// Distance of a point from the outline, below 0 inside.
    pub(super) fn outside(&self, [x, y]: [f64; 2]) -> f64 {
        match self {
            Outline::Rectangle { half, corner } => beside([x, y], *half, *corner),
            Outline::Circle { radius } => x.hypot(y) - radius,
            Outline::Polygon { corners } => {
                let sides = corners.iter().zip(corners.iter().cycle().skip(1));
                let (mut nearest, mut out) = (f64::MAX, false);
                for (a, b) in sides {
                    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
                    let t = (((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
                    nearest = nearest.min((x - a[0] - t * dx).hypot(y - a[1] - t * dy));
                    out |= dx * (y - a[1]) - dy * (x - a[0]) < 0.0;
                }
                if out { nearest } else { -nearest }
            }
        }
    }
}

impl Case {
    fn local(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.turn.to_radians().sin_cos();
        let (dx, dy) = (x - self.at[0], y - self.at[1]);
        [dx * cos + dy * sin, dy * cos - dx * sin]
    }

    fn least(&self, cut: &Cut) -> f64 {
        let count = if cut.is_vertical() { 1 } else { 24 };
        let points = (0..=count).map(|i| cut.at(f64::from(i) / f64::from(count)));
        points.map(|p| self.outline.outside(self.local([p[0], p[1]]))).fold(f64::MAX, f64::min)
    }

    fn judge(&self, settings: &[Settings; 2], shift: f64) -> Result<(), String> {
        let cuts = track(&self.text, &settings[self.starts]).map_err(|codes| format!("refused: {codes:?}"))?;
        let cell = self.radius / 4.0;
        let size = match self.blank {
            Outline::Rectangle { half, .. } => half[0].hypot(half[1]),
            Outline::Circle { radius } => radius,
            Outline::Polygon { .. } => 0.0,
        };
        let low = self.at.map(|v| v - size - 1.0 - shift * cell);
        let is_blank = |p| self.blank.outside(self.local(p)) <= 0.0;
        let mut stock =
            Stock::of(low, self.at.map(|v| v + size + 1.0), cell, |p| if is_blank(p) { 0.0 } else { NOTHING });
        let rough_floor = -self.depth + self.floor;
        for (cut, finishing) in cuts.iter().zip(finishing(&cuts)) {
            let lowest = cut.from[2].min(cut.to[2]);
            let (wall, deepest) = if finishing { (0.0, -self.depth) } else { (self.wall, rough_floor) };
            if lowest < 0.0 && self.least(cut) < self.radius + wall - EXACT {
                return Err(format!("gouges the spigot: {} of {} at {cut:?}", self.least(cut), self.radius + wall));
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
        let (wall, floor) = if self.finish { (0.0, -self.depth) } else { (self.wall, rough_floor) };
        for (p, top) in stock.columns().filter(|(_, top)| *top > NOTHING) {
            let out = self.outline.outside(self.local(p));
            if out < wall - EXACT && top < 0.0 {
                return Err(format!("the column at {p:?} of the spigot is cut"));
            }
            if out > wall + EXACT && top > floor + EXACT {
                return Err(format!("the column at {p:?} ends at {top}, not at {floor}"));
            }
        }
        match cuts.last() {
            Some(last) if last.to[2] == 10.0 => Ok(()),
            last => Err(format!("ends below the retract height: {last:?}")),
        }
    }
}

fn random(dice: &mut Dice) -> Case {
    let radius = number(dice, 1.0, 10.0);
    let depth = number(dice, 1.0, 12.0);
    let step = number(dice, depth / 5.0, depth * 1.2);
    let some = |dice: &mut Dice, high: f64| if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, high) };
    let (wall, floor) = (some(dice, 0.6 * radius), some(dice, 0.4 * depth));
    let at = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    let turn = if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, 180.0) };
    let (direction, clearance) = (dice.roll(4), number(dice, 0.5, 5.0));
    let finish = dice.roll(2) == 0;
    let calls: &[(usize, f64)] = if finish { &[(1, ROUGH), (2, FINISH)] } else { &[(1, ROUGH)] };
    let [x, y] = at;
    let mut text =
        format!("G17 G90 G71\n$TC_DP6[1,1]={radius}\nT1 D1\nM6\nS3000 M{}\nG0 X7 Y3 Z50\n", 3 + dice.roll(2));
    // What one circuit takes off, also the one that finishes.
    let reach = 2.0 * radius + if finish && floor > 0.0 { 0.0 } else { wall };
    let starts = dice.roll(2);
    let (mut turned, outline, blank);
    turned = turn;
    match dice.roll(3) {
        0 => {
            let half = [number(dice, 1.0, 20.0), number(dice, 1.0, 20.0)];
            // A blank with sharp corners stands out by 0.4142 of their radius.
            let corner = some(dice, half[0].min(half[1]).min(reach / 0.4143));
            // The corner of the blank stands out most.
            let most = ((reach + corner) / std::f64::consts::SQRT_2 - corner).max(0.0);
            let size = half.map(|half| half + number(dice, 0.0, most.max(0.001)).min(most));
            let (p, q) = (2.0 * half[0], 2.0 * half[1]);
            for (unit, feed) in calls {
                let _ = writeln!(
                    text,
                    "CYCLE76(10,0,{clearance},,{depth},{p},{q},{corner},{x},{y},{turn},{step},{wall},{floor},{feed},{PLUNGE},{direction},{unit},{},{},0,0,0,1,1)",
                    2.0 * size[0],
                    2.0 * size[1]
                );
            }
            (outline, blank) = (Outline::Rectangle { half, corner }, Outline::Rectangle { half: size, corner: 0.0 });
        }
        1 => {
            turned = 0.0;
            let size = number(dice, 1.0, 20.0);
            let around = size + number(dice, 0.0, reach - 0.001);
            for (unit, feed) in calls {
                let _ = writeln!(
                    text,
                    "CYCLE77(10,0,{clearance},,{depth},{},{x},{y},{step},{wall},{floor},{feed},{PLUNGE},{direction},{unit},{},0,0,0,1,1)",
                    2.0 * size,
                    2.0 * around
                );
            }
            (outline, blank) = (Outline::Circle { radius: size }, Outline::Circle { radius: around });
        }
        _ => {
            let edges = 3 + dice.roll(8);
            let size = number(dice, 2.0, 30.0);
            let half = std::f64::consts::PI / edges as f64;
            let apothem = if edges.is_multiple_of(2) { size / 2.0 } else { size / half.tan() / 2.0 };
            let around = apothem * number(dice, 1.0, 1.8) / half.cos();
            let width = number(dice, 0.3 * radius, 2.0 * radius);
            for (unit, feed) in calls {
                let _ = writeln!(
                    text,
                    "CYCLE79(10,0,{clearance},{depth},{edges},{size},{x},{y},{turn},0,{},{width},{step},{wall},{floor},{feed},{direction},{unit},0,0,0,1,1)",
                    2.0 * around
                );
            }
            let first = if starts == 0 { half } else { 0.0 };
            let corner = |i: usize| {
                let (sin, cos) = (first + 2.0 * half * i as f64).sin_cos();
                [apothem / half.cos() * cos, apothem / half.cos() * sin]
            };
            (outline, blank) =
                (Outline::Polygon { corners: (0..edges).map(corner).collect() }, Outline::Circle { radius: around });
        }
    }
    text.push_str("M30\n");
    Case { text, outline, blank, at, turn: turned, radius, depth, step, wall, floor, finish, starts }
}

#[test]
fn spigots_at_random_keep_the_properties_of_cycles() {
    let starts = ["edge", "corner"].map(|what| settings(&format!("[cycles]\nmulti_edge_start = \"{what}\"\n")));
    super::milling::many("PARTC_SPIGOTS", 150, |dice, shift| {
        let case = random(dice);
        case.judge(&starts, shift).map_err(|why| format!("{why}\n{}{case:?}", case.text)).map(|()| true)
    });
}
