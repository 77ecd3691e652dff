//! A program with everything that is needed to run it.

use std::path::{Path, PathBuf};

use crate::diag::selection::fits;
use crate::dialect::{self, Dialect};
use crate::driver::Session;
use crate::machine::Settings;
use crate::text::{FileId, Span};

use super::disk::{IncludeRoots, noting_settings, open_main};
use super::options::Common;
use super::progress::Place;
use super::report::counted;
use super::stamp::Stamp;
use super::{Trouble, config};

/// A program with everything that is needed to run it.
pub(super) struct Loaded {
    pub session: Session,
    pub dialect: &'static Dialect,
    pub settings: Settings,
    pub files: IncludeRoots,
    /// How far the program has been read.
    pub place: Place,
}

/// Bytes of a program that is tried several times for what it needs.
pub(super) const LARGEST_TRIED: u64 = 4 << 20;

/// Bytes looked at to tell the dialect.
const HEAD: u32 = 64 * 1024;

pub(super) fn load(path: &Path, common: &Common) -> Result<Loaded, Trouble> {
    let input = common.stdin_filename.as_deref().filter(|_| path == Path::new("-")).unwrap_or(path);
    let (settings, read) = noting_settings(|| config::settings(input, common));
    load_with(path, common, settings?).inspect(|loaded| loaded.files.read_before(read))
}

/// The same under given settings.
pub(super) fn load_with(path: &Path, common: &Common, settings: Settings) -> Result<Loaded, Trouble> {
    let shown = path.display().to_string();
    let stamp = Stamp::at(path).filter(|_| path != Path::new("-"));
    let mut main = open_main(path, common.stdin_filename.as_deref()).map_err(|error| format!("{shown}: {error}"))?;
    let place = Place::default();
    main.text = place.follow(main.text);
    let (name, identity) = (main.name.clone(), main.identity.clone());
    let session = Session::new(main);
    let dialect = if common.dialect != "auto" {
        dialect::find(&common.dialect).ok_or_else(|| format!("no dialect `{}`", common.dialect))?
    } else if let Some(dialect) = said_dialect(&identity, &settings).map_err(|error| format!("{shown}: {error}"))? {
        dialect
    } else {
        let head = session.sources.bytes(FileId(0), Span { start: 0, end: HEAD });
        dialect::read_as(&name, &head).ok_or_else(|| format!("{shown}: {}", which_language(path, common, &settings)))?
    };
    let file = common.stdin_filename.as_deref().filter(|_| path == Path::new("-")).unwrap_or(path);
    let base = match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
        _ => PathBuf::from("."),
    };
    let files = IncludeRoots::of_control(base, settings.include.roots.clone(), dialect.folders);
    stamp.into_iter().for_each(|stamp| files.reads(path, stamp));
    Ok(Loaded { session, dialect, settings, files, place })
}

/// The language that `[dialects]` says for a file of this path.
pub(super) fn said_dialect(identity: &str, settings: &Settings) -> Result<Option<&'static Dialect>, Trouble> {
    let path = if cfg!(windows) { identity.replace('\\', "/") } else { identity.to_owned() };
    let mut said = settings.dialects.iter().filter(|(pattern, _)| fits(pattern, &path)).map(|(_, dialect)| dialect);
    let Some(first) = said.next() else { return Ok(None) };
    if let Some(other) = said.find(|other| *other != first) {
        return Err(format!("`[dialects]` says that this is {first} and {other}"));
    }
    // The configuration was refused otherwise.
    Ok(dialect::find(first))
}

fn names_of_dialects() -> String {
    dialect::ALL.iter().map(|dialect| dialect.id).collect::<Vec<_>>().join("|")
}

/// All languages, each with how well the program fits it.
fn which_language(path: &Path, common: &Common, settings: &Settings) -> String {
    let mut fits: Vec<(u32, &str)> = Vec::new();
    for dialect in dialect::ALL {
        // What came through a pipe is gone.
        let Ok(main) = open_main(path, common.stdin_filename.as_deref())
            .map_err(drop)
            .and_then(|main| if path == Path::new("-") { Err(()) } else { Ok(main) })
        else {
            continue;
        };
        let session = Session::new(main);
        session.check_form(dialect, settings);
        fits.push((session.diags.errors(), dialect.id));
    }
    fits.sort_unstable();
    let evidence: Vec<String> = fits
        .iter()
        .map(|(errors, id)| format!("{id} ({} cannot be read)", counted(*errors, "block", "blocks")))
        .collect();
    let names = names_of_dialects();
    let evidence = if evidence.is_empty() { String::new() } else { format!("; tried: {}", evidence.join(", ")) };
    format!("which language is this? Say `--dialect {names}`{evidence}")
}

/// A file of a folder whose extension or content some dialect knows; plain G-code is taken where it is named, for outputs
/// lie beside their programs. One that cannot be read is judged by its name: who opens it says why it cannot.
pub(super) fn is_program(path: &Path, common: &Common) -> bool {
    let is_source = |dialect: &dialect::Dialect| dialect.id != "gcode";
    let Ok(main) = open_main(path, None) else {
        return path
            .file_name()
            .is_some_and(|name| dialect::guess(&name.to_string_lossy(), &[]).is_some_and(is_source));
    };
    let (name, identity) = (main.name.clone(), main.identity.clone());
    let session = Session::new(main);
    let head = session.sources.bytes(FileId(0), Span { start: 0, end: HEAD });
    let said =
        || config::settings(path, common).is_ok_and(|settings| !matches!(said_dialect(&identity, &settings), Ok(None)));
    match dialect::read_as(&name, &head) {
        // It is called as a program is: what it is instead is said of it.
        Some(dialect) if dialect.is_foreign() => dialect::guess(&name, &[]).is_some_and(is_source) || said(),
        Some(dialect) => is_source(dialect),
        None => said(),
    }
}

/// Name of the language of a program, where it is one and its language is known.
pub(super) fn dialect_of(path: &Path, common: &Common) -> Option<&'static str> {
    let named = || dialect::find(&common.dialect).map(|dialect| dialect.id);
    if !path.is_file() {
        return named();
    }
    let main = open_main(path, None).ok()?;
    let (name, identity) = (main.name.clone(), main.identity.clone());
    let session = Session::new(main);
    let head = session.sources.bytes(FileId(0), Span { start: 0, end: HEAD });
    let said = || {
        let settings = config::settings(path, common).ok()?;
        said_dialect(&identity, &settings).ok()?.map(|dialect| dialect.id)
    };
    named().or_else(said).or_else(|| dialect::guess(&name, &head).map(|dialect| dialect.id))
}
