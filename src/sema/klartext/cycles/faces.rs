//! Faces: 230 to 233.

use crate::sema::cycle::row::{Kind, Parameter};

use super::drilling::PREPOSITION;
use super::milling::{
    CORNER, FIRST_SIDE, OPERATION, POSITION, Q202, Q206, Q207, Q338, Q368, Q369, Q370, Q385, SECOND_SIDE, cycle,
};
use super::patterns::START;
use super::{Q, Row, SECOND, SET_UP, q};

pub(in super::super) const STEP_FEED: Q = Q(209);
pub(in super::super) const TOP: Q = Q(227);
pub(in super::super) const CUTS: Q = Q(240);
pub(in super::super) const LIMITS: [Q; 3] = [Q(347), Q(348), Q(349)];
pub(in super::super) const ALONG: Q = Q(350);
pub(in super::super) const SIDE_CLEARANCE: Q = Q(357);
pub(in super::super) const BOTTOM: Q = Q(386);
pub(in super::super) const STRATEGY: Q = Q(389);
/// First axis, second axis and height of the corners of a ruled surface.
pub(in super::super) const CORNERS: [[Q; 3]; 4] =
    [[START.0, START.1, TOP], [Q(228), Q(229), Q(230)], [Q(231), Q(232), Q(233)], [Q(234), Q(235), Q(236)]];

const Q225: Parameter = q(START.0, Kind::Length, "corner of the face along the first axis").needed();
const Q226: Parameter = q(START.1, Kind::Length, "corner of the face along the second axis").needed();
const Q218: Parameter = q(FIRST_SIDE, Kind::Length, "length of the face along the first axis").needed();
const Q219: Parameter = q(SECOND_SIDE, Kind::Length, "length of the face along the second axis").needed();
const Q227: Parameter = q(TOP, Kind::Length, "height of the blank").needed();
const Q386: Parameter = q(BOTTOM, Kind::Length, "height of the finished face").needed();
const Q253: Parameter = q(PREPOSITION, Kind::Feed, "feed to the level, and from path to path").needed();
const Q357: Parameter =
    q(SIDE_CLEARANCE, Kind::Length, "how far the cutter leaves the face at the ends of a path").needed();
const Q389: Parameter =
    q(STRATEGY, Kind::Number, "0 to and fro, turning outside, 1 turning inside, 2 in one sense; others are refused")
        .needed();
const NO_LIMITS: &str = "faces with limits are refused";

const fn limit(limit: Q, what: &'static str) -> Parameter {
    q(limit, Kind::Number, what).default("0")
}

const fn corner(of: Q, what: &'static str) -> Parameter {
    q(of, Kind::Length, what).needed()
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        230,
        "CYCL DEF 230",
        "MULTIPASS MILLING",
        |run, cycle, call| run.multipass(cycle, call),
        &[
            Q225,
            Q226,
            Parameter { what: "height of the face", ..Q227 },
            Q218,
            Q219,
            q(CUTS, Kind::Count, "number of paths, from 2 on").needed(),
            Q206,
            Q207,
            q(STEP_FEED, Kind::Feed, "feed from path to path").needed(),
            SET_UP,
        ],
    ),
    cycle(
        231,
        "CYCL DEF 231",
        "RULED SURFACE",
        |run, cycle, call| run.ruled_surface(cycle, call),
        &[
            corner(CORNERS[0][0], "corner where the first row begins, along the first axis"),
            corner(CORNERS[0][1], "the same corner along the second axis"),
            corner(CORNERS[0][2], "height of the same corner"),
            corner(CORNERS[1][0], "corner where the first row ends, along the first axis"),
            corner(CORNERS[1][1], "the same corner along the second axis"),
            corner(CORNERS[1][2], "height of the same corner"),
            corner(CORNERS[2][0], "corner opposite to the first one, along the first axis"),
            corner(CORNERS[2][1], "the same corner along the second axis"),
            corner(CORNERS[2][2], "height of the same corner"),
            corner(CORNERS[3][0], "corner opposite to the second one, along the first axis"),
            corner(CORNERS[3][1], "the same corner along the second axis"),
            corner(CORNERS[3][2], "height of the same corner"),
            q(CUTS, Kind::Count, "number of rows, from 2 on").needed(),
            Parameter { what: "feed for milling; half of it in the first row", ..Q207 },
        ],
    ),
    cycle(
        232,
        "CYCL DEF 232",
        "FACE MILLING",
        |run, cycle, call| run.face(cycle, call),
        &[
            Q389, Q225, Q226, Q227, Q386, Q218, Q219, Q202, Q369, Q370, Q207, Q385, Q253, SET_UP, Q357, SECOND,
        ],
    ),
    cycle(
        233,
        "CYCL DEF 233",
        "FACE MILLING",
        |run, cycle, call| run.face_at_call(cycle, call),
        &[
            q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes what Q369 leaves").needed(),
            Q389,
            q(ALONG, Kind::Number, "paths along 0 the first, 1 the second axis").needed(),
            Q218,
            Q219,
            Q227,
            Q386,
            Q369,
            Q202,
            Q370,
            Q207,
            Q385,
            Q253,
            Q357,
            SET_UP,
            SECOND,
            limit(LIMITS[0], "first limit; above or below 0 it is refused"),
            limit(LIMITS[1], "second limit; above or below 0 it is refused"),
            limit(LIMITS[2], "third limit; above or below 0 it is refused"),
            q(CORNER, Kind::Length, "radius of the corners between limits").without_effect(NO_LIMITS),
            Q368.without_effect(NO_LIMITS),
            Q338.without_effect(NO_LIMITS),
            q(POSITION, Kind::Number, "place of the call: -1 the corner from which signed lengths count, 0 the middle, 1 to 4 the corners from the lower left one on")
                .default("-1"),
        ],
    ),
];
