//! What a page shows of a program is what `partc compile` makes of it; the module for browsers gives the same bytes.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use partc::page_data;
use serde_json::{Value, json};

use super::book::{self, Case};

/// The request of a page that holds a case.
fn request(case: &Case, what: &str) -> Vec<u8> {
    let files = || {
        std::iter::once((&case.file, &case.program)).chain(case.called.iter().filter(|(name, _)| **name != case.file))
    };
    let list: Vec<Value> = files().map(|(name, bytes)| json!([name, bytes.len()])).collect();
    let asked = json!({ "what": what, "dialect": case.dialect, "config": case.config, "files": list }).to_string();
    let mut request = (asked.len() as u32).to_le_bytes().to_vec();
    request.extend_from_slice(asked.as_bytes());
    files().for_each(|(_, bytes)| request.extend_from_slice(bytes));
    request
}

/// The JSON of an answer, and its parts by name.
fn read(answer: &[u8]) -> (Value, Vec<(String, &[u8])>) {
    let word = |at: usize| u32::from_le_bytes(answer[at..at + 4].try_into().expect("four bytes")) as usize;
    let count = word(0);
    let mut at = 4 + 4 * count;
    let mut parts = Vec::new();
    for part in 0..count {
        at = at.next_multiple_of(8);
        let length = word(4 + 4 * part);
        parts.push(&answer[at..at + length]);
        at += length;
    }
    assert_eq!(at, answer.len());
    let about: Value = serde_json::from_slice(parts[0]).expect("JSON in front");
    let names = about["parts"].as_array().expect("names").iter().map(|name| name.as_str().expect("a name").to_owned());
    let parts = names.zip(parts.into_iter().skip(1)).collect();
    (about, parts)
}

fn part<'a>(parts: &[(String, &'a [u8])], name: &str) -> &'a [u8] {
    parts.iter().find(|(found, _)| found == name).unwrap_or_else(|| panic!("no part {name}")).1
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().expect("four bytes"))).collect()
}

/// Cases whose files a page finds by other rules than the folder of a test.
pub(super) fn finds_the_same(case: &Case) -> bool {
    let mut names: Vec<String> = case.called.keys().map(|name| name.to_ascii_lowercase()).collect();
    names.dedup();
    // A page has no folders of the control.
    names.retain(|name| !name.contains('/'));
    case.called.is_empty() || (names.len() == case.called.len() && !case.name.starts_with("errors/"))
}

#[test]
fn a_page_shows_the_code_that_is_compiled() {
    let mut compared = 0;
    // Some of each book: the module runs all of them.
    for case in book::cases("").into_iter().step_by(5).filter(|case| finds_the_same(case)) {
        let answer = page_data::answer(&request(case, "make"));
        let (about, parts) = read(&answer);
        let compiled = case.compile();
        if case.name.starts_with("errors/") && compiled.has_errors() != about["failed"] {
            // A check found it.
            continue;
        }
        assert_eq!(String::from_utf8_lossy(part(&parts, "code")), compiled.output, "{}", case.name);
        assert_eq!(about["failed"], compiled.has_errors(), "{}", case.name);
        compared += 1;
        let printed: Vec<u32> = words(part(&parts, "printed"));
        assert!(printed.is_sorted(), "{}: lines of moves in order", case.name);
        let lines = words(part(&parts, "lines"));
        assert!(printed.iter().all(|line| *line as usize <= lines.len()), "{}", case.name);
        for at in compiled.lines.iter().filter(|line| line.at.0 == 0 && !compiled.has_errors()) {
            assert_eq!(lines[at.number as usize - 1], at.at.1, "{}: line {}", case.name, at.number);
        }
        let points = part(&parts, "kinds").len();
        assert_eq!(part(&parts, "points").len(), 12 * points, "{}", case.name);
        assert!(words(part(&parts, "owners")).iter().all(|owner| (*owner as usize) < printed.len()), "{}", case.name);
    }
    assert!(compared > 200, "{compared} cases");
}

#[test]
fn a_page_shows_where_blocks_lead_and_what_is_found() {
    let program = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S100\n2 L X+0 Y+0 Z+5 R0 FMAX\n3 LBL 1\n4 L IX+10 F200\n5 CALL LBL 1 REP 2\n6 END PGM A MM\n";
    let case = Case {
        file: "A.H".to_owned(),
        program: program.as_bytes().to_vec(),
        dialect: "klartext".to_owned(),
        ..Case::default()
    };
    let answer = page_data::answer(&request(&case, "check"));
    let (_, parts) = read(&answer);
    let places = String::from_utf8_lossy(part(&parts, "places"));
    assert_eq!(places, "3\tX0 Y0 Z5\n5\tX10 Y0 Z5 ×3\n");
    let answer = page_data::answer(&request(&case, "make"));
    let (about, parts) = read(&answer);
    assert_eq!((&about["lathe"], &about["stats"]["cutting_mm"]), (&json!(false), &json!(30.0)));
    assert_eq!(words(part(&parts, "blocks")), [3, 5, 5, 5]);
    let numbers: Vec<f32> = words(part(&parts, "points")).into_iter().map(f32::from_bits).collect();
    assert_eq!(numbers[numbers.len() - 3..], [30.0, 0.0, 0.0]);
}

/// A refused program has its path up to the error and what is known behind it, and no code.
#[test]
fn a_page_shows_a_refused_program_up_to_its_error() {
    let program = "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+100 Y+80 Z+0\n3 L X+0 Y+0 Z+5 R0 FMAX\n\
                   4 L X+10 F200\n5 L X+20 R5\n6 L X+30 Y+0 Z+0\n7 L X+40\n8 END PGM A MM\n";
    let case = Case {
        file: "A.H".to_owned(),
        program: program.as_bytes().to_vec(),
        dialect: "klartext".to_owned(),
        ..Case::default()
    };
    let answer = page_data::answer(&request(&case, "make"));
    let (about, parts) = read(&answer);
    assert_eq!(
        about["incomplete"],
        json!({ "code": "P1003", "file": "A.H", "own": true, "line": 6, "from": 2 }),
        "{about}"
    );
    assert_eq!(about["blank"], json!({ "low": [0.0, 0.0, -20.0], "high": [100.0, 80.0, 0.0] }));
    assert_eq!((&about["failed"], &about["stats"]), (&json!(true), &Value::Null));
    assert!(part(&parts, "code").is_empty() && part(&parts, "lines").is_empty());
    assert_eq!(words(part(&parts, "blocks")), [4, 5, 7, 8]);
    assert_eq!(words(part(&parts, "printed")), [0; 4]);
    // Behind the error: a move from nowhere, and one that is known again.
    let kinds: Vec<u8> = part(&parts, "kinds").to_vec();
    assert!(kinds[..3].iter().all(|kind| *kind == 255 || kind & 128 == 0), "{kinds:?}");
    assert_eq!((kinds[3] & 128, kinds[3] & 112 > 0, kinds[4]), (128, true, 129), "{kinds:?}");
    let answer = page_data::answer(&request(&case, "check"));
    let (_, parts) = read(&answer);
    let places = String::from_utf8_lossy(part(&parts, "places"));
    assert_eq!(places, "4\tX0 Y0 Z5\n5\tX10 Y0 Z5\n7\tX30 Y0 Z0 after an error\n8\tX40 Y0 Z0 after an error\n");
}

#[test]
fn requests_that_are_none_are_refused() {
    for bytes in [&b""[..], b"\x10\0\0\0{}", b"\x02\0\0\0{}", b"\x04\0\0\0nope", b"\xff\xff\xff\xff"] {
        let answer = String::from_utf8(page_data::answer(bytes)).expect("text");
        assert!(answer.starts_with("{\"trouble\":"), "{answer}");
    }
    let about: Value = serde_json::from_slice(&page_data::answer(b"\x10\0\0\0{\"what\":\"about\"}")).expect("JSON");
    assert!(about["targets"].as_array().is_some_and(|targets| targets.len() > 10), "{about}");
}

/// Every golden case in the module for browsers, which Node runs: `PARTC_WASM` names the module, which takes minutes to build
/// (`crates/partc-wasm/build`).
#[test]
fn the_module_for_browsers_answers_with_the_same_bytes() {
    let Some(module) = std::env::var_os("PARTC_WASM") else { return };
    let mut bytes = Vec::new();
    let mut take = |request: &[u8]| {
        let answer = page_data::answer(request);
        for part in [request, &answer] {
            bytes.extend_from_slice(&(part.len() as u32).to_le_bytes());
            bytes.extend_from_slice(part);
        }
    };
    for case in book::cases("") {
        take(&request(case, "make"));
        take(&request(case, "check"));
    }
    take(b"\x10\0\0\0{\"what\":\"about\"}");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let asked = std::env::temp_dir().join(format!("partc-same-{}.bin", std::process::id()));
    fs::write(&asked, &bytes).expect("a file of requests");
    let ran = Command::new("node")
        .arg(root.join("web/test/same.mjs"))
        .args([Path::new(&module), &asked])
        .current_dir(root)
        .stdin(Stdio::null())
        .output()
        .expect("node runs");
    let _ = fs::remove_file(&asked);
    let said = String::from_utf8_lossy(&ran.stdout);
    assert!(ran.status.success(), "{said}{}", String::from_utf8_lossy(&ran.stderr));
    println!("{said}");
}

/// `web/dist/report.html` and the notice are what `web/src` gives; looked at where `npm ci` has run in `web`.
#[test]
fn the_page_is_what_its_sources_give() {
    let web = Path::new(env!("CARGO_MANIFEST_DIR")).join("web");
    if !web.join("node_modules").is_dir() {
        return;
    }
    let ran = Command::new("node").args(["build.mjs", "--check"]).current_dir(&web).stdin(Stdio::null()).output();
    let ran = ran.expect("node runs");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
}
