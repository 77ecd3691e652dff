//! `partc plot`

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

use super::args::Plot;
use super::disk::file_name;
use super::inputs::Input;
use super::output::{Destination, Made, ignore_closed_pipe, is_foreign, set_aside};
use super::progress::Ticker;
use super::report::{Reporter, Stdout};
use super::run::{Loaded, load, real, same_file};
use super::{Exit, Trouble, say};

/// Draws the path of one program. A program with errors gets no picture.
pub(super) fn plot(args: &Plot) -> Result<Exit, Trouble> {
    let target = target(args);
    let shown = target.display().to_string();
    let trouble = |error: io::Error| format!("{shown}: {error}");
    if same_file(&args.input, &target) {
        return Err(format!("{shown}: the picture would replace the program"));
    }
    if is_foreign(&target, Made::Picture) && !args.force {
        return Err(format!("{shown}: not drawn by partc; use --force to replace it, or another name"));
    }
    let Loaded { session, dialect, settings, files, place } = load(&args.input, &args.common)?;
    let stdout = if target == Path::new("-") { Stdout::Taken } else { Stdout::Free };
    let mut reporter = Reporter::new(&args.common, &args.findings, stdout, None);
    reporter.spares(&[Input::named(&args.input)], &BTreeSet::from([real(&target)]))?;
    let mut out = Destination::open(&target).map_err(trouble)?;
    let ticker = Ticker::start(true, &place);
    let result = session.plot(dialect, &settings, &files, &mut out);
    drop(ticker);
    if reporter.look().fails(&session) {
        drop(out);
        if let Some(stale) = set_aside(&target, Made::Picture).map_err(trouble)? {
            say(&format!("partc: the older {shown} was renamed to {}", stale.display()));
        }
    } else {
        result.and_then(|()| out.commit()).or_else(ignore_closed_pipe).map_err(trouble)?;
    }
    reporter.session(session);
    reporter.finish()
}

fn target(args: &Plot) -> PathBuf {
    match (&args.output, &args.common.stdin_filename) {
        (Some(output), _) => output.clone(),
        (None, Some(name)) if args.input == Path::new("-") => PathBuf::from(file_name(name)).with_extension("svg"),
        (None, _) if args.input == Path::new("-") => PathBuf::from("-"),
        (None, _) => args.input.with_extension("svg"),
    }
}
