//! LinuxCNC's stand-alone interpreter as an independent reader of our output.
//!
//! Starting it costs far more than one of our programs, so it gets many programs at a start, each between two marks.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Mutex;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use partc::internals::machine::axis::AXES;

use super::meant::{BEFORE, Cutter, Does, Found, How, Kind, Way, is_of_spindle};
use super::tools;

/// X Y Z A B C; the stand-alone interpreter has no U V W.
const OWN_AXES: usize = 6;
/// Programs at a start.
const BATCH: usize = 48;
/// What the interpreter does by itself between two programs, so that each finds it as after a start.
const RESET: &str = "G40 G49 G80\nG21 G90 G91.1 G94 G97 G8 G17 G54 S0\nT0 M6\nM5\nM9\n";
/// How marks in comments begin. None of our comments does: they hold no small letters behind `(partc`.
const MARK: &str = "partc-mark ";

/// Is the interpreter installed? `PARTC_REQUIRE_ORACLE` makes its absence an error.
pub fn available() -> bool {
    static FOUND: OnceLock<bool> = OnceLock::new();
    let found = *FOUND.get_or_init(tools::rs274);
    let optional = !tools::required("PARTC_REQUIRE_ORACLE");
    assert!(found || optional, "rs274 is not installed (Debian package linuxcnc-uspace)");
    found
}

/// A program and the diameter that its tools get.
#[derive(Debug, Clone, Copy)]
pub struct Job<'a> {
    pub program: &'a str,
    pub diameter: &'static str,
}

impl<'a> Job<'a> {
    /// With tools of radius 0: the path is the printed one.
    pub fn new(program: &'a str) -> Job<'a> {
        Job { program, diameter: "0" }
    }

    /// With tools that have a radius more is forbidden between G41 and G40, and outside corners get arcs, which
    /// nobody meant; so only its consent counts.
    pub fn thick(program: &'a str) -> Job<'a> {
        Job { program, diameter: "0.000002" }
    }
}

/// What one program does, or what the interpreter complains about.
pub type Answer = Result<Vec<Found>, String>;

/// Interprets many programs on all processors; the answers come in the order of the programs.
pub fn interpret_all(jobs: &[Job<'_>]) -> Vec<Answer> {
    let answers = Mutex::new(vec![Err(String::new()); jobs.len()]);
    let next = AtomicUsize::new(0);
    // Programs with tools of one diameter go together.
    let mut order: Vec<usize> = (0..jobs.len()).collect();
    order.sort_by_key(|i| jobs[*i].diameter);
    let batches: Vec<&[usize]> = order.chunks(BATCH).collect();
    let work = || {
        while let Some(batch) = batches.get(next.fetch_add(1, Ordering::Relaxed)) {
            let own: Vec<Job<'_>> = batch.iter().map(|i| jobs[*i]).collect();
            let found = run(&own);
            let mut answers = answers.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            batch.iter().zip(found).for_each(|(i, answer)| answers[*i] = answer);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    answers.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// Interprets a batch. The interpreter stops at the first program it does not take; those behind get another start.
fn run(jobs: &[Job<'_>]) -> Vec<Answer> {
    let mut answers = Vec::new();
    while answers.len() < jobs.len() {
        let rest = &jobs[answers.len()..];
        let alike = rest.iter().take_while(|job| job.diameter == rest[0].diameter).count();
        let (canonical, complaint) = start(&rest[..alike]);
        let mut pieces = pieces(&canonical);
        match complaint {
            None if pieces.len() == alike => answers.extend(pieces.iter().map(|piece| read(piece))),
            None => answers.push(Err(format!("{} of {alike} programs were interpreted", pieces.len()))),
            Some(why) => {
                // The last one that began is the one at fault; after it the others go on.
                pieces.pop();
                answers.extend(pieces.iter().map(|piece| read(piece)));
                answers.push(Err(why));
            }
        }
    }
    answers
}

/// Starts the interpreter on all programs: its canonical calls, and its complaint.
fn start(jobs: &[Job<'_>]) -> (String, Option<String>) {
    let dir = scratch();
    let write = |file: &str, text: &str| fs::write(dir.join(file), text).expect("a writable folder");
    let diameter = jobs.first().map_or("0", |job| job.diameter);
    let [x, y, z, a, b, c, ..] = BEFORE;
    let mut text = "%\n".to_owned();
    for job in jobs {
        text += RESET;
        text += &format!("G53 G0 X{x} Y{y} Z{z} A{a} B{b} C{c}\n");
        text += &marked(job.program, diameter == "0");
    }
    text += "M2\n%\n";
    let mut table = String::new();
    for (pocket, number) in tools_of(&text).into_iter().enumerate() {
        table += &format!("T{number} P{} D{diameter} Z0 ;\n", pocket + 1);
    }
    write("t.tbl", &table);
    write(
        "o.ini",
        "[EMC]\nMACHINE=o\n[RS274NGC]\nCENTER_ARC_RADIUS_TOLERANCE_MM = 0.001\nCENTER_ARC_RADIUS_TOLERANCE_INCH = 0.00004\n\
         [TRAJ]\nSPINDLES=8\nLINEAR_UNITS=mm\nANGULAR_UNITS=degree\nCOORDINATES=X Y Z A B C U V W\n[EMCIO]\nTOOL_TABLE=t.tbl\n",
    );
    write("v.var", "");
    write("p.ngc", &text);
    // Names without a folder: the interpreter has room for short ones only.
    let out = Command::new("rs274")
        .args(["-g", "-n", "2", "-i", "o.ini", "-t", "t.tbl", "-v", "v.var", "p.ngc"])
        .env("HOME", &dir)
        .current_dir(&dir)
        .output()
        .expect("rs274 starts");
    let errors = String::from_utf8_lossy(&out.stderr);
    let errors: Vec<&str> =
        errors.lines().filter(|line| !line.trim().is_empty() && line.trim() != "executing").collect();
    let _ = fs::remove_dir_all(&dir);
    let complaint = match (out.status.success(), errors.is_empty()) {
        (true, true) => None,
        (_, true) => Some(format!("rs274 ends with {}", out.status)),
        _ => Some(errors.join("\n")),
    };
    (String::from_utf8_lossy(&out.stdout).into_owned(), complaint)
}

/// The program up to its end, with marks for what the canonical calls do not show.
fn marked(program: &str, thin: bool) -> String {
    let mut text = format!("({MARK}begin)\n");
    for line in program.lines() {
        if line == "%" {
            continue;
        }
        let mut mark = |what: String| text += &format!("({MARK}{what})\n");
        let word = |letter: char| line.split(' ').find_map(|word| word.strip_prefix(letter));
        if line.starts_with('(') {
            text += line;
            text.push('\n');
            continue;
        }
        let has = |wanted: &str| line.split(' ').any(|word| word == wanted);
        if has("M2") || has("M30") {
            mark(format!("end {}", if has("M30") { 30 } else { 2 }));
            return text;
        }
        if has("G43") || has("G49") {
            mark(format!("length {}", if has("G49") { "0" } else { word('H').unwrap_or("0") }));
        }
        if has("G41") || has("G42") {
            mark(format!("cutter {}", word('D').unwrap_or("0")));
        }
        if let Some(code) = ["G41.1", "G42.1"].into_iter().find(|code| has(code)) {
            mark(format!("diameter {}", word('D').unwrap_or("0")));
            // The path is to be the printed one, as with tools of the table.
            if thin {
                text += &format!("{code} D0\n");
                continue;
            }
        }
        if let Some(feed) = word('F') {
            mark(format!("feed {feed}"));
        }
        if has("G53") {
            mark("machine".to_owned());
        }
        match word('M').and_then(|m| m.parse::<u32>().ok()) {
            // Machine functions that only the machine knows.
            Some(m) if m > 30 || matches!(m, 10..=18 | 20..=29) => mark(format!("aux {m}")),
            _ => {
                text += line;
                text.push('\n');
            }
        }
    }
    text
}

/// The canonical calls of each program that began, its complaint left out.
fn pieces(canonical: &str) -> Vec<String> {
    let begin = format!("COMMENT(\"{MARK}begin\")");
    canonical.split(begin.as_str()).skip(1).map(str::to_owned).collect()
}

/// A folder of its own for each run: tests run side by side.
fn scratch() -> PathBuf {
    static RUNS: AtomicUsize = AtomicUsize::new(0);
    let run = RUNS.fetch_add(1, Ordering::Relaxed);
    let own = format!("rs274-{}-{run}", std::process::id());
    let dir = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(own);
    fs::create_dir_all(&dir).expect("a writable target folder");
    dir
}

fn tools_of(program: &str) -> Vec<u32> {
    let mut found: Vec<u32> = program
        .lines()
        .filter(|line| !line.starts_with('('))
        .flat_map(|line| line.split(' '))
        .filter_map(|word| word.strip_prefix(['T', 'D', 'H'])?.parse().ok())
        .filter(|number| (1..100_000).contains(number))
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}

/// What holds while the canonical calls of one program are read.
struct Canon {
    plane: [usize; 3],
    at: [f64; AXES],
    feed: f64,
    per_revolution: bool,
    inverse_time: bool,
    /// What stands behind F: of inverse times the calls show what they come to.
    printed_feed: f64,
    lead: Option<f64>,
    /// Speed and sense of the first spindle.
    spindle: (f64, i8),
    /// What G41 and G42 will name, and what holds.
    named: Cutter,
    cutter: Cutter,
    length: u32,
    offset: u8,
    constant_cut: bool,
    changing: bool,
    /// The next move is one in machine coordinates.
    machine: bool,
    /// M7 and M8 go off in two calls.
    mist_off: bool,
    /// How far corners may be rounded off.
    corners: Option<f64>,
    list: Vec<Found>,
}

/// What the canonical calls of one program mean.
fn read(canonical: &str) -> Answer {
    let mut canon = Canon {
        plane: [0, 1, 2],
        at: BEFORE,
        feed: 0.0,
        per_revolution: false,
        inverse_time: false,
        printed_feed: 0.0,
        lead: None,
        spindle: (0.0, 0),
        named: Cutter::default(),
        cutter: Cutter::default(),
        length: 0,
        offset: 1,
        constant_cut: false,
        changing: false,
        machine: false,
        mist_off: false,
        corners: None,
        list: Vec::new(),
    };
    for line in canonical.lines() {
        let Some(open) = line.find('(') else { continue };
        let name = line[..open].rsplit(' ').next().unwrap_or_default();
        let arguments = line[open + 1..].trim_end().trim_end_matches(')');
        if canon.call(name, arguments).map_err(|why| format!("{line}: {why}"))? {
            return Ok(canon.list);
        }
    }
    Err("the program has no end".to_owned())
}

impl Canon {
    /// One canonical call; true at the end of the program.
    fn call(&mut self, name: &str, arguments: &str) -> Result<bool, String> {
        let numbers: Vec<f64> = arguments.split([',', ' ']).filter_map(|part| part.trim().parse().ok()).collect();
        let number = |i: usize| numbers.get(i).copied().ok_or_else(|| format!("{} numbers", numbers.len()));
        if std::mem::take(&mut self.mist_off) && name != "FLOOD_OFF" {
            return Err("M9 is two calls".to_owned());
        }
        match name {
            "COMMENT" => return self.comment(arguments.trim_matches('"')),
            "SELECT_PLANE" => {
                self.plane = match arguments.rsplit('_').next() {
                    Some("XZ") => [2, 0, 1],
                    Some("YZ") => [1, 2, 0],
                    _ => [0, 1, 2],
                }
            }
            "SET_FEED_MODE" => self.per_revolution = number(1)? != 0.0,
            "SET_FEED_RATE" => self.feed = number(0)?,
            "START_SPEED_FEED_SYNC" => self.lead = Some(number(0)?),
            "STOP_SPEED_FEED_SYNCH" => self.lead = None,
            "STRAIGHT_TRAVERSE" => self.straight(Way::Rapid(end_of(&numbers)?), None),
            "STRAIGHT_FEED" => {
                let feed = self.feed_in_force();
                self.straight(Way::Feed(end_of(&numbers)?), Some(feed));
            }
            "RIGID_TAP" => self.tap(&numbers)?,
            "ARC_FEED" => self.arc(&numbers)?,
            "SELECT_TOOL" => self.does(Does::Select(number(0)? as u32)),
            "START_CHANGE" => self.changing = true,
            "CHANGE_TOOL" => {
                self.changing = false;
                self.does(Does::Change);
            }
            "SET_SPINDLE_MODE" => {
                let (limit, on) = (number(1)?, number(1)? != 0.0);
                if on || self.constant_cut {
                    let limit = if limit > 1e20 { f64::INFINITY } else { limit };
                    self.does(Does::CuttingSpeed(on, limit));
                }
                self.constant_cut = on;
            }
            "SET_SPINDLE_SPEED" => {
                if number(0)? == 0.0 {
                    self.spindle.0 = number(1)?;
                }
                self.does(Does::Speed(number(0)? as u8, number(1)?));
            }
            "START_SPINDLE_CLOCKWISE" | "START_SPINDLE_COUNTERCLOCKWISE" => {
                let turn = if name.ends_with("_CLOCKWISE") { 1 } else { -1 };
                if number(0)? == 0.0 {
                    self.spindle.1 = turn;
                }
                self.does(Does::Turns(number(0)? as u8, turn));
            }
            // A change of tool stops all spindles.
            "STOP_SPINDLE_TURNING" if self.changing => {}
            "STOP_SPINDLE_TURNING" => self.does(Does::Turns(number(0)? as u8, 0)),
            "ORIENT_SPINDLE" => self.does(Does::Orient(number(0)? as u8, number(1)?)),
            "MIST_ON" => self.does(Does::Mist),
            "FLOOD_ON" => self.does(Does::Flood),
            "MIST_OFF" => self.mist_off = true,
            "FLOOD_OFF" => self.does(Does::CoolantOff),
            "DWELL" => self.does(Does::Dwell(number(0)?)),
            "PROGRAM_STOP" => self.does(Does::Stop),
            "OPTIONAL_PROGRAM_STOP" => self.does(Does::OptionalStop),
            "SET_G5X_OFFSET" => {
                let offset = number(0)? as u8;
                if std::mem::replace(&mut self.offset, offset) != offset {
                    self.does(Does::WorkOffset(offset));
                }
                if numbers[1..].iter().any(|n| *n != 0.0) {
                    return Err("a work offset that is not zero".to_owned());
                }
            }
            "SET_MOTION_CONTROL_MODE" => {
                self.corners = Some(match number(0) {
                    // No bound.
                    Ok(0.0) => f64::INFINITY,
                    Ok(bound) => bound,
                    Err(_) => 0.0,
                });
            }
            "USE_LENGTH_UNITS" if !arguments.ends_with("MM") => return Err("not in millimetres".to_owned()),
            "USE_LENGTH_UNITS"
            | "SET_G92_OFFSET"
            | "SET_XY_ROTATION"
            | "USE_TOOL_LENGTH_OFFSET"
            | "SET_FEED_REFERENCE"
            | "MESSAGE"
            | "SET_NAIVECAM_TOLERANCE"
            | "WAIT_SPINDLE_ORIENT_COMPLETE" => {}
            _ => return Err("a call that our programs do not make".to_owned()),
        }
        Ok(false)
    }

    fn comment(&mut self, text: &str) -> Result<bool, String> {
        match text {
            "interpreter: cutter radius compensation on left" => self.cutter = Cutter { side: 1, ..self.named },
            "interpreter: cutter radius compensation on right" => self.cutter = Cutter { side: -1, ..self.named },
            "interpreter: cutter radius compensation off" => self.cutter = Cutter::default(),
            "interpreter: feed mode set to inverse time" => self.inverse_time = true,
            _ if text.starts_with("interpreter: feed mode") => self.inverse_time = false,
            _ => {}
        }
        let Some(mark) = text.strip_prefix(MARK) else { return Ok(false) };
        let (what, value) = mark.split_once(' ').unwrap_or((mark, "0"));
        let value: f64 = value.parse().map_err(|e| format!("{value}: {e}"))?;
        match what {
            "machine" => self.machine = true,
            "feed" => self.printed_feed = value,
            "cutter" => self.named = Cutter { side: 0, number: value as u32, diameter: None },
            "diameter" => self.named = Cutter { side: 0, number: 0, diameter: Some(value) },
            "length" => {
                if std::mem::replace(&mut self.length, value as u32) != value as u32 {
                    self.does(Does::Length(value as u32));
                }
            }
            "aux" => self.does(Does::Aux(value as u32)),
            "end" => self.does(Does::End { rewind: value as u32 == 30 }),
            _ => return Err("an unknown mark".to_owned()),
        }
        Ok(what == "end")
    }

    fn feed_in_force(&self) -> (Kind, f64) {
        match (self.inverse_time, self.per_revolution) {
            (true, _) => (Kind::Inverse, self.printed_feed),
            (false, true) => (Kind::PerRevolution, self.feed),
            (false, false) => (Kind::PerMinute, self.feed),
        }
    }

    fn does(&mut self, does: Does) {
        self.list.push(Found::Does(does));
    }

    fn straight(&mut self, way: Way, feed: Option<(Kind, f64)>) {
        let how = How {
            feed: feed.filter(|_| self.lead.is_none()),
            lead: self.lead,
            cutter: self.cutter,
            corners: self.corners,
            machine: std::mem::take(&mut self.machine),
            plane: Some(self.plane),
        };
        self.at = way.end();
        self.list.push(Found::Move(way, how));
    }

    /// Down and back to where the axis stands; the spindle turns on as before.
    fn tap(&mut self, numbers: &[f64]) -> Result<(), String> {
        let (Some(lead), &[x, y, z]) = (self.lead, numbers) else { return Err("a tap without a lead".to_owned()) };
        let mut moved = [x, y, z].into_iter().enumerate().filter(|(axis, to)| (self.at[*axis] - to).abs() > 1e-9);
        let (Some((axis, to)), None) = (moved.next(), moved.next()) else {
            return Err("a tap along no axis, or along two".to_owned());
        };
        while self.list.last().is_some_and(|item| matches!(item, Found::Does(does) if is_of_spindle(does))) {
            self.list.pop();
        }
        let (speed, turn) = self.spindle;
        self.does(Does::Tap { axis, to, lead, turn, speed });
        Ok(())
    }

    fn arc(&mut self, numbers: &[f64]) -> Result<(), String> {
        let &[x, y, i, j, turns, third, a, b, c] = numbers else { return Err("nine numbers are expected".to_owned()) };
        let plane = self.plane;
        let mut end = self.at;
        (end[plane[0]], end[plane[1]], end[plane[2]]) = (x, y, third);
        end[3..OWN_AXES].copy_from_slice(&[a, b, c]);
        let radius = |p: [f64; AXES]| (p[plane[0]] - i).hypot(p[plane[1]] - j);
        let off = (radius(self.at) - radius(end)).abs();
        if off > 0.001 + 1.5e-4 {
            return Err(format!("the radii differ by {off:.5}"));
        }
        let feed = Some(self.feed_in_force());
        self.straight(Way::Arc { plane, center: [i, j], turns: turns as i32, end }, feed);
        Ok(())
    }
}

/// The end of a straight move.
fn end_of(numbers: &[f64]) -> Result<[f64; AXES], String> {
    let mut end = BEFORE;
    let own = numbers.get(..OWN_AXES).ok_or_else(|| format!("six numbers in {numbers:?}"))?;
    end[..OWN_AXES].copy_from_slice(own);
    Ok(end)
}
