//! The golden cases for the tests of `crates/partc-py`: `PARTC_CASES=FILE cargo test --test suite cases_for_python` writes them
//! with what the library makes of each, as JSON Lines. Bytes stand as the letters of Latin-1 with the same numbers.

use std::fmt::Write as _;
use std::fs;

use serde_json::json;

use super::book;
use super::page_data::finds_the_same;

#[test]
fn cases_for_python() {
    let Some(file) = std::env::var_os("PARTC_CASES") else { return };
    let letters = |bytes: &[u8]| bytes.iter().map(|byte| char::from(*byte)).collect::<String>();
    let mut lines = String::new();
    for case in book::cases("").into_iter().filter(|case| finds_the_same(case)) {
        let compiled = case.compile();
        let called: Vec<_> = case.called.iter().map(|(name, bytes)| json!([name, letters(bytes)])).collect();
        let line = json!({
            "name": case.name,
            "file": case.file,
            "dialect": case.dialect,
            "config": case.config,
            "program": letters(&case.program),
            "called": called,
            "gcode": if compiled.has_errors() { None } else { Some(&compiled.output) },
        });
        let _ = writeln!(lines, "{line}");
    }
    fs::write(file, lines).expect("a file that can be written");
}
