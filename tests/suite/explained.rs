//! The examples of `partc explain` are the first cases of the codes in the golden books; rules hold theirs in their files.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use partc::internals::diag::codes;

use super::book::{self, Case};

/// Programs and configuration of a case, each behind a line with its name.
fn shown(case: &Case) -> String {
    let mut text = format!("-- Example ({})\n{}", case.file, plain(&case.program));
    if !case.config.is_empty() {
        let _ = write!(text, "-- partc.toml\n{}", case.config);
    }
    // A chapter may have programs that its first case does not call.
    let program = String::from_utf8_lossy(&case.program).to_ascii_uppercase();
    for (name, bytes) in &case.called {
        let stem = name.split('.').next().unwrap_or(name).to_ascii_uppercase();
        if program.contains(&stem) {
            let _ = write!(text, "-- {name}\n{}", plain(bytes));
        }
    }
    text
}

/// Control characters as escapes, lines that all end.
fn plain(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    text.lines().flat_map(|line| [line.replace(char::is_control, "␍"), "\n".to_owned()]).collect()
}

#[test]
fn explain_shows_the_first_case_of_each_code() {
    let mut examples: BTreeMap<&str, String> = BTreeMap::new();
    for name in ["klartext", "sinumerik", "heidenhain-turning", "mtc200"] {
        for book in book::names().iter().filter(|book| book.starts_with(&format!("errors/{name}/"))) {
            for case in book::of(book) {
                let code = case.chapter.split(' ').next().unwrap_or_default();
                assert!(codes::find(code).is_some(), "{book}: {code} is no code");
                examples.entry(code).or_insert_with(|| shown(case));
            }
        }
    }
    // A rule holds its own beside its check: that of its file fires, as the books prove of theirs.
    for code in codes::all().into_iter().filter(|code| !code.of_rule.is_empty()) {
        let of_book = examples.remove(code.id).unwrap_or_default();
        assert!(of_book.starts_with(&format!("-- Example ({}_fires", code.id)), "{}: no case that fires", code.id);
        assert_eq!(code.example(), Some(of_book.trim_end()), "{}: the example in the file of its rule", code.id);
    }
    let text: String = examples.iter().map(|(code, example)| format!("=== {code}\n{example}\n")).collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/diag/codes/examples.txt");
    if std::fs::read_to_string(&path).is_ok_and(|before| before.replace("\r\n", "\n") == text) {
        return;
    }
    if std::env::var("INSTA_UPDATE").is_ok_and(|value| value == "always") {
        std::fs::write(&path, text).expect("a writable file");
    }
    panic!("src/diag/codes/examples.txt is not what the books say; INSTA_UPDATE=always writes it");
}

#[test]
fn examples_are_found_by_code() {
    let example = codes::find("K2101").and_then(|code| code.example()).expect("an example");
    assert!(example.starts_with("-- Example (K2101_fires.H)\n0 BEGIN PGM") && example.ends_with(" MM"), "{example}");
    let with = codes::all().into_iter().filter(|code| code.example().is_some()).count();
    assert!(
        codes::all().iter().all(|code| code.id.starts_with('L') != code.of_rule.is_empty()),
        "each rule has its example"
    );
    assert!(with >= 500, "{with} codes with an example");
}
