//! Code Quality report of GitLab.

use serde_json::{Value, json};

use crate::diag::Severity;
use crate::text::decode::escaped_json;

use super::{Checked, Document, Fingerprints, full_text, path_of};

/// The program that calls the file of an issue; receivers pass over what they do not know.
pub(super) const PROGRAM: &str = "partc_program";

#[derive(Debug, Default)]
pub struct GitLab {
    issues: Vec<Value>,
    prints: Fingerprints,
}

impl Document for GitLab {
    fn program(&mut self, checked: &Checked) {
        for found in &checked.findings {
            let severity = match found.severity {
                Severity::Error => "critical",
                Severity::Warning => "minor",
                Severity::Note => "info",
            };
            let mut issue = json!({
                "description": format!("{}: {}", found.code, full_text(found)),
                "check_name": found.code,
                "fingerprint": self.prints.of(&checked.file, found),
                "severity": severity,
                "location": {
                    "path": path_of(&found.file),
                    "lines": { "begin": found.line, "end": found.end_line },
                },
            });
            // Shards are put together by their programs.
            if found.file != checked.file {
                issue[PROGRAM] = json!(path_of(&checked.file));
            }
            self.issues.push(issue);
        }
    }

    fn finish(self: Box<Self>, _: &[String]) -> String {
        escaped_json(&Value::Array(self.issues).to_string()).into_owned() + "\n"
    }
}
