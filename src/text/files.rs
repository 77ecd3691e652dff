//! How the compiler gets at files: it asks [`Files`] and never the file system.

use std::fmt;
use std::io;
use std::sync::Arc;

/// Bytes that can be read at any place; a file is not loaded as a whole unless its program jumps.
pub trait ReadAt {
    /// Length in bytes.
    fn len(&self) -> u64;
    /// Reads up to `buf.len()` bytes from `at`; 0 at the end.
    ///
    /// # Errors
    /// What the operating system reports.
    fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize>;

    fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Text held in memory.
#[derive(Debug, Clone)]
pub struct Memory(Arc<[u8]>);

impl Memory {
    pub fn new(bytes: impl Into<Arc<[u8]>>) -> Memory {
        Memory(bytes.into())
    }
}

impl ReadAt for Memory {
    fn len(&self) -> u64 {
        self.0.len() as u64
    }

    fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize> {
        let from = usize::try_from(at).unwrap_or(usize::MAX).min(self.0.len());
        let n = buf.len().min(self.0.len() - from);
        buf[..n].copy_from_slice(&self.0[from..from + n]);
        Ok(n)
    }
}

/// A program that another program calls.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// Identity of the program that asks.
    pub from: &'a str,
    /// Name as written in the program, control path and all.
    pub name: &'a str,
    /// Extensions to try, in order, when the name has none (without the dot).
    pub extensions: &'a [&'a str],
    /// Where a name without a drive or folder of the control is looked for.
    pub within: Within,
}

/// The folders in which a name without a drive or folder of the control is looked for. Which of them a control searches is
/// part of its language; who keeps all programs in one place need not tell them apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Within {
    /// The folder of the main program.
    Main,
    /// The folder of the program that asks.
    Caller,
    /// Every folder that is known. Of files in two of them none goes before the other.
    #[default]
    Anywhere,
    /// None: the configuration names this file of the computer.
    Configured,
}

/// A file that was found.
pub struct Opened {
    /// Name for people and for the output; never an absolute path of the host.
    pub name: String,
    /// The same string for the same file, whatever name it was asked by.
    pub identity: String,
    pub text: Box<dyn ReadAt>,
}

impl fmt::Debug for Opened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Opened").field("name", &self.name).field("identity", &self.identity).finish_non_exhaustive()
    }
}

/// Why a called program is not to be had.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FileError {
    /// No such file in the include roots; the names that were tried, and similar names that exist.
    NotFound { tried: Vec<String>, similar: Vec<String> },
    /// The name points outside the include roots, or is no name a control accepts.
    Forbidden { why: String },
    /// More than one file fits: upper and lower case are ignored, or they lie in folders of one rank.
    Ambiguous { names: Vec<String> },
    /// The control's drive or folder has no entry in `[include] roots`.
    NoRoot { prefix: String },
    /// The operating system refused.
    Io { why: String },
}

/// Where called programs come from.
pub trait Files {
    /// Opens the program that `request` names.
    ///
    /// # Errors
    /// See [`FileError`].
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError>;

    /// The folder of this computer that stands for `folder` of the control, or for one in which it lies, because it is called so, and
    /// not because a configuration says it; and that folder of the control.
    fn copy_of(&self, folder: &str) -> Option<(String, &'static str)> {
        let _ = folder;
        None
    }

    /// The folder of the control in which the main program lies, because its folder on this computer is called so; the last part as it is
    /// called there.
    fn home(&self) -> Option<&str> {
        None
    }
}

/// A folder of a control, and what a copy of it is called on a computer.
#[derive(Debug, Clone, Copy)]
pub struct ControlFolder {
    /// As programs write it: `/_N_SPF_DIR`.
    pub path: &'static str,
    /// Names of its copies, in capitals.
    pub copies: [&'static str; 4],
    /// Programs lie in folders of it whose names end so; where there is none, in itself.
    pub below: &'static [&'static str],
}

impl ControlFolder {
    /// Is a folder of this name a copy of it?
    pub fn is_copied_as(&self, name: &str) -> bool {
        self.copies.iter().any(|copy| copy.eq_ignore_ascii_case(name))
    }
}

/// No program can be called.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        Err(FileError::NotFound { tried: vec![request.name.to_owned()], similar: Vec::new() })
    }
}

/// Files by name, all in one folder and in memory. Upper and lower case are one, as on a control.
#[derive(Debug, Default)]
pub struct Folder {
    files: Vec<(String, Arc<[u8]>)>,
}

impl Folder {
    pub fn add(&mut self, name: &str, bytes: impl Into<Arc<[u8]>>) {
        self.files.push((name.to_owned(), bytes.into()));
    }
}

impl Files for Folder {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let name = request.name.rsplit(['/', '\\', ':']).next().unwrap_or(request.name);
        let mut tried = vec![name.to_owned()];
        if !name.contains('.') {
            tried.extend(request.extensions.iter().map(|extension| format!("{name}.{extension}")));
        }
        for wanted in &tried {
            let found: Vec<_> = self.files.iter().filter(|(name, _)| name.eq_ignore_ascii_case(wanted)).collect();
            match found[..] {
                [] => {}
                [(name, bytes)] => {
                    let text = Box::new(Memory(Arc::clone(bytes)));
                    return Ok(Opened { identity: name.clone(), name: name.clone(), text });
                }
                _ => return Err(FileError::Ambiguous { names: found.iter().map(|(name, _)| name.clone()).collect() }),
            }
        }
        Err(FileError::NotFound { tried, similar: Vec::new() })
    }
}
