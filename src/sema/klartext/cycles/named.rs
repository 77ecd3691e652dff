//! Cycles that are known by number and name, and refused: where they are called, or where they are defined if they act there.
//!
//! Source: K 4.4, 6.9 (docs/sources.md).

use crate::sema::cycle::row::{Signature, Status};

use super::{CycleKind, REMOVE, Row};

/// Runs when it is called.
const fn named(number: u32, name: &'static str, what: &'static str) -> Row {
    group(number, number, name, what)
}

const fn group(first: u32, last: u32, name: &'static str, what: &'static str) -> Row {
    row((first, last), name, what, (CycleKind::Machining, REFUSED))
}

/// Acts where it is defined.
const fn acting(numbers: (u32, u32), name: &'static str, what: &'static str) -> Row {
    row(numbers, name, what, (CycleKind::Acting, REFUSED))
}

/// Says what other cycles of this list use.
const fn data(numbers: (u32, u32), name: &'static str, what: &'static str) -> Row {
    let read = Status::Checked { code: "P9010", why: "read, and the cycles that use it are refused" };
    row(numbers, name, what, (CycleKind::Data, read))
}

const REFUSED: Status = Status::Refused { code: "P9010" };

const fn row(
    numbers: (u32, u32),
    name: &'static str,
    what: &'static str,
    (nature, status): (CycleKind, Status),
) -> Row {
    let signature = Signature { name, what, status, source: "", parameters: &[] };
    Row { numbers, nature, requires: &[], signature, form: REMOVE }
}

pub(super) const ROWS: &[Row] = &[
    named(6, "CYCL DEF 6", "ROUGH-OUT"),
    named(15, "CYCL DEF 15", "PILOT DRILLING"),
    named(16, "CYCL DEF 16", "CONTOUR MILLING"),
    named(18, "CYCL DEF 18", "THREAD CUTTING"),
    named(27, "CYCL DEF 27", "CYLINDER SURFACE"),
    named(28, "CYCL DEF 28", "CYLINDER SURFACE SLOT"),
    named(29, "CYCL DEF 29", "CYLINDER SURFACE RIDGE"),
    named(39, "CYCL DEF 39", "CYLINDER SURFACE CONTOUR"),
    named(204, "CYCL DEF 204", "BACK BORING"),
    named(225, "CYCL DEF 225", "ENGRAVING"),
    acting((238, 238), "CYCL DEF 238", "MEASURE MACHINE STATUS"),
    acting((239, 239), "CYCL DEF 239", "ASCERTAIN THE LOAD"),
    group(272, 277, "CYCL DEF 272 to 277", "OCM cycle"),
    data((285, 285), "CYCL DEF 285", "DEFINE GEAR"),
    group(286, 288, "CYCL DEF 286 to 288", "gear cycle"),
    named(880, "CYCL DEF 880", "gear cycle"),
    named(290, "CYCL DEF 290", "INTERPOLATION TURNING"),
    acting((291, 291), "CYCL DEF 291", "COUPLING OF INTERPOLATION TURNING"),
    named(292, "CYCL DEF 292", "CONTOUR INTERPOLATION TURNING"),
    acting((800, 800), "CYCL DEF 800", "ADJUST ROTARY COORDINATE SYSTEM"),
    acting((801, 801), "CYCL DEF 801", "RESET ROTARY COORDINATE SYSTEM"),
    group(802, 879, "CYCL DEF 802 to 879", "turning cycle"),
    named(882, "CYCL DEF 882", "turning cycle"),
    named(883, "CYCL DEF 883", "turning cycle"),
    acting((892, 892), "CYCL DEF 892", "CHECK UNBALANCE"),
    acting((1000, 1003), "CYCL DEF 1000 to 1003", "RECIPROCATING STROKE"),
    acting((1004, 1020), "CYCL DEF 1004 to 1020", "dressing cycle"),
    group(1021, 1029, "CYCL DEF 1021 to 1029", "grinding cycle"),
    acting((1030, 1033), "CYCL DEF 1030 to 1033", "ACTIVATE WHEEL EDGE, GRINDING WHEEL COMPENSATION"),
    data((1271, 1282), "CYCL DEF 1271 to 1282", "OCM figure"),
];
