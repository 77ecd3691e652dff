//! Every parameter of every cycle that is built has a case that would show if it were ignored.
//!
//! The parameters are those of the table that the compiler reads them by; docs/cycle-parameters.md is written of it, too.
//! Each case is compiled as it stands, and with the argument emptied: the two must differ. A parameter without a case has
//! to say in its row why nothing depends on it.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use partc::internals::dialect;
use partc::internals::machine::Settings;
use partc::internals::sema::cycle::row::{Signature, Status};
use partc::internals::target;
use partc::internals::text::files::NoFiles;

use super::book::{Case, find};
use super::common::{Compiled, compile_bytes};
use super::cycle_cases::cases;

/// Set it to write the documentation anew.
const UPDATE: &str = "PARTC_UPDATE_DOCS";

const INTRODUCTION: &str = "\
# Cycles and their parameters

Written from the tables by which partc reads the arguments; a test compares (`PARTC_UPDATE_DOCS=1 cargo test cycle_parameters`
writes it anew). \"Left out\" is what holds where a call does not give the parameter; without a word it is 0.
";

fn documentation() -> String {
    let mut shown = INTRODUCTION.to_owned();
    for dialect in dialect::ALL {
        let cycles = (dialect.cycles)();
        if cycles.is_empty() {
            continue;
        }
        let _ = writeln!(shown, "\n## {}\n", dialect.name);
        let named = |cycle: &&&Signature| matches!(cycle.status, Status::Refused { .. });
        let sections: Vec<String> = cycles.iter().filter(|cycle| !named(cycle)).map(|cycle| cycle.section()).collect();
        shown.push_str(&sections.join("\n"));
        let refused: Vec<String> =
            cycles.iter().filter(named).map(|cycle| format!("* {}: {}\n", cycle.name, cycle.what)).collect();
        if !refused.is_empty() {
            let _ = write!(shown, "\n### Refused by name\n\n{}", refused.concat());
        }
    }
    shown
}

#[test]
fn the_documentation_is_that_of_the_tables() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/cycle-parameters.md");
    let made = documentation();
    if std::env::var_os(UPDATE).is_some() {
        fs::write(&path, &made).expect("the documentation");
    }
    let found = fs::read_to_string(&path).expect("the documentation").replace("\r\n", "\n");
    assert!(found == made, "{} is not up to date: {UPDATE}=1 writes it", path.display());
}

#[test]
fn a_cycle_is_described_by_its_name() {
    let sinumerik = dialect::find("sinumerik").expect("a dialect");
    let shown = sinumerik.cycle("cycle97").expect("a cycle").describe();
    assert!(shown.starts_with("CYCLE97(PIT, MPIT, SPL, FPL, DM1, DM2, APP, ROP, TDEP,"), "{shown}");
    assert!(shown.contains("\nTDEP: depth of the thread, on the radius; length; needed, without sign\n"), "{shown}");
    let klartext = dialect::find("klartext").expect("a dialect");
    let shown = klartext.cycle("CYCL DEF 200").expect("a cycle").describe();
    assert!(shown.contains("\nQ201: depth below the surface, 0 or less; length; needed\n"), "{shown}");
    let shown = klartext.cycle("CYCL DEF 225").expect("a cycle").describe();
    assert_eq!(shown, "CYCL DEF 225: ENGRAVING\nnot supported (P9010)");
    assert!(klartext.cycle("CYCL DEF 999").is_none());
}

/// The cycles of SINUMERIK that are compiled.
fn built() -> impl Iterator<Item = &'static Signature> {
    let cycles = dialect::find("sinumerik").map(|dialect| (dialect.cycles)()).unwrap_or_default();
    // CYCLE62 calls a contour and makes nothing itself.
    cycles.into_iter().filter(|cycle| cycle.status == Status::Built && cycle.name != "CYCLE62")
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

/// The tap of LinuxCNC comes out of the hole at each step: the blocks of a SINUMERIK say how far back it goes.
fn tells_taps_apart(case: &Case, cycle: &str, changed: &str) -> bool {
    let on_sinumerik = |program: &[u8]| {
        let mut settings = case.settings();
        settings.output.target = target::find("sinumerik").expect("a target");
        settings.output.tool_length = Some(false);
        result(&compile_bytes(&case.file, program.to_vec(), &case.dialect, &settings, case))
    };
    cycle == "CYCLE84" && on_sinumerik(&case.program) != on_sinumerik(changed.as_bytes())
}

#[test]
fn no_parameter_is_ignored() {
    let mut bad = Vec::new();
    for cycle in built() {
        for (place, parameter) in (1..).zip(cycle.parameters) {
            let what = format!("{} {}", cycle.name, parameter.name);
            let name = parameter.name.to_string();
            let cases: Vec<&str> =
                cases().filter(|(of, known, _)| *of == cycle.name && *known == name).map(|(.., case)| case).collect();
            if cases.is_empty() != parameter.without_effect.is_some() {
                bad.push(format!(
                    "{what} has {} cases, and without effect: {:?}",
                    cases.len(),
                    parameter.without_effect
                ));
            }
            for case in cases {
                let Some(found) = find(&format!("sinumerik/{case}")) else {
                    bad.push(format!("{what}: {case} does not exist"));
                    continue;
                };
                let Some(changed) = without(found.text().expect("a program in UTF-8"), cycle.name, place) else {
                    bad.push(format!("{what}: {case} has no such argument"));
                    continue;
                };
                let without = found.compile_instead(&changed);
                let says_nothing = result(&found.compile()) == result(&without);
                if says_nothing && !tells_taps_apart(found, cycle.name, &changed) {
                    bad.push(format!("{what}: {case} is the same without it"));
                }
                if parameter.needed && !without.has_errors() {
                    bad.push(format!("{what} is said to be needed, and {case} does without"));
                }
            }
        }
    }
    assert!(bad.is_empty(), "{bad:#?}");
}

#[test]
fn every_case_belongs_to_a_parameter() {
    let known = |cycle: &str, name: &str| {
        built()
            .any(|row| row.name == cycle && row.parameters.iter().any(|parameter| parameter.name.to_string() == name))
    };
    let strange: Vec<_> = cases().filter(|(cycle, name, _)| !known(cycle, name)).collect();
    assert!(strange.is_empty(), "{strange:#?}");
}

/// A cycle takes exactly as many arguments as its row has.
#[test]
fn cycles_take_as_many_arguments_as_they_have_parameters() {
    assert!(built().count() >= 20);
    for cycle in built() {
        let too_many = |count: usize| {
            let text = format!("G0 X0 Y0 Z20 F200\n{}({}1)\nM30\n", cycle.name, ",".repeat(count - 1));
            let compiled = compile_bytes("PART.MPF", text.into_bytes(), "sinumerik", &Settings::default(), &NoFiles);
            compiled.codes().contains(&"S2021")
        };
        let most = cycle.parameters.len();
        assert!(!too_many(most) && too_many(most + 1), "{} takes {most} arguments", cycle.name);
    }
}
