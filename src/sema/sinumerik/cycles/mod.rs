//! Machining cycles of the control: rows, and plans that make the arguments of `ir::cycle` of a call.
//!
//! A plan reports nothing and changes nothing; the file that calls them does both. Source: C 5 and 6 (docs/sources.md).

mod call;
mod contour_pocket;
mod contour_removal;
mod corner_removal;
mod cut_off;
mod drilling;
mod drilling_zones;
mod faces;
mod groove_shape;
mod grooves;
mod layers;
mod milling;
mod modes;
mod names;
mod path_milling;
mod pattern;
mod pockets;
mod spigots;
mod table;
mod thread;
mod thread_milling;
mod undercut;
mod undercut_call;

pub(super) use call::{Act, Acts, CycleCall, SpindleTold};
pub(super) use drilling::plane_across;
pub(super) use drilling_zones::has_zones;
pub(super) use names::{KNAME, LAB1, LAB2, NPP, TYPE};
pub use table::signatures;
pub(super) use table::{Cycle, Need, Source, Work, find, instead, rows};

/// Is this the name of a cycle that is not refused where it stands? The next one takes what some of them say.
pub(super) fn is_taken(name: &str) -> bool {
    find(name).is_some_and(|cycle| cycle.is_built() || matches!(cycle.work, Work::NamesContour))
}

/// Is this the name of a cycle of the control? Those are programs, the last ones of its search path: one of the user or of the machine
/// builder goes before.
pub(super) fn is_program(name: &str) -> bool {
    find(name).is_some() || name.starts_with("CYCLE")
}

/// Is this the name of a measuring cycle?
pub(super) fn measures(name: &str) -> bool {
    find(name).is_some_and(Cycle::measures)
}

/// Is this the name of a cycle that is compiled?
pub(super) fn is_built(name: &str) -> bool {
    find(name).is_some_and(Cycle::is_built)
}
