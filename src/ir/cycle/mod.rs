//! Cycles: one struct of resolved arguments per family, millimetres, degrees, radius values.
//!
//! A dialect fills the struct from its own parameters; `lower::cycles` makes moves of it.

pub mod recess;
pub mod roughing;
pub mod thread;
pub mod turning;

use crate::geo::Plane;

use super::Pos;

pub use recess::RecessTurning;
pub use roughing::Roughing;
pub use thread::Thread;

/// A machining cycle with all its arguments.
#[derive(Debug, Clone, PartialEq)]
pub enum Cycle {
    RecessTurning(RecessTurning),
    Roughing(Roughing),
    Thread(Thread),
}

impl Cycle {
    /// Where the tool stands afterwards, in the programmed frame, if the cycle starts in `at`.
    pub fn leaves(&self, at: &Pos) -> Pos {
        let mut end = *at;
        match self {
            Cycle::RecessTurning(recess) => recess.leaves(&mut end),
            Cycle::Roughing(roughing) => roughing.leaves(&mut end),
            Cycle::Thread(thread) => end.set_in_plane(Plane::Zx, thread.park),
        }
        end
    }
}
