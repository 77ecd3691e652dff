//! Every golden output means to two readers what the compiler meant: to LinuxCNC's interpreter, and to a small reader
//! of our own, which is always there.

use partc::internals::compare::{Difference, Steps, steps_of_text};
use partc::internals::diag::Diags;
use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::emit::Printer;
use partc::internals::ir::motion;
use partc::internals::ir::{Function, Origin, Pos, Tap};
use partc::internals::machine::Settings;
use partc::internals::machine::settings::{Quantity, ToolChange};
use partc::internals::text::{Files, Memory, Opened};
use partc::internals::validate::{Mismatch, Validator};

use super::book;
use super::common::Compiled;
use super::meant::{self, Found, Meant, Recorder, compare, without_moves};
use super::reader;
use super::rs274::{self, Job};

/// A golden case that compiles, with what it means.
pub struct Case {
    pub name: String,
    pub output: String,
    pub meant: Vec<Meant>,
    pub decimals: u8,
    /// An arc was replaced, so that the moves are others.
    replaced: bool,
    /// What the printer got, and how many lines it made of each.
    items: Vec<(Item, usize)>,
    settings: Settings,
}

/// What a printer gets.
pub enum Item {
    Move(Box<motion::Move>),
    Function(Function),
    BeginsAt(Pos),
    Tap(Tap, motion::Place),
    Lost,
}

/// Prints once more, and keeps each item with the number of its lines.
struct Items<'a> {
    printer: Printer<'a>,
    list: Vec<(Item, usize)>,
}

impl Items<'_> {
    fn keep(&mut self, item: Item) {
        let (bytes, end) = self.printer.held();
        let lines = bytes[..end].iter().filter(|b| **b == b'\n').count();
        self.printer.release();
        self.list.push((item, lines));
    }
}

impl motion::Sink for Items<'_> {
    fn movement(&mut self, mv: &motion::Move, origin: &Origin) {
        self.printer.movement(mv, origin);
        self.keep(Item::Move(Box::new(*mv)));
    }

    fn tap(&mut self, tap: &Tap, place: &motion::Place, origin: &Origin) {
        self.printer.tap(tap, place, origin);
        self.keep(Item::Tap(tap.clone(), *place));
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        self.printer.function(function, origin);
        self.keep(Item::Function(function.clone()));
    }

    fn lost(&mut self, origin: &Origin) {
        self.printer.lost(origin);
        self.keep(Item::Lost);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.printer.begins_at(at);
        self.keep(Item::BeginsAt(*at));
    }
}

impl Case {
    /// Nothing where the program has errors.
    fn of(case: &book::Case) -> Option<Case> {
        let compiled = case.compile();
        if compiled.has_errors() {
            return None;
        }
        let bytes = case.program.clone();
        Some(Case::new(case.name.clone(), compiled, bytes, &case.dialect, &case.settings(), case))
    }

    /// What came of a program, and what it means.
    pub fn new(
        name: String,
        compiled: Compiled,
        bytes: Vec<u8>,
        dialect: &str,
        settings: &Settings,
        files: &dyn Files,
    ) -> Case {
        let replaced = compiled.codes().iter().any(|code| matches!(*code, "O4001" | "O4002"));
        let session = || {
            let text = Box::new(Memory::new(bytes.clone()));
            Session::new(Opened { name: name.clone(), identity: name.clone(), text })
        };
        let found = dialect::find(dialect).expect("a dialect");
        let mut recorder = Recorder::new(&found.settings(settings));
        session().lower(found, settings, files, &mut recorder);
        let decimals = settings.output.places(Quantity::Length);
        let settings = found.settings(settings).into_owned();
        let items = items(&session(), found, &settings, files);
        Case { name, output: compiled.output, meant: recorder.finish(), decimals, replaced, items, settings }
    }

    /// What the validator says to `text` instead of the output. Lines that are as they were belong to the item that they
    /// were printed for; those between belong to the first item whose lines are others.
    pub fn validate(&self, text: &str) -> Option<Box<Mismatch>> {
        let (old, new): (Vec<&str>, Vec<&str>) = (self.output.lines().collect(), text.lines().collect());
        let most = old.len().min(new.len());
        let same = (0..most).take_while(|i| old[*i] == new[*i]).count();
        let behind = (0..most - same).take_while(|i| old[old.len() - 1 - i] == new[new.len() - 1 - i]).count();
        let place = |line: usize| {
            if line <= same { line } else { (new.len() - behind).max(same) + line.saturating_sub(old.len() - behind) }
        };
        let mut validator = Validator::new(&self.settings);
        let printed: usize = self.items.iter().map(|(_, lines)| lines).sum();
        let tail = old.iter().rev().take_while(|line| matches!(**line, "%" | "M2")).count();
        let tail = if self.ends_by_itself() { tail.min(2) } else { tail.min(1) };
        let mut line = old.len().saturating_sub(printed + tail);
        let part =
            |from: usize, to: usize| new[place(from)..place(to)].iter().map(|l| format!("{l}\n")).collect::<String>();
        let head = part(0, line);
        validator.head(head.as_bytes(), head.len());
        for (item, lines) in &self.items {
            let text = part(line, line + lines);
            let (bytes, end, origin) = (text.as_bytes(), text.len(), Origin::default());
            match item {
                Item::Move(mv) => validator.movement(mv, &origin, bytes, end),
                Item::Tap(tap, place) => validator.tap(tap, place, &origin, bytes, end),
                Item::Function(function) => validator.function(function, &origin, bytes, end),
                Item::BeginsAt(at) => validator.begins_at(at),
                Item::Lost => validator.lost(),
            }
            line += lines;
        }
        let rest = part(line, old.len());
        validator.finish(rest.as_bytes(), rest.len());
        validator.into_mismatch()
    }

    /// No block ends the program: the printer does.
    fn ends_by_itself(&self) -> bool {
        !self.items.iter().any(|(item, _)| matches!(item, Item::Function(Function::End { .. })))
    }

    /// Is `found` what was meant?
    pub fn judge(&self, found: &[Found]) -> Result<(), String> {
        let tolerance = meant::tolerance(self.decimals);
        if self.replaced {
            let (found, meant) = without_moves(found, &self.meant);
            return compare(&found, &meant, tolerance);
        }
        compare(found, &self.meant, tolerance)
    }

    /// Are the moves the ones that were meant?
    pub fn is_exact(&self) -> bool {
        !self.replaced
    }

    /// Does the interpreter miss a spindle that turns, in a case that is no whole program?
    fn is_part(&self, why: &str) -> bool {
        let misses = ["Cannot feed with zero spindle speed", "Spindle not turning in G33"];
        let turns = self.output.lines().any(|line| matches!(line, "M3" | "M4"))
            && self
                .output
                .lines()
                .any(|line| !line.starts_with('(') && line.split(' ').any(|word| word.starts_with('S')));
        !turns && misses.iter().any(|text| why.starts_with(text))
    }

    fn is_compensated(&self) -> bool {
        self.output.contains("\nG41") || self.output.contains("\nG42")
    }

    /// The stand-alone interpreter knows no U, V and W.
    pub fn has_parallel_axes(&self) -> bool {
        self.output.lines().filter(|line| !line.starts_with('(')).any(|line| line.contains(['U', 'V', 'W']))
    }
}

/// The items of a program with the lines of each.
fn items(session: &Session, dialect: &dialect::Dialect, settings: &Settings, files: &dyn Files) -> Vec<(Item, usize)> {
    let diags = Diags::default();
    let mut out = Vec::new();
    let mut printer = Printer::new(settings, "", &diags, &mut out, None);
    printer.hold();
    printer.release();
    let mut items = Items { printer, list: Vec::new() };
    session.lower(dialect, settings, files, &mut items);
    items.list
}

/// All golden cases that compile, those of findings among them, each compiled once for all tests.
pub fn all() -> &'static [Case] {
    static ALL: std::sync::OnceLock<Vec<Case>> = std::sync::OnceLock::new();
    ALL.get_or_init(|| {
        let cases = book::cases("");
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let share = cases.len().div_ceil(threads).max(1);
        std::thread::scope(|scope| {
            let work = |cases: &[&book::Case]| cases.iter().filter_map(|case| Case::of(case)).collect::<Vec<_>>();
            let parts: Vec<_> = cases.chunks(share).map(|part| scope.spawn(move || work(part))).collect();
            parts.into_iter().flat_map(|part| part.join().expect("the cases compile")).collect()
        })
    })
}

/// Every case of the books is judged: as many as there were when they were single files, and the new ones.
#[test]
fn every_case_is_judged() {
    let (cases, compiled) = (book::cases("").len(), all().len());
    println!("{cases} cases, {compiled} of them compile");
    assert!(cases >= 4_670 && compiled >= 3293, "{cases} cases, {compiled} of them compile");
}

fn report(failures: &[String], of: usize) {
    assert!(failures.is_empty(), "{} of {of}:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn golden_outputs_mean_what_they_say_to_rs274() {
    if !rs274::available() {
        return;
    }
    let cases: Vec<&Case> = all().iter().filter(|case| !case.has_parallel_axes()).collect();
    assert!(cases.len() > 1000, "only {} cases", cases.len());
    let thick: Vec<&Case> = cases.iter().copied().filter(|case| case.is_compensated()).collect();
    let jobs = cases.iter().map(|case| Job::new(&case.output));
    let jobs: Vec<Job<'_>> = jobs.chain(thick.iter().map(|case| Job::thick(&case.output))).collect();
    let answers = rs274::interpret_all(&jobs);
    let mut failures = Vec::new();
    for (i, answer) in answers.into_iter().enumerate() {
        let case = cases.get(i).or_else(|| thick.get(i - cases.len())).expect("a case for each answer");
        if answer.as_ref().is_err_and(|why| case.is_part(why)) {
            continue;
        }
        // Of tools that have a radius only the consent counts.
        let result = answer.and_then(|found| if i < cases.len() { case.judge(&found) } else { Ok(()) });
        if let Err(why) = result {
            failures.push(format!("{}: {why}", case.name));
        }
    }
    report(&failures, cases.len());
}

/// G33.1 comes back to where it began, does not wait, and begins at no angle: a warning says so of each tap of which more was asked.
fn as_linuxcnc_taps(tap: &Tap) -> Tap {
    let mut tap = tap.clone();
    let start = tap.start;
    tap.strokes.iter_mut().for_each(|stroke| (stroke.back, stroke.dwell) = (start, 0.0));
    tap.orient = None;
    tap
}

/// `partc diff` finds no difference between a program and what is printed for it.
#[test]
fn a_program_and_its_output_are_the_same_motion() {
    let exact = |case: &&Case| case.is_exact() && case.settings.output.tool_change == ToolChange::Change;
    let cases: Vec<&Case> = all().iter().filter(exact).collect();
    let mut failures = Vec::new();
    for case in &cases {
        let tolerance = 10f64.powi(-i32::from(case.decimals));
        let mut meant = Steps::of_program(tolerance, &case.settings);
        for (item, _) in &case.items {
            let origin = Origin::default();
            match item {
                Item::Move(mv) => motion::Sink::movement(&mut meant, mv, &origin),
                Item::Tap(tap, place) => motion::Sink::tap(&mut meant, &as_linuxcnc_taps(tap), place, &origin),
                Item::Function(function) => motion::Sink::function(&mut meant, function, &origin),
                Item::BeginsAt(at) => motion::Sink::begins_at(&mut meant, at),
                Item::Lost => motion::Sink::lost(&mut meant, &origin),
            }
        }
        let meant = meant.finish();
        match steps_of_text(case.output.as_bytes(), tolerance) {
            Ok(printed) => {
                let found = Difference::between(&meant, &printed, tolerance);
                if !found.is_same() {
                    failures.push(format!("{}: {}", case.name, found.text(&meant, &printed, ["meant", "printed"])));
                }
            }
            Err(stop) => failures.push(format!("{}: {stop}", case.name)),
        }
    }
    assert!(cases.len() > 3000);
    report(&failures, cases.len());
}

#[test]
fn golden_outputs_mean_what_they_say_to_our_reader() {
    let read = |case: &Case| reader::read(&case.output, case.decimals).and_then(|found| case.judge(&found));
    let failing = all().iter().filter_map(|case| Some(format!("{}: {}", case.name, read(case).err()?)));
    report(&failing.collect::<Vec<_>>(), all().len());
}
