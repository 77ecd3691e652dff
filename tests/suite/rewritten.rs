//! Receivers that read as Fanuc does, judged by readers of LinuxCNC's words: every golden program is printed for them,
//! looked at word by word, rewritten as written here, and interpreted. It has to move as the output for LinuxCNC does.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicUsize, Ordering};

use partc::internals::machine::MachineKind;
use partc::internals::machine::axis::AXES;
use partc::internals::machine::settings::{Decimals, Settings};
use partc::internals::target::{self, DwellUnit};

use super::book::{Case, cases};
use super::common::{Compiled, compile_bytes};
use super::meant::{BEFORE, Does, Found, How, Way};
use super::reader;
use super::rs274::{self, Job};

/// What the receivers differ in.
struct Judged {
    name: &'static str,
    lathe: bool,
    /// Comments in capitals.
    upper: bool,
    /// The name of the program; nothing where it has none.
    program: &'static str,
    /// The line around the program is there.
    framed: bool,
    /// Letters whose numbers have a point, always.
    points: &'static str,
    /// What a wait counts, and in which word.
    wait: (char, f64),
    /// Words that stand for others, whole words only.
    words: &'static [(&'static str, &'static str)],
    /// What states the largest speed, and a thread.
    limit: &'static str,
    thread: &'static str,
    /// Words of a plain program of this receiver: G and M without their letter.
    g: &'static [&'static str],
    most_sweep: f64,
    /// A line is one command; rapid traverse has an F, the start of the spindle its speed, and nothing ends the program.
    commands: bool,
}

const MILL_G: &[&str] = &[
    "0", "1", "2", "3", "4", "17", "18", "19", "20", "21", "40", "43", "49", "53", "54", "55", "56", "57", "58", "59",
    "61", "64", "80", "90", "92", "94", "95", "96", "97", "54.1", "154",
];

/// Words of Mach3 and UCCNC.
const MACH_G: &[&str] = &[
    "0", "1", "2", "3", "4", "17", "18", "19", "20", "21", "40", "43", "49", "54", "55", "56", "57", "58", "59", "61",
    "64", "80", "90", "91.1", "94",
];

const FANUC: Judged = Judged {
    name: "fanuc",
    lathe: false,
    upper: true,
    program: "O0001",
    framed: true,
    points: "XYZIJKFR",
    wait: ('P', 1000.0),
    words: &[],
    limit: "G92",
    thread: "-",
    g: MILL_G,
    most_sweep: 180.0,
    commands: false,
};

const KLIPPER: Judged = Judged {
    name: "klipper",
    upper: false,
    program: "",
    framed: false,
    points: "",
    limit: "-",
    g: &["0", "1", "2", "3", "4", "17", "18", "19", "21", "90"],
    commands: true,
    ..FANUC
};

const MACH3: Judged = Judged {
    name: "mach3",
    program: "",
    framed: false,
    points: "XYZIJKFRP",
    wait: ('P', 1.0),
    limit: "-",
    g: MACH_G,
    ..FANUC
};

const LATHE_B: Judged = Judged {
    name: "fanuc-lathe-b",
    lathe: true,
    thread: "G33",
    g: &[
        "0", "1", "2", "3", "4", "17", "18", "19", "20", "21", "33", "40", "54", "55", "56", "57", "58", "59", "61",
        "64", "90", "92", "94", "95", "96", "97",
    ],
    most_sweep: 120.0,
    ..FANUC
};

const JUDGED: [Judged; 12] = [
    KLIPPER,
    Judged { name: "marlin", ..KLIPPER },
    MACH3,
    // Arcs in XY alone.
    Judged { name: "uccnc", upper: false, points: "", wait: ('P', 1000.0), most_sweep: 90.0, ..MACH3 },
    Judged {
        name: "okuma",
        program: "OPART",
        points: "XYZIJKR",
        wait: ('F', 1.0),
        limit: "-",
        g: &["00", "01", "02", "03", "04", "15", "17", "18", "19", "20", "21", "40", "56", "80", "90", "94"],
        ..FANUC
    },
    Judged { name: "centroid", program: "O00001", points: "XYZIJKFRP", wait: ('P', 1.0), limit: "-", ..FANUC },
    Judged { name: "mazak", framed: false, limit: "-", ..FANUC },
    FANUC,
    Judged { name: "haas", upper: false, program: "O00001", limit: "-", ..FANUC },
    Judged {
        name: "fanuc-lathe",
        words: &[("G98", "G94"), ("G99", "G95")],
        limit: "G50",
        thread: "G32",
        // G90 and G94 are cycles there.
        g: &[
            "0", "1", "2", "3", "4", "17", "18", "19", "20", "21", "32", "40", "50", "54", "55", "56", "57", "58",
            "59", "61", "64", "96", "97", "98", "99",
        ],
        ..LATHE_B
    },
    LATHE_B,
    Judged {
        name: "fanuc-lathe-c",
        words: &[("G70", "G20"), ("G71", "G21")],
        g: &[
            "0", "1", "2", "3", "4", "17", "18", "19", "33", "40", "54", "55", "56", "57", "58", "59", "61", "64",
            "70", "71", "90", "92", "94", "95", "96", "97",
        ],
        ..LATHE_B
    },
];

/// Where rapid traverse has an F, that one.
const RAPID: u32 = 6000;

/// A program of single commands in words of LinuxCNC, as far as they differ.
fn commands(text: &str) -> Result<String, String> {
    let (mut out, mut turns) = (String::new(), false);
    for line in text.lines() {
        if let Some(comment) = line.strip_prefix("; ") {
            out += &format!("({})\n", comment.replace(['(', ')', '%'], "."));
            continue;
        }
        let mut words: Vec<&str> = line.split(' ').collect();
        if words.iter().filter(|word| word.starts_with(['G', 'M'])).count() != 1 || !line.starts_with(['G', 'M']) {
            return Err(format!("{line}: not one command"));
        }
        let (command, count) = (words[0], words.len());
        match command {
            "G0" if words.pop() != Some(&format!("F{RAPID}")) => return Err(format!("{line}: the F is missing")),
            "M3" | "M4" if count == 2 && std::mem::replace(&mut turns, true) => drop(words.remove(0)),
            "M5" => turns = false,
            _ => {}
        }
        out += &words.join(" ");
        out.push('\n');
    }
    Ok(out + "M30\n")
}

/// What is said in another order, or only where nothing else ends the program.
fn without_spindle(found: &[Found]) -> Vec<Found> {
    let said = |one: &Found| {
        matches!(one, Found::Does(Does::Turns(..) | Does::Speed(..) | Does::CoolantOff | Does::End { .. }))
    };
    found.iter().filter(|one| !said(one)).cloned().collect()
}

/// What a tapping cycle counts on.
#[derive(Default)]
struct Taps {
    speed: f64,
    per_turn: bool,
    /// M29 was said.
    ready: bool,
    /// A cycle is on, of this pitch.
    on: bool,
    lead: f64,
}

impl Taps {
    /// A line of a tap in words of LinuxCNC; `None` for other lines, and nothing for a tap that the receiver would not make.
    fn line(&mut self, line: &str, judged: &Judged) -> Option<Option<String>> {
        let words: Vec<&str> = line.split(' ').collect();
        let number = |letter: char| words.iter().find_map(|word| word.strip_prefix(letter)?.parse::<f64>().ok());
        let has = |wanted: &str| words.contains(&wanted);
        let by_pitch = judged.name == "mazak";
        let announced = !by_pitch && judged.name != "haas";
        self.speed = number('S').unwrap_or(self.speed);
        let lathe = judged.name == "fanuc-lathe";
        for (per_minute, per_turn) in [("G94", "G95"), ("G98", "G99")].into_iter().take(1 + usize::from(lathe)) {
            self.per_turn = has(per_turn) || self.per_turn && !has(per_minute);
        }
        if has("M29") {
            self.ready = true;
            return Some(announced.then(|| format!("S{}\n", self.speed)));
        }
        if has("G80") && words.len() == 1 && std::mem::take(&mut self.on) {
            return Some(Some(String::new()));
        }
        // While it is on, a depth alone taps the same hole again.
        if self.on
            && words.len() == 1
            && let Some(depth) = number('Z')
        {
            return Some(announced.then(|| format!("G33.1 Z{depth} K{}\n", self.lead)));
        }
        let (right, left) = if by_pitch { ("G84.2", "G84.3") } else { ("G84", "G74") };
        if !has(right) && !has(left) {
            return None;
        }
        let fits = std::mem::take(&mut self.ready) == announced && lathe == (number('R') == Some(0.0) && !has("G99"));
        self.on = true;
        let lead = match (number('F')?, self.per_turn) {
            (feed, true) if judged.name != "haas" => feed,
            (feed, false) if !by_pitch => feed / self.speed,
            _ => return Some(None),
        };
        let turn = if has(right) { "M3" } else { "M4" };
        let depth = number('Z')?;
        let lead = (lead * 1e4).round() / 1e4;
        self.lead = lead;
        Some((fits && !(lathe && has(left))).then(|| format!("{turn}\nG33.1 Z{depth} K{lead}\n")))
    }
}

/// The program in the words of LinuxCNC, or the first line that the receiver would not take.
fn rewritten(text: &str, judged: &Judged) -> Result<String, String> {
    let text = if judged.commands { &commands(text)? } else { text };
    let framed = if judged.framed { text.to_owned() } else { format!("%\n{text}%\n") };
    let text = framed.as_str();
    let mut lines = text.lines();
    let ends = ["M30", "M2", "M02"].iter().any(|end| text.ends_with(&format!("\n{end}\n%\n")));
    if lines.next() != Some("%") || !judged.program.is_empty() && lines.next() != Some(judged.program) || !ends {
        return Err("another frame".to_owned());
    }
    let mut out = "%\n".to_owned();
    let mut limit = None;
    let mut taps = Taps::default();
    for line in lines.filter(|line| *line != "%") {
        let says = |why: &str| format!("{line}: {why}");
        if line.len() > 80 || !line.is_ascii() {
            return Err(says("too long, or no ASCII"));
        }
        if line.starts_with('(') {
            let inner =
                line.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).ok_or_else(|| says("open comment"))?;
            let strange = |c: char| !(c.is_ascii_uppercase() || c.is_ascii_digit() || " .,=_-".contains(c));
            if inner.contains(['(', ')', '%']) || judged.upper && inner.contains(strange) {
                return Err(says("characters of a comment"));
            }
            continue;
        }
        if let Some(tapped) = taps.line(line, judged) {
            out += &tapped.ok_or_else(|| says("no tap"))?;
            continue;
        }
        let mut words: Vec<String> = Vec::new();
        for word in line.split(' ') {
            let (letter, number) = word.split_at(1);
            let coordinate = judged.points.contains(letter);
            let may = "XYZIJKF".contains(letter) && judged.points != "XYZIJKFR";
            if coordinate && !number.contains('.') || !coordinate && !may && letter != "G" && number.contains('.') {
                return Err(says("a point is missing, or too much"));
            }
            if number.parse::<f64>().is_err()
                || !judged.g.contains(&"91.1") && number.bytes().filter(u8::is_ascii_digit).count() > 8
            {
                return Err(says("too many digits"));
            }
            match letter {
                "G" if !judged.g.contains(&number) => return Err(says("a G function of somebody else")),
                "G" | "M" | "T" | "H" | "P" | "S" | "X" | "Y" | "Z" | "I" | "J" | "K" | "F" => {}
                _ => return Err(says("a letter of somebody else")),
            }
            let plain = if coordinate {
                format!("{letter}{}", number.parse::<f64>().unwrap_or(f64::NAN))
            } else if "GM".contains(letter) && number.len() > 1 {
                format!("{letter}{}", number.strip_prefix('0').unwrap_or(number))
            } else {
                word.to_owned()
            };
            let other = judged.words.iter().find(|(own, _)| *own == plain);
            words.push(other.map_or(plain, |(_, other)| (*other).to_owned()));
        }
        let has = |wanted: &str| words.iter().any(|word| word == wanted);
        let number = |letter: char| words.iter().find_map(|word| word.strip_prefix(letter)).map(str::to_owned);
        let (letter, parts) = judged.wait;
        if has("G4") {
            let wait: f64 = number(letter).and_then(|p| p.parse().ok()).ok_or_else(|| says("no wait"))?;
            words = vec!["G4".to_owned(), format!("P{}", wait / parts)];
        } else if let (true, Some(offset)) = (has("G15"), number('H')) {
            words = vec![format!("G{}", 53 + offset.parse::<u32>().unwrap_or(0))];
            if let Some(more @ 1..) = offset.parse::<u32>().ok().and_then(|n| n.checked_sub(6)) {
                words = vec![format!("G59.{more}")];
            }
        } else if let (true, Some(more)) = (has("G54.1") || has("G154"), number('P')) {
            words = vec![format!("G59.{more}")];
        } else if has(judged.limit) {
            limit = number('S');
            continue;
        } else if has("G96") {
            if let Some(limit) = &limit {
                words.push(format!("D{limit}"));
            }
        } else if has(judged.thread) {
            words = words
                .iter()
                .map(|word| match word.strip_prefix('F') {
                    Some(lead) => format!("K{lead}"),
                    None if word == judged.thread => "G33".to_owned(),
                    None => word.clone(),
                })
                .collect();
        } else if let (true, Some(tool)) = (judged.lathe, number('T')) {
            let (tool, offset) = tool.split_at_checked(2).ok_or_else(|| says("T wants four digits"))?;
            if tool != offset || offset.len() != 2 {
                return Err(says("another offset than the tool's"));
            }
            words = vec![format!("T{}", tool.trim_start_matches('0')), "M6".to_owned()];
        }
        out += &words.join(" ");
        out.push('\n');
        // Modes that the receiver has without a word.
        if out.matches('\n').count() == 2 {
            out += match (judged.lathe, judged.commands) {
                (true, _) => "G90 G91.1 G49 G80\nG18 G7\n",
                (_, true) => "G91.1 G49 G94 G40 G80\n",
                _ => "G91.1 G49\n",
            };
        }
    }
    Ok(out + "%\n")
}

/// How far a path turns from one place to another, in rad, whole turns begun as `turns` says.
fn turned(from: &[f64; AXES], to: &[f64; AXES], plane: [usize; 3], center: [f64; 2], turns: i32) -> f64 {
    let angle = |p: &[f64; AXES]| (p[plane[1]] - center[1]).atan2(p[plane[0]] - center[0]);
    let sense = f64::from(turns.signum());
    let mut part = sense * (angle(to) - angle(from));
    if part <= 1e-9 {
        part += TAU;
    }
    sense * (part + TAU * f64::from(turns.abs() - 1))
}

pub fn near(a: &[f64; AXES], b: &[f64; AXES], room: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= room)
}

/// Does the second program what the first one does? Arcs may come in parts, none of which turns more than the receiver takes.
pub fn same(wanted: &[Found], found: &[Found], most_sweep: f64) -> Result<(), String> {
    let (mut rest, mut at, room) = (found.iter(), BEFORE, 0.0021);
    // Receivers say more or less of their corners.
    let path = |how: &How| How { plane: None, corners: None, ..*how };
    let alike = |a: &How, b: &How| path(a) == path(b);
    for (i, one) in wanted.iter().enumerate() {
        let other = rest.next().ok_or("the other ends earlier")?;
        let fail = |other: &Found| Err(format!("{i}: {one:?} is {other:?}"));
        match (one, other) {
            (Found::Does(a), Found::Does(b))
                if a == b || matches!((a, b), (Does::Dwell(a), Does::Dwell(b)) if (a - b).abs() < 1e-6) => {}
            (Found::Move(Way::Rapid(a), how), Found::Move(Way::Rapid(b), other))
                if near(a, b, 1e-6) && alike(how, other) =>
            {
                at = *a
            }
            (Found::Move(Way::Feed(a), how), Found::Move(Way::Feed(b), other))
                if near(a, b, 1e-6) && alike(how, other) =>
            {
                at = *a
            }
            (Found::Move(Way::Arc { plane, center, turns, end }, how), Found::Move(Way::Arc { .. }, _)) => {
                let whole = turned(&at, end, *plane, *center, *turns);
                let mut done = 0.0;
                let mut part = other;
                loop {
                    let Found::Move(Way::Arc { plane: p, center: c, turns: t, end: to }, h) = part else {
                        return fail(part);
                    };
                    let sweep = turned(&at, to, *p, *c, *t);
                    // Between the same ends the centre of a short arc moves its path by far less than itself.
                    let off = (c[0] - center[0]).abs().max((c[1] - center[1]).abs()) * whole.abs().min(1.0).powi(2);
                    if p != plane || off > 2.0 * room || !alike(how, h) || sweep.abs().to_degrees() > most_sweep + 2.0 {
                        return fail(part);
                    }
                    done += sweep;
                    at = *to;
                    let radius = (end[plane[0]] - center[0]).hypot(end[plane[1]] - center[1]);
                    if (done - whole).abs() * radius < 4.0 * room && near(&at, end, 1e-6) {
                        break;
                    }
                    if done.abs() > whole.abs() + 0.1 {
                        return fail(part);
                    }
                    part = rest.next().ok_or("the other ends within an arc")?;
                    // A helix by its angle ends a little beside its place, where a line leads.
                    if let Found::Move(Way::Feed(to), h) = part
                        && near(to, end, 1e-6)
                        && near(to, &at, room)
                        && (done - whole).abs() * radius < 4.0 * room
                        && alike(how, h)
                    {
                        at = *to;
                        break;
                    }
                }
            }
            _ => return fail(other),
        }
    }
    rest.next().map_or(Ok(()), |more| Err(format!("the other goes on: {more:?}")))
}

fn alike(plain: &[Found], other: &[Found], judged: &Judged) -> Result<(), String> {
    if judged.commands {
        return same(&without_spindle(plain), &without_spindle(other), judged.most_sweep);
    }
    same(plain, other, judged.most_sweep)
}

/// Golden programs that are meant to compile.
pub fn programs() -> Vec<&'static Case> {
    cases("").into_iter().filter(|case| !case.name.starts_with("errors/")).collect()
}

/// Compiles; what was read back and differs is a finding here, so that all are seen at once.
pub fn compiled(file: &str, program: Vec<u8>, dialect: &str, settings: &Settings, case: &Case) -> Compiled {
    let run = || compile_bytes(file, program.clone(), dialect, settings, case);
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).unwrap_or_else(|_| {
        let mut unread = settings.clone();
        unread.output.validate = false;
        let mut compiled = compile_bytes(file, program.clone(), dialect, &unread, case);
        compiled.output.push_str("differs from what was meant\n");
        compiled
    })
}

/// A program for a target, its numbers of the same places for each.
fn print(case: &Case, target: &str, lathe: bool) -> Compiled {
    let mut settings = case.settings();
    settings.output.decimals =
        Decimals { length: Some(3), angle: Some(3), feed: Some(3), speed: Some(0), time: Some(3) };
    settings.output.tool_length = Some(false);
    settings.output.compensation = Default::default();
    settings.output.diameter = lathe.then_some(true);
    settings.output.target = target::find(target).expect("a target");
    settings.output.dwell_unit = Some(DwellUnit::Seconds);
    settings.output.rapid_feed = Some(RAPID);
    if settings.output.target.m.listed {
        // The others that are passed through are left out of the plain program, with a note.
        settings.output.pass_m.extend([0, 1, 3, 4, 5, 7, 8, 9]);
    }
    compiled("PART", case.program.clone(), &case.dialect, &settings, case)
}

/// The output for a receiver; `None` where it is no match for the plain one, the codes where it is refused.
fn other(case: &Case, plain: &Compiled, judged: &Judged) -> Option<Result<String, Vec<&'static str>>> {
    let codes = |compiled: &Compiled| compiled.findings.iter().map(|found| found.code.id).collect::<Vec<_>>();
    // A lead has places of its own.
    if plain.has_errors() || plain.output.contains("K0.33") {
        return None;
    }
    let other = print(case, judged.name, judged.lathe);
    if other.has_errors() {
        return Some(Err(codes(&other)));
    }
    // An arc may have become lines.
    let lines = |compiled: &Compiled| codes(compiled).contains(&"O4001");
    (lines(&other) == lines(plain)).then_some(Ok(other.output))
}

/// Receivers that differ little from another one are judged by some of the programs.
const SOME: usize = 4;

#[test]
fn golden_programs_move_alike_after_rewriting() {
    let list = programs();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut mine: Vec<(usize, String, [String; 2])> = Vec::new();
        let mut refused: BTreeMap<&str, usize> = BTreeMap::new();
        let mut wrong = Vec::new();
        loop {
            let n = next.fetch_add(1, Ordering::Relaxed);
            let Some(case) = list.get(n) else { break };
            let lathe = case.settings().machine.kind == MachineKind::Lathe;
            let plain = print(case, "linuxcnc", lathe);
            let all = |judged: &Judged| matches!(judged.name, "fanuc" | "fanuc-lathe") || n.is_multiple_of(SOME);
            for (i, judged) in JUDGED.iter().enumerate().filter(|(_, judged)| judged.lathe == lathe && all(judged)) {
                match other(case, &plain, judged) {
                    None => {}
                    Some(Err(codes)) => {
                        if !codes.iter().any(|code| code.starts_with("O93")) {
                            wrong.push(format!("{} {}: fails with {codes:?}", judged.name, case.name));
                        }
                        *refused.entry(judged.name).or_default() += 1;
                    }
                    Some(Ok(other)) => match rewritten(&other, judged) {
                        Ok(other) => mine.push((i, case.name.clone(), [plain.output.clone(), other])),
                        Err(why) => wrong.push(format!("{} {}: {why}", judged.name, case.name)),
                    },
                }
            }
        }
        (mine, refused, wrong)
    };
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    let parts = std::thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        running.into_iter().map(|thread| thread.join().expect("no case panics")).collect::<Vec<_>>()
    });
    let (mut pairs, mut wrong, mut refused) = (Vec::new(), Vec::new(), BTreeMap::<&str, usize>::new());
    for (mine, own, bad) in parts {
        pairs.extend(mine);
        wrong.extend(bad);
        own.into_iter().for_each(|(name, count)| *refused.entry(name).or_default() += count);
    }
    let mut printed: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, name, [plain, other]) in &pairs {
        let judged = &JUDGED[*i];
        *printed.entry(judged.name).or_default() += 1;
        let result = reader::read(plain, 3).and_then(|plain| alike(&plain, &reader::read(other, 3)?, judged));
        if let Err(why) = result {
            wrong.push(format!("{} {name}: {why}", judged.name));
        }
    }
    if rs274::available() {
        let jobs: Vec<Job<'_>> =
            pairs.iter().flat_map(|(_, _, texts)| texts.iter().map(|text| Job::new(text))).collect();
        for ((i, name, _), answers) in pairs.iter().zip(rs274::interpret_all(&jobs).chunks(2)) {
            let judged = &JUDGED[*i];
            let result = match answers {
                [Ok(plain), Ok(other)] => alike(plain, other, judged),
                // What LinuxCNC itself does not take is no judge.
                [Err(_), _] => Ok(()),
                // Mach3 takes 0.002 mm, where this interpreter was told less.
                [_, Err(why)] if why.contains("the radii differ by 0.001") && judged.g == MACH_G => Ok(()),
                [_, Err(why)] => Err(why.clone()),
                _ => Ok(()),
            };
            if let Err(why) = result {
                wrong.push(format!("{} {name}: rs274: {why}", judged.name));
            }
        }
    }
    println!("printed {printed:?}, refused {refused:?}");
    wrong.iter().for_each(|why| println!("{why}"));
    assert!(wrong.is_empty(), "{} wrong: {:#?}", wrong.len(), &wrong[..wrong.len().min(12)]);
    for judged in &JUDGED {
        let least = if judged.lathe || judged.commands { 20 } else { 100 };
        assert!(printed.get(judged.name).is_some_and(|count| *count > least), "{}: {printed:?}", judged.name);
    }
}
