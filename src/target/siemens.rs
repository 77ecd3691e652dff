//! SINUMERIK without cycles: whole turns by `TURN=`, lengths by D, waits by F, comments behind a semicolon.

use core::f64::consts::PI;

use super::{
    Arcs, Change, Comments, CoolantWords, Dwell, DwellUnit, EVERY_PLANE, FeedWords, Flow, Form, Frame, Lead, Length,
    LengthNumber, LengthWords, Line, MFunctions, Measure, Motion, Numbers, ProgramName, Sequence, SpindleWords, Target,
    Thread, ToolWords, Turns,
};

pub(super) const TARGET: Target = Target {
    name: "sinumerik",
    about: "SINUMERIK 840D sl, 828D, ONE: plain moves, no cycles",
    // A program beside its source must not replace it.
    extension: "plain.mpf",
    form: Form::Words,
    frame: Frame {
        first: None,
        last: None,
        name: ProgramName::None,
        // G70 and G71 leave the feed in the unit of the machine.
        head: &["G90 G710 G40 G94"],
        inch_head: &["G90 G700 G40 G94"],
        mill: Some("G17 D0"),
        lathe: Some("G18 DIAMOF D0"),
        lathe_diameter: Some("G18 DIAMON D0"),
    },
    comments: Comments { open: "; ", close: "", upper: false, forbidden: b"" },
    line: Line { length: 80, digits: 0, whole: 0, sequence: Sequence::Address(b'N', 99_999) },
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
    // Which axes F counts is a matter of the machine (FGROUP).
    axes: "XYZ",
    motion: Motion {
        rapid: "G0",
        line: "G1",
        machine: Some("SUPA"),
        machine_feed: true,
        machine_drops_length: true,
        thread: Some(Thread { word: "G33", lead: Lead::AlongZ(b'K'), stops: false }),
        planes: Some(["G17", "G18", "G19"]),
    },
    feed: FeedWords {
        address: b'F',
        per_minute: "G94",
        per_revolution: Some("G95"),
        inverse_time: None,
        measure: Measure::Linear,
    },
    arcs: Arcs {
        clockwise: "G2",
        counter_clockwise: "G3",
        center: *b"IJK",
        planes: EVERY_PLANE,
        turns: Some(Turns::More("TURN=")),
        most_sweep: f64::INFINITY,
        most_open_sweep: PI * 2.0 / 3.0,
        tolerance: 1.5,
        mismatch: [f64::INFINITY; 2],
        least_radius: 0.01,
        most_radius: 100_000.0,
        // Below, rounding turns the centre by more than the control takes (alarm 14040).
        least_chord: 0.01,
    },
    spindle: SpindleWords {
        clockwise: "M3",
        counter_clockwise: "M4",
        stop: "M5",
        speed: b'S',
        // G96 would take the feed per revolution with it.
        cutting_speed: None,
        orient: None,
        other: None,
    },
    coolant: CoolantWords { mist: Some("M7"), flood: "M8", off: "M9" },
    tool: ToolWords {
        address: b'T',
        most: 32_000,
        change: Some(Change::Word("M6")),
        prepares: true,
        length: Length::Words(LengthWords {
            on: "D1",
            number: LengthNumber::None,
            off: Some("D0"),
            with_move: false,
            usual: true,
        }),
    },
    dwell: Dwell { word: "G4", address: b'F', unit: DwellUnit::Seconds, most: f64::INFINITY, per_minute: false },
    flow: Flow { stop: "M0", optional_stop: "M1", optional_stop_is_idle: false, end: "M2", rewind: "M30" },
    // G58 and G59 shift by what stands in their block.
    offsets: &["G54", "G55", "G56", "G57"],
    offsets_confirmed: true,
    compensation: None,
    m: MFunctions { address: b'M', own: OWN, open: true },
};

const OWN: &[(u32, &str)] = &[
    (17, "ends a subprogram"),
    (19, "stops the spindle at an angle"),
    (40, "chooses the gear by the speed"),
    (41, "chooses a gear"),
    (42, "chooses a gear"),
    (43, "chooses a gear"),
    (44, "chooses a gear"),
    (45, "chooses a gear"),
    (70, "makes an axis of the spindle"),
];
