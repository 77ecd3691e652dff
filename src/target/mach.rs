//! Mach3 and UCCNC mills: words of RS274 as published post processors write them, arcs in parts. Previews.

use core::f64::consts::PI;

use crate::geo::Plane;

use super::{
    Arcs, Comments, Dwell, DwellUnit, FeedWords, Frame, Length, LengthNumber, LengthWords, Line, Motion, Numbers,
    PathWords, ProgramName, SpindleWords, Target, ToolWords, fanuc::TARGET as FANUC,
};

/// As [`FANUC`] without its line around a program, machine coordinates and taps.
pub(super) const MACH3: Target = Target {
    name: "mach3",
    about: "Mach3 mills (preview: after published post processors)",
    frame: Frame {
        first: None,
        last: None,
        name: ProgramName::None,
        // Centres count as a setting says, unless the program does.
        head: &["G90 G21 G91.1 G94"],
        inch_head: Some(&["G90 G20 G91.1 G94"]),
        ..FANUC.frame
    },
    line: Line { digits: 0, ..FANUC.line },
    numbers: Numbers { zero: true, length: [4, 4], ..FANUC.numbers },
    motion: Motion { machine: None, rigid_tap: None, ..FANUC.motion },
    feed: FeedWords { per_revolution: None, ..FANUC.feed },
    // Its check of arcs.
    arcs: Arcs { mismatch: [0.002, 0.00508], ..FANUC.arcs },
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    tool: ToolWords {
        most: 256,
        length: Length::Words(LengthWords {
            on: "G43",
            number: LengthNumber::Tool(b'H'),
            off: Some("G49"),
            with_move: false,
            usual: true,
        }),
        ..FANUC.tool
    },
    // Wrong by a thousand on half of the machines, either way.
    dwell: Dwell { unit: DwellUnit::Setting, per_minute: false, ..FANUC.dwell },
    more_offsets: None,
    offsets_confirmed: false,
    // With which of the two a program starts is a setting.
    path: PathWords { starts_unbounded: false, ..FANUC.path },
    ..FANUC
};

/// As [`MACH3`], with arcs in the plane XY alone, in quarters.
pub(super) const UCCNC: Target = Target {
    name: "uccnc",
    about: "UCCNC mills (preview: after published post processors)",
    comments: Comments { upper: false, ..FANUC.comments },
    numbers: Numbers { point: false, feed_point: false, ..MACH3.numbers },
    // Post processors write quarters in XY.
    arcs: Arcs { planes: &[Plane::Xy], most_sweep: PI / 2.0, ..MACH3.arcs },
    dwell: Dwell { unit: DwellUnit::Milliseconds, per_minute: false, ..FANUC.dwell },
    // Post processors avoid it.
    compensation: None,
    ..MACH3
};
