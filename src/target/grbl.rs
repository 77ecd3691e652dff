//! GRBL 1.1. Single precision, one spindle, three axes; halves instead of full circles.

use core::f64::consts::PI;

use super::{
    Arcs, Comments, CoolantWords, Dwell, DwellUnit, EVERY_PLANE, FeedWords, Flow, Form, Frame, Length, Line,
    MFunctions, Measure, Motion, Numbers, ProgramName, Sequence, SpindleWords, Target, ToolWords,
};

pub(super) const TARGET: Target = Target {
    name: "grbl",
    about: "GRBL 1.1, as it is delivered",
    extension: "gcode",
    form: Form::Words,
    frame: Frame {
        // A percent sign is an error.
        first: None,
        last: None,
        name: ProgramName::None,
        head: &["G90 G21 G91.1 G94"],
        inch_head: &["G90 G20 G91.1 G94"],
        mill: Some("G17 G40 G49 G80"),
        lathe: Some("G18 G40 G49 G80"),
        lathe_diameter: None,
    },
    // The receiver acts on these three as they arrive, inside a comment, too.
    comments: Comments { open: "(", close: ")", upper: false, forbidden: b"!?~" },
    line: Line { length: 79, digits: 8, whole: 0, sequence: Sequence::Address(b'N', 99_999) },
    numbers: Numbers {
        point: false,
        feed_point: false,
        zero: true,
        length: [4, 5],
        most: 6,
        feed: None,
        feed_per_revolution: None,
        lead: None,
        speed: None,
    },
    axes: "XYZ",
    motion: Motion {
        rapid: "G0",
        line: "G1",
        machine: Some("G53"),
        machine_feed: true,
        machine_drops_length: false,
        thread: None,
        planes: Some(["G17", "G18", "G19"]),
    },
    feed: FeedWords {
        address: b'F',
        per_minute: "G94",
        per_revolution: None,
        inverse_time: Some("G93"),
        measure: Measure::Linear,
    },
    arcs: Arcs {
        clockwise: "G2",
        counter_clockwise: "G3",
        center: *b"IJK",
        planes: EVERY_PLANE,
        turns: None,
        // Rounding decides between nothing and a full circle where the end is the start.
        most_sweep: PI,
        most_open_sweep: f64::INFINITY,
        tolerance: 1.5,
        mismatch: [f64::INFINITY; 2],
        least_radius: 0.01,
        // Beyond, single precision moves the centre by more than a printed place.
        most_radius: 1000.0,
        // What four roundings may move a point by, 4 m from the machine zero.
        least_chord: 0.002,
    },
    spindle: SpindleWords {
        clockwise: "M3",
        counter_clockwise: "M4",
        stop: "M5",
        speed: b'S',
        cutting_speed: None,
        orient: None,
        other: None,
    },
    coolant: CoolantWords { mist: None, flood: "M8", off: "M9" },
    tool: ToolWords { address: b'T', most: 255, change: None, prepares: true, length: Length::None },
    // The wait is counted in 16 bits of 50 ms.
    dwell: Dwell { word: "G4", address: b'P', unit: DwellUnit::Seconds, most: 3000.0, per_minute: false },
    flow: Flow { stop: "M0", optional_stop: "M1", optional_stop_is_idle: true, end: "M2", rewind: "M30" },
    offsets: &["G54", "G55", "G56", "G57", "G58", "G59"],
    offsets_confirmed: true,
    compensation: None,
    m: MFunctions { address: b'M', own: &[], open: false },
};
