//! The commands that work on programs.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::dialect::{self, Dialect};
use crate::driver::Session;
use crate::emit::LineMap;
use crate::ir::Origin;
use crate::machine::Settings;
use crate::text::decode::escaped_json;
use crate::text::{FileId, Span};

use super::args::{Check, Common, Compile, Format, Trace};
use super::disk::{IncludeRoots, file_name, open_main, walk};
use super::output::{Destination, MAP_MARK, Made, Progress, is_foreign, set_aside};
use super::report::Reporter;
use super::{Exit, Trouble, config, say};

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
    let place = common.stdin_filename.as_deref().filter(|_| path == Path::new("-")).unwrap_or(path);
    let base = match place.parent() {
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
    let streams = [
        (args.inputs.iter().any(|input| to_stdout(input)), "the program"),
        (args.map.as_deref() == Some(Path::new("-")), "the source map"),
        (args.common.format == Format::Json, "the JSON findings"),
    ];
    let streams: Vec<&str> = streams.iter().filter(|(used, _)| *used).map(|(_, what)| *what).collect();
    if streams.len() > 1 {
        return Err(format!("{} cannot all go to standard output; name a file", streams.join(" and ")));
    }
    different_outputs(args)?;
    if let Some(folder) = &args.out_dir {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let mut reporter = Reporter::new(&args.common);
    for input in &args.inputs {
        // One program that cannot be read does not stop the others.
        if let Err(trouble) = compile_one(input, args, &mut reporter) {
            reporter.trouble(trouble);
        }
    }
    reporter.finish()
}

/// Each input needs an output of its own.
fn different_outputs(args: &Compile) -> Result<(), Trouble> {
    if args.inputs.len() < 2 {
        return Ok(());
    }
    let mut taken: BTreeMap<PathBuf, &Path> = BTreeMap::new();
    for input in &args.inputs {
        // A configuration that cannot be read is reported with its program.
        let Ok(settings) = config::settings(input, &args.common) else { continue };
        let output = output_path(input, args, settings.output.target.extension);
        if let Some(first) = taken.insert(real(&output), input) {
            let (first, second) = (first.display(), input.display());
            return Err(format!("{first} and {second} would both be written to {}", output.display()));
        }
    }
    Ok(())
}

/// The one path of a file that may not exist yet.
fn real(path: &Path) -> PathBuf {
    if let Ok(path) = fs::canonicalize(path) {
        return path;
    }
    let folder = path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf()).join(file_name(path))
}

/// Refuses to write over an input, or over a file of somebody else.
fn may_write(path: &Path, made: Made, args: &Compile) -> Result<(), Trouble> {
    let shown = path.display();
    if args.inputs.iter().any(|input| same_file(input, path)) {
        let what = if made == Made::Map { "source map" } else { "output" };
        return Err(format!("{shown}: the {what} would replace the input"));
    }
    if is_foreign(path, made) && !args.force {
        return Err(format!("{shown}: not written by partc; use --force to replace it, or another name"));
    }
    Ok(())
}

fn compile_one(input: &Path, args: &Compile, reporter: &mut Reporter) -> Result<(), Trouble> {
    let Loaded { session, dialect, settings, files } = load(input, &args.common)?;
    let target = output_path(input, args, settings.output.target.extension);
    let shown = target.display().to_string();
    let trouble = |error: io::Error| format!("{shown}: {error}");
    may_write(&target, Made::Program, args)?;
    if let Some(path) = &args.map {
        if real(path) == real(&target) && path != Path::new("-") {
            return Err(format!("{}: output and source map need different files", path.display()));
        }
        may_write(path, Made::Map, args)?;
    }
    let map_trouble = |error: io::Error| {
        let path = args.map.as_deref().unwrap_or(Path::new("-"));
        format!("{}: {error}", path.display())
    };
    let mut out = Progress::new(Destination::open(&target).map_err(trouble)?);
    let mut map = match &args.map {
        Some(path) => Some(SourceMap::create(path, &target, &session).map_err(map_trouble)?),
        None => None,
    };
    let line_map = map.as_mut().map(|map| map as &mut dyn LineMap);
    let result = session.compile(dialect, &settings, &files, &mut out, line_map);
    let out = out.into_inner();
    let failed = session.diags.has_errors();
    let map = map.map(SourceMap::finish);
    if !failed {
        result.map_err(trouble)?;
        if let Some(map) = map {
            map.and_then(Destination::commit).or_else(ignore_closed_pipe).map_err(map_trouble)?;
        }
        out.commit().or_else(ignore_closed_pipe).map_err(trouble)?;
    } else {
        drop((out, map));
        if let Some(stale) = set_aside(&target, Made::Program).map_err(trouble)? {
            say(&format!("partc: the older {shown} was renamed to {}", stale.display()));
        }
        if let Some(path) = &args.map
            && let Some(stale) = set_aside(path, Made::Map).map_err(map_trouble)?
        {
            say(&format!("partc: the older {} was renamed to {}", path.display(), stale.display()));
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
        let inputs = if path == Path::new("-") { Ok(vec![path.clone()]) } else { walk(path, &takes) };
        match inputs {
            Ok(inputs) => inputs.iter().for_each(|input| check_one(input, &args.common, &mut reporter)),
            Err(error) => reporter.trouble(format!("{}: {error}", path.display())),
        }
    }
    reporter.finish()
}

fn check_one(input: &Path, common: &Common, reporter: &mut Reporter) {
    match load(input, common) {
        Ok(Loaded { session, dialect, settings, files }) => {
            session.check(dialect, &settings, &files);
            reporter.session(session);
        }
        Err(trouble) => reporter.trouble(trouble),
    }
}

/// A file whose extension or content some dialect knows.
pub(super) fn is_program(path: &Path) -> bool {
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
    let mut writer = BufWriter::new(&mut held);
    let result = session.trace(dialect, &settings, &files, &mut writer).and_then(|()| writer.flush());
    drop(writer);
    if !session.diags.has_errors() {
        result.and_then(|()| held.commit()).or_else(ignore_closed_pipe).map_err(|error| format!("stdout: {error}"))?;
    }
    reporter.session(session);
    reporter.finish()
}

/// The source map: a JSON document with one object for each output line that a block caused.
struct SourceMap<'a> {
    out: BufWriter<Destination>,
    session: &'a Session,
    first: bool,
    error: Option<io::Error>,
}

impl<'a> SourceMap<'a> {
    fn create(path: &Path, output: &Path, session: &'a Session) -> io::Result<SourceMap<'a>> {
        let mut out = BufWriter::new(Destination::open(path)?);
        let output = json!(file_name(output));
        let output = output.to_string();
        write!(out, "{MAP_MARK}{},\"lines\":[", escaped_json(&output))?;
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
        write!(self.out, "{comma}{}", escaped_json(&line.to_string()))
    }

    fn finish(mut self) -> io::Result<Destination> {
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
