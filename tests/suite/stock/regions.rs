//! Pockets along contours at random, with islands: the same properties, column by column.

use std::fmt::Write as _;

use partc::Settings;

use super::super::damage::Dice;
use super::milling::{Cut, EXACT, Stock, many, track_of};
use super::pockets::{FINISH, PLUNGE, ROUGH, finishing, number};

/// How much nearer than asked a path may come: what the rings of a contour may lose.
const NEARER: f64 = 2e-5;

pub type P = [f64; 2];

/// A closed polygon, or a circle.
#[derive(Debug, Clone)]
pub enum Ring {
    Corners(Vec<P>),
    Circle { center: P, radius: f64 },
}

#[derive(Debug)]
pub struct Case {
    pub language: &'static str,
    pub text: String,
    /// The outline, and the islands.
    pub rings: Vec<Ring>,
    pub radius: f64,
    pub depth: f64,
    pub step: f64,
    pub wall: f64,
    pub floor: f64,
    /// Wall and floor are finished.
    pub finish: [bool; 2],
    /// What is left on the wall then.
    pub left: f64,
    /// Radius of the path in inside corners.
    pub corners: f64,
}

fn to_segment(p: P, a: P, b: P) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let t = (((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    (p[0] - a[0] - t * dx).hypot(p[1] - a[1] - t * dy)
}

impl Ring {
    fn sides(corners: &[P]) -> impl Iterator<Item = (P, P)> + '_ {
        corners.iter().enumerate().map(|(i, a)| (*a, corners[(i + 1) % corners.len()]))
    }

    pub fn distance(&self, p: P) -> f64 {
        match self {
            Ring::Corners(corners) => Ring::sides(corners).map(|(a, b)| to_segment(p, a, b)).fold(f64::MAX, f64::min),
            Ring::Circle { center, radius } => ((p[0] - center[0]).hypot(p[1] - center[1]) - radius).abs(),
        }
    }

    fn holds(&self, p: P) -> bool {
        match self {
            Ring::Corners(corners) => {
                Ring::sides(corners)
                    .filter(|(a, b)| {
                        (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
                    })
                    .count()
                    % 2
                    == 1
            }
            Ring::Circle { center, radius } => (p[0] - center[0]).hypot(p[1] - center[1]) < *radius,
        }
    }

    fn contour(&self, name: &str) -> String {
        let mut text = format!("E_LAB_A_{name}:\n");
        match self {
            Ring::Corners(corners) => {
                for (at, p) in corners.iter().chain(corners.first()).enumerate() {
                    let _ = writeln!(text, "G{} X{} Y{}", usize::from(at > 0), p[0], p[1]);
                }
            }
            Ring::Circle { center: [x, y], radius } => {
                let _ = writeln!(text, "G0 X{} Y{y}\nG3 X{} Y{y} I{} J0", x + radius, x + radius, -radius);
            }
        }
        let _ = writeln!(text, "E_LAB_E_{name}:");
        text
    }
}

impl Case {
    /// Distance from the nearest wall, below 0 in the walls.
    fn room(&self, p: P) -> f64 {
        let nearest = self.rings.iter().map(|ring| ring.distance(p)).fold(f64::MAX, f64::min);
        let (outline, islands) = self.rings.split_first().expect("an outline");
        if outline.holds(p) && !islands.iter().any(|island| island.holds(p)) { nearest } else { -nearest }
    }

    fn least(&self, cut: &Cut) -> f64 {
        let count = if cut.is_vertical() { 1 } else { 24 };
        let points = (0..=count).map(|i| cut.at(f64::from(i) / f64::from(count)));
        points.map(|p| self.room([p[0], p[1]])).fold(f64::MAX, f64::min)
    }

    /// Cuts the blank and says what is wrong; false where the cutter was said to have no path.
    pub fn judge(&self, shift: f64) -> Result<bool, String> {
        let cuts = match track_of(self.language, &self.text, &Settings::default()) {
            Ok(cuts) => cuts,
            Err(codes)
                if codes.iter().all(|code| code.starts_with("G3321") || code.contains("no room for the radius Q8")) =>
            {
                return Ok(false);
            }
            Err(codes) => return Err(format!("refused: {codes:?}")),
        };
        let size = 62.0;
        let cell = self.radius / 4.0;
        let mut stock = Stock::new([-size - shift * cell; 2], [size; 2], cell);
        let (floor, rough_floor) = (-self.depth, -self.depth + self.floor);
        for (cut, finishing) in cuts.iter().zip(finishing(&cuts)) {
            let lowest = cut.from[2].min(cut.to[2]);
            if lowest < 0.0 {
                let wall = if finishing && self.finish[0] { self.left } else { self.wall };
                let found = self.least(cut);
                if found < self.radius + wall - NEARER {
                    return Err(format!("gouges the wall: {found} of {} at {cut:?}", self.radius + wall));
                }
                let deepest = if finishing { floor } else { rough_floor };
                if lowest < deepest - EXACT {
                    return Err(format!("gouges the floor: {lowest} of {deepest} at {cut:?}"));
                }
            }
            let met = stock.cut(cut, self.radius);
            if cut.is_rapid() && met.depth > EXACT {
                return Err(format!("rapid traverse through {:?}: {cut:?}", met.at));
            }
            let level = (cut.from[2] - cut.to[2]).abs() < 1e-12;
            if level && !finishing && met.depth > self.step + EXACT {
                return Err(format!("an infeed of {}: {cut:?}", met.depth));
            }
        }
        self.complete(&stock, cell)?;
        Ok(true)
    }

    /// Every column that a cutter between the walls can reach is cut down to the floor.
    fn complete(&self, stock: &Stock, cell: f64) -> Result<(), String> {
        let wall = if self.finish[0] { self.left } else { self.wall };
        let floor = if self.finish[1] && !self.finish[0] { -self.depth } else { -self.depth + self.floor };
        // In inside corners the path is as round as that of a larger cutter.
        let (least, reach) = (self.radius + wall + self.corners, self.radius + self.corners);
        for (p, top) in stock.columns() {
            if top < 0.0 && self.room(p) < -EXACT {
                return Err(format!("the column at {p:?} in the wall is cut"));
            }
            let stands = top > floor + EXACT && self.room(p) >= wall;
            // Could a cutter between the walls stand over it?
            if stands && stock.around(p, reach - EXACT).any(|c| self.room(c) >= least) {
                return Err(format!("the column at {p:?} ends at {top}, not at {floor} (columns {cell} apart)"));
            }
        }
        Ok(())
    }
}

/// A star about the origin, in either sense.
pub fn star(dice: &mut Dice) -> Vec<P> {
    let count = 3 + dice.roll(7);
    let start = number(dice, 0.0, 360.0);
    let round = |v: f64| (v * 1000.0).round() / 1000.0;
    let mut corners: Vec<P> = (0..count)
        .map(|i| {
            let angle = (start + 360.0 * i as f64 / count as f64).to_radians();
            let far = number(dice, 18.0, 55.0);
            [round(far * angle.cos()), round(far * angle.sin())]
        })
        .collect();
    if dice.roll(2) == 0 {
        corners.reverse();
    }
    corners
}

/// A star, and islands in it that keep off each other.
fn random(dice: &mut Dice) -> Case {
    let radius = number(dice, 1.5, 5.0);
    let depth = number(dice, 1.0, 8.0);
    let step = number(dice, depth / 3.0, depth * 1.2);
    let some = |dice: &mut Dice, high: f64| if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, high) };
    let (wall, floor) = (some(dice, 0.4 * radius), some(dice, 0.3 * depth));
    let round = |v: f64| (v * 1000.0).round() / 1000.0;
    let mut rings = vec![Ring::Corners(star(dice))];
    for _ in 0..dice.roll(4) {
        let center = [number(dice, -25.0, 25.0), number(dice, -25.0, 25.0)];
        let size = number(dice, 1.0, 7.0);
        let free = |p: P| {
            rings[0].holds(p)
                && rings.iter().all(|ring| ring.distance(p) > size + 0.01)
                && !rings[1..].iter().any(|ring| ring.holds(p))
        };
        if free(center) {
            rings.push(match dice.roll(2) {
                0 => Ring::Circle { center, radius: size },
                _ => {
                    let turn = number(dice, 0.0, 90.0);
                    let corner = |i: usize| {
                        let (sin, cos) = (turn + 90.0 * i as f64).to_radians().sin_cos();
                        [round(center[0] + size * cos), round(center[1] + size * sin)]
                    };
                    Ring::Corners((0..4).map(corner).collect())
                }
            });
        }
    }
    let (tens, er, ep, ew) = match dice.roll(3) {
        0 => (0, 0.0, 0.0, 0.0),
        1 => (1, number(dice, 0.0, 6.0), number(dice, 0.3, 3.0), 0.0),
        _ => (2, 0.0, 0.0, number(dice, 2.0, 30.0)),
    };
    let mut text = format!("G17 G90 G71\n$TC_DP6[1,1]={radius}\nT1 D1\nM6\nS3000 M3\nG0 X7 Y3 Z50\n");
    let width = number(dice, 0.4 * radius, 2.0 * radius);
    let (direction, lift) = (dice.roll(4), 1000 * dice.roll(2));
    let given = dice.roll(3) == 0;
    let (begin, at) = if given { (10_000, [number(dice, -9.0, 9.0), number(dice, -9.0, 9.0)]) } else { (0, [0.0; 2]) };
    let mut call = |unit: usize, feed: f64| {
        for i in 0..rings.len() {
            let _ = writeln!(text, "CYCLE62(\"R{i}\",1,,)");
        }
        let _ = writeln!(
            text,
            "CYCLE63(\"P\",{},10,0,2,{},{feed},{PLUNGE},{width},{step},{wall},{floor},{direction},{},{},{er},{ep},{ew})",
            unit + 10 * tens + lift + begin,
            -depth,
            at[0],
            at[1]
        );
    };
    call(1, ROUGH);
    let finish = [dice.roll(2) == 0, dice.roll(2) == 0];
    if finish[0] {
        call(4, FINISH);
    }
    if finish[1] {
        call(3, FINISH);
    }
    text.push_str("M30\n");
    for (i, ring) in rings.iter().enumerate() {
        text += &ring.contour(&format!("R{i}"));
    }
    // The floor is finished up to the allowance on the wall, the wall down to that on the floor.
    let (left, corners, language) = (0.0, 0.0, "sinumerik");
    Case { language, text, rings, radius, depth, step, wall, floor, finish, left, corners }
}

#[test]
fn contour_pockets_at_random_keep_the_properties_of_cycles() {
    many("PARTC_REGIONS", 15, |dice, shift| {
        let case = random(dice);
        case.judge(shift).map_err(|why| format!("{why}\n{}{case:?}", case.text))
    });
}
