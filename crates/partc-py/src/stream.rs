//! Moves as batches, made as they are pulled: a thread runs the program and waits while nobody takes a batch.

use std::sync::mpsc::{Receiver, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::{process, thread};

use arrow_array::{RecordBatch, RecordBatchReader};
use arrow_schema::{ArrowError, SchemaRef};
use partc::diagnostics::findings;
use partc::table::{self, Options, Until};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyList};

use crate::capsule;
use crate::fault::{Fault, caught, detached};
use crate::job::{Job, first_error, json};
use crate::rows;

/// Most rows of a trace that are kept rather than made again.
const KEPT: usize = 65_536;
/// What the main thread of a process has, too.
const STACK: usize = 8 << 20;

/// A reader that any library can pull.
pub type Reader = Box<dyn RecordBatchReader + Send>;

/// A program that was run once, so that no move of one with errors gets out.
#[pyclass(frozen, module = "partc._partc")]
pub struct Traced {
    job: Job,
    #[pyo3(get)]
    ok: bool,
    /// JSON.
    #[pyo3(get)]
    findings: String,
    /// All batches of a short program, and their rows.
    kept: Option<(usize, Vec<RecordBatch>)>,
    /// Of the main program.
    hash: u64,
}

impl Traced {
    pub fn of(job: &Job, rows: usize) -> Result<Traced, Fault> {
        let opened = job.open()?;
        let (mut kept, mut seen, mut whole) = (Vec::new(), 0, true);
        // Of a long program nothing is kept: its moves are made when somebody pulls them.
        let options = Options { rows: rows.clamp(1, KEPT), until: Until::End, ..Options::default() };
        let mut take = |batch: RecordBatch| {
            seen += batch.num_rows();
            whole = seen <= KEPT;
            if whole {
                kept.push(batch);
            } else {
                kept = Vec::new();
            }
            whole
        };
        let hash =
            opened.session.trace_batches(opened.dialect, &opened.settings, opened.files.as_ref(), options, &mut take);
        let ok = !opened.session.diags.has_errors();
        let findings = json(&findings(opened.session))?;
        let kept = if !ok { Some((rows, Vec::new())) } else { whole.then_some((rows, kept)) };
        Ok(Traced { job: job.clone(), ok, findings, kept, hash })
    }

    /// The moves as the program makes them; its first error ends them.
    pub fn unchecked(job: &Job, rows: usize) -> Result<Batches, Fault> {
        Ok(Batches::new(Box::new(Moves::of(job.clone(), rows, None)?)))
    }

    fn reader(&self, rows: usize) -> Result<Reader, Fault> {
        match &self.kept {
            Some((made_of, batches)) if !self.ok || *made_of == rows => {
                let all = batches.clone().into_iter().map(Ok);
                Ok(Box::new(arrow_array::RecordBatchIterator::new(all, table::schema())))
            }
            _ => Ok(Box::new(Moves::of(self.job.clone(), rows, Some(self.hash))?)),
        }
    }
}

#[pymethods]
impl Traced {
    /// From the first move on, with each call.
    fn batches(&self, rows: usize) -> PyResult<Batches> {
        Ok(Batches::new(self.reader(rows)?))
    }
}

/// The moves of a run that goes on in another thread.
struct Moves {
    batches: Receiver<Result<RecordBatch, Fault>>,
    ended: bool,
    /// The process that the thread runs in: one that was forked from it has no such thread.
    process: u32,
}

impl Moves {
    /// `checked` is the hash of the program that was found to have no errors.
    fn of(job: Job, rows: usize, checked: Option<u64>) -> Result<Moves, Fault> {
        // One batch waits while the next one is made.
        let (send, batches) = sync_channel(1);
        let run = move || {
            let made = caught(|| {
                let opened = job.open()?;
                let (files, until) = (opened.files.as_ref(), Until::FirstError);
                let options = Options { rows, until, ..Options::default() };
                let mut wanted = true;
                let mut take = |batch| {
                    wanted = send.send(Ok(batch)).is_ok();
                    wanted
                };
                let hash = opened.session.trace_batches(opened.dialect, &opened.settings, files, options, &mut take);
                if let Some(error) = first_error(opened.session) {
                    return Err(Fault::Program(format!("{error}: none of the program's moves must be used")));
                }
                if wanted && checked.is_some_and(|checked| checked != hash) {
                    let why = "has changed since it was checked: none of its moves must be used";
                    return Err(Fault::Program(format!("{}: the program {why}", job.name())));
                }
                Ok(())
            });
            // Nobody may be listening any more.
            if let Err(fault) = made {
                let _ = send.send(Err(fault));
            }
        };
        let started = thread::Builder::new().name("partc".to_owned()).stack_size(STACK).spawn(run);
        started.map_err(|error| Fault::Internal(error.to_string()))?;
        Ok(Moves { batches, ended: false, process: process::id() })
    }
}

impl Iterator for Moves {
    type Item = Result<RecordBatch, ArrowError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let next = if self.process == process::id() { self.batches.recv().ok() } else { Some(Err(Fault::forked())) };
        self.ended = !matches!(next, Some(Ok(_)));
        next.map(|batch| batch.map_err(|fault| ArrowError::ExternalError(Box::new(fault))))
    }
}

impl RecordBatchReader for Moves {
    fn schema(&self) -> SchemaRef {
        table::schema()
    }
}

/// Batches that can be pulled once: one by one, or by a library that takes streams of Arrow.
#[pyclass(frozen, module = "partc._partc")]
pub struct Batches {
    schema: SchemaRef,
    reader: Mutex<Option<Reader>>,
}

impl Batches {
    pub fn new(reader: Reader) -> Batches {
        Batches { schema: reader.schema(), reader: Mutex::new(Some(reader)) }
    }
}

#[pymethods]
impl Batches {
    fn __iter__(this: PyRef<'_, Self>) -> PyRef<'_, Self> {
        this
    }

    fn __next__(&self, py: Python<'_>) -> PyResult<Option<Batch>> {
        let batch = detached(py, || {
            let mut reader = self.reader.lock().unwrap_or_else(PoisonError::into_inner);
            reader.as_mut().and_then(Iterator::next).transpose().map_err(fault)
        })?;
        Ok(batch.map(Batch))
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        capsule::schema(py, &self.schema)
    }

    /// What is left; another schema than its own is not made.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        let _ = requested_schema;
        let taken = py.detach(|| self.reader.lock().unwrap_or_else(PoisonError::into_inner).take());
        let Some(reader) = taken else {
            return Err(PyValueError::new_err("these batches were taken before"));
        };
        capsule::stream(py, reader)
    }

    #[getter]
    fn column_names(&self) -> Vec<String> {
        self.schema.fields().iter().map(|field| field.name().clone()).collect()
    }
}

/// An error that went through Arrow is what it was.
fn fault(error: ArrowError) -> Fault {
    match error {
        ArrowError::ExternalError(error) => match error.downcast::<Fault>() {
            Ok(fault) => *fault,
            Err(error) => Fault::Config(error.to_string()),
        },
        error => Fault::Config(error.to_string()),
    }
}

/// Rows of a table.
#[pyclass(frozen, module = "partc._partc")]
pub struct Batch(pub RecordBatch);

#[pymethods]
impl Batch {
    #[getter]
    fn num_rows(&self) -> usize {
        self.0.num_rows()
    }

    #[getter]
    fn column_names(&self) -> Vec<String> {
        self.0.schema().fields().iter().map(|field| field.name().clone()).collect()
    }

    fn __len__(&self) -> usize {
        self.0.num_rows()
    }

    /// A dictionary for each row.
    fn to_rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        rows::of(py, &self.0)
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        capsule::schema(py, &self.0.schema())
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_array__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyCapsule>, Bound<'py, PyCapsule>)> {
        let _ = requested_schema;
        capsule::array(py, &self.0)
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        let _ = requested_schema;
        let batch = std::iter::once(Ok(self.0.clone()));
        capsule::stream(py, Box::new(arrow_array::RecordBatchIterator::new(batch, self.0.schema())))
    }
}

/// The schema of every trace.
#[pyfunction]
pub fn trace_schema(py: Python<'_>) -> PyResult<Bound<'_, PyCapsule>> {
    capsule::schema(py, &table::schema())
}
