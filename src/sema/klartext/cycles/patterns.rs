//! Patterns that run the machining cycle at many places: 220 and 221.

use crate::sema::cycle::row::{Kind, Parameter, Signature, Status};

use super::{AT_SURFACE, Nature, Q, REMOVE, Row, SECOND, SET_UP, q};

pub(in super::super) const CENTER: (Q, Q) = (Q(216), Q(217));
pub(in super::super) const TURN: Q = Q(224);
pub(in super::super) const START: (Q, Q) = (Q(225), Q(226));
pub(in super::super) const SPACING: (Q, Q) = (Q(237), Q(238));
pub(in super::super) const NUMBER: Q = Q(241);
pub(in super::super) const COLUMNS: Q = Q(242);
pub(in super::super) const LINES: Q = Q(243);
pub(in super::super) const CIRCLE: Q = Q(244);
pub(in super::super) const START_ANGLE: Q = Q(245);
pub(in super::super) const STOP_ANGLE: Q = Q(246);
pub(in super::super) const STEP: Q = Q(247);
pub(in super::super) const AT_SECOND: Q = Q(301);
pub(in super::super) const ON_ARCS: Q = Q(365);

const Q301: Parameter =
    q(AT_SECOND, Kind::Number, "from place to place at 0 the set-up clearance, 1 the 2nd set-up clearance").needed();

pub(super) const ROWS: &[Row] = &[
    Row {
        numbers: (220, 220),
        nature: Nature::Pattern(Some(|run, pattern| run.polar_places(pattern))),
        signature: Signature {
            name: "CYCL DEF 220",
            what: "POLAR PATTERN",
            status: Status::Built,
            source: "HEIDENHAIN TNC 320 cycle programming, p. 178; TNC 640 cycles, p. 162",
            parameters: &[
                q(CENTER.0, Kind::Length, "centre along the first axis").needed(),
                q(CENTER.1, Kind::Length, "centre along the second axis").needed(),
                q(CIRCLE, Kind::Length, "pitch circle diameter").needed(),
                q(START_ANGLE, Kind::Angle, "angle of the first place").needed(),
                q(STOP_ANGLE, Kind::Angle, "angle of the last place; not used where Q247 is not 0").needed(),
                q(STEP, Kind::Angle, "angle from place to place; 0 by Q246 and Q241").needed(),
                q(NUMBER, Kind::Count, "number of places").needed(),
                SET_UP,
                AT_SURFACE,
                SECOND,
                Q301,
                q(ON_ARCS, Kind::Number, "from place to place 0 on lines; 1, on arcs, is refused").default("0"),
            ],
        },
        form: REMOVE,
    },
    Row {
        numbers: (221, 221),
        nature: Nature::Pattern(Some(|run, pattern| run.grid_places(pattern))),
        signature: Signature {
            name: "CYCL DEF 221",
            what: "CARTESIAN PATTERN",
            status: Status::Built,
            source: "HEIDENHAIN TNC 410 DIN/ISO manual, p. 257",
            parameters: &[
                q(START.0, Kind::Length, "first place along the first axis").needed(),
                q(START.1, Kind::Length, "first place along the second axis").needed(),
                q(SPACING.0, Kind::Length, "distance of the columns").needed(),
                q(SPACING.1, Kind::Length, "distance of the lines").needed(),
                q(COLUMNS, Kind::Count, "number of columns").needed(),
                q(LINES, Kind::Count, "number of lines").needed(),
                q(TURN, Kind::Angle, "angle by which the pattern is turned about its first place").needed(),
                SET_UP,
                AT_SURFACE,
                SECOND,
                Q301,
            ],
        },
        form: REMOVE,
    },
    Row {
        numbers: (224, 224),
        nature: Nature::Pattern(None),
        signature: Signature {
            name: "CYCL DEF 224",
            what: "DATA MATRIX PATTERN",
            status: Status::Refused { code: "P9010" },
            source: "",
            parameters: &[],
        },
        form: REMOVE,
    },
];
