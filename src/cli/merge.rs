//! `partc merge`

use std::fs;
use std::io::Write as _;
use std::path::Path;

use crate::diag::report::merge::merge as merged;

use super::args::Merge;
use super::listing::print;
use super::output::Destination;
use super::run::{is_output, is_source_name, real};
use super::{Exit, Trouble};

/// Puts the reports of shards together.
pub(super) fn merge(args: &Merge) -> Result<Exit, Trouble> {
    let mut reports = Vec::new();
    for path in &args.reports {
        let name = path.display().to_string();
        let text = fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?;
        reports.push((name, text));
    }
    let text = merged(&reports)?;
    let Some(file) = args.output.as_deref().filter(|path| *path != Path::new("-")) else {
        return print(text.as_bytes());
    };
    let name = file.display();
    let taken = args.reports.iter().any(|report| real(report) == real(file)) || is_output(file);
    if taken || is_source_name(file) {
        return Err(format!("{name}: one of the reports, or a program, would be replaced; name another file"));
    }
    let written =
        Destination::open(file).and_then(|mut out| out.write_all(text.as_bytes()).and_then(|()| out.commit()));
    written.map_err(|error| format!("{name}: {error}"))?;
    Ok(Exit::Clean)
}
