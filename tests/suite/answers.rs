//! Where a finding names a key of `partc.toml`, the key is an answer: what `init`, the lines to paste and the JSON of a
//! finding know comes from there, never from the words.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use partc::diagnostics::{Answer, Severity};

use super::book::{self, Case};
use super::cli_run::Folder;

const SECTIONS: [&str; 12] = [
    "machine",
    "control",
    "tools",
    "datums",
    "include",
    "variables",
    "output",
    "start",
    "programs",
    "cycles",
    "undercut",
    "limits",
];

/// Sections and keys that a text names in backquotes: `[control] unit`, `[tools.5] radius`.
fn named(text: &str) -> Vec<(String, String)> {
    let quoted = text.split('`').skip(1).step_by(2);
    quoted
        .filter_map(|quoted| {
            let (section, rest) = quoted.strip_prefix('[')?.split_once(']')?;
            let section = section.split('.').next()?;
            SECTIONS.contains(&section).then_some(())?;
            let key: String =
                rest.trim_start().chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
            (!key.is_empty()).then(|| (section.to_owned(), key))
        })
        .collect()
}

fn answers(all: &[Answer], (section, key): &(String, String)) -> bool {
    // A table of tools stands for what is asked for of one.
    if (section.as_str(), key.as_str()) == ("tools", "table") {
        return all.iter().any(|answer| answer.section == "tools");
    }
    let is_it = |part: &String| part == key || part.split('.').next() == Some(key);
    all.iter().any(|answer| answer.section == section && answer.path.iter().any(is_it))
}

/// No finding of any book names a key that is no answer.
#[test]
fn keys_that_findings_name_are_answers() {
    let mut missing: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
    for name in book::names() {
        for case in book::of(&name) {
            for finding in case.compile().findings {
                // What a lint names bounds what it looks at.
                if finding.severity == Severity::Note || finding.code.id.starts_with('L') {
                    continue;
                }
                for key in named(finding.help.as_deref().unwrap_or_default()) {
                    if !answers(&finding.answers, &key) {
                        let words = format!("[{}] {}", key.0, key.1);
                        missing.entry((finding.code.id.to_owned(), words)).or_default().push(case.name.clone());
                    }
                }
            }
        }
    }
    let lines: Vec<String> = missing
        .iter()
        .map(|((code, key), cases)| format!("{code} names `{key}` without an answer, as in {}", cases[0]))
        .collect();
    assert!(lines.is_empty(), "{} findings:\n{}", lines.len(), lines.join("\n"));
}

/// Keys that texts name and no finding asks for.
const NEVER_ASKED: [(&str, &str); 7] = [
    // The meaning of a parameter of a cycle, which is no finding.
    ("control", "klartext"),
    // Notes of rules.
    ("control", "skip_blocks"),
    ("machine", "limits"),
    // Notes of what an undercut rests on.
    ("undercut", "din509_by_diameter"),
    ("undercut", "din509_in_cycle"),
    ("undercut", "internal_depth"),
    ("undercut", "thread_length"),
];

/// Sources of the stages: what of them words findings.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    // Tables of keys and codes, tests, and what the commands say of themselves.
    const OTHERS: [&str; 7] = ["machine", "codes", "tests", "cli", "lsp", "page_data", "target"];
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        if OTHERS.contains(&name.as_str()) {
            continue;
        }
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Each key that the text of some finding may name is an answer of some case, or made in the file of the text: also where no case brings
/// the text about.
#[test]
fn keys_that_texts_name_are_answers_somewhere() {
    let mut asked: BTreeSet<(&'static str, String)> = BTreeSet::new();
    for name in book::names() {
        for finding in book::of(&name).iter().flat_map(|case| case.compile().findings) {
            for answer in finding.answers {
                asked.extend(
                    answer.path.iter().map(|part| (answer.section, part.split('.').next().unwrap_or(part).to_owned())),
                );
            }
        }
    }
    let (mut files, mut missing) = (Vec::new(), BTreeMap::new());
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut files);
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a source");
        for line in text.lines().map(str::trim_start).filter(|line| !line.starts_with("//")) {
            for (section, key) in named(&line.replace("\\\"", "")) {
                let is_any = ["tools", "datums", "variables", "programs", "start"].contains(&section.as_str());
                let is_met = asked.iter().any(|(of, part)| *of == section && (*part == key || is_any));
                let is_made = text.contains(&format!("\"{section}\", \"{key}\""));
                if !is_met && !is_made && !NEVER_ASKED.contains(&(section.as_str(), key.as_str())) {
                    missing.entry(format!("[{section}] {key}")).or_insert_with(|| file.display().to_string());
                }
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Keys that errors of the books ask for, each with the first case of each code.
fn asking() -> Vec<&'static Case> {
    let (mut met, mut found) = (BTreeSet::new(), Vec::new());
    for name in book::names() {
        for case in book::of(&name) {
            // A backup has programs in folders of the control, which a folder of files says by its configuration.
            if case.called.keys().any(|name| name.contains(['/', '\\'])) {
                continue;
            }
            let errors = case.compile().findings.into_iter().filter(|finding| finding.severity == Severity::Error);
            let keys = errors.flat_map(|finding| {
                let key = |answer: &Answer| (finding.code.id, answer.section, answer.path.last().cloned());
                finding.answers.iter().map(key).collect::<Vec<_>>()
            });
            // Which name or number it is makes no difference.
            let is_name = |section: &str| matches!(section, "variables" | "programs" | "include" | "datums" | "start");
            let keys = keys.map(|(code, section, key)| (code, section, key.filter(|_| !is_name(section))));
            if keys.filter(|key| met.insert(key.clone())).count() > 0 {
                found.push(case);
            }
        }
    }
    found
}

/// `init` reads each of these programs: a value that it makes up to go on is one that the key takes.
#[test]
fn init_has_a_value_for_each_key() {
    let cases = asking();
    assert!(cases.len() > 100, "{}", cases.len());
    let mut failures = Vec::new();
    for case in cases {
        let folder = Folder::new("answers_init");
        std::fs::write(folder.0.join(&case.file), &case.program).expect("a program");
        for (name, bytes) in &case.called {
            std::fs::write(folder.0.join(name), bytes).expect("a program");
        }
        folder.write("partc.toml", &case.config);
        let ran = folder.run(&["init", &case.file, "-o", "-", "--dialect", &case.dialect]);
        if ran.code != Some(0) || !ran.err.is_empty() || ran.out.contains("# Not tried to its end") {
            failures.push(format!("{}: {}{}", case.name, ran.err, ran.out));
        }
    }
    assert!(failures.is_empty(), "{}:\n{}", failures.len(), failures.join("\n"));
}

/// Of the name of a file nobody makes one up: it is asked for, and nothing is said of what is left.
#[test]
fn what_cannot_be_made_up_is_asked_for_all_the_same() {
    let program = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000 F100\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n3 CYCL DEF 7.0 DATUM SHIFT\n\
                   4 CYCL DEF 7.1 #3\n5 L X+10 FMAX M30\n6 END PGM A MM\n";
    let folder = Folder::new("answers_name").with(&[("A.H", program)]);
    let said = folder.run(&["init", "A.H", "-o", "-"]).exits(0).out;
    assert!(said.contains("\n#datum_table = "), "{said}");
    assert!(said.contains("# 0 compile as it is, 0 once") && !said.contains("left whatever"), "{said}");
}
