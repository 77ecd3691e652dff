//! LinuxCNC (RS274/NGC). Arcs by offset from the start, whole turns by `P`, comments in brackets.

use crate::geo::Plane;

use super::Traits;

pub(super) const TRAITS: Traits = Traits {
    name: "linuxcnc",
    extension: "ngc",
    frame: "%",
    head: &["G90 G21 G91.1 G94", "G17 G40 G49 G80"],
    lathe_head: ["G18 G8 G40 G49 G80", "G18 G7 G40 G49 G80"],
    comment: ("(", ")"),
    line_length: 80,
    arc_tolerance: 1.5,
    // Below its tolerance of 0.00127 mm the interpreter calls the radius zero.
    least_radius: 0.0013,
    turns_in_one_block: true,
    own_m: &[
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
    compensation_planes: &[Plane::Xy, Plane::Zx],
};
