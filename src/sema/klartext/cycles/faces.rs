//! Faces: 230 and 232.

use crate::sema::cycle_table::Kind;

use super::drilling::PREPOSITION;
use super::milling::{FIRST_SIDE, Q202, Q206, Q207, Q369, Q370, Q385, SECOND_SIDE, cycle};
use super::patterns::START;
use super::{Q, Row, SECOND, SET_UP, q};

pub(in super::super) const STEP_FEED: Q = Q(209);
pub(in super::super) const TOP: Q = Q(227);
pub(in super::super) const CUTS: Q = Q(240);
pub(in super::super) const SIDE_CLEARANCE: Q = Q(357);
pub(in super::super) const BOTTOM: Q = Q(386);
pub(in super::super) const STRATEGY: Q = Q(389);

pub(super) const ROWS: &[Row] = &[
    cycle(
        230,
        "CYCL DEF 230",
        "MULTIPASS MILLING",
        |run, cycle, call| run.multipass(cycle, call),
        &[
            q(START.0, Kind::Length, "corner of the face along the first axis").needed(),
            q(START.1, Kind::Length, "corner of the face along the second axis").needed(),
            q(TOP, Kind::Length, "height of the face").needed(),
            q(FIRST_SIDE, Kind::Length, "length of the face along the first axis").needed(),
            q(SECOND_SIDE, Kind::Length, "length of the face along the second axis").needed(),
            q(CUTS, Kind::Count, "number of paths, from 2 on").needed(),
            Q206,
            Q207,
            q(STEP_FEED, Kind::Feed, "feed from path to path").needed(),
            SET_UP,
        ],
    ),
    cycle(
        232,
        "CYCL DEF 232",
        "FACE MILLING",
        |run, cycle, call| run.face(cycle, call),
        &[
            q(STRATEGY, Kind::Number, "0 to and fro, turning outside, 1 turning inside, 2 in one sense").needed(),
            q(START.0, Kind::Length, "corner of the face along the first axis").needed(),
            q(START.1, Kind::Length, "corner of the face along the second axis").needed(),
            q(TOP, Kind::Length, "height of the blank").needed(),
            q(BOTTOM, Kind::Length, "height of the finished face").needed(),
            q(FIRST_SIDE, Kind::Length, "length of the face along the first axis").needed(),
            q(SECOND_SIDE, Kind::Length, "length of the face along the second axis").needed(),
            Q202,
            Q369,
            Q370,
            Q207,
            Q385,
            q(PREPOSITION, Kind::Feed, "feed to the level, and from path to path").needed(),
            SET_UP,
            q(SIDE_CLEARANCE, Kind::Length, "how far the cutter leaves the face at the ends of a path").needed(),
            SECOND,
        ],
    ),
];
