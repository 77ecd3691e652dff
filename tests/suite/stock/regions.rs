//! Pockets along contours at random, with islands: the same properties, column by column.

use std::fmt::Write as _;

use partc::Settings;

use super::super::damage::Dice;
use super::klartext_frames::Seen;
use super::milling::{Cut, EXACT, Stock, many, track_of};
use super::pockets::{FINISH, PLUNGE, ROUGH, finishing, number};
use super::region_entries::Entries;

/// How much nearer than asked a path may come: what the rings of a contour may lose.
const NEARER: f64 = 2e-5;

pub type P = [f64; 2];

/// A closed polygon, or a circle.
#[derive(Debug, Clone)]
pub enum Ring {
    Corners(Vec<P>),
    Circle { center: P, radius: f64 },
}

/// Pockets, and islands in them.
#[derive(Debug, Default)]
pub struct Land {
    /// The pockets first.
    pub rings: Vec<Ring>,
    pub pockets: usize,
    /// Points in which two rings cross.
    crossings: Vec<(P, [usize; 2])>,
    /// What of straight sides is wall.
    sides: Vec<(P, P)>,
}

#[derive(Debug)]
pub struct Case {
    pub language: &'static str,
    pub text: String,
    pub land: Land,
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
    /// Radii of the cutters that rough before this one, in turn, with the feeds [`COARSE`].
    pub coarse: Vec<f64>,
    /// Steepest way into the material in degrees, where the cutter cannot go straight down.
    pub angle: Option<f64>,
    pub settings: Settings,
    /// The system in which the program runs.
    pub seen: Seen,
}

/// Feeds of the cutters before the one of the case.
pub const COARSE: [f64; 2] = [900.0, 800.0];

fn on_segment(p: P, a: P, b: P) -> P {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let t = (((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    [a[0] + t * dx, a[1] + t * dy]
}

fn apart(p: P, q: P) -> f64 {
    (p[0] - q[0]).hypot(p[1] - q[1])
}

fn to_segment(p: P, a: P, b: P) -> f64 {
    apart(p, on_segment(p, a, b))
}

/// Where two segments cross.
fn lines_cross((a, b): (P, P), (c, d): (P, P)) -> Option<P> {
    let (u, w, e) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]], [c[0] - a[0], c[1] - a[1]]);
    let cross = |a: P, b: P| a[0] * b[1] - a[1] * b[0];
    let (s, t) = (cross(e, w) / cross(u, w), cross(e, u) / cross(u, w));
    ((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t)).then(|| [a[0] + s * u[0], a[1] + s * u[1]])
}

/// Where a segment crosses a circle.
fn line_crosses((a, b): (P, P), center: P, radius: f64) -> Vec<P> {
    let (u, e) = ([b[0] - a[0], b[1] - a[1]], [a[0] - center[0], a[1] - center[1]]);
    let (uu, ue, ee) = (u[0] * u[0] + u[1] * u[1], u[0] * e[0] + u[1] * e[1], e[0] * e[0] + e[1] * e[1]);
    let square = ue * ue - uu * (ee - radius * radius);
    if square < 0.0 {
        return Vec::new();
    }
    let hits = [(-ue - square.sqrt()) / uu, (-ue + square.sqrt()) / uu];
    hits.into_iter().filter(|t| (0.0..=1.0).contains(t)).map(|t| [a[0] + t * u[0], a[1] + t * u[1]]).collect()
}

impl Ring {
    fn sides(corners: &[P]) -> impl Iterator<Item = (P, P)> + '_ {
        corners.iter().enumerate().map(|(i, a)| (*a, corners[(i + 1) % corners.len()]))
    }

    /// Where two rings cross.
    fn crossings(&self, other: &Ring) -> Vec<P> {
        match (self, other) {
            (Ring::Corners(one), Ring::Corners(two)) => {
                Ring::sides(one).flat_map(|a| Ring::sides(two).filter_map(move |b| lines_cross(a, b))).collect()
            }
            (Ring::Corners(corners), Ring::Circle { center, radius })
            | (Ring::Circle { center, radius }, Ring::Corners(corners)) => {
                Ring::sides(corners).flat_map(|side| line_crosses(side, *center, *radius)).collect()
            }
            (Ring::Circle { center: c, radius: r }, Ring::Circle { center: d, radius: s }) => {
                let (dx, dy) = (d[0] - c[0], d[1] - c[1]);
                let way = dx.hypot(dy);
                let along = (way * way + r * r - s * s) / (2.0 * way);
                let square = r * r - along * along;
                let (ux, uy) = (dx / way, dy / way);
                let at = |off: f64| [c[0] + ux * along - uy * off, c[1] + uy * along + ux * off];
                if square > 0.0 { vec![at(square.sqrt()), at(-square.sqrt())] } else { Vec::new() }
            }
        }
    }

    /// Its first point.
    pub fn start(&self) -> P {
        match self {
            Ring::Corners(corners) => corners[0],
            Ring::Circle { center, radius } => [center[0] + radius, center[1]],
        }
    }

    pub fn distance(&self, p: P) -> f64 {
        match self {
            Ring::Corners(corners) => Ring::sides(corners).map(|(a, b)| to_segment(p, a, b)).fold(f64::MAX, f64::min),
            Ring::Circle { center, radius } => ((p[0] - center[0]).hypot(p[1] - center[1]) - radius).abs(),
        }
    }

    pub fn holds(&self, p: P) -> bool {
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

impl Land {
    pub fn new(rings: Vec<Ring>, pockets: usize) -> Land {
        let mut crossings = Vec::new();
        for j in 0..rings.len() {
            for i in 0..j {
                crossings.extend(rings[i].crossings(&rings[j]).into_iter().map(|p| (p, [i, j])));
            }
        }
        let mut land = Land { rings, pockets, crossings, sides: Vec::new() };
        land.sides = (0..land.rings.len()).flat_map(|at| land.straight_walls(at)).collect();
        land
    }

    /// The parts of the sides of a ring that are walls.
    fn straight_walls(&self, at: usize) -> Vec<(P, P)> {
        let Ring::Corners(corners) = &self.rings[at] else { return Vec::new() };
        let mut walls = Vec::new();
        for (a, b) in Ring::sides(corners) {
            let on = self.crossings.iter().filter(|(p, on)| on.contains(&at) && to_segment(*p, a, b) < 1e-9);
            let mut points: Vec<P> = on.map(|(p, _)| *p).chain([a, b]).collect();
            points.sort_by(|p, q| apart(*p, a).total_cmp(&apart(*q, a)));
            let middle = |p: P, q: P| [f64::midpoint(p[0], q[0]), f64::midpoint(p[1], q[1])];
            let parts = points.windows(2).map(|pair| (pair[0], pair[1]));
            walls.extend(parts.filter(|(p, q)| self.is_wall(middle(*p, *q), at)));
        }
        walls
    }

    /// May this ring come to the others? No one of a kind lies in another one, islands begin in pockets, and pockets outside of the
    /// islands and of the pockets that are named after them.
    pub fn takes(&self, ring: &Ring, is_pocket: bool) -> bool {
        self.rings.iter().enumerate().all(|(at, other)| {
            let crosses = !other.crossings(ring).is_empty();
            let (in_other, holds_other) = (other.holds(ring.start()), ring.holds(other.start()));
            match (at < self.pockets, is_pocket) {
                (true, false) => !holds_other,
                (true, true) => !holds_other && (crosses || !in_other),
                (false, _) => crosses || !(in_other || holds_other),
            }
        }) && (is_pocket || self.rings[..self.pockets].iter().any(|pocket| pocket.holds(ring.start())))
    }

    fn inside(&self, p: P) -> bool {
        let (pockets, islands) = self.rings.split_at(self.pockets);
        pockets.iter().any(|pocket| pocket.holds(p)) && !islands.iter().any(|island| island.holds(p))
    }

    /// Is a point of a ring one of the wall?
    fn is_wall(&self, p: P, at: usize) -> bool {
        let held = |other: usize| other != at && self.rings[other].holds(p);
        let in_pocket = (0..self.pockets).any(held);
        !(self.pockets..self.rings.len()).any(held) && (at < self.pockets) != in_pocket
    }

    /// Distance from the nearest wall, below 0 in the walls.
    fn room(&self, p: P) -> f64 {
        let sides = self.sides.iter().map(|(a, b)| to_segment(p, *a, *b));
        let rounds = self.rings.iter().enumerate().filter_map(|(at, ring)| match ring {
            Ring::Circle { center, radius } => {
                let (dx, dy) = (p[0] - center[0], p[1] - center[1]);
                if dx.hypot(dy) < 1e-9 {
                    // From its centre the wall is as far in each direction.
                    let unit = |i: u32| [f64::from(i).cos(), f64::from(i).sin()];
                    let mut around = (0..32).map(unit).map(|[x, y]| [center[0] + radius * x, center[1] + radius * y]);
                    return around.any(|q| self.is_wall(q, at)).then_some(*radius);
                }
                let scale = radius / dx.hypot(dy).max(1e-12);
                let nearest = [center[0] + dx * scale, center[1] + dy * scale];
                self.is_wall(nearest, at).then(|| apart(p, nearest))
            }
            Ring::Corners(_) => None,
        });
        let ends = self.crossings.iter().filter(|(q, on)| self.is_corner(*q, *on)).map(|(q, _)| apart(p, *q));
        let nearest = sides.chain(rounds).chain(ends).fold(f64::MAX, f64::min);
        if self.inside(p) { nearest } else { -nearest }
    }

    /// Is a point in which two rings cross one of the wall?
    fn is_corner(&self, p: P, on: [usize; 2]) -> bool {
        let held = |at: usize| !on.contains(&at) && self.rings[at].holds(p);
        let in_pocket = (0..self.pockets).any(held);
        !(self.pockets..self.rings.len()).any(held) && on.iter().any(|at| *at < self.pockets) != in_pocket
    }
}

impl Case {
    /// Distance of a point from the nearest wall.
    pub fn room(&self, p: P) -> f64 {
        self.land.room(p)
    }

    fn least(&self, cut: &Cut) -> f64 {
        let count = if cut.is_vertical() { 1 } else { 24 };
        let points = (0..=count).map(|i| cut.at(f64::from(i) / f64::from(count)));
        points.map(|p| self.land.room([p[0], p[1]])).fold(f64::MAX, f64::min)
    }

    /// Cuts the blank and says what is wrong; false where the cutter was said to have no path.
    pub fn judge(&self, shift: f64) -> Result<bool, String> {
        let cuts = match track_of(self.language, &self.text, &self.settings) {
            Ok(cuts) => self.seen.programmed(cuts),
            Err(codes)
                if codes.iter().all(|code| {
                    let known =
                        ["no room for the radius Q8", "touch or run along each other", "(Q18) roughed these contours"];
                    code.starts_with("G3321") || known.iter().any(|text| code.contains(text))
                }) =>
            {
                return Ok(false);
            }
            Err(codes) => return Err(format!("refused: {codes:?}")),
        };
        let size = 62.0;
        let cell = self.radius / 4.0;
        let mut stock = Stock::new([-size - shift * cell; 2], [size; 2], cell);
        let (floor, rough_floor) = (-self.depth, -self.depth + self.floor);
        // Behind its last cut comes the next cutter.
        let end = |feed: f64| cuts.iter().rposition(|cut| cut.feed == Some(feed)).map_or(0, |last| last + 1);
        let before: Vec<(usize, f64)> = self.coarse.iter().zip(COARSE).map(|(by, feed)| (end(feed), *by)).collect();
        let coarse = before.iter().map(|(end, _)| *end).max().unwrap_or(0);
        let mut entries = Entries::default();
        for (at, (cut, finishing)) in cuts.iter().zip(finishing(&cuts)).enumerate() {
            let radius = before.iter().find(|(end, _)| at < *end).map_or(self.radius, |(_, by)| *by);
            let lowest = cut.from[2].min(cut.to[2]);
            if lowest < 0.0 {
                let wall = if finishing && self.finish[0] { self.left } else { self.wall };
                let found = self.least(cut);
                if found < radius + wall - NEARER {
                    return Err(format!("gouges the wall: {found} of {} at {cut:?}", radius + wall));
                }
                let deepest = if finishing { floor } else { rough_floor };
                if lowest < deepest - EXACT {
                    return Err(format!("gouges the floor: {lowest} of {deepest} at {cut:?}"));
                }
            }
            let met = stock.cut(cut, radius);
            if !finishing {
                entries.see(cut, met.depth > EXACT);
            }
            if let Some(angle) = self.angle.filter(|_| at >= coarse && !finishing && !cut.is_rapid()) {
                let fall = cut.from[2] - cut.to[2];
                let way = cut.length();
                if met.depth > EXACT && fall > way * angle.to_radians().tan() + EXACT {
                    return Err(format!("goes down too steeply: {cut:?}"));
                }
            }
            if cut.is_rapid() && met.depth > EXACT {
                return Err(format!("rapid traverse through {:?}: {cut:?}", met.at));
            }
            let level = (cut.from[2] - cut.to[2]).abs() < 1e-12;
            if level && !finishing && met.depth > self.step + EXACT {
                return Err(format!("an infeed of {}: {cut:?}", met.depth));
            }
        }
        self.complete(&stock, cell)?;
        // What a coarser cutter left is entered from ground that it cleared; corners with Q8 make necks that the rings do not know.
        if self.coarse.is_empty() && self.corners == 0.0 {
            entries.are_single(&stock, |p| self.room(p) >= self.radius + self.wall)?;
        }
        Ok(true)
    }

    /// Every column that a cutter between the walls can reach is cut down to the floor.
    fn complete(&self, stock: &Stock, cell: f64) -> Result<(), String> {
        let wall = if self.finish[0] { self.left } else { self.wall };
        let floor = if self.finish[1] && !self.finish[0] { -self.depth } else { -self.depth + self.floor };
        // In inside corners the path is as round as that of a larger cutter.
        let (least, reach) = (self.radius + wall + self.corners, self.radius + self.corners);
        for (p, top) in stock.columns() {
            if top < 0.0 && self.land.room(p) < -EXACT {
                return Err(format!("the column at {p:?} in the wall is cut"));
            }
            let stands = top > floor + EXACT && self.land.room(p) >= wall;
            // Could a cutter between the walls stand over it?
            if stands && stock.around(p, reach - EXACT).any(|c| self.land.room(c) >= least) {
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
    let land = Land::new(rings, 1);
    let (coarse, angle, settings, seen) = (Vec::new(), None, Settings::default(), Seen::default());
    Case {
        language,
        text,
        land,
        radius,
        depth,
        step,
        wall,
        floor,
        finish,
        left,
        corners,
        coarse,
        angle,
        settings,
        seen,
    }
}

#[test]
fn contour_pockets_at_random_keep_the_properties_of_cycles() {
    many("PARTC_REGIONS", 15, |dice, shift| {
        let case = random(dice);
        case.judge(shift).map_err(|why| format!("{why}\n{}{case:?}", case.text))
    });
}
