//! Codes, targets, and the command line itself.

use std::ffi::OsString;

use partc::cli::host;
use partc::diagnostics::codes;
use partc::output::TARGETS;
use pyo3::prelude::*;
use serde_json::{Map, Value, json};

use crate::fault::{Fault, detached};

/// A code as JSON.
#[pyfunction]
pub fn explain(code: &str) -> PyResult<String> {
    let found = codes::find(code).or_else(|| codes::find(&code.to_ascii_uppercase()));
    let found = found.or_else(|| codes::all().into_iter().find(|found| found.name == code));
    let Some(found) = found else { return Err(Fault::Config(format!("no code `{code}`")).into()) };
    let code = json!({
        "code": found.id,
        "name": found.name,
        "severity": found.severity.word(),
        "title": found.title,
        "text": found.explain,
        "example": found.example(),
    });
    Ok(code.to_string())
}

/// The targets as JSON, as `partc targets --format json`.
#[pyfunction]
pub fn targets() -> String {
    let object = |target: &&partc::output::Target| {
        let abilities: Map<String, Value> =
            target.abilities().into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect();
        json!({ "name": target.name, "about": target.about, "extension": target.extension, "abilities": abilities })
    };
    json!(TARGETS.iter().map(object).collect::<Vec<_>>()).to_string()
}

/// Runs the command line; returns its exit code.
#[pyfunction]
pub fn command_line(py: Python<'_>, arguments: Vec<OsString>) -> PyResult<u8> {
    detached(py, || Ok(host::run(arguments)))
}
