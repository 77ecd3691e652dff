//! Fanuc mills (0i, 30i) and what reads as they do. A point in every number, one block for each half of a circle, dwells in
//! whole milliseconds, the tool length in a move along Z.

use crate::geo::Plane;

use super::{
    Arcs, Comments, CompensationWords, CuttingSpeed, Dwell, DwellUnit, EulerWords, FeedWords, Frame, Length,
    LengthNumber, LengthWords, Limit, Line, MFunctions, MoreOffsets, Motion, Numbers, PathWords, ProgramName, RigidTap,
    SpindleWords, TapCycle, TapPitch, Target, TiltWords, ToolWords, base::BASE,
};

// Rotary axes (what F counts is a matter of parameters), feeds by time and G33 on a mill are options of the machine, M7 is
// its builder's: none of them is printed.
/// For mills; lathes have tables of their own.
pub(super) const TARGET: Target = Target {
    name: "fanuc",
    about: "Fanuc mills (0i, 30i), and Mitsubishi, Brother and others that read them",
    frame: Frame {
        first: Some("%"),
        last: Some("%"),
        name: ProgramName::Number { letter: b'O', digits: 4, most: 9999 },
        head: &["G90 G21 G94"],
        inch_head: Some(&["G90 G20 G94"]),
        mill: Some("G17 G40 G49 G80"),
        ..BASE.frame
    },
    comments: Comments { upper: true, ..BASE.comments },
    line: Line { digits: 8, ..BASE.line },
    numbers: Numbers {
        // Without it a number may count thousandths, by a parameter.
        point: true,
        feed_point: true,
        zero: false,
        length: [3, 4],
        feed: Some([2, 3]),
        feed_per_revolution: Some([3, 4]),
        lead: Some([4, 6]),
        speed: Some(0),
        ..BASE.numbers
    },
    motion: Motion { machine: Some("G53"), rigid_tap: Some(RigidTap::Cycle(TAP)), ..BASE.motion },
    feed: FeedWords { per_revolution: Some("G95"), ..BASE.feed },
    // Eight digits.
    arcs: Arcs { most_radius: 50_000.0, ..BASE.arcs },
    spindle: SpindleWords {
        cutting_speed: Some(CuttingSpeed { on: "G96", off: "G97", limit: Limit::Block("G92") }),
        ..BASE.spindle
    },
    tool: ToolWords {
        most: 99_999_999,
        most_offset: Some(99),
        length: Length::Words(LengthWords {
            on: "G43",
            number: LengthNumber::Tool(b'H'),
            off: Some("G49"),
            with_move: true,
            usual: true,
        }),
        ..BASE.tool
    },
    dwell: Dwell { unit: DwellUnit::Milliseconds, most: 99_999.999, per_minute: true, ..BASE.dwell },
    // Where they are no option of the machine, the control knows nothing of G54.1 and stops.
    offsets: BASE.offsets,
    more_offsets: Some(MoreOffsets { word: "G54.1 P", less: 6, most: 54 }),
    offsets_named: 6,
    compensation: Some(CompensationWords {
        left: "G41",
        right: "G42",
        by_diameter: None,
        edge: None,
        off: "G40",
        tool: Some(b'D'),
        with_move: true,
        reads_over_stops: false,
        planes: &[Plane::Xy],
    }),
    // G64 is the cutting mode, in which corners are passed as acceleration has it. Stops in every corner would change what a
    // program does today.
    path: PathWords { exact: Some("G61"), unbounded: Some("G64"), starts_unbounded: true, ..PathWords::NONE },
    // An option of the 30i.
    tilt: Some(TiltWords::Euler(&EULER)),
    m: MFunctions { own: OWN, ..BASE.m },
    ..BASE
};

// In steps (Q) it taps by parameters that nobody knows here: partc prints each step as a tap of its own. In one mode the axis stays in
// step with the spindle, and parameter 5202 (bit 0) stops the spindle at its mark where the mode begins; that holds for the first step.
/// The tapping cycle; other makes differ in single words.
pub(super) const TAP: TapCycle = TapCycle {
    ready: Some("M29"),
    right: "G84",
    left: Some("G74"),
    level: Some("G99"),
    off: "G80",
    begins: b'R',
    from_start: false,
    pitch: TapPitch::Either,
    dwell: Some(b'P'),
    factor: None,
    stays: true,
    meets: "rigid tapping stays on between them, and the control has to keep the angle meanwhile or to begin each at the mark \
            of the spindle (parameter 5202)",
};

/// A tilted plane; which angles follow need not be said.
pub(super) const EULER: EulerWords = EulerWords { on: "G68.2", mode: None, angles: *b"IJK", turn: "G53.1", off: "G69" };

/// M functions that the control knows by itself, and what they do there.
pub(super) const OWN: &[(u32, &str)] = &[
    (29, "begins tapping in step with the spindle"),
    (96, "begins or ends an interruption by a macro"),
    (97, "begins or ends an interruption by a macro"),
    (98, "calls a subprogram"),
    (99, "returns, or starts the program again"),
    (198, "calls a subprogram from outside"),
];
