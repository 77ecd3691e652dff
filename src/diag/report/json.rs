//! One JSON object.

use serde_json::json;

use crate::diag::Finding;
use crate::text::decode::escaped_json;

use super::{Checked, Counts, Document};

#[derive(Debug, Default)]
pub struct Json {
    diagnostics: Vec<Finding>,
    files: u32,
    counts: Counts,
}

impl Document for Json {
    fn program(&mut self, checked: &Checked) {
        self.files += 1;
        self.counts.add(&checked.counts);
        self.diagnostics.extend_from_slice(&checked.findings);
    }

    fn finish(self: Box<Self>, troubles: &[String]) -> String {
        let mut report = json!({
            "version": 1,
            "diagnostics": self.diagnostics,
            "files": self.files,
            "errors": self.counts.errors,
            "warnings": self.counts.warnings,
        });
        if self.counts.not_shown > 0 {
            report["not_shown"] = json!(self.counts.not_shown);
        }
        if !troubles.is_empty() {
            report["troubles"] = json!(troubles);
        }
        escaped_json(&report.to_string()).into_owned() + "\n"
    }
}
