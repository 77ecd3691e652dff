//! Which programs a command works on: files, folders, patterns, lists.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use std::{env, fs};

use globset::GlobBuilder;
use ignore::WalkBuilder;
use xxhash_rust::xxh3::xxh3_64;

use crate::text::decode::harmless_lines;

use super::Trouble;
use super::disk::file_name;
use super::options::{Many, Shard};

/// Names files that nobody shall look at, as `.gitignore` does.
const IGNORE_FILE: &str = ".partcignore";

/// A program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Input {
    pub path: PathBuf,
    /// Its path below the folder that was named; its name where it was named itself.
    pub below: PathBuf,
}

impl Input {
    /// A program that was named itself.
    pub fn named(path: &Path) -> Input {
        Input { path: path.to_path_buf(), below: PathBuf::from(file_name(path)) }
    }
}

/// What was found, in order, and what could not be read.
#[derive(Debug, Default)]
pub(super) struct Inputs {
    pub list: Vec<Input>,
    /// The programs of the other shards.
    pub others: Vec<Input>,
    pub troubles: Vec<Trouble>,
}

/// The programs that `paths` and `many` name; of folders those that `takes` takes.
///
/// # Errors
/// Standard input cannot hold a program and the list.
pub(super) fn inputs(paths: &[PathBuf], many: &Many, takes: &dyn Fn(&Path) -> bool) -> Result<Inputs, Trouble> {
    let mut found = Inputs::default();
    let mut named = paths.to_vec();
    match many.files_from.as_deref().map(list_from).transpose() {
        Ok(list) => named.extend(list.unwrap_or_default()),
        Err(trouble) => found.troubles.push(trouble),
    }
    let stdin = |path: &Path| path == Path::new("-");
    if many.files_from.as_deref().is_some_and(stdin) && named.iter().any(|path| stdin(path)) {
        return Err("standard input holds the list of --files-from; it cannot hold a program, too".to_owned());
    }
    let mut seen = BTreeSet::new();
    for path in &named {
        match expand(path, takes) {
            Ok(list) => found.list.extend(list.into_iter().filter(|input| seen.insert(input.path.clone()))),
            Err(error) => found.troubles.push(shortened(&format!("{}: {error}", path.display()))),
        }
    }
    if let Some(shard) = many.shard {
        (found.list, found.others) = found.list.into_iter().partition(|input| is_in(shard, &input.path));
    }
    Ok(found)
}

/// Characters of a message about files that are shown at its start, and at its end: no name of a file is longer than those.
const SHOWN: [usize; 2] = [200, 400];

/// A message with the path through very many folders cut in its middle.
fn shortened(text: &str) -> String {
    let count = text.chars().count();
    let [start, end] = SHOWN;
    if count <= start + end + 1 {
        return text.to_owned();
    }
    let chars = |from: usize, to: usize| text.chars().skip(from).take(to - from).collect::<String>();
    format!("{}…{}", chars(0, start), chars(count - end, count))
}

/// The names in a list, one a line.
fn list_from(path: &Path) -> Result<Vec<PathBuf>, Trouble> {
    let mut text = String::new();
    let read = if path == Path::new("-") {
        io::stdin().lock().read_to_string(&mut text).map(drop)
    } else {
        std::fs::read_to_string(path).map(|read| text = read)
    };
    read.map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(text.lines().map(str::trim_end).filter(|line| !line.is_empty()).map(PathBuf::from).collect())
}

fn expand(path: &Path, takes: &dyn Fn(&Path) -> bool) -> io::Result<Vec<Input>> {
    if path == Path::new("-") {
        return Ok(vec![Input { path: path.to_path_buf(), below: path.to_path_buf() }]);
    }
    if path.is_dir() {
        return Ok(below(path, walk(path, takes, Ignored::LeftOut)?));
    }
    let pattern = path.to_string_lossy();
    if !path.exists() && pattern.contains(['*', '?', '[', '{']) {
        return matching(&pattern);
    }
    Ok(vec![Input::named(path)])
}

/// Kinds of files named where none is a program.
const KINDS: usize = 5;

/// What to say where no program lies in the folders: which files lie there, and how they become programs.
pub(super) fn no_program(paths: &[PathBuf]) -> String {
    let mut kinds: BTreeMap<String, u32> = BTreeMap::new();
    for path in paths.iter().filter(|path| path.is_dir()) {
        for file in walk(path, &|_| true, Ignored::LeftOut).unwrap_or_default() {
            let extension = file.extension().map(|extension| extension.to_string_lossy().to_lowercase());
            let kind =
                extension.map_or_else(|| "without an extension".to_owned(), |extension| format!("`.{extension}`"));
            *kinds.entry(kind).or_default() += 1;
        }
    }
    let nothing = "no part program lies in the folders that are named";
    if kinds.is_empty() {
        return nothing.to_owned();
    }
    let mut kinds: Vec<(String, u32)> = kinds.into_iter().collect();
    kinds.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    let named: Vec<String> = kinds.iter().take(KINDS).map(|(kind, count)| format!("{count} {kind}")).collect();
    let more = if kinds.len() > KINDS { " and others" } else { "" };
    format!(
        "{nothing}; passed over: {}{more}. Where some are programs, say their language: `partc check FILE --dialect …`, or for all of \
         them in partc.toml: `[dialects]` with a pattern, such as `\"**/*.txt\" = \"sinumerik\"`",
        harmless_lines(&named.join(", "))
    )
}

/// With their paths below `folder`.
fn below(folder: &Path, files: Vec<PathBuf>) -> Vec<Input> {
    let own = |path: &Path| path.strip_prefix(folder).unwrap_or(path).to_path_buf();
    files.into_iter().map(|path| Input { below: own(&path), path }).collect()
}

/// The files that a pattern names; a shell that expands none passes it on.
fn matching(pattern: &str) -> io::Result<Vec<Input>> {
    let glob = GlobBuilder::new(pattern).literal_separator(true).build().map_err(io::Error::other)?.compile_matcher();
    let fixed: PathBuf = Path::new(pattern)
        .components()
        .take_while(|part| !part.as_os_str().to_string_lossy().contains(['*', '?', '[', '{']))
        .collect();
    let folder = if fixed.as_os_str().is_empty() { Path::new(".") } else { fixed.as_path() };
    let files = walk(folder, &|path| glob.is_match(path.strip_prefix(".").unwrap_or(path)), Ignored::LeftOut)?;
    if files.is_empty() {
        return Err(io::Error::other("no file has such a name"));
    }
    Ok(below(folder, files))
}

/// What becomes of files that `.gitignore`, `.ignore` or `.partcignore` name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ignored {
    Taken,
    LeftOut,
}

/// Files below `folder` that `takes` takes, in order of their names. Hidden ones are passed over, no link to a folder is
/// followed, and nothing outside the tree decides: no ignore file of the user or of a repository.
pub(super) fn walk(folder: &Path, takes: &dyn Fn(&Path) -> bool, ignored: Ignored) -> io::Result<Vec<PathBuf>> {
    let mut walk = WalkBuilder::new(folder);
    let ignores = ignored == Ignored::LeftOut;
    walk.standard_filters(false).hidden(true).parents(ignores).ignore(ignores).git_ignore(ignores).require_git(false);
    if ignores {
        walk.add_custom_ignore_filename(IGNORE_FILE);
    }
    let mut found = Vec::new();
    for entry in walk.build() {
        let entry = entry.map_err(|error| match error.io_error() {
            Some(inner) => io::Error::new(inner.kind(), error.to_string()),
            None => io::Error::other(error.to_string()),
        })?;
        let path = entry.into_path();
        if path.is_file() && takes(&path) {
            found.push(path);
        }
    }
    found.sort();
    // What lies in `.` is called as the user would call it.
    Ok(found.into_iter().map(|path| path.strip_prefix(".").map(Path::to_path_buf).unwrap_or(path)).collect())
}

/// Which part a program belongs to depends on its name alone, as it lies from the current folder: other programs may come and go.
fn is_in(shard: Shard, path: &Path) -> bool {
    xxh3_64(place(path).as_bytes()) % u64::from(shard.of) == u64::from(shard.part - 1)
}

/// The way to a path from the current folder, however it was typed. Links of files are not followed: on another machine they
/// may lead elsewhere.
fn place(path: &Path) -> String {
    let here = env::current_dir().unwrap_or_default();
    let mut there = here.join(path);
    if !there.starts_with(&here) {
        // The current folder may have been reached by a link.
        let folder = there.parent().and_then(|folder| fs::canonicalize(folder).ok());
        let name = there.file_name().map(OsStr::to_os_string);
        if let Some((folder, name)) = folder.zip(name).filter(|(folder, _)| folder.starts_with(&here)) {
            there = folder.join(name);
        }
    }
    let (here, there) = (parts(&here), parts(&there));
    let same = here.iter().zip(&there).take_while(|(one, other)| one == other).count();
    let up = here[same..].iter().map(|_| "..");
    up.chain(there[same..].iter().map(String::as_str)).collect::<Vec<_>>().join("/")
}

fn parts(path: &Path) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if parts.last().is_some_and(|last| last != "..") => drop(parts.pop()),
            part => parts.push(part.as_os_str().to_string_lossy().into_owned()),
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_of_very_many_folders_is_cut_in_its_middle_and_the_name_is_not() {
        let name = "n".repeat(255);
        let text = format!("here/{}{name}: File name too long", "folder/".repeat(5000));
        let short = shortened(&text);
        assert!(short.starts_with("here/folder/") && short.ends_with(&format!("/{name}: File name too long")));
        assert_eq!(short.chars().count(), 601);
        assert_eq!(shortened("a/b: is a folder"), "a/b: is a folder");
    }

    #[test]
    fn each_program_is_in_one_shard() {
        for n in 0..100 {
            let path = PathBuf::from(format!("./a/P{n}.H"));
            let parts: Vec<u32> = (1..=7).filter(|part| is_in(Shard { part: *part, of: 7 }, &path)).collect();
            assert_eq!(parts.len(), 1, "{path:?}");
            let here = env::current_dir().unwrap();
            let typed = [format!("a/P{n}.H"), format!("a/../b/.././a/P{n}.H"), format!("{}/a/P{n}.H", here.display())];
            for other in typed {
                assert!(is_in(Shard { part: parts[0], of: 7 }, Path::new(&other)), "{other}");
            }
            // Above the current folder, too.
            let up = here.parent().unwrap().join(format!("P{n}.H"));
            assert_eq!(place(&up), format!("../P{n}.H"));
            assert_eq!(place(Path::new(&format!("./../P{n}.H"))), place(&up));
        }
    }
}
