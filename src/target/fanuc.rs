//! Fanuc mills (0i, 30i) and what reads as they do. A point in every number, one block for each half of a circle, dwells in
//! whole milliseconds, the tool length in a move along Z.

use core::f64::consts::PI;

use super::{
    Arcs, Change, Comments, CoolantWords, CuttingSpeed, Dwell, DwellUnit, EVERY_PLANE, FeedWords, Flow, Form, Frame,
    Length, LengthNumber, LengthWords, Limit, Line, MFunctions, Measure, Motion, Numbers, ProgramName, Sequence,
    SpindleWords, Target, ToolWords,
};

pub(super) const TARGET: Target = Target {
    name: "fanuc",
    about: "Fanuc mills (0i, 30i), and Mitsubishi, Brother and others that read them",
    extension: "tap",
    form: Form::Words,
    frame: Frame {
        first: Some("%"),
        last: Some("%"),
        name: ProgramName::Number { letter: b'O', digits: 4, most: 9999 },
        head: &["G90 G21 G94"],
        inch_head: &["G90 G20 G94"],
        mill: Some("G17 G40 G49 G80"),
        lathe: None,
        lathe_diameter: None,
    },
    comments: Comments { open: "(", close: ")", upper: true, forbidden: b"" },
    line: Line { length: 80, digits: 8, whole: 0, sequence: Sequence::Address(b'N', 99_999) },
    numbers: Numbers {
        // Without it a number may count thousandths, by a parameter.
        point: true,
        feed_point: true,
        zero: false,
        length: [3, 4],
        most: 6,
        feed: Some([2, 3]),
        feed_per_revolution: Some([3, 4]),
        lead: Some([4, 6]),
        speed: Some(0),
    },
    // What F counts for rotary axes is a matter of parameters.
    axes: "XYZ",
    motion: Motion {
        rapid: "G0",
        line: "G1",
        machine: Some("G53"),
        machine_feed: false,
        machine_drops_length: false,
        // A mill taps with G84; whether G33 is there is an option of the machine.
        thread: None,
        planes: Some(["G17", "G18", "G19"]),
    },
    feed: FeedWords {
        address: b'F',
        per_minute: "G94",
        per_revolution: Some("G95"),
        // An option of the machine.
        inverse_time: None,
        measure: Measure::Linear,
    },
    arcs: Arcs {
        clockwise: "G2",
        counter_clockwise: "G3",
        center: *b"IJK",
        planes: EVERY_PLANE,
        turns: None,
        most_sweep: PI,
        most_open_sweep: f64::INFINITY,
        tolerance: 1.5,
        mismatch: [f64::INFINITY; 2],
        least_radius: 0.01,
        // Eight digits.
        most_radius: 50_000.0,
        least_chord: 0.0,
    },
    spindle: SpindleWords {
        clockwise: "M3",
        counter_clockwise: "M4",
        stop: "M5",
        speed: b'S',
        cutting_speed: Some(CuttingSpeed { on: "G96", off: "G97", limit: Limit::Block("G92") }),
        orient: None,
        other: None,
    },
    // M7 is the machine builder's.
    coolant: CoolantWords { mist: None, flood: "M8", off: "M9" },
    tool: ToolWords {
        address: b'T',
        most: 99_999_999,
        change: Some(Change::Word("M6")),
        prepares: true,
        length: Length::Words(LengthWords {
            on: "G43",
            number: LengthNumber::Tool(b'H'),
            off: Some("G49"),
            with_move: true,
            usual: true,
        }),
    },
    dwell: Dwell { word: "G4", address: b'P', unit: DwellUnit::Milliseconds, most: 99_999.999, per_minute: true },
    flow: Flow { stop: "M0", optional_stop: "M1", optional_stop_is_idle: false, end: "M2", rewind: "M30" },
    offsets: &["G54", "G55", "G56", "G57", "G58", "G59"],
    offsets_confirmed: true,
    compensation: None,
    m: MFunctions { address: b'M', own: OWN, open: true },
};

pub(super) const OWN: &[(u32, &str)] = &[
    (29, "begins tapping in step with the spindle"),
    (96, "begins or ends an interruption by a macro"),
    (97, "begins or ends an interruption by a macro"),
    (98, "calls a subprogram"),
    (99, "returns, or starts the program again"),
    (198, "calls a subprogram from outside"),
];
