//! What is no finding in a program, as exceptions.

use std::any::Any;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

create_exception!(partc, ConfigError, PyValueError, "The call or the configuration is at fault.");
create_exception!(partc, InternalError, PyRuntimeError, "partc is at fault. Please report it with the program.");
create_exception!(partc, ProgramError, PyException, "A program among others has errors.");

/// Why there is nothing to give.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fault {
    /// Usage or configuration.
    Config(String),
    /// The program has errors: moves that were made of it must not be used.
    Program(String),
    /// partc itself.
    Internal(String),
}

impl Fault {
    /// Nothing runs here that would make more batches.
    pub fn forked() -> Fault {
        let why = "these batches were begun in another process, of which this one is a fork";
        Fault::Config(format!("{why}: begin them anew, or start processes with `spawn`"))
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Fault::Config(text) | Fault::Program(text) | Fault::Internal(text)) = self;
        f.write_str(text)
    }
}

impl std::error::Error for Fault {}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> PyErr {
        match fault {
            Fault::Config(text) => ConfigError::new_err(text),
            Fault::Program(text) => ProgramError::new_err(text),
            Fault::Internal(text) => InternalError::new_err(text),
        }
    }
}

/// Works without the lock of the interpreter; a panic becomes an [`InternalError`].
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> Result<T, Fault> + Send) -> PyResult<T> {
    py.detach(|| caught(work)).map_err(PyErr::from)
}

/// A panic becomes a fault.
pub fn caught<T>(work: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|panic| Err(Fault::Internal(said(&*panic))))
}

fn said(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    let text = text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default();
    format!("internal error: {text}")
}
