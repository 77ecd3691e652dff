//! Tables on their way in. The only file with `unsafe`: the Arrow C stream interface hands over a pointer.
#![allow(unsafe_code, reason = "a stream of another library comes as a pointer in a capsule")]

use arrow_array::ffi_stream::{FFI_ArrowArrayStream, RecordBatchStreamReader};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::fault::Fault;

/// The batches of anything that has `__arrow_c_stream__`: tables and readers of PyArrow, frames of Polars and pandas,
/// relations of DuckDB.
pub fn reader(table: &Bound<'_, PyAny>) -> PyResult<RecordBatchStreamReader> {
    let Ok(method) = table.getattr("__arrow_c_stream__") else {
        let kind = table.get_type().name()?;
        return Err(Fault::Config(format!("a {kind} is no table of Arrow: it has no __arrow_c_stream__")).into());
    };
    let capsule = method.call0()?;
    let capsule = capsule.cast::<PyCapsule>()?;
    // Fails unless this is a capsule of this name that nobody else made invalid.
    let pointer = capsule.pointer_checked(Some(c"arrow_array_stream"))?.cast::<FFI_ArrowArrayStream>();
    // SAFETY: a capsule of this name holds an `ArrowArrayStream` (Arrow PyCapsule interface), which lives as long as the capsule,
    // and the capsule lives to the end of this function. `from_raw` moves it out and leaves a released stream, so that it
    // is freed once; the lock of the interpreter is held, so that nobody else does the same meanwhile.
    let stream = unsafe { FFI_ArrowArrayStream::from_raw(pointer.as_ptr()) };
    RecordBatchStreamReader::try_new(stream).map_err(|error| Fault::Config(error.to_string()).into())
}
