//! What tells one version of a file from the next: where it lies on its disk, its size, the time of its last change.
//!
//! A program that somebody rewrites while it is read would be compiled as a mixture of two.

use std::fs::Metadata;
use std::path::Path;
use std::time::SystemTime;

/// What is said of a file whose stamp is another one now.
pub(super) const CHANGED: &str = "changed while it was read";

/// A version of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Stamp {
    /// In bytes.
    len: u64,
    /// `None` on disks that keep no time.
    changed: Option<SystemTime>,
    /// Disk, and number of the file on it: another file may have got its name.
    place: Option<(u64, u64)>,
    /// An ordinary file: a pipe is another one with each look.
    is_file: bool,
}

impl Stamp {
    pub fn of(meta: &Metadata) -> Stamp {
        Stamp { len: meta.len(), changed: meta.modified().ok(), place: place(meta), is_file: meta.is_file() }
    }

    /// The version of the file that lies at a path; `None` where no ordinary one does.
    pub fn at(path: &Path) -> Option<Stamp> {
        path.metadata().ok().filter(Metadata::is_file).map(|meta| Stamp::of(&meta))
    }

    pub fn is_of_file(&self) -> bool {
        self.is_file
    }

    pub fn len(&self) -> u64 {
        self.len
    }
}

#[cfg(unix)]
fn place(meta: &Metadata) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt as _;
    Some((meta.dev(), meta.ino()))
}

#[cfg(not(unix))]
fn place(_: &Metadata) -> Option<(u64, u64)> {
    None
}
