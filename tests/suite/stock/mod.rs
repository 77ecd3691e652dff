//! Stock models: what the moves of a cycle cut out of a blank, judged by a geometry of its own.

pub mod milling;
mod pockets;
