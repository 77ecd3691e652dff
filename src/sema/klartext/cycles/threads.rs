//! Thread milling: cycles 262 to 265 and 267.

use crate::sema::cycle::row::{Kind, Name, Parameter, Rule};

use super::bores::DIAMETER;
use super::drilling::{AHEAD_ABOVE, BREAK_DEPTH, BREAK_WAY, FEED, PLUNGE, PREPOSITION, Q201, Q239};
use super::milling::{MILLING_FEED, Q351, cycle};
use super::{ABOVE_0, AT_SURFACE, Row, SECOND, SET_UP, q};

pub(in super::super) const SINK_FEED: Name = Name::Q(254);
pub(in super::super) const STEPS: Name = Name::Q(355);
pub(in super::super) const TOTAL_DEPTH: Name = Name::Q(356);
pub(in super::super) const SIDE_CLEARANCE: Name = Name::Q(357);
pub(in super::super) const FRONT_DEPTH: Name = Name::Q(358);
pub(in super::super) const FRONT_OFFSET: Name = Name::Q(359);
pub(in super::super) const SINK_LATER: Name = Name::Q(360);
pub(in super::super) const APPROACH_FEED: Name = Name::Q(512);

const Q207: Parameter = q(MILLING_FEED, Kind::Feed, "feed for milling").needed();
const Q253: Parameter = q(PREPOSITION, Kind::Feed, "feed of positioning in the hole or beside the stud").needed();
const Q254: Parameter = q(SINK_FEED, Kind::Feed, "feed for countersinking").needed();
const Q355: Parameter =
    q(STEPS, Kind::Count, "0 one turn, 1 turns over the whole depth, more: one turn every so many pitches")
        .needed()
        .rule(Rule::OneOf(0, 99_999));
const Q358: Parameter =
    q(FRONT_DEPTH, Kind::Length, "depth of the tip for the countersink at the front, 0 none").needed();
const Q359: Parameter =
    q(FRONT_OFFSET, Kind::Length, "radius of the centre's circle in the countersink").needed().unsigned();
const Q512: Parameter = q(APPROACH_FEED, Kind::Feed, "feed of the way to the thread").default("Q207");

pub(super) const ROWS: &[Row] = &[
    cycle(
        262,
        "CYCL DEF 262",
        "THREAD MILLING",
        |call| call.thread_in_hole(),
        &[DIAMETER, Q239, Q201, Q355, Q253, Q351, SET_UP, AT_SURFACE, SECOND, Q207, Q512],
    ),
    cycle(
        263,
        "CYCL DEF 263",
        "THREAD MILLING AND COUNTERSINKING",
        |call| call.thread_with_countersink(),
        &[
            DIAMETER,
            Q239,
            Q201,
            q(TOTAL_DEPTH, Kind::Length, "depth of the tip for the countersink, 0 none").needed(),
            Q253,
            Q351,
            SET_UP,
            q(SIDE_CLEARANCE, Kind::Length, "distance of the tool from the wall").without_effect(
                "the tool goes down in the middle, and the circle that the distance belongs to is left out",
            ),
            Q358,
            Q359,
            AT_SURFACE,
            SECOND,
            Q254,
            Q207,
            Q512,
        ],
    ),
    cycle(
        264,
        "CYCL DEF 264",
        "THREAD DRILLING AND MILLING",
        |call| call.thread_with_hole(),
        &[
            DIAMETER,
            Q239,
            Q201,
            q(TOTAL_DEPTH, Kind::Length, "depth of the hole").needed(),
            Q253,
            Q351,
            q(PLUNGE, Kind::Length, "plunging depth").needed().rule(ABOVE_0),
            q(AHEAD_ABOVE, Kind::Length, "distance above the last depth").needed(),
            q(BREAK_DEPTH, Kind::Length, "depth after which the chip is broken; 0 never").needed().unsigned(),
            q(BREAK_WAY, Kind::Length, "way back to break the chip").needed(),
            Q358,
            Q359,
            SET_UP,
            AT_SURFACE,
            SECOND,
            q(FEED, Kind::Feed, "feed for drilling").needed(),
            Q207,
            Q512,
        ],
    ),
    cycle(
        265,
        "CYCL DEF 265",
        "HELICAL THREAD DRILLING AND MILLING",
        |call| call.thread_from_solid(),
        &[
            DIAMETER,
            Q239,
            Q201,
            Q253,
            Q358,
            Q359,
            q(SINK_LATER, Kind::Number, "countersink 0 before the thread, 1 afterwards")
                .needed()
                .rule(Rule::OneOf(0, 1)),
            SET_UP,
            AT_SURFACE,
            SECOND,
            Q254,
            Q207,
        ],
    ),
    cycle(
        267,
        "CYCL DEF 267",
        "OUTSIDE THREAD MILLING",
        |call| call.thread_on_stud(),
        &[DIAMETER, Q239, Q201, Q355, Q253, Q351, SET_UP, Q358, Q359, AT_SURFACE, SECOND, Q254, Q207, Q512],
    ),
];
