//! Batches as dictionaries, for who has no library for tables.

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int32Type, Int64Type};
use arrow_array::{Array, RecordBatch};
use arrow_schema::DataType;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString};

use crate::fault::Fault;

pub fn of<'py>(py: Python<'py>, batch: &RecordBatch) -> PyResult<Bound<'py, PyList>> {
    let schema = batch.schema();
    let names: Vec<Bound<'py, PyString>> = schema.fields().iter().map(|f| PyString::intern(py, f.name())).collect();
    let rows: Vec<Bound<'py, PyDict>> = (0..batch.num_rows()).map(|_| PyDict::new(py)).collect();
    for (name, column) in names.iter().zip(batch.columns()) {
        let values = column_of(py, column.as_ref())?;
        for (row, value) in rows.iter().zip(values) {
            row.set_item(name, value)?;
        }
    }
    PyList::new(py, rows)
}

/// The values of a column.
fn column_of<'py>(py: Python<'py>, array: &dyn Array) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let none = || py.None().into_bound(py);
    let count = 0..array.len();
    let shown = |at: usize, value: Bound<'py, PyAny>| if array.is_null(at) { none() } else { value };
    Ok(match array.data_type() {
        DataType::Float64 => {
            let array = array.as_primitive::<Float64Type>();
            count.map(|at| Ok(shown(at, array.value(at).into_pyobject(py)?.into_any()))).collect::<PyResult<_>>()?
        }
        DataType::Int64 => {
            let array = array.as_primitive::<Int64Type>();
            count.map(|at| Ok(shown(at, array.value(at).into_pyobject(py)?.into_any()))).collect::<PyResult<_>>()?
        }
        DataType::Boolean => {
            let array = array.as_boolean();
            count
                .map(|at| Ok(shown(at, array.value(at).into_pyobject(py)?.to_owned().into_any())))
                .collect::<PyResult<_>>()?
        }
        DataType::Utf8 => {
            let array = array.as_string::<i32>();
            count.map(|at| shown(at, PyString::new(py, array.value(at)).into_any())).collect()
        }
        DataType::Dictionary(..) => {
            let array = array.as_dictionary::<Int32Type>();
            let words = column_of(py, array.values().as_ref())?;
            let word = |key: i32| words.get(usize::try_from(key).unwrap_or(usize::MAX)).cloned();
            count
                .map(|at| if array.is_null(at) { none() } else { word(array.keys().value(at)).unwrap_or_else(none) })
                .collect()
        }
        DataType::List(_) => {
            let array = array.as_list::<i32>();
            let list = |at: usize| Ok(shown(at, PyList::new(py, column_of(py, array.value(at).as_ref())?)?.into_any()));
            count.map(list).collect::<PyResult<_>>()?
        }
        DataType::Struct(_) => {
            let whole = RecordBatch::from(array.as_struct().clone());
            of(py, &whole)?.iter().collect()
        }
        other => return Err(Fault::Internal(format!("a column of {other} has no rows")).into()),
    })
}
