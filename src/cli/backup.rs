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
    home: Option<Home>,
}

/// The folder in which the program lies, where no configuration names it.
#[derive(Debug)]
struct Home {
    /// Of the control; its last part as it is called here.
    folder: String,
    copies: Copies,
}

/// What stands for a folder of the control on this computer.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Copies {
    None,
    One(PathBuf),
    /// Of these nobody knows which is meant.
    Several(Vec<PathBuf>),
    /// It cannot be used, and why: a link to another place, or no folder at all.
    Unfit(PathBuf, &'static str),
}

/// What a name of the control comes to.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Sought<'n> {
    /// It lies in this folder, under this name.
    In(PathBuf, &'n str),
    /// In any of these, under this name.
    InSeveral(Vec<PathBuf>, &'n str),
    /// What stands for the folder cannot be used, and why.
    Unfit(PathBuf, &'static str),
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
            let (own, up) = folders.iter().find_map(|folder| Some((folder, levels_up(&real, folder)?)))?;
            let real_root = real.ancestors().nth(up)?.to_path_buf();
            Some((root_of(base, up, &real_root), real_root, own, real))
        };
        let Some((root, real_root, own, real)) = found() else { return Backup::default() };
        let Some(names) = names_in(&root) else { return Backup::default() };
        let open = folders.iter().filter(|folder| !roots.clone().any(|prefix| names_it(prefix, folder)));
        let of = |folder: &ControlFolder| Copies::among(&names, |name| folder.is_copied_as(name), &root, &real_root);
        let folders: Vec<_> = open.map(|folder| (folder, of(folder))).collect();
        let home = folders.iter().find(|(folder, _)| folder.path == own.path);
        let home = home.map(|(folder, copies)| Home::of(folder, copies, &real));
        Backup { root: Some(root), folders, home }
    }

    /// The folder of the control in which the program lies, because of the names here; its last part as it is called here.
    pub fn home(&self) -> Option<&str> {
        self.home.as_ref().map(|home| home.folder.as_str())
    }

    /// Where a file beside the program is looked for, if its folder has more than one copy, or one that cannot be used.
    pub fn seek_beside<'n>(&self, name: &'n str) -> Option<Sought<'n>> {
        match &self.home.as_ref()?.copies {
            Copies::None | Copies::One(_) => None,
            Copies::Several(paths) => Some(Sought::InSeveral(paths.clone(), name)),
            Copies::Unfit(path, why) => Some(Sought::Unfit(path.clone(), why)),
        }
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
            Copies::Unfit(path, why) => Sought::Unfit(path.clone(), why),
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

impl Home {
    fn of(folder: &ControlFolder, copies: &Copies, real: &Path) -> Home {
        let own = real.file_name().map_or_else(String::new, |name| name.to_string_lossy().to_uppercase());
        if folder.below.is_empty() {
            return Home { folder: folder.path.to_owned(), copies: copies.clone() };
        }
        let path = format!("{}/{own}", folder.path);
        let parents = match copies {
            Copies::None => &[][..],
            Copies::One(parent) => std::slice::from_ref(parent),
            Copies::Several(parents) => parents,
            Copies::Unfit(..) => return Home { folder: path, copies: copies.clone() },
        };
        let wanted = stem_below(&own, folder);
        let mut all = Vec::new();
        for parent in parents {
            let (Some(names), Ok(real)) = (names_in(parent), fs::canonicalize(parent)) else { continue };
            match Copies::among(&names, |name| stem_below(name, folder) == wanted, parent, &real) {
                Copies::None => {}
                Copies::One(one) => all.push(one),
                Copies::Several(several) => all.extend(several),
                unfit @ Copies::Unfit(..) => return Home { folder: path, copies: unfit },
            }
        }
        Home { folder: path, copies: Copies::from(all) }
    }
}

impl Copies {
    /// Those of the names in a folder that are copies of one of the control.
    fn among(names: &[String], is_copy: impl Fn(&str) -> bool, root: &Path, real_root: &Path) -> Copies {
        let mut found: BTreeMap<PathBuf, PathBuf> = BTreeMap::new();
        for name in names.iter().filter(|name| is_copy(name)) {
            let path = root.join(name);
            if let Some(why) = no_folder(&path) {
                return Copies::Unfit(path, why);
            }
            match fs::canonicalize(&path) {
                Ok(real) if real.parent() == Some(real_root) => drop(found.entry(real).or_insert(path)),
                Ok(_) => {
                    return Copies::Unfit(path, "is a link that leads out of the folder in which the others lie");
                }
                Err(_) => return Copies::Unfit(path, "cannot be read"),
            }
        }
        Copies::from(found.into_values().collect())
    }

    fn from(mut paths: Vec<PathBuf>) -> Copies {
        match paths.len() {
            0 => Copies::None,
            1 => Copies::One(paths.remove(0)),
            _ => Copies::Several(paths),
        }
    }
}

/// Why what has this name is no folder; `None` for a folder, and where there is nothing.
pub(super) fn no_folder(path: &Path) -> Option<&'static str> {
    match fs::metadata(or_here(path)) {
        Ok(meta) if meta.is_dir() => None,
        Ok(_) => Some("is no folder"),
        Err(_) => path.symlink_metadata().is_ok().then_some("is a link that leads nowhere"),
    }
}

/// The names in a folder; `None` where it cannot be read.
fn names_in(folder: &Path) -> Option<Vec<String>> {
    let entries = fs::read_dir(or_here(folder)).ok()?;
    let mut names: Vec<String> = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect();
    names.sort();
    Some(names)
}

/// `SHAFT` of `SHAFT.WPD` and `_N_SHAFT_WPD`; `None` for what is called otherwise.
fn stem_below(name: &str, folder: &ControlFolder) -> Option<String> {
    let name = name.to_uppercase();
    let stem = folder.below.iter().find_map(|ending| name.strip_suffix(ending)).filter(|stem| !stem.is_empty())?;
    Some(stem.strip_prefix("_N_").unwrap_or(stem).to_owned())
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
