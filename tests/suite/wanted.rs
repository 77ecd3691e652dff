//! What the cases of the golden books are wanted to do, worked out by hand from the program, is what they do.
//!
//! The moves are compared before they are rounded, with the four decimals of the books, and each has to come behind the one
//! before. `tests/golden/README.md` describes the items.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use partc::internals::driver::Session;
use partc::internals::geo::{Plane, rotation};
use partc::internals::ir::function::{Coolant, Spindle, Turn};
use partc::internals::ir::{Function, Origin, Pos, motion};
use partc::internals::machine::Axis;
use partc::internals::text::{Memory, Opened};

use super::book::{self, Case};

/// Four decimals, rounded or cut.
const WRITTEN: f64 = 1.1e-4;

/// What a program does; of a move where it starts, too.
enum Act {
    Move(motion::Move, Pos),
    Function(Function),
}

#[derive(Default)]
struct Acts {
    list: Vec<Act>,
    at: Pos,
}

impl motion::Sink for Acts {
    fn movement(&mut self, mv: &motion::Move, _: &Origin) {
        self.list.push(Act::Move(*mv, self.at));
        self.at = if mv.machine { Pos::UNKNOWN } else { mv.end };
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        self.list.push(Act::Function(function.clone()));
    }

    fn lost(&mut self, _: &Origin) {
        self.at = Pos::UNKNOWN;
    }

    fn begins_at(&mut self, at: &Pos) {
        self.at.update(at);
    }
}

/// The acts of a case, and whether it is refused.
fn acts(case: &Case) -> (Vec<Act>, bool) {
    let text = Box::new(Memory::new(case.program.clone()));
    let session = Session::new(Opened { name: case.file.clone(), identity: case.file.clone(), text });
    let dialect = partc::internals::dialect::find(&case.dialect).expect("a dialect");
    let mut out = Acts::default();
    session.lower(dialect, &case.settings(), case, &mut out);
    (out.list, session.diags.has_errors())
}

/// A letter and its number.
#[derive(Debug, Clone, Copy)]
struct Word(char, f64);

fn words(text: &str) -> Result<Vec<Word>, String> {
    let word = |word: &str| {
        let letter = word.chars().next().unwrap_or_default();
        let number = word[letter.len_utf8()..].parse().map_err(|_| format!("`{word}` is no word"))?;
        Ok(Word(letter, number))
    };
    text.split_whitespace().map(word).collect()
}

/// A move or function that is wanted.
enum Item {
    Move {
        kind: Kind,
        machine: bool,
        end: Vec<Word>,
        start: Vec<Word>,
        centre: Vec<Word>,
        sweep: Option<f64>,
    },
    Function(Word),
    Dwell(f64),
    /// Cutting speed in m/min.
    Cutting(f64),
    /// A working plane by its space angles and its zero point.
    Plane([f64; 6]),
    /// The plane ends, and the rotary axes turn back or stay.
    PlaneEnds {
        turns: bool,
    },
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Rapid,
    Line,
    Arc { ccw: bool },
    Thread,
}

/// `text` up to ` mark `, and what stands behind it.
fn part<'t>(text: &'t str, mark: &str) -> (&'t str, &'t str) {
    text.split_once(mark).unwrap_or((text, ""))
}

impl Item {
    fn of(text: &str) -> Result<Item, String> {
        let (machine, rest) = text.strip_prefix("G53 ").map_or((false, text), |rest| (true, rest));
        let (first, rest) = part(rest, " ");
        let kind = match first {
            "G0" => Kind::Rapid,
            "G1" => Kind::Line,
            "G2" => Kind::Arc { ccw: false },
            "G3" => Kind::Arc { ccw: true },
            "thread" => Kind::Thread,
            "dwell" => return Ok(Item::Dwell(rest.parse().map_err(|_| format!("`{text}` has no seconds"))?)),
            "plane" if rest == "back" || rest == "off" => return Ok(Item::PlaneEnds { turns: rest == "back" }),
            "plane" => {
                let numbers: Vec<f64> =
                    rest.split_whitespace().filter(|word| *word != "at").filter_map(|n| n.parse().ok()).collect();
                let numbers = <[f64; 6]>::try_from(numbers);
                return numbers.map(Item::Plane).map_err(|_| format!("`{text}`: `plane A B C at X Y Z`"));
            }
            "cutting" => return Ok(Item::Cutting(rest.parse().map_err(|_| format!("`{text}` has no speed"))?)),
            _ => match words(text)?[..] {
                [word] if matches!(word.0, 'M' | 'S' | 'T' | 'G') => return Ok(Item::Function(word)),
                _ => return Err(format!("`{text}` has no meaning")),
            },
        };
        let (rest, sweep) = part(rest, " by ");
        let (ends, centre) = part(rest, " about ");
        let (start, end) = ends.split_once(" to ").unwrap_or(("", ends));
        let sweep = if sweep.is_empty() { None } else { Some(sweep.parse().map_err(|_| format!("`{text}`: sweep"))?) };
        let item = Item::Move { kind, machine, end: words(end)?, start: words(start)?, centre: words(centre)?, sweep };
        match &item {
            Item::Move { end, centre, .. } if end.is_empty() && centre.is_empty() => {
                Err(format!("`{text}` says nothing"))
            }
            _ => Ok(item),
        }
    }

    fn is(&self, act: &Act) -> bool {
        match (self, act) {
            (Item::Move { machine, .. }, Act::Move(mv, from)) => *machine == mv.machine && self.is_made_by(mv, from),
            (Item::Function(word), Act::Function(function)) => does(function, *word),
            (Item::Dwell(seconds), Act::Function(Function::Dwell(made))) => near(*made, *seconds),
            (Item::Plane(wanted), Act::Function(Function::Tilt(tilting))) => tilting.plane().is_some_and(|tilt| {
                let [a, b, c, origin @ ..] = *wanted;
                let off = rotation::spatial([a, b, c]) - tilt.axes;
                off.iter().all(|v| v.abs() < TURNED) && origin.iter().zip(tilt.origin.iter()).all(|(a, b)| near(*a, *b))
            }),
            (Item::PlaneEnds { turns }, Act::Function(Function::Tilt(tilting))) => {
                tilting.plane().is_none() && tilting.turns() == *turns
            }
            (Item::Cutting(wanted), Act::Function(Function::Spindle(Spindle::CuttingSpeed { speed, .. }))) => {
                near(*speed, *wanted)
            }
            _ => false,
        }
    }

    fn is_made_by(&self, mv: &motion::Move, from: &Pos) -> bool {
        let Item::Move { kind, end, start, centre, sweep, .. } = self else { return false };
        let made = match mv.path {
            motion::Path::Rapid => Kind::Rapid,
            motion::Path::Line(_) | motion::Path::Carried { .. } => Kind::Line,
            motion::Path::Thread { .. } => Kind::Thread,
            motion::Path::Arc(arc, _) => Kind::Arc { ccw: arc.sweep > 0.0 },
        };
        let ends = end.iter().all(|word| match (word.0, mv.path) {
            ('F', motion::Path::Carried { feed, .. }) => near(feed, word.1),
            ('F', path) => path.feed().is_some_and(|feed| near(feed.value(), word.1)),
            ('K', motion::Path::Thread { lead }) => near(lead, word.1),
            (letter, _) => axis(letter).and_then(|axis| mv.end.get(axis)).is_some_and(|at| near(at, word.1)),
        });
        let starts =
            start.iter().all(|word| axis(word.0).and_then(|axis| from.get(axis)).is_some_and(|at| near(at, word.1)));
        let round = match mv.path {
            motion::Path::Arc(arc, _) => {
                let of = |letter, point: partc::internals::geo::Point2| {
                    let (first, second) = match arc.plane {
                        Plane::Xy => ('X', 'Y'),
                        Plane::Zx => ('Z', 'X'),
                        Plane::Yz => ('Y', 'Z'),
                    };
                    if letter == first { Some(point.x) } else { (letter == second).then_some(point.y) }
                };
                centre.iter().all(|word| of(word.0, arc.center).is_some_and(|at| near(at, word.1)))
                    && sweep.is_none_or(|wanted| near(arc.sweep.to_degrees().abs(), wanted))
            }
            _ => centre.is_empty() && sweep.is_none(),
        };
        made == *kind && ends && starts && round
    }
}

/// What the fourth decimal of an angle may move a direction by.
const TURNED: f64 = 2e-6;

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= WRITTEN
}

fn axis(letter: char) -> Option<Axis> {
    Axis::ALL.into_iter().find(|axis| axis.letter() == letter)
}

fn does(function: &Function, word: Word) -> bool {
    let number = word.1;
    let whole = |n: u32| f64::from(n) == number;
    match (word.0, function) {
        ('S', Function::Spindle(Spindle::Speed(speed))) => near(*speed, number),
        ('T', Function::ToolChange { number } | Function::ToolPrepare { number }) => whole(*number),
        ('G', Function::WorkOffset(offset)) => whole(53 + u32::from(*offset)),
        ('G', Function::Plane(plane)) => whole(match plane {
            Plane::Xy => 17,
            Plane::Zx => 18,
            Plane::Yz => 19,
        }),
        ('M', Function::Aux(made)) => whole(*made),
        ('M', Function::Spindle(Spindle::Start(Turn::Clockwise))) => whole(3),
        ('M', Function::Spindle(Spindle::Start(Turn::CounterClockwise))) => whole(4),
        ('M', Function::Spindle(Spindle::Stop)) => whole(5),
        ('M', Function::Spindle(Spindle::Orient(_))) => whole(19),
        ('M', Function::Coolant(Coolant::Mist)) => whole(7),
        ('M', Function::Coolant(Coolant::Flood)) => whole(8),
        ('M', Function::Coolant(Coolant::Off)) => whole(9),
        ('M', Function::Stop) => whole(0),
        ('M', Function::OptionalStop) => whole(1),
        ('M', Function::End { rewind }) => whole(if *rewind { 30 } else { 2 }),
        _ => false,
    }
}

/// What a line wants of the acts; the first thing that is not met.
fn missed(line: &str, acts: &[Act]) -> Option<String> {
    if line == "no moves" {
        return acts.iter().any(|act| matches!(act, Act::Move(..))).then(|| "it moves".to_owned());
    }
    let (exactly, line) = line.strip_prefix("exactly ").map_or((false, line), |line| (true, line));
    let mut rest = acts.iter();
    for text in line.split(';').map(str::trim).filter(|item| !item.is_empty()) {
        let item = match Item::of(text) {
            Ok(item) => item,
            Err(why) => return Some(why),
        };
        // Where no other move may be made, the next one is it, and none stands in front of a function.
        let met = match exactly {
            true => {
                let next = rest.by_ref().find(|act| matches!(act, Act::Move(..)) || item.is(act));
                next.is_some_and(|act| item.is(act))
            }
            false => rest.any(|act| item.is(act)),
        };
        if !met {
            return Some(text.to_owned());
        }
    }
    (exactly && rest.any(|act| matches!(act, Act::Move(..)))).then(|| "it moves once more".to_owned())
}

/// `CODE text`: a finding of this code says so.
fn not_said(wanted: &str, case: &Case) -> Option<String> {
    let (code, part) = wanted.split_once(' ').unwrap_or((wanted, ""));
    let found = case.compile().findings;
    let said = found.iter().any(|found| {
        found.code.id == code && (found.text().contains(part) || found.help.iter().any(|help| help.contains(part)))
    });
    let all: Vec<_> = found.iter().map(|found| format!("{} {}", found.code.id, found.text())).collect();
    (!said).then(|| format!("!! {wanted}: {all:?}"))
}

/// Cases that compile, and those of them whose moves or functions are worked out.
#[derive(Default)]
struct Count {
    compile: usize,
    decided: usize,
    refused: usize,
}

#[test]
fn what_is_wanted_of_cases_is_done() {
    let mut bad = String::new();
    let mut counts: BTreeMap<&str, Count> = BTreeMap::new();
    for book in book::names() {
        for case in book::of(&book) {
            let (findings, lines): (Vec<_>, Vec<_>) = case.wanted.iter().partition(|line| line.starts_with("!! "));
            let (made, refused) = acts(case);
            let count = counts.entry(&case.dialect).or_default();
            count.compile += usize::from(!refused);
            count.decided += usize::from(!refused && !lines.is_empty());
            count.refused += usize::from(refused && !findings.is_empty());
            if refused && !lines.is_empty() {
                let _ = writeln!(bad, "{}: it is refused", case.name);
            }
            let wrong = whole_lines(&lines).into_iter().find_map(|line| missed(&line, &made));
            for wrong in wrong.into_iter().chain(findings.iter().filter_map(|line| not_said(&line[3..], case))) {
                let _ = writeln!(bad, "{}: {wrong}", case.name);
            }
        }
    }
    let mut shares = String::new();
    for (dialect, Count { compile, decided, refused }) in &counts {
        let _ = writeln!(shares, "{dialect}: {decided} of {compile} are decided; {refused} refusals");
    }
    println!("{shares}");
    assert!(bad.is_empty(), "not as worked out:\n{bad}");
    let sum = |of: fn(&Count) -> usize| counts.values().map(of).sum::<usize>();
    assert!(sum(|count| count.decided) * 100 >= sum(|count| count.compile) * LEAST_DECIDED, "{shares}");
    assert!(sum(|count| count.refused) >= 400, "{shares}");
}

/// Of a hundred cases that compile, so many have their numbers worked out.
const LEAST_DECIDED: usize = 95;

/// Lines of one list are one: a list goes on while an item follows.
fn whole_lines(lines: &[&String]) -> Vec<String> {
    let mut whole: Vec<String> = Vec::new();
    for line in lines {
        match whole.last_mut() {
            Some(last) if last.ends_with(';') => {
                last.push(' ');
                last.push_str(line);
            }
            _ => whole.push((*line).clone()),
        }
    }
    whole
}
