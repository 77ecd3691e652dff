//! partc compiles CNC part programs written in control dialects into plain, fully resolved G-code.
//!
//! The library opens no file by itself: programs come through [`files::Files`], output goes to [`output::Output`], and what is
//! wrong with a program is a list of [`diagnostics::Finding`]s. [`compile`], [`check`] and [`trace`] work on a program in
//! memory; a [`Session`] streams programs of any length, and draws them.
//!
//! ```
//! use partc::{Program, Settings, compile, files::NoFiles};
//!
//! let text = b"0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 FMAX\n2 L IX+10 F200\n3 END PGM A MM\n";
//! let result = compile(&Program::new("A.H", text)?, &Settings::default(), &NoFiles)?;
//! assert!(result.text.is_some_and(|code| code.contains("G1 X10 F200")));
//! # Ok::<(), partc::Trouble>(())
//! ```

#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::unwrap_used))]

mod block_ends;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "arrow")]
mod columns;
mod compare;
mod diag;
mod dialect;
mod driver;
mod emit;
mod facade;
mod geo;
mod ir;
mod lexer;
mod lint;
mod lower;
#[cfg(feature = "cli")]
mod lsp;
mod machine;
pub mod page_data;
mod parser;
mod program_needs;
mod read;
mod sema;
mod standard;
mod target;
mod text;
mod validate;
mod validated;

pub use dialect::Dialect;
pub use driver::{Failure, Session};
#[cfg(feature = "arrow")]
pub use facade::trace_batches;
pub use facade::{Outcome, Program, Trouble, check, compile, trace};
pub use machine::Settings;

/// The codes of rules stand with their checks in `lint`: the catalogue of `diag`, which knows no stage, has them from here.
fn codes_of_rules() -> impl Iterator<Item = &'static diag::Code> {
    lint::rules::RULES.iter().map(|rule| rule.code)
}

/// Where programs come from.
pub mod files {
    pub use crate::text::files::{FileError, Files, Folder, Memory, NoFiles, Opened, ReadAt, Request, Within};
}

/// What the user can say about a run: `partc.toml` as data.
pub mod settings {
    pub use crate::machine::config::{from_toml, read};
    pub use crate::machine::settings::*;
    pub use crate::machine::tree::ConfigError;
    pub use crate::machine::{schema, show, table, tools, tree};
}

/// What partc finds.
pub mod diagnostics {
    pub use crate::diag::codes::{self, Code};
    pub use crate::diag::finding::{Asked, Finding, Related, Site};
    pub use crate::diag::render::concise;
    pub use crate::diag::report::{Checked, Counts, Document, Kind};
    pub use crate::diag::{Answer, Diagnostic, Diags, Help, Severity, Trail, Values};
    pub use crate::facade::findings;
}

/// Where the output goes, and the targets that it is made for.
pub mod output {
    pub use crate::emit::{LineMap, Output};
    pub use crate::target::{ALL as TARGETS, Target};
}

/// What a program comes to: figures, pictures, and what two programs do differently.
pub mod results {
    pub use crate::compare::{Difference, Step, Steps, Stop, steps_of_text};
    #[cfg(feature = "cli")]
    pub use crate::emit::is_printed;
    pub use crate::emit::plot::{Form, Options, Plot, Side};
    pub use crate::emit::stats::{Model, Stats};
}

/// The moves of a program as record batches of Arrow.
#[cfg(feature = "arrow")]
pub mod table {
    pub use crate::columns::{COLUMNS, Column, Kind, Options, Take, Until, VERSION, VERSION_KEY, schema};
    #[cfg(feature = "cli")]
    pub use crate::columns::{Form, Table};
    pub use crate::emit::stats::Model;
}

/// The languages that partc reads.
pub mod languages {
    pub use crate::dialect::{ALL, Dialect, find, guess, read_as};
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// What tests, benches and fuzz targets of this repository look into. No promise holds for it.
#[doc(hidden)]
pub mod internals;
