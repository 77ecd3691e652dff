//! Firmware of printers that carry a spindle: Klipper and Marlin. A line is one command and its parameters, rapid traverse goes
//! at the last F, and what is no move is a macro or an option of the build. Previews, after the source of both.

use crate::geo::Plane;

use super::{
    Arcs, Comments, Dwell, DwellUnit, FeedWords, Flow, Frame, Line, MFunctions, Motion, Sequence, SpindleWords, Target,
    ToolWords, base::BASE, grbl::TARGET as GRBL,
};

/// Made of [`BASE`], with the arcs and comments of [`GRBL`]; no work offsets, no tool change.
pub(super) const KLIPPER: Target = Target {
    name: "klipper",
    about: "Klipper with gcode_arcs (preview: after its source)",
    extension: "gcode",
    frame: Frame { head: &["G90", "G21"], mill: Some("G17"), ..BASE.frame },
    comments: Comments { open: "; ", close: "", ..GRBL.comments },
    // Behind N, Marlin wants a checksum.
    line: Line { digits: 8, sequence: Sequence::None, ..BASE.line },
    motion: Motion { rapid_at_feed: true, ..BASE.motion },
    feed: FeedWords { per_minute: "F", ..BASE.feed },
    // Klipper goes round mirrored in G18. Halves: where an offset was set, rounding decides between nothing and a full circle.
    arcs: Arcs { planes: &[Plane::Xy], ..GRBL.arcs },
    spindle: SpindleWords { speed_with_start: true, ..BASE.spindle },
    // T chooses an extruder.
    tool: ToolWords { change: None, prepares: false, ..BASE.tool },
    dwell: Dwell { unit: DwellUnit::Milliseconds, most: 99_999.999, ..BASE.dwell },
    flow: Flow { end: None, rewind: None, ..BASE.flow },
    offsets: &[],
    m: MFunctions { own: OWN, listed: true, ..BASE.m },
    ..BASE
};

/// As [`KLIPPER`], without helices.
pub(super) const MARLIN: Target = Target {
    name: "marlin",
    about: "Marlin 2 with ARC_SUPPORT (preview: after its source)",
    // Builds that level the bed by a mesh drop the third axis of an arc.
    arcs: Arcs { helices: false, ..KLIPPER.arcs },
    ..KLIPPER
};

const OWN: &[(u32, &str)] = &[
    (6, "changes nothing"),
    (18, "switches the motors off"),
    (23, "selects a file"),
    (24, "prints a file"),
    (30, "deletes a file"),
    (82, "counts the extruder"),
    (83, "counts the extruder"),
    (84, "switches the motors off"),
    (104, "heats"),
    (109, "heats and waits"),
    (112, "stops everything"),
    (140, "heats"),
    (190, "heats and waits"),
    (203, "sets limits of the machine"),
    (204, "sets limits of the machine"),
    (206, "shifts positions"),
    (220, "scales all feeds"),
    (410, "stops everything"),
    (428, "shifts positions"),
    (500, "saves settings"),
    (502, "resets settings"),
];
