//! Fanuc lathes. The G codes of system A have other meanings than anywhere else: G90 and G94 are cycles there, and absolute
//! is a matter of the letters. Systems B and C are tables of their own.

use core::f64::consts::PI;

use super::{
    Arcs, Change, CuttingSpeed, FeedWords, Frame, Lead, Length, Limit, Motion, RigidTap, SpindleWords, TapCycle,
    Target, Thread, ToolWords,
    fanuc::{TAP, TARGET as FANUC},
};

/// G-code system A.
pub(super) const A: Target = Target {
    name: "fanuc-lathe",
    about: "Fanuc lathes, G-code system A",
    frame: Frame {
        head: &["G21 G40 G98"],
        inch_head: Some(&["G20 G40 G98"]),
        mill: None,
        lathe_diameter: Some("G18"),
        ..FANUC.frame
    },
    motion: Motion {
        // Whether it is there, and where X is counted then, is not confirmed.
        machine: None,
        thread: Some(Thread { word: "G32", lead: Lead::OneAxis(b'F'), stops: false }),
        // G74 is another cycle here, and R counts from where the tool stands.
        rigid_tap: Some(RigidTap::Cycle(TapCycle {
            left: None,
            level: None,
            from_start: true,
            stays: false,
            meets: MEETS,
            ..TAP
        })),
        ..FANUC.motion
    },
    feed: FeedWords { per_minute: "G98", per_revolution: Some("G99"), ..FANUC.feed },
    arcs: Arcs { most_sweep: PI * 2.0 / 3.0, ..FANUC.arcs },
    spindle: SpindleWords {
        cutting_speed: Some(CuttingSpeed { on: "G96", off: "G97", limit: Limit::Block("G50") }),
        ..FANUC.spindle
    },
    tool: ToolWords {
        address: b'T',
        most: 99,
        most_offset: None,
        change: Some(Change::Turret { digits: 2 }),
        prepares: false,
        length: Length::WithTool,
    },
    more_offsets: None,
    // That of the nose of a tool is not confirmed.
    compensation: None,
    tilt: None,
    ..FANUC
};

/// G-code system B.
pub(super) const B: Target = Target {
    name: "fanuc-lathe-b",
    about: "Fanuc lathes, G-code system B",
    frame: Frame { head: &["G90 G21 G40 G94"], inch_head: Some(&["G90 G20 G40 G94"]), ..A.frame },
    motion: Motion {
        thread: Some(Thread { word: "G33", lead: Lead::OneAxis(b'F'), stops: false }),
        // What R counts from is not confirmed.
        rigid_tap: None,
        ..A.motion
    },
    feed: FeedWords { per_minute: "G94", per_revolution: Some("G95"), ..A.feed },
    spindle: SpindleWords {
        cutting_speed: Some(CuttingSpeed { on: "G96", off: "G97", limit: Limit::Block("G92") }),
        ..A.spindle
    },
    ..A
};

/// G-code system C.
pub(super) const C: Target = Target {
    name: "fanuc-lathe-c",
    about: "Fanuc lathes, G-code system C",
    frame: Frame { head: &["G90 G71 G40 G94"], inch_head: Some(&["G90 G70 G40 G94"]), ..A.frame },
    ..B
};

const MEETS: &str = "parameter 5202 has to stop the spindle at its mark where rigid tapping begins";
