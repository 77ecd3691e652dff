//! Batches as files of Arrow and Parquet. The same batches give the same bytes.

use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_ipc::writer::StreamWriter;
use parquet::arrow::ArrowWriter;
use parquet::basic::{Compression, Encoding};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::schema::types::ColumnPath;

use super::arrow_file::{ArrowFile, of_arrow};
use super::schema::{VERSION, VERSION_KEY, schema};

/// Rows of a group of a Parquet file: what its writer holds in memory.
const GROUP: usize = 262_144;

/// A file that is being written.
pub enum Binary<W: Write + Send> {
    Stream(Box<StreamWriter<W>>),
    File(Box<ArrowFile<W>>),
    Parquet(Box<ArrowWriter<W>>),
}

impl<W: Write + Send> std::fmt::Debug for Binary<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Binary").finish_non_exhaustive()
    }
}

impl<W: Write + Send> Binary<W> {
    pub(super) fn stream(out: W) -> io::Result<Binary<W>> {
        Ok(Binary::Stream(Box::new(StreamWriter::try_new(out, &schema()).map_err(of_arrow)?)))
    }

    pub(super) fn file(out: W) -> io::Result<Binary<W>> {
        Ok(Binary::File(Box::new(ArrowFile::open(out)?)))
    }

    pub(super) fn parquet(out: W) -> io::Result<Binary<W>> {
        let file = ArrowWriter::try_new(out, schema(), Some(properties())).map_err(of_parquet)?;
        Ok(Binary::Parquet(Box::new(file)))
    }

    pub fn write(&mut self, batch: &RecordBatch) -> io::Result<()> {
        match self {
            Binary::Stream(stream) => stream.write(batch).map_err(of_arrow),
            Binary::File(file) => file.write(batch),
            Binary::Parquet(file) => file.write(batch).map_err(of_parquet),
        }
    }

    pub fn finish(self) -> io::Result<W> {
        match self {
            Binary::Stream(stream) => stream.into_inner().map_err(of_arrow),
            Binary::File(file) => file.finish(),
            Binary::Parquet(file) => file.into_inner().map_err(of_parquet),
        }
    }
}

fn properties() -> WriterProperties {
    let about = KeyValue::new(VERSION_KEY.to_owned(), VERSION.to_owned());
    let line = || ColumnPath::from("line");
    let block = || ColumnPath::from("block");
    WriterProperties::builder()
        .set_created_by(concat!("partc ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(vec![about]))
        .set_compression(Compression::SNAPPY)
        .set_max_row_group_row_count(Some(GROUP))
        .set_statistics_enabled(EnabledStatistics::Chunk)
        // They count up: differences are small.
        .set_column_dictionary_enabled(line(), false)
        .set_column_encoding(line(), Encoding::DELTA_BINARY_PACKED)
        .set_column_dictionary_enabled(block(), false)
        .set_column_encoding(block(), Encoding::DELTA_BYTE_ARRAY)
        .build()
}

fn of_parquet(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(error) => match error.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(error) => io::Error::other(error.to_string()),
        },
        other => io::Error::other(other.to_string()),
    }
}
