//! The same programs under other circumstances: the same bytes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use super::process::{folder, run_with};
use crate::book::cases;

/// What was seen.
#[derive(Debug, Default)]
pub struct Same {
    pub programs: usize,
    pub outputs: usize,
    pub ways: usize,
    /// Ways under which something came out differently.
    pub differ: Vec<String>,
}

/// Outputs by name, and what was said.
type Came = (BTreeMap<PathBuf, Vec<u8>>, String);

/// Its name, threads, the folder from which it runs, and variables of the environment.
type Way<'a> = (&'a str, &'a str, &'a Path, &'a [(&'a str, &'a str)]);

/// Compiles every `step`-th golden program one at a time, then in every other way.
pub fn same(partc: &Path, under: &Path, step: usize) -> Same {
    let root = folder(under, "same");
    let programs = folder(&root, "in");
    let mut seen = Same::default();
    for (n, case) in cases("").into_iter().step_by(step).enumerate() {
        let extension = case.file.rsplit_once('.').map_or("H", |(_, extension)| extension);
        fs::write(programs.join(format!("P{n}.{extension}")), &case.program).expect("a program");
        seen.programs += 1;
    }
    let come = |jobs: &str, from: &Path, variables: &[(&str, &str)]| -> Came {
        let out = folder(&root, "out");
        let mut command = Command::new(partc);
        command.args(["compile", "--isolated", "--format", "concise", "--jobs", jobs, "--out-dir"]).arg(&out);
        // The programs have the same name from everywhere.
        command.arg(if from == root { PathBuf::from("in") } else { programs.clone() });
        command.envs(variables.iter().copied());
        let took = run_with(&mut command, from, Duration::from_secs(300));
        let mut files = BTreeMap::new();
        let mut open = vec![out.clone()];
        while let Some(next) = open.pop() {
            for entry in fs::read_dir(next).expect("a folder").flatten() {
                let path = entry.path();
                if path.is_dir() {
                    open.push(path);
                } else {
                    files.insert(
                        path.strip_prefix(&out).expect("inside").to_owned(),
                        fs::read(&path).expect("an output"),
                    );
                }
            }
        }
        // The last line says how long it took.
        let said = took.said.lines().filter(|line| !line.contains(" programs, ")).map(|line| format!("{line}\n"));
        (files, said.collect())
    };
    let first = come("1", &root, &[]);
    seen.outputs = first.0.len();
    let elsewhere = folder(&root, "elsewhere");
    let ways: [Way<'_>; 7] = [
        ("again", "1", &root, &[]),
        ("two threads", "2", &root, &[]),
        ("eight threads", "8", &root, &[]),
        ("German", "2", &root, &[("LC_ALL", "de_DE.UTF-8"), ("LANG", "de_DE.UTF-8")]),
        ("Turkish", "2", &root, &[("LC_ALL", "tr_TR.UTF-8")]),
        ("another time zone", "2", &root, &[("TZ", "Pacific/Kiritimati")]),
        ("another folder", "2", &elsewhere, &[]),
    ];
    for (way, jobs, from, variables) in ways {
        seen.ways += 1;
        let (files, said) = come(jobs, from, variables);
        // From another folder findings name the programs otherwise.
        if files != first.0 || from == root && said != first.1 {
            seen.differ.push(way.to_owned());
        }
    }
    seen
}
