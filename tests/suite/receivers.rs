//! The targets: one registry, no word outside their tables.

use std::fs;
use std::path::Path;

use serde_json::json;

use partc::machine::{Settings, schema};
use partc::target;

use super::cli_run::Folder;
use super::common::settings;

#[test]
fn command_line_configuration_and_registry_know_the_same_targets() {
    let names: Vec<&str> = target::ALL.iter().map(|target| target.name).collect();
    assert_eq!(target::NAMES, names[..]);
    let key = &schema::schema()["properties"]["output"]["properties"]["target"];
    assert_eq!(key["enum"], json!(names));
    assert_eq!(key["default"], json!(names[0]));
    assert_eq!(Settings::default().output.target, target::ALL[0]);
    for name in &names {
        assert_eq!(target::find(name).expect("a target").name, *name);
        assert_eq!(settings(&format!("[output]\ntarget = \"{name}\"")).output.target.name, *name);
    }
    let folder = Folder::new("target_names");
    let offered = format!("possible values: {}]", names.join(", "));
    folder.run(&["compile", "--target", "nobody", "A.H"]).exits(2).says(&offered);
}

/// A literal in the printer core would be a word that a table cannot change.
#[test]
fn no_word_of_a_target_stands_in_the_printer() {
    let emit = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/emit");
    let core = ["arc.rs", "comment.rs", "compensation.rs", "line.rs", "modal.rs", "page.rs", "printer.rs"];
    let parts = fs::read_dir(emit.join("printer")).expect("a folder").map(|entry| entry.expect("a file").path());
    for path in core.iter().map(|name| emit.join(name)).chain(parts) {
        let text = fs::read_to_string(&path).expect("a readable source");
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
            let words = line.split('"').skip(1).step_by(2).any(is_word);
            let letters = line.split("b'").skip(1).any(|rest| rest.starts_with(|c: char| c.is_ascii_uppercase()));
            assert!(!words && !letters, "{}: {line}", path.display());
        }
    }
}

/// `G40`, ` F`, `%`
fn is_word(text: &str) -> bool {
    let text = text.trim();
    let digits = text.trim_start_matches(|c: char| c.is_ascii_uppercase());
    let letters = text.len() - digits.len();
    text == "%" || letters == 1 && digits.chars().all(|c| c.is_ascii_digit() || c == '.')
}
