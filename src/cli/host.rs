//! What bindings for other languages take of the command line: programs and configurations of this computer, found and opened
//! by the same rules, and the command line itself.

use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};

use crate::dialect::Dialect;
use crate::driver::Session;
use crate::machine::Settings;
use crate::machine::tree::{Table, Value};
use crate::target;
use crate::text::Files;

use super::disk::read_settings;
use super::options::Common;
use super::{config, program};

/// What the caller says in place of what would be found.
#[derive(Debug, Clone, Copy, Default)]
pub struct Asked<'a> {
    /// `None`: the nearest `partc.toml` wins, as on the command line.
    pub settings: Option<&'a Settings>,
    /// `None`: by extension, content and `[dialects]`.
    pub dialect: Option<&'a str>,
    pub target: Option<&'a str>,
}

/// A program of this computer with everything that is needed to run it.
pub struct Opened {
    pub session: Session,
    pub dialect: &'static Dialect,
    pub settings: Settings,
    /// The programs that it may call.
    pub files: Box<dyn Files>,
}

impl fmt::Debug for Opened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Opened").field("session", &self.session).finish_non_exhaustive()
    }
}

/// Opens a program as the command line does.
///
/// # Errors
/// What cannot be read, a configuration that cannot be used, a language that is not known.
pub fn open(path: &Path, asked: &Asked<'_>) -> Result<Opened, String> {
    let common = Common::asking(asked.dialect, asked.target);
    let settings = match asked.settings {
        Some(settings) => {
            let mut settings = settings.clone();
            if let Some(name) = asked.target {
                settings.output.target = target::find(name).ok_or_else(|| format!("no target `{name}`"))?;
            }
            settings
        }
        None => config::settings(path, &common)?,
    };
    let program::Loaded { session, dialect, settings, files, .. } = program::load_with(path, &common, settings)?;
    Ok(Opened { session, dialect, settings, files: Box::new(files) })
}

/// A configuration, and the bytes of the tables that it names, by their paths.
pub type WithTables = (Table, Vec<(String, Vec<u8>)>);

/// A configuration file with what it extends, paths in it from the root.
///
/// # Errors
/// What cannot be read, or is no TOML.
pub fn configuration(file: &Path) -> Result<WithTables, String> {
    let folder = std::path::absolute(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let tree = config::named(&folder)?;
    let mut tables = Vec::new();
    for path in table_paths(&tree) {
        let bytes = read_settings(&PathBuf::from(&path)).map_err(|error| format!("{path}: {error}"))?;
        tables.push((path, bytes));
    }
    Ok((tree, tables))
}

/// The files of tool and datum tables that a configuration names.
pub fn table_paths(tree: &Table) -> Vec<String> {
    let named = |(section, key): (&str, &str)| {
        let Value::Table(keys) = &tree.get(section)?.value else { return None };
        match &keys.get(key)?.value {
            Value::Text(path) => Some(path.clone()),
            _ => None,
        }
    };
    [("tools", "table"), ("control", "datum_table")].into_iter().filter_map(named).collect()
}

/// Runs the command line, the name of the program in front. Returns its exit code.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    super::run_line(arguments)
}
