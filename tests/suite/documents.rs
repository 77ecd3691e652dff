//! What the documents show of the command line is what it does: blocks of `console`. Their links lead somewhere, and the
//! book has them all.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The documents for readers.
fn documents() -> Vec<PathBuf> {
    let beside = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| root().join(name));
    let folder = fs::read_dir(root().join("docs")).expect("the folder").map(|entry| entry.expect("an entry").path());
    let mut all: Vec<PathBuf> = folder.filter(|path| path.extension().is_some_and(|end| end == "md")).collect();
    all.extend(beside);
    all.sort();
    all
}

/// Lines outside of blocks of code.
fn prose(text: &str) -> Vec<&str> {
    let mut inside = false;
    let outside = |line: &&str| {
        let fence = line.trim_start().starts_with("```");
        inside ^= fence;
        !inside && !fence
    };
    text.lines().filter(outside).collect()
}

/// What a heading is called in a link.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}

fn anchors(text: &str) -> BTreeSet<String> {
    prose(text)
        .into_iter()
        .filter(|line| line.starts_with('#'))
        .map(|line| anchor(line.trim_start_matches('#').trim()))
        .collect()
}

/// What stands in the brackets behind `](`.
fn links(text: &str) -> Vec<String> {
    let targets = |line: &str| -> Vec<String> {
        line.split("](").skip(1).filter_map(|rest| rest.split(')').next()).map(str::to_owned).collect()
    };
    prose(text).into_iter().flat_map(targets).collect()
}

#[test]
fn links_lead_somewhere() {
    let mut lost = Vec::new();
    for path in documents().into_iter().filter(|path| !path.ends_with("SUMMARY.md")) {
        let text = fs::read_to_string(&path).expect("a document");
        for link in links(&text).into_iter().filter(|link| !link.contains("://")) {
            let (file, place) = link.split_once('#').map_or((link.as_str(), None), |(file, at)| (file, Some(at)));
            let other = if file.is_empty() { path.clone() } else { path.parent().expect("a folder").join(file) };
            let found = other.exists()
                && place.is_none_or(|at| anchors(&fs::read_to_string(&other).expect("a document")).contains(at));
            if !found {
                lost.push(format!("{}: {link}", path.display()));
            }
        }
    }
    assert!(lost.is_empty(), "{}", lost.join("\n"));
}

#[test]
fn the_book_has_every_document() {
    let summary = fs::read_to_string(root().join("docs/SUMMARY.md")).expect("the summary");
    let listed: BTreeSet<String> = links(&summary).into_iter().collect();
    let names = documents().into_iter().filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()));
    let written: BTreeSet<String> = names.filter(|name| name != "SUMMARY.md").collect();
    assert_eq!(listed, written);
}

#[test]
fn commands_in_the_documents_do_what_they_show() {
    trycmd::TestCases::new()
        .register_bin("partc", std::path::Path::new(env!("CARGO_BIN_EXE_partc")))
        .case("README.md")
        .case("CONTRIBUTING.md")
        .case("docs/*.md");
}
