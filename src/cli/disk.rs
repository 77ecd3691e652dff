//! Files of this computer: reading programs, and opening called ones inside the include roots only.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Component, Path, PathBuf};

use crate::machine::tree::did_you_mean;
use crate::text::{FileError, Files, Memory, Opened, ReadAt, Request, Within};

use super::Trouble;
use super::stamp::{CHANGED, Stamp};

use super::regular::{is_pipe, metadata, open_regular};

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
    /// Files that were looked for.
    looked: RefCell<BTreeMap<PathBuf, Looked>>,
    /// Files that are read, each as it was when it was opened.
    read: RefCell<BTreeMap<PathBuf, Stamp>>,
    /// What lies in the folders that were looked in.
    listed: Listings,
    /// Names that similar ones were looked for.
    missed: Cell<u32>,
}

/// The names in each folder, by how they are written in capitals; none for a folder that cannot be listed.
type Listings = RefCell<BTreeMap<PathBuf, Option<BTreeMap<String, Vec<String>>>>>;

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
            looked: RefCell::default(),
            read: RefCell::default(),
            listed: RefCell::default(),
            missed: Cell::new(0),
        }
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

    fn note(&self, path: PathBuf, name: &[String], found: bool) {
        self.looked.borrow_mut().insert(path, Looked { name: name.join("/"), found });
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
    fn of_folder(&self, folder: &Path, parts: &[String], extensions: &[&str]) -> Result<Option<Hit>, FileError> {
        let mut hits: Vec<Hit> = Vec::new();
        for name in with_extensions(parts, extensions) {
            match find(folder, &name, &self.listed)? {
                Some(path) => {
                    let (opened, stamp) = open_inside(&path, folder)?;
                    if !hits.iter().any(|hit| hit.opened.identity == opened.identity) {
                        hits.push(Hit { path, name, opened, stamp });
                    }
                }
                None => self.note(folder.join(name.iter().collect::<PathBuf>()), &name, false),
            }
        }
        if hits.len() > 1 && hits[0].name == parts {
            return Err(ambiguous(&hits));
        }
        Ok(hits.into_iter().next())
    }

    /// The file that the configuration names.
    fn configured(&self, name: &str) -> Result<Opened, FileError> {
        let path = Path::new(name);
        let tried = vec![name.to_owned()];
        // Where it lies is not what it is.
        self.note(path.to_path_buf(), &[file_name(path)], path.is_file());
        if ordinary(path)?.is_none() {
            return Err(FileError::NotFound { tried, similar: Vec::new() });
        }
        let folder = path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let (opened, stamp) = open_inside(path, folder)?;
        self.reads(path, stamp);
        Ok(opened)
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
            Some((folder, rest)) => (vec![folder.to_path_buf()], rest.to_owned()),
            None => {
                if let Some(at) = name.find(':') {
                    return Err(FileError::NoRoot { prefix: request.name[..=at].to_owned() });
                }
                if let Some(rest) = name.strip_prefix('/') {
                    let first = rest.split('/').next().unwrap_or(rest);
                    return Err(FileError::NoRoot { prefix: format!("/{first}") });
                }
                (self.folders(request), name)
            }
        };
        let parts = match parts_of(&rest) {
            Ok(parts) => parts,
            Err(why) => return forbidden(why),
        };
        let mut hits: Vec<Hit> = Vec::new();
        let mut similar = Vec::new();
        for folder in &folders {
            match self.of_folder(folder, &parts, request.extensions)? {
                // One folder may be known by two names.
                Some(hit) if hits.iter().any(|known| known.opened.identity == hit.opened.identity) => {}
                Some(hit) => hits.push(hit),
                None if self.missed.get() > MOST_MISSED => {}
                None => {
                    self.missed.set(self.missed.get() + 1);
                    let name = parts.last().map_or("", String::as_str);
                    similar.extend(like(folder, name, request.extensions, &self.listed));
                }
            }
        }
        if hits.len() > 1 {
            return Err(ambiguous(&hits));
        }
        let Some(Hit { path, name, opened, stamp }) = hits.pop() else {
            let tried = with_extensions(&parts, request.extensions);
            return Err(FileError::NotFound { tried: tried.iter().map(|name| name.join("/")).collect(), similar });
        };
        self.reads(&path, stamp);
        self.note(path, &name, true);
        Ok(opened)
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

/// Finds the file below `folder`; upper and lower case do not matter where one name fits. Names that differ in nothing else are one
/// name on a control, so that none of them is the right one.
fn find(folder: &Path, parts: &[String], listed: &Listings) -> Result<Option<PathBuf>, FileError> {
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

/// Is there an ordinary file? A folder of this name is none.
///
/// # Errors
/// A pipe, a device, a link that leads nowhere: somebody put it there, and it cannot be called.
fn ordinary(path: &Path) -> Result<Option<()>, FileError> {
    match metadata(path) {
        Ok(meta) if meta.is_file() => Ok(Some(())),
        Ok(meta) if meta.is_dir() => Ok(None),
        Err(_) if path.symlink_metadata().is_err() => Ok(None),
        Ok(_) | Err(_) => match open_regular(path) {
            Ok(_) => Ok(Some(())),
            Err(error) => Err(FileError::Io { why: error.to_string() }),
        },
    }
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

/// Fewest letters of a name that another one may be near to.
const SHORTEST_LIKE: usize = 3;

/// A program in the folder with a name near to this one. Of very short names any other would be near.
fn like(folder: &Path, name: &str, extensions: &[&str], listed: &Listings) -> Option<String> {
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
