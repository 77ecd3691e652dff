//! Cycles that act where they are defined: shifts, mirror, dwell, rotation, scaling, program call, orientation, tilt,
//! tolerance, datum; and those that set data for others.

use crate::sema::cycle::row::{Kind, Name, Parameter, Signature, Status};

use super::{CycleKind, REMOVE, Row, q};

pub(in super::super) const DATUM: Name = Name::Q(339);

const MANUAL: &str = "HEIDENHAIN iTNC 530 conversational programming";

const fn acting(
    number: u32,
    nature: CycleKind,
    name: &'static str,
    what: &'static str,
    parameters: &'static [Parameter],
    form: &'static str,
) -> Row {
    let signature = Signature { name, what, status: Status::Built, source: MANUAL, parameters };
    Row { numbers: (number, number), nature, requires: &[], signature, form }
}

const fn data(number: u32, name: &'static str, what: &'static str) -> Row {
    let status = Status::Checked { code: "P9010", why: "read, and the cycles that use it are refused" };
    let signature = Signature { name, what, status, source: "", parameters: &[] };
    Row { numbers: (number, number), nature: CycleKind::Data, requires: &[], signature, form: REMOVE }
}

const fn part(kind: Kind, what: &'static str) -> Parameter {
    Parameter::new(Name::Part(1), kind, what)
}

pub(super) const ROWS: &[Row] = &[
    acting(
        7,
        CycleKind::DatumShift,
        "CYCL DEF 7",
        "DATUM SHIFT",
        &[part(Kind::Length, "shift by axis, or `#` and the line of a datum table")],
        "write the shift: `CYCL DEF 7.1 X+60`",
    ),
    acting(
        8,
        CycleKind::Mirror,
        "CYCL DEF 8",
        "MIRROR IMAGE",
        &[part(Kind::Either, "letters of the axes; none ends it")],
        "write the letters of the axes: `CYCL DEF 8.1 X Y`",
    ),
    acting(
        9,
        CycleKind::Dwell,
        "CYCL DEF 9",
        "DWELL TIME",
        &[part(Kind::Dwell, "0 to 3600 seconds").needed()],
        "write the time: `CYCL DEF 9.1 DWELL 1.5`",
    ),
    acting(
        10,
        CycleKind::Rotation,
        "CYCL DEF 10",
        "ROTATION",
        &[part(Kind::Angle, "angle after ROT, or IROT for an incremental one").needed()],
        "write the angle: `CYCL DEF 10.1 ROT+35`",
    ),
    acting(
        11,
        CycleKind::Scaling,
        "CYCL DEF 11",
        "SCALING",
        &[part(Kind::Number, "factor after SCL").needed()],
        "write the factor: `CYCL DEF 11.1 SCL 0.75`",
    ),
    acting(
        12,
        CycleKind::ProgramCall,
        "CYCL DEF 12",
        "PGM CALL",
        &[part(Kind::Text, "name of the program that calls run").needed()],
        REMOVE,
    ),
    acting(
        13,
        CycleKind::Orientation,
        "CYCL DEF 13",
        "ORIENTATION",
        &[part(Kind::Angle, "0 to 360 degrees, taken by M19").needed()],
        "write the angle: `CYCL DEF 13.1 ANGLE 180`",
    ),
    acting(
        19,
        CycleKind::Tilt,
        "CYCL DEF 19",
        "WORKING PLANE",
        &[part(Kind::Angle, "angles of the rotary axes; all of them 0")],
        REMOVE,
    ),
    acting(
        26,
        CycleKind::AxisScaling,
        "CYCL DEF 26",
        "AXIS-SPECIFIC SCALING",
        &[part(Kind::Number, "factor by axis, and the centre after CCX, CCY, CCZ")],
        "write factors and centre: `CYCL DEF 26.1 X1.4 Y0.6 CCX+15 CCY+20`",
    ),
    acting(
        32,
        CycleKind::Tolerance,
        "CYCL DEF 32",
        "TOLERANCE",
        &[part(Kind::Length, "tolerance of the path after T; without it the setting of the machine")],
        REMOVE,
    ),
    acting(
        247,
        CycleKind::Preset,
        "CYCL DEF 247",
        "DATUM SETTING",
        &[q(DATUM, Kind::Count, "number of the work offset: 1 is G54").needed()],
        REMOVE,
    ),
    data(271, "CYCL DEF 271", "OCM CONTOUR DATA"),
];
