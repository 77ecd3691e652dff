//! Cycles: one struct of resolved arguments per family, millimetres, degrees, radius values.
//!
//! A dialect fills the struct from its own parameters; `lower::cycles` makes moves of it.

use super::Pos;

/// A machining cycle with all its arguments.
#[derive(Debug, Clone, PartialEq)]
pub enum Cycle {}

impl Cycle {
    /// Where the tool stands afterwards, in the programmed frame, if the cycle starts in `at`.
    pub fn leaves(&self, _at: &Pos) -> Pos {
        match *self {}
    }
}
