//! Cycles that are known by number and name, and refused where they are called.

use crate::sema::cycle_table::{Signature, Status};

use super::{Nature, REMOVE, Row};

const fn named(number: u32, name: &'static str, what: &'static str) -> Row {
    group(number, number, name, what)
}

const fn group(first: u32, last: u32, name: &'static str, what: &'static str) -> Row {
    let status = Status::Refused { code: "K9001" };
    let signature = Signature { name, what, status, source: "", parameters: &[] };
    Row { numbers: (first, last), nature: Nature::Machining, signature, form: REMOVE }
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
    named(258, "CYCL DEF 258", "POLYGON STUD"),
    group(272, 277, "CYCL DEF 272 to 277", "OCM cycle"),
    group(285, 288, "CYCL DEF 285 to 288", "gear cycle"),
    named(880, "CYCL DEF 880", "gear cycle"),
    group(290, 292, "CYCL DEF 290 to 292", "interpolation turning"),
    group(800, 879, "CYCL DEF 800 to 879", "turning cycle"),
    named(882, "CYCL DEF 882", "turning cycle"),
    named(883, "CYCL DEF 883", "turning cycle"),
    named(892, "CYCL DEF 892", "turning cycle"),
    group(1000, 1030, "CYCL DEF 1000 to 1030", "grinding cycle"),
    group(1271, 1278, "CYCL DEF 1271 to 1278", "OCM figure"),
];
