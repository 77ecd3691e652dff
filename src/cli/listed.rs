//! What lies in the folders in which called programs are looked for: each is listed once.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::machine::tree::did_you_mean;
use crate::text::FileError;

use super::regular::ordinary;

/// The names in each folder, by how they are written in capitals; none for a folder that cannot be listed.
pub(super) type Listings = RefCell<BTreeMap<PathBuf, Option<BTreeMap<String, Vec<String>>>>>;

/// Finds the file below `folder`; upper and lower case do not matter where one name fits. Names that differ in nothing else are one
/// name on a control, so that none of them is the right one.
pub(super) fn find(folder: &Path, parts: &[String], listed: &Listings) -> Result<Option<PathBuf>, FileError> {
    let mut path = folder.to_path_buf();
    for part in parts {
        let mut listed = listed.borrow_mut();
        let names = listed.entry(path.clone()).or_insert_with(|| names_in(&path)).as_ref();
        let fitting = names.and_then(|names| names.get(&part.to_ascii_uppercase())).map_or(&[][..], Vec::as_slice);
        match fitting {
            [one] => path = path.join(one),
            // A folder that cannot be listed, or a file that came after.
            [] if path.join(part).symlink_metadata().is_ok() => path = path.join(part),
            [] => return Ok(None),
            _ => return Err(FileError::Ambiguous { names: fitting.to_vec() }),
        }
    }
    Ok(ordinary(&path)?.map(|()| path))
}

fn names_in(folder: &Path) -> Option<BTreeMap<String, Vec<String>>> {
    let mut names: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for name in fs::read_dir(folder).ok()?.filter_map(|entry| entry.ok()?.file_name().into_string().ok()) {
        names.entry(name.to_ascii_uppercase()).or_default().push(name);
    }
    names.values_mut().for_each(|fitting| fitting.sort());
    Some(names)
}

/// Fewest letters of a name that another one may be near to.
const SHORTEST_LIKE: usize = 3;

/// A program in the folder with a name near to this one. Of very short names any other would be near.
pub(super) fn like(folder: &Path, name: &str, extensions: &[&str], listed: &Listings) -> Option<String> {
    let (stem, extension) = name.rsplit_once('.').map_or((name, None), |(stem, extension)| (stem, Some(extension)));
    if stem.chars().count() < SHORTEST_LIKE {
        return None;
    }
    let program = |name: &String| {
        name.rsplit_once('.').is_some_and(|(stem, found)| {
            let kind = extensions.iter().chain(&extension).any(|wanted| wanted.eq_ignore_ascii_case(found));
            kind && stem.chars().count() >= SHORTEST_LIKE
        })
    };
    let mut listed = listed.borrow_mut();
    let known = listed.entry(folder.to_path_buf()).or_insert_with(|| names_in(folder)).as_ref()?;
    let mut names: Vec<&String> = known.values().flatten().filter(|name| program(name)).collect();
    names.sort();
    let stems = names.iter().filter_map(|name| name.rsplit_once('.')).map(|(stem, _)| stem);
    let near = did_you_mean(stem, stems)?;
    names.iter().find(|name| name.rsplit_once('.').is_some_and(|(stem, _)| stem == near)).map(|name| (*name).clone())
}
