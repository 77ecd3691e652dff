//! Slots that are milled to and fro on falling strokes: 210 and 211.

use crate::sema::cycle::row::{Kind, Parameter};

use super::drilling::{FEED, Q201};
use super::milling::{FIRST_SIDE, OPERATION, Q202, Q207, Q338, SECOND_SIDE, TURN, cycle};
use super::patterns::{CENTER, CIRCLE, START_ANGLE};
use super::pockets::OPENING;
use super::{AT_SURFACE, Row, SECOND, SET_UP, q};

const Q202_OF_A_STROKE: Parameter = Parameter { what: "by how much a stroke falls, above 0 (`[cycles] q202`)", ..Q202 };
const Q206: Parameter = q(FEED, Kind::Feed, "feed for going down while it finishes").default("Q207");
const Q215: Parameter = q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes the wall").needed();
const Q216: Parameter = q(CENTER.0, Kind::Length, "centre along the first axis").needed();
const Q217: Parameter = q(CENTER.1, Kind::Length, "centre along the second axis").needed();
const Q219: Parameter =
    q(SECOND_SIDE, Kind::Length, "width of the slot, one to three diameters of the cutter").needed();

/// What both have in front of their sizes, and behind them.
macro_rules! parameters {
    ($($own:expr),*) => {
        &[SET_UP, Q201, Q207, Q202_OF_A_STROKE, Q215, AT_SURFACE, SECOND, Q216, Q217, $($own),*, Q338, Q206]
    };
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        210,
        "CYCL DEF 210",
        "SLOT RECIPROCATING",
        |run, cycle, call| run.reciprocating_slot(cycle, call),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the slot, above twice the diameter of the cutter").needed(),
            Q219,
            q(TURN, Kind::Angle, "angle by which the slot is turned about its centre").default("0")
        ],
    ),
    cycle(
        211,
        "CYCL DEF 211",
        "CIRCULAR SLOT",
        |run, cycle, call| run.reciprocating_bow(cycle, call),
        parameters![
            q(CIRCLE, Kind::Length, "diameter of the pitch circle").needed(),
            Q219,
            q(START_ANGLE, Kind::Angle, "angle of the centre of the first arc").needed(),
            q(OPENING, Kind::Angle, "angle of the slot between the centres of its arcs").needed()
        ],
    ),
];
