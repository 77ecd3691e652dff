//! Bore milling: cycle 208.

use crate::sema::cycle::row::{Kind, Parameter};

use super::drilling::{FEED, Q201, ROUGH_DIAMETER};
use super::milling::{OVERLAP, Q351, cycle};
use super::{AT_SURFACE, Q, Row, SECOND, SET_UP, q};

pub(in super::super) const TURN_INFEED: Q = Q(334);
pub(in super::super) const NOMINAL: Q = Q(335);

pub(super) const DIAMETER: Parameter = q(NOMINAL, Kind::Length, "nominal diameter, above 0").needed();

pub(super) const ROWS: &[Row] = &[cycle(
    208,
    "CYCL DEF 208",
    "BORE MILLING",
    |run, cycle, call| run.bore_milling(cycle, call),
    &[
        SET_UP,
        Q201,
        q(FEED, Kind::Feed, "feed on the helix").needed(),
        q(TURN_INFEED, Kind::Length, "infeed of a turn, above 0").needed(),
        AT_SURFACE,
        SECOND,
        DIAMETER,
        q(ROUGH_DIAMETER, Kind::Length, "diameter that is drilled already").default("0"),
        Parameter { needed: false, ..Q351 }.default("+1"),
        q(OVERLAP, Kind::Number, "width of a cut in radii of the cutter, 0.1 to 1.9999").default("one circle"),
    ],
)];
