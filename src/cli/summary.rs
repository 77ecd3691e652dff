//! Findings of several programs on a terminal: a line each, a key told once for all, a table at the end.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use crate::diag::codes;

use super::answers::{Needs, Request};
use super::need::Form;

/// Findings of a program that are shown unless the user wants more.
pub(super) const USUAL: usize = 20;
/// Codes in the table.
const MOST_ROWS: usize = 20;
/// Lines to paste that are shown; more of them are a file of their own.
const MOST_LINES: usize = 60;
/// Characters of the keys behind a code.
const KEYS_WIDTH: usize = 60;

/// A finding in one line, and the keys that it asks for.
#[derive(Debug)]
pub(super) struct Line {
    pub text: String,
    pub code: &'static str,
    pub keys: Vec<String>,
    /// Blocks in which it was found.
    pub findings: u32,
}

#[derive(Debug, Default)]
struct Row {
    findings: u32,
    programs: u32,
    keys: BTreeSet<String>,
}

/// What is kept of all programs.
#[derive(Debug, Default)]
pub(super) struct Summary {
    rows: BTreeMap<&'static str, Row>,
    /// Keys of findings that were shown.
    told: BTreeSet<String>,
    /// Findings that were shown for another program.
    told_before: u32,
    pub needs: Needs,
}

impl Summary {
    /// Takes the findings of a program and gives its lines: at most `most`, and none whose keys another program has shown.
    pub fn lines(&mut self, program: &str, lines: &[Line], not_kept: u32, most: usize) -> String {
        let (mut text, mut shown, mut hidden) = (String::new(), 0, not_kept);
        let mut met = BTreeSet::new();
        for line in lines {
            let row = self.rows.entry(line.code).or_default();
            row.findings += line.findings;
            row.programs += u32::from(met.insert(line.code));
            row.keys.extend(line.keys.iter().cloned());
            if !line.keys.is_empty() && line.keys.iter().all(|key| self.told.contains(key)) {
                self.told_before += line.findings;
                continue;
            }
            if shown == most {
                hidden += line.findings;
                continue;
            }
            self.told.extend(line.keys.iter().cloned());
            text += &line.text;
            text.push('\n');
            shown += 1;
        }
        if hidden > 0 {
            let _ = writeln!(text, "{program}: … and {hidden} more");
        }
        text
    }

    pub fn ask(&mut self, program: &str, requests: &[Request]) {
        self.needs.take(program, requests);
    }

    /// Code by programs by key, the code of most programs first.
    pub fn table(&self) -> String {
        let mut rows: Vec<_> = self.rows.iter().collect();
        rows.sort_by_key(|(code, row)| (std::cmp::Reverse((row.programs, row.findings)), **code));
        let mut text = String::from("\nprograms findings\n");
        for (code, row) in rows.iter().take(MOST_ROWS) {
            let title = codes::find(code).map_or("", |code| code.title);
            let mut keys: String = row.keys.iter().cloned().collect::<Vec<_>>().join(", ");
            if let Some((at, _)) = keys.char_indices().nth(KEYS_WIDTH) {
                keys.truncate(at);
                keys.push('…');
            }
            let keys = if keys.is_empty() { keys } else { format!("  <- {keys}") };
            let _ = writeln!(text, "{:8} {:8}  {code} {title}{keys}", row.programs, row.findings);
        }
        if rows.len() > MOST_ROWS {
            let _ = writeln!(text, "                   … and {} more codes", rows.len() - MOST_ROWS);
        }
        if self.told_before > 0 {
            let _ = writeln!(text, "{} that ask for the same keys as others are not repeated.", self.told_before);
        }
        text
    }

    /// What a configuration can answer, to be pasted.
    pub fn to_paste(&self, many: bool) -> String {
        if self.needs.is_empty() {
            return String::new();
        }
        let lines = self.needs.toml(Form::Lines, &BTreeSet::new(), &|_, _| Vec::new());
        let begin = if many {
            "Begin with what partc.toml can answer: `partc init` writes these lines for a folder; or paste and fill in:"
        } else {
            "Paste into partc.toml and fill in:"
        };
        let mut text = format!("\n{begin}\n\n");
        for line in lines.lines().take(MOST_LINES) {
            let _ = writeln!(text, "    {line}");
        }
        if lines.lines().count() > MOST_LINES {
            let _ = writeln!(text, "    … and {} more lines", lines.lines().count() - MOST_LINES);
        }
        text.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
    }
}
