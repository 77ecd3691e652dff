//! HEIDENHAIN Klartext for an iTNC 530 and its successors: lines, arcs around CC, helices by CP, tools by TOOL CALL. Cycles
//! for waits and presets alone.

use core::f64::consts::{PI, TAU};

use crate::geo::Plane;

use super::{
    Arcs, Change, Comments, Dialog, Dwell, FeedWords, Flow, Form, Frame, HelixWords, Length, Line, MFunctions, Motion,
    Numbers, PathBound, PathWords, PlaneWords, ProgramName, RigidTap, Sequence, TapDialog, Target, TiltWords,
    ToolWords, base::BASE,
};

// What F counts where a rotary axis goes along is not confirmed, and what M136 counts differs by generation: neither is said.
// A feed per revolution is said by FU.
/// A dialog: blocks begin with what they do.
pub(super) const TARGET: Target = Target {
    name: "heidenhain",
    about: "HEIDENHAIN Klartext (iTNC 530, TNC 320 to 640, TNC7): plain moves",
    // A program beside its source must not replace it.
    extension: "plain.h",
    form: Form::Dialog(&Dialog {
        begin: "BEGIN PGM",
        end: "END PGM",
        units: ["MM", "INCH"],
        inch_feed: 2.54,
        rapid: "FMAX",
        uncompensated: "R0",
        center: "CC",
        arc: "C",
        helix: HelixWords {
            word: "CP",
            angle: "IPA",
            way: "I",
            places: 4,
            // Older controls turn 5400 degrees in a block.
            most_turns: 15,
            most_radius: 1000.0,
            planes: &[Plane::Xy],
        },
        tool: "TOOL CALL",
        tool_axis: "Z",
        prepare: "TOOL DEF",
        dwell: "CYCL DEF 9.0 DWELL TIME",
        tolerance: "CYCL DEF 32.0 TOLERANCE",
        offset: ["CYCL DEF 247 DATUM SETTING ~", ";DATUM NUMBER"],
    }),
    frame: Frame {
        name: ProgramName::Text { front: "", most: 16, marks: "_-" },
        // Positions are absolute where no I stands in front of them, and what is selected anew compensates nothing.
        inch_head: Some(&[]),
        mill: Some(""),
        ..BASE.frame
    },
    // At the end of a line, the comment would go on in the next one.
    comments: Comments { open: "; ", close: "", forbidden: b"~", ..BASE.comments },
    line: Line { digits: 9, whole: 5, sequence: Sequence::Blocks, ..BASE.line },
    numbers: Numbers {
        length: [4, 4],
        most: 4,
        feed: Some([3, 3]),
        feed_per_revolution: Some([3, 3]),
        speed: Some(3),
        time: Some(3),
        ..BASE.numbers
    },
    motion: Motion {
        rapid: "L",
        line: "L",
        machine: Some("M91"),
        machine_feed: true,
        planes: None,
        rigid_tap: Some(RigidTap::Dialog(&TAP)),
        ..BASE.motion
    },
    feed: FeedWords { per_minute: "F", per_revolution: Some("FU"), ..BASE.feed },
    arcs: Arcs {
        clockwise: "DR-",
        counter_clockwise: "DR+",
        center: *b"XYZ",
        most_sweep: TAU,
        // The control moves a centre that does not quite fit, and far where start and end lie close together.
        most_open_sweep: PI * 1.5,
        mismatch: [0.016, 0.016],
        // Nine digits.
        most_radius: 50_000.0,
        // Where both nearly meet, rounding within the control would decide between nothing and a full circle.
        least_chord: 0.001,
        ..BASE.arcs
    },
    tool: ToolWords { most: 32_767, change: Some(Change::Call), length: Length::WithTool, ..BASE.tool },
    dwell: Dwell { word: "CYCL DEF 9.1 DWELL", address: b' ', most: 3600.0, ..BASE.dwell },
    // M0 would stop the spindle, too.
    flow: Flow { stop: "STOP", ..BASE.flow },
    offsets: &["Q339=+1", "Q339=+2", "Q339=+3", "Q339=+4", "Q339=+5", "Q339=+6", "Q339=+7", "Q339=+8", "Q339=+9"],
    // M134 stops at rotary axes alone, and what a cycle 32 without T rounds by is a setting.
    path: PathWords { within: Some(PathBound { word: "CYCL DEF 32.1", length: "T" }), ..PathWords::NONE },
    tilt: Some(TiltWords::Dialog(&PLANE)),
    m: MFunctions { own: OWN, ..BASE.m },
    ..BASE
};

const TAP: TapDialog = TapDialog {
    plain: "CYCL DEF 207 RIGID TAPPING",
    stepped: "CYCL DEF 209 TAPPING W/ CHIP BRKG",
    call: "CYCL CALL",
    parameters: [
        ("Q200", "SET-UP CLEARANCE"),
        ("Q201", "DEPTH OF THREAD"),
        ("Q239", "THREAD PITCH"),
        ("Q203", "SURFACE COORDINATE"),
        ("Q204", "2ND SET-UP CLEARANCE"),
        ("Q257", "DEPTH FOR CHIP BRKNG"),
        ("Q256", "DIST FOR CHIP BRKNG"),
        ("Q336", "ANGLE OF SPINDLE"),
        ("Q403", "RPM FACTOR"),
    ],
    of_plain: 5,
    places: 4,
};

const PLANE: PlaneWords = PlaneWords {
    shift: "CYCL DEF 7.0 DATUM SHIFT",
    shift_axes: ["CYCL DEF 7.1 X", "CYCL DEF 7.2 Y", "CYCL DEF 7.3 Z"],
    on: "PLANE SPATIAL",
    angles: ["SPA", "SPB", "SPC"],
    turn: "TURN FMAX",
    primary: ["SEQ+", "SEQ-"],
    free: "COORD ROT",
    off: "PLANE RESET STAY",
    back: "PLANE RESET TURN FMAX",
};

const OWN: &[(u32, &str)] = &[
    (0, "stops the spindle and the coolant, too"),
    (6, "changes the tool and may stop the program"),
    (13, "starts the spindle and the coolant"),
    (14, "starts the spindle and the coolant"),
    (89, "may call a cycle in every block after it"),
    (90, "goes round corners at constant speed"),
    (91, "counts its block from the machine datum"),
    (92, "counts its block from a place of the machine builder"),
    (94, "counts rotary axes anew"),
    (97, "changes corners of a compensated contour"),
    (98, "opens corners of a compensated contour"),
    (99, "calls a cycle"),
    (101, "changes worn tools by itself"),
    (102, "ends the change of worn tools"),
    (103, "slows plunges down"),
    (104, "takes the last datum again"),
    (105, "switches the gain of the axes"),
    (106, "switches the gain of the axes"),
    (107, "lets replacement tools be larger"),
    (108, "lets replacement tools be no larger"),
    (109, "counts the feed of arcs at the cutting edge"),
    (110, "counts the feed of arcs at the cutting edge"),
    (111, "counts the feed of arcs at the tool centre"),
    (112, "rounds corners"),
    (113, "rounds no corners"),
    (114, "compensates tilted axes"),
    (115, "ends the compensation of tilted axes"),
    (116, "counts the feed of rotary axes in mm"),
    (117, "counts the feed of rotary axes in degrees"),
    (118, "lets the handwheel move axes"),
    (120, "looks ahead under compensation"),
    (124, "leaves points out"),
    (126, "turns rotary axes the shorter way"),
    (127, "turns rotary axes as programmed"),
    (128, "keeps the tool tip in its place"),
    (129, "ends M128"),
    (130, "leaves a tilted plane for its block"),
    (134, "stops exactly at rotary axes"),
    (135, "ends M134"),
    (136, "counts the feed by the turn"),
    (137, "counts the feed by the minute"),
    (138, "chooses tilting axes"),
    (140, "retracts along the tool"),
    (141, "watches no probe"),
    (142, "deletes modal data"),
    (143, "deletes a basic rotation"),
    (144, "counts the kinematics"),
    (145, "ends M144"),
    (148, "lifts the tool off at a stop"),
    (149, "ends M148"),
    (150, "keeps a limit switch silent"),
    (197, "prolongs corners of a compensated contour"),
    (200, "controls a laser"),
    (201, "controls a laser"),
    (202, "controls a laser"),
    (203, "controls a laser"),
    (204, "controls a laser"),
];
