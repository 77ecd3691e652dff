//! Every diagnostic code fires where it should, and is silent where it should be.
//!
//! The books under `tests/golden/errors/<dialect>` have a chapter for each code, with programs that show the mistake
//! (`fires`) and the same programs with the mistake mended (`silent`). Inputs that no book can show are built in [`BUILT`].

mod built;

use std::collections::{BTreeMap, BTreeSet};
use std::io;

use partc::internals::diag::{Diagnostic, Severity, codes};
use partc::internals::machine::Settings;
use partc::internals::text::ReadAt;

use super::book::{Case, cases, find};
use super::common::{Compiled, compile_bytes};
use built::{BUILT, Built, By, CALLER, NEVER, main_of, opened};

/// The cases of each code: `(fires, silent)`.
fn by_code() -> BTreeMap<String, (Vec<&'static Case>, Vec<&'static Case>)> {
    let mut map: BTreeMap<String, (Vec<&Case>, Vec<&Case>)> = BTreeMap::new();
    for case in cases("errors") {
        let stem = case.stem();
        let (code, rest) = stem.split_once('_').unwrap_or_else(|| panic!("{stem}: CODE_fires or CODE_silent"));
        let entry = map.entry(code.to_owned()).or_default();
        match rest.split('_').next() {
            Some("fires") => entry.0.push(case),
            Some("silent") => entry.1.push(case),
            _ => panic!("{stem}: CODE_fires or CODE_silent"),
        }
    }
    map
}

fn check_fires(what: &str, code: &codes::Code, compiled: &Compiled) {
    assert!(compiled.codes().contains(&code.id), "{what} does not fire: {:#?}", compiled.rendered);
    assert_eq!(compiled.has_errors(), compiled.output.is_empty(), "{what}: output beside errors");
    if code.severity == Severity::Error {
        assert!(compiled.output.is_empty(), "{what}: an error, and still an output");
    }
}

fn check_silent(what: &str, code: &codes::Code, compiled: &Compiled) {
    assert!(!compiled.codes().contains(&code.id), "{what} is not silent: {:#?}", compiled.rendered);
    assert!(!compiled.has_errors(), "{what}: mended, and still an error: {:#?}", compiled.rendered);
}

#[test]
fn every_code_fires_and_is_silent() {
    let cases = by_code();
    let mut missing = Vec::new();
    for code in codes::all() {
        let built: Vec<&Built> = BUILT.iter().filter(|built| built.code == code.id).collect();
        for built in &built {
            check_fires(&format!("{} built", code.id), code, &(built.fires)());
            check_silent(&format!("{} built", code.id), code, &(built.silent)());
        }
        let none = (Vec::new(), Vec::new());
        let (fires, silent) = cases.get(code.id).unwrap_or(&none);
        for case in fires {
            check_fires(&case.name, code, &case.compile());
        }
        for case in silent {
            check_silent(&case.name, code, &case.compile());
        }
        let never = NEVER.iter().any(|(id, _)| *id == code.id);
        let shown = !built.is_empty() || (!fires.is_empty() && !silent.is_empty());
        assert!(!(never && (shown || !fires.is_empty())), "{} fires: take it out of NEVER", code.id);
        if !shown && !never {
            missing.push(code.id);
        }
    }
    assert!(missing.is_empty(), "no case that fires, or none that is silent, for {missing:?}");
}

#[test]
fn every_case_belongs_to_a_code_and_has_its_counterpart() {
    for (id, (fires, silent)) in by_code() {
        assert!(codes::find(&id).is_some(), "{id} is no code");
        let suffixes = |cases: &[&Case], kind: &str| -> BTreeSet<String> {
            cases.iter().map(|case| case.stem().replace(&format!("{id}_{kind}"), "")).collect()
        };
        assert_eq!(suffixes(&fires, "fires"), suffixes(&silent, "silent"), "cases of {id} come in pairs");
    }
    for id in BUILT.iter().map(|built| built.code).chain(NEVER.iter().map(|(id, _)| *id)) {
        assert!(codes::find(id).is_some(), "{id} is no code");
    }
}

/// Findings of a mended program are about other things, so a pair differs in as little as possible.
#[test]
fn mended_programs_differ_in_few_lines() {
    for (id, (fires, silent)) in by_code() {
        for (fires, silent) in fires.iter().zip(&silent) {
            let lines = |case: &Case| -> Vec<String> {
                let text = case.text().expect("a program in UTF-8");
                // Block numbers move when a block is added.
                text.lines()
                    .map(|line| line.trim_start_matches(|c: char| c.is_ascii_digit()).trim().to_owned())
                    .collect()
            };
            let (a, b) = (lines(fires), lines(silent));
            let lost = a.iter().filter(|line| !b.contains(line)).count();
            // The title comment, the mistake, and for long definitions what replaces them.
            let most = if matches!(id.as_str(), "P9010" | "K9003") { 12 } else { 3 };
            assert!(lost <= most, "{id}: {lost} lines of {} changed", fires.name);
        }
    }
}

#[test]
fn every_finding_has_a_place_and_a_plain_message() {
    for case in cases("errors") {
        let compiled = case.compile();
        for (found, rendered) in compiled.findings.iter().zip(&compiled.rendered) {
            let what = format!("{}: {rendered}", case.name);
            check_place(&what, case, found, rendered);
            check_text(&what, &found.text());
            if let Some(help) = &found.help {
                check_text(&what, help);
            }
            for label in std::iter::once(&found.label).chain(&found.more).filter(|label| !label.text.is_empty()) {
                check_text(&what, &label.text);
            }
        }
    }
    for built in BUILT {
        for found in (built.fires)().findings {
            check_text(built.code, &found.text());
            assert!(found.label.loc.line >= 1, "{}", built.code);
        }
    }
}

/// The span lies in its file, on the line that is shown.
fn check_place(what: &str, case: &Case, found: &Diagnostic, rendered: &str) {
    let loc = found.label.loc;
    let mut parts = rendered.splitn(4, ':');
    let (name, line, column) = (parts.next().expect("a name"), parts.next(), parts.next());
    let number =
        |part: Option<&str>| part.and_then(|part| part.parse::<usize>().ok()).unwrap_or_else(|| panic!("{what}"));
    let (line, column) = (number(line), number(column));
    let text = if loc.file.0 == 0 {
        assert_eq!(name, case.file, "{what}");
        &case.program
    } else {
        case.called.get(name).expect("a called program")
    };
    let (start, end) = (loc.span.start as usize, loc.span.end as usize);
    assert!(start <= end && end <= text.len(), "{what}: span {start} to {end} of {} bytes", text.len());
    let lines = text.split(|b| *b == b'\n').count();
    assert!(loc.line >= 1 && line <= lines && column >= 1, "{what}");
    let above = text[..start].iter().filter(|b| **b == b'\n').count() + 1;
    assert_eq!(line, above, "{what}: the marked bytes stand on another line");
    // Only the end of a file that breaks off has no word to mark.
    let marked = !String::from_utf8_lossy(&text[start..end]).trim().is_empty() || end == text.len();
    assert!(marked, "{what}: nothing is marked");
}

/// Words for a machinist: no full stop, no name of the program's inside.
fn check_text(what: &str, text: &str) {
    assert!(!text.trim().is_empty(), "{what}: no text");
    assert!(!text.ends_with('.') || text.ends_with('…'), "{what}: ends in a full stop: {text}");
    assert!(text.chars().all(|c| !c.is_control()), "{what}: control characters: {text}");
    // What stands in quotes is the user's, or to be typed by him.
    let plain: String =
        text.split('`').step_by(2).flat_map(|part| part.split('"').step_by(2)).collect::<Vec<_>>().join(" ");
    for sign in ["::", "Some(", "None", "Err(", "Ok(", "{", "}", "unwrap", "usize", "f64", "NaN", "_"] {
        assert!(!plain.contains(sign), "{what}: `{sign}` in: {text}");
    }
    for word in plain.split(|c: char| !c.is_alphanumeric()).filter(|word| !matches!(*word, "GiB" | "MiB")) {
        let inner = word.chars().zip(word.chars().skip(1)).any(|(a, b)| a.is_lowercase() && b.is_uppercase());
        assert!(!inner, "{what}: `{word}` looks like a name of the source: {text}");
    }
    let mut first = plain.chars();
    let capital = first.next().is_some_and(char::is_uppercase) && first.next().is_some_and(char::is_lowercase);
    assert!(!capital, "{what}: messages begin in lower case: {text}");
}

/// The title of a code is what all its messages have in common, so it reads like one.
#[test]
fn titles_and_explanations_read_alike() {
    for code in codes::all() {
        check_text(code.id, code.title);
        assert!(code.title.chars().count() <= 72, "{}: a title is one short line", code.id);
        let explain = code.explain;
        assert!(explain.ends_with('.') || explain.ends_with('`'), "{}: explanations are sentences", code.id);
        assert!(!explain.contains("  ") && !explain.contains(" \n"), "{}: stray blanks", code.id);
        assert!(code.name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-'), "{}", code.id);
    }
}

#[test]
fn a_finding_in_a_called_subprogram_says_how_the_program_got_there() {
    let compiled = find("errors/klartext/G3001_fires_in_subprogram").expect("the case").compile();
    assert!(compiled.rendered[0].ends_with("(called from G3001_fires_in_subprogram.H:5)"), "{:?}", compiled.rendered);
}

/// The same mistake at the same place is one finding, however often the loop passes it.
#[test]
fn a_mistake_in_a_loop_is_one_finding() {
    let text = "0 BEGIN PGM LOOP MM\n1 LBL 1\n2 L IX+10 R0 F300 M25\n3 CALL LBL 1 REP 9\n4 END PGM LOOP MM\n";
    let compiled = main_of(text.as_bytes());
    assert_eq!(compiled.codes(), ["P2007"], "{:?}", compiled.rendered);
    assert_eq!(compiled.findings[0].times, 10);
}

/// A file that breaks off while it is read is no shorter program.
#[test]
fn a_read_error_in_the_middle_of_a_file_is_an_error() {
    struct Breaks(Vec<u8>);
    impl ReadAt for Breaks {
        fn len(&self) -> u64 {
            self.0.len() as u64
        }

        fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize> {
            if at > 0 {
                return Err(io::Error::other("the medium was removed"));
            }
            let n = buf.len().min(self.0.len() - 1);
            buf[..n].copy_from_slice(&self.0[..n]);
            Ok(n)
        }
    }
    let files = By(|name: &str| {
        let text = format!("0 BEGIN PGM {name} MM\n1 L Z-5 F150\n2 L Z+2 FMAX\n3 END PGM {name} MM\n");
        Ok(opened(name, Box::new(Breaks(text.into_bytes()))))
    });
    let compiled = compile_bytes("PART.H", CALLER.as_bytes().to_vec(), "klartext", &Settings::default(), &files);
    assert!(compiled.codes().contains(&"P0105") && compiled.output.is_empty(), "{:?}", compiled.rendered);
}

/// 500 findings are kept; the rest is counted, so that the exit code never depends on the room.
#[test]
fn more_findings_than_are_kept_still_fail() {
    let mut text = "0 BEGIN PGM MANY MM\n1 L X+0 Y+0 R0 F300\n".to_owned();
    for _ in 0..600 {
        text += "L X+10 R5\n";
    }
    text += "END PGM MANY MM\n";
    let compiled = main_of(text.as_bytes());
    assert_eq!(compiled.findings.len(), 500);
    assert!(compiled.output.is_empty());
}
