//! Opening program files, and what is said when that fails.

use crate::diag::{Answer, CallPath, Diagnostic, codes};
use crate::sema::Job;
use crate::text::blocks::{Hole, OpenError, Place};
use crate::text::sources::{MAX_ALL_CALLED, MAX_CALLED, TooMuch};
use crate::text::{Cursor, FileError, FileId, Loc, Opened, Request, Span, SplitRules, Within};

/// Opens a file for reading from its start; reports what is wrong with it.
pub fn open_cursor(job: &Job<'_>, file: FileId, rules: SplitRules, from: Loc) -> Option<Cursor> {
    let error = match Cursor::open(job.sources, file, rules) {
        Ok(cursor) => return Some(cursor),
        Err(error) => error,
    };
    let name = job.sources.shown(file);
    let found = match error {
        OpenError::Utf16 => Diagnostic::new(codes::P0001, from, format!("`{name}` is a UTF-16 file"))
            .help("save it as UTF-8 or Windows-1252"),
        OpenError::TooLarge => Diagnostic::new(codes::P0002, from, format!("`{name}` is over 4 GiB")),
        OpenError::Empty => Diagnostic::new(codes::P0004, from, format!("`{name}` is empty"))
            .help("check whether the file was transferred completely"),
        OpenError::Io(error) => Diagnostic::new(codes::P0105, from, format!("`{name}` cannot be read: {error}")),
    };
    // The form of the program was looked at before it runs.
    if !job.diags.knows(&found) {
        job.diags.push(found);
    }
    None
}

/// Reports what is lost in a file; `block` was read last.
#[inline]
pub fn report_hole(job: &Job<'_>, file: FileId, cursor: &mut Cursor, block: Place, call: CallPath) {
    if let Some(Hole { place, inside }) = cursor.passed_hole(block) {
        let loc = Loc { file, line: place.line, span: Span::at(place.at, 1) };
        let found = if inside {
            Diagnostic::new(codes::P0005, loc, "NUL or Ctrl-Z stands inside a block")
        } else {
            Diagnostic::new(codes::P0006, loc, "NUL or Ctrl-Z stands between the blocks of the program")
        };
        job.diags.push(found.help("something may be lost here: get the program anew").called(call));
    }
}

/// A file that a program names.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'w> {
    pub name: &'w str,
    /// Extensions to try, in order, when the name has none.
    pub extensions: &'w [&'w str],
    /// Where a control looks for a name without a path. What is not beside its caller, where it has to be, is taken from
    /// the only other folder that has it, and that is said.
    pub within: Within,
}

/// Finds and opens the program that the block at `from` calls.
pub fn open_program(job: &Job<'_>, wanted: &Wanted<'_>, from: Loc, call: CallPath) -> Option<FileId> {
    find_program(job, wanted, from, call).map_err(|found| job.diags.push(found)).ok()
}

/// The same; a finding that is not reported yet where it cannot be opened.
pub fn find_program(job: &Job<'_>, wanted: &Wanted<'_>, from: Loc, call: CallPath) -> Result<FileId, Diagnostic> {
    let found = match look_for(job, wanted, from, call) {
        Ok(opened) => match job.sources.add(opened) {
            Ok(id) => return Ok(id),
            Err(too_much) => refused(too_much, wanted.name, from),
        },
        Err(error) => not_opened(error, wanted.name, from),
    };
    Err(found.called(call))
}

/// Is the program that the block at `from` calls nowhere, so that what `[programs]` says may stand for it?
pub fn is_nowhere(job: &Job<'_>, wanted: &Wanted<'_>, from: Loc) -> bool {
    let caller = job.sources.identity(from.file);
    let Wanted { name, extensions, within } = *wanted;
    let opens = |within| job.files.open(&Request { from: &caller, name, extensions, within });
    let misses = |within| matches!(opens(within), Err(FileError::NotFound { .. } | FileError::NoRoot { .. }));
    misses(within) && (within != Within::Caller || misses(Within::Anywhere))
}

fn look_for(job: &Job<'_>, wanted: &Wanted<'_>, from: Loc, call: CallPath) -> Result<Opened, FileError> {
    let caller = job.sources.identity(from.file);
    let Wanted { name, extensions, within } = *wanted;
    let request = Request { from: &caller, name, extensions, within };
    let beside = job.files.open(&request);
    let has_path = name.starts_with(['/', '\\']) || name.contains(':');
    if within != Within::Caller || has_path || !matches!(beside, Err(FileError::NotFound { .. })) {
        return beside;
    }
    let opened = job.files.open(&Request { within: Within::Anywhere, ..request })?;
    let message = format!("`{name}` does not lie beside the program that names it; `{}` is taken", opened.name);
    let help = "on the control a name without a path means the folder of the program that names it: put the file there, or write its path";
    job.diags.push(Diagnostic::new(codes::P0107, from, message).help(help).called(call));
    Ok(opened)
}

/// The finding for a file that is not found or cannot be opened.
pub fn not_opened(error: FileError, name: &str, from: Loc) -> Diagnostic {
    match error {
        FileError::NotFound { tried, similar } => {
            let found = Diagnostic::new(codes::P0101, from, format!("program `{name}` is not found"))
                .here(format!("looked for {}", tried.join(", ")));
            match similar.first() {
                Some(like) if tried.contains(like) => found.help(format!("`{like}` is there, and is no file")),
                Some(like) => found.help(format!("did you mean `{like}`?")),
                None => found.help(
                    Answer::folder_of(&tried)
                        .help("put the file beside the program, or name its folder under `[include] roots`"),
                ),
            }
        }
        FileError::Forbidden { why } => {
            Diagnostic::new(codes::P0102, from, format!("program `{name}` may not be opened: {why}"))
                .help(Answer::folder_of(&[name]).help("name its folder under `[include] roots`"))
        }
        FileError::Ambiguous { names } => {
            let folder = |name: &String| name.rsplit_once(['/', '\\']).map(|(folder, _)| folder.to_owned());
            let one_folder = names.windows(2).all(|pair| folder(&pair[0]) == folder(&pair[1]));
            let help = if one_folder { "rename all but one" } else { "rename all but one, or call it by its path" };
            Diagnostic::new(codes::P0103, from, format!("program `{name}` may be any of {}", names.join(", ")))
                .help(help)
        }
        FileError::NoRoot { prefix } => no_root(&prefix, from),
        FileError::Io { why } => Diagnostic::new(codes::P0105, from, format!("program `{name}` cannot be read: {why}")),
    }
}

/// The finding for a drive or folder of the control that no root stands for.
pub fn no_root(prefix: &str, from: Loc) -> Diagnostic {
    Diagnostic::new(codes::P0104, from, format!("no folder is known for `{prefix}`")).help(
        Answer::entry("include", "roots", prefix)
            .help(format!("add `[include] roots = {{ \"{prefix}\" = \"folder\" }}` to partc.toml")),
    )
}

/// The finding for a called file that is not taken.
pub fn refused(too_much: TooMuch, name: &str, from: Loc) -> Diagnostic {
    let mib = |bytes: u64| bytes.div_ceil(1 << 20);
    match too_much {
        TooMuch::Files => Diagnostic::new(codes::P0106, from, "too many programs are called"),
        TooMuch::Bytes(size) => {
            let (size, most) = (mib(size), mib(MAX_CALLED));
            let message =
                format!("called program `{name}` has {size} MiB, more than the {most} MiB of one called file");
            Diagnostic::new(codes::P0120, from, message).help("compile it as a main program, or split it")
        }
        TooMuch::AllBytes(all) => {
            let (all, most) = (mib(all), mib(MAX_ALL_CALLED));
            let message = format!("with `{name}` the called programs have {all} MiB, more than {most} MiB together");
            Diagnostic::new(codes::P0121, from, message).help("compile the large ones as main programs")
        }
    }
}
