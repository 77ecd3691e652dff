//! partc compiles CNC part programs written in control dialects into plain, fully resolved G-code.
//!
//! The library opens no file by itself: programs come through [`text::Files`], output goes to
//! [`emit::Output`]. A run is a [`driver::Session`]; what it found is in its `diags`, and with an error
//! among them its output must not be used.

#![forbid(unsafe_code)]

#[cfg(feature = "cli")]
pub mod cli;
pub mod diag;
pub mod dialect;
pub mod driver;
pub mod emit;
pub mod facade;
pub mod geo;
pub mod ir;
pub mod lexer;
pub mod lower;
pub mod machine;
pub mod parser;
pub mod sema;
pub mod standard;
pub mod target;
pub mod text;
