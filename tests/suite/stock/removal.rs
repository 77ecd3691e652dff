//! Stock removal on a lathe: the moves of a cycle judged by a stock of their own.
//!
//! No gouge, no rapid traverse in material, complete, infeed bounded, each feed where it belongs, and back where it began.

use partc::files::NoFiles;
use partc::{Program, compile};

use super::turning::{P, Stock, Sweep, reachable};
use crate::common::settings;
use crate::meant::{Found, How, Way};
use crate::reader;

const STEP: f64 = 0.03;
/// What six printed decimals and the columns of steep walls may lose, mm.
pub const LOST: f64 = 2e-5;
pub const ROUGH: f64 = 0.25;
pub const PLUNGE: f64 = 0.15;
pub const FINISH: f64 = 0.1;

/// An element of the contour: from, to, and the centre with the sense for an arc.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    pub from: P,
    pub to: P,
    pub arc: Option<(P, bool)>,
}

/// How the part is seen: cuts along +x, infeed along -y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// The infeed is along X.
    pub radial: bool,
    /// Sense of the infeed axis out of the material, and of the cutting axis along the cuts.
    pub out: f64,
    pub along: f64,
    /// The origin of the view on the cutting axis and on the infeed axis, X as a radius.
    pub zero: P,
}

impl Side {
    /// A point of the view on the part: Z and X as a diameter.
    pub fn part(&self, p: P) -> P {
        let (cut, depth) = (self.cut(p[0]), self.depth(p[1]));
        if self.radial { [cut, 2.0 * depth] } else { [depth, 2.0 * cut] }
    }

    /// A place of the view on the cutting axis, and a height on the infeed axis; X as a radius.
    pub fn cut(&self, x: f64) -> f64 {
        self.zero[0] + self.along * x
    }

    pub fn depth(&self, y: f64) -> f64 {
        self.zero[1] + self.out * y
    }

    pub fn view(&self, z: f64, radius: f64) -> P {
        let (cut, depth) = if self.radial { (z, radius) } else { (radius, z) };
        [(cut - self.zero[0]) * self.along, (depth - self.zero[1]) * self.out]
    }

    /// Do arcs of the view turn the other way on the part?
    pub fn mirrors(&self) -> bool {
        (self.along * self.out < 0.0) == self.radial
    }

    /// From the tip to the nose centre in the view, for a position of the edge.
    pub fn center(&self, position: usize, nose: f64) -> P {
        // Along Z and X, as tool tables have it.
        let table = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, 0), (0, -1), (1, 0), (0, 1), (0, 0)];
        let (z, x) = table[position - 1];
        let (z, x) = (f64::from(z) * nose, f64::from(x) * nose);
        if self.radial { [z * self.along, x * self.out] } else { [x * self.along, z * self.out] }
    }

    /// Positions of the edge that do not point out of the material; the corner ahead first.
    pub fn positions(&self) -> Vec<usize> {
        let mut list: Vec<usize> = (1..=9).filter(|k| self.center(*k, 1.0)[1] >= 0.0).collect();
        list.sort_by_key(|k| usize::from(self.center(*k, 1.0) != [-1.0, 1.0]));
        list
    }
}

/// Stock above the contour, in the view.
#[derive(Debug, Clone)]
pub enum Blank {
    /// From this place on up to this height.
    Box { front: f64, top: f64 },
    /// So much in front of the contour and above it.
    On { along: f64, up: f64 },
    /// Below a line.
    Line(Vec<P>),
}

/// Borders of the area that is machined, in the view.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    pub near: f64,
    pub far: f64,
    pub bottom: f64,
    pub top: f64,
}

pub const UNLIMITED: Limits =
    Limits { near: f64::NEG_INFINITY, far: f64::INFINITY, bottom: f64::NEG_INFINITY, top: f64::INFINITY };

/// What a cycle is to make.
#[derive(Debug, Clone)]
pub struct Part {
    pub pieces: Vec<Piece>,
    pub side: Side,
    pub nose: f64,
    /// From the tip to the nose centre.
    pub center: P,
    /// What falls behind higher parts is cut.
    pub relief: bool,
    pub along: f64,
    pub up: f64,
    pub around: f64,
    pub most: f64,
    pub blank: Blank,
    pub limits: Limits,
    pub plunge: f64,
    /// How far the nose may reach beyond the end of the contour.
    pub beyond: f64,
    /// How much roughing leaves at most on its allowances and what the nose cannot reach, where that is known.
    pub steps: Option<f64>,
}

impl Piece {
    pub fn points(&self) -> Vec<P> {
        match self.arc {
            None => vec![self.from, self.to],
            Some((center, ccw)) => Sweep::Arc(self.from, self.to, center, ccw).points(8),
        }
    }
}

pub fn top(pieces: &[Piece]) -> f64 {
    pieces.iter().flat_map(Piece::points).map(|p| p[1]).fold(0.0, f64::max)
}

/// Height of a line over `x`, the higher one at a wall; below everything outside.
pub fn height(line: &[P], x: f64) -> f64 {
    let over = line.windows(2).filter(|pair| x >= pair[0][0] - 1e-9 && x <= pair[1][0] + 1e-9);
    over.map(|pair| {
        let (a, b) = (pair[0], pair[1]);
        if b[0] - a[0] < 1e-12 {
            a[1].max(b[1])
        } else {
            a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0)
        }
    })
    .fold(f64::NEG_INFINITY, f64::max)
}

impl Part {
    fn end(&self) -> P {
        self.pieces.last().map_or([0.0, 0.0], |piece| piece.to)
    }

    /// Height of the finished contour: over `x`, the higher one at a wall.
    fn finished(&self, x: f64) -> f64 {
        let mut high = f64::NEG_INFINITY;
        for piece in &self.pieces {
            let (a, b) = (piece.from, piece.to);
            if x < a[0] - 1e-9 || x > b[0] + 1e-9 {
                continue;
            }
            high = high.max(match piece.arc {
                None => height(&[a, b], x),
                Some((c, ccw)) => {
                    let r = (a[0] - c[0]).hypot(a[1] - c[1]);
                    let up = (r * r - (x - c[0]).powi(2)).max(0.0).sqrt();
                    c[1] + if ccw { -up } else { up }
                }
            });
        }
        high
    }

    /// Greatest height of the contour in the cell about `x`.
    fn cell(&self, x: f64) -> f64 {
        let inside = |p: &P| (p[0] - x).abs() <= STEP;
        let corners = self.pieces.iter().flat_map(|p| [p.from, p.to]).filter(inside).map(|p| p[1]);
        corners.fold(self.finished(x), f64::max)
    }

    /// Without what lies behind higher parts, where it is left standing.
    fn kept(&self, columns: &Stock, of: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut list: Vec<f64> = (0..columns.heights.len()).map(|i| of(columns.place(i))).collect();
        if !self.relief {
            let mut high = f64::NEG_INFINITY;
            for y in &mut list {
                high = high.max(*y);
                *y = high;
            }
        }
        list
    }

    /// With the borders of the area.
    fn limited(&self, columns: &Stock, mut list: Vec<f64>) -> Vec<f64> {
        for (i, y) in list.iter_mut().enumerate() {
            *y = if columns.place(i) > self.limits.far + 1e-9 { 1e3 } else { y.max(self.limits.bottom) };
        }
        list
    }

    /// The stock before the cycle.
    fn stock(&self, columns: &Stock, own: &[f64]) -> Vec<f64> {
        let (end, limits) = (self.end(), self.limits);
        let stands = |i: usize| {
            let x = columns.place(i);
            match &self.blank {
                Blank::Box { front, .. } if x < *front => f64::NEG_INFINITY,
                Blank::Box { top, .. } => *top,
                Blank::On { along, .. } if x < -along || x > end[0] => f64::NEG_INFINITY,
                Blank::On { along, up } => grown(columns, own, i, *along) + up,
                Blank::Line(line) => height(line, x),
            }
        };
        (0..columns.heights.len())
            .map(|i| {
                let x = columns.place(i);
                if x < limits.near || x > limits.far { f64::NEG_INFINITY } else { stands(i).min(limits.top) }
            })
            .collect()
    }

    /// The finished shape with the allowances.
    fn with_allowances(&self, columns: &Stock, kept: &[f64], more: f64) -> Vec<f64> {
        let wide = |by: f64| if by > 0.0 { by + more } else { 0.0 };
        let boxed: Vec<f64> = (0..kept.len()).map(|i| grown(columns, kept, i, wide(self.along)) + self.up).collect();
        let n = (wide(self.around) / columns.step).floor() as isize;
        let at = |i: isize| boxed[i.clamp(0, boxed.len() as isize - 1) as usize];
        (0..boxed.len() as isize)
            .map(|i| {
                (-n..=n)
                    .map(|k| {
                        let off = k as f64 * columns.step;
                        at(i + k) + (self.around * self.around - off * off).max(0.0).sqrt()
                    })
                    .fold(f64::NEG_INFINITY, f64::max)
            })
            .collect()
    }

    /// Judges the moves.
    pub fn check(&self, steps: &[Step]) -> Result<(), String> {
        self.cut(steps)?;
        self.comes_back(steps)
    }

    /// All but where they end.
    pub fn cut(&self, steps: &[Step]) -> Result<(), String> {
        let end = self.end();
        let (left, right) = (-6.0 + STEP * 0.37, end[0] + 4.0);
        let mut stock = Stock::new(left, right, STEP, |_| f64::NEG_INFINITY);
        let own: Vec<f64> = (0..stock.heights.len()).map(|i| self.finished(stock.place(i))).collect();
        let kept = self.kept(&stock, |x| self.finished(x));
        // What may stand counts the corners between two columns.
        let high = self.kept(&stock, |x| self.cell(x));
        stock.heights = self.stock(&stock, &own);
        let left_over = self.limited(&stock, self.with_allowances(&stock, &kept, 0.0));
        let done = self.limited(&stock, kept);
        let first_finish = steps.iter().position(|s| !s.rapid && s.feed == FINISH).unwrap_or(steps.len());
        for (n, step) in steps.iter().enumerate() {
            let finishing = n >= first_finish;
            let limit = if finishing { &done } else { &left_over };
            let rolled = self.around > 0.0 && !finishing;
            self.take(&mut stock, step, limit, end[0], rolled).map_err(|why| format!("move {n} {step:?}: {why}"))?;
        }
        let finished = first_finish < steps.len();
        let stands = if finished { high } else { self.with_allowances(&stock, &high, STEP) };
        match self.steps {
            _ if finished => self.complete(&stock, &self.limited(&stock, stands), None),
            None => Ok(()),
            rough => self.complete(&stock, &self.limited(&stock, stands), rough),
        }
    }

    /// One move: what it takes, and whether it may.
    fn take(&self, stock: &mut Stock, step: &Step, limit: &[f64], end: f64, rolled: bool) -> Result<(), String> {
        let mut fault = None;
        let (mut deep, mut touched) = (0.0f64, false);
        let mut cuts: Vec<(usize, f64)> = Vec::new();
        stock.swept(&step.sweep, self.nose, |i, y| {
            let x = stock.place(i);
            let near = |d: isize| limit[(i as isize + d).clamp(0, limit.len() as isize - 1) as usize];
            let floor = near(0).min(near(1)).min(near(-1));
            let inside = x >= 0.0 && x <= end.min(self.limits.far);
            if inside && y < floor - LOST - 1e-3 * f64::from(u8::from(rolled)) {
                fault.get_or_insert(format!("gouge of {} at {x}", floor - y));
            }
            if y < stock.heights[i] - LOST {
                touched = true;
                if step.rapid {
                    fault.get_or_insert(format!("rapid {} deep in stock at {x}", stock.heights[i] - y));
                }
                if stock.heights[i] > f64::NEG_INFINITY {
                    deep = deep.max(stock.heights[i] - y);
                }
            }
            if !step.rapid {
                cuts.push((i, y));
            }
        });
        if let Some(fault) = fault {
            return Err(fault);
        }
        for (i, y) in cuts {
            stock.heights[i] = stock.heights[i].min(y);
        }
        let (a, b) = step.sweep.ends();
        let level = (a[1] - b[1]).abs() < 1e-9 && matches!(step.sweep, Sweep::Line(..));
        if touched && level && step.feed == ROUGH && deep > self.most + 1e-4 {
            return Err(format!("{deep} deep, infeed {}", self.most));
        }
        if touched && step.feed == self.plunge && b[1] > a[1] + 1e-9 {
            return Err("goes up at the plunge feed".to_owned());
        }
        if touched && ![ROUGH, self.plunge, FINISH].contains(&step.feed) {
            return Err(format!("cuts with the feed {}", step.feed));
        }
        Ok(())
    }

    /// What stands afterwards is what the nose cannot reach, and the steps of roughing.
    fn complete(&self, stock: &Stock, wanted: &[f64], rough: Option<f64>) -> Result<(), String> {
        let end = self.end()[0].min(self.limits.far);
        let mut floor = stock.clone();
        floor.heights = (0..wanted.len())
            .map(|i| {
                let x = stock.place(i);
                // In front of the contour nothing holds the nose, behind its end a wall.
                if x < 0.0 {
                    wanted[i].max(-50.0)
                } else if x > end + self.beyond {
                    1e3
                } else {
                    wanted[i]
                }
            })
            .collect();
        // In front it goes on as it begins.
        let first = floor.heights.iter().position(|y| *y > -40.0).unwrap_or(0);
        for i in 0..first {
            floor.heights[i] = floor.heights[first];
        }
        for i in 1..floor.heights.len() {
            if floor.place(i) > end && floor.heights[i] < 0.0 {
                floor.heights[i] = floor.heights[i - 1];
            }
        }
        let best = reachable(&floor, self.nose);
        let margin = self.nose + self.along + self.around + 0.2;
        for (i, y) in stock.heights.iter().enumerate() {
            let x = stock.place(i);
            if wanted[i] > self.limits.top - margin {
                // What stands higher than the area ends it.
                break;
            }
            if x < margin || x > end - margin || x < self.limits.near + margin {
                continue;
            }
            let near = (-2isize..=2).map(|d| best[(i as isize + d).clamp(0, best.len() as isize - 1) as usize]);
            let most = near.fold(f64::NEG_INFINITY, f64::max);
            if *y > most + 0.05 + rough.unwrap_or(0.0) {
                return Err(format!("{} stands at {x}, finished {}", y - most, rough.is_none()));
            }
        }
        Ok(())
    }

    /// The cycle ends where its own approach ended.
    pub fn comes_back(&self, steps: &[Step]) -> Result<(), String> {
        let approach = steps.iter().take_while(|step| step.rapid).map(|step| step.sweep.ends().1);
        let Some(last) = steps.last().map(|step| step.sweep.ends().1) else { return Err("no move".to_owned()) };
        let near = |p: P| (p[0] - last[0]).abs() < 1e-5 && (p[1] - last[1]).abs() < 1e-5;
        if approach.into_iter().any(near) { Ok(()) } else { Err(format!("ends in {last:?}")) }
    }
}

/// Greatest height within a distance.
fn grown(columns: &Stock, heights: &[f64], i: usize, by: f64) -> f64 {
    let n = (by / columns.step).floor() as usize;
    heights[i.saturating_sub(n)..(i + n + 1).min(heights.len())].iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// A move that was found, in the view, of the nose centre.
#[derive(Debug, Clone)]
pub struct Step {
    pub sweep: Sweep,
    pub rapid: bool,
    pub feed: f64,
}

pub fn steps(side: Side, center: P, moves: &[Found]) -> Vec<Step> {
    let (mut at, mut list) = (None::<P>, Vec::new());
    let seen = |z: f64, x: f64| {
        let p = side.view(z, x);
        [p[0] + center[0], p[1] + center[1]]
    };
    for found in moves {
        let Found::Move(way, How { feed, .. }) = found else { continue };
        let end = way.end();
        let to = seen(end[2], end[0]);
        if let Some(from) = at {
            let sweep = match way {
                Way::Arc { plane, center, turns, .. } => {
                    let center = if plane[0] == 2 { seen(center[0], center[1]) } else { seen(center[1], center[0]) };
                    let ccw = (*turns > 0) == (plane[0] == 2);
                    Sweep::Arc(from, to, center, ccw != side.mirrors())
                }
                _ => Sweep::Line(from, to),
            };
            list.push(Step { sweep, rapid: matches!(way, Way::Rapid(_)), feed: feed.map_or(0.0, |(_, value)| value) });
        }
        at = Some(to);
    }
    list
}

/// What a program came to.
pub enum Made {
    Moves {
        text: String,
        moves: Vec<Found>,
        codes: Vec<&'static str>,
    },
    /// The code and the text of the first error.
    Refused(&'static str, String),
}

/// Whose program it is.
#[derive(Debug, Clone, Copy)]
pub enum Language {
    Sinumerik,
    Turning,
}

/// Compiles a program for a lathe.
pub fn made(language: Language, text: &str, config: &str) -> Result<Made, String> {
    let settings = settings(config);
    let (language, name) = match language {
        Language::Sinumerik => ("sinumerik", "C.MPF"),
        Language::Turning => ("heidenhain-turning", "C.NC"),
    };
    let program = Program::in_language(language, name, text.as_bytes()).map_err(|e| e.to_string())?;
    let compiled = std::panic::catch_unwind(|| compile(&program, &settings, &NoFiles));
    let outcome = compiled.map_err(|_| "the compiler panics".to_owned())?.map_err(|e| e.to_string())?;
    let Some(text) = outcome.text else {
        let error = outcome.findings.iter().find(|f| f.severity == partc::diagnostics::Severity::Error);
        return error
            .map(|f| Made::Refused(f.code, f.message.clone()))
            .ok_or_else(|| "no output and no error".to_owned());
    };
    let moves = reader::read(&text, 6)?;
    Ok(Made::Moves { text, moves, codes: outcome.findings.iter().map(|f| f.code).collect() })
}

/// What became of random cases.
#[derive(Debug, Default)]
pub struct Tally {
    pub cut: u64,
    pub refused: u64,
    pub valleys: u64,
    pub moves: u64,
}

/// Runs `one` over random numbers in all threads; the environment says how many and which.
pub fn run<T>(name: &str, least: u64, one: T)
where
    T: Fn(&mut crate::damage::Dice, &mut Tally) -> Result<(), String> + Sync,
{
    let from = |name: String, or: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(or);
    let (count, seed) = (from(format!("PARTC_{name}"), least), from(format!("PARTC_{name}_SEED"), 1));
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let part = |seed: u64| {
        let (mut tally, mut failures) = (Tally::default(), Vec::new());
        for i in 0..count.div_ceil(threads) {
            let state = (seed.wrapping_mul(1_000_003).wrapping_add(i) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
            let mut dice = crate::damage::Dice(state);
            for _ in 0..4 {
                dice.roll(2);
            }
            if let Err(why) = one(&mut dice, &mut tally) {
                failures.push(format!("case {i} of {seed}: {why}"));
                if failures.len() >= 4 {
                    break;
                }
            }
        }
        (tally, failures)
    };
    let parts: Vec<(Tally, Vec<String>)> = std::thread::scope(|scope| {
        let part = &part;
        let work = |k: u64| scope.spawn(move || part(seed * 64 + k));
        let parts: Vec<_> = (0..threads).map(work).collect();
        parts.into_iter().map(|part| part.join().expect("a part")).collect()
    });
    let sum = |of: fn(&Tally) -> u64| parts.iter().map(|(tally, _)| of(tally)).sum::<u64>();
    println!(
        "{} cut, {} with relief cuts, {} refused, {} moves",
        sum(|t| t.cut),
        sum(|t| t.valleys),
        sum(|t| t.refused),
        sum(|t| t.moves)
    );
    let failures: Vec<&str> = parts.iter().flat_map(|(_, list)| list).map(String::as_str).collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(sum(|t| t.cut) * 2 > count);
}
