//! What the executors of all dialects share: the step budget, the cache of parsed blocks, opening files.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::diag::{CallPath, Diagnostic, codes};
use crate::text::blocks::{OpenError, Place};
use crate::text::{Cursor, FileError, FileId, Loc, Request, SplitRules};

use super::Job;

/// Counts executed blocks and knows which jump ran most often.
#[derive(Debug)]
pub struct Budget {
    left: u64,
    limit: u64,
    jumps: FxHashMap<Loc, u64>,
}

impl Budget {
    pub fn new(limit: u64) -> Budget {
        Budget { left: limit, limit, jumps: FxHashMap::default() }
    }

    /// Takes one step; false when none is left.
    #[inline]
    pub fn step(&mut self) -> bool {
        if self.left == 0 {
            return false;
        }
        self.left -= 1;
        true
    }

    /// Notes a jump, repeat or call at `from`.
    pub fn jump(&mut self, from: Loc) {
        *self.jumps.entry(from).or_default() += 1;
    }

    /// The report for a run that has no steps left; `here` is where it stopped.
    pub fn exceeded(&self, here: Loc, call: CallPath) -> Diagnostic {
        let busiest = self.jumps.iter().max_by_key(|(loc, n)| (**n, std::cmp::Reverse((loc.file, loc.span.start))));
        let stopped = format!("stopped after {} blocks", self.limit);
        let found = match busiest {
            Some((&loc, n)) => Diagnostic::new(codes::P4001, loc, stopped)
                .here(format!("taken {n} times"))
                .also(here, "the run stopped here"),
            None => Diagnostic::new(codes::P4001, here, stopped).called(call),
        };
        found.help("check the condition that ends this loop, or raise `[limits] steps`")
    }
}

/// Most blocks kept parsed.
const CACHED: usize = 1 << 16;

/// Parsed blocks of programs that jump, by place.
#[derive(Debug)]
pub struct Cache<B> {
    blocks: FxHashMap<u32, Rc<B>>,
}

impl<B> Default for Cache<B> {
    fn default() -> Cache<B> {
        Cache { blocks: FxHashMap::default() }
    }
}

impl<B> Cache<B> {
    pub fn get(&self, at: u32) -> Option<Rc<B>> {
        self.blocks.get(&at).cloned()
    }

    /// Keeps a block; starts anew when there are too many.
    pub fn insert(&mut self, at: u32, block: Rc<B>) {
        if self.blocks.len() >= CACHED {
            self.blocks.clear();
        }
        self.blocks.insert(at, block);
    }
}

/// Opens a file for reading from its start; reports what is wrong with it.
pub fn open_cursor(job: &Job<'_>, file: FileId, rules: SplitRules, from: Loc) -> Option<Cursor> {
    let error = match Cursor::open(job.sources, file, rules) {
        Ok(cursor) => return Some(cursor),
        Err(error) => error,
    };
    let name = job.sources.name(file);
    let found = match error {
        OpenError::Utf16 => Diagnostic::new(codes::P0001, from, format!("`{name}` is a UTF-16 file"))
            .help("save it as UTF-8 or Windows-1252"),
        OpenError::TooLarge => Diagnostic::new(codes::P0002, from, format!("`{name}` is over 4 GiB")),
        OpenError::Empty => Diagnostic::new(codes::P0004, from, format!("`{name}` is empty"))
            .help("check whether the file was transferred completely"),
        OpenError::Io(error) => Diagnostic::new(codes::P0105, from, format!("`{name}` cannot be read: {error}")),
    };
    job.diags.push(found);
    None
}

/// Finds and opens the program `name` that the block at `from` calls.
pub fn open_program(job: &Job<'_>, name: &str, extensions: &[&str], from: Loc, call: CallPath) -> Option<FileId> {
    let caller = job.sources.identity(from.file);
    let error = match job.files.open(&Request { from: &caller, name, extensions }) {
        Ok(opened) => match job.sources.add(opened) {
            Some(id) => return Some(id),
            None => {
                job.diags.push(Diagnostic::new(codes::P0106, from, "too many programs are called").called(call));
                return None;
            }
        },
        Err(error) => error,
    };
    let found = match error {
        FileError::NotFound { tried, similar } => {
            let found = Diagnostic::new(codes::P0101, from, format!("program `{name}` is not found"))
                .here(format!("looked for {}", tried.join(", ")));
            match similar.first() {
                Some(like) => found.help(format!("did you mean `{like}`?")),
                None => found.help("put the file beside the program, or name its folder under `[include] roots`"),
            }
        }
        FileError::Forbidden { why } => {
            Diagnostic::new(codes::P0102, from, format!("program `{name}` may not be opened: {why}"))
                .help("name its folder under `[include] roots`")
        }
        FileError::Ambiguous { names } => {
            Diagnostic::new(codes::P0103, from, format!("program `{name}` may be any of {}", names.join(", ")))
                .help("rename all but one")
        }
        FileError::NoRoot { prefix } => {
            Diagnostic::new(codes::P0104, from, format!("no folder is known for `{prefix}`"))
                .help(format!("add `[include] roots = {{ \"{prefix}\" = \"folder\" }}` to partc.toml"))
        }
        FileError::Io { why } => Diagnostic::new(codes::P0105, from, format!("program `{name}` cannot be read: {why}")),
    };
    job.diags.push(found.called(call));
    None
}

/// A place to go on at: file by number in the executor, and the block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Target {
    pub program: usize,
    pub place: Place,
}
