//! The functions that the targets call.

pub mod targets;
