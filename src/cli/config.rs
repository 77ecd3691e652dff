//! Finds and reads `partc.toml` and the tool table.

use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use crate::dialect;
use crate::machine::config;
use crate::machine::settings::{Compensation, Settings};
use crate::machine::table::{self, Contents, Kind};
use crate::machine::tree::{Node, Spot, Table, Value, overlay, parse};
use crate::target;

use super::Trouble;
use super::disk::{read_settings, read_settings_once};
use super::options::Common;
use super::regular;

/// Name of the configuration file.
pub(super) const NAME: &str = "partc.toml";
/// Keys that name a file.
const PATHS: [(&str, &str); 2] = [("tools", "table"), ("control", "datum_table")];
/// Longest chain of `extend`.
const MOST_EXTENDS: usize = 16;

/// What an argument of the command line says in place of the configuration.
pub(super) fn set(tree: &mut Table, section: &str, key: &str, value: Value) {
    let spot = Spot { file: "command line".to_owned(), ..Spot::default() };
    let node = Node { value, spot: spot.clone() };
    let table = Value::Table(Table::from([(key.to_owned(), node)]));
    overlay(tree, Table::from([(section.to_owned(), Node { value: table, spot })]));
}

/// The configuration in force for `input`: its file and what that extends, and the findings that the command line chooses.
pub(super) fn tree_for(input: &Path, common: &Common) -> Result<Table, Trouble> {
    tree_beyond(None, input, common)
}

/// The same as if the configuration `hidden`, which will be written anew, were not there.
pub(super) fn tree_beyond(hidden: Option<&Path>, input: &Path, common: &Common) -> Result<Table, Trouble> {
    let mut tree = file_for(hidden, input, common)?;
    for (key, words) in [("select", &common.report.select), ("ignore", &common.report.ignore)] {
        let Some(words) = words else { continue };
        let spot = Spot { file: "command line".to_owned(), ..Spot::default() };
        let node = |word: &String| Node { value: Value::Text(word.trim().to_owned()), spot: spot.clone() };
        set(&mut tree, "lint", key, Value::List(words.iter().map(node).collect()));
    }
    Ok(tree)
}

/// The configuration file for `input`, with what it extends; empty where there is none.
fn file_for(hidden: Option<&Path>, input: &Path, common: &Common) -> Result<Table, Trouble> {
    let file = match &common.config {
        Some(file) => Some(file.clone()),
        None if common.isolated => None,
        None => nearest(hidden, input)?,
    };
    let Some(file) = file else { return Ok(Table::new()) };
    // What nobody named may come from anywhere, with a folder of programs that was downloaded.
    let trust = if common.config.is_some() { Trust::Named } else { Trust::Found };
    load(&file, trust, 0)
}

/// A configuration that somebody names, with what it extends.
pub(super) fn named(file: &Path) -> Result<Table, Trouble> {
    load(file, Trust::Named, 0)
}

/// How a configuration came into force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Trust {
    /// By `--config`.
    Named,
    /// It lies at or above the program: it opens nothing outside its own folder.
    Found,
}

/// Does `path` lie in `folder`, links followed? What does not exist is judged by its name.
fn is_below(path: &Path, folder: &Path) -> bool {
    let Ok(folder) = fs::canonicalize(if folder.as_os_str().is_empty() { Path::new(".") } else { folder }) else {
        return false;
    };
    // Up to the part that exists; `..` behind it would lead anywhere.
    let existing =
        path.ancestors().find_map(|part| Some((fs::canonicalize(part).ok()?, path.strip_prefix(part).ok()?)));
    existing.is_some_and(|(real, rest)| {
        real.starts_with(&folder) && !rest.components().any(|part| part == Component::ParentDir)
    })
}

/// May a configuration that was found by itself extend `other`? A `partc.toml` in a folder above would have been found
/// by itself without the nearer one.
fn may_extend(other: &Path, folder: &Path) -> bool {
    let found = || -> Option<bool> {
        let (real, folder) = (fs::canonicalize(other).ok()?, fs::canonicalize(folder).ok()?);
        Some(real.file_name()? == NAME && folder.starts_with(real.parent()?))
    };
    is_below(other, folder) || found().unwrap_or(false)
}

/// The settings that hold for `input`.
pub(super) fn settings(input: &Path, common: &Common) -> Result<Settings, Trouble> {
    settings_of(&tree_for(input, common)?, common)
}

/// The settings that a configuration comes to, with what the command line says.
pub(super) fn settings_of(tree: &Table, common: &Common) -> Result<Settings, Trouble> {
    let table = table_path(tree, common);
    let mut settings = config::read(tree)
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\npartc: "))?;
    if let Some(path) = table {
        read_tools(&path, &mut settings)?;
    }
    if let Some(path) = path_of(tree, "control", "datum_table") {
        let contents = read_table(&path, Once::No)?;
        if contents.kind != Kind::Datums {
            return Err(format!("{}: is a {}, not a datum table", path.display(), contents.kind.name()));
        }
        settings.datums.table = Some(contents);
    }
    for (pattern, id) in &settings.dialects {
        if dialect::find(id).is_none() {
            let known = dialect::ALL.iter().map(|dialect| dialect.id).collect::<Vec<_>>().join(", ");
            return Err(format!("`[dialects]`: `{id}` of `{pattern}` is no language; there are {known}"));
        }
    }
    if let Some(target) = &common.target {
        settings.output.target = target::find(target).ok_or_else(|| format!("no target `{target}`"))?;
    }
    settings.output.line_numbers = common.numbers.unwrap_or(settings.output.line_numbers);
    match common.compensation.as_deref() {
        Some("control") => settings.output.compensation = Compensation::Control,
        Some(_) => settings.output.compensation = Compensation::Resolve,
        None => {}
    }
    Ok(settings)
}

/// Files that decide what is in force for a program.
#[derive(Debug, Default)]
pub(super) struct Read {
    /// The configuration, what it extends, tool and datum table: each with what it is.
    pub files: Vec<(&'static str, PathBuf)>,
    /// Configurations that would be in force if they existed, the nearest first.
    pub absent: Vec<PathBuf>,
}

/// What [`settings`] reads for `input`.
pub(super) fn read_for(input: &Path, common: &Common) -> Result<Read, Trouble> {
    // First what may not be read at all is refused.
    let tree = tree_for(input, common)?;
    let mut read = Read::default();
    let mut file = match &common.config {
        Some(file) => Some(file.clone()),
        None if common.isolated => None,
        None => {
            let found = nearest(None, input)?;
            let folder = found.as_deref().and_then(Path::parent);
            let above = folder_of(input)?.map(|folder| folder.ancestors().map(Path::to_path_buf).collect::<Vec<_>>());
            let nearer = above.unwrap_or_default().into_iter().take_while(|dir| Some(dir.as_path()) != folder);
            read.absent = nearer.map(|dir| dir.join(NAME)).collect();
            found
        }
    };
    while let Some(path) = file.take().filter(|_| read.files.len() <= MOST_EXTENDS) {
        let text = read_settings(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let text = String::from_utf8(text).map_err(|_| format!("{}: is not UTF-8 text", path.display()))?;
        let tree = parse(&text, &path.display().to_string()).map_err(|error| error.to_string())?;
        if let Some(Value::Text(other)) = tree.get("extend").map(|node| &node.value) {
            file = Some(path.parent().unwrap_or(Path::new(".")).join(other));
        }
        read.files.push(("configuration", path));
    }
    let tables = [("tool table", table_path(&tree, common)), ("datum table", path_of(&tree, "control", "datum_table"))];
    read.files.extend(tables.into_iter().filter_map(|(what, path)| Some((what, path?))));
    Ok(read)
}

/// The folder of a program; none where it does not exist.
fn folder_of(input: &Path) -> Result<Option<PathBuf>, Trouble> {
    let folder = if input == Path::new("-") { Some(Path::new(".")) } else { input.parent() };
    let Some(folder) = folder else { return Ok(None) };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    match fs::canonicalize(folder) {
        Ok(folder) => Ok(Some(folder)),
        Err(error) if is_absence(&error) => Ok(None),
        Err(error) => Err(format!("{}: {error}", folder.display())),
    }
}

fn is_absence(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory)
}

/// The nearest configuration file above `folder`, as one in `folder` would name it.
pub(super) fn above(folder: &Path) -> Option<String> {
    let folder = fs::canonicalize(folder).ok()?;
    let levels = folder.ancestors().skip(1).position(|dir| dir.join(NAME).is_file())?;
    Some("../".repeat(levels + 1) + NAME)
}

/// The nearest configuration file at or above the folder of `input`: whatever has its name is one, also what cannot be read.
fn nearest(hidden: Option<&Path>, input: &Path) -> Result<Option<PathBuf>, Trouble> {
    let Some(folder) = folder_of(input)? else { return Ok(None) };
    let hidden = hidden.and_then(|file| fs::canonicalize(file).ok());
    for file in folder.ancestors().map(|dir| dir.join(NAME)).filter(|file| Some(file) != hidden.as_ref()) {
        match fs::symlink_metadata(&file) {
            Ok(_) => return Ok(Some(file)),
            Err(error) if is_absence(&error) => {}
            Err(error) => return Err(format!("{}: {error}", file.display())),
        }
    }
    Ok(None)
}

/// The configuration files that may hold for a folder: the one that is named, or all above.
pub(super) fn files_above(folder: &Path, common: &Common) -> Vec<PathBuf> {
    let named = common.config.iter().chain(&common.tools).cloned();
    let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
    named.chain(folder.ancestors().map(|dir| dir.join(NAME))).collect()
}

/// Reads a file and what it extends.
fn load(file: &Path, trust: Trust, depth: usize) -> Result<Table, Trouble> {
    let shown = file.display();
    if depth > MOST_EXTENDS {
        return Err(format!("{shown}: `extend` goes in circles"));
    }
    let folder = file.parent().unwrap_or(Path::new("."));
    if trust == Trust::Found && file.is_symlink() {
        // What it leads to is not even read: a message would quote it.
        regular::metadata(file).map_err(|error| format!("{shown}: {error}"))?;
        if !may_extend(file, folder) {
            return Err(format!("{shown}: is a link that {LEADS_OUT}"));
        }
    }
    let bytes = read_settings(file).map_err(|error| format!("{shown}: {error}"))?;
    let text = String::from_utf8(bytes).map_err(|_| format!("{shown}: is not UTF-8 text"))?;
    let mut tree = parse(&text, &shown.to_string()).map_err(|error| error.to_string())?;
    make_absolute(&mut tree, folder);
    if trust == Trust::Found {
        paths_stay_below(&tree, folder)?;
        stand_ins_stay_below(&tree, folder)?;
    }
    let Some(node) = tree.remove("extend") else { return Ok(tree) };
    let Value::Text(other) = &node.value else {
        return Err(node.fail("`extend` names a file").to_string());
    };
    let other = folder.join(other);
    if trust == Trust::Found && other.exists() && !may_extend(&other, folder) {
        return Err(node.fail(format!("`extend` {LEADS_OUT}")).to_string());
    }
    let mut base = load(&other, trust, depth + 1)?;
    overlay(&mut base, tree);
    Ok(base)
}

/// Why a path of a configuration is not used.
const LEADS_OUT: &str = "leads out of the folder of this configuration, which was found by itself; to allow it, name the configuration \
with --config";

/// The files and folders that a configuration names which nobody named.
fn paths_stay_below(tree: &Table, folder: &Path) -> Result<(), Trouble> {
    for (section, key) in PATHS {
        if let Some(Value::Table(keys)) = tree.get(section).map(|node| &node.value)
            && let Some(node) = keys.get(key)
            && let Value::Text(path) = &node.value
            && !is_below(Path::new(path), folder)
        {
            return Err(node.fail(format!("this table {LEADS_OUT}")).to_string());
        }
    }
    let Some(Value::Table(include)) = tree.get("include").map(|node| &node.value) else { return Ok(()) };
    let Some(Value::Table(roots)) = include.get("roots").map(|node| &node.value) else { return Ok(()) };
    for node in roots.values() {
        if let Value::Text(root) = &node.value
            && !is_below(Path::new(root), folder)
        {
            return Err(node.fail(format!("this root {LEADS_OUT}")).to_string());
        }
    }
    Ok(())
}

/// The files that a configuration that nobody named gives in place of programs.
fn stand_ins_stay_below(tree: &Table, folder: &Path) -> Result<(), Trouble> {
    let Some(Value::Table(programs)) = tree.get("programs").map(|node| &node.value) else { return Ok(()) };
    for node in programs.values() {
        if let Value::Table(keys) = &node.value
            && let Some(Value::Text(file)) = keys.get("file").map(|node| &node.value)
            && !is_below(Path::new(file), folder)
        {
            return Err(node.fail(format!("this file {LEADS_OUT}")).to_string());
        }
    }
    Ok(())
}

/// Paths in a configuration file count from its own folder.
pub(super) fn make_absolute(tree: &mut Table, folder: &Path) {
    let anchor = |node: &mut Node| {
        if let Value::Text(text) = &mut node.value {
            *text = folder.join(&text).to_string_lossy().into_owned();
        }
    };
    for (section, key) in PATHS {
        if let Some(Value::Table(keys)) = tree.get_mut(section).map(|node| &mut node.value)
            && let Some(node) = keys.get_mut(key)
        {
            anchor(node);
        }
    }
    if let Some(Value::Table(include)) = tree.get_mut("include").map(|node| &mut node.value)
        && let Some(Value::Table(roots)) = include.get_mut("roots").map(|node| &mut node.value)
    {
        roots.values_mut().for_each(anchor);
    }
    if let Some(Value::Table(programs)) = tree.get_mut("programs").map(|node| &mut node.value) {
        let files = programs.values_mut().filter_map(|node| match &mut node.value {
            Value::Table(keys) => keys.get_mut("file"),
            _ => None,
        });
        files.for_each(anchor);
    }
    if let Some(Value::Table(dialects)) = tree.get_mut("dialects").map(|node| &mut node.value) {
        anchor_patterns(dialects, folder);
    }
    if let Some(Value::Table(lint)) = tree.get_mut("lint").map(|node| &mut node.value)
        && let Some(Value::Table(files)) = lint.get_mut("files").map(|node| &mut node.value)
    {
        anchor_patterns(files, folder);
    }
}

/// Patterns of files count from a folder, and are compared with where the files really lie.
fn anchor_patterns(patterns: &mut Table, folder: &Path) {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
    let here = std::mem::take(patterns);
    *patterns = here.into_iter().map(|(pattern, node)| (pattern_below(&folder, &pattern), node)).collect();
}

/// A pattern of paths that counts from a folder.
fn pattern_below(folder: &Path, pattern: &str) -> String {
    let folder = folder.to_string_lossy();
    let folder = if cfg!(windows) { folder.replace('\\', "/") } else { folder.into_owned() };
    format!("{}/{pattern}", folder.trim_end_matches('/'))
}

fn table_path(tree: &Table, common: &Common) -> Option<PathBuf> {
    if let Some(path) = &common.tools {
        return Some(path.clone());
    }
    path_of(tree, "tools", "table")
}

/// The file that a key names.
fn path_of(tree: &Table, section: &str, key: &str) -> Option<PathBuf> {
    let Value::Table(keys) = &tree.get(section)?.value else { return None };
    match &keys.get(key)?.value {
        Value::Text(path) => Some(path.into()),
        _ => None,
    }
}

/// Reads a tool table; tools of the configuration file win over it.
fn read_tools(path: &Path, settings: &mut Settings) -> Result<(), Trouble> {
    let contents = read_table(path, Once::No)?;
    if !contents.has_tools() {
        return Err(format!("{}: is a {}, and holds no tools", path.display(), contents.kind.name()));
    }
    settings.tools.add(contents).map_err(|message| format!("{}: {message}", path.display()))
}

/// Is a file read once in a run? Then it may come through a pipe.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Once {
    Yes,
    No,
}

/// Reads a file of tool or machine data.
pub(super) fn read_table(path: &Path, once: Once) -> Result<Contents, Trouble> {
    let bytes = if once == Once::Yes { read_settings_once(path) } else { read_settings(path) };
    let bytes = bytes.map_err(|error| format!("{}: {error}", path.display()))?;
    let text = String::from_utf8(bytes).unwrap_or_else(|error| crate::text::decode::readable_lines(error.as_bytes()));
    table::read(&text).map_err(|error| format!("{}:{error}", path.display()))
}
