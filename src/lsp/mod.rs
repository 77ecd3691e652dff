//! The language server: what editors show of a program while it is written.
//!
//! In: messages of the Language Server Protocol. Out: answers, and findings whenever a document changed. Everything is said
//! by the same engine as on the command line ([`study`]); nothing here knows a dialect but by its tables.

mod actions;
mod completion;
mod document;
pub mod frames;
mod hints;
mod hover;
mod names;
mod server;
mod study;
mod symbols;
#[cfg(test)]
mod tests;
mod text;
mod tokens;
mod words;

pub use document::{Setting, World};
pub use server::Server;
