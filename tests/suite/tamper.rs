//! Do the readers see faults? Each kind of fault is put into real outputs, hundreds in all, the same ones in each run;
//! every one of them has to be noticed.

use std::sync::OnceLock;

use super::damage::Dice;
use super::oracle::{self, Case};
use super::reader;
use super::rs274::{self, Job};

/// Faults of each kind.
const EACH: usize = 14;

type Lines = Vec<String>;
/// Puts a fault into the line, or cannot.
type Fault = fn(&mut Lines, usize) -> Option<()>;

/// Every kind of fault, and how one is put into a line.
const FAULTS: &[(&str, Fault)] = &[
    ("another feed", |l, i| number(&mut l[i], 'F', |f| f + 0.01)),
    ("a feed tenfold", |l, i| number(&mut l[i], 'F', |f| f * 10.0)),
    ("no feed", |l, i| no_word(l, i, 'F')),
    ("another kind of feed", |l, i| swap_line(l, i, &["G94", "G95"])),
    ("inverse time as feed per minute", |l, i| swap_line(l, i, &["G93", "G94"])),
    ("no new kind of feed", |l, i| drop_line(l, i, &["G94", "G95"])),
    ("another speed", |l, i| number(&mut l[i], 'S', |s| s + 1.0)),
    ("no speed", |l, i| l[i].starts_with('S').then(|| drop(l.remove(i)))),
    // Under the G96 of a line before, S alone is a cutting speed as well.
    ("cutting speed as speed", |l, i| {
        let first = !l[..i].iter().any(|line| line.starts_with("G96"));
        let end = l[i].rfind(" S").filter(|_| first && l[i].starts_with("G96"))?;
        l[i] = l[i][end + 1..].to_owned();
        Some(())
    }),
    ("another limit of the speed", |l, i| l[i].starts_with("G96").then(|| number(&mut l[i], 'D', |d| d + 1.0))?),
    ("another sense of the spindle", |l, i| swap_line(l, i, &["M3", "M4"])),
    ("a spindle that does not stop", |l, i| swap_line(l, i, &["M5", "M3"])),
    ("no order for the spindle", |l, i| drop_line(l, i, &["M3", "M4", "M5"])),
    ("another orientation", |l, i| l[i].starts_with("M19").then(|| number(&mut l[i], 'R', |r| r + 1.0))?),
    ("other coolant", |l, i| swap_line(l, i, &["M7", "M8"])),
    ("coolant off instead of on", |l, i| swap_line(l, i, &["M8", "M9"])),
    ("no order for the coolant", |l, i| drop_line(l, i, &["M7", "M8", "M9"])),
    ("another dwell", |l, i| l[i].starts_with("G4 ").then(|| number(&mut l[i], 'P', |p| p + 0.1))?),
    ("no dwell", |l, i| l[i].starts_with("G4 ").then(|| drop(l.remove(i)))),
    ("another lead", |l, i| l[i].starts_with("G33 ").then(|| number(&mut l[i], 'K', |k| k + 0.01))?),
    ("a thread as a line", |l, i| {
        l[i] = l[i].strip_prefix("G33 ").map(|rest| format!("G1 {}", rest.split(" K").next().unwrap_or(rest)))?;
        Some(())
    }),
    ("another tool", |l, i| l[i].starts_with('T').then(|| number(&mut l[i], 'T', |t| t + 1.0))?),
    ("no tool", |l, i| l[i].starts_with('T').then(|| drop(l.remove(i)))),
    ("a tool that is only brought forth", |l, i| {
        l[i] = l[i].strip_suffix(" M6")?.to_owned();
        Some(())
    }),
    ("another tool length", |l, i| l[i].starts_with("G43 ").then(|| number(&mut l[i], 'H', |h| h + 1.0))?),
    ("another side", |l, i| {
        let (from, to) = if l[i].starts_with("G41") { ("G41", "G42") } else { ("G42", "G41") };
        l[i] = format!("{to}{}", l[i].strip_prefix(from)?);
        Some(())
    }),
    ("another cutter", |l, i| {
        (l[i].starts_with("G41") || l[i].starts_with("G42")).then(|| number(&mut l[i], 'D', |d| d + 1.0))?
    }),
    ("no compensation", |l, i| (l[i].starts_with("G41") || l[i].starts_with("G42")).then(|| drop(l.remove(i)))),
    ("compensation that goes on", |l, i| {
        let moves = l[i + 1..].iter().any(|line| is_move(line));
        moves.then(|| drop_line(l, i, &["G40"]))?
    }),
    ("another work offset", |l, i| {
        let next = ["G54", "G55", "G56", "G57", "G58", "G59"];
        swap_line(l, i, &next)
    }),
    ("another stop", |l, i| swap_line(l, i, &["M0", "M1"])),
    ("no stop", |l, i| drop_line(l, i, &["M0", "M1"])),
    ("another end", |l, i| swap_line(l, i, &["M2", "M30"])),
    ("rapid instead of feed", |l, i| first_word(&mut l[i], "G1", "G0")),
    ("feed instead of rapid", |l, i| first_word(&mut l[i], "G0", "G1")),
    ("another X", |l, i| is_move(&l[i]).then(|| number(&mut l[i], 'X', |x| x + 0.002))?),
    ("another Z", |l, i| is_move(&l[i]).then(|| number(&mut l[i], 'Z', |z| -z - 0.001))?),
    ("another angle", |l, i| is_move(&l[i]).then(|| number(&mut l[i], 'C', |c| c + 360.0))?),
    ("an axis that stays", |l, i| {
        let last = l[..i].iter().rev().flat_map(|line| line.split(' ')).find(|word| word.starts_with('Y'));
        let own = l[i].split(' ').find(|word| word.starts_with('Y'))?;
        (last? != own && l[i].split(' ').count() > 2).then(|| no_word(l, i, 'Y'))?
    }),
    ("a move less", |l, i| is_move(&l[i]).then(|| drop(l.remove(i)))),
    ("machine coordinates as those of the workpiece", |l, i| {
        l[i] = l[i].strip_prefix("G53 ")?.to_owned();
        Some(())
    }),
    ("the other way round", |l, i| {
        let (from, to) = if l[i].starts_with("G2 ") { ("G2", "G3") } else { ("G3", "G2") };
        first_word(&mut l[i], from, to)
    }),
    ("another centre", |l, i| is_arc(&l[i]).then(|| number(&mut l[i], 'I', |x| x + 0.005))?),
    ("more turns", |l, i| is_arc(&l[i]).then(|| number(&mut l[i], 'P', |p| p + 1.0))?),
    ("no turns", |l, i| is_arc(&l[i]).then(|| no_word(l, i, 'P'))?),
    ("another bound of corners", |l, i| {
        (l[i].contains("G64 P") && bounds_a_move(l, i)).then(|| number(&mut l[i], 'P', |p| p + 0.01))?
    }),
    ("an exact path", |l, i| {
        let at = l[i].find("G64 P").filter(|_| bounds_a_move(l, i))?;
        l[i].replace_range(at.., "G61");
        Some(())
    }),
    ("no word for corners", |l, i| {
        let says = l[i].starts_with("G61") || l[i].starts_with("G64");
        (says && l.get(i + 1).is_some_and(|next| is_move(next))).then(|| drop(l.remove(i)))
    }),
    ("another plane", |l, i| {
        // Tool lengths act along Z in every plane.
        let asks = |line: &str| line.starts_with("G4") && !line.starts_with("G43") && !line.starts_with("G49");
        let next = l[i + 1..].iter().find(|line| is_arc(line) || asks(line) || is_plane(line))?;
        (!is_plane(next) && !next.starts_with("G4 ")).then(|| swap_line(l, i, &["G17", "G18", "G19"]))?
    }),
    ("inches", |l, i| within(&mut l[i], "G21", "G20")),
    ("increments", |l, i| {
        let moves = l.iter().filter(|line| is_move(line)).count();
        (moves > 4).then(|| within(&mut l[i], "G90", "G91"))?
    }),
    ("two lines in the wrong order", |l, i| {
        let other = l.get(i + 1)?;
        (is_action(&l[i]) && is_action(other) && *other != l[i]).then(|| l.swap(i, i + 1))
    }),
    ("a function behind the move after it", |l, i| {
        let other = l.get(i + 1)?;
        (is_action(&l[i]) && !is_move(&l[i]) && is_move(other)).then(|| l.swap(i, i + 1))
    }),
    ("a line twice", |l, i| {
        (is_action(&l[i]) && !matches!(l[i].as_str(), "M2" | "M30")).then(|| l.insert(i, l[i].clone()))
    }),
];

fn is_arc(line: &str) -> bool {
    line.starts_with("G2 ") || line.starts_with("G3 ")
}

fn is_plane(line: &str) -> bool {
    matches!(line, "G17" | "G18" | "G19")
}

fn is_move(line: &str) -> bool {
    is_arc(line) || ["G0 ", "G1 ", "G33 ", "G53 "].iter().any(|word| line.starts_with(word))
}

/// A line whose place among the others matters by itself.
/// Does the mode of this line hold for a move?
fn bounds_a_move(lines: &Lines, at: usize) -> bool {
    let says = |line: &&String| is_move(line) || line.starts_with("G61") || line.starts_with("G64");
    lines[at + 1..].iter().find(says).is_some_and(|line| is_move(line))
}

fn is_action(line: &str) -> bool {
    is_move(line) || line.starts_with("G4 ") || line.starts_with(['T', 'S', 'M'])
}

/// Changes the number behind a letter.
fn number(line: &mut String, letter: char, change: fn(f64) -> f64) -> Option<()> {
    let mut words: Vec<String> = line.split(' ').map(str::to_owned).collect();
    let word = words.iter_mut().find(|word| word.starts_with(letter))?;
    let old: f64 = word[1..].parse().ok()?;
    let new = (change(old) * 1e4).round() / 1e4 + 0.0;
    *word = format!("{letter}{new}");
    *line = words.join(" ");
    Some(())
}

fn no_word(lines: &mut Lines, at: usize, letter: char) -> Option<()> {
    let words: Vec<&str> = lines[at].split(' ').filter(|word| !word.starts_with(letter)).collect();
    let text = words.join(" ");
    if text == lines[at] {
        return None;
    }
    lines[at] = text;
    Some(())
}

/// The next of the lines instead of this one.
fn swap_line(lines: &mut Lines, at: usize, all: &[&str]) -> Option<()> {
    let own = all.iter().position(|line| *line == lines[at])?;
    lines[at] = all[(own + 1) % all.len()].to_owned();
    Some(())
}

fn drop_line(lines: &mut Lines, at: usize, all: &[&str]) -> Option<()> {
    all.contains(&lines[at].as_str()).then(|| drop(lines.remove(at)))
}

fn first_word(line: &mut String, from: &str, to: &str) -> Option<()> {
    *line = format!("{to} {}", line.strip_prefix(from)?.strip_prefix(' ')?);
    Some(())
}

fn within(line: &mut String, from: &str, to: &str) -> Option<()> {
    let words: Vec<&str> = line.split(' ').map(|word| if word == from { to } else { word }).collect();
    let text = words.join(" ");
    if text == *line {
        return None;
    }
    *line = text;
    Some(())
}

/// An output with a fault.
struct Tampered<'a> {
    case: &'a Case,
    kind: &'static str,
    /// The line that was there, for the report.
    line: String,
    text: String,
}

/// Faults of every kind in real outputs; the same ones each time.
fn tampered() -> &'static [Tampered<'static>] {
    static LIST: OnceLock<Vec<Tampered<'static>>> = OnceLock::new();
    LIST.get_or_init(tamper)
}

fn tamper() -> Vec<Tampered<'static>> {
    let cases: Vec<&Case> = oracle::all().iter().filter(|case| case.is_exact() && !case.has_parallel_axes()).collect();
    let mut list = Vec::new();
    for (n, (kind, fault)) in FAULTS.iter().enumerate() {
        let mut dice = Dice(0x9e37_79b9_7f4a_7c15 ^ (n as u64 + 1));
        let first = dice.roll(cases.len());
        let turned = cases[first..].iter().chain(&cases[..first]);
        let own: Vec<_> = turned.filter_map(|case| with_fault(case, kind, *fault, &mut dice)).take(EACH).collect();
        assert!(!own.is_empty(), "no output can have: {kind}");
        list.extend(own);
    }
    list
}

/// The output of the case with the fault in one of the lines that can have it.
fn with_fault(case: &'static Case, kind: &'static str, fault: Fault, dice: &mut Dice) -> Option<Tampered<'static>> {
    let lines: Lines = case.output.lines().map(str::to_owned).collect();
    let with = |at: usize| {
        let mut copy = lines.clone();
        (!lines[at].starts_with('(') && fault(&mut copy, at).is_some() && copy != lines).then_some(copy)
    };
    let places: Vec<usize> = (0..lines.len()).filter(|at| with(*at).is_some()).collect();
    let at = *places.get(dice.roll(places.len()))?;
    Some(Tampered { case, kind, line: lines[at].clone(), text: with(at)?.join("\n") + "\n" })
}

fn assert_noticed(list: &[Tampered<'_>], answers: Vec<rs274::Answer>) {
    let noticed = |t: &Tampered<'_>, answer: rs274::Answer| answer.and_then(|found| t.case.judge(&found)).is_err();
    let missed: Vec<String> = list
        .iter()
        .zip(answers)
        .filter(|(_, answer)| answer.as_ref().is_ok())
        .filter_map(|(t, answer)| (!noticed(t, answer)).then(|| format!("{}: {} ({})", t.case.name, t.line, t.kind)))
        .collect();
    assert!(list.len() >= 500, "only {} faults", list.len());
    assert!(missed.is_empty(), "{} of {} faults are not noticed:\n{}", missed.len(), list.len(), missed.join("\n"));
}

#[test]
fn our_reader_notices_every_fault() {
    let list = tampered();
    let answers = list.iter().map(|t| reader::read(&t.text, t.case.decimals)).collect();
    assert_noticed(list, answers);
}

#[test]
fn the_rs274_oracle_notices_every_fault() {
    if !rs274::available() {
        return;
    }
    let list = tampered();
    let jobs: Vec<Job<'_>> = list.iter().map(|t| Job::new(&t.text)).collect();
    let answers = rs274::interpret_all(&jobs);
    assert_noticed(list, answers);
}

/// The validator reads along with the printer: it gets the text of an item with the item.
#[test]
fn the_validator_notices_every_fault() {
    let list = tampered();
    let missed: Vec<String> = list
        .iter()
        .filter(|t| t.case.validate(&t.text).is_none())
        .map(|t| format!("{}: {} ({})", t.case.name, t.line, t.kind))
        .collect();
    assert!(missed.is_empty(), "{} of {} faults are not noticed:\n{}", missed.len(), list.len(), missed.join("\n"));
}

#[test]
fn the_validator_accepts_every_golden_output() {
    for case in oracle::all() {
        assert_eq!(case.validate(&case.output).map(|found| found.to_string()), None, "{}", case.name);
    }
}
