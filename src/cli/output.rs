//! Writing results: when all is well, or not at all.

use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
#[cfg(target_os = "linux")]
use std::thread;
#[cfg(target_os = "linux")]
use std::time::{Duration, Instant};

use crate::emit::Output;

use super::made::{Made, Replaces, head_of, is_foreign, is_ours};
use super::pending::{self, Pending, behind_links};
#[cfg(target_os = "linux")]
use super::regular::is_pipe;

/// Bytes of standard output kept in memory before a temporary file takes over.
const IN_MEMORY: usize = 8 << 20;
/// Names tried for an older output that is set aside.
const STALE_NAMES: u32 = 1000;

/// Where a program goes.
#[derive(Debug)]
pub(super) enum Destination {
    File(Pending),
    /// Standard output, or a device or pipe: held back until the program is complete.
    Stream {
        path: Option<PathBuf>,
        held: Held,
    },
    /// The null device.
    Nowhere,
}

/// Bytes held back, in memory or, when there are many, in a temporary file.
#[derive(Debug, Default)]
pub(super) struct Held {
    memory: Vec<u8>,
    file: Option<File>,
}

impl Held {
    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        if self.file.is_none() && self.memory.len() + bytes.len() > IN_MEMORY {
            let mut file = pending::scratch()?;
            file.write_all(&self.memory)?;
            self.memory = Vec::new();
            self.file = Some(file);
        }
        match &mut self.file {
            Some(file) => file.write_all(bytes),
            None => {
                self.memory.extend_from_slice(bytes);
                Ok(())
            }
        }
    }

    fn patch(&mut self, at: u64, bytes: &[u8]) -> io::Result<()> {
        match &mut self.file {
            Some(file) => {
                file.seek(SeekFrom::Start(at))?;
                file.write_all(bytes)?;
                file.seek(SeekFrom::End(0)).map(drop)
            }
            None => self.memory.patch(at, bytes),
        }
    }

    fn release(self, out: &mut dyn Write) -> io::Result<()> {
        match self.file {
            Some(mut file) => {
                file.seek(SeekFrom::Start(0))?;
                let mut buffer = vec![0; 1 << 20];
                loop {
                    let n = file.read(&mut buffer)?;
                    if n == 0 {
                        break;
                    }
                    out.write_all(&buffer[..n])?;
                }
            }
            None => out.write_all(&self.memory)?,
        }
        out.flush()
    }
}

impl Destination {
    /// The destination for `path`, whatever stands there; `-` is standard output.
    pub(super) fn open(path: &Path) -> io::Result<Destination> {
        Destination::open_for(path, Replaces::Anything)
    }

    /// The same for a file that may be there already.
    pub(super) fn open_for(path: &Path, replaces: Replaces) -> io::Result<Destination> {
        if path == Path::new("-") {
            if stdout_is_closed() {
                return Err(io::Error::other("standard output is closed; to throw the result away, name /dev/null"));
            }
            return Ok(Destination::Stream { path: None, held: Held::default() });
        }
        match fs::metadata(path) {
            Ok(meta) if meta.is_dir() => Err(io::Error::other("is a folder")),
            Ok(meta) if !meta.is_file() => {
                if path == Path::new("/dev/null") {
                    return Ok(Destination::Nowhere);
                }
                Ok(Destination::Stream { path: Some(path.to_path_buf()), held: Held::default() })
            }
            _ => Pending::create(path, replaces).map(Destination::File),
        }
    }

    /// Takes the name away from an older file of this name, once all that will replace it is on the disk.
    pub(super) fn clear_name(&self) -> io::Result<()> {
        match self {
            Destination::File(pending) => pending.clear_name(),
            Destination::Stream { .. } | Destination::Nowhere => Ok(()),
        }
    }

    /// All is well: the result becomes visible.
    pub(super) fn commit(self) -> io::Result<()> {
        match self {
            Destination::File(pending) => pending.commit(),
            Destination::Stream { path: Some(path), held } => held.release(&mut open_stream(&path)?),
            Destination::Stream { path: None, held } => held.release(&mut io::stdout().lock()),
            Destination::Nowhere => Ok(()),
        }
    }
}

/// How long somebody has to begin to read a pipe.
#[cfg(target_os = "linux")]
const PATIENCE: Duration = Duration::from_secs(5);

/// Opens a device or a pipe for writing. A pipe waits for its reader: only so long.
#[cfg(target_os = "linux")]
fn open_stream(path: &Path) -> io::Result<File> {
    use rustix::fs::{Mode, OFlags, fcntl_getfl, fcntl_setfl, open};
    let start = Instant::now();
    let waits = || fs::metadata(path).is_ok_and(|meta| is_pipe(&meta));
    let flags = OFlags::WRONLY | OFlags::NONBLOCK | OFlags::CLOEXEC | OFlags::NOCTTY;
    let file: File = loop {
        match open(path, flags, Mode::empty()) {
            Ok(file) => break file.into(),
            Err(error) if error != rustix::io::Errno::NXIO || !waits() => return Err(error.into()),
            Err(_) if start.elapsed() < PATIENCE => thread::sleep(Duration::from_millis(20)),
            Err(_) => {
                let seconds = PATIENCE.as_secs();
                return Err(io::Error::other(format!(
                    "is a pipe without a reader: none came within {seconds} seconds"
                )));
            }
        }
    };
    // From here on a slow reader is waited for.
    fcntl_setfl(&file, fcntl_getfl(&file)? - OFlags::NONBLOCK)?;
    Ok(file)
}

#[cfg(not(target_os = "linux"))]
fn open_stream(path: &Path) -> io::Result<File> {
    File::options().write(true).open(path)
}

/// Outputs that are complete. They go to the disk together, and get their names then.
#[derive(Debug, Default)]
pub(super) struct Group {
    waiting: Vec<(Pending, String)>,
    /// Outputs that have their names.
    pub written: u32,
    /// What went wrong.
    pub troubles: Vec<String>,
}

impl Group {
    /// Fewer than the files that any system lets a process have open.
    const MOST: usize = 64;

    /// Takes a complete output, named so in what is said of it.
    pub(super) fn take(&mut self, out: Destination, name: String) {
        match out {
            Destination::File(file) => self.waiting.push((file, name)),
            other => self.note(&name, other.commit().or_else(ignore_closed_pipe)),
        }
        if self.waiting.len() >= Group::MOST {
            self.commit();
        }
    }

    /// Names all that wait.
    pub(super) fn commit(&mut self) {
        let together = match &self.waiting[..] {
            [(first, _), _, ..] if first.sync_with_others() => first.device(),
            _ => None,
        };
        for (file, name) in std::mem::take(&mut self.waiting) {
            // An output on another file system is not on its disk yet.
            let is_there = together.is_some() && file.device() == together;
            self.note(&name, if is_there { file.name() } else { file.commit() });
        }
    }

    fn note(&mut self, name: &str, done: io::Result<()>) {
        match done {
            Ok(()) => self.written += 1,
            Err(error) => self.troubles.push(format!("{name}: {error}")),
        }
    }
}

impl Output for Destination {
    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        match self {
            Destination::File(pending) => pending.write_all(bytes),
            Destination::Stream { held, .. } => held.append(bytes),
            Destination::Nowhere => Ok(()),
        }
    }

    fn patch(&mut self, at: u64, bytes: &[u8]) -> io::Result<()> {
        match self {
            Destination::File(pending) => {
                let file = pending.file();
                file.seek(SeekFrom::Start(at))?;
                file.write_all(bytes)?;
                file.seek(SeekFrom::End(0)).map(drop)
            }
            Destination::Stream { held, .. } => held.patch(at, bytes),
            Destination::Nowhere => Ok(()),
        }
    }
}

impl Write for Destination {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.append(bytes).map(|()| bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Was standard output closed at the start? The runtime opens the null device for reading and writing in its place, which no shell
/// does.
#[cfg(target_os = "linux")]
fn stdout_is_closed() -> bool {
    use rustix::fs::{FileType, OFlags, fcntl_getfl, fstat, stat};
    let out = io::stdout();
    let is_null = fstat(&out).ok().zip(stat("/dev/null").ok()).is_some_and(|(out, null)| {
        FileType::from_raw_mode(out.st_mode) == FileType::CharacterDevice && out.st_rdev == null.st_rdev
    });
    is_null && fcntl_getfl(&out).is_ok_and(|flags| flags.contains(OFlags::RDWR))
}

#[cfg(not(target_os = "linux"))]
fn stdout_is_closed() -> bool {
    false
}

/// An older output must not look like the result of a program that now has errors.
pub(super) fn set_aside(path: &Path, made: Made) -> io::Result<Option<PathBuf>> {
    let path = &behind_links(path)?;
    let regular = fs::symlink_metadata(path).is_ok_and(|meta| meta.is_file() && meta.len() > 0);
    if !regular || is_foreign(path, made) {
        return Ok(None);
    }
    for attempt in 0..STALE_NAMES {
        let mut name = path.as_os_str().to_owned();
        name.push(".stale");
        if attempt > 0 {
            name.push(format!(".{attempt}"));
        }
        let stale = PathBuf::from(name);
        let ours = head_of(&stale).is_some_and(|head| is_ours(&stale, &head, made));
        if stale.symlink_metadata().is_err() || ours {
            fs::rename(path, &stale)?;
            return Ok(Some(stale));
        }
    }
    Err(io::Error::other("no name is left to set the older output aside"))
}

/// A reader that has seen enough is no trouble.
pub(super) fn ignore_closed_pipe(error: io::Error) -> io::Result<()> {
    if error.kind() == io::ErrorKind::BrokenPipe { Ok(()) } else { Err(error) }
}
