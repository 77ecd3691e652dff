//! The tool in the spindle, and how far its change got.

use crate::text::Loc;

/// The tool in the spindle; lengths in mm, `None` for unknown.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ActiveTool {
    /// Number to print.
    pub number: u32,
    /// Number in the control's own table, where it is known.
    pub own: Option<u32>,
    /// As called: the number without the index, or the name.
    pub called: String,
    pub radius: Option<f64>,
    /// What the tool table says where TOOL DEF gave another radius.
    pub other_radius: Option<f64>,
    pub length: Option<f64>,
    pub corner_radius: Option<f64>,
    /// At which it goes down into material at most, degrees.
    pub plunge_angle: Option<f64>,
    /// Cutting edges that follow each other in a turn.
    pub teeth: Option<u8>,
    /// Angle at the tip, degrees.
    pub tip_angle: Option<f64>,
    /// Oversizes of length, radius and corner radius from the table.
    pub table_deltas: [f64; 3],
    /// The same from TOOL CALL.
    pub call_deltas: [f64; 3],
}

impl ActiveTool {
    /// Radius with all oversizes.
    pub fn effective_radius(&self) -> Option<f64> {
        self.radius.map(|r| r + self.table_deltas[1] + self.call_deltas[1])
    }
}

/// How far a tool change got since the last block that cut.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Change {
    /// Complete, or none under way.
    #[default]
    None,
    /// An M6 stood in front of its TOOL CALL: the next TOOL CALL changes.
    Announced,
    /// The tool that was called is in the spindle already: an M6 changes nothing.
    InSpindle,
    /// Printed at the TOOL CALL; did the tool move since?
    Printed { moved: bool },
    /// Called and made ready; the M6 is still to come.
    Called {
        number: u32,
        /// TOOL CALL.
        from: Loc,
        /// Coordinate of the tool axis at the TOOL CALL, before it was forgotten.
        height: Option<f64>,
        /// The block under way holds the M6: wherever it goes, the change waits at its end.
        at_end: bool,
        /// Something moved since.
        moved: bool,
    },
    /// The change was missing where something cut, which was reported: an M6 now comes too late.
    Missed,
}
