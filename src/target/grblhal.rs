//! grblHAL: GRBL with turns on arcs, a tool change, more offsets and M functions of drivers.

use super::{Arcs, Change, CoolantWords, Flow, Line, MFunctions, Target, ToolWords, Turns, grbl::TARGET as GRBL};

/// As [`GRBL`] but for what the core of grblHAL adds.
pub(super) const TARGET: Target = Target {
    name: "grblhal",
    about: "grblHAL, in the plain build of any driver",
    line: Line { length: 80, ..GRBL.line },
    // Angles are computed in double precision.
    arcs: Arcs { turns: Some(Turns::All(b'P')), most_sweep: f64::INFINITY, ..GRBL.arcs },
    coolant: CoolantWords { mist: Some("M7"), ..GRBL.coolant },
    tool: ToolWords { most: 2_147_483_647, change: Some(Change::Word("M6")), ..GRBL.tool },
    flow: Flow { optional_stop_is_idle: false, ..GRBL.flow },
    offsets: &["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"],
    m: MFunctions { open: true, own: OWN, ..GRBL.m },
    ..GRBL
};

const OWN: &[(u32, &str)] = &[
    (48, "switches the overrides on"),
    (49, "switches the overrides off"),
    (50, "switches the feed override"),
    (51, "switches the spindle override"),
    (53, "switches the feed stop"),
    (56, "switches the parking override"),
    (60, "changes the pallet and ends the program"),
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
    (98, "calls a macro"),
    (99, "returns from a macro, or starts the program again"),
];
