//! Files of this computer: reading programs, and opening called ones inside the include roots only.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Component, Path, PathBuf};

use crate::text::{ControlFolder, FileError, Files, Memory, Opened, ReadAt, Request, Within};

use super::Trouble;
use super::backup::{Backup, Sought, no_folder};
use super::listed::{Listings, find, like};
use super::stamp::{CHANGED, Stamp};

use super::regular::{is_pipe, metadata, open_regular, ordinary};

/// After so many names that no file has none is proposed any more: all would be compared with every file of a folder.
const MOST_MISSED: u32 = 500;
/// Longest name of a called program.
const LONGEST_NAME: usize = 255;
/// Most bytes that are taken from a pipe or from standard input: they are held in memory.
const LARGEST_STREAM: u64 = 256 << 20;
/// Most bytes of a configuration or a tool table.
const LARGEST_SETTINGS: u64 = 16 << 20;
/// Names that Windows gives to devices.
const DEVICES: &[&str] = &["CON", "PRN", "AUX", "NUL", "CLOCK$", "CONIN$", "CONOUT$"];

/// A file read where it lies.
pub(super) struct OnDisk {
    file: File,
    stamp: Stamp,
    at: u64,
}

impl OnDisk {
    pub(super) fn open(path: &Path) -> io::Result<OnDisk> {
        let file = open_regular(path)?;
        let meta = file.metadata()?;
        Ok(OnDisk { file, stamp: Stamp::of(&meta), at: 0 })
    }
}

impl ReadAt for OnDisk {
    fn len(&self) -> u64 {
        self.stamp.len()
    }

    /// What was read so far, this part included, is of one version of the file; otherwise it is not given.
    fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize> {
        if self.at != at {
            self.file.seek(SeekFrom::Start(at))?;
            self.at = at;
        }
        let n = loop {
            match self.file.read(buf) {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                other => break other?,
            }
        };
        self.at += n as u64;
        if Stamp::of(&self.file.metadata()?) != self.stamp {
            return Err(io::Error::other(CHANGED));
        }
        Ok(n)
    }
}

/// A main program: an ordinary file, a pipe, or standard input.
pub(super) fn open_main(path: &Path, stdin_name: Option<&Path>) -> io::Result<Opened> {
    if path == Path::new("-") {
        let bytes = read_stream(io::stdin().lock(), LARGEST_STREAM)?;
        let name = stdin_name.map_or_else(|| "stdin".to_owned(), text_of);
        // The file of this name is the program, too, when it calls itself.
        let identity = stdin_name.and_then(|name| fs::canonicalize(name).ok());
        let identity = identity.as_deref().map(text_of).unwrap_or_default();
        return Ok(Opened { name, identity, text: Box::new(Memory::new(bytes)) });
    }
    let name = text_of(path);
    let meta = fs::metadata(path)?;
    if meta.is_file() {
        let identity = text_of(&fs::canonicalize(path)?);
        return Ok(Opened { name, identity, text: Box::new(OnDisk::open(path)?) });
    }
    if meta.is_dir() {
        return Err(io::Error::other("is a folder"));
    }
    if !is_pipe(&meta) {
        return Err(io::Error::other("is a device; a program comes from an ordinary file, a pipe or `-`"));
    }
    // A pipe can be read once only, and has no place among the folders: no program calls it again.
    let bytes = read_stream(File::open(path)?, LARGEST_STREAM)?;
    Ok(Opened { identity: name.clone(), name, text: Box::new(Memory::new(bytes)) })
}

/// Everything that comes, up to a bound: what never ends must not fill the memory.
fn read_stream(from: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        let most = most >> 20;
        return Err(io::Error::other(format!("more than {most} MiB come through a pipe; save the program as a file")));
    }
    Ok(bytes)
}

thread_local! {
    /// Configurations and tables that this thread has read, for [`noting_settings`].
    static NOTED: RefCell<Vec<(PathBuf, Stamp)>> = const { RefCell::new(Vec::new()) };
}

/// Does something, and says which configurations and tables that read, each as it was then.
pub(super) fn noting_settings<T>(work: impl FnOnce() -> T) -> (T, Vec<(PathBuf, Stamp)>) {
    NOTED.take();
    let result = work();
    (result, NOTED.take())
}

/// A configuration or a tool table. Each is read more than once in a run, so that none comes through a pipe.
pub(super) fn read_settings(path: &Path) -> io::Result<Vec<u8>> {
    settings_from(&open_regular(path)?, path)
}

/// The same for a table that is read once, and may come through a pipe.
pub(super) fn read_settings_once(path: &Path) -> io::Result<Vec<u8>> {
    let file = if is_pipe(&metadata(path)?) { File::open(path)? } else { open_regular(path)? };
    settings_from(&file, path)
}

fn settings_from(file: &File, path: &Path) -> io::Result<Vec<u8>> {
    let before = Stamp::of(&file.metadata()?);
    let bytes = read_stream(file.take(LARGEST_SETTINGS + 1), LARGEST_SETTINGS + 1)?;
    if before.is_of_file() && Stamp::of(&file.metadata()?) != before {
        return Err(io::Error::other(CHANGED));
    }
    if before.is_of_file() {
        NOTED.with_borrow_mut(|noted| noted.push((path.to_path_buf(), before)));
    }
    if bytes.len() as u64 > LARGEST_SETTINGS {
        return Err(io::Error::other(format!("is over {} MiB, which no table is", LARGEST_SETTINGS >> 20)));
    }
    // The byte-order mark of UTF-16, of either order.
    if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) {
        return Err(io::Error::other("is a UTF-16 file; save it as UTF-8"));
    }
    Ok(bytes)
}

/// A file of any kind, read as a whole.
pub(super) fn read_whole(path: &Path) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let before = Stamp::of(&file.metadata()?);
    let mut bytes = Vec::new();
    (&file).read_to_end(&mut bytes)?;
    if before.is_of_file() && Stamp::of(&file.metadata()?) != before {
        return Err(io::Error::other(CHANGED));
    }
    Ok(bytes)
}

/// A path as text: different ones look different, for bytes that are no UTF-8 are written `\xFF`.
pub(super) fn text_of(path: &Path) -> String {
    let mut text = String::new();
    for part in path.as_os_str().as_encoded_bytes().utf8_chunks() {
        text.push_str(part.valid());
        part.invalid().iter().for_each(|byte| text.push_str(&format!("\\x{byte:02X}")));
    }
    text
}

/// The last part of a path.
pub(super) fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// Called programs, from the folders of the programs and the configured roots.
#[derive(Debug)]
pub(super) struct IncludeRoots {
    /// Folder of the main program.
    base: PathBuf,
    /// Prefix of the control's path, and folder.
    roots: BTreeMap<String, PathBuf>,
    /// Folders beside the program's own that are called as those of its control.
    backup: Backup,
    /// Files that were looked for.
    looked: RefCell<BTreeMap<PathBuf, Looked>>,
    /// Files that are read, each as it was when it was opened.
    read: RefCell<BTreeMap<PathBuf, Stamp>>,
    /// What lies in the folders that were looked in.
    listed: Listings,
    /// Names that similar ones were looked for.
    missed: Cell<u32>,
}

/// What came of looking for a file.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Looked {
    /// Its name below the folder that was looked in.
    pub name: String,
    pub found: bool,
}

impl IncludeRoots {
    pub(super) fn new(base: PathBuf, roots: BTreeMap<String, PathBuf>) -> IncludeRoots {
        IncludeRoots {
            base,
            roots,
            backup: Backup::default(),
            looked: RefCell::default(),
            read: RefCell::default(),
            listed: RefCell::default(),
            missed: Cell::new(0),
        }
    }

    /// The same with the folders of a backup in which the program lies; `folders` are those of its control.
    pub(super) fn of_control(
        base: PathBuf,
        roots: BTreeMap<String, PathBuf>,
        folders: &'static [ControlFolder],
    ) -> IncludeRoots {
        let backup = Backup::around(&base, folders, roots.keys());
        IncludeRoots { backup, ..IncludeRoots::new(base, roots) }
    }

    /// Every file that was looked for so far: those that were found as they are called, the others as they would be.
    pub(super) fn looked(&self) -> BTreeMap<PathBuf, Looked> {
        self.looked.borrow().clone()
    }

    /// The file is read from now on.
    pub(super) fn reads(&self, path: &Path, stamp: Stamp) {
        self.read.borrow_mut().entry(path.to_path_buf()).or_insert(stamp);
    }

    /// These were read before.
    pub(super) fn read_before(&self, files: Vec<(PathBuf, Stamp)>) {
        self.read.borrow_mut().extend(files);
    }

    /// Refuses where a file that was read is another one now: what was read may be a part of each.
    ///
    /// # Errors
    /// The first file that changed.
    pub(super) fn unchanged(&self) -> Result<(), Trouble> {
        let read = self.read.borrow();
        match read.iter().find(|(path, stamp)| Stamp::at(path).as_ref() != Some(*stamp)) {
            Some((path, _)) => Err(format!("{}: {CHANGED}; start again once it is complete", shown(path))),
            None => Ok(()),
        }
    }

    fn note(&self, path: PathBuf, name: String, found: bool) {
        self.looked.borrow_mut().insert(path, Looked { name, found });
    }

    /// The root whose prefix fits, and the rest of the name.
    fn rooted<'n>(&self, name: &'n str) -> Option<(&Path, &'n str)> {
        self.roots
            .iter()
            .filter(|(prefix, _)| {
                let prefix = prefix.replace('\\', "/");
                // A name may have no letter that ends where the prefix does.
                name.split_at_checked(prefix.len()).is_some_and(|(head, rest)| {
                    let whole = rest.is_empty() || rest.starts_with('/') || prefix.ends_with(['/', ':']);
                    whole && head.eq_ignore_ascii_case(&prefix)
                })
            })
            .max_by_key(|(prefix, _)| prefix.len())
            .map(|(prefix, folder)| (folder.as_path(), name[prefix.len()..].trim_start_matches('/')))
    }

    /// Folders to look in for a name without a drive.
    fn folders(&self, request: &Request<'_>) -> Vec<PathBuf> {
        let caller = Path::new(request.from).parent().filter(|dir| dir.is_absolute()).map(Path::to_path_buf);
        let base = self.base.clone();
        let folders = match request.within {
            Within::Main => vec![base],
            Within::Caller => vec![caller.unwrap_or(base)],
            Within::Anywhere => {
                caller.into_iter().chain([base]).chain(self.roots.values().cloned()).collect::<Vec<_>>()
            }
            Within::Configured => Vec::new(),
        };
        let mut once: Vec<PathBuf> = Vec::new();
        for folder in folders {
            if !once.contains(&folder) {
                once.push(folder);
            }
        }
        once
    }

    /// The file of a folder that the name means. A name without extension that is a file as it stands has no order among
    /// those with one.
    fn of_folder(&self, folder: &Path, asked: &Asked<'_>) -> Result<Option<Hit>, FileError> {
        let mut hits: Vec<Hit> = Vec::new();
        for name in with_extensions(&asked.parts, asked.extensions) {
            match find(folder, &name, &self.listed)? {
                Some(path) => {
                    let (opened, stamp) = open_inside(&path, folder)?;
                    if !hits.iter().any(|hit| hit.opened.identity == opened.identity) {
                        hits.push(Hit { path, name, opened, stamp });
                    }
                }
                None => self.note(folder.join(name.iter().collect::<PathBuf>()), asked.named(&name), false),
            }
        }
        if hits.len() > 1 && hits[0].name == asked.parts {
            return Err(ambiguous(&hits));
        }
        Ok(hits.into_iter().next())
    }

    /// The file that `asked` means in the folders; where it lies in none, what was tried, and what is similar.
    fn of_folders(&self, folders: &[PathBuf], asked: &Asked<'_>) -> Result<Opened, FileError> {
        let mut hits: Vec<Hit> = Vec::new();
        let mut similar = Vec::new();
        for folder in folders {
            match self.of_folder(folder, asked)? {
                // One folder may be known by two names.
                Some(hit) if hits.iter().any(|known| known.opened.identity == hit.opened.identity) => {}
                Some(hit) => hits.push(hit),
                None if self.missed.get() > MOST_MISSED => {}
                None => {
                    self.missed.set(self.missed.get() + 1);
                    let name = asked.parts.last().map_or("", String::as_str);
                    similar.extend(like(folder, name, asked.extensions, &self.listed));
                }
            }
        }
        if hits.len() > 1 {
            return Err(ambiguous(&hits));
        }
        let Some(Hit { path, name, opened, stamp }) = hits.pop() else {
            let tried = with_extensions(&asked.parts, asked.extensions);
            return Err(FileError::NotFound { tried: tried.iter().map(|name| name.join("/")).collect(), similar });
        };
        self.reads(&path, stamp);
        self.note(path, asked.named(&name), true);
        Ok(opened)
    }

    /// The file that a name of the control means in the backup in which the program lies; `None` where it has no such folder.
    fn of_backup(&self, sought: Sought<'_>, name: &str, extensions: &[&str]) -> Option<Result<Opened, FileError>> {
        let forbidden = |why: String| Some(Err(FileError::Forbidden { why }));
        let (folders, rest) = match sought {
            Sought::In(folder, rest) => (vec![folder], rest),
            Sought::InSeveral(folders, rest) => (folders, rest),
            Sought::Unfit(path, why) => return forbidden(format!("`{}` {why}", shown(&path))),
            Sought::Absent(files) => {
                files.into_iter().for_each(|file| self.note(file, name.to_owned(), false));
                return None;
            }
        };
        let parts = match parts_of(rest) {
            Ok(parts) => parts,
            Err(why) => return forbidden(why.to_owned()),
        };
        let asked = Asked { parts, extensions, root: &name[..name.len() - rest.len()] };
        let found = self.of_folders(&folders, &asked);
        if folders.len() > 1 && !matches!(found, Err(FileError::NotFound { .. })) {
            let names: Vec<String> = folders.iter().map(|folder| format!("`{}`", shown(folder))).collect();
            return forbidden(format!("{} stand for one folder of the control", names.join(" and ")));
        }
        Some(found)
    }

    /// The file that the configuration names.
    fn configured(&self, name: &str) -> Result<Opened, FileError> {
        let path = Path::new(name);
        let tried = vec![name.to_owned()];
        // Where it lies is not what it is.
        self.note(path.to_path_buf(), file_name(path), path.is_file());
        if ordinary(path)?.is_none() {
            return Err(FileError::NotFound { tried, similar: Vec::new() });
        }
        let folder = path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let (opened, stamp) = open_inside(path, folder)?;
        self.reads(path, stamp);
        Ok(opened)
    }
}

/// A file that is asked for, of some folders.
struct Asked<'r> {
    /// Its name below each of them.
    parts: Vec<String>,
    extensions: &'r [&'r str],
    /// The folder of the control, as the name begins; empty for a name without one.
    root: &'r str,
}

impl Asked<'_> {
    /// As it is called, whatever the folder of this computer is.
    fn named(&self, name: &[String]) -> String {
        self.root.to_ascii_uppercase() + &name.join("/")
    }
}

/// A file that was found.
struct Hit {
    path: PathBuf,
    /// Its name below the folder.
    name: Vec<String>,
    opened: Opened,
    stamp: Stamp,
}

fn ambiguous(hits: &[Hit]) -> FileError {
    FileError::Ambiguous { names: hits.iter().map(|hit| hit.opened.name.clone()).collect() }
}

impl Files for IncludeRoots {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        if request.within == Within::Configured {
            return self.configured(request.name);
        }
        let name = request.name.replace('\\', "/");
        let forbidden = |why: &str| Err(FileError::Forbidden { why: why.to_owned() });
        if name.len() > LONGEST_NAME {
            return forbidden("the name is too long");
        }
        if name.starts_with("//") {
            return forbidden("it names a network share");
        }
        let (folders, rest) = match self.rooted(&name) {
            Some((folder, rest)) => {
                if let Some(why) = no_folder(folder) {
                    return forbidden(&format!("`{}` {why}", shown(folder)));
                }
                (vec![folder.to_path_buf()], rest.to_owned())
            }
            None => {
                if let Some(at) = name.find(':') {
                    return Err(FileError::NoRoot { prefix: request.name[..=at].to_owned() });
                }
                let beside = || self.backup.seek_beside(&name).filter(|_| request.within == Within::Main);
                let sought = if name.starts_with('/') { self.backup.seek(&name) } else { beside() };
                if let Some(found) = sought.and_then(|sought| self.of_backup(sought, &name, request.extensions)) {
                    return found;
                }
                if let Some(rest) = name.strip_prefix('/') {
                    let first = rest.split('/').next().unwrap_or(rest);
                    return Err(FileError::NoRoot { prefix: format!("/{first}") });
                }
                (self.folders(request), name.clone())
            }
        };
        let parts = match parts_of(&rest) {
            Ok(parts) => parts,
            Err(why) => return forbidden(why),
        };
        let root = &name[..name.len() - rest.len()];
        self.of_folders(&folders, &Asked { parts, extensions: request.extensions, root })
    }

    fn copy_of(&self, folder: &str) -> Option<(String, &'static str)> {
        self.backup.copy_of(folder).map(|(copy, control)| (shown(copy), control))
    }

    fn home(&self) -> Option<&str> {
        self.backup.home()
    }
}

/// The parts of a relative name, if a control would accept them and they lead nowhere else.
fn parts_of(name: &str) -> Result<Vec<String>, &'static str> {
    let mut parts = Vec::new();
    for part in name.split('/') {
        let stem = part.split('.').next().unwrap_or_default().trim_end();
        if part.is_empty() || part == "." {
            continue;
        }
        if part == ".." {
            return Err("`..` leads out of the include roots");
        }
        if part.chars().any(|c| c.is_control() || matches!(c, ':' | '*' | '?' | '<' | '>' | '|' | '"')) {
            return Err("the name holds a character that no file of a control has");
        }
        let port = stem.len() == 4 && stem[..3].eq_ignore_ascii_case("COM")
            || stem.len() == 4 && stem[..3].eq_ignore_ascii_case("LPT");
        if DEVICES.iter().any(|device| stem.eq_ignore_ascii_case(device)) || port {
            return Err("it is the name of a device");
        }
        parts.push(part.to_owned());
    }
    if parts.is_empty() { Err("the name is empty") } else { Ok(parts) }
}

fn with_extensions(parts: &[String], extensions: &[&str]) -> Vec<Vec<String>> {
    let mut candidates = vec![parts.to_vec()];
    let Some(last) = parts.last() else { return candidates };
    if !last.contains('.') {
        for extension in extensions {
            let mut parts = parts.to_vec();
            if let Some(name) = parts.last_mut() {
                *name = format!("{last}.{extension}");
            }
            candidates.push(parts);
        }
    }
    candidates
}

/// Opens a file after a last look at where it really lies.
fn open_inside(path: &Path, root: &Path) -> Result<(Opened, Stamp), FileError> {
    let io = |error: io::Error| FileError::Io { why: error.to_string() };
    let real = fs::canonicalize(path).map_err(io)?;
    let root = fs::canonicalize(root).map_err(io)?;
    if !real.starts_with(&root) {
        return Err(FileError::Forbidden { why: "it is a link that leads out of the include roots".to_owned() });
    }
    let text = Box::new(OnDisk::open(&real).map_err(io)?);
    let stamp = text.stamp.clone();
    Ok((Opened { name: shown(path), identity: text_of(&real), text }, stamp))
}

/// The path as an editor or CI job opens it from here: relative where it lies below the current folder.
pub(super) fn shown(path: &Path) -> String {
    let here = std::env::current_dir().ok();
    let below = here.as_deref().and_then(|here| path.strip_prefix(here).ok()).unwrap_or(path);
    let plain: PathBuf = below.components().filter(|part| *part != Component::CurDir).collect();
    text_of(&plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hostile_names_are_refused() {
        for name in [
            "..", "a/../b", "C:x", "a:stream", "NUL", "con.H", "com1", "lpt9.h", "", ".", "a\u{0}b", "x*", "a\nb",
            "\"q\"",
        ] {
            assert!(parts_of(name).is_err(), "{name:?}");
        }
        assert_eq!(parts_of("sub/./A.H").unwrap(), ["sub", "A.H"]);
    }

    #[cfg(unix)]
    #[test]
    fn names_that_are_no_text_differ() {
        use std::os::unix::ffi::OsStrExt as _;
        let name = |bytes: &[u8]| text_of(Path::new(std::ffi::OsStr::from_bytes(bytes)));
        assert_eq!(name("Teil_ä.H".as_bytes()), "Teil_ä.H");
        assert_eq!(name(b"a/N\xff\xe4.H"), "a/N\\xFF\\xE4.H");
    }

    #[test]
    fn streams_have_a_bound() {
        assert_eq!(read_stream(&b"abc"[..], 3).unwrap(), b"abc");
        assert!(read_stream(io::repeat(0), 1 << 20).unwrap_err().to_string().contains("more than 1 MiB"));
    }

    #[test]
    fn drives_need_a_root() {
        let roots = IncludeRoots::new(PathBuf::from("."), BTreeMap::from([("TNC:".to_owned(), PathBuf::from("/p"))]));
        assert_eq!(roots.rooted("tnc:/DIR/A.H"), Some((Path::new("/p"), "DIR/A.H")));
        assert_eq!(roots.rooted("PLC:/A.H"), None);
        assert_eq!(roots.rooted("..\u{2215}A.H"), None);
        let request = Request { from: "", name: "PLC:\\A.H", extensions: &[], within: Within::Anywhere };
        assert!(matches!(roots.open(&request), Err(FileError::NoRoot { prefix }) if prefix == "PLC:"));
        let request = Request { from: "", name: "\\\\host\\a.H", extensions: &[], within: Within::Anywhere };
        assert!(matches!(roots.open(&request), Err(FileError::Forbidden { .. })));
    }
}
