//! A finding as plain data: everything resolved, for programs that use the library, and for JSON.

use serde::Serialize;

use crate::text::Sources;

use super::{Answer, Diagnostic, Severity, Trail, Values};

/// One finding, as `--format json` shows it. Lines and columns count from 1, columns in characters.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Stable code, `K2101`; `partc explain` has its text.
    pub code: &'static str,
    /// Stable name, `pole-missing`.
    pub name: &'static str,
    #[serde(serialize_with = "word")]
    pub severity: Severity,
    /// What is wrong, in a machinist's words.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
    pub file: String,
    pub line: u32,
    pub column: u32,
    pub end_line: u32,
    pub end_column: u32,
    /// Number of the block, where it has one.
    pub block: Option<String>,
    /// How often the same was found at the same place.
    pub times: u32,
    /// Places that explain it.
    pub related: Vec<Related>,
    /// The calls that led there, the innermost first.
    pub stack: Vec<Site>,
    /// Number of the alarm that the control shows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alarm: Option<u32>,
    /// Keys of a configuration that answer it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub answers: Vec<Asked>,
    /// The line of the program, readable.
    #[serde(skip)]
    pub text: String,
}

/// A place that explains a finding.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Related {
    pub message: String,
    pub file: String,
    pub line: u32,
    pub column: u32,
}

/// A key of `partc.toml`, by its table, and the values that would do, as TOML: none where only the user knows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Asked {
    pub table: String,
    pub key: String,
    pub values: Vec<String>,
}

/// The values that a key may take, as TOML, where it has a list of them and the finding offers none.
pub type Choices = fn(&Answer) -> Vec<String>;

impl Asked {
    /// `None` for what only a look into folders can tell.
    fn new(answer: &Answer, choices: Choices) -> Option<Asked> {
        let (table, key) = answer.place();
        let values = match &answer.values {
            Values::Open => choices(answer),
            Values::Meaning(_) | Values::Coordinates => Vec::new(),
            Values::Item(item) => vec![format!("[{item}]")],
            Values::OneOf(values) => values.clone(),
            Values::FolderOf(_) => return None,
        };
        Some(Asked { table, key, values })
    }
}

/// The block of a call.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Site {
    pub file: String,
    pub line: u32,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands over a reference")]
fn word<S: serde::Serializer>(severity: &Severity, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(severity.word())
}

impl Finding {
    /// The finding with its places looked up.
    pub fn new(found: &Diagnostic, sources: &Sources, trail: &Trail, choices: Choices) -> Finding {
        let loc = found.label.loc;
        let line = sources.line(loc);
        let related = found.more.iter().map(|label| {
            let line = sources.line(label.loc);
            let file = sources.name(label.loc.file);
            Related { message: label.text.clone(), file, line: line.number, column: line.column }
        });
        let stack = trail.sites(found.call);
        let stack = stack.iter().map(|site| Site { file: sources.name(site.file), line: site.line });
        Finding {
            code: found.code.id,
            name: found.code.name,
            severity: found.severity,
            message: found.text().into_owned(),
            help: found.help.clone(),
            file: sources.name(loc.file),
            line: line.number,
            column: line.column,
            end_line: line.end_line,
            end_column: line.end_column,
            block: sources.block_number(loc),
            times: found.times,
            related: related.collect(),
            stack: stack.collect(),
            alarm: found.alarm,
            answers: found.answers.iter().filter_map(|answer| Asked::new(answer, choices)).collect(),
            text: line.text,
        }
    }
}
