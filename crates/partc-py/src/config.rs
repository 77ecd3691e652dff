//! A configuration with the tables that it names.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use partc::cli::host;
use partc::settings::table::{self, Kind};
use partc::settings::tree::{Node, Table, Value, parse};
use partc::settings::{self, ConfigError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::fault::{Fault, detached};

/// Name of a configuration that is no file, in messages.
const NAME: &str = "partc.toml";

/// Files by name.
pub type Named = Vec<(String, Arc<[u8]>)>;

/// Settings in force; tables that are not at hand come with the files of a run.
#[pyclass(frozen, module = "partc._partc")]
pub struct Settings {
    settings: Arc<partc::Settings>,
    /// Tables that were not handed over.
    missing: Vec<String>,
    toml: String,
    tables: Named,
}

#[pymethods]
impl Settings {
    #[new]
    fn new(py: Python<'_>, toml: String, tables: Vec<(String, Vec<u8>)>) -> PyResult<Settings> {
        let tables: Named = tables.into_iter().map(|(name, bytes)| (name, bytes.into())).collect();
        detached(py, || Settings::read(&toml, tables))
    }
}

impl Settings {
    pub fn read(toml: &str, tables: Named) -> Result<Settings, Fault> {
        let tree = parse(toml, NAME).map_err(|error| Fault::Config(error.to_string()))?;
        let named = host::table_paths(&tree);
        let missing: Vec<String> = named.iter().filter(|name| find(&tables, name).is_none()).cloned().collect();
        let settings = Arc::new(made(&tree, &tables)?);
        Ok(Settings { settings, missing, toml: toml.to_owned(), tables })
    }

    /// The settings of a run with these files.
    pub fn with(&self, files: Option<&Named>) -> Result<Arc<partc::Settings>, Fault> {
        if self.missing.is_empty() {
            return Ok(Arc::clone(&self.settings));
        }
        let mut all = self.tables.clone();
        all.extend(files.into_iter().flatten().cloned());
        if let Some(name) = self.missing.iter().find(|name| find(&all, name).is_none()) {
            let how = "hand it over in files= or tables=, or read the configuration with Config.from_file";
            return Err(Fault::Config(format!("the table `{name}` is not there: {how}")));
        }
        let tree = parse(&self.toml, NAME).map_err(|error| Fault::Config(error.to_string()))?;
        Ok(Arc::new(made(&tree, &all)?))
    }
}

/// By its whole name, or by the last part of it.
fn find<'f>(files: &'f Named, name: &str) -> Option<&'f Arc<[u8]>> {
    let last = |name: &str| name.rsplit(['/', '\\']).next().unwrap_or_default().to_owned();
    let whole = files.iter().find(|(found, _)| found == name);
    whole.or_else(|| files.iter().find(|(found, _)| *found == last(name))).map(|(_, bytes)| bytes)
}

/// Tables that are not there are left out.
fn made(tree: &Table, tables: &Named) -> Result<partc::Settings, Fault> {
    let mut tree = tree.clone();
    if let Some(node) = tree.remove("extend") {
        let why = "`extend` names a file: read the configuration with Config.from_file";
        return Err(Fault::Config(node.fail(why).to_string()));
    }
    let all =
        |errors: Vec<ConfigError>| Fault::Config(errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"));
    let mut settings = settings::read(&tree).map_err(all)?;
    let trouble = |name: &str, why: String| Fault::Config(format!("{name}: {why}"));
    for name in host::table_paths(&tree) {
        let Some(bytes) = find(tables, &name) else { continue };
        let contents =
            table::read(&String::from_utf8_lossy(bytes)).map_err(|error| trouble(&name, error.to_string()))?;
        if contents.has_tools() {
            settings.tools.add(contents).map_err(|why| trouble(&name, why))?;
        } else if contents.kind == Kind::Datums {
            settings.datums.table = Some(contents);
        } else {
            return Err(trouble(&name, format!("is a {}, neither tools nor datums", contents.kind.name())));
        }
    }
    Ok(settings)
}

/// The same configuration in one form, whatever its order, comments and blanks.
#[pyfunction]
pub fn canonical(toml: &str) -> PyResult<String> {
    let tree = parse(toml, NAME).map_err(|error| Fault::Config(error.to_string()))?;
    Ok(written(&tree))
}

/// A configuration file with what it extends, as text, and the tables that it names.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a pair of text and files, as Python sees it")]
pub fn load(py: Python<'_>, path: PathBuf) -> PyResult<(String, Vec<(String, Py<PyBytes>)>)> {
    let (tree, tables) = detached(py, || host::configuration(&path).map_err(Fault::Config))?;
    let tables = tables.into_iter().map(|(name, bytes)| (name, PyBytes::new(py, &bytes).unbind()));
    Ok((written(&tree), tables.collect()))
}

/// A section for each key at the top, all below in one line.
fn written(tree: &Table) -> String {
    let mut text = String::new();
    let (tables, plain): (Vec<_>, Vec<_>) = tree.iter().partition(|(_, node)| matches!(node.value, Value::Table(_)));
    for (key, node) in plain {
        let _ = writeln!(text, "{} = {}", quoted(key), value(node));
    }
    for (key, node) in tables {
        let Value::Table(inner) = &node.value else { continue };
        let _ = writeln!(text, "[{}]", quoted(key));
        for (key, node) in inner {
            let _ = writeln!(text, "{} = {}", quoted(key), value(node));
        }
    }
    text
}

fn value(node: &Node) -> String {
    match &node.value {
        Value::Text(text) => string(text),
        Value::Whole(number) => number.to_string(),
        Value::Number(number) => format!("{number:?}"),
        Value::Flag(flag) => flag.to_string(),
        Value::List(items) => format!("[{}]", items.iter().map(value).collect::<Vec<_>>().join(", ")),
        Value::Table(inner) => {
            let pairs = inner.iter().map(|(key, node)| format!("{} = {}", quoted(key), value(node)));
            format!("{{ {} }}", pairs.collect::<Vec<_>>().join(", "))
        }
    }
}

fn quoted(key: &str) -> String {
    let bare = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
    if !key.is_empty() && key.chars().all(bare) { key.to_owned() } else { string(key) }
}

/// Strings of JSON are such of TOML, but for one control character.
fn string(text: &str) -> String {
    serde_json::Value::from(text).to_string().replace('\u{7f}', "\\u007F")
}
