//! Codes on the terminal: `partc explain`, `partc rules`.

use std::io::{self, Write};

use serde_json::json;

use crate::diag::codes;
use crate::machine::tree::did_you_mean;

use super::args::ListFormat;
use super::{Exit, Trouble};

/// `partc explain CODE`
pub(super) fn explain(code: &str, format: ListFormat) -> Result<Exit, Trouble> {
    let Some(found) = codes::find(code) else {
        let all = codes::all();
        let like = did_you_mean(code, all.iter().map(|code| code.id).chain(all.iter().map(|code| code.name)));
        let hint = like.map_or("`partc rules` lists all codes".to_owned(), |like| format!("did you mean `{like}`?"));
        return Err(format!("no code `{code}`; {hint}"));
    };
    let text = if format == ListFormat::Json {
        let mut value = object(found);
        value["example"] = json!(found.example());
        format!("{value}\n")
    } else {
        let head = format!("{} {} ({})\n{}\n", found.id, found.name, found.severity.word(), found.title);
        format!("{head}\n{}\n{}", found.explain, example(found))
    };
    print(text.as_bytes())
}

/// The example of a code, its programs indented.
fn example(code: &codes::Code) -> String {
    let lines = code.example().into_iter().flat_map(str::lines);
    let shown = lines.map(|line| match line.strip_prefix("-- ") {
        Some(name) => format!("\n{name}:\n\n"),
        None => format!("    {line}").trim_end().to_owned() + "\n",
    });
    shown.collect()
}

/// `partc rules`
pub(super) fn rules(format: ListFormat) -> Result<Exit, Trouble> {
    let all = codes::all();
    let text = if format == ListFormat::Json {
        format!("{}\n", json!(all.iter().map(|code| object(code)).collect::<Vec<_>>()))
    } else {
        let width = all.iter().map(|code| code.name.len()).max().unwrap_or(0);
        all.iter()
            .map(|code| format!("{} {:7} {:width$}  {}\n", code.id, code.severity.word(), code.name, code.title))
            .collect()
    };
    print(text.as_bytes())
}

fn object(code: &codes::Code) -> serde_json::Value {
    json!({
        "code": code.id,
        "name": code.name,
        "severity": code.severity.word(),
        "title": code.title,
        "explanation": code.explain,
    })
}

/// Writes to standard output. `partc rules | head` is no trouble.
pub(super) fn print(bytes: &[u8]) -> Result<Exit, Trouble> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(format!("stdout: {error}")),
        _ => Ok(Exit::Clean),
    }
}
