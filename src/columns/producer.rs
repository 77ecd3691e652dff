//! The side of the run: takes the motion stream as it comes, and hands it on in chunks.
//!
//! A program of more than one chunk has its columns filled by a second thread, which works on one while the next ones are made.
//! Which of both does it changes nothing of what comes out.

use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, SyncSender, channel, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, Scope, ScopedJoinHandle};

use rustc_hash::FxHashMap;

use crate::diag::{CallPath, Diags, Trail};
use crate::ir::motion::{Move, Sink};
use crate::ir::{Function, Origin, Pos};
use crate::text::{BlockNumbers, FileId, Sources};

use super::chunk::{Chunk, Item, Row};
use super::{Columns, Until};

/// Chunks that wait for the second thread.
const WAITING: usize = 4;

/// What tells where a move comes from, and whether it counts.
pub(crate) struct Known<'a> {
    pub sources: &'a Sources,
    pub trail: &'a Trail,
    pub diags: &'a Diags,
}

/// Takes the moves of a run.
pub(super) struct Front<'f, 'scope, 'env, 'c: 'scope> {
    known: Known<'f>,
    until: Until,
    chunk: Chunk,
    hands: Hands<'scope, 'env, 'c>,
    /// Nobody wants more moves.
    ended: bool,
    numbers: BlockNumbers,
    /// Keys of the files.
    files: Vec<Option<i32>>,
    named: i32,
    /// Keys of the call paths, and the one that was asked for last.
    paths: FxHashMap<CallPath, i32>,
    last_path: (CallPath, Option<i32>),
}

impl<'f, 'scope, 'env, 'c: 'scope> Front<'f, 'scope, 'env, 'c> {
    pub fn new(
        known: Known<'f>,
        until: Until,
        scope: &'scope Scope<'scope, 'env>,
        columns: &'scope Mutex<Columns<'c>>,
    ) -> Front<'f, 'scope, 'env, 'c> {
        Front {
            known,
            until,
            chunk: Chunk::default(),
            hands: Hands { scope, columns, second: None, alone: has_one_core() },
            ended: false,
            numbers: BlockNumbers::default(),
            files: Vec::new(),
            named: 0,
            paths: FxHashMap::default(),
            last_path: (CallPath::MAIN, None),
        }
    }

    /// Hands over the rest. True where the program ran without an error.
    pub fn finish(mut self) -> bool {
        self.hand_over();
        self.hands.rest();
        !self.known.diags.has_errors()
    }

    /// Behind an error nobody knows where the moves lead.
    #[inline]
    fn is_silent(&self) -> bool {
        self.ended || self.known.diags.has_errors()
    }

    #[inline]
    fn item(&mut self, item: Item) {
        self.chunk.items.push(item);
        if self.chunk.is_full() {
            self.hand_over();
        }
    }

    fn hand_over(&mut self) {
        if !self.chunk.items.is_empty() && !self.ended {
            self.ended = !self.hands.take(&mut self.chunk);
        }
        self.chunk.clear();
    }

    fn row(&mut self, mv: &Move, origin: &Origin) -> Row {
        let number = self.numbers.bytes_of(self.known.sources, origin.loc).map(|number| {
            self.chunk.numbers.extend_from_slice(number);
            self.chunk.numbers.len() as u32
        });
        let (file, call_path) = (self.file(origin.loc.file), self.call_path(origin.call));
        Row { mv: *mv, line: origin.loc.line, number, file, call_path }
    }

    fn file(&mut self, id: FileId) -> i32 {
        let place = usize::from(id.0);
        match self.files.get(place) {
            Some(Some(key)) => *key,
            _ => self.new_file(id, place),
        }
    }

    #[cold]
    fn new_file(&mut self, id: FileId, place: usize) -> i32 {
        self.files.resize(self.files.len().max(place + 1), None);
        self.chunk.files.push(self.known.sources.name(id));
        let key = self.named;
        self.named += 1;
        self.files[place] = Some(key);
        key
    }

    fn call_path(&mut self, call: CallPath) -> Option<i32> {
        if call == self.last_path.0 {
            return self.last_path.1;
        }
        let (Known { sources, trail, .. }, chunk) = (&self.known, &mut self.chunk);
        let next = i32::try_from(self.paths.len()).unwrap_or(i32::MAX);
        let key = (call != CallPath::MAIN).then(|| {
            *self.paths.entry(call).or_insert_with(|| {
                let sites = trail.sites(call);
                let calls: Vec<String> =
                    sites.iter().rev().map(|site| format!("{}:{}", sources.name(site.file), site.line)).collect();
                chunk.call_paths.push(calls.join(" > "));
                next
            })
        });
        self.last_path = (call, key);
        key
    }
}

impl Sink for Front<'_, '_, '_, '_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        if !self.is_silent() {
            let row = self.row(mv, origin);
            self.item(Item::Move(row));
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if !matches!(function, Function::Comment(_) | Function::Remark(_)) && !self.is_silent() {
            self.item(Item::Function(function.clone()));
        }
    }

    fn lost(&mut self, _: &Origin) {
        if !self.is_silent() {
            self.item(Item::Lost);
        }
    }

    fn begins_at(&mut self, at: &Pos) {
        if !self.is_silent() {
            self.item(Item::BeginsAt(*at));
        }
    }

    fn full(&self) -> bool {
        match self.until {
            Until::Taken => self.ended,
            Until::FirstError => self.is_silent(),
            Until::End => false,
        }
    }
}

/// Who fills the columns.
struct Hands<'scope, 'env, 'c: 'scope> {
    scope: &'scope Scope<'scope, 'env>,
    columns: &'scope Mutex<Columns<'c>>,
    second: Option<Second<'scope>>,
    /// There is no second thread, and there shall be none.
    alone: bool,
}

/// The thread that fills the columns.
struct Second<'scope> {
    chunks: SyncSender<Chunk>,
    /// Chunks that were done.
    done: Receiver<Chunk>,
    thread: ScopedJoinHandle<'scope, ()>,
}

impl<'scope, 'c: 'scope> Hands<'scope, '_, 'c> {
    /// Takes what is in the chunk; false where nobody wants more.
    fn take(&mut self, chunk: &mut Chunk) -> bool {
        if self.second.is_none() && !self.alone && chunk.is_full() {
            self.second = self.start();
            self.alone = self.second.is_none();
        }
        let Some(second) = &self.second else {
            let mut columns = self.columns.lock().unwrap_or_else(PoisonError::into_inner);
            columns.chunk(chunk);
            return !columns.ended;
        };
        let next = second.done.try_recv().unwrap_or_default();
        second.chunks.send(std::mem::replace(chunk, next)).is_ok()
    }

    /// `None` where the system has no threads.
    fn start(&self) -> Option<Second<'scope>> {
        let (send, chunks) = sync_channel::<Chunk>(WAITING);
        let (give_back, done) = channel();
        let columns = self.columns;
        let work = move || {
            let mut columns = columns.lock().unwrap_or_else(PoisonError::into_inner);
            while let Ok(mut chunk) = chunks.recv() {
                columns.chunk(&chunk);
                if columns.ended {
                    return;
                }
                chunk.clear();
                // At the end nobody takes it back.
                let _ = give_back.send(chunk);
            }
        };
        let thread = thread::Builder::new().name("columns".to_owned()).spawn_scoped(self.scope, work).ok()?;
        Some(Second { chunks: send, done, thread })
    }

    /// Waits until all is done.
    fn rest(&mut self) {
        let Some(Second { chunks, thread, .. }) = self.second.take() else { return };
        drop(chunks);
        if let Err(panic) = thread.join() {
            resume_unwind(panic);
        }
    }
}

/// Two threads on one core only wait for each other.
fn has_one_core() -> bool {
    cfg!(target_family = "wasm") || thread::available_parallelism().is_ok_and(|cores| cores.get() == 1)
}
