//! A blank as columns over the plane G17, cut by a flat cutter; the surface lies at Z 0.

use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::ir::motion::{Move, Path, Sink};
use partc::internals::ir::{Function, Origin, Pos};
use partc::internals::machine::{Axis, Settings};
use partc::internals::text::files::NoFiles;
use partc::internals::text::{Memory, Opened};

use super::super::damage::Dice;

/// Slack of a comparison of exact numbers, mm.
pub const EXACT: f64 = 1e-6;
/// Height of a column where there is no blank.
pub const NOTHING: f64 = -1e9;
/// How far the swept cylinder of a rapid move is taken in, so that columns it touches do not count, mm.
const TOUCH: f64 = 1e-4;
/// Largest sweep of a piece of an arc, rad.
const PIECE: f64 = 0.5;

/// A move of the cutter's centre.
#[derive(Debug, Clone, Copy)]
pub struct Cut {
    pub from: [f64; 3],
    pub to: [f64; 3],
    /// Centre and sweep of an arc.
    pub arc: Option<([f64; 2], f64)>,
    /// None at rapid traverse.
    pub feed: Option<f64>,
}

/// The moves of a program whose axes are all known.
#[derive(Debug, Default)]
pub struct Track {
    at: Pos,
    pub cuts: Vec<Cut>,
}

impl Sink for Track {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        let place = |pos: &Pos| Some([pos.get(Axis::X)?, pos.get(Axis::Y)?, pos.get(Axis::Z)?]);
        if let (Some(from), Some(to)) = (place(&self.at), place(&mv.end)) {
            let arc = match &mv.path {
                Path::Arc(arc, _) => Some(([arc.center.x, arc.center.y], arc.sweep)),
                _ => None,
            };
            self.cuts.push(Cut { from, to, arc, feed: mv.path.feed().map(|feed| feed.value()) });
        }
        self.at.update(&mv.end);
    }

    fn function(&mut self, _: &Function, _: &Origin) {}
    fn lost(&mut self, _: &Origin) {}
}

/// The moves of a SINUMERIK program, or the codes of its errors.
pub fn track(text: &str, settings: &Settings) -> Result<Vec<Cut>, Vec<String>> {
    track_of("sinumerik", text, settings)
}

/// The moves of a program, or the codes of its errors.
pub fn track_of(language: &str, text: &str, settings: &Settings) -> Result<Vec<Cut>, Vec<String>> {
    let main = Opened { name: "P".into(), identity: "P".into(), text: Box::new(Memory::new(text.as_bytes().to_vec())) };
    let session = Session::new(main);
    let mut track = Track::default();
    session.lower(dialect::find(language).expect("a dialect"), settings, &NoFiles, &mut track);
    let errors: Vec<String> = session
        .diags
        .into_sorted()
        .into_iter()
        .filter(|found| found.code.severity == partc::internals::diag::Severity::Error)
        .map(|found| format!("{} {}", found.code.id, found.text()))
        .collect();
    if errors.is_empty() { Ok(track.cuts) } else { Err(errors) }
}

impl Cut {
    pub fn is_rapid(&self) -> bool {
        self.feed.is_none()
    }

    /// Along the tool axis only.
    pub fn is_vertical(&self) -> bool {
        self.arc.is_none() && self.length() < 1e-9
    }

    pub fn length(&self) -> f64 {
        match self.arc {
            Some(([x, y], sweep)) => sweep.abs() * (self.from[0] - x).hypot(self.from[1] - y),
            None => (self.to[0] - self.from[0]).hypot(self.to[1] - self.from[1]),
        }
    }

    /// Where the cutter is after a part of the way.
    pub fn at(&self, part: f64) -> [f64; 3] {
        let z = self.from[2] + (self.to[2] - self.from[2]) * part;
        match self.arc {
            Some(([x, y], sweep)) => {
                let (sin, cos) = (sweep * part).sin_cos();
                let (dx, dy) = (self.from[0] - x, self.from[1] - y);
                [x + dx * cos - dy * sin, y + dx * sin + dy * cos, z]
            }
            None => [
                self.from[0] + (self.to[0] - self.from[0]) * part,
                self.from[1] + (self.to[1] - self.from[1]) * part,
                z,
            ],
        }
    }

    /// Pieces of at most one height, or of a small descent; arcs of small sweep.
    fn pieces(&self, cell: f64) -> Vec<Cut> {
        let falls = (self.to[2] - self.from[2]).abs() > 1e-12 && !self.is_vertical();
        let by_arc = self.arc.map_or(1.0, |(_, sweep)| (sweep.abs() / PIECE).ceil());
        let by_fall = if falls { (self.length() / cell).ceil() } else { 1.0 };
        let count = by_arc.max(by_fall).max(1.0) as usize;
        if count == 1 {
            return vec![*self];
        }
        let part = |i: usize| i as f64 / count as f64;
        (0..count)
            .map(|i| Cut {
                from: self.at(part(i)),
                to: if i + 1 == count { self.to } else { self.at(part(i + 1)) },
                arc: self.arc.map(|(center, sweep)| (center, sweep / count as f64)),
                feed: self.feed,
            })
            .collect()
    }

    /// Distance of a point from the way in the plane.
    fn distance(&self, p: [f64; 2]) -> f64 {
        let end = |q: [f64; 3]| (p[0] - q[0]).hypot(p[1] - q[1]);
        match self.arc {
            Some((c, sweep)) => {
                let angle = |q: [f64; 2]| (q[1] - c[1]).atan2(q[0] - c[0]);
                let radius = (self.from[0] - c[0]).hypot(self.from[1] - c[1]);
                let turn = (angle(p) - angle([self.from[0], self.from[1]])) * sweep.signum();
                let turn = turn.rem_euclid(std::f64::consts::TAU);
                if turn <= sweep.abs() {
                    ((p[0] - c[0]).hypot(p[1] - c[1]) - radius).abs()
                } else {
                    end(self.from).min(end(self.to))
                }
            }
            None => {
                let (dx, dy) = (self.to[0] - self.from[0], self.to[1] - self.from[1]);
                let square = dx * dx + dy * dy;
                if square == 0.0 {
                    return end(self.from);
                }
                let t = (((p[0] - self.from[0]) * dx + (p[1] - self.from[1]) * dy) / square).clamp(0.0, 1.0);
                (p[0] - self.from[0] - t * dx).hypot(p[1] - self.from[1] - t * dy)
            }
        }
    }
}

/// Columns with the height at which each ends.
#[derive(Debug)]
pub struct Stock {
    low: [f64; 2],
    cell: f64,
    count: [usize; 2],
    top: Vec<f64>,
}

/// Distance of `p` from a rectangle about the origin with round corners, below 0 inside.
pub fn beside([x, y]: [f64; 2], half: [f64; 2], corner: f64) -> f64 {
    let q = [x.abs() - half[0] + corner, y.abs() - half[1] + corner];
    q[0].max(0.0).hypot(q[1].max(0.0)) + q[0].max(q[1]).min(0.0) - corner
}

/// A point that is turned about the origin, in degrees.
pub fn turned([x, y]: [f64; 2], turn: f64) -> [f64; 2] {
    let (sin, cos) = turn.to_radians().sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

/// What a move met.
#[derive(Debug, Clone, Copy, Default)]
pub struct Met {
    /// Deepest cut.
    pub depth: f64,
    /// Where it met material.
    pub at: Option<[f64; 2]>,
}

impl Stock {
    /// A blank over a rectangle, its columns `cell` apart.
    pub fn new(low: [f64; 2], high: [f64; 2], cell: f64) -> Stock {
        Stock::of(low, high, cell, |_| 0.0)
    }

    /// The same where the columns have their own heights, [`NOTHING`] for none.
    pub fn of(low: [f64; 2], high: [f64; 2], cell: f64, top: impl Fn([f64; 2]) -> f64) -> Stock {
        let count = [0, 1].map(|i| ((high[i] - low[i]) / cell).ceil() as usize + 1);
        let mut stock = Stock { low, cell, count, top: vec![0.0; count[0] * count[1]] };
        for at in 0..stock.top.len() {
            stock.top[at] = top(stock.place(at % count[0], at / count[0]));
        }
        stock
    }

    /// Distance of columns.
    pub fn cell(&self) -> f64 {
        self.cell
    }

    /// How many columns stand side by side along the first axis.
    pub fn wide(&self) -> usize {
        self.count[0]
    }

    /// Columns and their heights, along the first axis first.
    pub fn columns(&self) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        self.top.iter().enumerate().map(|(at, top)| (self.place(at % self.count[0], at / self.count[0]), *top))
    }

    /// Places of columns within a distance.
    pub fn around(&self, p: [f64; 2], reach: f64) -> impl Iterator<Item = [f64; 2]> + '_ {
        let index = |v: f64, i: usize| ((v - self.low[i]) / self.cell).clamp(0.0, self.count[i] as f64 - 1.0) as usize;
        let (i0, i1) = (index(p[0] - reach, 0), index(p[0] + reach, 0));
        let (j0, j1) = (index(p[1] - reach, 1), index(p[1] + reach, 1));
        let places = (j0..=j1).flat_map(move |j| (i0..=i1).map(move |i| self.place(i, j)));
        places.filter(move |c| (c[0] - p[0]).hypot(c[1] - p[1]) <= reach)
    }

    fn place(&self, i: usize, j: usize) -> [f64; 2] {
        [self.low[0] + i as f64 * self.cell, self.low[1] + j as f64 * self.cell]
    }

    /// What the cutter meets on its way; a feed move takes it away.
    pub fn cut(&mut self, cut: &Cut, radius: f64) -> Met {
        let mut met = Met::default();
        let reach = if cut.is_rapid() { radius - TOUCH } else { radius };
        for piece in cut.pieces(self.cell) {
            let z = piece.from[2].min(piece.to[2]);
            if z >= 0.0 {
                continue;
            }
            let (low, high) = piece.span(reach);
            let index = |v: f64, i: usize| ((v - self.low[i]) / self.cell).clamp(0.0, self.count[i] as f64 - 1.0);
            let [i0, j0] = [index(low[0], 0).floor() as usize, index(low[1], 1).floor() as usize];
            let [i1, j1] = [index(high[0], 0).ceil() as usize, index(high[1], 1).ceil() as usize];
            for j in j0..=j1 {
                for i in i0..=i1 {
                    let at = j * self.count[0] + i;
                    let depth = self.top[at] - z;
                    if depth <= EXACT / 10.0 {
                        continue;
                    }
                    let p = self.place(i, j);
                    if piece.distance(p) > reach {
                        continue;
                    }
                    if depth > met.depth {
                        met = Met { depth, at: Some(p) };
                    }
                    if !cut.is_rapid() {
                        self.top[at] = z;
                    }
                }
            }
        }
        met
    }
}

impl Cut {
    fn span(&self, reach: f64) -> ([f64; 2], [f64; 2]) {
        let mut low = [f64::MAX; 2];
        let mut high = [f64::MIN; 2];
        let mut points = vec![self.from, self.to];
        if let Some(([x, y], _)) = self.arc {
            // A piece of at most half a radian bulges by less than an eighth of its chord.
            let radius = (self.from[0] - x).hypot(self.from[1] - y);
            let bulge = radius * 0.04;
            for p in [self.from, self.to] {
                points.push([p[0] - bulge, p[1] - bulge, p[2]]);
                points.push([p[0] + bulge, p[1] + bulge, p[2]]);
            }
        }
        for p in points {
            for i in 0..2 {
                low[i] = low[i].min(p[i] - reach);
                high[i] = high[i].max(p[i] + reach);
            }
        }
        (low, high)
    }
}

/// Runs so many cases as an environment variable says: `judge` makes one, and says why it fails, or that it was refused for its
/// geometry. The shortest failures are shown.
pub fn many(name: &str, usual: u64, mut judge: impl FnMut(&mut Dice, f64) -> Result<bool, String>) {
    let from = |name: &str, usual: u64| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(usual);
    let (count, seed) = (from(name, usual), from(&format!("{name}_SEED"), 1));
    let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let (mut bad, mut without) = (Vec::new(), 0);
    for _ in 0..count {
        let shift = dice.roll(100) as f64 / 100.0;
        match judge(&mut dice, shift) {
            Ok(true) => {}
            Ok(false) => without += 1,
            Err(why) => bad.push(why),
        }
    }
    bad.sort_by_key(String::len);
    println!("{name}: {count} cases, {without} refused for their geometry, {} bad", bad.len());
    assert!(bad.is_empty(), "{} of {count} fail, such as\n{}", bad.len(), bad[..bad.len().min(4)].join("\n\n"));
    assert!(without * 2 < count, "{without} of {count} have no path");
}
