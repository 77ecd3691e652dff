//! Compiles a program in memory and keeps everything that came of it.

use partc::internals::diag::{Diagnostic, Severity, render};
use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::emit::LineMap;
use partc::internals::ir::Origin;
use partc::internals::machine::{Settings, config, tree};
use partc::internals::text::{Files, Loc, Memory, Opened, Sources};

/// What came of a program.
pub struct Compiled {
    /// Empty if there were errors: the driver would write nothing.
    pub output: String,
    /// What the printer had made, errors or not.
    pub attempt: String,
    pub findings: Vec<Diagnostic>,
    /// The findings, one a line.
    pub rendered: Vec<String>,
    /// The block of each output line that has one.
    pub lines: Vec<Line>,
    /// The blocks of the findings.
    pub found_in: Vec<String>,
}

/// The block that an output line comes from.
#[derive(Debug, Clone)]
pub struct Line {
    /// Number of the output line, from 1.
    pub number: u64,
    /// File and line of the block.
    pub at: (u16, u32),
    /// Its text; of a called program with the name in front.
    pub text: String,
}

impl Compiled {
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|found| found.code.severity == Severity::Error)
    }

    pub fn codes(&self) -> Vec<&'static str> {
        self.findings.iter().map(|found| found.code.id).collect()
    }
}

/// Settings from the text of a `partc.toml`.
pub fn settings(text: &str) -> Settings {
    let tree = tree::parse(text, "partc.toml").unwrap_or_else(|error| panic!("{error}"));
    config::read(&tree).unwrap_or_else(|errors| panic!("{errors:?}"))
}

struct Lines<'a> {
    sources: &'a Sources,
    list: Vec<Line>,
}

/// The block at a place; of a called program with the name in front.
fn block(sources: &Sources, loc: Loc) -> String {
    let text = sources.line(loc).text.trim().to_owned();
    if loc.file.0 == 0 { text } else { format!("{}: {text}", sources.name(loc.file)) }
}

impl LineMap for Lines<'_> {
    fn line(&mut self, number: u64, origin: &Origin) {
        let at = (origin.loc.file.0, origin.loc.line);
        self.list.push(Line { number, at, text: block(self.sources, origin.loc) });
    }
}

/// Compiles `bytes` under a name.
pub fn compile_bytes(name: &str, bytes: Vec<u8>, dialect: &str, settings: &Settings, files: &dyn Files) -> Compiled {
    let main = Opened { name: name.to_owned(), identity: name.to_owned(), text: Box::new(Memory::new(bytes)) };
    let session = Session::new(main);
    let dialect = dialect::find(dialect).expect("a dialect of this name");
    let mut output = Vec::new();
    let sources = session.sources.clone();
    let mut lines = Lines { sources: &sources, list: Vec::new() };
    session.compile(dialect, settings, files, &mut output, Some(&mut lines)).expect("memory takes everything");
    finished(session, output, lines.list)
}

/// Compiles `bytes`, and finds what `partc check` finds in them.
pub fn compile_checked(name: &str, bytes: &[u8], dialect: &str, settings: &Settings, files: &dyn Files) -> Compiled {
    let compiled = compile_bytes(name, bytes.to_vec(), dialect, settings, files);
    let main = Opened { name: name.to_owned(), identity: name.to_owned(), text: Box::new(Memory::new(bytes.to_vec())) };
    let session = Session::new(main);
    session.check(dialect::find(dialect).expect("a dialect of this name"), settings, files);
    let Compiled { findings, rendered, found_in, .. } = finished(session, Vec::new(), Vec::new());
    Compiled { findings, rendered, found_in, ..compiled }
}

fn finished(session: Session, output: Vec<u8>, lines: Vec<Line>) -> Compiled {
    let Session { sources, diags, trail } = session;
    let findings = diags.into_sorted();
    let found_in = findings.iter().map(|found| block(&sources, found.label.loc)).collect();
    let rendered = findings.iter().map(|found| render::concise(found, &sources, &trail)).collect();
    let attempt = String::from_utf8(output).expect("the output is ASCII");
    let failed = findings.iter().any(|found| found.code.severity == Severity::Error);
    let output = if failed { String::new() } else { attempt.clone() };
    Compiled { output, attempt, findings, rendered, lines, found_in }
}

/// The findings of `partc check` for a Klartext program, one a line.
pub fn check_klartext(text: &str) -> Vec<Diagnostic> {
    check_program("klartext", "PART.H", text)
}

/// Findings of `partc check` in the program `text`.
pub fn check_program(dialect: &str, name: &str, text: &str) -> Vec<Diagnostic> {
    let main = Opened {
        name: name.to_owned(),
        identity: name.to_owned(),
        text: Box::new(Memory::new(text.as_bytes().to_vec())),
    };
    let session = Session::new(main);
    let dialect = dialect::find(dialect).expect("a dialect of this name");
    session.check(dialect, &Settings::default(), &partc::internals::text::files::NoFiles);
    session.diags.into_sorted()
}
