//! A trace as columns: record batches of Arrow, for tables, notebooks and engines that take such.
//!
//! In: the motion stream, element by element ([`front`]). Out: [`RecordBatch`]es of so many rows, a row for each move, with the
//! facts of `partc trace`. Memory does not grow with the program: what is kept beside the open batch are the names of files
//! and the distinct call paths. Decides nothing about geometry, and rounds nothing.

mod arrays;
#[cfg(feature = "columns")]
mod arrow_file;
#[cfg(feature = "columns")]
mod binary;
mod buffer_pool;
mod chunk;
#[cfg(feature = "cli")]
mod csv;
mod producer;
mod row;
pub mod schema;
#[cfg(feature = "cli")]
mod table;

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};
use std::thread;

use arrow_array::{ArrayRef, RecordBatch};

use crate::emit::stats::{Clock, Ended, Model, Time};
use crate::ir::motion::Sink;
use crate::ir::workpiece::InWorkpiece;

use buffer_pool::BufferPool;
use chunk::{Chunk, Item, Row};
use producer::Front;
pub(crate) use producer::Known;
use row::{Rows, TIME};
pub use schema::{COLUMNS, Column, Kind, VERSION, VERSION_KEY, schema};
#[cfg(feature = "cli")]
pub use table::{Form, Table};

/// How the moves become batches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Rows of a batch, at least 1; the last one has fewer.
    pub rows: usize,
    /// The machine whose time is told.
    pub model: Model,
    pub until: Until,
}

impl Default for Options {
    fn default() -> Options {
        Options { rows: 65_536, model: Model::default(), until: Until::Taken }
    }
}

/// How long the program runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Until {
    /// As long as somebody wants more batches. An error ends the batches, and not the run.
    Taken,
    /// The same, or up to the first error.
    FirstError,
    /// To its end, for its findings, also when nobody wants more batches.
    End,
}

/// Gets each batch, maybe in another thread, and says whether it wants more.
pub type Take<'a> = dyn FnMut(RecordBatch) -> bool + Send + 'a;

/// Makes batches of the moves that `run` sends, in workpiece coordinates, and gives what it returns. An error ends them: the moves behind it are in none,
/// and a batch that was not full is not made.
pub(crate) fn batches<T>(
    known: Known<'_>,
    options: Options,
    take: &mut Take<'_>,
    run: impl FnOnce(&mut dyn Sink) -> T,
) -> T {
    let columns = Mutex::new(Columns::new(options, take));
    let (ran, is_right) = thread::scope(|scope| {
        let mut front = Front::new(known, options.until, scope, &columns);
        let ran = run(&mut InWorkpiece::new(&mut front));
        (ran, front.finish())
    });
    if is_right {
        columns.into_inner().unwrap_or_else(PoisonError::into_inner).finish();
    }
    ran
}

/// The columns of the open batch, and those that wait for a time.
struct Columns<'a> {
    rows: Rows,
    clock: Clock,
    most: usize,
    /// Number of the first row of the open batch.
    first: u64,
    /// Times of the open batch, no number where none is known.
    times: Vec<f64>,
    pool: BufferPool,
    /// Batches that are full, of which the time of a move is still open.
    full: VecDeque<Full>,
    take: &'a mut Take<'a>,
    ended: bool,
}

struct Full {
    first: u64,
    columns: Vec<ArrayRef>,
    times: Vec<f64>,
}

impl<'a> Columns<'a> {
    fn new(options: Options, take: &'a mut Take<'a>) -> Columns<'a> {
        Columns {
            rows: Rows::new(),
            clock: Clock::new(options.model),
            most: options.rows.max(1),
            first: 0,
            times: Vec::new(),
            pool: BufferPool::default(),
            full: VecDeque::new(),
            take,
            ended: false,
        }
    }

    /// The rest.
    fn finish(mut self) {
        if self.ended {
            return;
        }
        let ended = self.clock.stop();
        self.settle(ended);
        if !self.times.is_empty() {
            self.close();
        }
        self.release();
    }

    /// What comes next.
    fn chunk(&mut self, chunk: &Chunk) {
        self.rows.names(&chunk.files, &chunk.call_paths);
        let mut begin = 0;
        for item in &chunk.items {
            match item {
                Item::Move(row) => {
                    let number = row.number.map(|end| &chunk.numbers[begin..end as usize]);
                    begin = row.number.map_or(begin, |end| end as usize);
                    self.movement(row, number);
                }
                Item::Function(function) => {
                    let ended = self.clock.function(function);
                    self.settle(ended);
                    self.rows.function(function);
                }
                Item::Lost => {
                    let ended = self.clock.lost();
                    self.settle(ended);
                }
                Item::BeginsAt(at) => self.clock.begins_at(at),
            }
            if self.ended {
                return;
            }
        }
    }

    fn movement(&mut self, row: &Row, number: Option<&[u8]>) {
        let from = *self.clock.at();
        let step = self.clock.movement(&row.mv);
        self.settle(step.ended);
        self.rows.push(row, number, &from, step.length);
        self.times.push(if step.time == Time::None { 0.0 } else { f64::NAN });
        if self.times.len() >= self.most {
            self.close();
            self.release();
        }
    }

    /// A time that was open is known.
    fn settle(&mut self, ended: Option<Ended>) {
        let Some(Ended { number, time, .. }) = ended else { return };
        let (first, times) = match self.full.iter_mut().rfind(|full| full.first <= number) {
            Some(full) if number < self.first => (full.first, &mut full.times),
            _ => (self.first, &mut self.times),
        };
        if let Some(place) = times.get_mut((number - first) as usize) {
            *place = time;
        }
        if !self.full.is_empty() {
            self.release();
        }
    }

    /// The open batch is full.
    fn close(&mut self) {
        let times = std::mem::replace(&mut self.times, self.pool.take(self.most.min(1 << 16)));
        let first = self.first;
        self.first += times.len() as u64;
        self.full.push_back(Full { first, columns: self.rows.finish(), times });
    }

    /// Hands over what is complete.
    fn release(&mut self) {
        let open = self.clock.open().unwrap_or(u64::MAX);
        while let Some(full) = self.full.pop_front() {
            if full.first + full.times.len() as u64 > open {
                self.full.push_front(full);
                return;
            }
            let mut columns = full.columns;
            columns.insert(TIME, arrays::times(full.times, &mut self.pool));
            let batch = RecordBatch::try_new(schema(), columns).expect("a column for each field, all of one length");
            self.ended = self.ended || !(self.take)(batch);
        }
    }
}

#[cfg(test)]
mod tests;
