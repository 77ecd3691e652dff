//! Opening files that are ordinary ones: a pipe would make the run wait for somebody who may never write.

use std::fs::{self, File, Metadata};
use std::io;
use std::path::Path;

use crate::text::FileError;

/// Opens an ordinary file for reading.
///
/// # Errors
/// What the system reports; a folder, a pipe, a device, a link that leads nowhere.
pub(super) fn open_regular(path: &Path) -> io::Result<File> {
    is_regular(&metadata(path)?)?;
    let file = open(path)?;
    // It may be another one by now.
    is_regular(&file.metadata()?)?;
    Ok(file)
}

/// What the file is, links followed.
///
/// # Errors
/// What the system reports; a link that leads nowhere is called so.
pub(super) fn metadata(path: &Path) -> io::Result<Metadata> {
    fs::metadata(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound if path.is_symlink() => {
            io::Error::new(io::ErrorKind::NotFound, "is a link that leads nowhere")
        }
        _ => error,
    })
}

fn is_regular(meta: &Metadata) -> io::Result<()> {
    match () {
        () if meta.is_file() => Ok(()),
        () if meta.is_dir() => Err(io::Error::other("is a folder")),
        () if is_pipe(meta) => Err(io::Error::other("is a pipe, and has to be an ordinary file here")),
        () => Err(io::Error::other("is a device")),
    }
}

#[cfg(unix)]
pub(super) fn is_pipe(meta: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    meta.file_type().is_fifo()
}

#[cfg(not(unix))]
pub(super) fn is_pipe(_: &Metadata) -> bool {
    false
}

/// Opens without waiting, should it be a pipe.
#[cfg(target_os = "linux")]
fn open(path: &Path) -> io::Result<File> {
    use rustix::fs::{Mode, OFlags, open};
    Ok(open(path, OFlags::RDONLY | OFlags::NONBLOCK | OFlags::CLOEXEC, Mode::empty())?.into())
}

#[cfg(not(target_os = "linux"))]
fn open(path: &Path) -> io::Result<File> {
    File::open(path)
}

/// Is there an ordinary file? A folder of this name is none.
///
/// # Errors
/// A pipe, a device, a link that leads nowhere: somebody put it there, and it cannot be called.
pub(super) fn ordinary(path: &Path) -> Result<Option<()>, FileError> {
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
