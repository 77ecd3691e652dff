//! The copy of the project that holds the changes, and what switches them on.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::process::Command;

use super::list::{self, Mutant};
use super::{Places, Result, edit};

/// Stands behind the modules of the library. A change is asked for by its number in the order of the sample.
const SWITCH: &str = r#"
pub(crate) mod mutation {
    use std::io::Write;
    use std::sync::OnceLock;
    use std::sync::atomic::{AtomicBool, Ordering};

    static ACTIVE: OnceLock<u32> = OnceLock::new();
    static REACHED: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];

    #[inline]
    pub(crate) fn on(number: u32) -> bool {
        let active = *ACTIVE.get_or_init(active);
        if active == u32::MAX {
            reached(number);
        }
        active == number
    }

    #[cold]
    fn active() -> u32 {
        if std::env::var_os("PARTC_MUTANTS_REACHED").is_some() {
            return u32::MAX;
        }
        std::env::var("PARTC_MUTANT").ok().and_then(|number| number.parse().ok()).unwrap_or(0)
    }

    fn reached(number: u32) {
        if REACHED[number as usize].swap(true, Ordering::Relaxed) {
            return;
        }
        let Some(path) = std::env::var_os("PARTC_MUTANTS_REACHED") else { return };
        if let Ok(mut file) = std::fs::OpenOptions::new().append(true).create(true).open(path) {
            let _ = file.write_all(format!("{number}\n").as_bytes());
        }
    }
}
"#;

/// Numbers that are left out of the build, with the reason.
pub fn left_out(places: &Places) -> BTreeMap<usize, String> {
    let text = fs::read_to_string(places.work.join("left_out.tsv")).unwrap_or_default();
    text.lines()
        .filter_map(|line| line.split_once('\t'))
        .filter_map(|(n, why)| Some((n.parse().ok()?, why.into())))
        .collect()
}

/// Adds to what is left out.
pub fn leave_out(places: &Places, new: &BTreeMap<usize, String>) -> Result<()> {
    let mut all = left_out(places);
    all.extend(new.iter().map(|(number, why)| (*number, why.clone())));
    let lines: String = all.iter().map(|(number, why)| format!("{number}\t{why}\n")).collect();
    Ok(fs::write(places.work.join("left_out.tsv"), lines)?)
}

/// Copies the project and builds the sample in, but for what is left out.
pub fn lay_out(places: &Places) -> Result<()> {
    let out = Command::new("git").args(["ls-files", "-z"]).current_dir(&places.project).output()?;
    let listed = String::from_utf8(out.stdout)?;
    let files: BTreeSet<&str> = listed.split('\0').filter(|file| !file.is_empty()).collect();
    let tree = places.tree();
    let sample = list::read(places)?;
    let left_out = left_out(places);
    let mut by_file: BTreeMap<&str, Vec<&Mutant>> = BTreeMap::new();
    for mutant in sample.iter().filter(|mutant| !left_out.contains_key(&mutant.number)) {
        by_file.entry(&mutant.file).or_default().push(mutant);
    }
    let mut unsaid = BTreeMap::new();
    for file in files {
        let from = places.project.join(file);
        if !from.is_file() {
            continue;
        }
        let to = tree.join(file);
        if let Some(folder) = to.parent() {
            fs::create_dir_all(folder)?;
        }
        let mut bytes = fs::read(&from)?;
        if let Some(mutants) = by_file.get(file) {
            let (text, not_said) = edit::apply(&String::from_utf8(bytes)?, mutants)?;
            bytes = text.into_bytes();
            unsaid.extend(not_said.into_iter().map(|(number, why)| (number, why.to_owned())));
        }
        if file == "src/lib.rs" {
            bytes.extend(SWITCH.replace("COUNT", &(sample.len() + 1).to_string()).bytes());
        }
        // What is as it was keeps its time, and is not compiled again.
        if fs::read(&to).ok().as_ref() != Some(&bytes) {
            fs::write(&to, bytes)?;
            fs::set_permissions(&to, fs::metadata(&from)?.permissions())?;
        }
    }
    leave_out(places, &unsaid)
}
