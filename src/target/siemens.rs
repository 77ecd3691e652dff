//! SINUMERIK without cycles: whole turns by `TURN=`, lengths by D, waits by F, comments behind a semicolon.

use core::f64::consts::PI;

use crate::geo::Plane;

use super::{
    Arcs, Comments, CompensationWords, CoolantWords, Dwell, FeedWords, Frame, Lead, Length, LengthNumber, LengthWords,
    MFunctions, MoreOffsets, Motion, PathBound, PathWords, RigidTap, SpindleWords, SwivelWords, Target, Thread,
    TiltWords, ToolWords, Turns, base::BASE,
};

// Which axes F counts is a matter of the machine (FGROUP): no rotary ones. G96 would take the feed per revolution with it.
/// For mills and lathes, X as a radius or a diameter.
pub(super) const TARGET: Target = Target {
    name: "sinumerik",
    about: "SINUMERIK 840D sl, 828D, ONE: plain moves, no cycles",
    // A program beside its source must not replace it.
    extension: "plain.mpf",
    frame: Frame {
        // G70 and G71 leave the feed in the unit of the machine.
        head: &["G90 G710 G40 G94"],
        inch_head: Some(&["G90 G700 G40 G94"]),
        mill: Some("G17 D0"),
        lathe: Some("G18 DIAMOF D0"),
        lathe_diameter: Some("G18 DIAMON D0"),
        ..BASE.frame
    },
    comments: Comments { open: "; ", close: "", ..BASE.comments },
    motion: Motion {
        machine: Some("SUPA"),
        machine_feed: true,
        machine_drops_length: true,
        thread: Some(Thread { word: "G33", lead: Lead::AlongZ(b'K'), stops: false }),
        rigid_tap: Some(RigidTap::InAndOut { ready: "SPOS=", into: "G331", out: "G332", leads: *b"IJK" }),
        ..BASE.motion
    },
    feed: FeedWords { per_revolution: Some("G95"), ..BASE.feed },
    arcs: Arcs {
        turns: Some(Turns::More("TURN=")),
        most_sweep: f64::INFINITY,
        most_open_sweep: PI * 2.0 / 3.0,
        // Below, rounding turns the centre by more than the control takes (alarm 14040).
        least_chord: 0.01,
        ..BASE.arcs
    },
    spindle: SpindleWords { orient: Some(("SPOS=", None)), ..BASE.spindle },
    coolant: CoolantWords { mist: Some("M7"), ..BASE.coolant },
    tool: ToolWords {
        most: 32_000,
        most_offset: None,
        length: Length::Words(LengthWords {
            on: "D1",
            number: LengthNumber::None,
            off: Some("D0"),
            with_move: false,
            usual: true,
        }),
        ..BASE.tool
    },
    dwell: Dwell { address: b'F', ..BASE.dwell },
    // G58 and G59 shift by what stands in their block.
    offsets: &["G54", "G55", "G56", "G57", "G505", "G506", "G507", "G508", "G509"],
    more_offsets: Some(MoreOffsets { word: "G5", less: 0, most: 99 }),
    offsets_named: 4,
    compensation: Some(CompensationWords {
        left: "G41",
        right: "G42",
        by_diameter: None,
        edge: None,
        off: "G40",
        tool: None,
        with_move: true,
        reads_over_stops: true,
        planes: &[Plane::Xy],
    }),
    // G60 is what the control starts with, as it is delivered.
    path: PathWords {
        exact: Some("G60"),
        within: Some(PathBound { word: "G642", length: "CTOL=" }),
        before: Some(PathBound { word: "G641", length: "ADIS=" }),
        unbounded: Some("G64"),
        starts_unbounded: false,
        under_compensation: true,
        exact_on_lathes: true,
    },
    tilt: Some(TiltWords::Swivel(&SWIVEL)),
    m: MFunctions { own: OWN, ..BASE.m },
    ..BASE
};

// It retracts nothing by itself, is no addition to another plane, and counts in G17.
const SWIVEL: SwivelWords = SwivelWords {
    begin: "CYCLE800(0,\"",
    into: "\",0,27",
    back: "\",0,57,0,0,0,0,0,0",
    between: b',',
    direction: ",0,0,0",
    end: ",0,1)",
    off: "CYCLE800()",
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
