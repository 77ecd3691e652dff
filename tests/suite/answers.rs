//! Where a finding names a key of `partc.toml`, the key is an answer: what `init`, the lines to paste and the JSON of a
//! finding know comes from there, never from the words.

use std::collections::BTreeMap;

use partc::diagnostics::{Answer, Severity};

use super::book;

const SECTIONS: [&str; 9] =
    ["machine", "control", "tools", "datums", "include", "variables", "output", "start", "programs"];

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
    for name in book::files("book") {
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
