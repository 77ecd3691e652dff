//! `partc targets`: the receivers, and what each can say.

use serde_json::{Map, Value, json};

use crate::target::{ALL, Target};

use super::listing::print;
use super::options::ListFormat;
use super::{Exit, Trouble};

/// Blanks between two columns.
const GAP: usize = 2;
/// Targets beside each other.
const ABREAST: usize = 4;

pub(super) fn list(format: ListFormat) -> Result<Exit, Trouble> {
    let text = if format == ListFormat::Json {
        format!("{}\n", json!(ALL.iter().map(|target| object(target)).collect::<Vec<_>>()))
    } else {
        table()
    };
    print(text.as_bytes())
}

fn object(target: &Target) -> Value {
    let abilities: Map<String, Value> =
        target.abilities().into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect();
    json!({ "name": target.name, "about": target.about, "extension": target.extension, "abilities": abilities })
}

/// A line for each target; then their abilities, some targets a table.
fn table() -> String {
    let width = ALL.iter().map(|target| target.name.len()).max().unwrap_or(0) + GAP;
    let lines = ALL.iter().map(|target| format!("{:width$}{}\n", target.name, target.about));
    lines.chain(ALL.chunks(ABREAST).map(|targets| format!("\n{}", abilities(targets)))).collect()
}

/// One column a target, one row an ability.
fn abilities(targets: &[&Target]) -> String {
    let columns: Vec<Vec<(&str, String)>> = targets.iter().map(|target| target.abilities()).collect();
    let names = columns[0].iter().map(|(name, _)| *name);
    let mut rows: Vec<Vec<&str>> = vec![[""].into_iter().chain(targets.iter().map(|target| target.name)).collect()];
    for (i, name) in names.enumerate() {
        rows.push([name].into_iter().chain(columns.iter().map(|column| column[i].1.as_str())).collect());
    }
    let widths: Vec<usize> =
        (0..rows[0].len()).map(|i| rows.iter().map(|row| row[i].len()).max().unwrap_or(0)).collect();
    let mut text = String::new();
    for row in rows {
        let line: String =
            row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}", width = width + GAP)).collect();
        text += line.trim_end();
        text.push('\n');
    }
    text
}
