//! The words of a target whose blocks are a dialog.

use crate::geo::Plane;

/// Words of a dialog.
#[derive(Debug)]
pub struct Dialog {
    /// First and last block; the name of the program and the unit stand behind.
    pub begin: &'static str,
    pub end: &'static str,
    /// Millimetres, inches.
    pub units: [&'static str; 2],
    /// What F1 is in a program in inches, in mm/min.
    pub inch_feed: f64,
    /// At rapid traverse, where a feed would stand; it holds for its own block.
    pub rapid: &'static str,
    /// The tool centre moves along the programmed path.
    pub uncompensated: &'static str,
    /// States the centre of the arcs behind it.
    pub center: &'static str,
    /// An arc to its end.
    pub arc: &'static str,
    pub helix: HelixWords,
    /// Calls a tool, or states the speed alone.
    pub tool: &'static str,
    /// The axis along which the tool is long.
    pub tool_axis: &'static str,
    /// Brings a tool forth.
    pub prepare: &'static str,
    /// The block in front of the one that waits.
    pub dwell: &'static str,
    /// The block in front of the one that says how far corners are rounded off.
    pub tolerance: &'static str,
    /// What stands in front of the number of a work offset and behind it, in lines of one block.
    pub offset: [&'static str; 2],
}

/// An arc that goes along its third axis, by the angle that it turns.
#[derive(Debug)]
pub struct HelixWords {
    pub word: &'static str,
    /// The angle from the start.
    pub angle: &'static str,
    /// In front of an axis: its way.
    pub way: &'static str,
    /// Places of the angle.
    pub places: u8,
    /// Turns of one block.
    pub most_turns: i64,
    /// Up to this radius in mm the last place of the angle moves the end by less than a thousandth.
    pub most_radius: f64,
    /// Working planes.
    pub planes: &'static [Plane],
}
