//! `partc merge`

use std::collections::BTreeSet;
use std::io::Write as _;
use std::path::Path;
use std::{fs, io};

use crate::diag::report::merge::merge as merged;

use super::args::Merge;
use super::listing::print;
use super::made::is_output;
use super::output::Destination;
use super::paths::{is_source_name, real};
use super::{Exit, Trouble};

/// Puts the reports of shards together.
pub(super) fn merge(args: &Merge) -> Result<Exit, Trouble> {
    let (mut reports, mut given) = (Vec::new(), BTreeSet::new());
    for path in &args.reports {
        let name = path.display().to_string();
        if !given.insert(real(path)) {
            return Err(format!("{name}: this report is given twice; its findings would count twice"));
        }
        let text =
            if path == Path::new("-") { io::read_to_string(io::stdin().lock()) } else { fs::read_to_string(path) };
        let text = text.map_err(|error| format!("{name}: {error}"))?;
        // Some editors and shells put a byte-order mark in front.
        let text = text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text);
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
