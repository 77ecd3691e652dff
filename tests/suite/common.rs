//! Compiles a program in memory and keeps everything that came of it.

use std::fs;
use std::path::{Path, PathBuf};

use partc::diag::{Diagnostic, Severity, render};
use partc::dialect;
use partc::driver::Session;
use partc::emit::LineMap;
use partc::ir::Origin;
use partc::machine::{Settings, config, tree};
use partc::text::{FileError, Files, Memory, Opened, Request, Sources};

/// What came of a program.
pub struct Compiled {
    /// Empty if there were errors: the driver would write nothing.
    pub output: String,
    /// What the printer had made, errors or not.
    pub attempt: String,
    pub findings: Vec<Diagnostic>,
    /// The findings, one a line.
    pub rendered: Vec<String>,
    /// Source line of each output line that a block caused.
    pub lines: Vec<(u64, String)>,
}

impl Compiled {
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|found| found.code.severity == Severity::Error)
    }

    pub fn codes(&self) -> Vec<&'static str> {
        self.findings.iter().map(|found| found.code.id).collect()
    }
}

/// Called programs lie in a folder `called` beside the case.
pub struct Beside(pub PathBuf);

impl Files for Beside {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let name = request.name.rsplit(['/', '\\']).next().unwrap_or(request.name);
        let candidates =
            std::iter::once(name.to_owned()).chain(request.extensions.iter().map(|e| format!("{name}.{e}")));
        for candidate in candidates {
            let path = self.0.join("called").join(&candidate);
            if let Ok(bytes) = fs::read(&path) {
                return Ok(Opened { name: candidate.clone(), identity: candidate, text: Box::new(Memory::new(bytes)) });
            }
        }
        Err(FileError::NotFound { tried: vec![name.to_owned()], similar: Vec::new() })
    }
}

/// Settings from the text of a `partc.toml`.
pub fn settings(text: &str) -> Settings {
    let tree = tree::parse(text, "partc.toml").unwrap_or_else(|error| panic!("{error}"));
    config::read(&tree).unwrap_or_else(|errors| panic!("{errors:?}"))
}

struct Lines<'a> {
    sources: &'a Sources,
    list: Vec<(u64, String)>,
}

impl LineMap for Lines<'_> {
    fn line(&mut self, number: u64, origin: &Origin) {
        let text = self.sources.line(origin.loc).text.trim().to_owned();
        let text =
            if origin.loc.file.0 == 0 { text } else { format!("{}: {text}", self.sources.name(origin.loc.file)) };
        self.list.push((number, text));
    }
}

/// Compiles `bytes` under a name.
pub fn compile_bytes(name: &str, bytes: Vec<u8>, dialect: &str, settings: &Settings, files: &dyn Files) -> Compiled {
    let main = Opened { name: name.to_owned(), identity: name.to_owned(), text: Box::new(Memory::new(bytes)) };
    let session = Session::new(main);
    let dialect = dialect::find(dialect).expect("a dialect of this name");
    let mut output = Vec::new();
    let mut lines = Lines { sources: &session.sources, list: Vec::new() };
    session.compile(dialect, settings, files, &mut output, Some(&mut lines)).expect("memory takes everything");
    let lines = lines.list;
    let Session { sources, diags, trail } = session;
    let findings = diags.into_sorted();
    let rendered = findings.iter().map(|found| render::concise(found, &sources, &trail)).collect();
    let attempt = String::from_utf8(output).expect("the output is ASCII");
    let failed = findings.iter().any(|found| found.code.severity == Severity::Error);
    let output = if failed { String::new() } else { attempt.clone() };
    Compiled { output, attempt, findings, rendered, lines }
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
    session.check(dialect, &Settings::default(), &partc::text::files::NoFiles);
    session.diags.into_sorted()
}

/// Dialect of a golden case: the folder under `tests/golden`.
pub fn dialect_of(path: &Path) -> String {
    let mut parts = path.components().skip_while(|part| part.as_os_str() != "golden").skip(1);
    let first = parts.next().expect("a folder under golden").as_os_str().to_string_lossy().into_owned();
    if first == "errors" { parts.next().expect("a dialect").as_os_str().to_string_lossy().into_owned() } else { first }
}

/// Compiles a golden case with the configuration beside it.
pub fn compile_case(path: &Path) -> Compiled {
    let toml = path.with_extension("toml");
    let settings = match fs::read_to_string(&toml) {
        Ok(text) => settings(&text),
        Err(_) => Settings::default(),
    };
    let name = path.file_name().expect("a file").to_string_lossy().into_owned();
    let bytes = fs::read(path).expect("a readable case");
    let folder = path.parent().expect("a folder").to_path_buf();
    compile_bytes(&name, bytes, &dialect_of(path), &settings, &Beside(folder))
}

/// All golden cases, in order.
pub fn cases(under: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(under);
    let mut folders = vec![root];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten() {
            let path = entry.expect("a readable folder").path();
            let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
            if path.is_dir() {
                if !path.ends_with("called") {
                    folders.push(path);
                }
            } else if !matches!(extension.as_str(), "snap" | "toml" | "new" | "md" | "svg") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}
