//! Pockets and slots: 251 to 254.

use crate::sema::cycle::row::Kind;

use super::drilling::Q201;
use super::milling::{
    DIAMETER, FIRST_SIDE, POSITION, Q202, Q206, Q207, Q215, Q338, Q351, Q366, Q368, Q369, Q370, Q385, Q439,
    SECOND_SIDE, TURN, cycle,
};
use super::{AT_SURFACE, Q, Row, SECOND, SET_UP, q};

pub(in super::super) const CENTER: (Q, Q) = (Q(216), Q(217));
pub(in super::super) const OPENING: Q = Q(248);
pub(in super::super) const SLOT_TURN: Q = Q(374);
pub(in super::super) const PITCH_CIRCLE: Q = Q(375);
pub(in super::super) const START_ANGLE: Q = Q(376);
pub(in super::super) const NUMBER: Q = Q(377);
pub(in super::super) const STEP: Q = Q(378);

/// The parameters of a cycle of its own, those that all pockets and slots have, and how it goes down.
macro_rules! parameters {
    ($($own:expr),* ; $($down:expr),*) => {
        &[
            Q215, $($own),*, Q368, Q207, Q351, Q201, Q202, Q369, Q206, Q338, SET_UP, AT_SURFACE, SECOND, $($down),*, Q385, Q439,
        ]
    };
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        251,
        "CYCL DEF 251",
        "RECTANGULAR POCKET",
        |run, cycle, call| run.rectangular_pocket(cycle, call),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the pocket along the first axis").needed(),
            q(SECOND_SIDE, Kind::Length, "length of the pocket along the second axis").needed(),
            q(super::milling::CORNER, Kind::Length, "radius of the corners; the cutter's where that is larger")
                .default("0"),
            q(TURN, Kind::Angle, "angle by which the pocket is turned about the place of the call").default("0"),
            q(POSITION, Kind::Number, "place of the call: 0 the middle, 1 to 4 the corners from the lower left one on")
                .default("0");
            Q370, Q366
        ],
    ),
    cycle(
        252,
        "CYCL DEF 252",
        "CIRCULAR POCKET",
        |run, cycle, call| run.circular_pocket(cycle, call),
        parameters![
            q(DIAMETER, Kind::Length, "diameter of the pocket").needed();
            Q370, Q366
        ],
    ),
    cycle(
        253,
        "CYCL DEF 253",
        "SLOT MILLING",
        |run, cycle, call| run.slot(cycle, call),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the slot").needed(),
            q(SECOND_SIDE, Kind::Length, "width of the slot").needed(),
            q(SLOT_TURN, Kind::Angle, "angle by which the slot is turned about the place of the call").default("0"),
            q(
                POSITION,
                Kind::Number,
                "place of the call: 0 the middle, 1 the left end, 2 and 3 the centres of the left and the right arc, 4 the right end",
            )
            .default("0");
            Q366
        ],
    ),
    cycle(
        254,
        "CYCL DEF 254",
        "CIRCULAR SLOT",
        |run, cycle, call| run.circular_slot(cycle, call),
        parameters![
            q(SECOND_SIDE, Kind::Length, "width of the slot").needed(),
            q(PITCH_CIRCLE, Kind::Length, "diameter of the pitch circle").needed(),
            q(
                POSITION,
                Kind::Number,
                "0 the centre is Q216/Q217; 2 the call is in the middle of the slot; 1 and 3, its ends, are refused",
            )
            .default("0"),
            q(CENTER.0, Kind::Length, "centre along the first axis; for Q367 = 0").default("0"),
            q(CENTER.1, Kind::Length, "centre along the second axis; for Q367 = 0").default("0"),
            q(START_ANGLE, Kind::Angle, "angle of the centre of the first arc; of the middle for Q367 = 2").needed(),
            q(OPENING, Kind::Angle, "angle of the slot between the centres of its arcs").needed(),
            q(STEP, Kind::Angle, "angle from slot to slot").default("0"),
            q(NUMBER, Kind::Count, "number of slots").default("1");
            Q366
        ],
    ),
];
