//! GRBL 1.1. Single precision, one spindle, three axes; halves instead of full circles.

use super::{Arcs, Comments, Dwell, FeedWords, Flow, Frame, Line, MFunctions, Motion, Target, ToolWords, base::BASE};

/// For a mill of three axes, or a lathe without diameters.
pub(super) const TARGET: Target = Target {
    name: "grbl",
    about: "GRBL 1.1, as it is delivered",
    extension: "gcode",
    // A percent sign is an error.
    frame: Frame {
        head: &["G90 G21 G91.1 G94"],
        inch_head: Some(&["G90 G20 G91.1 G94"]),
        mill: Some("G17 G40 G49 G80"),
        lathe: Some("G18 G40 G49 G80"),
        ..BASE.frame
    },
    // The receiver acts on these three as they arrive, inside a comment, too.
    comments: Comments { forbidden: b"!?~", ..BASE.comments },
    line: Line { length: 79, digits: 8, ..BASE.line },
    motion: Motion { machine: Some("G53"), machine_feed: true, ..BASE.motion },
    feed: FeedWords { inverse_time: Some("G93"), ..BASE.feed },
    // Halves: rounding decides between nothing and a full circle where the end is the start.
    arcs: Arcs {
        // Beyond, single precision moves the centre by more than a printed place.
        most_radius: 1000.0,
        // What four roundings may move a point by, 4 m from the machine zero.
        least_chord: 0.002,
        ..BASE.arcs
    },
    tool: ToolWords { most: 255, change: None, ..BASE.tool },
    // The wait is counted in 16 bits of 50 ms.
    dwell: Dwell { most: 3000.0, ..BASE.dwell },
    flow: Flow { optional_stop_is_idle: true, ..BASE.flow },
    m: MFunctions { open: false, ..BASE.m },
    ..BASE
};
