//! Which tests reach which changes: each test runs once by itself, with nothing changed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write;
use std::process::Command;
use std::time::{Duration, Instant};

use super::process::{self, End};
use super::{Places, Result, compile};

/// Longer than any test may take.
const PATIENCE: Duration = Duration::from_secs(120);

/// A test that passes when nothing is changed.
pub struct Test {
    pub program: String,
    pub name: String,
    pub takes: Duration,
    pub reaches: BTreeSet<usize>,
}

/// Runs every test that has not been run yet, and writes what it reached.
pub fn reach(places: &Places) -> Result<()> {
    let path = places.work.join("tests.tsv");
    let known = fs::read_to_string(&path).unwrap_or_default();
    let known: BTreeSet<(&str, &str)> = known.lines().filter_map(|line| pair(line)).collect();
    let mut log = fs::OpenOptions::new().create(true).append(true).open(&path)?;
    let reached = places.work.join("reached");
    for (name, program) in compile::programs(places)? {
        let out = Command::new(&program).arg("--list").current_dir(places.tree()).output()?;
        let listed = String::from_utf8(out.stdout)?;
        for test in listed.lines().filter_map(|line| line.strip_suffix(": test")) {
            if known.contains(&(name.as_str(), test)) {
                continue;
            }
            let _ = fs::remove_file(&reached);
            let mut command = process::command(places, &program, &[test]);
            command.env("PARTC_MUTANTS_REACHED", &reached);
            let start = Instant::now();
            let end = process::run(command, PATIENCE)?;
            let takes = start.elapsed().as_millis();
            let how = match end {
                End::Passed => "passes",
                End::Failed(_) => "fails",
                End::TooLong => "too long",
            };
            let numbers = fs::read_to_string(&reached).unwrap_or_default();
            let numbers: BTreeSet<usize> = numbers.lines().filter_map(|line| line.parse().ok()).collect();
            let numbers: Vec<String> = numbers.iter().map(usize::to_string).collect();
            writeln!(log, "{name}\t{test}\t{takes}\t{how}\t{}", numbers.join(","))?;
        }
    }
    Ok(())
}

fn pair(line: &str) -> Option<(&str, &str)> {
    let (program, rest) = line.split_once('\t')?;
    Some((program, rest.split_once('\t')?.0))
}

/// The tests that judge: those that passed.
pub fn tests(places: &Places) -> Result<Vec<Test>> {
    let text = fs::read_to_string(places.work.join("tests.tsv"))?;
    let mut tests = Vec::new();
    for line in text.lines() {
        let fields: Vec<&str> = line.split('\t').collect();
        let [program, name, takes, "passes", numbers] = fields[..] else { continue };
        tests.push(Test {
            program: program.to_owned(),
            name: name.to_owned(),
            takes: Duration::from_millis(takes.parse()?),
            reaches: numbers.split(',').filter_map(|number| number.parse().ok()).collect(),
        });
    }
    Ok(tests)
}

/// The changes that are reached, each with the tests that reach it, the quickest first.
pub fn by_mutant(tests: &[Test]) -> BTreeMap<usize, Vec<&Test>> {
    let mut by_mutant: BTreeMap<usize, Vec<&Test>> = BTreeMap::new();
    for test in tests {
        for number in &test.reaches {
            by_mutant.entry(*number).or_default().push(test);
        }
    }
    for tests in by_mutant.values_mut() {
        tests.sort_by(|a, b| (a.takes, &a.name).cmp(&(b.takes, &b.name)));
    }
    by_mutant
}
