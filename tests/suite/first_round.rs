//! Real programs beside the repository: which share compiles after one round of `partc init` with its blanks filled in.
//!
//! What counts is a part program: SINUMERIK files that others call, those with arguments, and the test input of an editor
//! are counted among all files only.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::cli_init::filled;
use super::cli_run::Folder;
use super::tools::beside_repository;

/// Repositories whose files show an editor every spelling of a language: no programs.
const NO_PROGRAMS: &[&str] = &["deathaxe__sublime-s840d"];
/// Programs for a five-axis mill, which wait for tilted planes and tool-tip control: shown, and in no share of what three axes can do.
const FIVE_AXES: &[&str] = &["unknown__five-axis"];
/// Least share in per cent of part programs, over both languages.
const LEAST: usize = 60;

/// Codes of what is left that are shown of a repository.
const MOST_LEFT: usize = 6;
/// Time for each program.
const LIMITS: &str = "[limits]\nsteps = 500_000\n";

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder") {
        let path = entry.expect("an entry").path();
        let target = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            copy(&path, &target);
        } else {
            fs::copy(&path, &target).expect("a copy");
        }
    }
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        // Without a program there is no folder for outputs.
        for entry in fs::read_dir(folder).into_iter().flatten() {
            let path = entry.expect("an entry").path();
            if path.is_dir() { folders.push(path) } else { found.push(path) }
        }
    }
    found
}

/// Files that others of the same repository call, and those with arguments: subprograms.
struct Subprograms {
    /// Words of each file in upper case.
    words: Vec<(PathBuf, BTreeSet<String>)>,
}

impl Subprograms {
    fn new(all: &[PathBuf]) -> Subprograms {
        let words = |path: &PathBuf| {
            let text = String::from_utf8_lossy(&fs::read(path).unwrap_or_default()).to_uppercase();
            let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').map(str::to_owned).collect();
            (path.clone(), words)
        };
        Subprograms { words: all.iter().map(words).collect() }
    }

    fn has(&self, path: &Path) -> bool {
        let text = String::from_utf8_lossy(&fs::read(path).unwrap_or_default()).to_uppercase();
        let takes = text.lines().take(20).any(|line| line.trim_start().starts_with("PROC ") && line.contains('('));
        let name = path.file_stem().expect("a name").to_string_lossy().to_uppercase();
        takes || self.words.iter().any(|(other, words)| other != path && words.contains(&name))
    }
}

#[derive(Debug, Default, Clone, Copy)]
struct Share {
    programs: usize,
    before: usize,
    after: usize,
}

impl Share {
    fn add(&mut self, other: Share) {
        self.programs += other.programs;
        self.before += other.before;
        self.after += other.after;
    }

    fn per_cent(self) -> usize {
        (100 * self.after).checked_div(self.programs).unwrap_or(0)
    }
}

/// Part programs, and all files.
fn measure(language: &str, repository: &Path, into: &mut Vec<String>) -> [Share; 2] {
    let name = repository.file_name().expect("a name").to_string_lossy().into_owned();
    let folder = Folder::new(&format!("first_round_{name}_{language}"));
    copy(repository, &folder.0.join("shop"));
    let compiled = |to: &str| {
        folder.run(&["compile", "shop", "--out-dir", to, "--format", "concise", "--quiet", "--dialect", language]);
        let out = folder.0.join(to);
        files(&out)
            .into_iter()
            .filter_map(|path| Some(path.strip_prefix(&out).ok()?.with_extension("")))
            .collect::<Vec<_>>()
    };
    let extensions = if language == "klartext" { &["h", "ptp", "klartext"][..] } else { &["mpf", "spf"] };
    let is_program = |path: &Path| {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        extension.is_some_and(|extension| extensions.contains(&extension.as_str()))
    };
    let all: Vec<PathBuf> = files(&folder.0.join("shop")).into_iter().filter(|path| is_program(path)).collect();
    // Simulations that run for a minute are no part programs.
    folder.write("shop/partc.toml", LIMITS);
    let subprograms = Subprograms::new(&all);
    let before = compiled("before");
    folder.run(&["init", "shop", "--dialect", language, "--force"]);
    let config = filled(&folder.read("shop/partc.toml"));
    if config != LIMITS {
        folder.write("shop/partc.toml", &format!("{config}\n{LIMITS}"));
    }
    let after = compiled("after");
    let mut shares = [Share::default(); 2];
    for path in &all {
        let own = path.strip_prefix(folder.0.join("shop")).expect("inside").with_extension("");
        let one =
            Share { programs: 1, before: usize::from(before.contains(&own)), after: usize::from(after.contains(&own)) };
        shares[1].add(one);
        let counts = ![NO_PROGRAMS, FIVE_AXES].concat().contains(&name.as_str());
        if counts && (language == "klartext" || !subprograms.has(path)) {
            shares[0].add(one);
        }
    }
    into.push(format!("{:5} {:5} {:5}   {name}", shares[0].programs, shares[0].before, shares[0].after));
    let left = config.lines().skip_while(|line| !line.starts_with("# What is left")).skip(1).take(MOST_LEFT);
    into.extend(left.map(|line| line.chars().take(100).collect()));
    shares
}

#[test]
fn one_round_is_enough_for_most_real_programs() {
    let mut sums = [Share::default(); 2];
    let mut lines = vec!["parts before after".to_owned()];
    for (language, corpus) in [("klartext", "corpus/heidenhain"), ("sinumerik", "corpus/sinumerik")] {
        let Some(folder) = beside_repository(corpus) else {
            eprintln!("skipped: ../shared/{corpus} is not there");
            return;
        };
        let mut repositories: Vec<PathBuf> =
            fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
        repositories.sort();
        let mut own = [Share::default(); 2];
        for repository in repositories.iter().filter(|path| path.is_dir()) {
            let shares = measure(language, repository, &mut lines);
            own.iter_mut().zip(shares).for_each(|(sum, share)| sum.add(share));
        }
        lines.push(format!("{language}: {own:?}"));
        sums.iter_mut().zip(own).for_each(|(sum, share)| sum.add(share));
    }
    let [parts, all] = sums;
    lines.push(format!("part programs {} %: {parts:?}; all files {} %: {all:?}", parts.per_cent(), all.per_cent()));
    println!("{}", lines.join("\n"));
    assert!(parts.per_cent() >= LEAST, "{}", lines.join("\n"));
}
