//! Cycles: one struct of resolved arguments per family, millimetres, degrees, radius values.
//!
//! A dialect fills the struct from its own parameters; `lower::cycles` makes moves of it.

pub mod bore_milling;
pub mod cut_off;
pub mod drilling;
pub mod facing;
pub mod finishing;
pub mod grooving;
pub mod layers;
pub mod long_hole;
pub mod milling;
pub mod path_milling;
pub mod pilot_holes;
pub mod pocket;
pub mod recess;
pub mod region;
pub mod roughing;
pub mod ruled;
pub mod spigot;
mod stock_corner;
pub mod thread;
pub mod thread_milling;
pub mod turning;
pub mod undercut;

use core::fmt;

use crate::geo::{Element, Vec2};

use super::Pos;
use super::function::Spindle;

pub use bore_milling::BoreMilling;
pub use cut_off::CutOff;
pub use drilling::Drilling;
pub use facing::Facing;
pub use finishing::Finishing;
pub use grooving::Grooving;
pub use layers::Layers;
pub use long_hole::LongHole;
pub use path_milling::PathMilling;
pub use pilot_holes::PilotHoles;
pub use pocket::Pocket;
pub use recess::RecessTurning;
pub use region::Region;
pub use ruled::Ruled;
pub use spigot::Spigot;
pub use thread::Thread;
pub use thread_milling::ThreadMilling;
use turning::Towards;
pub use undercut::UndercutCycle;

/// What the resolved arguments of all cycles can say. Numbers are in mm, degrees and seconds, in the programmed frame.
///
/// A dialect may send arguments that make no cycle: `lower::cycles` calls [`Family::check`] before the first move and
/// reports the fault. After that call the rules of `check` hold.
pub trait Family {
    /// Why arguments make no cycle.
    type Fault: fmt::Display;

    /// The first fault of the arguments.
    ///
    /// # Errors
    /// See the fault of the family.
    fn check(&self) -> Result<(), Self::Fault>;

    /// Moves `at`, where the cycle starts, to where it leaves the tool, in the programmed frame.
    fn leaves(&self, at: &mut Pos);

    /// What the spindle does after the cycle; `None` where the cycle leaves it as it is.
    fn spindle_after(&self) -> Option<Spindle> {
        None
    }

    /// About how many moves it makes, so that one call cannot ask for very many; 0 for a cycle of few moves.
    fn moves(&self) -> f64 {
        0.0
    }

    /// Is it run again and again, at many places, so that one refusal stands for all?
    fn repeats(&self) -> bool {
        false
    }
}

/// Hands the list of all families, variant and arguments, to a macro: the only place that names them all.
macro_rules! families {
    ($take:ident) => {
        $take! {
            Finishing(crate::ir::cycle::Finishing),
            Grooving(crate::ir::cycle::Grooving),
            CutOff(crate::ir::cycle::CutOff),
            RecessTurning(crate::ir::cycle::RecessTurning),
            Layers(crate::ir::cycle::Layers),
            Thread(crate::ir::cycle::Thread),
            Drilling(crate::ir::cycle::Drilling),
            Undercut(crate::ir::cycle::UndercutCycle),
            Pocket(crate::ir::cycle::Pocket),
            LongHole(crate::ir::cycle::LongHole),
            Region(crate::ir::cycle::Region),
            PilotHoles(crate::ir::cycle::PilotHoles),
            Facing(crate::ir::cycle::Facing),
            Ruled(crate::ir::cycle::Ruled),
            Spigot(crate::ir::cycle::Spigot),
            PathMilling(crate::ir::cycle::PathMilling),
            ThreadMilling(crate::ir::cycle::ThreadMilling),
            BoreMilling(crate::ir::cycle::BoreMilling),
        }
    };
}
pub(crate) use families;

macro_rules! cycle {
    ($($family:ident($arguments:ty),)*) => {
        /// A machining cycle with all its arguments.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Cycle {
            $($family($arguments),)*
        }

        impl Cycle {
            /// Where the tool stands afterwards, in the programmed frame, if the cycle starts in `at`.
            pub fn leaves(&self, at: &Pos) -> Pos {
                let mut end = *at;
                match self {
                    $(Cycle::$family(cycle) => cycle.leaves(&mut end),)*
                }
                end
            }

            /// See [`Family::spindle_after`].
            pub fn spindle_after(&self) -> Option<Spindle> {
                match self {
                    $(Cycle::$family(cycle) => cycle.spindle_after(),)*
                }
            }

            /// See [`Family::moves`].
            pub fn moves(&self) -> f64 {
                match self {
                    $(Cycle::$family(cycle) => cycle.moves(),)*
                }
            }

            /// See [`Family::repeats`].
            pub fn repeats(&self) -> bool {
                match self {
                    $(Cycle::$family(cycle) => cycle.repeats(),)*
                }
            }
        }
    };
}
families!(cycle);

impl Cycle {
    /// The finished contour of a turned part that it works down to, and from where.
    pub fn finished(&self) -> Option<(&[Element], Towards)> {
        match self {
            Cycle::Finishing(cycle) if cycle.oversize == 0.0 && cycle.shift == Vec2::zeros() => {
                Some((&cycle.contour, cycle.cut_from()?))
            }
            Cycle::Layers(cycle) => Some((&cycle.contour, cycle.into)),
            Cycle::RecessTurning(cycle) => Some((&cycle.contour, cycle.into)),
            Cycle::Grooving(cycle) if cycle.copies == grooving::Copies::ONE => Some((&cycle.contour, cycle.into)),
            Cycle::Finishing(_)
            | Cycle::Grooving(_)
            | Cycle::CutOff(_)
            | Cycle::Thread(_)
            | Cycle::Drilling(_)
            | Cycle::Undercut(_)
            | Cycle::Pocket(_)
            | Cycle::LongHole(_)
            | Cycle::Region(_)
            | Cycle::PilotHoles(_)
            | Cycle::Facing(_)
            | Cycle::Ruled(_)
            | Cycle::Spigot(_)
            | Cycle::PathMilling(_)
            | Cycle::ThreadMilling(_)
            | Cycle::BoreMilling(_) => None,
        }
    }
}
