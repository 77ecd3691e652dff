//! Walls of pockets and studs that are finished: 212 to 215.

use crate::sema::cycle::row::{Kind, Parameter};

use super::drilling::Q201;
use super::milling::{CORNER, DIAMETER, FIRST_SIDE, Q202, Q206, Q207, SECOND_SIDE, cycle};
use super::patterns::CENTER;
use super::studs::RAW_DIAMETER;
use super::{AT_SURFACE, Q, Row, SECOND, SET_UP, q};

pub(in super::super) const ALLOWANCE: Q = Q(221);

const Q216: Parameter = q(CENTER.0, Kind::Length, "centre along the first axis").needed();
const Q217: Parameter = q(CENTER.1, Kind::Length, "centre along the second axis").needed();
const Q218: Parameter = q(FIRST_SIDE, Kind::Length, "finished length along the first axis").needed();
const Q219: Parameter = q(SECOND_SIDE, Kind::Length, "finished length along the second axis").needed();
const Q221: Parameter =
    q(ALLOWANCE, Kind::Length, "what stands on the wall along the first axis, 0 or more").default("0");
const Q223: Parameter = q(DIAMETER, Kind::Length, "finished diameter").needed();

/// What all have in front of their sizes.
macro_rules! parameters {
    ($($own:expr),*) => {
        &[SET_UP, Q201, Q206, Q202, Q207, AT_SURFACE, SECOND, Q216, Q217, $($own),*]
    };
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        212,
        "CYCL DEF 212",
        "POCKET FINISHING",
        |run, cycle, call| run.finished_rectangle(cycle, call),
        parameters![
            Q218,
            Q219,
            q(CORNER, Kind::Length, "radius of the corners; the cutter's where that is larger").default("0"),
            Q221
        ],
    ),
    cycle(
        213,
        "CYCL DEF 213",
        "STUD FINISHING",
        |run, cycle, call| run.finished_stud(cycle, call),
        parameters![Q218, Q219, q(CORNER, Kind::Length, "radius of the corners").default("0"), Q221],
    ),
    cycle(
        214,
        "CYCL DEF 214",
        "CIRCULAR POCKET FINISHING",
        |run, cycle, call| run.finished_circle(cycle, call),
        parameters![q(RAW_DIAMETER, Kind::Length, "diameter of the pocket that is there").needed(), Q223],
    ),
    cycle(
        215,
        "CYCL DEF 215",
        "CIRCULAR STUD FINISHING",
        |run, cycle, call| run.finished_round_stud(cycle, call),
        parameters![q(RAW_DIAMETER, Kind::Length, "diameter of the stud that is there").needed(), Q223],
    ),
];
