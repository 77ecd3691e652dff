//! A trace as columns: record batches of Arrow, for tables, notebooks and engines that take such.
//!
//! In: the motion stream, element by element. Out: [`RecordBatch`]es of so many rows, a row for each move, with the facts of
//! `partc trace`. Memory does not grow with the program: what is kept beside the open batch are the names of files and the
//! distinct call paths. Decides nothing about geometry, and rounds nothing.

mod arrays;
#[cfg(feature = "columns")]
mod arrow_file;
#[cfg(feature = "columns")]
mod csv;
mod row;
pub mod schema;
#[cfg(feature = "columns")]
mod table;

use std::collections::VecDeque;

use arrow_array::{ArrayRef, RecordBatch};

use crate::diag::Trail;
use crate::emit::stats::{Clock, Ended, Model, Time};
use crate::ir::motion::{Move, Sink};
use crate::ir::{Function, Origin, Pos};
use crate::text::Sources;

use row::{Rows, TIME};
pub use schema::{COLUMNS, Column, Kind, VERSION, VERSION_KEY, schema};
#[cfg(feature = "columns")]
pub use table::{Form, Table};

/// How the moves become batches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Rows of a batch, at least 1; the last one has fewer.
    pub rows: usize,
    /// The machine whose time is told.
    pub model: Model,
}

impl Default for Options {
    fn default() -> Options {
        Options { rows: 65_536, model: Model::default() }
    }
}

/// Makes batches of moves.
///
/// `take` gets each batch, and says whether it wants more: otherwise the run may stop.
pub struct Columns<'a> {
    rows: Rows<'a>,
    clock: Clock,
    most: usize,
    /// Number of the first row of the open batch.
    first: u64,
    /// Times of the open batch, no number where none is known.
    times: Vec<f64>,
    /// Batches that are full, of which the time of a move is still open.
    full: VecDeque<Full>,
    take: &'a mut dyn FnMut(RecordBatch) -> bool,
    ended: bool,
}

struct Full {
    first: u64,
    columns: Vec<ArrayRef>,
    times: Vec<f64>,
}

impl std::fmt::Debug for Columns<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Columns").field("first", &self.first).finish_non_exhaustive()
    }
}

impl<'a> Columns<'a> {
    pub fn new(
        sources: &'a Sources,
        trail: &'a Trail,
        options: Options,
        take: &'a mut dyn FnMut(RecordBatch) -> bool,
    ) -> Columns<'a> {
        Columns {
            rows: Rows::new(sources, trail),
            clock: Clock::new(options.model),
            most: options.rows.max(1),
            first: 0,
            times: Vec::new(),
            full: VecDeque::new(),
            take,
            ended: false,
        }
    }

    /// The rest.
    pub fn finish(mut self) {
        let ended = self.clock.stop();
        self.settle(ended);
        if !self.times.is_empty() {
            self.close();
        }
        self.release();
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
        let times = std::mem::replace(&mut self.times, Vec::with_capacity(self.most.min(1 << 16)));
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
            columns.insert(TIME, arrays::times(full.times));
            let batch = RecordBatch::try_new(schema(), columns).expect("a column for each field, all of one length");
            self.ended = self.ended || !(self.take)(batch);
        }
    }
}

impl Sink for Columns<'_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        if self.ended {
            return;
        }
        let from = *self.clock.at();
        let step = self.clock.movement(mv);
        self.settle(step.ended);
        self.rows.push(mv, origin, &from, step.length);
        self.times.push(if step.time == Time::None { 0.0 } else { f64::NAN });
        if self.times.len() >= self.most {
            self.close();
            self.release();
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        let ended = self.clock.function(function);
        self.settle(ended);
        self.rows.function(function);
    }

    fn lost(&mut self, _: &Origin) {
        let ended = self.clock.lost();
        self.settle(ended);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.clock.begins_at(at);
    }

    fn full(&self) -> bool {
        self.ended
    }
}

#[cfg(test)]
mod tests;
