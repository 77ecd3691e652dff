//! A program with what is said about it, and the commands.

use std::path::PathBuf;
use std::sync::Arc;

use partc::cli::host::{self, Asked, Opened};
use partc::diagnostics::{Finding, Severity, findings};
use partc::files::{Files, Folder, Memory, NoFiles};
use partc::languages::{self, Dialect};
use partc::output::TARGETS;
use partc::results::{Difference, Model, Options, Side, Step, Steps, is_printed, steps_of_text};
use partc::{Failure, Session};
use pyo3::prelude::*;

use crate::config::{Named, Settings};
use crate::fault::{Fault, detached};
use crate::stream::{Batches, Traced};

/// Bytes looked at to tell the language.
const HEAD: usize = 64 * 1024;
/// Bytes looked at to tell plain G-code, and its extensions.
const PLAIN_HEAD: usize = 4096;
const PLAIN: [&str; 6] = ["ngc", "gcode", "nc", "tap", "cnc", "gc"];

/// Where a program is.
#[derive(Debug, Clone)]
enum Source {
    Bytes {
        name: String,
        bytes: Arc<[u8]>,
    },
    /// On disk, with the programs and the configuration around it.
    Path(PathBuf),
}

/// A program, and what is said about it.
#[pyclass(frozen, module = "partc._partc")]
#[derive(Debug, Clone)]
pub struct Job {
    source: Source,
    files: Option<Arc<Named>>,
    settings: Option<Arc<partc::Settings>>,
    dialect: Option<String>,
    target: Option<String>,
}

/// What compiling came to.
pub struct Compiled {
    pub code: Option<String>,
    pub findings: Vec<Finding>,
    pub dropped: u32,
    /// As `partc stats` says them; nothing of a program with errors.
    pub stats: Option<serde_json::Value>,
}

#[pymethods]
impl Job {
    /// Of a program on disk or of bytes with a name.
    #[new]
    #[pyo3(signature = (path, name, bytes, files, settings, dialect, target))]
    fn new(
        path: Option<PathBuf>,
        name: String,
        bytes: Option<&[u8]>,
        files: Option<Vec<(String, Vec<u8>)>>,
        settings: Option<&Settings>,
        dialect: Option<String>,
        target: Option<String>,
    ) -> PyResult<Job> {
        let files: Option<Named> =
            files.map(|files| files.into_iter().map(|(name, bytes)| (name, bytes.into())).collect());
        let source = match (path, bytes) {
            (_, Some(bytes)) => Source::Bytes { name, bytes: bytes.into() },
            (Some(path), None) => Source::Path(path),
            (None, None) => return Err(Fault::Config("there is no program".to_owned()).into()),
        };
        let settings = settings.map(|settings| settings.with(files.as_ref())).transpose()?;
        if let Some(id) = dialect.as_deref().filter(|id| languages::find(id).is_none()) {
            return Err(Fault::Config(format!("no dialect `{id}`; there are {}", dialects())).into());
        }
        if let Some(name) = target.as_deref().filter(|name| !TARGETS.iter().any(|target| target.name == *name)) {
            return Err(Fault::Config(format!("no target `{name}`; partc.targets() lists them")).into());
        }
        Ok(Job { source, files: files.map(Arc::new), settings, dialect, target })
    }

    /// Code, findings, findings that were left out, figures.
    fn compile(&self, py: Python<'_>) -> PyResult<(Option<String>, String, u32, Option<String>)> {
        detached(py, || {
            let made = self.compiled()?;
            let stats = made.stats.map(|stats| stats.to_string());
            Ok((made.code, json(&made.findings)?, made.dropped, stats))
        })
    }

    /// Findings, and how many were left out.
    fn check(&self, py: Python<'_>) -> PyResult<(String, u32)> {
        detached(py, || {
            let opened = self.open()?;
            opened.session.check(opened.dialect, &opened.settings, opened.files.as_ref());
            let dropped = opened.session.diags.dropped();
            Ok((json(&findings(opened.session))?, dropped))
        })
    }

    /// Runs the program once to see whether it has errors; moves of few rows are kept.
    fn trace(&self, py: Python<'_>, rows: usize) -> PyResult<Traced> {
        detached(py, || Traced::of(self, rows))
    }

    /// The moves in one run, which are over at the first error.
    fn stream(&self, rows: usize) -> PyResult<Batches> {
        Ok(Traced::unchecked(self, rows)?)
    }

    /// The picture, and the findings.
    fn plot(&self, py: Python<'_>, view: Option<&str>, dimensions: bool) -> PyResult<(Option<String>, String)> {
        let view = match view {
            None => None,
            Some("xy") => Some(Side::Xy),
            Some("xz") => Some(Side::Xz),
            Some("yz") => Some(Side::Yz),
            Some("iso") => Some(Side::Iso),
            Some(view) => return Err(Fault::Config(format!("no view `{view}`; there are xy, xz, yz, iso")).into()),
        };
        detached(py, || {
            let opened = self.open()?;
            let mut picture = Vec::new();
            let options = Options { view, dimensions, ..Options::default() };
            let files = opened.files.as_ref();
            let made = opened.session.plot(opened.dialect, &opened.settings, files, options, &mut picture);
            made.map_err(|error| Fault::Internal(error.to_string()))?;
            let picture = if opened.session.diags.has_errors() { None } else { String::from_utf8(picture).ok() };
            Ok((picture, json(&findings(opened.session))?))
        })
    }
}

impl Job {
    /// Of a row of a table.
    pub fn of_bytes(
        name: &str,
        bytes: &[u8],
        files: Option<Named>,
        settings: Option<&Settings>,
        (dialect, target): (Option<String>, Option<String>),
    ) -> Result<Job, Fault> {
        let settings = settings.map(|settings| settings.with(files.as_ref())).transpose()?;
        let source = Source::Bytes { name: name.to_owned(), bytes: bytes.into() };
        Ok(Job { source, files: files.map(Arc::new), settings, dialect, target })
    }

    pub fn open(&self) -> Result<Opened, Fault> {
        let asked = Asked {
            settings: self.settings.as_deref(),
            dialect: self.dialect.as_deref(),
            target: self.target.as_deref(),
        };
        let (name, bytes) = match &self.source {
            // The command line says how to say it there.
            Source::Path(path) => {
                return host::open(path, &asked)
                    .map_err(|trouble| Fault::Config(trouble.replace("Say `--dialect ", "Say `dialect=")));
            }
            Source::Bytes { name, bytes } => (name, bytes),
        };
        let mut settings = asked.settings.cloned().unwrap_or_default();
        if let Some(name) = asked.target {
            let found = TARGETS.iter().find(|target| target.name == name);
            settings.output.target = found.ok_or_else(|| Fault::Config(format!("no target `{name}`")))?;
        }
        let dialect = self.language(name, bytes)?;
        let text = Box::new(Memory::new(Arc::clone(bytes)));
        let session = Session::new(partc::files::Opened { name: name.clone(), identity: name.clone(), text });
        let files: Box<dyn Files> = match &self.files {
            None => Box::new(NoFiles),
            Some(named) => {
                let mut folder = Folder::default();
                named.iter().for_each(|(name, bytes)| folder.add(name, Arc::clone(bytes)));
                Box::new(folder)
            }
        };
        Ok(Opened { session, dialect, settings, files })
    }

    fn language(&self, name: &str, bytes: &[u8]) -> Result<&'static Dialect, Fault> {
        if let Some(id) = &self.dialect {
            return languages::find(id).ok_or_else(|| Fault::Config(format!("no dialect `{id}`")));
        }
        languages::guess(name, &bytes[..bytes.len().min(HEAD)])
            .ok_or_else(|| Fault::Config(format!("which language is `{name}`? Say dialect=; there are {}", dialects())))
    }

    pub fn compiled(&self) -> Result<Compiled, Fault> {
        let opened = self.open()?;
        let Opened { session, dialect, settings, files } = &opened;
        let mut code = Vec::new();
        let counted = session.compile_counted(dialect, settings, files.as_ref(), &mut code, Model::default());
        let stats = counted.map_err(|failure| match failure {
            Failure::Mismatch(mismatch) => Fault::Internal(mismatch.to_string()),
            Failure::Output(error) => Fault::Internal(error.to_string()),
        })?;
        let failed = session.diags.has_errors();
        let code = if failed { None } else { String::from_utf8(code).ok() };
        let dropped = session.diags.dropped();
        let stats = (!failed).then(|| stats.object());
        Ok(Compiled { code, findings: findings(opened.session), dropped, stats })
    }

    /// The steps of the program, or of plain G-code; findings where it has errors.
    fn steps(&self, tolerance: f64) -> Result<(Vec<Step>, bool, Vec<Finding>), Fault> {
        if let Some(text) = self.plain()? {
            let steps =
                steps_of_text(&text, tolerance).map_err(|stop| Fault::Config(format!("{}: {stop}", self.name())))?;
            return Ok((steps, true, Vec::new()));
        }
        let opened = self.open()?;
        let mut steps = Steps::of_program(tolerance, &opened.dialect.settings(&opened.settings));
        opened.session.lower(opened.dialect, &opened.settings, opened.files.as_ref(), &mut steps);
        let ok = !opened.session.diags.has_errors();
        Ok((steps.finish(), ok, findings(opened.session)))
    }

    /// The text of plain G-code: by its head, or by its extension where no language knows it.
    fn plain(&self) -> Result<Option<Vec<u8>>, Fault> {
        if self.dialect.is_some() {
            return Ok(None);
        }
        let text = match &self.source {
            Source::Bytes { bytes, .. } => bytes.to_vec(),
            Source::Path(path) => {
                std::fs::read(path).map_err(|error| Fault::Config(format!("{}: {error}", path.display())))?
            }
        };
        let name = self.name();
        let head = &text[..text.len().min(PLAIN_HEAD)];
        let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_lowercase());
        let named = extension.is_some_and(|extension| PLAIN.contains(&extension.as_str()));
        let is_plain = is_printed(head) || languages::guess(&name, head).map_or(named, |dialect| dialect.id == "gcode");
        Ok(is_plain.then_some(text))
    }

    pub fn name(&self) -> String {
        match &self.source {
            Source::Bytes { name, .. } => name.clone(),
            Source::Path(path) => path.to_string_lossy().into_owned(),
        }
    }
}

/// Two programs as motion: whether both have no errors, the comparison as JSON and as text, findings.
#[pyfunction]
pub fn diff(py: Python<'_>, a: &Job, b: &Job, tolerance: f64) -> PyResult<(bool, String, String, String)> {
    if !(tolerance.is_finite() && tolerance >= 0.0) {
        return Err(Fault::Config("the tolerance is a number of mm, not below zero".to_owned()).into());
    }
    detached(py, || {
        let names = [a.name(), b.name()];
        let names = [names[0].as_str(), names[1].as_str()];
        let ((a, a_ok, mut found), (b, b_ok, more)) = (a.steps(tolerance)?, b.steps(tolerance)?);
        found.extend(more);
        if !(a_ok && b_ok) {
            return Ok((false, "null".to_owned(), String::new(), json(&found)?));
        }
        let difference = Difference::between(&a, &b, tolerance);
        let text = difference.text(&a, &b, names);
        Ok((true, difference.json(&a, &b, names).to_string(), text, json(&found)?))
    })
}

fn dialects() -> String {
    languages::ALL.iter().map(|dialect| dialect.id).collect::<Vec<_>>().join(", ")
}

/// As a line of text.
pub fn first_error(session: Session) -> Option<String> {
    let found = findings(session).into_iter().find(|found| found.severity == Severity::Error)?;
    let Finding { file, line, column, code, message, .. } = found;
    Some(format!("{file}:{line}:{column}: error[{code}]: {message}"))
}

pub fn json(findings: &[Finding]) -> Result<String, Fault> {
    serde_json::to_string(findings).map_err(|error| Fault::Internal(error.to_string()))
}
