//! Studs: 256 and 257.

use crate::sema::cycle::row::Kind;

use super::drilling::Q201;
use super::milling::{
    CORNER, DIAMETER, FIRST_SIDE, OPERATION, POSITION, Q202, Q206, Q207, Q338, Q351, Q368, Q369, Q370, Q385,
    SECOND_SIDE, TURN, cycle,
};
use super::pockets::START_ANGLE;
use super::{AT_SURFACE, Q, Row, SECOND, SET_UP, q};
use crate::sema::cycle::row::Parameter;

pub(in super::super) const RAW_DIAMETER: Q = Q(222);
pub(in super::super) const RAW: (Q, Q) = (Q(424), Q(425));
pub(in super::super) const APPROACH: Q = Q(437);

const Q215: Parameter =
    q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes what Q368 and Q369 leave").default("1");

/// The parameters of a cycle of its own, those that both studs have, and where it approaches.
macro_rules! parameters {
    ($($own:expr),* ; $approach:expr) => {
        &[
            $($own),*, Q207, Q351, Q201, Q202, Q206, SET_UP, AT_SURFACE, SECOND, Q370, $approach, Q215, Q369, Q338, Q385,
        ]
    };
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        256,
        "CYCL DEF 256",
        "RECTANGULAR STUD",
        |run, cycle, call| run.rectangular_stud(cycle, call),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the stud along the first axis").needed(),
            q(RAW.0, Kind::Length, "length of the blank along the first axis").needed(),
            q(SECOND_SIDE, Kind::Length, "length of the stud along the second axis").needed(),
            q(RAW.1, Kind::Length, "length of the blank along the second axis").needed(),
            q(CORNER, Kind::Length, "radius of the corners; below 0, a chamfer, is refused").default("0"),
            Q368,
            q(TURN, Kind::Angle, "angle by which the stud is turned about the place of the call").default("0"),
            q(POSITION, Kind::Number, "place of the call: 0 the middle, 1 to 4 the corners from the lower left one on")
                .default("0");
            q(APPROACH, Kind::Number, "place of the approach: 0 beside the middle of the +X side; others are refused")
                .default("0")
        ],
    ),
    cycle(
        257,
        "CYCL DEF 257",
        "CIRCULAR STUD",
        |run, cycle, call| run.circular_stud(cycle, call),
        parameters![
            q(DIAMETER, Kind::Length, "diameter of the stud").needed(),
            q(RAW_DIAMETER, Kind::Length, "diameter of the blank").needed(),
            Q368;
            q(START_ANGLE, Kind::Angle, "angle of the approach, 0 to 359; -1 for 0").default("-1")
        ],
    ),
];
