//! Batches as files: CSV, Arrow and Parquet. The same batches give the same bytes.

use std::io::{self, Write};

#[cfg(feature = "columns")]
use super::binary::Binary;
use super::csv::Csv;
use arrow_array::RecordBatch;

/// Forms of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// RFC 4180, with the names of the columns in the first line.
    Csv,
    /// Arrow IPC, one batch after the other.
    ArrowStream,
    /// Arrow IPC with its batches listed at the end; also known as Feather 2.
    ArrowFile,
    /// Compressed with Snappy.
    Parquet,
}

/// A table that is being written.
pub enum Table<W: Write + Send> {
    Csv(Csv<W>),
    #[cfg(feature = "columns")]
    Binary(Binary<W>),
}

impl<W: Write + Send> std::fmt::Debug for Table<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Table").finish_non_exhaustive()
    }
}

impl<W: Write + Send> Table<W> {
    /// # Errors
    /// What `out` reports, and a form that this build does not have.
    pub fn open(form: Form, out: W) -> io::Result<Table<W>> {
        match form {
            Form::Csv => Ok(Table::Csv(Csv::open(out)?)),
            #[cfg(feature = "columns")]
            Form::ArrowStream => Ok(Table::Binary(Binary::stream(out)?)),
            #[cfg(feature = "columns")]
            Form::ArrowFile => Ok(Table::Binary(Binary::file(out)?)),
            #[cfg(feature = "columns")]
            Form::Parquet => Ok(Table::Binary(Binary::parquet(out)?)),
            #[cfg(not(feature = "columns"))]
            _ => Err(io::Error::other("this partc was built without the feature `columns`")),
        }
    }

    /// # Errors
    /// What the output reports.
    pub fn write(&mut self, batch: &RecordBatch) -> io::Result<()> {
        match self {
            Table::Csv(csv) => csv.write(batch),
            #[cfg(feature = "columns")]
            Table::Binary(file) => file.write(batch),
        }
    }

    /// Writes what stands at the end.
    ///
    /// # Errors
    /// What the output reports.
    pub fn finish(self) -> io::Result<W> {
        match self {
            Table::Csv(csv) => Ok(csv.finish()),
            #[cfg(feature = "columns")]
            Table::Binary(file) => file.finish(),
        }
    }
}
