//! The words of a target whose blocks are a dialog.

use crate::geo::Plane;

/// Words of a dialog, as they are printed, without the blanks around them.
#[derive(Debug)]
pub struct Dialog {
    /// First block; the name of the program and its unit follow.
    pub begin: &'static str,
    /// Last block, with the same after it.
    pub end: &'static str,
    /// The unit of a program: millimetres, inches.
    pub units: [&'static str; 2],
    /// What F1 is in a program in inches, in mm/min.
    pub inch_feed: f64,
    /// At rapid traverse, where a feed would stand; it holds for its own block.
    pub rapid: &'static str,
    /// The tool centre moves along the programmed path.
    pub uncompensated: &'static str,
    /// States the centre of the arcs behind it.
    pub center: &'static str,
    /// An arc about that centre to its end.
    pub arc: &'static str,
    /// An arc that goes along its third axis.
    pub helix: HelixWords,
    /// Calls a tool with its axis and speed, or states the speed alone.
    pub tool: &'static str,
    /// The axis along which the tool is long.
    pub tool_axis: &'static str,
    /// Brings the next tool forth.
    pub prepare: &'static str,
    /// The block before the one that waits.
    pub dwell: &'static str,
    /// The block before the one that says how far corners are rounded off.
    pub tolerance: &'static str,
    /// What stands in front of the number of a work offset and behind it, in lines of one block.
    pub offset: [&'static str; 2],
}

/// An arc that goes along its third axis, by the angle that it turns.
#[derive(Debug)]
pub struct HelixWords {
    /// Begins the block.
    pub word: &'static str,
    /// In front of the angle from the start, degrees, counter-clockwise positive.
    pub angle: &'static str,
    /// In front of the letter of an axis: its number is the travel in this block.
    pub way: &'static str,
    /// Places of the angle that are printed.
    pub places: u8,
    /// Most turns of one block.
    pub most_turns: i64,
    /// Up to this radius in mm the last place of the angle moves the end by less than a thousandth.
    pub most_radius: f64,
    /// Planes of the circle in which the target knows such an arc.
    pub planes: &'static [Plane],
}
