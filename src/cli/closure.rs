//! What a run reads is never replaced by what it writes, whatever `--force` says.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use super::disk::IncludeRoots;
use super::inputs::Input;
use super::key::Nowhere;
use super::options::Common;
use super::pool::in_order;
use super::program::{Loaded, load};
use super::{Trouble, config};

/// Files that a run will replace. What a program calls shows only when it has run: they are compared after that, and before
/// anything gets its name.
#[derive(Debug, Default)]
pub(super) struct Targets {
    /// Where each really lies, and how it was named.
    files: BTreeMap<PathBuf, PathBuf>,
    hit: AtomicBool,
}

impl Targets {
    /// Those of the files that exist: no other can be lost.
    pub fn new<'p>(files: impl IntoIterator<Item = &'p Path>) -> Targets {
        let there = files.into_iter().filter(|file| *file != Path::new("-") && file.is_file());
        let files = there.filter_map(|file| Some((fs::canonicalize(file).ok()?, file.to_path_buf()))).collect();
        Targets { files, hit: AtomicBool::new(false) }
    }

    /// Refuses where one of them is the program, what it called, its configuration or a table; and where the program or what it
    /// called changed while it was read, for then nobody knows what was read.
    ///
    /// # Errors
    /// A file that would be lost, or has changed; a configuration that can be read no more.
    pub fn spare(&self, program: &Path, common: &Common, files: &IncludeRoots) -> Result<(), Trouble> {
        files.unchanged()?;
        if self.files.is_empty() {
            return Ok(());
        }
        let named = common.stdin_filename.as_deref().filter(|_| program == Path::new("-")).unwrap_or(program);
        let settings = config::read_for(named, common)?.files.into_iter().map(|(_, path)| path);
        let called = files.looked().into_iter().filter(|(_, looked)| looked.found).map(|(path, _)| path);
        self.none_of(program, settings.chain(called).chain([program.to_path_buf()]))
    }

    /// The same for files that are known.
    ///
    /// # Errors
    /// A file that would be lost.
    pub fn none_of(&self, program: &Path, read: impl IntoIterator<Item = PathBuf>) -> Result<(), Trouble> {
        let lost = |path: PathBuf| self.files.get(&fs::canonicalize(path).ok()?);
        let Some(file) = read.into_iter().find_map(lost) else { return Ok(()) };
        self.hit.store(true, Ordering::Relaxed);
        let (file, program) = (file.display(), program.display());
        Err(format!(
            "{file}: is read for {program}, and would be replaced; name another file (--force is no help here)"
        ))
    }

    /// Runs all of several programs without output, so that none gets its name before a later program is seen to call that file.
    ///
    /// # Errors
    /// A file that would be lost. What cannot be read is said when the program's turn comes.
    pub fn look_ahead(&self, inputs: &[Input], jobs: Option<u16>, common: &Common) -> Result<(), Trouble> {
        let mut lost = None;
        let spared = |input: &Input| {
            let Ok(Loaded { session, dialect, settings, files, .. }) = load(&input.path, common) else { return Ok(()) };
            let _ = session.compile(dialect, &settings, &files, &mut Nowhere, None);
            self.spare(&input.path, common, &files)
        };
        in_order(jobs, inputs, spared, |_, result| lost = lost.take().or(result.err()));
        lost.map_or(Ok(()), Err)
    }

    /// Has a file been refused?
    pub fn was_hit(&self) -> bool {
        self.hit.load(Ordering::Relaxed)
    }
}
