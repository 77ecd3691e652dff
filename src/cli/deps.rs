//! `--deps FILE`: which files an output was made of, for make, ninja and others.

use std::collections::BTreeSet;
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::text::decode::escaped_json;

use super::disk::{IncludeRoots, shown, text_of};
use super::made::is_output;
use super::options::{Common, Deps, DepsFormat};
use super::output::Destination;
use super::paths::{is_source_name, real};
use super::report::Reporter;
use super::{Exit, Trouble, config};

/// How a list in JSON begins.
const JSON_HEAD: &[u8] = b"{\"version\":1,\"rules\":";
/// Bytes that are looked at to tell a list.
const HEAD: u64 = 1 << 16;

/// What something was made of.
#[derive(Debug, Default)]
pub(super) struct Rule {
    outputs: Vec<PathBuf>,
    /// The program first, the others in order.
    inputs: Vec<PathBuf>,
    /// Files that were looked for: with one of them there would be another result.
    absent: BTreeSet<PathBuf>,
}

impl Rule {
    /// One of all: what a report of many programs was made of.
    pub(super) fn together(rules: Vec<Rule>, output: Option<&Path>) -> Vec<Rule> {
        let mut all = Rule::default();
        all.outputs.extend(output.filter(|path| *path != Path::new("-")).map(Path::to_path_buf));
        let mut seen = BTreeSet::new();
        for rule in rules {
            all.inputs.extend(rule.inputs.into_iter().filter(|path| seen.insert(path.clone())));
            all.absent.extend(rule.absent);
        }
        vec![all]
    }
}

/// What `outputs` were made of: a program with what it calls, and what was in force for it.
fn rule(program: &Path, common: &Common, files: &IncludeRoots, outputs: &[&Path]) -> Result<Rule, Trouble> {
    let named = outputs.iter().filter(|path| **path != Path::new("-")).map(|path| path.to_path_buf());
    let mut rule = Rule { outputs: named.collect(), ..Rule::default() };
    let stdin = program == Path::new("-");
    if !stdin {
        rule.inputs.push(program.to_path_buf());
    }
    let path = common.stdin_filename.as_deref().filter(|_| stdin).unwrap_or(program);
    let read = config::read_for(path, common)?;
    let mut others: BTreeSet<PathBuf> = read.files.into_iter().map(|(_, path)| path).collect();
    rule.absent.extend(read.absent);
    for (path, looked) in files.looked() {
        if looked.found {
            others.insert(path);
        } else {
            rule.absent.insert(path);
        }
    }
    let own = real(program);
    rule.inputs.extend(others.into_iter().filter(|path| real(path) != own));
    Ok(rule)
}

impl Deps {
    /// Keeps the file off what is something else.
    ///
    /// # Errors
    /// A file that would be lost.
    pub fn spares(&self, inputs: &[&Path], outputs: &BTreeSet<PathBuf>, reporter: &Reporter) -> Result<(), Trouble> {
        let Some(file) = &self.deps else { return Ok(()) };
        let own = real(file);
        if reporter.files().any(|report| real(report) == own && report != Path::new("/dev/null")) {
            return Err(format!("{}: the list of files and a report cannot go to one file", file.display()));
        }
        let taken = outputs.contains(&own) || inputs.iter().any(|input| real(input) == own) || is_output(file);
        if taken || named_otherwise(file) || !may_be_replaced(file) {
            return Err(format!(
                "{}: the list of files would replace what is no such list; name another file",
                file.display()
            ));
        }
        Ok(())
    }

    /// The list, where one is written.
    pub fn file(&self) -> Option<&Path> {
        self.deps.as_deref()
    }

    /// What a program was made into `outputs` of, where somebody wants to know.
    ///
    /// # Errors
    /// A configuration that can be read no more.
    pub fn rule(
        &self,
        program: &Path,
        common: &Common,
        files: &IncludeRoots,
        outputs: &[&Path],
    ) -> Result<Option<Rule>, Trouble> {
        self.deps.is_some().then(|| rule(program, common, files, outputs)).transpose()
    }

    /// Writes the file. After a run that failed there is nothing that was made of anything, and an older list stays.
    ///
    /// # Errors
    /// A name that the form cannot hold; what the system reports.
    pub fn write(&self, rules: Vec<Rule>, exit: Exit) -> Result<Exit, Trouble> {
        let Some(file) = self.deps.as_deref().filter(|_| exit == Exit::Clean) else { return Ok(exit) };
        let name = file.display();
        let bytes = match self.deps_format {
            DepsFormat::Make => make(file, &rules).map_err(|why| format!("{name}: {why}"))?,
            DepsFormat::Json => json(&rules).into_bytes(),
        };
        let written = Destination::open(file).and_then(|mut out| out.write_all(&bytes).and_then(|()| out.commit()));
        written.map_err(|error| format!("{name}: {error}"))?;
        Ok(exit)
    }
}

/// Is its name that of something else?
fn named_otherwise(file: &Path) -> bool {
    // `x.d` is what compilers call such a list; a datum table is told by what it holds.
    let may_be_list = file.extension().is_some_and(|name| name.eq_ignore_ascii_case("d"));
    !may_be_list && is_source_name(file)
}

/// Nothing is there, or a list: rules of make, or ours in JSON.
fn may_be_replaced(file: &Path) -> bool {
    let Ok(meta) = std::fs::metadata(file) else { return true };
    if !meta.is_file() || meta.len() == 0 {
        return true;
    }
    let mut head = Vec::new();
    let read = std::fs::File::open(file).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    if read.is_err() {
        return false;
    }
    // A rule: the colon stands behind its first name, at the end of a line that goes on.
    let first = head.split(|byte| *byte == b'\n').next().unwrap_or_default();
    head.starts_with(JSON_HEAD) || first.ends_with(b": \\") || first.ends_with(b":")
}

/// A rule of make for each. What goes to standard output has the list itself for its target.
fn make(file: &Path, rules: &[Rule]) -> Result<Vec<u8>, Trouble> {
    let mut text = Vec::new();
    for rule in rules {
        let outputs = if rule.outputs.is_empty() { vec![file.to_path_buf()] } else { rule.outputs.clone() };
        for (at, output) in outputs.iter().enumerate() {
            if at > 0 {
                text.push(b' ');
            }
            escape(output, &mut text)?;
        }
        text.push(b':');
        for input in &rule.inputs {
            text.extend(b" \\\n  ");
            escape(input, &mut text)?;
        }
        text.push(b'\n');
    }
    Ok(text)
}

/// A name as make, ninja and the compilers that write such lists have it.
fn escape(path: &Path, text: &mut Vec<u8>) -> Result<(), Trouble> {
    let name = relative(path);
    for byte in name.as_os_str().as_encoded_bytes() {
        match byte {
            b' ' | b'\t' => {
                // A backslash in front of a blank would be taken for its escape.
                let before = text.iter().rev().take_while(|b| **b == b'\\').count();
                text.resize(text.len() + before + 1, b'\\');
            }
            b'#' => text.push(b'\\'),
            // On Windows the one behind a drive is known as such.
            b':' if !cfg!(windows) => text.push(b'\\'),
            b'$' => text.push(b'$'),
            b'\n' | b'\r' => return Err(format!("no list of make can hold a name such as {:?}", text_of(&name))),
            _ => {}
        }
        text.push(*byte);
    }
    Ok(())
}

/// The path from the current folder where it lies below that.
fn relative(path: &Path) -> PathBuf {
    let here = std::env::current_dir().ok();
    here.as_deref().and_then(|here| path.strip_prefix(here).ok()).unwrap_or(path).to_path_buf()
}

/// The one path of a file that does not exist, in folders that may not exist, either.
fn anchored(path: &Path) -> PathBuf {
    let known = path.ancestors().skip(1).find_map(|folder| {
        let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        Some(std::fs::canonicalize(here).ok()?.join(path.strip_prefix(folder).ok()?))
    });
    known.unwrap_or_else(|| path.to_path_buf())
}

fn json(rules: &[Rule]) -> String {
    let names = |paths: &mut dyn Iterator<Item = &PathBuf>| {
        let mut seen = BTreeSet::new();
        paths.map(|path| shown(path)).filter(|name| seen.insert(name.clone())).collect::<Vec<_>>()
    };
    // A folder may have been looked in by two of its names.
    let sorted = |paths: &BTreeSet<PathBuf>| paths.iter().map(|path| shown(&anchored(path))).collect::<BTreeSet<_>>();
    let list: Vec<_> = rules
        .iter()
        .map(|rule| {
            json!({
                "outputs": names(&mut rule.outputs.iter()),
                "inputs": names(&mut rule.inputs.iter()),
                "absent": sorted(&rule.absent),
            })
        })
        .collect();
    escaped_json(&json!({ "version": 1, "rules": list }).to_string()).into_owned() + "\n"
}
