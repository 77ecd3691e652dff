//! Faces with sizes and walls at random: the same properties, column by column.

use std::fmt::Write as _;

use partc::Settings;

use super::super::damage::Dice;
use super::milling::{Cut, EXACT, NOTHING, Stock, track};
use super::pockets::{FINISH, ROUGH, finishing, number};

#[derive(Debug)]
struct Case {
    text: String,
    corner: [f64; 2],
    turn: f64,
    /// Signed.
    size: [f64; 2],
    walls: [[bool; 2]; 2],
    radius: f64,
    depth: f64,
    step: f64,
    floor: f64,
    finish: bool,
}

impl Case {
    fn local(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.turn.to_radians().sin_cos();
        let (dx, dy) = (x - self.corner[0], y - self.corner[1]);
        [dx * cos + dy * sin, dy * cos - dx * sin]
    }

    fn span(&self, axis: usize) -> [f64; 2] {
        [self.size[axis].min(0.0), self.size[axis].max(0.0)]
    }

    /// How far a point of the face's own axes lies in front of the nearest wall.
    fn room(&self, p: [f64; 2]) -> f64 {
        let of = |axis: usize| {
            let [low, high] = self.span(axis);
            let minus = if self.walls[axis][0] { p[axis] - low } else { f64::MAX };
            let plus = if self.walls[axis][1] { high - p[axis] } else { f64::MAX };
            minus.min(plus)
        };
        of(0).min(of(1))
    }

    fn is_on_face(&self, p: [f64; 2], by: f64) -> bool {
        (0..2).all(|axis| p[axis] >= self.span(axis)[0] + by && p[axis] <= self.span(axis)[1] - by)
    }

    /// In the corner of two walls the cutter leaves its rounding.
    fn is_in_corner(&self, p: [f64; 2]) -> bool {
        let into = |axis: usize| {
            let [low, high] = self.span(axis);
            let minus = if self.walls[axis][0] { self.radius - (p[axis] - low) } else { 0.0 };
            let plus = if self.walls[axis][1] { self.radius - (high - p[axis]) } else { 0.0 };
            minus.max(plus).max(0.0)
        };
        into(0) > 0.0 && into(1) > 0.0 && into(0).hypot(into(1)) > self.radius - EXACT
    }

    fn least(&self, cut: &Cut) -> f64 {
        [0.0, 1.0]
            .map(|part| cut.at(part))
            .map(|p| self.room(self.local([p[0], p[1]])))
            .into_iter()
            .fold(f64::MAX, f64::min)
    }

    fn judge(&self, settings: &Settings, shift: f64) -> Result<(), String> {
        let cuts = track(&self.text, settings).map_err(|codes| format!("refused: {codes:?}"))?;
        let cell = self.radius / 4.0;
        let reach = self.size[0].abs().hypot(self.size[1].abs()) + self.radius + 2.0;
        let low = self.corner.map(|v| v - reach - shift * cell);
        let mut stock = Stock::of(low, self.corner.map(|v| v + reach), cell, |p| {
            let p = self.local(p);
            if self.is_on_face(p, 0.0) || self.room(p) < 0.0 { 0.0 } else { NOTHING }
        });
        let rough_floor = -self.depth + self.floor;
        for (cut, finishing) in cuts.iter().zip(finishing(&cuts)) {
            let lowest = cut.from[2].min(cut.to[2]);
            if lowest < 0.0 && self.least(cut) < self.radius - EXACT {
                return Err(format!("gouges a wall: {} at {cut:?}", self.least(cut)));
            }
            let deepest = if finishing { -self.depth } else { rough_floor };
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
        let floor = if self.finish { -self.depth } else { rough_floor };
        for (p, top) in stock.columns() {
            let p = self.local(p);
            if self.room(p) < -EXACT && top < 0.0 {
                return Err(format!("the column at {p:?} in a wall is cut"));
            }
            if self.is_on_face(p, EXACT) && top > floor + EXACT && !self.is_in_corner(p) {
                return Err(format!("the column at {p:?} of the face ends at {top}, not at {floor}"));
            }
        }
        match cuts.last() {
            Some(last) if last.to[2] == 10.0 => Ok(()),
            last => Err(format!("ends below the retract height: {last:?}")),
        }
    }
}

fn random(dice: &mut Dice) -> Case {
    let radius = number(dice, 2.0, 10.0);
    let depth = number(dice, 1.0, 10.0);
    let step = number(dice, depth / 4.0, depth * 1.2);
    let floor = if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, 0.4 * depth) };
    let signed = |dice: &mut Dice| number(dice, 2.0 * radius, 50.0) * if dice.roll(2) == 0 { 1.0 } else { -1.0 };
    let size = [signed(dice), signed(dice)];
    let corner = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    let width = number(dice, 0.2 * radius, 2.0 * radius);
    let tens = 1 + dice.roll(4);
    let along = (tens + 1) % 2;
    let finish = dice.roll(2) == 0;
    let mut text = format!("G17 G90 G71\n$TC_DP6[1,1]={radius}\nT1 D1\nM6\nS3000 M3\nG0 X7 Y3 Z50\n");
    let calls: &[(usize, f64)] = if finish { &[(1, ROUGH), (2, FINISH)] } else { &[(1, ROUGH)] };
    let clearance = if dice.roll(4) == 0 { 0.0 } else { number(dice, 0.5, 5.0) };
    let ([x, y], [length, wide]) = (corner, size);
    let (mut turn, mut walls) = (0.0, [[false; 2]; 2]);
    if dice.roll(3) == 0 {
        turn = if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, 179.0) };
        let over = [number(dice, 0.0, radius), number(dice, 0.0, radius)];
        for (unit, feed) in calls {
            let _ = writeln!(
                text,
                "CYCLE71(10,0,{clearance},{},{x},{y},{length},{wide},{turn},{step},{width},{},{floor},{feed},{tens}{unit},{})",
                -depth, over[0], over[1]
            );
        }
    } else {
        for (axis, of) in walls.iter_mut().enumerate() {
            *of = [dice.roll(2) == 0, dice.roll(2) == 0];
            // The tool comes in by an open end of the paths.
            if axis == along && *of == [true; 2] {
                of[dice.roll(2)] = false;
            }
        }
        let limits: usize = [walls[0][0], walls[0][1], walls[1][0], walls[1][1]]
            .iter()
            .rev()
            .fold(0, |limits, wall| limits * 10 + usize::from(*wall));
        for (unit, feed) in calls {
            let _ = writeln!(
                text,
                "CYCLE61(10,0,{clearance},{},{x},{y},{length},{wide},{step},{width},{floor},{feed},{tens}{unit},{limits},1,11000)",
                -depth
            );
        }
    }
    text.push_str("M30\n");
    Case { text, corner, turn, size, walls, radius, depth, step, floor, finish }
}

#[test]
fn faces_at_random_keep_the_properties_of_cycles() {
    let settings = Settings::default();
    super::milling::many("PARTC_FACES", 150, |dice, shift| {
        let case = random(dice);
        case.judge(&settings, shift).map_err(|why| format!("{why}\n{}{case:?}", case.text)).map(|()| true)
    });
}
