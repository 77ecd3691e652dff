//! Every parameter of every cycle that is built has a case that would show if it were ignored.
//!
//! The table is docs/cycle-parameters.md. Each case is compiled as it stands, and with the argument emptied: the two must
//! differ. A parameter without a case has to say why it has none.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use partc::machine::Settings;
use partc::text::files::NoFiles;

use super::book::find;
use super::common::{Compiled, compile_bytes};

struct Row {
    cycle: String,
    place: usize,
    case: Option<String>,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn rows() -> Vec<Row> {
    let text = fs::read_to_string(root().join("docs/cycle-parameters.md")).expect("the table");
    let mut rows = Vec::new();
    for line in text.lines().filter(|line| line.starts_with("| ")) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [cycle, place, _, case] = cells[..] else { panic!("four cells: {line}") };
        let Ok(place) = place.parse() else { continue };
        let case = case.strip_prefix('`').and_then(|case| case.strip_suffix('`')).map(str::to_owned);
        rows.push(Row { cycle: cycle.to_owned(), place, case });
    }
    rows
}

/// The arguments of the call of `cycle` in a line, and where they stand in it.
fn arguments<'t>(line: &'t str, cycle: &str) -> Option<(usize, Vec<&'t str>)> {
    let from = line.find(&format!("{cycle}("))? + cycle.len() + 1;
    let (mut depth, mut quoted, mut start) = (0, false, from);
    let mut list = Vec::new();
    for (at, c) in line[from..].char_indices().map(|(at, c)| (from + at, c)) {
        match c {
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' => depth += 1,
            ')' if depth == 0 => {
                list.push(&line[start..at]);
                return Some((from, list));
            }
            ')' => depth -= 1,
            ',' if depth == 0 => {
                list.push(&line[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    None
}

/// The program with one argument of its first call that has it emptied.
fn without(text: &str, cycle: &str, place: usize) -> Option<String> {
    let given = |line: &&str| {
        !line.starts_with(';')
            && arguments(line, cycle).is_some_and(|(_, list)| list.get(place - 1).is_some_and(|a| !a.trim().is_empty()))
    };
    let line = text.lines().find(given)?;
    let (from, list) = arguments(line, cycle)?;
    let len = list.iter().map(|argument| argument.len() + 1).sum::<usize>() - 1;
    let emptied: Vec<&str> = list.iter().enumerate().map(|(at, a)| if at + 1 == place { "" } else { *a }).collect();
    let changed = format!("{}{}{}", &line[..from], emptied.join(","), &line[from + len..]);
    Some(text.replacen(line, &changed, 1))
}

/// What the machine would do, and what is said; comments of the source are neither.
fn result(compiled: &Compiled) -> (Vec<String>, Vec<String>) {
    let moves = compiled.output.lines().filter(|line| !line.starts_with('(')).map(str::to_owned).collect();
    let said = compiled.findings.iter().map(|found| format!("{} {}", found.code.id, found.text())).collect();
    (moves, said)
}

#[test]
fn no_parameter_is_ignored() {
    let mut bad = Vec::new();
    for row in rows() {
        let Some(case) = &row.case else { continue };
        let what = format!("{} {}: {case}", row.cycle, row.place);
        let Some(case) = find(&format!("sinumerik/{case}")) else {
            bad.push(format!("{what} does not exist"));
            continue;
        };
        let Some(changed) = without(case.text().expect("a program in UTF-8"), &row.cycle, row.place) else {
            bad.push(format!("{what} has no such argument"));
            continue;
        };
        if result(&case.compile()) == result(&case.compile_instead(&changed)) {
            bad.push(format!("{what} is the same without it"));
        }
    }
    assert!(bad.is_empty(), "{bad:#?}");
}

/// The table is complete: places count from 1 without a gap, and the cycle takes exactly so many arguments.
#[test]
fn all_parameters_are_in_the_table() {
    let mut places: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for row in rows() {
        places.entry(row.cycle).or_default().push(row.place);
    }
    assert!(places.len() >= 20, "{} cycles", places.len());
    for (cycle, list) in places {
        assert_eq!(list, (1..=list.len()).collect::<Vec<_>>(), "{cycle}");
        let too_many = |count: usize| {
            let text = format!("G0 X0 Y0 Z20 F200\n{cycle}({}1)\nM30\n", ",".repeat(count - 1));
            let compiled = compile_bytes("PART.MPF", text.into_bytes(), "sinumerik", &Settings::default(), &NoFiles);
            compiled.codes().contains(&"S2021")
        };
        assert!(!too_many(list.len()) && too_many(list.len() + 1), "{cycle} takes {} arguments", list.len());
    }
}
