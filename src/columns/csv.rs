//! Batches as comma-separated values (RFC 4180): lines end in CR LF, what is missing is empty.

use std::fmt::Write as _;
use std::io::{self, Write};

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int32Type, Int64Type};
use arrow_array::{Array, BooleanArray, Float64Array, Int32Array, Int64Array, RecordBatch, StringArray};

use super::schema::{COLUMNS, Kind};

/// Bytes written at a time.
const PART: usize = 1 << 16;

/// A table as text.
#[derive(Debug)]
pub struct Csv<W> {
    out: W,
    text: String,
}

/// A column of a batch.
enum Cells<'a> {
    Numbers(&'a Float64Array),
    Whole(&'a Int64Array),
    Truths(&'a BooleanArray),
    Words(&'a Int32Array, Vec<String>),
    Texts(&'a StringArray),
}

impl<W: Write> Csv<W> {
    /// Writes the names of the columns.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn open(mut out: W) -> io::Result<Csv<W>> {
        let names: Vec<&str> = COLUMNS.iter().map(|column| column.name).collect();
        out.write_all((names.join(",") + "\r\n").as_bytes())?;
        Ok(Csv { out, text: String::new() })
    }

    /// # Errors
    /// What the output reports.
    pub fn write(&mut self, batch: &RecordBatch) -> io::Result<()> {
        let columns: Vec<Cells<'_>> =
            batch.columns().iter().zip(COLUMNS).map(|(array, column)| cells(array, column.kind)).collect();
        for row in 0..batch.num_rows() {
            for (place, column) in columns.iter().enumerate() {
                if place > 0 {
                    self.text.push(',');
                }
                column.write(row, &mut self.text);
            }
            self.text.push_str("\r\n");
            if self.text.len() >= PART {
                self.out.write_all(self.text.as_bytes())?;
                self.text.clear();
            }
        }
        self.out.write_all(self.text.as_bytes())?;
        self.text.clear();
        Ok(())
    }

    pub fn finish(self) -> W {
        self.out
    }
}

fn cells(array: &dyn Array, kind: Kind) -> Cells<'_> {
    match kind {
        Kind::Number => Cells::Numbers(array.as_primitive::<Float64Type>()),
        Kind::Whole => Cells::Whole(array.as_primitive::<Int64Type>()),
        Kind::Truth => Cells::Truths(array.as_boolean()),
        Kind::Text => Cells::Texts(array.as_string::<i32>()),
        Kind::Word => {
            let words = array.as_dictionary::<Int32Type>();
            let quoted = words.values().as_string::<i32>().iter().map(|word| quoted(word.unwrap_or_default()));
            Cells::Words(words.keys(), quoted.collect())
        }
    }
}

impl Cells<'_> {
    fn write(&self, row: usize, text: &mut String) {
        let array: &dyn Array = match self {
            Cells::Numbers(array) => array,
            Cells::Whole(array) => array,
            Cells::Truths(array) => array,
            Cells::Words(keys, _) => keys,
            Cells::Texts(array) => array,
        };
        if array.is_null(row) {
            return;
        }
        // Writing to a text does not fail.
        let _ = match self {
            // No -0.
            Cells::Numbers(array) => write!(text, "{}", array.value(row) + 0.0),
            Cells::Whole(array) => write!(text, "{}", array.value(row)),
            Cells::Truths(array) => write!(text, "{}", array.value(row)),
            Cells::Words(keys, words) => {
                text.push_str(words.get(keys.value(row) as usize).map_or("", String::as_str));
                Ok(())
            }
            Cells::Texts(array) => {
                text.push_str(&quoted(array.value(row)));
                Ok(())
            }
        };
    }
}

/// A text as it stands between commas.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\r', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
