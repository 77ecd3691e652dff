//! Opening program files, and what is said when that fails.

use crate::diag::{Answer, CallPath, Diagnostic, codes};
use crate::sema::Job;
use crate::text::blocks::{Hole, OpenError};
use crate::text::sources::{MAX_ALL_CALLED, MAX_CALLED, TooMuch};
use crate::text::{Cursor, FileError, FileId, Loc, Opened, Place, Request, Span, SplitRules, Within};

/// Opens a file for reading from its start; reports what is wrong with it.
pub fn open_cursor(job: &Job<'_>, file: FileId, rules: SplitRules, from: Loc) -> Option<Cursor> {
    let error = match Cursor::open(job.sources, file, rules) {
        Ok(cursor) => return Some(cursor),
        Err(error) => error,
    };
    let name = job.sources.shown(file);
    let found = match error {
        OpenError::Utf16 => codes::P0001::is_utf_16_file(&name).at(from),
        OpenError::TooLarge => codes::P0002::is_over_4_gib(&name).at(from),
        OpenError::Empty => codes::P0004::is_empty(&name).at(from),
        OpenError::Io(error) => codes::P0105::cannot_be_read(&name, &error).at(from),
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
            codes::P0005::nul_or_ctrl_z_stands_inside_block().at(loc)
        } else {
            codes::P0006::nul_or_ctrl_z_stands_between_blocks().at(loc)
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
    find_program(job, wanted, from, call).map_err(|found| job.diags.push(*found)).ok()
}

/// The same; a finding that is not reported yet where it cannot be opened.
pub fn find_program(job: &Job<'_>, wanted: &Wanted<'_>, from: Loc, call: CallPath) -> Result<FileId, Box<Diagnostic>> {
    let found = match look_for(job, wanted, from, call) {
        Ok(opened) => match job.sources.add(opened) {
            Ok(id) => return Ok(id),
            Err(too_much) => refused(too_much, wanted.name, from),
        },
        Err(error) => not_opened(error, wanted.name, from),
    };
    Err(Box::new(found.called(call)))
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
    job.diags.push(codes::P0107::does_not_lie_beside_program_that_names(&name, &opened.name).at(from).called(call));
    Ok(opened)
}

/// The finding for a file that is not found or cannot be opened.
pub fn not_opened(error: FileError, name: &str, from: Loc) -> Diagnostic {
    match error {
        FileError::NotFound { tried, similar } => {
            let found =
                codes::P0101::program_is_not_found(&name).at(from).here(format!("looked for {}", tried.join(", ")));
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
            codes::P0102::program_may_not_be_opened(&name, &why).answer(Answer::folder_of(&[name])).at(from)
        }
        FileError::Ambiguous { names } => {
            let folder = |name: &String| name.rsplit_once(['/', '\\']).map(|(folder, _)| folder.to_owned());
            let one_folder = names.windows(2).all(|pair| folder(&pair[0]) == folder(&pair[1]));
            let help = if one_folder { "rename all but one" } else { "rename all but one, or call it by its path" };
            codes::P0103::program_may_be_any(&name, &names.join(", ")).at(from).help(help)
        }
        FileError::NoRoot { prefix } => no_root(&prefix, from),
        FileError::Io { why } => codes::P0105::program_cannot_be_read(&name, &why).at(from),
    }
}

/// The finding for a drive or folder of the control that no root stands for.
pub fn no_root(prefix: &str, from: Loc) -> Diagnostic {
    codes::P0104::no_folder_is_known(&prefix).answer(Answer::entry("include", "roots", prefix)).at(from)
}

/// The finding for a called file that is not taken.
pub fn refused(too_much: TooMuch, name: &str, from: Loc) -> Diagnostic {
    let mib = |bytes: u64| bytes.div_ceil(1 << 20);
    match too_much {
        TooMuch::Files => codes::P0106::too_many_programs_are_called().at(from),
        TooMuch::Bytes(size) => {
            let (size, most) = (mib(size), mib(MAX_CALLED));
            codes::P0120::called_program_has_mib(&name, &size, &most).at(from)
        }
        TooMuch::AllBytes(all) => {
            let (all, most) = (mib(all), mib(MAX_ALL_CALLED));
            codes::P0121::with_called_programs_have_mib(&name, &all, &most).at(from)
        }
    }
}
