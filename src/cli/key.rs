//! `partc key`: a name for everything that a result depends on.
//!
//! The same program with the same called programs, configuration and tables under the same version has the same key, on every
//! machine and in every folder; where one byte of them differs, or a file appears that was looked for, it has another one.

use std::fs::File;
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use xxhash_rust::xxh3::Xxh3;

use crate::emit::Output;
use crate::text::decode::harmless_lines;
use crate::text::{FileId, Sources};

use super::args::Key;
use super::disk::file_name;
use super::inputs::{Input, inputs};
use super::listing::print;
use super::options::Common;
use super::pool::in_order;
use super::program::{Loaded, is_program, load};
use super::{Exit, Trouble, config, say};

/// Raised where the same inputs shall have another key.
const VERSION: &str = "3";

/// Prints a line for each program: its key and its path, as `sha256sum` would.
pub(super) fn key(args: &Key) -> Result<Exit, Trouble> {
    let found = inputs(&args.paths, &args.many, &|path| is_program(path, &args.common))?;
    let mut troubles = found.troubles;
    let mut lines = String::new();
    in_order(
        args.many.jobs,
        &found.list,
        |input| of(input, args),
        |done, result: Result<String, Trouble>| match result {
            Ok(key) => lines += &line(&key, &found.list[done].path),
            Err(trouble) => troubles.push(trouble),
        },
    );
    print(harmless_lines(&lines).as_bytes())?;
    troubles.iter().for_each(|trouble| say(&format!("partc: {trouble}")));
    Ok(if troubles.is_empty() { Exit::Clean } else { Exit::Usage })
}

/// As `sha256sum` has it: a name that would break the line is escaped, and the line begins with a backslash.
fn line(key: &str, path: &Path) -> String {
    let name = path.display().to_string();
    if !name.contains(['\n', '\r', '\\']) {
        return format!("{key}  {name}\n");
    }
    let escaped = name.replace('\\', "\\\\").replace('\n', "\\n").replace('\r', "\\r");
    format!("\\{key}  {escaped}\n")
}

/// Everything goes in with its length in front, so that no two lists are one.
#[derive(Default)]
struct Hash(Xxh3);

impl Hash {
    fn part(&mut self, bytes: &[u8]) {
        self.0.update(&(bytes.len() as u64).to_le_bytes());
        self.0.update(bytes);
    }

    fn text(&mut self, text: &str) {
        self.part(text.as_bytes());
    }

    fn file(&mut self, path: &Path) -> io::Result<()> {
        let mut content = Xxh3::new();
        let mut file = File::open(path)?;
        let mut buffer = vec![0; 1 << 16];
        loop {
            let n = file.read(&mut buffer)?;
            if n == 0 {
                break;
            }
            content.update(&buffer[..n]);
        }
        self.part(&content.digest128().to_le_bytes());
        Ok(())
    }
}

fn of(input: &Input, args: &Key) -> Result<String, Trouble> {
    let (path, common) = (&input.path, &args.common);
    let trouble = |path: &Path, error: io::Error| format!("{}: {error}", path.display());
    let Loaded { session, dialect, settings, files, .. } = load(path, common)?;
    // What is called shows in a run only.
    let _ = session.compile(dialect, &settings, &files, &mut Nowhere, None);
    let mut hash = Hash::default();
    hash.text(VERSION);
    hash.text(env!("CARGO_PKG_VERSION"));
    hash.text(dialect.id);
    said(&mut hash, common);
    let model = args.timing.model();
    [model.rapid, model.acceleration, model.tool_change].iter().for_each(|value| hash.text(&value.to_string()));
    let named = common.stdin_filename.as_deref().filter(|_| path == Path::new("-")).unwrap_or(path);
    hash.text(&file_name(named));
    main_program(&mut hash, &session.sources);
    let read = config::read_for(named, common)?;
    for (what, file) in &read.files {
        hash.text(what);
        // Patterns and roots count from here.
        hash.text(&between(file, named).unwrap_or_default());
        hash.file(file).map_err(|error| trouble(file, error))?;
    }
    let mut looked: Vec<_> = files.looked().into_iter().map(|(path, looked)| (looked, path)).collect();
    // Where a file lies is no part of it, and neither is the order of folders.
    looked.sort();
    let mut parts = Vec::new();
    for (looked, file) in &looked {
        let mut part = Hash::default();
        part.text(&looked.name);
        part.text(&between(file, named).unwrap_or_default());
        if looked.found {
            part.file(file).map_err(|error| trouble(file, error))?;
        }
        parts.push(part.0.digest128());
    }
    parts.sort_unstable();
    parts.iter().for_each(|part| hash.part(&part.to_le_bytes()));
    files.unchanged()?;
    Ok(format!("{:032x}", hash.0.digest128()))
}

/// What the command line says about the result.
fn said(hash: &mut Hash, common: &Common) {
    hash.text(common.target.as_deref().unwrap_or_default());
    hash.text(&common.numbers.map(|step| step.to_string()).unwrap_or_default());
    hash.text(common.compensation.as_deref().unwrap_or_default());
    for words in [&common.report.select, &common.report.ignore] {
        hash.text(&words.as_ref().map(|words| words.join(",")).unwrap_or_default());
        hash.text(if words.is_some() { "said" } else { "" });
    }
}

fn main_program(hash: &mut Hash, sources: &Sources) {
    let mut content = Xxh3::new();
    let (mut at, mut buffer) = (0, vec![0; 1 << 16]);
    while let Ok(n @ 1..) = sources.read_at(FileId(0), at, &mut buffer) {
        content.update(&buffer[..n]);
        at += n as u64;
    }
    hash.part(&content.digest128().to_le_bytes());
}

/// The way from the folder of a file to another one where it lies below that, or the other way round: the same wherever both
/// of them are.
fn between(file: &Path, program: &Path) -> Option<String> {
    let folder = |path: &Path| -> Option<PathBuf> {
        let folder = path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."));
        std::fs::canonicalize(folder).ok()
    };
    let (one, other) = (folder(file)?, folder(program)?);
    let down = other.strip_prefix(&one).map(|way| format!("down/{}", way.display()));
    let up = || one.strip_prefix(&other).map(|way| format!("up/{}", way.display()));
    down.or_else(|_| up()).ok().map(|way| way.replace('\\', "/"))
}

/// An output that keeps nothing.
pub(super) struct Nowhere;

impl Output for Nowhere {
    fn append(&mut self, _: &[u8]) -> io::Result<()> {
        Ok(())
    }

    fn patch(&mut self, _: u64, _: &[u8]) -> io::Result<()> {
        Ok(())
    }
}
