//! What the executors of all dialects share: the step budget, the cache of parsed blocks, opening files.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::diag::{CallPath, Diagnostic, codes};
use crate::ir::contour::Sink;
use crate::text::blocks::{OpenError, Place};
use crate::text::sources::{MAX_ALL_CALLED, MAX_CALLED, TooMuch};
use crate::text::{Cursor, FileError, FileId, Loc, Next, Request, Span, SplitRules};

use super::Job;
use super::here::Here;

/// Moves of one block that cost nothing while a program runs straight on.
const FREE_MOVES: u64 = 16;
/// Bytes of a block, and operations of its formulas, that are one step.
const BYTES_A_STEP: u32 = 64;
const OPERATIONS_A_STEP: usize = 8;
/// Steps that parsing a block costs.
const PARSING: u64 = 5;
/// Steps that looking for a called program on the disk costs.
const SEARCH: u64 = 250;

/// Counts what a run costs in steps, and knows which jump ran most often.
///
/// A step is a block, a move or a long stretch of text: each takes about the same time, so that the limit of steps is
/// one of time, too.
#[derive(Debug)]
pub struct Budget {
    left: u64,
    limit: u64,
    jumps: FxHashMap<Loc, u64>,
    /// Moves that the sink had taken at the last look.
    moves: u64,
    /// Other things than blocks were counted.
    mixed: bool,
}

impl Budget {
    pub fn new(limit: u64) -> Budget {
        Budget { left: limit, limit, jumps: FxHashMap::default(), moves: 0, mixed: false }
    }

    /// Takes the steps of the block before and one for the next; false when none is left, or when `out` is full. Up to
    /// the first jump nothing can run for ever: a file that is read once may have any length.
    #[inline]
    pub fn step(&mut self, out: &dyn Sink) -> bool {
        let load = out.load();
        if self.left == 0 || load.full {
            return false;
        }
        let made = load.moves - self.moves;
        self.moves = load.moves;
        if made > 1 && (made > FREE_MOVES || !self.jumps.is_empty()) {
            self.mixed = true;
            self.left = self.left.saturating_sub(made);
        } else if !self.jumps.is_empty() {
            self.left -= 1;
        }
        true
    }

    /// The same between two places of a pattern, or wherever one block does much: is there anything left?
    pub fn goes_on(&mut self, out: &dyn Sink) -> bool {
        let load = out.load();
        self.mixed = true;
        self.left = self.left.saturating_sub(load.moves - self.moves);
        self.moves = load.moves;
        self.left > 0 && !load.full
    }

    /// Takes `n` steps, for work that grows with a number of the program; false when fewer are left.
    pub fn take(&mut self, n: u64) -> bool {
        self.mixed |= n > 0;
        let enough = self.left >= n;
        self.left = self.left.saturating_sub(n);
        enough
    }

    /// Takes what a block costs over the one step that every block has: its length in bytes, the operations of its
    /// formulas, and that it was parsed although it ran before.
    #[inline]
    pub fn block(&mut self, bytes: u32, operations: usize, parsed_again: bool) {
        if (bytes > BYTES_A_STEP || operations > OPERATIONS_A_STEP || parsed_again) && !self.jumps.is_empty() {
            let parsing = if parsed_again { PARSING } else { 0 };
            self.take(u64::from(bytes / BYTES_A_STEP) + (operations / OPERATIONS_A_STEP) as u64 + parsing);
        }
    }

    /// Takes the steps of looking for a called program.
    pub fn search(&mut self) {
        if !self.jumps.is_empty() {
            self.take(SEARCH);
        }
    }

    /// Notes a jump, repeat or call at `from`.
    pub fn jump(&mut self, from: Loc) {
        *self.jumps.entry(from).or_default() += 1;
    }

    /// Reports a run that has no steps left; `here` is where it stopped. That the output is full was reported.
    pub fn report_end(&self, job: &Job<'_>, out: &dyn Sink, here: Loc, call: CallPath) {
        if !out.load().full {
            job.diags.push(self.exceeded(here, call));
        }
    }

    fn exceeded(&self, here: Loc, call: CallPath) -> Diagnostic {
        let busiest = self.jumps.iter().max_by_key(|(loc, n)| (**n, std::cmp::Reverse((loc.file, loc.span.start))));
        let what = if self.mixed { "steps (blocks, moves and long lines)" } else { "blocks" };
        let stopped = format!("stopped after {} {what}", self.limit);
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

/// A block with what its execution needs besides.
#[derive(Debug, Clone, Default)]
pub struct Parsed<B> {
    pub block: B,
    /// The text of the block, where the block needs it.
    pub text: Vec<u8>,
    pub lines: u32,
    next: Place,
}

/// A file that runs: the reading position, and the blocks that were read before.
#[derive(Debug)]
pub struct Source<B> {
    pub file: FileId,
    pub cursor: Cursor,
    cache: Cache<Parsed<B>>,
    /// Up to here the file was read at least once.
    furthest: u32,
    /// The last block had been read before, and was parsed again.
    pub parsed_again: bool,
}

/// What [`Source::read`] found.
#[derive(Debug)]
pub enum Read {
    Block(Here),
    /// A block over 1 MiB, which was reported and passed over.
    TooLong,
    End,
    /// The file cannot be read on, which was reported.
    Broken,
}

impl<B: Clone> Source<B> {
    /// Opens a file; reports what is wrong with it.
    pub fn open(job: &Job<'_>, file: FileId, rules: SplitRules, from: Loc) -> Option<Source<B>> {
        open_cursor(job, file, rules, from).map(|cursor| Source {
            file,
            cursor,
            cache: Cache::default(),
            furthest: 0,
            parsed_again: false,
        })
    }

    /// The next block, if it was read before.
    #[inline]
    pub fn again(&mut self, call: CallPath) -> Option<(Rc<Parsed<B>>, Here)> {
        if !self.cursor.is_whole() {
            return None;
        }
        let place = self.cursor.place();
        let parsed = self.cache.get(place.at)?;
        self.cursor.resume(parsed.next);
        self.parsed_again = false;
        let here = Here::new(self.file, place.at, place.line, parsed.lines, call);
        Some((parsed, here))
    }

    /// Reads the next block and keeps it for [`Source::again`]; `parse` fills the block and its text.
    #[inline]
    pub fn read(
        &mut self,
        job: &Job<'_>,
        call: CallPath,
        into: &mut Parsed<B>,
        parse: impl FnOnce(&[u8], &mut Parsed<B>),
    ) -> Read {
        let at = self.cursor.place().at;
        let read = self.pass(job, call, into, parse);
        if self.cursor.is_whole() && matches!(read, Read::Block(_)) {
            into.next = self.cursor.place();
            self.cache.insert(at, Rc::new(Parsed::clone(into)));
        }
        read
    }

    /// Reads the next block, which is not executed now.
    #[inline]
    pub fn pass(
        &mut self,
        job: &Job<'_>,
        call: CallPath,
        into: &mut Parsed<B>,
        parse: impl FnOnce(&[u8], &mut Parsed<B>),
    ) -> Read {
        into.text.clear();
        let place = self.cursor.place();
        self.parsed_again = place.at < self.furthest;
        self.furthest = self.furthest.max(place.at.saturating_add(1));
        let read = match self.cursor.next(job.sources) {
            Ok(Next::Block(found)) => {
                parse(found.text, into);
                into.lines = found.lines;
                Read::Block(Here::new(self.file, place.at, place.line, into.lines, call))
            }
            Ok(Next::TooLong { at, line }) => {
                let loc = Loc { file: self.file, line, span: Span::at(at, 1) };
                job.diags.push(Diagnostic::new(codes::P0003, loc, "block is longer than 1 MiB").called(call));
                Read::TooLong
            }
            Ok(Next::End) => Read::End,
            Err(error) => {
                let loc = Loc { file: self.file, line: place.line, span: Span::at(place.at, 0) };
                let found = Diagnostic::new(codes::P0105, loc, format!("the file cannot be read: {error}"));
                job.diags.push(found.called(call));
                Read::Broken
            }
        };
        report_hole(job, self.file, &mut self.cursor, place, call);
        read
    }
}

/// Reports what is lost in a file; `block` was read last.
#[inline]
pub fn report_hole(job: &Job<'_>, file: FileId, cursor: &mut Cursor, block: Place, call: CallPath) {
    if let Some(Place { at, line }) = cursor.passed_hole(block) {
        let loc = Loc { file, line, span: Span::at(at, 1) };
        let found = Diagnostic::new(codes::P0005, loc, "NUL or Ctrl-Z bytes stand inside the program");
        job.diags.push(found.help("get the program anew: what stood here is lost").called(call));
    }
}

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
    job.diags.push(found);
    None
}

/// Finds and opens the program `name` that the block at `from` calls.
pub fn open_program(job: &Job<'_>, name: &str, extensions: &[&str], from: Loc, call: CallPath) -> Option<FileId> {
    let caller = job.sources.identity(from.file);
    let error = match job.files.open(&Request { from: &caller, name, extensions }) {
        Ok(opened) => match job.sources.add(opened) {
            Ok(id) => return Some(id),
            Err(too_much) => {
                job.diags.push(refused(too_much, name, from).called(call));
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

/// A place to go on at: file by number in the executor, and the block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Target {
    pub program: usize,
    pub place: Place,
}
