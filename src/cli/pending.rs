//! A file that appears under its name only when it is complete.
//!
//! Where the system has files without a name, an output is one until then, and nothing of it stays when the process is
//! killed. Elsewhere it has a hidden name; a lock tells others that somebody still writes it.

use std::collections::BTreeSet;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::disk::file_name;
use super::made::{Replaces, is_foreign};

/// Hidden names tried for one file.
const NAMES: u32 = 100;
/// Characters of the target's name in a hidden name, which must not get longer than file systems allow.
const SHOWN: usize = 60;
/// What all hidden names have behind the target's.
const MARK: &str = ".partc-";
const END: &str = ".tmp";
/// Links followed to a target.
const MOST_LINKS: u32 = 40;

#[derive(Debug)]
pub(super) struct Pending {
    file: File,
    /// Name that it has until it is complete, if any.
    hidden: Option<PathBuf>,
    target: PathBuf,
    /// The file that had the name at the start.
    older: Option<Id>,
    replaces: Replaces,
}

impl Pending {
    /// Starts a file that will be `target`, or what `target` links to.
    pub(super) fn create(target: &Path, replaces: Replaces) -> io::Result<Pending> {
        let target = behind_links(target)?;
        let older = unprotected(&target)?.as_ref().map(id);
        let folder = folder_of(&target);
        if is_first(folder) {
            remove_rests(folder);
        }
        if let Some(file) = unnamed(folder) {
            return Ok(Pending { file, hidden: None, target, older, replaces });
        }
        let (file, hidden) = named(folder, &file_name(&target))?;
        Ok(Pending { file, hidden: Some(hidden), target, older, replaces })
    }

    /// The same in the place of a file that is changed: one that is protected stays, and so do its owner and its names.
    pub(super) fn replace(target: &Path) -> io::Result<Pending> {
        let older = fs::metadata(target)?;
        let pending = Pending::create(target, Replaces::Anything)?;
        keep_owner(&pending.file, &older)?;
        Ok(pending)
    }

    pub(super) fn file(&mut self) -> &mut File {
        &mut self.file
    }

    /// Gives the file its name, and the rights of the file that it replaces.
    pub(super) fn commit(self) -> io::Result<()> {
        self.file.sync_all()?;
        self.name()
    }

    /// Has the system write down all that its file system holds, where it can.
    pub(super) fn sync_with_others(&self) -> bool {
        #[cfg(target_os = "linux")]
        return rustix::fs::syncfs(&self.file).is_ok();
        #[cfg(not(target_os = "linux"))]
        false
    }

    /// The file system that it lies on.
    #[cfg(unix)]
    pub(super) fn device(&self) -> Option<u64> {
        use std::os::unix::fs::MetadataExt as _;
        self.file.metadata().ok().map(|meta| meta.dev())
    }

    #[cfg(not(unix))]
    pub(super) fn device(&self) -> Option<u64> {
        None
    }

    /// The same for a file that is on the disk already.
    pub(super) fn name(mut self) -> io::Result<()> {
        let older = self.may_be_named()?;
        if let Some(older) = &older {
            self.file.set_permissions(older.permissions())?;
        }
        if self.hidden.is_none() {
            if older.is_none() {
                if link(&self.file, &self.target)? {
                    return Ok(());
                }
                // Somebody took the name just now.
                self.may_be_named()?;
            }
            // A link cannot replace a file; a name can.
            let _ = self.file.try_lock();
            let names = hidden_names(folder_of(&self.target), &file_name(&self.target));
            for hidden in names {
                if link(&self.file, &hidden)? {
                    self.hidden = Some(hidden);
                    break;
                }
            }
        }
        let hidden = self.hidden.as_ref().ok_or_else(no_name_left)?;
        fs::rename(hidden, &self.target)
    }

    /// The file that has the name now, if it may lose it.
    fn may_be_named(&self) -> io::Result<Option<fs::Metadata>> {
        let Some(now) = unprotected(&self.target)? else { return Ok(None) };
        let same = self.older == Some(id(&now));
        let may = match self.replaces {
            Replaces::Anything => true,
            Replaces::Ours(made) => !is_foreign(&self.target, made),
            Replaces::Forced(made) => same || !is_foreign(&self.target, made),
        };
        if may {
            return Ok(Some(now));
        }
        Err(io::Error::other("another program wrote this file while partc ran; it is kept, and nothing was written"))
    }

    /// Takes the name away from the older file, once this one is on the disk.
    pub(super) fn clear_name(&self) -> io::Result<()> {
        self.file.sync_all()?;
        match self.may_be_named()? {
            // Its rights go on.
            Some(older) => {
                self.file.set_permissions(older.permissions())?;
                fs::remove_file(&self.target)
            }
            None => Ok(()),
        }
    }
}

/// Which file it is, whatever its name.
type Id = (u64, u64);

#[cfg(unix)]
fn id(meta: &fs::Metadata) -> Id {
    use std::os::unix::fs::MetadataExt as _;
    (meta.dev(), meta.ino())
}

#[cfg(not(unix))]
fn id(meta: &fs::Metadata) -> Id {
    let made = meta.created().ok().and_then(|made| made.duration_since(std::time::UNIX_EPOCH).ok());
    (0, made.map_or(0, |made| made.as_nanos() as u64))
}

/// The file of this name, if there is one.
///
/// # Errors
/// One that is write-protected: it stays as it is.
fn unprotected(target: &Path) -> io::Result<Option<fs::Metadata>> {
    match fs::metadata(target) {
        Ok(meta) if meta.permissions().readonly() => {
            Err(io::Error::new(io::ErrorKind::PermissionDenied, "is write-protected; nothing was written"))
        }
        Ok(meta) => Ok(Some(meta)),
        Err(_) => Ok(None),
    }
}

impl Drop for Pending {
    fn drop(&mut self) {
        // After a rename there is nothing to remove.
        if let Some(hidden) = &self.hidden {
            let _ = fs::remove_file(hidden);
        }
    }
}

impl Write for Pending {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A file for this process alone.
pub(super) fn scratch() -> io::Result<File> {
    let folder = std::env::temp_dir();
    if let Some(file) = unnamed(&folder) {
        return Ok(file);
    }
    let (file, hidden) = named(&folder, "held")?;
    // Open but without a name: it goes when the process goes.
    let _ = fs::remove_file(hidden);
    Ok(file)
}

/// What a link leads to, whether it exists or not.
pub(super) fn behind_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        if !path.is_symlink() {
            return Ok(path);
        }
        // A link counts from its own folder.
        path = folder_of(&path).join(fs::read_link(&path)?);
    }
    Err(io::Error::other("links lead in circles"))
}

/// Gives the new file the owner of the old one.
#[cfg(unix)]
fn keep_owner(file: &File, older: &fs::Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt as _, fchown};
    let own = file.metadata()?;
    if older.nlink() > 1 {
        return Err(io::Error::other("has several names (hard links), and only one would change; nothing was written"));
    }
    if (own.uid(), own.gid()) == (older.uid(), older.gid()) {
        return Ok(());
    }
    let kept = fchown(file, Some(older.uid()), Some(older.gid()));
    kept.map_err(|error| io::Error::new(error.kind(), "belongs to another user or group; nothing was written"))
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &fs::Metadata) -> io::Result<()> {
    Ok(())
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn no_name_left() -> io::Error {
    io::Error::other("no name is left for a temporary file")
}

fn hidden_names(folder: &Path, name: &str) -> impl Iterator<Item = PathBuf> + use<> {
    let start: String = name.chars().take(SHOWN).collect();
    let folder = folder.to_path_buf();
    let process = std::process::id();
    (0..NAMES).map(move |n| folder.join(format!(".{start}{MARK}{process}-{n}{END}")))
}

/// A file with a hidden name, locked as long as it is open.
fn named(folder: &Path, name: &str) -> io::Result<(File, PathBuf)> {
    for hidden in hidden_names(folder, name) {
        match File::options().read(true).write(true).create_new(true).open(&hidden) {
            Ok(file) => match file.try_lock() {
                // Somebody took it for a rest just now.
                Err(TryLockError::WouldBlock) => {}
                _ if hidden.exists() => return Ok((file, hidden)),
                _ => {}
            },
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(no_name_left())
}

/// Is this one of our hidden names?
fn is_hidden(name: &str) -> bool {
    let inner = name.strip_prefix('.').and_then(|name| name.strip_suffix(END));
    let ids = inner.and_then(|inner| inner.rsplit_once(MARK)).and_then(|(_, ids)| ids.split_once('-'));
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    ids.is_some_and(|(process, n)| digits(process) && digits(n))
}

/// Is this the first file that this process makes in the folder? Looking through it for each would take the square of the time.
fn is_first(folder: &Path) -> bool {
    static SEEN: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    let mut seen = SEEN.lock().unwrap_or_else(PoisonError::into_inner);
    !seen.contains(folder) && seen.insert(folder.to_path_buf())
}

/// Removes what processes left that were killed; nobody holds the lock of such a file.
fn remove_rests(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let ours = entry.file_name().to_str().is_some_and(is_hidden);
        if !ours || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let path = entry.path();
        if let Ok(file) = File::open(&path)
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(&path);
        }
    }
}

/// A file without a name in this folder, where the system has such.
#[cfg(target_os = "linux")]
fn unnamed(folder: &Path) -> Option<File> {
    use rustix::fs::{Mode, OFlags, open};
    // It gets its name through here.
    if !Path::new("/proc/self/fd").is_dir() {
        return None;
    }
    let flags = OFlags::TMPFILE | OFlags::RDWR | OFlags::CLOEXEC;
    open(folder, flags, Mode::from_raw_mode(0o666)).ok().map(File::from)
}

/// Gives a file without a name this one; false where it is taken.
#[cfg(target_os = "linux")]
fn link(file: &File, path: &Path) -> io::Result<bool> {
    use rustix::fs::{AtFlags, CWD, linkat};
    use std::os::fd::AsRawFd as _;
    let own = format!("/proc/self/fd/{}", file.as_raw_fd());
    match linkat(CWD, own.as_str(), CWD, path, AtFlags::SYMLINK_FOLLOW) {
        Ok(()) => Ok(true),
        Err(rustix::io::Errno::EXIST) => Ok(false),
        Err(error) => Err(error.into()),
    }
}

#[cfg(not(target_os = "linux"))]
fn unnamed(_: &Path) -> Option<File> {
    None
}

#[cfg(not(target_os = "linux"))]
fn link(_: &File, _: &Path) -> io::Result<bool> {
    Err(io::Error::from(io::ErrorKind::Unsupported))
}

#[cfg(test)]
mod tests {
    use super::super::made::Made;
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("partc-pending-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn rests_of_dead_processes_are_removed_and_no_others() {
        let folder = folder("rests");
        for name in [".a.ngc.partc-1-0.tmp", ".a.partc-1.tmp", "a.partc-1-0.tmp", ".a.ngc.partc-x-0.tmp"] {
            fs::write(folder.join(name), "").unwrap();
        }
        // What is being written has a lock.
        let (file, hidden) = named(&folder, "b.ngc").unwrap();
        remove_rests(&folder);
        assert!(!folder.join(".a.ngc.partc-1-0.tmp").exists() && hidden.exists());
        drop(file);
        remove_rests(&folder);
        assert!(!hidden.exists());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 3);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn what_another_program_wrote_meanwhile_is_kept() {
        let folder = folder("meanwhile");
        let target = folder.join("A.ngc");
        let ours = "%\n(partc 0.1.0, target linuxcnc)\n";
        let begin = |replaces| {
            let mut file = Pending::create(&target, replaces).unwrap();
            file.write_all(ours.as_bytes()).unwrap();
            file
        };
        let text = || fs::read_to_string(&target).unwrap();
        let (by_name, forced) = (Replaces::Ours(Made::Program), Replaces::Forced(Made::Program));
        for replaces in [by_name, forced] {
            // It appears during the run.
            let file = begin(replaces);
            fs::write(&target, "foreign").unwrap();
            assert!(file.commit().unwrap_err().to_string().contains("another program"));
            assert_eq!(text(), "foreign");
            // It takes the place of an older output.
            fs::write(&target, ours).unwrap();
            let file = begin(replaces);
            fs::write(folder.join("other"), "foreign").unwrap();
            fs::rename(folder.join("other"), &target).unwrap();
            assert!(file.commit().is_err());
            assert_eq!(text(), "foreign");
            // What partc wrote meanwhile is no loss.
            fs::remove_file(&target).unwrap();
            let file = begin(replaces);
            fs::write(&target, ours).unwrap();
            file.commit().unwrap();
            fs::remove_file(&target).unwrap();
        }
        // The file that `--force` is about.
        fs::write(&target, "foreign").unwrap();
        begin(forced).commit().unwrap();
        assert_eq!(text(), ours);
        // Protected during the run.
        let file = begin(by_name);
        let mut rights = fs::metadata(&target).unwrap().permissions();
        rights.set_readonly(true);
        fs::set_permissions(&target, rights).unwrap();
        assert!(file.commit().unwrap_err().to_string().contains("write-protected"));
        // Nothing else is left.
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_file_with_a_hidden_name_is_renamed_or_removed() {
        let folder = folder("named");
        let target = folder.join("n".repeat(250));
        let pending = || {
            let (file, hidden) = named(&folder, &file_name(&target)).unwrap();
            Pending { file, hidden: Some(hidden), target: target.clone(), older: None, replaces: Replaces::Anything }
        };
        drop(pending());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
        let mut file = pending();
        file.write_all(b"new").unwrap();
        file.commit().unwrap();
        assert_eq!((fs::read_dir(&folder).unwrap().count(), fs::read(&target).unwrap()), (1, b"new".to_vec()));
        fs::remove_dir_all(&folder).unwrap();
    }
}
