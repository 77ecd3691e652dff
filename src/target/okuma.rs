//! Okuma mills (OSP): work offsets by G15, lengths by G56, waits by F. A preview: what published post processors write.

use super::{
    Arcs, Change, Dwell, DwellUnit, FeedWords, Flow, Frame, Length, LengthNumber, LengthWords, MFunctions, Motion,
    Numbers, PathWords, ProgramName, SpindleWords, Target, ToolWords, fanuc::TARGET as FANUC,
};

/// As [`FANUC`] but for words of two digits, offsets, lengths and waits.
pub(super) const TARGET: Target = Target {
    name: "okuma",
    about: "Okuma mills, OSP (preview: after published post processors)",
    extension: "min",
    frame: Frame {
        name: ProgramName::Text { front: "O", most: 4, marks: "" },
        mill: Some("G17 G40 G80"),
        ..FANUC.frame
    },
    numbers: Numbers { feed_point: false, zero: true, ..FANUC.numbers },
    motion: Motion { rapid: "G00", line: "G01", machine: None, rigid_tap: None, ..FANUC.motion },
    feed: FeedWords { per_revolution: None, ..FANUC.feed },
    arcs: Arcs { clockwise: "G02", counter_clockwise: "G03", mismatch: [0.02, 0.02], ..FANUC.arcs },
    spindle: SpindleWords {
        clockwise: "M03",
        counter_clockwise: "M04",
        stop: "M05",
        cutting_speed: None,
        ..FANUC.spindle
    },
    tool: ToolWords {
        change: Some(Change::Word("M06")),
        length: Length::Words(LengthWords {
            on: "G56",
            number: LengthNumber::Tool(b'H'),
            off: None,
            with_move: true,
            usual: true,
        }),
        ..FANUC.tool
    },
    dwell: Dwell { word: "G04", address: b'F', unit: DwellUnit::Seconds, per_minute: false, ..FANUC.dwell },
    flow: Flow { end: Some("M02"), ..FANUC.flow },
    offsets: &["G15 H1", "G15 H2", "G15 H3", "G15 H4", "G15 H5", "G15 H6", "G15 H7", "G15 H8", "G15 H9"],
    more_offsets: None,
    offsets_named: 0,
    m: MFunctions { own: &[], ..FANUC.m },
    // Not confirmed.
    path: PathWords::NONE,
    tilt: None,
    ..FANUC
};
