//! Klartext programs in another system, and in inches: their moves are looked at as they were programmed.

use super::super::damage::Dice;
use super::milling::Cut;
use super::pockets::number;

/// Datum shift, rotation and mirror of a program, and its unit in mm.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    shift: [f64; 2],
    angle: f64,
    mirror: [bool; 2],
    pub unit: f64,
}

impl Default for Seen {
    fn default() -> Seen {
        Seen { shift: [0.0; 2], angle: 0.0, mirror: [false; 2], unit: 1.0 }
    }
}

impl Seen {
    /// Half of them are as they were programmed.
    pub fn random(dice: &mut Dice) -> Seen {
        let mut seen = Seen::default();
        if dice.roll(2) == 0 {
            return seen;
        }
        if dice.roll(2) == 0 {
            seen.shift = [0, 1].map(|_| number(dice, -30.0, 30.0));
        }
        if dice.roll(2) == 0 {
            seen.angle = number(dice, -180.0, 180.0);
        }
        seen.mirror = [0, 1].map(|_| dice.roll(3) == 0);
        if dice.roll(3) == 0 {
            seen.unit = 25.4;
        }
        seen
    }

    pub fn word(&self) -> &'static str {
        if self.unit == 1.0 { "MM" } else { "INCH" }
    }

    /// The cycles that set the system.
    pub fn text(&self) -> String {
        let mut text = String::new();
        if self.shift != [0.0; 2] {
            let [x, y] = self.shift;
            text += &format!("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X{x:+}\nCYCL DEF 7.2 Y{y:+}\n");
        }
        match self.mirror {
            [false, false] => {}
            [true, false] => text += "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X\n",
            [false, true] => text += "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 Y\n",
            [true, true] => text += "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X Y\n",
        }
        if self.angle != 0.0 {
            text += &format!("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{:+}\n", self.angle);
        }
        text
    }

    /// The moves in programmed coordinates, at the programmed feeds.
    pub fn programmed(&self, cuts: Vec<Cut>) -> Vec<Cut> {
        let (sin, cos) = self.angle.to_radians().sin_cos();
        let back = |[x, y]: [f64; 2]| {
            let (dx, dy) = (x / self.unit - self.shift[0], y / self.unit - self.shift[1]);
            let turned = [dx * cos + dy * sin, dy * cos - dx * sin];
            [0, 1].map(|i| if self.mirror[i] { -turned[i] } else { turned[i] })
        };
        let place = |p: [f64; 3]| {
            let [x, y] = back([p[0], p[1]]);
            // What the change of the unit rounds.
            [x, y, (p[2] / self.unit * 1e9).round() / 1e9]
        };
        let turn = if self.mirror[0] == self.mirror[1] { 1.0 } else { -1.0 };
        // In inches F counts tenths of an inch.
        let feed = if self.unit == 1.0 { 1.0 } else { self.unit / 10.0 };
        cuts.into_iter()
            .map(|cut| Cut {
                from: place(cut.from),
                to: place(cut.to),
                arc: cut.arc.map(|(center, sweep)| (back(center), turn * sweep)),
                feed: cut.feed.map(|by| (by / feed * 1e6).round() / 1e6),
            })
            .collect()
    }
}
