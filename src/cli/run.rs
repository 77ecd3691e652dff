//! The commands that work on programs.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::dialect::{self, Dialect};
use crate::driver::Session;
use crate::emit::{LineMap, Output, targets};
use crate::ir::Origin;
use crate::machine::Settings;
use crate::text::{FileId, Span};

use super::args::{Check, Common, Compile, Format, Trace};
use super::disk::{IncludeRoots, file_name, open_main, walk};
use super::output::{Destination, Pending, Progress, is_ours, set_aside};
use super::report::Reporter;
use super::{Exit, Trouble, config};

/// A program with everything that is needed to run it.
pub(super) struct Loaded {
    pub session: Session,
    pub dialect: &'static Dialect,
    pub settings: Settings,
    pub files: IncludeRoots,
}

/// Bytes looked at to tell the dialect.
const HEAD: u32 = 64 * 1024;

pub(super) fn load(path: &Path, common: &Common) -> Result<Loaded, Trouble> {
    let shown = path.display().to_string();
    let settings =
        config::settings(common.stdin_filename.as_deref().filter(|_| path == Path::new("-")).unwrap_or(path), common)?;
    let main = open_main(path, common.stdin_filename.as_deref()).map_err(|error| format!("{shown}: {error}"))?;
    let name = main.name.clone();
    let session = Session::new(main);
    let dialect = if common.dialect == "auto" {
        let head = session.sources.bytes(FileId(0), Span { start: 0, end: HEAD });
        dialect::guess(&name, &head)
            .ok_or_else(|| format!("{shown}: which language is this? Say `--dialect klartext`"))?
    } else {
        dialect::find(&common.dialect).ok_or_else(|| format!("no dialect `{}`", common.dialect))?
    };
    let base = match path.parent() {
        _ if path == Path::new("-") => PathBuf::from("."),
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
        _ => PathBuf::from("."),
    };
    let files = IncludeRoots::new(base, settings.include.roots.clone());
    Ok(Loaded { session, dialect, settings, files })
}

/// `partc compile`
pub(super) fn compile(args: &Compile) -> Result<Exit, Trouble> {
    if args.inputs.len() > 1 && args.output.is_some() {
        return Err("several inputs cannot go to one output; use --out-dir".to_owned());
    }
    if args.inputs.len() > 1 && args.map.is_some() {
        return Err("a source map belongs to one input".to_owned());
    }
    let to_stdout = |input: &Path| match &args.output {
        Some(output) => output == Path::new("-"),
        None => input == Path::new("-") && args.out_dir.is_none(),
    };
    if args.common.format == Format::Json && args.inputs.iter().any(|input| to_stdout(input)) {
        return Err("the program and the JSON findings cannot both go to standard output; use -o FILE".to_owned());
    }
    if let Some(folder) = &args.out_dir {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let mut reporter = Reporter::new(&args.common);
    for input in &args.inputs {
        compile_one(input, args, &mut reporter)?;
    }
    reporter.finish()
}

fn compile_one(input: &Path, args: &Compile, reporter: &mut Reporter) -> Result<(), Trouble> {
    let Loaded { session, dialect, settings, files } = load(input, &args.common)?;
    let traits =
        targets::find(&settings.output.target).ok_or_else(|| format!("no target `{}`", settings.output.target))?;
    let target = output_path(input, args, traits.extension);
    let shown = target.display().to_string();
    let trouble = |error: io::Error| format!("{shown}: {error}");
    if same_file(input, &target) {
        return Err(format!("{shown}: the output would replace the input"));
    }
    let foreign = target.is_file() && args.output.is_none() && !is_ours(&target);
    if foreign && !args.force {
        return Err(format!("{shown}: not written by partc; use --force to replace it, or -o for another name"));
    }
    let mut out = Progress::new(Destination::open(&target).map_err(trouble)?);
    let mut map = match &args.map {
        Some(path) => {
            Some(SourceMap::create(path, &target, &session).map_err(|error| format!("{}: {error}", path.display()))?)
        }
        None => None,
    };
    let line_map = map.as_mut().map(|map| map as &mut dyn LineMap);
    let result = session.compile(dialect, &settings, &files, &mut out, line_map);
    let out = out.into_inner();
    let failed = session.diags.has_errors();
    let map = map.map(SourceMap::finish);
    if !failed {
        result.map_err(trouble)?;
        if let (Some(map), Some(path)) = (map, &args.map) {
            map.and_then(Pending::commit).map_err(|error| format!("{}: {error}", path.display()))?;
        }
        out.commit().or_else(ignore_closed_pipe).map_err(trouble)?;
    } else {
        drop(out);
        if let Some(stale) = set_aside(&target).map_err(trouble)? {
            eprintln!("partc: the older {shown} was renamed to {}", stale.display());
        }
    }
    reporter.session(session);
    Ok(())
}

/// A reader that has seen enough is no trouble.
pub(super) fn ignore_closed_pipe(error: io::Error) -> io::Result<()> {
    if error.kind() == io::ErrorKind::BrokenPipe { Ok(()) } else { Err(error) }
}

fn output_path(input: &Path, args: &Compile, extension: &str) -> PathBuf {
    if let Some(output) = &args.output {
        return output.clone();
    }
    let stdin = input == Path::new("-");
    let name = match &args.common.stdin_filename {
        Some(name) if stdin => file_name(name),
        _ if stdin => "stdin".to_owned(),
        _ => file_name(input),
    };
    let name = Path::new(&name).with_extension(extension);
    match &args.out_dir {
        Some(folder) => folder.join(name),
        None if stdin => PathBuf::from("-"),
        None => input.with_file_name(name),
    }
}

pub(super) fn same_file(a: &Path, b: &Path) -> bool {
    match (fs::canonicalize(a), fs::canonicalize(b)) {
        (Ok(a), Ok(b)) => a == b && a.is_file(),
        _ => false,
    }
}

/// `partc check`
pub(super) fn check(args: &Check) -> Result<Exit, Trouble> {
    let mut reporter = Reporter::new(&args.common);
    let takes = |path: &Path| is_program(path);
    for path in &args.paths {
        let inputs = if path == Path::new("-") {
            vec![path.clone()]
        } else {
            walk(path, &takes).map_err(|error| format!("{}: {error}", path.display()))?
        };
        for input in inputs {
            let Loaded { session, dialect, settings, files } = load(&input, &args.common)?;
            session.check(dialect, &settings, &files);
            reporter.session(session);
        }
    }
    reporter.finish()
}

/// A file whose extension or content some dialect knows.
fn is_program(path: &Path) -> bool {
    let Ok(main) = open_main(path, None) else { return false };
    let name = main.name.clone();
    let session = Session::new(main);
    let head = session.sources.bytes(FileId(0), Span { start: 0, end: HEAD });
    dialect::guess(&name, &head).is_some()
}

/// `partc trace`
pub(super) fn trace(args: &Trace) -> Result<Exit, Trouble> {
    if args.common.format == Format::Json {
        return Err("the moves and the JSON findings cannot both go to standard output".to_owned());
    }
    let Loaded { session, dialect, settings, files } = load(&args.input, &args.common)?;
    let mut reporter = Reporter::new(&args.common);
    // Moves of a program with errors are not shown: they end where nobody knows.
    let mut held = Destination::open(Path::new("-")).map_err(|error| format!("stdout: {error}"))?;
    let mut writer = BufWriter::new(Appender(&mut held));
    let result = session.trace(dialect, &settings, &files, &mut writer).and_then(|()| writer.flush());
    drop(writer);
    if !session.diags.has_errors() {
        result.and_then(|()| held.commit()).or_else(ignore_closed_pipe).map_err(|error| format!("stdout: {error}"))?;
    }
    reporter.session(session);
    reporter.finish()
}

/// An output as a writer.
struct Appender<'a>(&'a mut Destination);

impl Write for Appender<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.append(bytes).map(|()| bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The source map: a JSON document with one object for each output line that a block caused.
struct SourceMap<'a> {
    out: BufWriter<Pending>,
    session: &'a Session,
    first: bool,
    error: Option<io::Error>,
}

impl<'a> SourceMap<'a> {
    fn create(path: &Path, output: &Path, session: &'a Session) -> io::Result<SourceMap<'a>> {
        let mut out = BufWriter::new(Pending::create(path)?);
        let output = json!(file_name(output));
        write!(out, "{{\"version\":1,\"output\":{output},\"lines\":[")?;
        Ok(SourceMap { out, session, first: true, error: None })
    }

    fn write(&mut self, number: u64, origin: &Origin) -> io::Result<()> {
        let sources = &self.session.sources;
        let stack: Vec<_> = self
            .session
            .trail
            .sites(origin.call)
            .iter()
            .map(|site| json!({ "file": sources.name(site.file), "line": site.line }))
            .collect();
        let comma = if std::mem::take(&mut self.first) { "\n" } else { ",\n" };
        let file = sources.name(origin.loc.file);
        let line = json!({ "line": number, "file": file, "source_line": origin.loc.line, "stack": stack });
        write!(self.out, "{comma}{line}")
    }

    fn finish(mut self) -> io::Result<Pending> {
        if let Some(error) = self.error {
            return Err(error);
        }
        writeln!(self.out, "\n]}}")?;
        self.out.into_inner().map_err(io::IntoInnerError::into_error)
    }
}

impl LineMap for SourceMap<'_> {
    fn line(&mut self, number: u64, origin: &Origin) {
        if self.error.is_none()
            && let Err(error) = self.write(number, origin)
        {
            self.error = Some(error);
        }
    }
}
