//! A table of programs becomes a table of results, batch by batch.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::thread;

use arrow_array::cast::AsArray;
use arrow_array::{Array, ArrayRef, BooleanArray, Float64Array, Int64Array, ListArray, MapArray, RecordBatch};
use arrow_array::{RecordBatchReader, StringArray, StructArray};
use arrow_buffer::OffsetBuffer;
use arrow_schema::{ArrowError, DataType, Field, Fields, Schema, SchemaRef};
use partc::diagnostics::{Finding, Severity, Site};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::config::{Named, Settings};
use crate::fault::{Fault, caught};
use crate::job::{Compiled, Job};
use crate::stream::{Batches, Reader};
use crate::{capsule, import};

const STACK: usize = 8 << 20;

/// The columns of a finding.
static FINDING: LazyLock<Fields> = LazyLock::new(|| {
    let text = |name: &str, null: bool| Field::new(name, DataType::Utf8, null);
    let whole = |name: &str| Field::new(name, DataType::Int64, false);
    Fields::from(vec![
        text("code", false),
        text("name", false),
        text("severity", false),
        text("message", false),
        text("help", true),
        text("file", false),
        whole("line"),
        whole("column"),
        whole("end_line"),
        whole("end_column"),
        text("block", true),
        text("call_path", true),
    ])
});

fn item() -> Arc<Field> {
    Arc::new(Field::new("item", DataType::Struct(FINDING.clone()), true))
}

/// The columns of a result.
static RESULT: LazyLock<SchemaRef> = LazyLock::new(|| {
    let figure = |name: &str| Field::new(name, DataType::Float64, true);
    let whole = |name: &str, null: bool| Field::new(name, DataType::Int64, null);
    Arc::new(Schema::new(vec![
        Field::new("name", DataType::Utf8, false),
        Field::new("ok", DataType::Boolean, false),
        Field::new("gcode", DataType::Utf8, true),
        Field::new("diagnostics", DataType::List(item()), false),
        whole("errors", false),
        whole("warnings", false),
        whole("moves", true),
        figure("cutting_mm"),
        figure("rapid_mm"),
        figure("time_s"),
        Field::new("trouble", DataType::Utf8, true),
    ]))
});

/// Results of the programs of a table, made as they are pulled.
#[pyfunction]
#[pyo3(signature = (table, settings, dialect, target, jobs))]
pub fn compile_table(
    table: &Bound<'_, PyAny>,
    settings: Option<Py<Settings>>,
    dialect: Option<String>,
    target: Option<String>,
    jobs: usize,
) -> PyResult<Batches> {
    let reader = import::reader(table)?;
    let columns = Columns::of(&reader.schema())?;
    let defaults = Defaults { settings, asked: (dialect, target), jobs: jobs.clamp(1, 256) };
    let results: Reader = Box::new(Results { reader: Box::new(reader), columns, defaults });
    Ok(Batches::new(results))
}

/// The schema of the results.
#[pyfunction]
pub fn table_schema(py: Python<'_>) -> PyResult<Bound<'_, PyCapsule>> {
    capsule::schema(py, &RESULT)
}

/// What holds for rows that say nothing else.
struct Defaults {
    settings: Option<Py<Settings>>,
    asked: (Option<String>, Option<String>),
    jobs: usize,
}

/// Places of the columns.
struct Columns {
    name: Option<usize>,
    program: usize,
    files: Option<usize>,
    config: Option<usize>,
}

impl Columns {
    fn of(schema: &Schema) -> Result<Columns, Fault> {
        let place = |name: &str| {
            let mut places = (0..schema.fields().len()).filter(|at| schema.field(*at).name() == name);
            match (places.next(), places.next()) {
                (_, Some(_)) => Err(Fault::Config(format!("the table has two columns `{name}`"))),
                (place, None) => Ok(place),
            }
        };
        let missing = || Fault::Config("the table has no column `program` with the text of the programs".to_owned());
        Ok(Columns {
            name: place("name")?,
            program: place("program")?.ok_or_else(missing)?,
            files: place("files")?,
            config: place("config")?,
        })
    }
}

struct Results {
    reader: Reader,
    columns: Columns,
    defaults: Defaults,
}

impl Iterator for Results {
    type Item = Result<RecordBatch, ArrowError>;

    fn next(&mut self) -> Option<Self::Item> {
        let batch = match self.reader.next()? {
            Ok(batch) => batch,
            Err(error) => return Some(Err(error)),
        };
        let made = caught(|| compiled(&batch, &self.columns, &self.defaults));
        Some(made.map_err(|fault| ArrowError::ExternalError(Box::new(fault))))
    }
}

impl RecordBatchReader for Results {
    fn schema(&self) -> SchemaRef {
        Arc::clone(&RESULT)
    }
}

/// What came of a row.
struct Row {
    name: String,
    made: Result<Compiled, String>,
}

fn compiled(batch: &RecordBatch, columns: &Columns, defaults: &Defaults) -> Result<RecordBatch, Fault> {
    let (next, rows) = (AtomicUsize::new(0), Mutex::new(VecDeque::from_iter((0..batch.num_rows()).map(|_| None))));
    let work = || {
        // Neighbours often have the same configuration.
        let mut last: Option<(String, Settings)> = None;
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            if at >= batch.num_rows() {
                return Ok(());
            }
            let row = one(batch, at, columns, defaults, &mut last)?;
            rows.lock().unwrap_or_else(PoisonError::into_inner)[at] = Some(row);
        }
    };
    let jobs = defaults.jobs.min(batch.num_rows());
    if jobs < 2 {
        work()?;
    } else {
        thread::scope(|scope| {
            let start = |_| thread::Builder::new().stack_size(STACK).spawn_scoped(scope, || caught(work));
            let threads: Vec<_> = (0..jobs).map(start).collect();
            let started = threads.into_iter().map(|thread| thread.map_err(|error| Fault::Internal(error.to_string())));
            let joined = |thread: thread::ScopedJoinHandle<'_, _>| {
                thread.join().unwrap_or_else(|_| Err(Fault::Internal("a thread was lost".to_owned())))
            };
            started.map(|thread| thread.and_then(joined)).collect::<Result<Vec<()>, Fault>>()
        })?;
    }
    let rows: Vec<Row> = rows.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten().collect();
    written(&rows)
}

fn one(
    batch: &RecordBatch,
    at: usize,
    columns: &Columns,
    defaults: &Defaults,
    last: &mut Option<(String, Settings)>,
) -> Result<Row, Fault> {
    let name = columns.name.map(|place| bytes_at(batch.column(place).as_ref(), at, "name")).transpose()?.flatten();
    let name = name.map_or_else(|| "program".to_owned(), |name| String::from_utf8_lossy(name).into_owned());
    let program = bytes_at(batch.column(columns.program).as_ref(), at, "program")?;
    let Some(program) = program else { return Ok(Row { name, made: Err("there is no program".to_owned()) }) };
    let files = columns.files.map(|place| files_at(batch.column(place).as_ref(), at)).transpose()?.flatten();
    let config =
        columns.config.map(|place| bytes_at(batch.column(place).as_ref(), at, "config")).transpose()?.flatten();
    let made = || {
        let settings = match config {
            None => defaults.settings.as_ref().map(|settings| settings.get()),
            Some(config) => {
                let config = String::from_utf8_lossy(config);
                if last.as_ref().is_none_or(|(known, _)| *known != config) {
                    *last = Some((config.to_string(), Settings::read(&config, Vec::new())?));
                }
                last.as_ref().map(|(_, settings)| settings)
            }
        };
        Job::of_bytes(&name, program, files, settings, defaults.asked.clone())?.compiled()
    };
    match caught(made) {
        Ok(made) => Ok(Row { name, made: Ok(made) }),
        // A row that cannot be used does not stop the others.
        Err(Fault::Config(why) | Fault::Program(why)) => Ok(Row { name, made: Err(why) }),
        Err(Fault::Internal(why)) => Ok(Row { name, made: Err(why) }),
    }
}

/// Text or bytes of a row, in any of the forms that libraries choose.
fn bytes_at<'a>(array: &'a dyn Array, at: usize, column: &str) -> Result<Option<&'a [u8]>, Fault> {
    if array.is_null(at) {
        return Ok(None);
    }
    Ok(Some(match array.data_type() {
        DataType::Utf8 => array.as_string::<i32>().value(at).as_bytes(),
        DataType::LargeUtf8 => array.as_string::<i64>().value(at).as_bytes(),
        DataType::Utf8View => array.as_string_view().value(at).as_bytes(),
        DataType::Binary => array.as_binary::<i32>().value(at),
        DataType::LargeBinary => array.as_binary::<i64>().value(at),
        DataType::BinaryView => array.as_binary_view().value(at),
        DataType::Null => return Ok(None),
        // Words that are kept once.
        DataType::Dictionary(..) => {
            let key = array.slice(at, 1).as_any_dictionary().normalized_keys()[0];
            return bytes_at(array.as_any_dictionary().values().as_ref(), key, column);
        }
        other => return Err(Fault::Config(format!("the column `{column}` is {other}, neither text nor bytes"))),
    }))
}

/// Pairs of name and bytes: a map, or a list of such pairs.
fn files_at(array: &dyn Array, at: usize) -> Result<Option<Named>, Fault> {
    if array.is_null(at) {
        return Ok(None);
    }
    let pairs: ArrayRef = match array.data_type() {
        DataType::Map(..) => {
            let map: &MapArray = array.as_map();
            Arc::new(map.value(at))
        }
        DataType::List(_) => array.as_list::<i32>().value(at),
        DataType::LargeList(_) => array.as_list::<i64>().value(at),
        DataType::Null => return Ok(None),
        _ => return Err(no_files()),
    };
    let pairs = pairs.as_struct_opt().filter(|pairs| pairs.num_columns() == 2).ok_or_else(no_files)?;
    let named = |at: usize| matches!(pairs.fields()[at].name().as_str(), "name" | "key");
    if !named(0) && named(1) {
        return Err(Fault::Config("the pairs of the column `files` have the name behind the bytes".to_owned()));
    }
    let mut files = Vec::new();
    for row in 0..pairs.len() {
        let name = bytes_at(pairs.column(0).as_ref(), row, "files")?.unwrap_or_default();
        let bytes = bytes_at(pairs.column(1).as_ref(), row, "files")?.unwrap_or_default();
        files.push((String::from_utf8_lossy(name).into_owned(), bytes.into()));
    }
    Ok(Some(files))
}

fn no_files() -> Fault {
    Fault::Config("the column `files` is a map, or a list of pairs: name and bytes".to_owned())
}

fn written(rows: &[Row]) -> Result<RecordBatch, Fault> {
    let made = || rows.iter().map(|row| row.made.as_ref().ok());
    let count = |severity: Severity| {
        let of = |made: &Compiled| made.findings.iter().filter(|found| found.severity == severity).count() as i64;
        Int64Array::from_iter_values(made().map(|made| made.map_or(0, of)))
    };
    let figure =
        |key: &str| -> Vec<Option<&serde_json::Value>> { made().map(|made| made?.stats.as_ref()?.get(key)).collect() };
    let number = |key: &str| Float64Array::from_iter(figure(key).into_iter().map(|value| value?.as_f64()));
    let columns: Vec<ArrayRef> = vec![
        Arc::new(StringArray::from_iter_values(rows.iter().map(|row| &row.name))),
        Arc::new(BooleanArray::from_iter(made().map(|made| Some(made.is_some_and(|made| made.code.is_some()))))),
        Arc::new(StringArray::from_iter(made().map(|made| made?.code.as_deref()))),
        Arc::new(diagnostics(rows)),
        Arc::new(count(Severity::Error)),
        Arc::new(count(Severity::Warning)),
        Arc::new(Int64Array::from_iter(figure("moves").into_iter().map(|value| value?.as_i64()))),
        Arc::new(number("cutting_mm")),
        Arc::new(number("rapid_mm")),
        Arc::new(number("time_s")),
        Arc::new(StringArray::from_iter(rows.iter().map(|row| row.made.as_ref().err()))),
    ];
    RecordBatch::try_new(Arc::clone(&RESULT), columns).map_err(|error| Fault::Internal(error.to_string()))
}

fn diagnostics(rows: &[Row]) -> ListArray {
    let findings = |row: &Row| row.made.as_ref().map_or(0, |made| made.findings.len());
    let lengths = OffsetBuffer::from_lengths(rows.iter().map(findings));
    let all: Vec<&Finding> = rows.iter().filter_map(|row| row.made.as_ref().ok()).flat_map(|m| &m.findings).collect();
    let text = |of: fn(&Finding) -> Option<&str>| -> ArrayRef {
        Arc::new(StringArray::from_iter(all.iter().map(|found| of(found))))
    };
    let whole = |of: fn(&Finding) -> u32| -> ArrayRef {
        Arc::new(Int64Array::from_iter_values(all.iter().map(|found| i64::from(of(found)))))
    };
    let path = |stack: &[Site]| {
        let calls = stack.iter().rev().map(|site| format!("{}:{}", site.file, site.line));
        (!stack.is_empty()).then(|| calls.collect::<Vec<_>>().join(" > "))
    };
    let columns = vec![
        text(|found| Some(found.code)),
        text(|found| Some(found.name)),
        text(|found| Some(found.severity.word())),
        text(|found| Some(&found.message)),
        text(|found| found.help.as_deref()),
        text(|found| Some(&found.file)),
        whole(|found| found.line),
        whole(|found| found.column),
        whole(|found| found.end_line),
        whole(|found| found.end_column),
        text(|found| found.block.as_deref()),
        Arc::new(StringArray::from_iter(all.iter().map(|found| path(&found.stack)))),
    ];
    ListArray::new(item(), lengths, Arc::new(StructArray::new(FINDING.clone(), columns, None)), None)
}
