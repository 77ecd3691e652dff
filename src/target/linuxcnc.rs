//! LinuxCNC (RS274/NGC). Arcs by offset from the start, whole turns by `P`, comments in brackets.

use crate::geo::Plane;

use super::{
    Arcs, CompensationWords, CoolantWords, CuttingSpeed, EdgeWords, FeedWords, Frame, Lead, Length, LengthNumber,
    LengthWords, Limit, MFunctions, Motion, PathBound, PathWords, RigidTap, SpindleWords, Target, Thread, ToolWords,
    Turns, base::BASE,
};

/// For mills and lathes, nine axes. The default.
pub(super) const TARGET: Target = Target {
    name: "linuxcnc",
    about: "LinuxCNC (RS274/NGC)",
    extension: "ngc",
    frame: Frame {
        first: Some("%"),
        last: Some("%"),
        head: &["G90 G21 G91.1 G94"],
        inch_head: Some(&["G90 G20 G91.1 G94"]),
        mill: Some("G17 G40 G49 G80"),
        lathe: Some("G18 G8 G40 G49 G80"),
        lathe_diameter: Some("G18 G7 G40 G49 G80"),
        ..BASE.frame
    },
    axes: "XYZABCUVW",
    motion: Motion {
        machine: Some("G53"),
        machine_feed: true,
        thread: Some(Thread { word: "G33", lead: Lead::Way(b'K'), stops: true }),
        rigid_tap: Some(RigidTap::Return { word: "G33.1", lead: b'K', factor: b'I' }),
        ..BASE.motion
    },
    feed: FeedWords { per_revolution: Some("G95"), inverse_time: Some("G93"), ..BASE.feed },
    arcs: Arcs {
        turns: Some(Turns::All(b'P')),
        most_sweep: f64::INFINITY,
        // Its tolerance without a key in its INI file.
        mismatch: [0.0282, 0.0718],
        // Below its tolerance of 0.00127 mm the interpreter calls the radius zero.
        least_radius: 0.0013,
        most_radius: f64::INFINITY,
        ..BASE.arcs
    },
    spindle: SpindleWords {
        cutting_speed: Some(CuttingSpeed { on: "G96", off: "G97", limit: Limit::Word("D") }),
        orient: Some(("M19", Some(b'R'))),
        other: Some(b'$'),
        ..BASE.spindle
    },
    coolant: CoolantWords { mist: Some("M7"), ..BASE.coolant },
    tool: ToolWords {
        length: Length::Words(LengthWords {
            on: "G43",
            number: LengthNumber::Tool(b'H'),
            off: Some("G49"),
            with_move: false,
            usual: false,
        }),
        ..BASE.tool
    },
    offsets: &["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"],
    compensation: Some(CompensationWords {
        left: "G41",
        right: "G42",
        by_diameter: Some(["G41.1", "G42.1"]),
        // LinuxCNC User Manual, Lathe: the orientations of a tool.
        edge: Some(EdgeWords { address: b'L', numbers: [[2, 7, 3], [6, 0, 8], [1, 5, 4]] }),
        off: "G40",
        tool: Some(b'D'),
        with_move: false,
        reads_over_stops: true,
        planes: &[Plane::Xy, Plane::Zx],
    }),
    // G61 follows the path and stops where it has to; G64 alone promises no bound.
    path: PathWords {
        exact: Some("G61"),
        within: Some(PathBound { word: "G64", length: "P" }),
        before: None,
        unbounded: Some("G64"),
        starts_unbounded: false,
        under_compensation: false,
        exact_on_lathes: true,
    },
    m: MFunctions {
        own: &[
            (48, "switches the overrides on"),
            (49, "switches the overrides off"),
            (50, "switches the feed override"),
            (51, "switches the spindle override"),
            (52, "switches the adaptive feed"),
            (53, "switches the feed stop"),
            (60, "changes the pallet and stops"),
            (61, "sets the number of the tool"),
            (62, "switches an output"),
            (63, "switches an output"),
            (64, "switches an output"),
            (65, "switches an output"),
            (66, "waits for an input"),
            (67, "sets an analog output"),
            (68, "sets an analog output"),
            (70, "saves the modes"),
            (71, "forgets the saved modes"),
            (72, "brings saved modes back, G90 and G91 among them"),
            (73, "saves the modes up to the end of the program"),
            (98, "calls a subprogram"),
            (99, "returns, or starts the program again"),
        ],
        ..BASE.m
    },
    ..BASE
};
