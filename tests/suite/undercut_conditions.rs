//! The table of conditions in docs/undercuts.md: each has a case that compiles and one that is refused with its code.

use std::fs;
use std::path::Path;

use super::book::find;

#[test]
fn every_condition_of_undercuts_has_its_cases() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(root.join("docs/undercuts.md")).expect("the page");
    let mut bad = Vec::new();
    let mut count = 0;
    for line in text.lines() {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [condition, compiled, refused, code] = cells[..] else { continue };
        let name = |cell: &str| cell.strip_prefix('`').and_then(|cell| cell.strip_suffix('`')).map(str::to_owned);
        let (Some(compiled), Some(refused)) = (name(compiled), name(refused)) else { continue };
        count += 1;
        if find(&format!("sinumerik/{compiled}")).is_none_or(|case| case.compile().has_errors()) {
            bad.push(format!("{condition}: {compiled} does not compile"));
        }
        if find(&refused).is_none_or(|case| !case.compile().codes().contains(&code)) {
            bad.push(format!("{condition}: {refused} is not refused with {code}"));
        }
    }
    assert!(bad.is_empty(), "{bad:#?}");
    assert!(count >= 30, "{count} conditions");
}
