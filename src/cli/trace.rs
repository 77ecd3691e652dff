//! `partc trace`

use std::collections::BTreeSet;
use std::io::{self, BufWriter, IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};

use crate::dialect::Dialect;
use crate::driver::Session;
use crate::emit::stats::Model;
use crate::machine::Settings;
use crate::text::Files;

use super::args::Trace;
use super::closure::Targets;
use super::inputs::Input;
use super::made::{Made, Replaces, is_foreign};
use super::options::Format;
use super::output::{Destination, ignore_closed_pipe, set_aside};
use super::paths::{real, same_file};
use super::program::{Loaded, load};
use super::progress::Ticker;
use super::report::{Reporter, Stdout};
use super::{Exit, Trouble, say};

/// What a build without the feature says of Arrow and Parquet.
const NOT_BUILT: &str = "this partc was built without the files of Arrow and Parquet, which take long to build; take csv or jsonl, or build it with \
                         them: `cargo install --path . --profile dist --features columns`";

/// What is said of a table that cannot be written.
const WHOLE: &str = "partc: no table was written: it could not say that its moves stop at the first error. Take \
                     `--format jsonl`, whose last line does";

/// Writes the moves of one program. Those of a program with errors end at the first one: as JSON Lines, with a line that says
/// so. A table has no place for that.
pub(super) fn trace(args: &Trace) -> Result<Exit, Trouble> {
    let target = args.output.clone().unwrap_or_else(|| PathBuf::from("-"));
    let to_stdout = target == Path::new("-");
    let shown = if to_stdout { "stdout".to_owned() } else { target.display().to_string() };
    let trouble = |error: io::Error| format!("{shown}: {error}");
    let form = form(args.common.report.format, &target)?;
    if cfg!(not(feature = "columns")) && matches!(form, Format::Arrow | Format::Parquet) {
        return Err(NOT_BUILT.to_owned());
    }
    if to_stdout && io::stdout().is_terminal() && matches!(form, Format::Arrow | Format::Parquet) {
        return Err(
            "what a terminal shows of this form is no use to anybody; name a file with -o, or a pipe".to_owned()
        );
    }
    if same_file(&args.input, &target) {
        return Err(format!("{shown}: the moves would replace the program"));
    }
    if is_foreign(&target, Made::Trace) && !args.force {
        return Err(format!("{shown}: is no trace; use --force to replace it, or another name"));
    }
    let mut common = args.common.clone();
    // The others are forms of the moves.
    common.report.format = common.report.format.filter(|format| matches!(format, Format::Human | Format::Concise));
    let Loaded { session, dialect, settings, files, place } = load(&args.input, &common)?;
    let stdout = if to_stdout { Stdout::Taken } else { Stdout::Free };
    let mut reporter = Reporter::new(&common, &args.findings, stdout, None);
    reporter.spares(&[Input::named(&args.input)], &BTreeSet::from([real(&target)]))?;
    args.deps.spares(&[&args.input], &BTreeSet::from([real(&target)]), &reporter)?;
    let targets = Targets::new([target.as_path()].into_iter().chain(reporter.files()).chain(args.deps.file()));
    let out = Destination::open_for(&target, Replaces::by(Made::Trace, args.force)).map_err(trouble)?;
    let model = args.machine.model();
    let ticker = Ticker::start(!to_stdout, &place);
    let run = Run { session: &session, dialect, settings: &settings, files: &files, model };
    let written = match form {
        // What comes of a program with errors is thrown away.
        Format::Csv | Format::Arrow | Format::Parquet => run.table(form, to_stdout, out),
        Format::Human
        | Format::Concise
        | Format::Json
        | Format::Jsonl
        | Format::Github
        | Format::Gitlab
        | Format::Sarif
        | Format::Junit
        | Format::Checkstyle => run.lines(out),
    };
    drop(ticker);
    targets.spare(&args.input, &common, &files)?;
    if form != Format::Jsonl && session.first_error().is_some() {
        drop(written);
        say(WHOLE);
        if !to_stdout && let Some(stale) = set_aside(&target, Made::Trace).map_err(trouble)? {
            say(&format!("partc: the older {shown} was renamed to {}", stale.display()));
        }
    } else {
        written.and_then(Destination::commit).or_else(ignore_closed_pipe).map_err(trouble)?;
    }
    let rule = args.deps.rule(&args.input, &common, &files, &[&target])?;
    reporter.session(session);
    let exit = reporter.finish()?;
    args.deps.write(rule.into_iter().collect(), exit)
}

/// The form of the moves: the one that is named, or that of the file.
fn form(named: Option<Format>, target: &Path) -> Result<Format, Trouble> {
    if let Some(form @ (Format::Jsonl | Format::Csv | Format::Arrow | Format::Parquet)) = named {
        return Ok(form);
    }
    let extension = target.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    Ok(match extension.as_deref() {
        Some("csv") => Format::Csv,
        Some("arrow" | "feather" | "ipc") => Format::Arrow,
        Some("parquet") => Format::Parquet,
        // A pipe or a device has no extension.
        None | Some("jsonl" | "ndjson") => Format::Jsonl,
        Some(_) => {
            let name = target.display();
            return Err(format!(
                "{name}: no form of moves has this extension; say `--format jsonl|csv|arrow|parquet`, or name the file .jsonl, .ndjson, .csv, .arrow, .feather, .ipc or .parquet"
            ));
        }
    })
}

/// A program and how it is run.
struct Run<'a> {
    session: &'a Session,
    dialect: &'static Dialect,
    settings: &'a Settings,
    files: &'a dyn Files,
    model: Model,
}

impl Run<'_> {
    fn lines(&self, out: Destination) -> io::Result<Destination> {
        let mut out = BufWriter::new(out);
        self.session.trace(self.dialect, self.settings, self.files, self.model, &mut out)?;
        out.flush()?;
        out.into_inner().map_err(io::IntoInnerError::into_error)
    }

    #[cfg(feature = "arrow")]
    fn table(&self, form: Format, is_stream: bool, out: Destination) -> io::Result<Destination> {
        use crate::columns::{Form, Options, Table};
        let form = match form {
            Format::Csv => Form::Csv,
            Format::Parquet => Form::Parquet,
            _ if is_stream => Form::ArrowStream,
            _ => Form::ArrowFile,
        };
        let mut table = Table::open(form, BufWriter::new(out))?;
        let mut error = None;
        let mut take = |batch| {
            error = table.write(&batch).err();
            error.is_none()
        };
        let options = Options { model: self.model, ..Options::default() };
        self.session.trace_batches(self.dialect, self.settings, self.files, options, &mut take);
        if let Some(error) = error {
            return Err(error);
        }
        let mut out = table.finish()?;
        out.flush()?;
        out.into_inner().map_err(io::IntoInnerError::into_error)
    }

    #[cfg(not(feature = "arrow"))]
    fn table(&self, _: Format, _: bool, _: Destination) -> io::Result<Destination> {
        Err(io::Error::other("this partc was built without tables; take jsonl"))
    }
}
