//! Each change is switched on, and the tests that reach it run until one fails.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::process::{self, End};
use super::reach::{self, Test};
use super::{Places, Result, compile, list, tree};

/// Quick tests run together: what a program takes to start.
const QUICK: Duration = Duration::from_millis(150);
/// So many at a time, so that the first failure is near.
const TOGETHER: usize = 40;

/// Longer tests judge only what all others passed, when that is asked for.
const LONG: Duration = Duration::from_secs(1);
/// Tests that take longer than this do not judge, as they add what dozens of others do to a change that nobody notices.
const TOO_LONG: Duration = Duration::from_secs(5);
/// Modules of the suite that judge no numbers: the command line but for its figures, hostile input, texts and files.
const ASIDE: [&str; 21] = [
    "cli",
    "cli_ci",
    "cli_config",
    "cli_diff",
    "cli_files",
    "cli_findings",
    "cli_init",
    "cli_lint",
    "cli_output",
    "cli_reports",
    "cli_tables",
    "diagnostics",
    "documents",
    "endless",
    "explained",
    "hostile",
    "hostile_fk",
    "hostile_turning",
    "layering",
    "quality_bar",
    "supply",
];

/// Tries every change that has no verdict yet, in the order of the sample; `long`: those that nobody noticed, against the
/// long tests.
pub fn try_all(places: &Places, long: bool) -> Result<()> {
    let programs = compile::programs(places)?;
    let mut tests = reach::tests(places)?;
    tests.retain(|test| judges(test) && (test.takes > LONG) == long);
    let by_mutant = reach::by_mutant(&tests);
    let path = places.work.join("verdicts.tsv");
    let known = verdicts(places);
    let left_out = tree::left_out(places);
    let mut log = fs::OpenOptions::new().create(true).append(true).open(&path)?;
    for mutant in list::read(places)? {
        let number = mutant.number;
        let verdict = known.get(&number).map(String::as_str);
        let is_due = if long { verdict.is_some_and(|verdict| !is_caught(verdict)) } else { verdict.is_none() };
        if !is_due || left_out.contains_key(&number) {
            continue;
        }
        let start = Instant::now();
        let (verdict, by) = match by_mutant.get(&number) {
            None if long => ("alive", String::new()),
            None => ("unreached", String::new()),
            Some(tests) => tried(places, &programs, number, tests)?,
        };
        writeln!(log, "{number}\t{verdict}\t{by}\t{}\t{}", start.elapsed().as_millis(), mutant.name)?;
    }
    Ok(())
}

fn judges(test: &Test) -> bool {
    let module = test.name.split("::").next().unwrap_or_default();
    test.takes <= TOO_LONG && (test.program != "suite" || !ASIDE.contains(&module))
}

/// What was found out: caught, timeout, alive, unreached; and by which test.
pub fn verdicts(places: &Places) -> BTreeMap<usize, String> {
    let text = fs::read_to_string(places.work.join("verdicts.tsv")).unwrap_or_default();
    text.lines()
        .filter_map(|line| line.split_once('\t'))
        .filter_map(|(n, rest)| Some((n.parse().ok()?, rest.into())))
        .collect()
}

fn tried(
    places: &Places,
    programs: &BTreeMap<String, PathBuf>,
    number: usize,
    tests: &[&Test],
) -> Result<(&'static str, String)> {
    for (program, names, patience) in runs(programs, tests) {
        let mut command = process::command(places, program, &names);
        command.env("PARTC_MUTANT", number.to_string());
        match process::run(command, patience)? {
            End::Passed => {}
            End::Failed(test) => return Ok(("caught", test)),
            End::TooLong => return Ok(("timeout", names.first().copied().unwrap_or_default().to_owned())),
        }
    }
    Ok(("alive", String::new()))
}

/// What runs one after the other: quick tests together, by program, then the others by themselves.
fn runs<'a>(programs: &'a BTreeMap<String, PathBuf>, tests: &[&'a Test]) -> Vec<(&'a Path, Vec<&'a str>, Duration)> {
    let mut runs = Vec::new();
    for (name, path) in programs {
        let quick: Vec<&&Test> = tests.iter().filter(|test| test.program == *name && test.takes <= QUICK).collect();
        for part in quick.chunks(TOGETHER) {
            runs.push((path.as_path(), part.iter().map(|test| test.name.as_str()).collect(), patience(QUICK)));
        }
    }
    for test in tests.iter().filter(|test| test.takes > QUICK) {
        if let Some(path) = programs.get(&test.program) {
            runs.push((path, vec![test.name.as_str()], patience(test.takes)));
        }
    }
    runs
}

/// Others may work on the machine.
fn patience(takes: Duration) -> Duration {
    Duration::from_secs(60) + 30 * takes
}

fn is_caught(verdict: &str) -> bool {
    verdict.starts_with("caught") || verdict.starts_with("timeout")
}
