//! Where a finding names a key of `partc.toml`, the key is an answer: what `init`, the lines to paste and the JSON of a
//! finding know comes from there, never from the words.

use std::collections::BTreeMap;

use partc::diagnostics::{Answer, Severity};

use super::book;

const SECTIONS: [&str; 9] =
    ["machine", "control", "tools", "datums", "include", "variables", "output", "start", "programs"];

/// Sections and keys that a text names in backquotes: `[control] unit`, `[tools.5] radius`.
fn named(text: &str) -> Vec<(String, Option<String>)> {
    let quoted = text.split('`').skip(1).step_by(2);
    quoted
        .filter_map(|quoted| {
            let (section, rest) = quoted.strip_prefix('[')?.split_once(']')?;
            let section = section.split('.').next()?;
            SECTIONS.contains(&section).then_some(())?;
            let key: String =
                rest.trim_start().chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
            Some((section.to_owned(), Some(key).filter(|key| !key.is_empty())))
        })
        .collect()
}

fn answers(all: &[Answer], (section, key): &(String, Option<String>)) -> bool {
    all.iter().any(|answer| {
        answer.section == section
            && key.as_ref().is_none_or(|key| {
                // A tool may be named by the number of its example.
                answer.path.iter().any(|part| part == key)
            })
    })
}

/// No finding of any book names a key that is no answer.
#[test]
fn keys_that_findings_name_are_answers() {
    let mut missing: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
    for name in book::files("book") {
        for case in book::of(&name) {
            for finding in case.compile().findings {
                if finding.severity == Severity::Note {
                    continue;
                }
                for key in named(finding.help.as_deref().unwrap_or_default()) {
                    if !answers(&finding.answers, &key) {
                        let words = format!("[{}] {}", key.0, key.1.unwrap_or_default());
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
