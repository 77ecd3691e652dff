//! Golden cases: each program under `tests/golden` has its listing beside it.
//!
//! The listing shows every output line next to the block that caused it, then the findings. Numbers are
//! checked against the manual or a derivation before a listing is accepted (see the comment in the case).

use std::fmt::Write as _;
use std::path::Path;

use super::common::{Compiled, cases, compile_case};

/// Width of the source column.
const WIDTH: usize = 44;

fn listing(compiled: &Compiled) -> String {
    let mut text = String::new();
    if !compiled.has_errors() {
        let mut last = "";
        for (number, output) in (1..).zip(compiled.output.lines()) {
            let source = compiled.lines.iter().find(|(line, _)| *line == number).map(|(_, source)| source.as_str());
            // The head and the frame come from no block.
            let Some(source) = source else { continue };
            let shown = if source == last { "" } else { source };
            let cut: String = shown.chars().take(WIDTH).collect();
            let _ = writeln!(text, "{cut:WIDTH$} | {output}");
            last = source;
        }
    }
    for line in &compiled.rendered {
        let _ = writeln!(text, "{line}");
    }
    text
}

fn check(folder: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in cases(folder) {
        let compiled = compile_case(&path);
        let name = Path::new(&path).file_name().expect("a file").to_string_lossy().into_owned();
        settings.set_snapshot_path(path.parent().expect("a folder"));
        settings.set_input_file(&path);
        settings.bind(|| insta::assert_snapshot!(name, listing(&compiled)));
    }
}

#[test]
fn klartext() {
    check("klartext");
}

#[test]
fn heidenhain_turning() {
    check("heidenhain-turning");
}

#[test]
fn mtc200() {
    check("mtc200");
}

#[test]
fn sinumerik() {
    check("sinumerik");
}

#[test]
fn errors() {
    check("errors");
}

#[test]
fn there_are_enough_cases() {
    assert!(cases("klartext").len() >= 120, "{} Klartext cases", cases("klartext").len());
    assert!(cases("sinumerik").len() >= 150, "{} SINUMERIK cases", cases("sinumerik").len());
    let turning = cases("heidenhain-turning").len();
    assert!(turning >= 70, "{turning} HEIDENHAIN turning cases");
    assert!(cases("mtc200").len() >= 100, "{} MTC200 cases", cases("mtc200").len());
}

#[test]
fn output_is_the_same_on_every_run() {
    for path in cases("klartext").into_iter().step_by(7) {
        assert_eq!(compile_case(&path).attempt, compile_case(&path).attempt, "{}", path.display());
    }
}

/// The head of every output, once.
#[test]
fn head_and_frame() {
    let path = cases("klartext").into_iter().find(|path| path.ends_with("path/line.H")).expect("the case path/line.H");
    insta::assert_snapshot!(compile_case(&path).output);
}
