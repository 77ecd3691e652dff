//! A strict reader of what GRBL takes, after its own interpreter: one line at a time, single precision, error numbers.
//!
//! It shares nothing with the printer. Whatever the interpreter would refuse is refused here, and arcs are turned as far
//! as its own arithmetic turns them.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// What differs between the receivers of the family.
pub struct Rules {
    /// Longest line, blanks and comments left out.
    pub length: usize,
    pub digits: usize,
    pub m: &'static [u32],
    /// A driver may add M functions.
    pub more_m: bool,
    /// Work offsets behind G59.
    pub more_offsets: bool,
    /// Arcs take the number of turns.
    pub turns: bool,
    pub most_tool: f64,
    /// Arcs are turned in double precision.
    pub double: bool,
    /// Some characters act as they arrive, in comments, too.
    pub streamed: bool,
}

pub const GRBL: Rules = Rules {
    length: 79,
    digits: 8,
    m: &[0, 1, 2, 3, 4, 5, 8, 9, 30],
    more_m: false,
    more_offsets: false,
    turns: false,
    most_tool: 255.0,
    double: false,
    streamed: true,
};

/// One move, or the words of a line that moves nothing.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    Straight { rapid: bool, machine: bool, end: [f64; 3], feed: Feed },
    Arc { plane: [usize; 3], center: [f64; 2], sweep: f64, end: [f64; 3], feed: Feed },
    Words(String),
    Comment(String),
}

/// Feed in force; whether it counts by time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feed(pub f64, pub bool);

/// Where the machine zero may lie, seen from the work offset: it changes what single precision can tell apart.
const OFFSETS: [f32; 3] = [0.0, -1234.567, 2345.678];

pub struct Reader<'a> {
    rules: &'a Rules,
    at: [f64; 3],
    plane: [usize; 3],
    motion: Option<u32>,
    feed: Option<f64>,
    by_time: bool,
}

type Words = BTreeMap<char, f64>;

impl<'a> Reader<'a> {
    pub fn new(rules: &'a Rules) -> Reader<'a> {
        Reader { rules, at: [0.0; 3], plane: [0, 1, 2], motion: Some(0), feed: None, by_time: false }
    }

    /// The events of one line, or why it is refused.
    pub fn line(&mut self, line: &str, events: &mut Vec<Event>) -> Result<(), String> {
        if let Some(b) = line.bytes().find(|b| !(b' '..0x7f).contains(b) || self.rules.streamed && b"!?~".contains(b)) {
            return Err(format!("the receiver acts on byte {b:#x} as it arrives"));
        }
        let mut code = String::new();
        let mut rest = line;
        while let Some((before, comment)) = rest.split_once('(') {
            code += before;
            let (comment, behind) = comment.split_once(')').ok_or("an open comment")?;
            events.push(Event::Comment(comment.to_owned()));
            rest = behind;
        }
        code += rest;
        code.retain(|c| c != ' ');
        if code.len() > self.rules.length {
            return Err("error 11: line overflow".to_owned());
        }
        if code.is_empty() { Ok(()) } else { self.block(&code, events) }
    }

    fn words(&self, code: &str) -> Result<(Vec<u32>, Vec<u32>, Words), String> {
        let (mut g, mut m, mut values) = (Vec::new(), Vec::new(), Words::new());
        let mut rest = code;
        while let Some(letter) = rest.chars().next() {
            if !letter.is_ascii_uppercase() {
                return Err("error 1: a letter is expected".to_owned());
            }
            rest = &rest[1..];
            let number = rest.len() - rest.trim_start_matches(|c: char| "+-.0123456789".contains(c)).len();
            let text = &rest[..number];
            rest = &rest[number..];
            let value: f64 = text.parse().map_err(|_| format!("error 2: {letter}{text}"))?;
            if text.bytes().filter(u8::is_ascii_digit).count() > self.rules.digits {
                return Err(format!("digits of {letter}{text} are dropped"));
            }
            match letter {
                'G' => g.push((value * 10.0).round() as u32),
                'M' if text.contains('.') => return Err("error 23: not an integer".to_owned()),
                'M' => m.push(value as u32),
                'F' | 'I' | 'J' | 'K' | 'N' | 'P' | 'R' | 'S' | 'T' | 'X' | 'Y' | 'Z' => {
                    if values.insert(letter, value).is_some() {
                        return Err(format!("error 25: {letter} repeated"));
                    }
                    if "FNPTS".contains(letter) && value < 0.0 {
                        return Err(format!("error 4: negative {letter}"));
                    }
                }
                _ => return Err(format!("error 20: {letter}")),
            }
        }
        Ok((g, m, values))
    }

    /// Modal group of a G word, in tenths.
    fn group(&self, g: u32) -> Result<u32, String> {
        Ok(match g {
            40 | 530 => 0,
            0 | 10 | 20 | 30 | 800 => 1,
            170 | 180 | 190 => 2,
            900 => 3,
            911 => 4,
            930 | 940 => 5,
            210 => 6,
            400 => 7,
            490 => 8,
            540 | 550 | 560 | 570 | 580 | 590 => 12,
            591..=593 if self.rules.more_offsets => 12,
            _ => return Err(format!("error 20: G{}", f64::from(g) / 10.0)),
        })
    }

    fn block(&mut self, code: &str, events: &mut Vec<Event>) -> Result<(), String> {
        let (g, m, mut values) = self.words(code)?;
        let mut groups = Vec::new();
        for &g in &g {
            let group = self.group(g)?;
            if groups.contains(&group) {
                return Err("error 21: two words of a group".to_owned());
            }
            groups.push(group);
        }
        if let Some(m) = m.iter().find(|m| !self.rules.more_m && !self.rules.m.contains(m)) {
            return Err(format!("error 20: M{m}"));
        }
        if m.len() > 1 {
            return Err("two M words in a line".to_owned());
        }
        if values.get(&'T').is_some_and(|t| *t > self.rules.most_tool) {
            return Err("error 38: tool number".to_owned());
        }
        for g in g.iter().copied() {
            match g {
                0 | 10 | 20 | 30 => self.motion = Some(g / 10),
                800 => self.motion = None,
                170 => self.plane = [0, 1, 2],
                180 => self.plane = [2, 0, 1],
                190 => self.plane = [1, 2, 0],
                // The feed is undefined after a change of its kind.
                930 | 940 if std::mem::replace(&mut self.by_time, g == 930) != (g == 930) => self.feed = None,
                _ => {}
            }
        }
        let feed = values.remove(&'F');
        self.feed = feed.or(self.feed.filter(|_| !self.by_time));
        let moves = ['X', 'Y', 'Z'].iter().any(|axis| values.contains_key(axis));
        if g.contains(&40) {
            values.remove(&'P').ok_or("error 28: a dwell without P")?;
        }
        let (machine, arc) = (g.contains(&530), matches!(self.motion, Some(2 | 3)));
        if machine && arc {
            return Err("error 31: G53 with an arc".to_owned());
        }
        if moves {
            let motion = self.motion.ok_or("error 31: axis words under G80")?;
            let event = self.movement(motion, machine, &mut values)?;
            events.push(event);
        } else if g.iter().any(|g| matches!(g, 20 | 30)) {
            return Err("error 26: an arc without an end".to_owned());
        }
        let other = !moves && (g.iter().any(|g| !matches!(g, 0 | 10)) || !m.is_empty() || !values.is_empty());
        if other {
            events.push(Event::Words(code.to_owned()));
        }
        values.retain(|letter, _| !("NST".contains(*letter) || g.contains(&40) && *letter == 'P'));
        match values.keys().next() {
            Some(letter) => Err(format!("error 36: {letter} is not used")),
            None => Ok(()),
        }
    }

    fn movement(&mut self, motion: u32, machine: bool, values: &mut Words) -> Result<Event, String> {
        let mut end = self.at;
        let (mut in_plane, mut named) = (false, [false; 3]);
        for (i, axis) in ['X', 'Y', 'Z'].iter().enumerate() {
            if let Some(value) = values.remove(axis) {
                (end[i], named[i]) = (value, true);
                in_plane |= i != self.plane[2];
            }
        }
        let feed = Feed(self.feed.unwrap_or(0.0), self.by_time);
        if motion != 0 && feed.0 == 0.0 {
            return Err("error 22: no feed".to_owned());
        }
        let event = if motion < 2 {
            Event::Straight { rapid: motion == 0, machine, end, feed }
        } else {
            if !in_plane {
                return Err("error 32: no axis of the plane".to_owned());
            }
            let turns = match values.remove(&'P') {
                Some(_) if !self.rules.turns => return Err("error 36: P on an arc".to_owned()),
                Some(turns) if turns < 1.0 || turns.fract() != 0.0 => return Err("no number of turns".to_owned()),
                turns => turns.unwrap_or(1.0),
            };
            self.arc(motion == 2, end, turns, feed, values)?
        };
        // Where a move in machine coordinates leads is not known here.
        self.at = if machine { [0, 1, 2].map(|i| if named[i] { f64::NAN } else { self.at[i] }) } else { end };
        Ok(event)
    }

    fn arc(&self, clockwise: bool, end: [f64; 3], turns: f64, feed: Feed, values: &mut Words) -> Result<Event, String> {
        let [a, b, _] = self.plane;
        let mut offset = [0.0; 3];
        let mut any = false;
        for (i, letter) in ['I', 'J', 'K'].iter().enumerate() {
            if let Some(value) = values.remove(letter) {
                offset[i] = value;
                any |= i != self.plane[2];
            }
        }
        if !any {
            return Err("error 35: no offset in the plane".to_owned());
        }
        let (from, to, off) = ([self.at[a], self.at[b]], [end[a], end[b]], [offset[a], offset[b]]);
        let center = [from[0] + off[0], from[1] + off[1]];
        let exact =
            travel([-off[0], -off[1]], [to[0] - center[0], to[1] - center[1]], clockwise, 1e-9 / off[0].hypot(off[1]));
        for offset in OFFSETS {
            self.turns_as_far(from, to, off, offset, clockwise, exact)?;
        }
        let whole = (turns - 1.0) * TAU;
        let sweep = exact + if clockwise { -whole } else { whole };
        Ok(Event::Arc { plane: self.plane, center, sweep, end, feed })
    }

    /// The checks and the arithmetic of the receiver, with the work offset at `offset`.
    fn turns_as_far(
        &self,
        from: [f64; 2],
        to: [f64; 2],
        off: [f64; 2],
        offset: f32,
        clockwise: bool,
        exact: f64,
    ) -> Result<(), String> {
        let place = |p: [f64; 2]| p.map(|v| v as f32 + offset);
        let (position, target, off) = (place(from), place(to), off.map(|v| v as f32));
        let (x, y) = (target[0] - position[0] - off[0], target[1] - position[1] - off[1]);
        let radius = off[0].hypot(off[1]);
        let delta = (x.hypot(y) - radius).abs();
        if delta > 0.005 && (delta > 0.5 || delta > 0.001 * radius) {
            return Err(format!("error 33: radii differ by {delta}"));
        }
        let turned = if self.rules.double {
            let center = [0, 1].map(|i| f64::from(position[i]) + f64::from(off[i]));
            let rt = [0, 1].map(|i| f64::from(target[i]) - center[i]);
            travel(off.map(|v| -f64::from(v)), rt, clockwise, 5e-7)
        } else {
            let center = [position[0] + off[0], position[1] + off[1]];
            let rt = [target[0] - center[0], target[1] - center[1]];
            travel(off.map(|v| -f64::from(v)), rt.map(f64::from), clockwise, 5e-7)
        };
        // Four roundings of a coordinate below 4096 mm.
        let noise = 1e-3 / f64::from(radius) + 1e-3;
        if (turned - exact).abs() > noise {
            return Err(format!("turns by {turned:.5} instead of {exact:.5} with the work offset at {offset}"));
        }
        Ok(())
    }
}

/// Signed angle from `r` to `rt`; one that is not larger than `epsilon` is a full turn.
fn travel(r: [f64; 2], rt: [f64; 2], clockwise: bool, epsilon: f64) -> f64 {
    let angle = (r[0] * rt[1] - r[1] * rt[0]).atan2(r[0] * rt[0] + r[1] * rt[1]);
    debug_assert!(angle.abs() <= PI + 1e-9);
    match clockwise {
        true if angle >= -epsilon => angle - TAU,
        false if angle <= epsilon => angle + TAU,
        _ => angle,
    }
}

/// All events of a program, or the first line that is refused.
pub fn read(program: &str, rules: &Rules) -> Result<Vec<Event>, String> {
    let mut reader = Reader::new(rules);
    let mut events = Vec::new();
    for (i, line) in program.lines().enumerate() {
        reader.line(line, &mut events).map_err(|why| format!("line {}: {why}: {line}", i + 1))?;
    }
    match program.lines().last() {
        Some("M2" | "M30") => Ok(events),
        _ => Err("no end of program".to_owned()),
    }
}

#[test]
fn what_the_interpreter_refuses_is_refused() {
    let refused = |lines: &str, why: &str| {
        let found = read(&format!("G21 G90 G94\nG0 X0 Y0 Z0\n{lines}\nM30\n"), &GRBL).unwrap_err();
        assert!(found.contains(why), "{lines}: {found}");
    };
    refused("%", "error 1");
    refused("G43 H1", "error 20");
    refused("G59.1", "error 20");
    refused("G64", "error 20");
    refused("G95", "error 20");
    refused("T1 M6", "error 20");
    refused("M7", "error 20");
    refused("G1 A5 F100", "error 20");
    refused("G1 X1e3 F100", "error 1");
    refused("G0 G1 X5 F100", "error 21");
    refused("G1 X5 X6 F100", "error 25");
    refused("G4", "error 28");
    refused("G1 X5", "error 22");
    refused("T256", "error 38");
    refused("G3 X0 Y0 I5 J0 P2 F100", "error 36");
    refused("G3 X10 Y0 I5.5 J0 F100", "error 33");
    refused("G3 Z5 I5 J0 F100", "error 32");
    refused("G1 X12345.6789 F100", "dropped");
    refused("(what?)", "acts on byte");
    refused("G1 X1.000000000000000000000000000000000000000000000000000000000000000000000000000000", "error 11");
    // The end is the start, and rounding turns the circle into nothing.
    refused("G0 X100.1234 Y50.4321\nG3 X100.1234 Y50.4321 I3.3333 J4.4444 F100", "turns by");
    let fine = "G21 G90 G94\nG0 X0 Y0 Z0\nG1 X30 F200\nG3 X40 Y10 I0 J10\nG4 P0.5\nG53 G0 Z-1\nM30\n";
    assert_eq!(read(fine, &GRBL).map(|events| events.len()), Ok(7));
}
