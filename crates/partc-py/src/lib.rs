//! partc for Python: the native half of the package `partc`, which is in `python/partc`.
//!
//! A [`job::Job`] is a program with what is said about it; its methods are the commands. All of them work without the lock of
//! the interpreter. Findings and figures cross the border as JSON, moves as record batches of Arrow. No panic crosses it.

#![deny(unsafe_code)]

mod capsule;
mod config;
mod fault;
mod import;
mod job;
mod listing;
mod rows;
mod stream;
mod table;

use pyo3::prelude::*;

#[pymodule]
fn _partc(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("ConfigError", py.get_type::<fault::ConfigError>())?;
    module.add("InternalError", py.get_type::<fault::InternalError>())?;
    module.add("ProgramError", py.get_type::<fault::ProgramError>())?;
    module.add_class::<config::Settings>()?;
    module.add_class::<job::Job>()?;
    module.add_class::<stream::Traced>()?;
    module.add_class::<stream::Batch>()?;
    module.add_class::<stream::Batches>()?;
    module.add_function(wrap_pyfunction!(config::canonical, module)?)?;
    module.add_function(wrap_pyfunction!(config::load, module)?)?;
    module.add_function(wrap_pyfunction!(job::diff, module)?)?;
    module.add_function(wrap_pyfunction!(listing::explain, module)?)?;
    module.add_function(wrap_pyfunction!(listing::targets, module)?)?;
    module.add_function(wrap_pyfunction!(listing::command_line, module)?)?;
    module.add_function(wrap_pyfunction!(stream::trace_schema, module)?)?;
    module.add_function(wrap_pyfunction!(table::compile_table, module)?)?;
    module.add_function(wrap_pyfunction!(table::table_schema, module)?)?;
    Ok(())
}
