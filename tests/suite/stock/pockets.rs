//! Pockets, slots and long holes with sizes at random: the properties of docs/cycles.md, column by column.

use std::fmt::Write as _;

use partc::Settings;

use super::super::damage::Dice;
use super::klartext_frames::Seen;
use super::milling::{Cut, EXACT, Stock, beside, many, track_of, turned};

/// Feeds by which the cuts are told apart.
pub const ROUGH: f64 = 1000.0;
pub const PLUNGE: f64 = 200.0;
pub const FINISH: f64 = 500.0;

/// A finished outline about its own origin.
#[derive(Debug, Clone, Copy)]
pub enum Outline {
    Rectangle { half: [f64; 2], corner: f64 },
    Circle { radius: f64 },
    Slot { from: f64, to: f64, half: f64 },
    Bow { radius: f64, sweep: f64, half: f64 },
}

#[derive(Debug, Clone)]
pub struct Case {
    pub language: &'static str,
    pub text: String,
    pub outline: Outline,
    pub places: Vec<([f64; 2], f64)>,
    pub radius: f64,
    pub depth: f64,
    pub step: f64,
    pub wall: f64,
    pub floor: f64,
    pub rough: bool,
    /// Wall and floor are finished.
    pub finish: [bool; 2],
    /// Greatest slope of the way into the material; none where the cutter may go straight down.
    pub slope: Option<f64>,
    /// Where it ends in the plane, if that is promised.
    pub home: Option<[f64; 2]>,
    /// What was cleared before, and how deep.
    pub cleared: Option<(Outline, f64)>,
    /// Feeds at which it goes down.
    pub plunges: &'static [f64],
    /// The system in which the program runs.
    pub seen: Seen,
}

/// Distance of `p` from the wall, above 0 inside.
fn inside(outline: &Outline, [x, y]: [f64; 2]) -> f64 {
    match *outline {
        Outline::Rectangle { half, corner } => -beside([x, y], half, corner),
        Outline::Circle { radius } => radius - x.hypot(y),
        Outline::Slot { from, to, half } => half - (x - x.clamp(from, to)).hypot(y),
        Outline::Bow { radius, sweep, half } => {
            let turn = y.atan2(x).rem_euclid(std::f64::consts::TAU);
            let end = [radius * sweep.cos(), radius * sweep.sin()];
            let to_arc = if turn <= sweep {
                (x.hypot(y) - radius).abs()
            } else {
                (x - radius).hypot(y).min((x - end[0]).hypot(y - end[1]))
            };
            half - to_arc
        }
    }
}

/// The outline that a cutter leaves which keeps off the wall.
fn reached(outline: &Outline, wall: f64, radius: f64) -> Outline {
    match *outline {
        Outline::Rectangle { half, corner } => {
            Outline::Rectangle { half: half.map(|size| size - wall), corner: (corner - wall).max(radius) }
        }
        Outline::Circle { radius } => Outline::Circle { radius: radius - wall },
        Outline::Slot { from, to, half } => Outline::Slot { from, to, half: half - wall },
        Outline::Bow { radius, sweep, half } => Outline::Bow { radius, sweep, half: half - wall },
    }
}

impl Case {
    fn local(&self, place: &([f64; 2], f64), [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = place.1.to_radians().sin_cos();
        let (dx, dy) = (x - place.0[0], y - place.0[1]);
        [dx * cos + dy * sin, dy * cos - dx * sin]
    }

    fn inside(&self, outline: &Outline, p: [f64; 2]) -> f64 {
        self.places.iter().map(|place| inside(outline, self.local(place, p))).fold(f64::MIN, f64::max)
    }

    /// Least distance of the centre on its way from the wall.
    fn least(&self, cut: &Cut) -> f64 {
        let count = if cut.is_vertical() { 1 } else { 24 };
        let points = (0..=count).map(|i| cut.at(f64::from(i) / f64::from(count)));
        points.map(|p| self.inside(&self.outline, [p[0], p[1]])).fold(f64::MAX, f64::min)
    }

    fn extent(&self) -> ([f64; 2], [f64; 2]) {
        let size = match self.outline {
            Outline::Rectangle { half, .. } => half[0].hypot(half[1]),
            Outline::Circle { radius } => radius,
            Outline::Slot { from, to, half } => from.abs().max(to.abs()) + half,
            Outline::Bow { radius, half, .. } => radius + half,
        };
        let mut low = [f64::MAX; 2];
        let mut high = [f64::MIN; 2];
        for (at, _) in &self.places {
            for i in 0..2 {
                low[i] = low[i].min(at[i] - size - 1.0);
                high[i] = high[i].max(at[i] + size + 1.0);
            }
        }
        (low, high)
    }

    /// Cuts the blank and says what is wrong.
    pub fn judge(&self, settings: &Settings, shift: f64) -> Result<(), String> {
        let cuts = track_of(self.language, &self.text, settings).map_err(|codes| format!("refused: {codes:?}"))?;
        let cuts = self.seen.programmed(cuts);
        let (low, high) = self.extent();
        let cell = self.radius / 5.0;
        let mut stock = Stock::of(low.map(|v| v - shift * cell), high, cell, |p| match &self.cleared {
            Some((outline, depth)) if self.inside(outline, p) >= 0.0 => -depth,
            _ => 0.0,
        });
        let finishes = finishing(&cuts);
        let (floor, rough_floor) = (-self.depth, -self.depth + self.floor);
        for (cut, finishing) in cuts.iter().zip(finishes) {
            let lowest = cut.from[2].min(cut.to[2]);
            if lowest < 0.0 {
                let least = if finishing { self.radius } else { self.radius + self.wall };
                let found = self.least(cut);
                if found < least - EXACT {
                    return Err(format!("gouges the wall: {found} of {least} at {cut:?}"));
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
            let falls = cut.from[2] - cut.to[2];
            if let Some(slope) = self.slope.filter(|_| falls > 0.0 && met.depth > EXACT)
                && falls > slope * cut.length() + EXACT
            {
                return Err(format!("goes into the material too steeply: {cut:?}"));
            }
            let plunges = cut.is_vertical() || self.language == "klartext" && falls > EXACT;
            if plunges && cut.feed.is_some_and(|feed| !self.plunges.contains(&feed)) {
                return Err(format!("goes down at the feed of the plane: {cut:?}"));
            }
        }
        self.complete(&stock)?;
        let end = cuts.last().map(|last| [last.to[0], last.to[1]]);
        if let (Some(home), Some(end)) = (self.home, end)
            && (home[0] - end[0]).hypot(home[1] - end[1]) > EXACT
        {
            return Err(format!("ends at {end:?}, not at {home:?}"));
        }
        if let Some(last) = cuts.last().filter(|last| last.to[2] != 10.0) {
            return Err(format!("ends below the retract height: {last:?}"));
        }
        Ok(())
    }

    fn complete(&self, stock: &Stock) -> Result<(), String> {
        let (wall, floor) = (
            if self.finish[0] { 0.0 } else { self.wall },
            if self.finish[1] { -self.depth } else { -self.depth + self.floor },
        );
        let made = reached(&self.outline, wall, self.radius);
        for (p, top) in stock.columns() {
            if top < 0.0 && self.inside(&self.outline, p) < -EXACT {
                return Err(format!("the column at {p:?} outside is cut"));
            }
            if (self.rough || self.finish[0] && self.finish[1])
                && self.inside(&made, p) > EXACT
                && top > floor.max(-self.depth + if self.finish[1] { 0.0 } else { self.floor }) + EXACT
            {
                return Err(format!("the column at {p:?} ends at {top}, not at {floor}"));
            }
        }
        Ok(())
    }
}

/// Which moves belong to finishing: those on the way down by what follows them.
pub fn finishing(cuts: &[Cut]) -> Vec<bool> {
    let mut finishing = false;
    let mut made: Vec<bool> = cuts
        .iter()
        .rev()
        .map(|cut| {
            if cut.feed.is_some_and(|feed| feed != PLUNGE) {
                finishing = cut.feed == Some(FINISH);
            }
            finishing
        })
        .collect();
    made.reverse();
    for at in 1..made.len() {
        made[at] |= cuts[at].is_rapid() && made[at - 1];
    }
    made
}

/// A number with three decimals between two bounds.
pub fn number(dice: &mut Dice, low: f64, high: f64) -> f64 {
    let steps = ((high - low) * 1000.0).max(1.0) as usize;
    ((low * 1000.0).round() + dice.roll(steps) as f64) / 1000.0
}

fn header(radius: f64, more: &str) -> String {
    format!("G17 G90 G71\n$TC_DP6[1,1]={radius}\nT1 D1\nM6\nS3000 M3\nG0 X{more} Y3 Z50\n")
}

fn random(dice: &mut Dice) -> Case {
    match dice.roll(7) {
        0 | 1 => rectangle(dice),
        2 => circle(dice),
        3 => old_pocket(dice),
        4 => long_holes(dice),
        _ => slots(dice),
    }
}

/// What a pocket of any language has.
#[derive(Debug, Clone, Copy)]
pub struct Sizes {
    pub radius: f64,
    pub depth: f64,
    pub step: f64,
    pub wall: f64,
    pub floor: f64,
    pub at: [f64; 2],
}

pub fn sizes(dice: &mut Dice) -> Sizes {
    let radius = number(dice, 1.0, 10.0);
    let depth = number(dice, 1.0, 12.0);
    let some = |dice: &mut Dice, high: f64| if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.01, high) };
    Sizes {
        radius,
        depth,
        step: number(dice, depth / 5.0, depth * 1.2),
        wall: some(dice, 0.6 * radius),
        floor: some(dice, 0.4 * depth),
        at: [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)],
    }
}

impl Case {
    /// A pocket that is roughed.
    pub fn of(language: &'static str, text: String, outline: Outline, places: Vec<([f64; 2], f64)>, c: &Sizes) -> Case {
        let Sizes { radius, depth, step, wall, floor, .. } = *c;
        let (finish, plunges) = ([false; 2], &[PLUNGE]);
        let (slope, home, cleared) = (None, None, None);
        Case {
            language,
            text,
            outline,
            places,
            radius,
            depth,
            step,
            wall,
            floor,
            rough: true,
            finish,
            slope,
            home,
            cleared,
            plunges,
            seen: Seen::default(),
        }
    }
}

struct Common {
    sizes: Sizes,
    width: f64,
    direction: usize,
}

impl std::ops::Deref for Common {
    type Target = Sizes;

    fn deref(&self) -> &Sizes {
        &self.sizes
    }
}

fn common(dice: &mut Dice) -> Common {
    let sizes = sizes(dice);
    let width = number(dice, 0.3 * sizes.radius, 2.0 * sizes.radius);
    Common { sizes, width, direction: dice.roll(4) }
}

/// A circular slot about the middle of its pitch circle, one of several that are `index` degrees apart: the radius of that, and the
/// angle of the slot.
pub fn bow(dice: &mut Dice, half: f64, index: f64) -> (f64, f64) {
    let about = half * 5.0 + number(dice, 0.0, 20.0);
    let room = (half / about).asin().to_degrees() * 2.2;
    (about, number(dice, 5.0, (index - room).max(6.0)).min((350.0 - room).floor()))
}

/// How the tool is inserted by POCKET3 and POCKET4: the tens, `_RAD1` and `_DP1`.
fn insertion(dice: &mut Dice, most: usize, radius: f64) -> (usize, f64, f64) {
    match 1 + dice.roll(most) {
        2 => (2, number(dice, 0.0, 1.3 * radius), number(dice, 0.3, 3.0)),
        3 => (3, number(dice, 2.0, 30.0), 0.0),
        _ => (1, 0.0, 0.0),
    }
}

fn rectangle(dice: &mut Dice) -> Case {
    let c = common(dice);
    let half = [0, 1].map(|_| c.radius + c.wall + number(dice, 0.0, 4.0 * c.radius));
    let most = half[0].min(half[1]);
    let corner = if dice.roll(3) == 0 { 0.0 } else { number(dice, c.radius, most.max(c.radius + 0.001)).min(most) };
    let corner = if corner < c.radius { 0.0 } else { corner };
    let turn = if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, 180.0) };
    let (tens, rad, pitch) = insertion(dice, 3, c.radius);
    let mut text = header(c.radius, "7");
    let reference = dice.roll(5);
    let corner_of = [[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]][reference];
    let gmode = if reference == 0 { 0 } else { 1000 * (reference + 1) };
    let way = turned([corner_of[0] * half[0], corner_of[1] * half[1]], turn);
    let centre = [c.at[0] + way[0], c.at[1] + way[1]];
    let before = [0, 1].map(|i| number(dice, 0.1, half[i]).min(half[i]));
    let cleared = (dice.roll(4) == 0).then(|| number(dice, 0.1, c.depth).min(c.depth));
    let ad = cleared.unwrap_or(0.0);
    let call = |text: &mut String, vari: usize, feed: f64| {
        let (Sizes { depth, step, wall, floor, at: [x, y], .. }, width, direction) = (c.sizes, c.width, c.direction);
        let [ap1, ap2] = before.map(|half| 2.0 * half);
        let _ = writeln!(
            text,
            "POCKET3(10,0,2,{},{},{},{corner},{x},{y},{turn},{step},{wall},{floor},{feed},{PLUNGE},{direction},{vari},{width},{ap1},{ap2},{ad},{rad},{pitch},0,1,2,{gmode},1,0)",
            -depth,
            2.0 * half[0],
            2.0 * half[1]
        );
    };
    let finish = finish_calls(dice, &mut text, tens, call);
    let outline = Outline::Rectangle { half, corner };
    let least = before[0].min(before[1]);
    let earlier = Outline::Rectangle { half: before, corner: corner.max(c.radius).min(least) };
    Case { cleared: cleared.map(|depth| (earlier, depth)), ..case(text, outline, vec![(centre, turn)], &c, finish) }
}

/// The calls that rough, and those that finish.
fn finish_calls(dice: &mut Dice, text: &mut String, tens: usize, call: impl Fn(&mut String, usize, f64)) -> [bool; 2] {
    call(text, 1 + 10 * tens, ROUGH);
    let finish = match dice.roll(4) {
        0 => [false, false],
        1 => [true, true],
        2 => [true, false],
        _ => [false, true],
    };
    match finish {
        [true, true] => call(text, 12, FINISH),
        [true, false] => call(text, 14, FINISH),
        [false, true] => call(text, 13, FINISH),
        [false, false] => {}
    }
    text.push_str("M30\n");
    finish
}

fn circle(dice: &mut Dice) -> Case {
    let c = common(dice);
    // A pocket of one point would have no cut in the plane by whose feed its phases are told apart.
    let size = c.radius + c.wall + number(dice, 0.01, 5.0 * c.radius);
    let (tens, rad, pitch) = insertion(dice, 2, c.radius);
    let helical = if dice.roll(3) == 0 { 1000 } else { 0 };
    let mut text = header(c.radius, "7");
    let before = number(dice, 0.1, size).min(size);
    let cleared = (dice.roll(4) == 0).then(|| number(dice, 0.1, c.depth).min(c.depth));
    let ad = cleared.unwrap_or(0.0);
    let call = |text: &mut String, vari: usize, feed: f64| {
        let (Sizes { depth, step, wall, floor, at: [x, y], .. }, width, direction) = (c.sizes, c.width, c.direction);
        let _ = writeln!(
            text,
            "POCKET4(10,0,2,{depth},{},{x},{y},{step},{wall},{floor},{feed},{PLUNGE},{direction},{},{width},{},{ad},{rad},{pitch},0,1,2,0,1,1)",
            2.0 * size,
            vari + helical,
            2.0 * before
        );
    };
    let finish = finish_calls(dice, &mut text, tens, call);
    let cleared = cleared.map(|depth| (Outline::Circle { radius: before }, depth));
    Case { cleared, ..case(text, Outline::Circle { radius: size }, vec![(c.at, 0.0)], &c, finish) }
}

fn slots(dice: &mut Dice) -> Case {
    let c = common(dice);
    let bow = dice.roll(2) == 0;
    let half = c.radius + number(dice, 0.0, 2.5 * c.radius);
    let wall = c.wall.min(half - c.radius);
    let count = 1 + dice.roll(3);
    let start = number(dice, 0.0, 360.0);
    let index = 360.0 / count as f64;
    let (sway, angle) = if dice.roll(2) == 0 { (10, 0.0) } else { (30, number(dice, 0.0, 20.0)) };
    // Complete, roughing, and roughing with a call of its own for the wall, or for wall and floor.
    let units: &[usize] = [&[0][..], &[1], &[1, 2], &[1, 4]][dice.roll(4)];
    let midf = if dice.roll(2) == 0 { 0.0 } else { number(dice, 1.0, 5.0) };
    let (Sizes { radius, depth, step, at: [x, y], .. }, direction) = (c.sizes, c.direction);
    let (centred, transfer) = (count == 1 && dice.roll(2) == 0, 700 * dice.roll(2));
    let mut text = header(radius, "7");
    let places = (0..count).map(|i| ([x, y], start + i as f64 * index)).collect();
    let outline = if bow {
        let (about, sweep) = self::bow(dice, half, index);
        for unit in units {
            let _ = writeln!(
                text,
                "SLOT2(10,0,2,,{depth},{count},{sweep},{},{x},{y},{about},{start},0,{PLUNGE},{ROUGH},{step},{direction},{wall},{},{midf},{FINISH},0,{transfer},0,1,2,0,1,1)",
                2.0 * half,
                unit + sway,
            );
        }
        Outline::Bow { radius: about, sweep: sweep.to_radians(), half }
    } else {
        let rad = half * 2.0 + number(dice, 0.0, 20.0);
        let length = 2.0 * half + number(dice, 0.5, 40.0);
        for unit in units {
            let _ = writeln!(
                text,
                "SLOT1(10,0,2,,{depth},{count},{length},{},{x},{y},{rad},{start},0,{PLUNGE},{ROUGH},{step},{direction},{wall},{},{midf},{FINISH},0,{},{angle},0,0,1,2,{},1,1)",
                2.0 * half,
                unit + sway,
                c.floor,
                if centred { 1000 } else { 0 }
            );
        }
        if centred {
            let between = length - 2.0 * half;
            Outline::Slot { from: -between / 2.0, to: between / 2.0, half }
        } else {
            Outline::Slot { from: rad + half, to: rad + length - half, half }
        }
    };
    text.push_str("M30\n");
    let floor = if bow { 0.0 } else { c.floor };
    let c = Sizes { wall, floor, ..c.sizes };
    case(text, outline, places, &c, [*units != [1], !bow && [&[0][..], &[1, 2]].contains(&units)])
}

/// POCKET1 and POCKET2.
fn old_pocket(dice: &mut Dice) -> Case {
    let direction = dice.roll(4);
    let c = Sizes { floor: 0.0, ..sizes(dice) };
    let Sizes { radius, depth, step, wall, at: [x, y], .. } = c;
    let unit = dice.roll(3);
    let midf = if dice.roll(2) == 0 { 0.0 } else { number(dice, 1.0, 5.0) };
    let mut text = header(radius, "7");
    // The finishing cuts alone follow a call that roughs.
    let units: &[usize] = if unit == 2 { &[1, 2] } else { &[unit] };
    let (round, turn) = (dice.roll(2) == 0, number(dice, 0.0, 179.0));
    let half = [0, 1].map(|_| radius + wall + number(dice, 0.01, 4.0 * radius));
    let most = half[0].min(half[1]);
    let corner = if dice.roll(3) == 0 || most < radius + 0.01 { 0.0 } else { number(dice, radius, most).min(most) };
    for unit in units {
        let rest = format!("{PLUNGE},{ROUGH},{step},{direction},{wall},{unit},{midf},{FINISH}");
        let _ = if round {
            writeln!(text, "POCKET2(10,0,2,,{depth},{},{x},{y},{rest})", half[0])
        } else {
            let (p, q) = (2.0 * half[0], 2.0 * half[1]);
            writeln!(text, "POCKET1(10,0,2,,{depth},{p},{q},{corner},{x},{y},{turn},{rest})")
        };
    }
    text.push_str("M30\n");
    let outline = if round { Outline::Circle { radius: half[0] } } else { Outline::Rectangle { half, corner } };
    case(text, outline, vec![(c.at, if round { 0.0 } else { turn })], &c, [unit != 1, unit != 1])
}

fn long_holes(dice: &mut Dice) -> Case {
    let c = Sizes { wall: 0.0, floor: 0.0, ..sizes(dice) };
    let Sizes { radius, depth, step, at: [x, y], .. } = c;
    let (count, start) = (1 + dice.roll(3), number(dice, 0.0, 360.0));
    let rad = 4.0 * radius + number(dice, 0.0, 20.0);
    let length = 2.0 * radius + number(dice, 0.01, 40.0);
    let mut text = header(radius, "7");
    let _ = writeln!(
        text,
        "LONGHOLE(10,0,2,,{depth},{count},{length},{x},{y},{rad},{start},0,{PLUNGE},{ROUGH},{step},0,0,0,1,1)\nM30"
    );
    let places = (0..count).map(|i| ([x, y], start + i as f64 * (360.0 / count as f64))).collect();
    let outline = Outline::Slot { from: rad + radius, to: rad + length - radius, half: radius };
    case(text, outline, places, &c, [false, false])
}

fn case(text: String, outline: Outline, places: Vec<([f64; 2], f64)>, c: &Sizes, finish: [bool; 2]) -> Case {
    Case { finish, ..Case::of("sinumerik", text, outline, places, c) }
}

#[test]
fn pockets_at_random_keep_the_properties_of_cycles() {
    let settings = Settings::default();
    many("PARTC_POCKETS", 250, |dice, shift| {
        let case = random(dice);
        case.judge(&settings, shift).map_err(|why| format!("{why}\n{}{case:?}", case.text)).map(|()| true)
    });
}
