//! Reads a printed program back as moves, to say what a difference of two outputs means on the machine.
//!
//! The reader knows the plain words that partc prints: absolute positions, arcs by offset, modal G codes.
//! It checks nothing: the text was printed by partc, or is shown as text all the same.

use core::f64::consts::TAU;

use serde_json::{Value, json};

use crate::geo::{Plane, Point2, Vec2, arc, distance};
use crate::machine::Axis;
use crate::machine::axis::AXES;

/// Numbers closer than this print alike.
const SAME: f64 = 1e-7;

/// One move of a printed program.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// 1-based line.
    line: usize,
    /// Word of the move, such as `G1`; `G53 G0` in machine coordinates.
    word: String,
    end: [Option<f64>; AXES],
    /// I J K and P, K as pitch too.
    arc: [Option<f64>; 4],
    feed: Option<f64>,
    /// Way of the main axes in mm; 0 where the start is not known.
    length: f64,
}

impl Motion {
    fn same(&self, other: &Motion) -> bool {
        let near = |a: &Option<f64>, b: &Option<f64>| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() < SAME,
            (None, None) => true,
            _ => false,
        };
        self.word == other.word
            && self.end.iter().zip(&other.end).all(|(a, b)| near(a, b))
            && self.arc.iter().zip(&other.arc).all(|(a, b)| near(a, b))
            && near(&self.feed, &other.feed)
    }

    /// Largest difference of a coordinate at the end.
    fn gap(&self, other: &Motion) -> f64 {
        let ends = self.end.iter().zip(&other.end);
        ends.filter_map(|(a, b)| Some((a.as_ref()? - b.as_ref()?).abs())).fold(0.0, f64::max)
    }

    fn text(&self) -> String {
        let mut text = self.word.clone();
        for axis in Axis::ALL {
            if let Some(value) = self.end[axis.index()] {
                text += &format!(" {}{value}", axis.letter());
            }
        }
        for (letter, value) in ['I', 'J', 'K', 'P'].iter().zip(self.arc) {
            if let Some(value) = value {
                text += &format!(" {letter}{value}");
            }
        }
        if let Some(feed) = self.feed.filter(|_| !self.word.ends_with("G0")) {
            text += &format!(" F{feed}");
        }
        format!("{text} (line {})", self.line)
    }
}

/// The moves of a printed program, each with everything that holds for it.
pub fn read(program: &str) -> Vec<Motion> {
    let mut reader = Reader { diameter: false, at: [None; AXES], plane: Plane::Xy, word: "G0".to_owned(), feed: None };
    program.lines().enumerate().filter_map(|(i, line)| reader.line(i + 1, line)).collect()
}

struct Reader {
    /// X words are diameters.
    diameter: bool,
    at: [Option<f64>; AXES],
    plane: Plane,
    word: String,
    feed: Option<f64>,
}

impl Reader {
    fn line(&mut self, number: usize, line: &str) -> Option<Motion> {
        let (mut end, mut arc, mut machine, mut moves) = (self.at, [None; 4], false, false);
        for (letter, value) in words(line) {
            match letter {
                'G' => match value {
                    17.0 => self.plane = Plane::Xy,
                    18.0 => self.plane = Plane::Zx,
                    19.0 => self.plane = Plane::Yz,
                    7.0 => self.diameter = true,
                    8.0 => self.diameter = false,
                    53.0 => machine = true,
                    0.0..=3.0 | 33.0..=34.0 => self.word = format!("G{value}"),
                    // Work offsets change where the same numbers are.
                    54.0..60.0 => self.at = [None; AXES],
                    _ => {}
                },
                'F' => self.feed = Some(value),
                'I' | 'J' | 'K' | 'P' => arc["IJKP".find(letter)?] = Some(value),
                _ => {
                    if let Some(axis) = u8::try_from(letter).ok().and_then(Axis::of) {
                        end[axis.index()] = Some(value);
                        moves = true;
                    }
                }
            }
        }
        if !moves {
            return None;
        }
        let word = if machine { format!("G53 {}", self.word) } else { self.word.clone() };
        let length = if machine { 0.0 } else { self.length(&end, &arc) };
        for (at, end) in self.at.iter_mut().zip(&end) {
            *at = if machine && at != end { None } else { *end };
        }
        Some(Motion { line: number, word, end, arc, feed: self.feed, length })
    }

    /// Way of the main axes.
    fn length(&self, end: &[Option<f64>; AXES], offsets: &[Option<f64>; 4]) -> f64 {
        let part = |i: usize| if self.diameter && i == 0 { 0.5 } else { 1.0 };
        let way = |i: usize| end[i].zip(self.at[i]).map_or(0.0, |(to, from)| part(i) * (to - from));
        let (first, second, third) = self.plane.axes();
        let (Some(x), Some(y), true) = (self.at[first], self.at[second], matches!(self.word.as_str(), "G2" | "G3"))
        else {
            return libm::hypot(libm::hypot(way(0), way(1)), way(2));
        };
        let from = Point2::new(part(first) * x, part(second) * y);
        let to = from + Vec2::new(way(first), way(second));
        let center = from + Vec2::new(offsets[first].unwrap_or(0.0), offsets[second].unwrap_or(0.0));
        let turns = offsets[3].unwrap_or(1.0) - 1.0;
        let sweep = arc::sweep(from, to, center, self.word == "G3").abs() + turns * TAU;
        libm::hypot(sweep * distance(from, center), way(third))
    }
}

/// Bound of a number that is read, in mm: lengths computed from it stay finite. No machine reaches it.
const LARGEST: f64 = 1e12;

/// Letters and numbers of a line, comments left out.
fn words(line: &str) -> Vec<(char, f64)> {
    let mut words = Vec::new();
    let mut rest = line;
    loop {
        rest = rest.trim_start();
        if let Some(comment) = rest.strip_prefix('(') {
            rest = comment.split_once(')').map_or("", |(_, behind)| behind);
            continue;
        }
        let Some(letter) = rest.chars().next() else { return words };
        let behind = &rest[letter.len_utf8()..];
        let number = behind.len() - behind.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.".contains(c)).len();
        if let Ok(value) = behind[..number].parse::<f64>() {
            words.push((letter.to_ascii_uppercase(), value.clamp(-LARGEST, LARGEST)));
        }
        rest = &behind[number..];
    }
}

/// What two programs do differently.
#[derive(Debug)]
pub struct Change {
    before: Vec<Motion>,
    now: Vec<Motion>,
    /// Pairs of moves that differ, where there are as many.
    differing: usize,
    first: Option<usize>,
    largest: f64,
}

impl Change {
    pub fn between(before: &str, now: &str) -> Change {
        let (before, now) = (read(before), read(now));
        let unequal = |(a, b): (&Motion, &Motion)| !a.same(b);
        let differing = before.iter().zip(&now).filter(|pair| unequal(*pair)).count();
        let same = before.iter().zip(&now).position(unequal);
        let first = same.or((before.len() != now.len()).then(|| before.len().min(now.len())));
        let largest = before.iter().zip(&now).map(|(a, b)| a.gap(b)).fold(0.0, f64::max);
        Change { before, now, differing, first, largest }
    }

    /// In a few lines.
    pub fn text(&self) -> String {
        let Some(first) = self.first else {
            return "motion: all moves are the same; only other words differ\n".to_owned();
        };
        let shown = |list: &[Motion]| list.get(first).map_or("none".to_owned(), Motion::text);
        let mut text = if self.before.len() == self.now.len() {
            let (n, all) = (self.differing, self.now.len());
            let differ = if n == 1 { "differs" } else { "differ" };
            format!("motion: {n} of {all} moves {differ}, by up to {} at the end of a move\n", round(self.largest))
        } else {
            format!("motion: {} moves, golden has {}\n", self.now.len(), self.before.len())
        };
        text += &format!("  first difference  golden: {}\n", shown(&self.before));
        text += &format!("                       now: {}\n", shown(&self.now));
        let length = |list: &[Motion]| round(list.iter().map(|motion| motion.length).sum());
        text + &format!("  way               golden: {} mm, now: {} mm\n", length(&self.before), length(&self.now))
    }

    pub fn json(&self) -> Value {
        let length = |list: &[Motion]| round(list.iter().map(|motion| motion.length).sum());
        let line = |list: &[Motion]| self.first.and_then(|i| list.get(i)).map(|motion| motion.line);
        json!({
            "same": self.first.is_none(),
            "golden": { "moves": self.before.len(), "way": length(&self.before), "first_line": line(&self.before) },
            "now": { "moves": self.now.len(), "way": length(&self.now), "first_line": line(&self.now) },
        })
    }
}

fn round(v: f64) -> f64 {
    libm::round(v * 1e4) / 1e4
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moves_carry_what_holds_for_them() {
        let moves = read("%\n(G1 X9)\nG17\nT1 M6\nG0 X0 Y0\nG1 X10 F100\nG3 X10 Y0 I-5 J0 P2\nG53 G0 Z-1\nM30\n%\n");
        let words: Vec<&str> = moves.iter().map(|motion| motion.word.as_str()).collect();
        assert_eq!(words, ["G0", "G1", "G3", "G53 G0"]);
        assert_eq!((moves[2].line, moves[2].feed), (7, Some(100.0)));
        assert!((moves[2].length - 2.0 * TAU * 5.0).abs() < 1e-9);
        assert_eq!(moves[3].text(), "G53 G0 X10 Y0 Z-1 (line 8)");
    }

    #[test]
    fn numbers_beyond_any_machine_leave_the_lengths_finite() {
        let far = format!("G0 X0 Y0\nG3 X10 Y10 I0 J1{}\nG3 X0 I1{}\n", "0".repeat(200), "0".repeat(400));
        assert!(read(&far).iter().all(|motion| motion.length.is_finite()));
    }

    #[test]
    fn a_change_names_its_first_move_and_its_size() {
        let change = Change::between("G0 X0 Y0\nG1 X10 F100\n", "G0 X0 Y0\n(new)\nG1 X10.5 F100\n");
        let text = change.text();
        assert!(text.contains("1 of 2 moves differs, by up to 0.5"), "{text}");
        assert!(text.contains("golden: G1 X10 Y0 F100 (line 2)") && text.contains("now: G1 X10.5 Y0 F100 (line 3)"));
        assert!(text.contains("golden: 10 mm, now: 10.5 mm"), "{text}");
        assert!(Change::between("G0 X1\nM8\n", "G0 X1\nM9\n").text().contains("only other words differ"));
        assert!(Change::between("G0 X1\n", "G0 X1\nG0 X2\n").text().contains("2 moves, golden has 1"));
    }
}
