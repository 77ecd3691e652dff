//! Cycles: one struct of resolved arguments per family, millimetres, degrees, radius values.
//!
//! A dialect fills the struct from its own parameters; `lower::cycles` makes moves of it.

pub mod drilling;
pub mod finishing;
pub mod recess;
pub mod roughing;
pub mod thread;
pub mod turning;
pub mod undercut;

use crate::geo::Plane;

use super::Pos;

pub use drilling::Drilling;
pub use finishing::Finishing;
pub use recess::RecessTurning;
pub use roughing::Roughing;
pub use thread::Thread;
pub use undercut::UndercutCycle;

/// A machining cycle with all its arguments.
#[derive(Debug, Clone, PartialEq)]
pub enum Cycle {
    Finishing(Finishing),
    RecessTurning(RecessTurning),
    Roughing(Roughing),
    Thread(Thread),
    Drilling(Drilling),
    /// Ends where it starts.
    Undercut(UndercutCycle),
}

impl Cycle {
    /// Where the tool stands afterwards, in the programmed frame, if the cycle starts in `at`.
    pub fn leaves(&self, at: &Pos) -> Pos {
        let mut end = *at;
        match self {
            Cycle::Finishing(finishing) => finishing.leaves(&mut end),
            Cycle::RecessTurning(recess) => recess.leaves(&mut end),
            Cycle::Roughing(roughing) => roughing.leaves(&mut end),
            Cycle::Thread(thread) => end.set_in_plane(Plane::Zx, thread.park),
            // A hole without depth moves nothing.
            Cycle::Drilling(hole) if hole.levels.outward() == 0.0 => {}
            Cycle::Drilling(hole) => end.set(hole.axis, hole.levels.retract),
            Cycle::Undercut(_) => {}
        }
        end
    }
}
