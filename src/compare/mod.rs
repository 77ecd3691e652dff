//! Two programs compared as motion: what the machine does, whatever words say it.
//!
//! In: the steps of both, from a motion stream or from plain G-code. Out: the first difference, how many there are, the
//! largest deviation, feeds, tools and functions that differ. Steps that one program has and the other has not are found
//! by looking a little ahead, so that one block more does not make all others differ.

#![cfg_attr(not(test), warn(clippy::wildcard_enum_match_arm))]

pub mod play;
mod steps;
#[cfg(test)]
mod tests;

use serde_json::{Value, json};

use crate::geo::distance;
use crate::ir::{Feed, Pos};
use crate::machine::Axis;

pub use play::{Stop, play};
pub use steps::{Does, Kind, Step, Steps, Travel};

use steps::{Stroke, shown};

/// How far ahead the place is looked for where two programs agree again, in steps.
const AHEAD: usize = 40;
/// Steps that have to agree there.
const AGREE: usize = 3;
/// What angles of arcs may differ by for the same tolerance on the arc, in rad.
const ANGLE: f64 = 1e-9;

/// The steps of plain G-code.
///
/// # Errors
/// The first line that is none.
pub fn steps_of_text(text: &[u8], tolerance: f64) -> Result<Vec<Step>, Stop> {
    let mut steps = Steps::new(tolerance);
    if !play::rules_of(text).corners {
        steps.corners_are_open();
    }
    play(text, &mut steps)?;
    Ok(steps.finish())
}

/// What two programs do differently.
#[derive(Debug, Default)]
pub struct Difference {
    /// Pairs of steps that differ, and steps that only one program has.
    pub differing: usize,
    pub only: [usize; 2],
    /// Pairs of moves that differ in nothing but the feed.
    pub feeds: usize,
    /// Functions among what differs.
    pub functions: usize,
    /// Where the first difference is: the step of each program.
    pub first: Option<[Option<usize>; 2]>,
    /// Largest distance of two places of moves that belong together, mm or degrees.
    pub largest: f64,
    pub sums: [Sum; 2],
}

/// What there is of a program.
#[derive(Debug, Default, PartialEq)]
pub struct Sum {
    pub moves: usize,
    pub way: f64,
    pub tools: Vec<u32>,
}

impl Sum {
    fn of(steps: &[Step]) -> Sum {
        let mut sum = Sum::default();
        for step in steps {
            match &step.does {
                Does::Travel(travel) => {
                    sum.moves += 1;
                    sum.way += travel.length();
                }
                Does::Function(word, [number, _]) if word == "tool" => sum.tools.push(*number as u32),
                Does::Function(..) => {}
            }
        }
        sum
    }
}

impl Difference {
    /// Compares two programs; lengths, feeds and speeds that differ by `tolerance` at most are the same.
    pub fn between(a: &[Step], b: &[Step], tolerance: f64) -> Difference {
        let mut found = Difference { sums: [Sum::of(a), Sum::of(b)], ..Difference::default() };
        // Where one of them cannot say how corners are taken, the other one may say what it likes.
        let unsaid = [a, b].iter().any(|list| list.iter().any(Step::leaves_corners_open));
        let counts = |step: &Step| !(step.leaves_corners_open() || unsaid && step.is_path_control());
        let places = [a, b].map(|list| (0..list.len()).filter(|i| counts(&list[*i])).collect::<Vec<_>>());
        let [a, b] =
            [(a, &places[0]), (b, &places[1])].map(|(list, at)| at.iter().map(|i| &list[*i]).collect::<Vec<_>>());
        let (mut i, mut j) = (0, 0);
        while i < a.len() || j < b.len() {
            if let (Some(one), Some(other)) = (a.get(i), b.get(j))
                && same(one, other, tolerance)
            {
                found.largest = found.largest.max(apart(one, other));
                (i, j) = (i + 1, j + 1);
                continue;
            }
            let (di, dj) = again(&a[i..], &b[j..], tolerance);
            let before = found.count();
            for n in 0..di.max(dj) {
                match (a[i..i + di].get(n), b[j..j + dj].get(n)) {
                    (Some(one), Some(other)) if same(one, other, tolerance) => {}
                    (Some(one), Some(other)) => found.pair(one, other, tolerance),
                    // A way that one program rounds away.
                    (one, other) if one.or(other).is_some_and(|step| is_tiny(step, tolerance)) => {}
                    (one, other) => {
                        found.only[usize::from(one.is_none())] += 1;
                        let is_function = |step: &Step| matches!(step.does, Does::Function(..));
                        found.functions += usize::from(one.or(other).is_some_and(|step| is_function(step)));
                    }
                }
            }
            if found.count() > before {
                found.first.get_or_insert([places[0].get(i).copied(), places[1].get(j).copied()]);
            }
            (i, j) = (i + di, j + dj);
        }
        found
    }

    fn count(&self) -> usize {
        self.differing + self.only[0] + self.only[1]
    }

    fn pair(&mut self, one: &Step, other: &Step, tolerance: f64) {
        self.differing += 1;
        match (&one.does, &other.does) {
            (Does::Travel(a), Does::Travel(b)) => {
                self.largest = self.largest.max(apart(one, other));
                let with_feed = Travel { feed: b.feed, ..a.clone() };
                self.feeds += usize::from(same_travel(&with_feed, b, tolerance));
            }
            (Does::Function(..), _) | (_, Does::Function(..)) => self.functions += 1,
        }
    }

    pub fn is_same(&self) -> bool {
        self.first.is_none()
    }

    /// In a few lines; `names` are those of the programs.
    pub fn text(&self, a: &[Step], b: &[Step], names: [&str; 2]) -> String {
        let [one, other] = &self.sums;
        let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        let lines = |label: &str, values: [String; 2]| {
            let line =
                |i: usize| format!("  {:16}  {:>width$}: {}\n", if i == 0 { label } else { "" }, names[i], values[i]);
            line(0) + &line(1)
        };
        let Some(first) = self.first else {
            return format!("motion: all {} moves are the same, within {}\n", one.moves, shown(self.largest));
        };
        let mut text = if one.moves == other.moves && self.only == [0, 0] {
            let (n, all) = (self.differing, if self.functions > 0 { a.len() } else { one.moves });
            let what = if self.functions > 0 { "steps" } else { "moves" };
            let differ = if n == 1 { "differs" } else { "differ" };
            format!("motion: {n} of {all} {what} {differ}, by up to {}\n", shown(self.largest))
        } else {
            let (n, [less, more]) = (self.differing, self.only);
            let (one, other) = (one.moves, other.moves);
            format!(
                "motion: {one} and {other} moves; {n} differ, {less} are only in {}, {more} only in {}\n",
                names[0], names[1]
            )
        };
        if self.feeds > 0 {
            text += &format!("  {} of them in the feed alone\n", self.feeds);
        }
        let step = |list: &[Step], at: Option<usize>| at.map_or("none".to_owned(), |at| list[at].text());
        text += &lines("first difference", [step(a, first[0]), step(b, first[1])]);
        text += &lines("way", [one, other].map(|sum| format!("{} mm", shown(sum.way))));
        if one.tools != other.tools {
            let tools = |sum: &Sum| sum.tools.iter().map(|tool| format!("T{tool}")).collect::<Vec<_>>().join(" ");
            text += &lines("tools", [tools(one), tools(other)]);
        }
        text
    }

    /// The same as data.
    pub fn json(&self, a: &[Step], b: &[Step], names: [&str; 2]) -> Value {
        let program = |i: usize, list: &[Step]| {
            let first = self.first.and_then(|first| first[i]).map(|at| &list[at]);
            json!({
                "name": names[i],
                "moves": self.sums[i].moves,
                "way": shown(self.sums[i].way),
                "tools": self.sums[i].tools,
                "first_line": first.map(|step| step.line),
                "first": first.map(Step::text),
                "only": self.only[i],
            })
        };
        json!({
            "same": self.is_same(),
            "differing": self.differing,
            "feeds": self.feeds,
            "functions": self.functions,
            "largest": shown(self.largest),
            "programs": [program(0, a), program(1, b)],
        })
    }
}

/// How many steps each program goes on until both agree again; all that is left where they never do.
fn again(a: &[&Step], b: &[&Step], tolerance: f64) -> (usize, usize) {
    let agree = |i: usize, j: usize| {
        let left = (a.len() - i).min(b.len() - j);
        let ends = a.len() - i == b.len() - j;
        let run = left.min(AGREE);
        (run == AGREE || ends && left == run) && (0..run).all(|n| same(a[i + n], b[j + n], tolerance))
    };
    for sum in 1..=AHEAD {
        // Changed steps are likelier than new ones.
        let mut tries: Vec<(usize, usize)> = (0..=sum).map(|i| (i, sum - i)).collect();
        tries.sort_by_key(|(i, j)| i.abs_diff(*j));
        let found = tries.into_iter().find(|(i, j)| *i <= a.len() && *j <= b.len() && agree(*i, *j));
        if let Some(found) = found {
            return found;
        }
    }
    match (a.len(), b.len()) {
        (0, left) => (0, left),
        (left, 0) => (left, 0),
        _ => (1, 1),
    }
}

fn same(a: &Step, b: &Step, tolerance: f64) -> bool {
    match (&a.does, &b.does) {
        (Does::Travel(a), Does::Travel(b)) => same_travel(a, b, tolerance),
        (Does::Function(a, n), Does::Function(b, m)) => {
            a == b && n.iter().zip(m).all(|(n, m)| (n - m).abs() <= tolerance)
        }
        _ => false,
    }
}

fn same_travel(a: &Travel, b: &Travel, tolerance: f64) -> bool {
    let same_kind = match (a.kind, b.kind) {
        (Kind::Rapid, Kind::Rapid) | (Kind::Line, Kind::Line) => true,
        (Kind::Thread(one), Kind::Thread(other)) => same_pitch(one, other, a.length().max(b.length()), tolerance),
        (Kind::Tap(one), Kind::Tap(other)) => {
            let deep = |travel: &Travel, stroke: &Stroke| {
                let ways = [&travel.start, &travel.end].map(|pos| pos.get(stroke.axis).unwrap_or(stroke.depth));
                ways.into_iter().map(|at| (at - stroke.depth).abs()).fold(0.0, f64::max)
            };
            same_stroke(&one, &other, tolerance)
                && same_pitch(one.lead, other.lead, deep(a, &one).max(deep(b, &other)), tolerance)
        }
        (
            Kind::Arc { plane, center, sweep },
            Kind::Arc { plane: other_plane, center: other_center, sweep: other_sweep },
        ) => {
            // Rounded ends of a short arc move its centre far, and the arc little: its middle is looked at below.
            let radius = b.end.in_plane(plane).map_or(0.0, |end| distance(end, center)).max(tolerance);
            let turned = (sweep - other_sweep).abs() * radius;
            plane == other_plane
                && turned <= 4.0 * tolerance + ANGLE * sweep.abs() * radius
                && (distance(center, other_center) <= 4.0 * tolerance
                    || gap(&a.place(0.5), &b.place(0.5)) <= 2.0 * tolerance)
        }
        _ => false,
    };
    same_kind
        && a.machine == b.machine
        && a.side == b.side
        && same_feed(a.feed, b.feed, tolerance)
        && ends_alike(a, b)
        && gap(&a.end, &b.end) <= tolerance
}

/// What the places of a factor may change a speed by, as a part of it.
const OF_FACTOR: f64 = 1e-4;

/// Half of the last of four places, and what a conversion adds: so much of a pitch no output says.
const OF_PITCH: f64 = 0.51e-4;

/// Do two pitches lead to the same place at the end of so long a way, as far as they can be printed?
fn same_pitch(a: f64, b: f64, way: f64, tolerance: f64) -> bool {
    let turns = way / a.min(b).max(f64::MIN_POSITIVE);
    let off = (a - b).abs();
    off <= OF_PITCH || off * turns.max(1.0) <= tolerance
}

/// An angle within half a turn, without its sign.
fn turned_by(angle: f64) -> f64 {
    let part = angle - 360.0 * libm::floor(angle / 360.0);
    part.min(360.0 - part)
}

/// Where a text does not say it, the spindle may start anywhere: that is another start than 0.
fn same_angle(a: &Stroke, b: &Stroke, tolerance: f64) -> bool {
    match (a.angle, b.angle) {
        (Some(one), Some(other)) => turned_by(one - other) <= tolerance,
        (None, None) => true,
        (Some(said), None) => b.any_angle && turned_by(said) <= tolerance,
        (None, Some(said)) => a.any_angle && turned_by(said) <= tolerance,
    }
}

fn same_stroke(a: &Stroke, b: &Stroke, tolerance: f64) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= tolerance;
    // What nobody said is not another speed.
    let same = |a: Option<f64>, b: Option<f64>| a.zip(b).is_none_or(|(a, b)| near(a, b));
    a.axis == b.axis
        && a.turn == b.turn
        && near(a.depth, b.depth)
        && near(a.dwell, b.dwell)
        && same_angle(a, b, tolerance)
        && same(a.speed, b.speed)
        // It may be printed as a factor on the speed of the way in, with four places.
        && a.back.zip(b.back).is_none_or(|(a, b)| (a - b).abs() <= tolerance.max(a.abs() * OF_FACTOR))
}

/// Neither names an axis of which the other knows nothing.
fn ends_alike(a: &Travel, b: &Travel) -> bool {
    let moved = |one: &Travel, other: &Travel| {
        one.end.iter().any(|(axis, end)| other.end.get(axis).is_none() && one.start.get(axis) != Some(end))
    };
    !moved(a, b) && !moved(b, a)
}

fn same_feed(a: Option<Feed>, b: Option<Feed>, tolerance: f64) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => {
            core::mem::discriminant(&a) == core::mem::discriminant(&b) && (a.value() - b.value()).abs() <= tolerance
        }
        // What is carried out in other axes has a feed that only its printed numbers give.
        _ => true,
    }
}

/// Largest difference of a coordinate that both know.
fn gap(a: &Pos, b: &Pos) -> f64 {
    a.iter().filter_map(|(axis, value): (Axis, f64)| Some((value - b.get(axis)?).abs())).fold(0.0, f64::max)
}

fn is_tiny(step: &Step, tolerance: f64) -> bool {
    match &step.does {
        Does::Travel(travel) => {
            travel.start.known() == travel.end.known()
                && gap(&travel.start, &travel.end) <= tolerance
                && !matches!(travel.kind, Kind::Arc { .. } | Kind::Tap(_))
        }
        Does::Function(..) => false,
    }
}

/// How far two moves are apart at most: at their ends and halfway.
fn apart(a: &Step, b: &Step) -> f64 {
    match (&a.does, &b.does) {
        (Does::Travel(a), Does::Travel(b)) if a.machine == b.machine => {
            let halfway = if a.machine { 0.0 } else { gap(&a.place(0.5), &b.place(0.5)) };
            gap(&a.end, &b.end).max(halfway)
        }
        _ => 0.0,
    }
}
