//! Changes to the text of a program, which are written only where the program still does the same.

use std::io::Write as _;
use std::path::Path;

use crate::diag::{Diagnostic, Severity};
use crate::dialect::Dialect;
use crate::driver::Session;
use crate::lint::fix::Fix;
use crate::machine::Settings;
use crate::text::{FileId, Memory, Opened, Span};

use super::Trouble;
use super::disk::IncludeRoots;
use super::options::Common;
use super::pending::Pending;
use super::program::{Loaded, load};

/// Bytes of a program that is changed: it is held in memory.
const LARGEST: u64 = 256 << 20;

/// Findings of a program that is changed: nearly all of them, so that few rounds are enough.
const MOST_FINDINGS: usize = 1 << 20;

/// Another text for a stretch of bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Edit {
    pub span: Span,
    pub text: Vec<u8>,
}

/// A program in memory with everything that is needed to run any text of it.
pub(super) struct Program {
    pub text: Vec<u8>,
    pub dialect: &'static Dialect,
    pub settings: Settings,
    files: IncludeRoots,
    name: String,
    identity: String,
}

impl Program {
    pub(super) fn read(path: &Path, common: &Common) -> Result<Program, Trouble> {
        if path == Path::new("-") {
            return Err("a program that is changed has to be a file".to_owned());
        }
        let Loaded { session, dialect, settings, files, .. } = load(path, common)?;
        let size = session.sources.size(FileId(0));
        if size > LARGEST {
            return Err(format!("{}: programs over {} MiB are not changed", path.display(), LARGEST >> 20));
        }
        let text = session.sources.bytes(FileId(0), Span { start: 0, end: size as u32 });
        let (name, identity) = (session.sources.name(FileId(0)), session.sources.identity(FileId(0)));
        Ok(Program { text, dialect, settings, files, name, identity })
    }

    pub(super) fn session(&self, text: &[u8]) -> Session {
        let memory = Box::new(Memory::new(text.to_vec()));
        let session = Session::new(Opened { name: self.name.clone(), identity: self.identity.clone(), text: memory });
        session.diags.keep(MOST_FINDINGS);
        session
    }

    /// The session of a check of this text.
    pub(super) fn check(&self, text: &[u8]) -> Session {
        let session = self.session(text);
        self.fixes(&session);
        session
    }

    /// Checks the text of the session, and gives what would mend some of the findings.
    pub(super) fn fixes(&self, session: &Session) -> Vec<Fix> {
        session.check(self.dialect, &self.settings, &self.files)
    }

    /// Refuses where the program or what it calls changed since it was read.
    pub(super) fn unchanged(&self) -> Result<(), Trouble> {
        self.files.unchanged()
    }

    /// What this text of the program does, and how many errors it has.
    pub(super) fn does(&self, text: &[u8]) -> (u128, u32) {
        let session = self.session(text);
        let fingerprint = session.fingerprint(self.dialect, &self.settings, &self.files);
        (fingerprint, session.diags.errors())
    }
}

/// The text with the edits made; they do not overlap, and are sorted here.
pub(super) fn apply(text: &[u8], edits: &[Edit]) -> Vec<u8> {
    let mut edits: Vec<&Edit> = edits.iter().collect();
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let mut made = Vec::with_capacity(text.len() + 64);
    let mut at = 0;
    for edit in edits {
        let (start, end) = (edit.span.start as usize, edit.span.end as usize);
        if start < at || end > text.len() {
            continue;
        }
        made.extend_from_slice(&text[at..start]);
        made.extend_from_slice(&edit.text);
        at = end;
    }
    made.extend_from_slice(&text[at..]);
    made
}

/// Replaces the program in one step.
pub(super) fn write(path: &Path, text: &[u8]) -> Result<(), Trouble> {
    let written = Pending::replace(path).and_then(|mut file| {
        file.write_all(text)?;
        file.commit()
    });
    written.map_err(|error| format!("{}: {error}", path.display()))
}

/// Findings in the program itself that can be ignored and are at least so bad.
pub(super) fn ignorable(list: Vec<Diagnostic>, least: Severity) -> Vec<Diagnostic> {
    let own = |found: &Diagnostic| {
        found.label.loc.file == FileId(0) && !found.code.is_firm() && !found.code.id.starts_with("P800")
    };
    list.into_iter().filter(|found| own(found) && found.severity >= least).collect()
}
