//! The targets: what they call things and what they cannot say. A target is a table.

mod linuxcnc;

use crate::geo::Plane;

/// What a target looks like.
#[derive(Debug)]
pub struct Traits {
    /// Name in `--target` and in the head of the output.
    pub name: &'static str,
    /// Extension of output files.
    pub extension: &'static str,
    /// First and last line of a program.
    pub frame: &'static str,
    /// Lines that state the modes at the start.
    pub head: &'static [&'static str],
    /// The last of these on a lathe, with X as a radius and as a diameter.
    pub lathe_head: [&'static str; 2],
    /// What stands around a comment.
    pub comment: (&'static str, &'static str),
    /// Longest line, end of line not counted.
    pub line_length: usize,
    /// Largest difference of the radii at start and end of a printed arc, in units of the last place.
    pub arc_tolerance: f64,
    /// Smallest radius of an arc, mm.
    pub least_radius: f64,
    /// Several turns in one block by a `P` word; otherwise one block a turn.
    pub turns_in_one_block: bool,
    /// M functions that the target knows by itself, and what they do there.
    pub own_m: &'static [(u32, &'static str)],
    /// Working planes in which the target compensates the tool radius.
    pub compensation_planes: &'static [Plane],
}

/// All targets.
pub const ALL: &[&Traits] = &[&linuxcnc::TRAITS];

/// The target of this name.
pub fn find(name: &str) -> Option<&'static Traits> {
    ALL.iter().copied().find(|traits| traits.name == name)
}
