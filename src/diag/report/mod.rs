//! Findings of many programs as one document for another program: one file a format.

mod checkstyle;
mod github;
mod gitlab;
mod json;
mod jsonl;
mod junit;
#[cfg(feature = "cli")]
pub mod merge;
mod sarif;
pub mod xml;

use crate::text::Sources;

use super::finding::Choices;
use super::{Diagnostic, Diags, Finding, Severity, Trail};

/// What one program came to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Checked {
    /// The program as the user calls it.
    pub file: String,
    /// In the order of their places.
    pub findings: Vec<Finding>,
    pub counts: Counts,
    /// Of the program itself, not of what it calls.
    pub bytes: u64,
}

/// How many findings there are, also those that are not kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    pub errors: u32,
    pub warnings: u32,
    pub notes: u32,
    /// Of them, without a finding in the list.
    pub not_shown: u32,
}

impl Counts {
    pub fn of(diags: &Diags) -> Counts {
        let [notes, warnings, errors] = diags.counts();
        Counts { errors, warnings, notes, not_shown: diags.dropped() }
    }

    pub fn add(&mut self, more: &Counts) {
        self.errors = self.errors.saturating_add(more.errors);
        self.warnings = self.warnings.saturating_add(more.warnings);
        self.notes = self.notes.saturating_add(more.notes);
        self.not_shown = self.not_shown.saturating_add(more.not_shown);
    }

    /// Findings that are at least as bad as `severity`.
    pub fn at_least(&self, severity: Severity) -> u32 {
        match severity {
            Severity::Error => self.errors,
            Severity::Warning => self.errors.saturating_add(self.warnings),
            Severity::Note => self.errors.saturating_add(self.warnings).saturating_add(self.notes),
        }
    }
}

impl Checked {
    /// The findings of `list` with their places looked up.
    pub fn new(
        file: &str,
        list: &[Diagnostic],
        counts: Counts,
        (sources, trail): (&Sources, &Trail),
        choices: Choices,
    ) -> Checked {
        let findings = list.iter().map(|found| Finding::new(found, sources, trail, choices)).collect();
        Checked { file: file.to_owned(), findings, counts, bytes: sources.size(crate::text::FileId(0)) }
    }
}

/// The formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// One object, as the manual describes it.
    Json,
    /// One finding a line.
    JsonLines,
    /// Workflow commands: annotations of a pull request.
    GitHub,
    /// Code Quality report.
    GitLab,
    /// SARIF 2.1.0.
    Sarif,
    /// A test case for each program.
    JUnit,
    Checkstyle,
}

/// Takes the programs one after the other, and makes a document of them.
pub trait Document {
    fn program(&mut self, checked: &Checked);

    /// The document with its last line end. `troubles` are no findings: files that could not be read.
    fn finish(self: Box<Self>, troubles: &[String]) -> String;
}

impl Kind {
    /// An empty document. A program fails with a finding that is at least as bad as `fails`.
    pub fn document(self, fails: Severity) -> Box<dyn Document> {
        match self {
            Kind::Json => Box::<json::Json>::default(),
            Kind::JsonLines => Box::<jsonl::JsonLines>::default(),
            Kind::GitHub => Box::<github::GitHub>::default(),
            Kind::GitLab => Box::<gitlab::GitLab>::default(),
            Kind::Sarif => Box::<sarif::Sarif>::default(),
            Kind::JUnit => Box::new(junit::JUnit::new(fails)),
            Kind::Checkstyle => Box::<checkstyle::Checkstyle>::default(),
        }
    }
}

/// Message and help as one text.
fn full_text(found: &Finding) -> String {
    let mut text = found.message.clone();
    if found.times > 1 {
        text += &format!(" ({} times)", found.times);
    }
    if let Some(help) = &found.help {
        text += "; ";
        text += help;
    }
    text
}

/// The name of a file as receivers compare it: relative, with slashes, without a leading `./`.
fn path_of(file: &str) -> String {
    let path = if cfg!(windows) { file.replace('\\', "/") } else { file.to_owned() };
    path.strip_prefix("./").map_or(path.clone(), str::to_owned)
}

/// Names the findings of one run so that they keep their names when lines are put in front of them, and when other programs
/// come: by program, file, code and text of the block, and counted where these are equal.
#[derive(Debug, Default)]
struct Fingerprints {
    seen: rustc_hash::FxHashMap<u128, u32>,
}

impl Fingerprints {
    fn of(&mut self, program: &str, found: &Finding) -> String {
        let mut hash = xxhash_rust::xxh3::Xxh3::new();
        if program != found.file {
            hash.update(path_of(program).as_bytes());
            hash.update(&[0]);
        }
        for part in [path_of(&found.file).as_str(), found.code, without_number(&found.text)] {
            hash.update(part.as_bytes());
            hash.update(&[0]);
        }
        let before = self.seen.entry(hash.digest128()).or_default();
        hash.update(&before.to_le_bytes());
        *before += 1;
        format!("{:032x}", hash.digest128())
    }
}

/// The text of a block without its number.
fn without_number(text: &str) -> &str {
    let text = text.trim();
    let digits = text.strip_prefix(['N', 'n']).unwrap_or(text);
    let rest = digits.trim_start_matches(|c: char| c.is_ascii_digit());
    // `N` alone, or a number alone, is the text.
    if rest.len() == digits.len() || rest.is_empty() { text } else { rest.trim_start() }
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn finding(line: u32, text: &str) -> Finding {
        Finding {
            code: "K2101",
            name: "pole-missing",
            severity: Severity::Error,
            message: "no <pole> & \"none\"".to_owned(),
            help: Some("program CC".to_owned()),
            file: "./a b/PART,1.H".to_owned(),
            line,
            column: 3,
            end_line: line,
            end_column: 9,
            block: None,
            times: 2,
            related: Vec::new(),
            stack: Vec::new(),
            alarm: None,
            answers: Vec::new(),
            text: text.to_owned(),
        }
    }

    pub(super) fn checked() -> Checked {
        let counts = Counts { errors: 2, warnings: 0, notes: 0, not_shown: 0 };
        let findings = vec![finding(3, "12 LP PR+5"), finding(7, "15 LP PR+5")];
        Checked { file: "./a b/PART,1.H".to_owned(), findings, counts, bytes: 100 }
    }

    #[test]
    fn fingerprints_survive_new_lines_and_numbers() {
        let of = |lines: &[(u32, &str)]| {
            let mut prints = Fingerprints::default();
            lines.iter().map(|(line, text)| prints.of("./a b/PART,1.H", &finding(*line, text))).collect::<Vec<_>>()
        };
        let before = of(&[(3, "12 LP PR+5"), (7, "N15 LP PR+6"), (9, "16 LP PR+5")]);
        let after = of(&[(30, "13 LP PR+5"), (70, "N160 LP PR+6"), (90, "LP PR+5")]);
        assert_eq!(before, after);
        assert_ne!(before[0], before[1]);
        assert_ne!(before[0], before[2]);
    }

    #[test]
    fn numbers_of_blocks_are_told_from_their_text() {
        for (text, left) in [("12 L X5", "L X5"), ("N10G1", "G1"), ("N", "N"), ("77", "77"), ("NAME=5", "NAME=5")] {
            assert_eq!(without_number(text), left);
        }
    }

    #[test]
    fn a_threshold_counts_what_is_worse() {
        let counts = Counts { errors: 1, warnings: 2, notes: 4, not_shown: 0 };
        let all = [Severity::Error, Severity::Warning, Severity::Note].map(|severity| counts.at_least(severity));
        assert_eq!(all, [1, 3, 7]);
    }
}
