//! SARIF 2.1.0, the form that code scanning of several forges takes.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::diag::{Finding, Severity, codes};
use crate::text::decode::escaped_json;

use super::{Checked, Document, Fingerprints, full_text, path_of};

const SCHEMA: &str = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

#[derive(Debug, Default)]
pub struct Sarif {
    results: Vec<Value>,
    /// Codes that are used, and where each stands in `rules`.
    indices: BTreeMap<&'static str, usize>,
    rules: Vec<Value>,
    prints: Fingerprints,
}

impl Document for Sarif {
    fn program(&mut self, checked: &Checked) {
        for found in &checked.findings {
            let index = self.rule(found);
            let mut result = json!({
                "ruleId": found.code,
                "ruleIndex": index,
                "level": level(found.severity),
                "message": { "text": full_text(found) },
                "locations": [place(&found.file, json!({
                    "startLine": found.line,
                    "startColumn": found.column,
                    "endLine": found.end_line,
                    "endColumn": found.end_column,
                }))],
                "partialFingerprints": { "partcBlock/v1": self.prints.of(&checked.file, found) },
            });
            let related = found.related.iter().map(|other| {
                let region = json!({ "startLine": other.line, "startColumn": other.column });
                with_text(place(&other.file, region), &other.message)
            });
            let calls = found
                .stack
                .iter()
                .map(|site| with_text(place(&site.file, json!({ "startLine": site.line })), "called from here"));
            let related: Vec<Value> = related.chain(calls).collect();
            if !related.is_empty() {
                result["relatedLocations"] = json!(related);
            }
            self.results.push(result);
        }
    }

    fn finish(self: Box<Self>, troubles: &[String]) -> String {
        let notifications: Vec<Value> =
            troubles.iter().map(|text| json!({ "level": "error", "message": { "text": text } })).collect();
        let report = json!({
            "$schema": SCHEMA,
            "version": "2.1.0",
            "runs": [{
                "tool": { "driver": {
                    "name": "partc",
                    "semanticVersion": env!("CARGO_PKG_VERSION"),
                    "rules": self.rules,
                } },
                "columnKind": "unicodeCodePoints",
                "invocations": [{
                    "executionSuccessful": troubles.is_empty(),
                    "toolExecutionNotifications": notifications,
                }],
                "results": self.results,
            }],
        });
        escaped_json(&report.to_string()).into_owned() + "\n"
    }
}

impl Sarif {
    /// Where the rule of a finding stands among the rules.
    fn rule(&mut self, found: &Finding) -> usize {
        let next = self.rules.len();
        let index = *self.indices.entry(found.code).or_insert(next);
        if index == next {
            let code = codes::find(found.code);
            let title = code.map_or(found.name, |code| code.title);
            let text = code.map_or(found.name, |code| code.explain);
            self.rules.push(json!({
                "id": found.code,
                "name": found.name,
                "shortDescription": { "text": title },
                "fullDescription": { "text": text },
                "defaultConfiguration": { "level": level(code.map_or(found.severity, |code| code.severity)) },
            }));
        }
        index
    }
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

#[expect(clippy::needless_pass_by_value, reason = "the region is made for this place")]
fn place(file: &str, region: Value) -> Value {
    json!({ "physicalLocation": { "artifactLocation": { "uri": uri(file) }, "region": region } })
}

fn with_text(mut place: Value, text: &str) -> Value {
    if !text.is_empty() {
        place["message"] = json!({ "text": text });
    }
    place
}

/// A relative reference, or a `file:` URI for an absolute path.
fn uri(file: &str) -> String {
    let path = path_of(file);
    let mut uri = String::with_capacity(path.len());
    if path.starts_with('/') {
        uri.push_str("file://");
    } else if cfg!(windows) && path.as_bytes().get(1) == Some(&b':') {
        uri.push_str("file:///");
    }
    let bytes = path.as_bytes();
    for (at, byte) in bytes.iter().copied().enumerate() {
        match byte {
            // A byte of a name that is no UTF-8 is written `\xFF`; a URI has a way to say it.
            b'\\' if is_raw_byte(&bytes[at..]) => uri.push('%'),
            b'x' if at > 0 && is_raw_byte(&bytes[at - 1..]) => {}
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => uri.push(char::from(byte)),
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

/// Does a byte from 80 on begin the text, as `\xFF`?
fn is_raw_byte(text: &[u8]) -> bool {
    matches!(text, [b'\\', b'x', b'8'..=b'9' | b'A'..=b'F', b'0'..=b'9' | b'A'..=b'F', ..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_uris() {
        assert_eq!(uri("./a b/Teil_ä.H"), "a%20b/Teil_%C3%A4.H");
        assert_eq!(uri("N\\xFF\\xE4x.H"), "N%FF%E4x.H");
        assert_eq!(uri("/p/%1.H"), "file:///p/%251.H");
    }
}
