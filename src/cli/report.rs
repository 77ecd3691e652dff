//! Findings on the terminal, and the list of codes.

use std::io::{self, IsTerminal, Write};

use serde_json::json;

use crate::diag::render::terminal::Style;
use crate::diag::render::{JsonReport, concise};
use crate::diag::{Severity, codes};
use crate::driver::Session;
use crate::machine::tree::did_you_mean;

use super::args::{Color, Common, Format};
use super::{Exit, Trouble, say};

/// Collects and prints the findings of a command.
pub(super) struct Reporter {
    format: Format,
    quiet: bool,
    style: Style,
    json: JsonReport,
    errors: u32,
    warnings: u32,
    /// What is no finding in a program, such as a file that cannot be read.
    troubles: Vec<Trouble>,
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
            troubles: Vec::new(),
        }
    }

    /// Prints what a session found. Returns whether there were errors.
    pub(super) fn session(&mut self, session: Session) -> bool {
        let Session { sources, diags, trail } = session;
        let (errors, warnings, dropped) = (diags.errors(), diags.warnings(), diags.dropped());
        let mut list = diags.into_sorted();
        if self.quiet {
            list.retain(|found| found.code.severity == Severity::Error);
        }
        self.errors += errors;
        self.warnings += warnings;
        if self.format == Format::Json {
            self.json.add(&list, [errors, warnings, dropped], &sources, &trail);
            return errors > 0;
        }
        let mut out = io::stderr().lock();
        for found in &list {
            let text = match self.format {
                Format::Human => self.style.render(found, &sources, &trail),
                _ => concise(found, &sources, &trail),
            };
            let _ = writeln!(out, "{text}");
        }
        if dropped > 0 && (errors > 0 || !self.quiet) {
            let name = sources.shown(crate::text::FileId(0));
            let _ = writeln!(out, "{name}: {} not shown", counted(dropped, "more finding is", "more findings are"));
        }
        errors > 0
    }

    /// Prints trouble that is no finding; the command goes on with what is left.
    pub(super) fn trouble(&mut self, trouble: Trouble) {
        // One configuration may be at fault for many programs.
        if !self.troubles.contains(&trouble) {
            say(&format!("partc: {trouble}"));
            self.troubles.push(trouble);
        }
    }

    /// What was no finding.
    pub(super) fn troubles(&self) -> &[Trouble] {
        &self.troubles
    }

    /// Prints the end of the report.
    pub(super) fn finish(self) -> Result<Exit, Trouble> {
        let exit = match (self.troubles.is_empty(), self.errors) {
            (false, _) => Exit::Usage,
            (true, 0) => Exit::Clean,
            (true, _) => Exit::Errors,
        };
        if self.format == Format::Json {
            print(format!("{}\n", self.json.finish(&self.troubles)).as_bytes())?;
        } else if self.errors + self.warnings > 0 && !self.quiet {
            let errors = counted(self.errors, "error", "errors");
            say(&format!("{errors}, {}", counted(self.warnings, "warning", "warnings")));
        }
        Ok(exit)
    }
}

/// A number with its word: `1 error`, `2 errors`.
pub(super) fn counted(n: u32, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
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
