//! Runs over real programs that lie beside the repository: what compiles, what is refused and why.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use partc::text::files::NoFiles;

use super::common::{beside_repository, compile_bytes, settings};
use super::rs274;

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

fn sweep(dialect: &str, corpus: &str, options: &str) {
    let Some(folder) = beside_repository(corpus) else { return };
    let options = settings(options);
    let oracle = rs274::available();
    let (mut compiled_count, mut failures) = (0, Vec::new());
    let all = programs(&folder);
    for path in &all {
        let name = path.strip_prefix(&folder).expect("inside").display().to_string();
        let bytes = fs::read(path).expect("a readable program");
        let size = bytes.len();
        let start = Instant::now();
        let compiled = compile_bytes(&name, bytes, dialect, &options, &NoFiles);
        if start.elapsed() > SOON {
            failures.push(format!("{name}: took {:?}", start.elapsed()));
        }
        for found in &compiled.findings {
            if found.label.loc.line == 0 || found.label.loc.span.start as usize > size {
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
        compiled_count += 1;
        println!("compiled  {name}");
        if oracle && let Err(why) = rs274::interpret(&compiled.output, &format!("sweep-{dialect}")) {
            failures.push(format!("{name}: {why}"));
        }
    }
    println!("{compiled_count} of {} programs in {corpus} compile", all.len());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn heidenhain() {
    sweep("klartext", "corpus/heidenhain", include_str!("../sweep/heidenhain.toml"));
}

#[test]
fn rexroth() {
    sweep("mtc200", "corpus/rexroth", include_str!("../sweep/rexroth.toml"));
}
