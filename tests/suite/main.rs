//! The test suite: golden programs, the independent interpreter, hostile input, the command line.

mod cli;
mod common;
mod diagnostics;
mod golden;
mod hostile;
mod layering;
mod oracle;
mod rs274;
mod sweep;
