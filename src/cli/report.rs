//! Findings on the terminal, and the list of codes.

use std::io::{self, IsTerminal, Write};

use serde_json::json;

use crate::diag::render::terminal::Style;
use crate::diag::render::{JsonReport, concise};
use crate::diag::{Severity, codes};
use crate::driver::Session;
use crate::machine::tree::did_you_mean;

use super::args::{Color, Common, Format};
use super::{Exit, Trouble};

/// Collects and prints the findings of a command.
pub(super) struct Reporter {
    format: Format,
    quiet: bool,
    style: Style,
    json: JsonReport,
    errors: u32,
    warnings: u32,
}

impl Reporter {
    pub(super) fn new(common: &Common) -> Reporter {
        let terminal = io::stderr().is_terminal();
        let color = match common.color {
            Color::Always => true,
            Color::Never => false,
            Color::Auto => terminal && std::env::var_os("NO_COLOR").is_none(),
        };
        Reporter {
            format: common.format,
            quiet: common.quiet,
            style: Style::new(color, 100),
            json: JsonReport::default(),
            errors: 0,
            warnings: 0,
        }
    }

    /// Prints what a session found. Returns whether there were errors.
    pub(super) fn session(&mut self, session: Session) -> bool {
        let Session { sources, diags, trail } = session;
        let (errors, warnings) = (diags.errors(), diags.warnings());
        let list = diags.into_sorted();
        self.errors += errors;
        self.warnings += warnings;
        let shown = list.iter().filter(|found| !self.quiet || found.code.severity == Severity::Error);
        let stderr = io::stderr();
        let mut out = stderr.lock();
        match self.format {
            Format::Json => self.json.add(&list, errors, warnings, &sources, &trail),
            Format::Concise => {
                for found in shown {
                    let _ = writeln!(out, "{}", concise(found, &sources, &trail));
                }
            }
            Format::Human => {
                for found in shown {
                    let _ = writeln!(out, "{}", self.style.render(found, &sources, &trail));
                }
            }
        }
        errors > 0
    }

    /// Prints the end of the report.
    pub(super) fn finish(self) -> Result<Exit, Trouble> {
        let exit = if self.errors > 0 { Exit::Errors } else { Exit::Clean };
        if self.format == Format::Json {
            let text = self.json.finish();
            writeln!(io::stdout().lock(), "{text}").map_err(|error| format!("stdout: {error}"))?;
        } else if self.errors + self.warnings > 0 && !self.quiet {
            eprintln!("{} errors, {} warnings", self.errors, self.warnings);
        }
        Ok(exit)
    }
}

/// `partc explain CODE`
pub(super) fn explain(code: &str, format: Format) -> Result<Exit, Trouble> {
    let Some(found) = codes::find(code) else {
        let all = codes::all();
        let like = did_you_mean(code, all.iter().map(|code| code.id).chain(all.iter().map(|code| code.name)));
        let hint = like.map_or("`partc rules` lists all codes".to_owned(), |like| format!("did you mean `{like}`?"));
        return Err(format!("no code `{code}`; {hint}"));
    };
    let text = if format == Format::Json {
        format!("{}\n", object(found))
    } else {
        format!("{} {} ({})\n{}\n\n{}\n", found.id, found.name, found.severity.word(), found.title, found.explain)
    };
    print(&text)
}

/// `partc rules`
pub(super) fn rules(format: Format) -> Result<Exit, Trouble> {
    let all = codes::all();
    let text = if format == Format::Json {
        format!("{}\n", json!(all.iter().map(|code| object(code)).collect::<Vec<_>>()))
    } else {
        let width = all.iter().map(|code| code.name.len()).max().unwrap_or(0);
        all.iter()
            .map(|code| format!("{} {:7} {:width$}  {}\n", code.id, code.severity.word(), code.name, code.title))
            .collect()
    };
    print(&text)
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

fn print(text: &str) -> Result<Exit, Trouble> {
    match io::stdout().lock().write_all(text.as_bytes()) {
        // `partc rules | head` is no trouble.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(format!("stdout: {error}")),
        _ => Ok(Exit::Clean),
    }
}
