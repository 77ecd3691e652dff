//! Runs over real programs that lie beside the repository: what compiles, what is refused and why.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use partc::internals::text::{FileError, Files, Memory, Opened, Request};

use super::common::{compile_bytes, settings};
use super::oracle::Case;
use super::rs274::{self, Job};
use super::tools::beside_repository;

/// Longest time for one program, even unoptimized.
const SOON: Duration = Duration::from_secs(60);

fn programs(folder: &Path) -> Vec<PathBuf> {
    let mut folders = vec![folder.to_path_buf()];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a readable folder") {
            let path = entry.expect("a readable entry").path();
            if path.is_dir() { folders.push(path) } else { found.push(path) }
        }
    }
    found.sort();
    found
}

/// Called programs, from anywhere in the repository that the caller came from.
struct Repository {
    /// Name without folders in lower case, and the file.
    files: Vec<(String, PathBuf)>,
}

impl Repository {
    fn new(folder: &Path) -> Repository {
        let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().to_lowercase();
        Repository { files: programs(folder).into_iter().map(|path| (name(&path), path)).collect() }
    }
}

impl Files for Repository {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let name = request.name.rsplit(['/', '\\', ':']).next().unwrap_or(request.name).to_lowercase();
        let wanted = std::iter::once(name.clone()).chain(request.extensions.iter().map(|e| format!("{name}.{e}")));
        for wanted in wanted {
            if let Some((_, path)) = self.files.iter().find(|(known, _)| *known == wanted.to_lowercase()) {
                let text = Box::new(Memory::new(fs::read(path).expect("a readable program")));
                let name = path.display().to_string();
                return Ok(Opened { name: name.clone(), identity: name, text });
            }
        }
        Err(FileError::NotFound { tried: vec![name], similar: Vec::new() })
    }
}

fn sweep(dialect: &str, corpus: &str, options: &str) {
    let Some(folder) = beside_repository(corpus) else { return };
    let options = settings(options);
    let oracle = rs274::available();
    let mut failures = Vec::new();
    let mut cases: Vec<Case> = Vec::new();
    let all = programs(&folder);
    let mut repository = (PathBuf::new(), Repository { files: Vec::new() });
    for path in &all {
        let own = path.strip_prefix(&folder).expect("inside").components().next().expect("a name");
        let own = folder.join(own);
        if repository.0 != own {
            repository = (own.clone(), Repository::new(&own));
        }
        let name = path.strip_prefix(&folder).expect("inside").display().to_string();
        let bytes = fs::read(path).expect("a readable program");
        let size = bytes.len();
        let start = Instant::now();
        let compiled = compile_bytes(&name, bytes.clone(), dialect, &options, &repository.1);
        if start.elapsed() > SOON {
            failures.push(format!("{name}: took {:?}", start.elapsed()));
        }
        for found in &compiled.findings {
            let main = found.label.loc.file.0 == 0;
            if found.label.loc.line == 0 || main && found.label.loc.span.start as usize > size {
                failures.push(format!("{name}: no place: {found:?}"));
            }
        }
        if compiled.has_errors() {
            let mut codes = compiled.codes();
            codes.sort_unstable();
            codes.dedup();
            println!("refused   {name}: {}", codes.join(" "));
            continue;
        }
        println!("compiled  {name}");
        cases.push(Case::new(name, compiled, bytes, dialect, &options, &repository.1));
    }
    if oracle {
        let jobs: Vec<Job<'_>> = cases.iter().map(|case| Job::new(&case.output)).collect();
        for (case, answer) in cases.iter().zip(rs274::interpret_all(&jobs)) {
            if let Err(why) = answer.and_then(|found| case.judge(&found)) {
                failures.push(format!("{}: {why}", case.name));
            }
        }
    }
    println!("{} of {} programs in {corpus} compile", cases.len(), all.len());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn heidenhain() {
    sweep("klartext", "corpus/heidenhain", include_str!("../sweep/heidenhain.toml"));
}

#[test]
fn sinumerik() {
    sweep("sinumerik", "corpus/sinumerik", include_str!("../sweep/sinumerik.toml"));
}

#[test]
fn rexroth() {
    sweep("mtc200", "corpus/rexroth", include_str!("../sweep/rexroth.toml"));
}
