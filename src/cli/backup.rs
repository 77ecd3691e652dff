//! A backup of a control: the folders beside that of a program whose names are those of the control's folders.
//!
//! In: the folder of a program, and what the configuration says. Out: which folder of this computer stands for which one of the
//! control. Nothing outside those folders is named, and a link that leads elsewhere is not followed.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::text::ControlFolder;

/// The folders of the control that no configuration names, where the program lies in one of them.
#[derive(Debug, Default)]
pub(super) struct Backup {
    /// The folder that holds them; none where the program lies in no such folder.
    root: Option<PathBuf>,
    folders: Vec<(&'static ControlFolder, Copies)>,
}

/// What stands for a folder of the control on this computer.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Copies {
    None,
    One(PathBuf),
    /// Of these nobody knows which is meant.
    Several(Vec<PathBuf>),
    /// A link to another place.
    LeadsOut(PathBuf),
}

/// What a name of the control comes to.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Sought<'n> {
    /// It lies in this folder, under this name.
    In(PathBuf, &'n str),
    /// In any of these, under this name.
    InSeveral(Vec<PathBuf>, &'n str),
    /// The folder is a link that leads out of the backup.
    LeadsOut(PathBuf),
    /// The backup has no such folder; with one of these files it would have.
    Absent(Vec<PathBuf>),
}

impl Backup {
    /// The one in which `base` lies, the folder of a program. `folders` are those of its control, `roots` the prefixes that the
    /// configuration gives folders to: it goes before what is found.
    pub fn around<'r>(
        base: &Path,
        folders: &'static [ControlFolder],
        roots: impl Iterator<Item = &'r String> + Clone,
    ) -> Backup {
        let found = || {
            let real = fs::canonicalize(base).ok()?;
            let up = folders.iter().find_map(|folder| levels_up(&real, folder))?;
            let real_root = real.ancestors().nth(up)?.to_path_buf();
            Some((root_of(base, up, &real_root), real_root))
        };
        let Some((root, real_root)) = found() else { return Backup::default() };
        let names: Vec<String> = match fs::read_dir(or_here(&root)) {
            Ok(entries) => entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect(),
            Err(_) => return Backup::default(),
        };
        let open = folders.iter().filter(|folder| !roots.clone().any(|prefix| names_it(prefix, folder)));
        let folders = open.map(|folder| (folder, Copies::of(folder, &names, &root, &real_root))).collect();
        Backup { root: Some(root), folders }
    }

    /// Where a name of the control leads; `None` for one that is none of these folders'.
    pub fn seek<'n>(&self, name: &'n str) -> Option<Sought<'n>> {
        let root = self.root.as_ref()?;
        let (folder, copies, rest) = self.folders.iter().find_map(|(folder, copies)| {
            let (head, rest) = name.split_at_checked(folder.path.len())?;
            let is_it = head.eq_ignore_ascii_case(folder.path) && rest.starts_with('/');
            is_it.then_some((folder, copies, rest.trim_start_matches('/')))
        })?;
        Some(match copies {
            Copies::None => Sought::Absent(folder.copies.iter().map(|copy| root.join(copy).join(rest)).collect()),
            Copies::One(path) => Sought::In(path.clone(), rest),
            Copies::Several(paths) => Sought::InSeveral(paths.clone(), rest),
            Copies::LeadsOut(path) => Sought::LeadsOut(path.clone()),
        })
    }

    /// The folder that stands for `folder` of the control.
    pub fn copy_of(&self, folder: &str) -> Option<(&Path, &'static str)> {
        self.folders.iter().find_map(|(known, copies)| match copies {
            Copies::One(path) if is_in(folder, known.path) => Some((path.as_path(), known.path)),
            _ => None,
        })
    }

    /// All folders that stand for one.
    pub fn folders(&self) -> impl Iterator<Item = &Path> {
        self.folders.iter().filter_map(|(_, copies)| match copies {
            Copies::One(path) => Some(path.as_path()),
            _ => None,
        })
    }
}

impl Copies {
    fn of(folder: &ControlFolder, names: &[String], root: &Path, real_root: &Path) -> Copies {
        let mut found: BTreeMap<PathBuf, PathBuf> = BTreeMap::new();
        for name in names.iter().filter(|name| folder.is_copied_as(name)) {
            let path = root.join(name);
            match fs::canonicalize(&path) {
                Ok(real) if real.parent() != Some(real_root) => return Copies::LeadsOut(path),
                Ok(real) if real.is_dir() => drop(found.entry(real).or_insert(path)),
                Ok(_) | Err(_) => {}
            }
        }
        let mut paths = found.into_values().collect::<Vec<_>>();
        match paths.len() {
            0 => Copies::None,
            1 => Copies::One(paths.remove(0)),
            _ => Copies::Several(paths),
        }
    }
}

/// How many levels above a folder of programs the folder of the backup lies, where the programs lie in this one of the control.
fn levels_up(real: &Path, folder: &ControlFolder) -> Option<usize> {
    let mut names = real.iter().rev().map(|name| name.to_string_lossy());
    let (own, above) = (names.next()?, names.next());
    let is_below = |ending: &&str| own.len() > ending.len() && own.to_uppercase().ends_with(*ending);
    if folder.below.is_empty() {
        folder.is_copied_as(&own).then_some(1)
    } else {
        (folder.below.iter().any(is_below) && folder.is_copied_as(&above?)).then_some(2)
    }
}

/// The folder of the backup as it is reached from here.
fn root_of(base: &Path, up: usize, real_root: &Path) -> PathBuf {
    let plain: PathBuf = base.components().filter(|part| *part != Component::CurDir).collect();
    let is_it = |path: &&Path| fs::canonicalize(or_here(path)).is_ok_and(|real| real == real_root);
    match plain.ancestors().nth(up).filter(is_it) {
        Some(above) => above.to_path_buf(),
        None => (0..up).fold(plain, |path, _| path.join("..")),
    }
}

/// The path, or that of the current folder where there is nothing of it.
fn or_here(path: &Path) -> &Path {
    if path.as_os_str().is_empty() { Path::new(".") } else { path }
}

/// Is this prefix of the configuration one of the folder, or of all?
fn names_it(prefix: &str, folder: &ControlFolder) -> bool {
    let prefix = prefix.replace('\\', "/");
    let prefix = prefix.get(..5).filter(|head| head.eq_ignore_ascii_case("//NC:")).map_or(&*prefix, |_| &prefix[5..]);
    let first = prefix.split('/').find(|part| !part.is_empty());
    prefix.starts_with('/') && first.is_none_or(|first| folder.is_copied_as(first))
}

/// Is `folder` this one of the control, or below it?
fn is_in(folder: &str, of: &str) -> bool {
    folder.strip_prefix(of).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}
