//! The targets: how each receiver says things, and what it cannot say. A target is one table of words.
//!
//! Nothing here runs: `emit` prints with the table, `machine` and the command line offer the names.

mod abilities;
mod base;
mod centroid;
mod dialog_words;
mod fanuc;
mod fanuc_lathe;
mod function_words;
mod grbl;
mod grblhal;
mod haas;
mod heidenhain;
mod linuxcnc;
mod mach;
mod mazak;
mod move_words;
mod okuma;
mod printers;
mod siemens;
mod tap_words;
mod tilt_words;
mod words;

pub use dialog_words::*;
pub use function_words::*;
pub use move_words::*;
pub use tap_words::*;
pub use tilt_words::*;
pub use words::*;

/// All targets; the first one is the default.
pub const ALL: &[&Target] = &[
    &linuxcnc::TARGET,
    &grbl::TARGET,
    &grblhal::TARGET,
    &fanuc::TARGET,
    &haas::TARGET,
    &fanuc_lathe::A,
    &fanuc_lathe::B,
    &fanuc_lathe::C,
    &siemens::TARGET,
    &heidenhain::TARGET,
    &centroid::TARGET,
    &mazak::TARGET,
    &mach::MACH3,
    &mach::UCCNC,
    &okuma::TARGET,
    &printers::KLIPPER,
    &printers::MARLIN,
];

/// Their names, in the same order.
pub const NAMES: [&str; ALL.len()] = {
    let mut names = [""; ALL.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = ALL[i].name;
        i += 1;
    }
    names
};

/// The target of this name.
pub fn find(name: &str) -> Option<&'static Target> {
    ALL.iter().copied().find(|target| target.name == name)
}
