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
    turns_in_one_block: true,
    compensation_planes: &[Plane::Xy, Plane::Zx],
};
