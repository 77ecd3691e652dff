//! Studs: 256, 257 and 258.
//!
//! Source: K 6.5 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::spigot::{Blank, Finish, Shape, Spigot, stock_at_corner};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter, Rule};

use super::call::CycleCall;
use super::drilling::Q201;
use super::machining::{Machining, shown};
use super::milling::{
    CORNER, DIAMETER, FIRST_SIDE, OPERATION, POSITION, Q202, Q206, Q207, Q338, Q351, Q368, Q369, Q370, Q385,
    SECOND_SIDE, TURN, cycle,
};
use super::pockets::START_ANGLE;
use super::{ABOVE_0, AT_SURFACE, Planned, Row, SECOND, SET_UP, q};

pub(in super::super) const RAW_DIAMETER: Name = Name::Q(222);
pub(in super::super) const RAW: (Name, Name) = (Name::Q(424), Name::Q(425));
pub(in super::super) const APPROACH: Name = Name::Q(437);
const CIRCLE: Name = Name::Q(571);
const CORNERS: Name = Name::Q(572);
const CIRCLE_THROUGH: Name = Name::Q(573);

const Q215: Parameter =
    q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes what Q368 and Q369 leave")
        .rule(Rule::OneOf(0, 2))
        .default("1");

/// The parameters of a cycle of its own, those that all studs have, and one of its own between them.
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
        |call| call.rectangular_stud(),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the stud along the first axis").needed().rule(ABOVE_0),
            q(RAW.0, Kind::Length, "length of the blank along the first axis").needed().rule(ABOVE_0),
            q(SECOND_SIDE, Kind::Length, "length of the stud along the second axis").needed().rule(ABOVE_0),
            q(RAW.1, Kind::Length, "length of the blank along the second axis").needed().rule(ABOVE_0),
            q(CORNER, Kind::Length, "radius of the corners; below 0, a chamfer, is refused").default("0"),
            Q368,
            q(TURN, Kind::Angle, "angle by which the stud is turned about the place of the call").default("0"),
            q(POSITION, Kind::Number, "place of the call: 0 the middle, 1 to 4 the corners from the lower left one on")
                .rule(Rule::OneOf(0, 4))
                .default("0");
            q(APPROACH, Kind::Number, "place of the approach: 0 beside the middle of the +X side; others are refused")
                .rule(Rule::OneOf(0, 4))
                .default("0")
        ],
    ),
    cycle(
        257,
        "CYCL DEF 257",
        "CIRCULAR STUD",
        |call| call.circular_stud(),
        parameters![
            q(DIAMETER, Kind::Length, "diameter of the stud").needed().rule(ABOVE_0),
            q(RAW_DIAMETER, Kind::Length, "diameter of the blank").needed().rule(ABOVE_0),
            Q368;
            q(START_ANGLE, Kind::Angle, "angle of the approach, 0 to 359; -1 for 0").default("-1")
        ],
    ),
    cycle(
        258,
        "CYCL DEF 258",
        "POLYGON STUD",
        |call| call.polygon_stud(),
        parameters![
            q(CIRCLE_THROUGH, Kind::Number, "Q571 is the diameter of 0 the inscribed circle, 1 the circumscribed one")
                .needed()
                .rule(Rule::OneOf(0, 1)),
            q(CIRCLE, Kind::Length, "diameter of the reference circle").needed().rule(ABOVE_0),
            q(RAW_DIAMETER, Kind::Length, "diameter of the blank").needed().rule(ABOVE_0),
            q(CORNERS, Kind::Number, "number of corners").needed().rule(Rule::OneOf(3, 30)),
            q(TURN, Kind::Angle, "angle of a corner or the middle of an edge, by `[cycles] multi_edge_start`").needed(),
            q(CORNER, Kind::Length, "radius of the corners, below 0 a chamfer; refused where it is not 0").default("0");
            Q368
        ],
    ),
];

/// Beside the blank the tool goes down so far away, mm.
pub(super) const ASIDE: f64 = 2.0;

impl CycleCall<'_> {
    /// Cycle 256.
    pub fn rectangular_stud(&self) -> Made<Planned> {
        let Some((mill, asked)) = self.stud_of()? else { return Ok(Planned::default()) };
        let half = [self.given.length(FIRST_SIDE) / 2.0, self.given.length(SECOND_SIDE) / 2.0];
        let raw = [self.given.length(RAW.0) / 2.0, self.given.length(RAW.1) / 2.0];
        let over = [raw[0] - half[0], raw[1] - half[1]];
        if over.iter().any(|way| *way < -1e-9) {
            return self.refuse(codes::P2090::blank_q424());
        }
        let corner = self.given.length(CORNER);
        if corner < 0.0 {
            return self.refuse(codes::P9010::chamfer_at_corners_is_not_supported(&corner));
        }
        let approach = self.given.whole(APPROACH);
        if approach != 0 {
            return self.refuse(codes::P9010::approach_at_corner_is_not_supported(&approach));
        }
        let turn = Deg(self.given.or_zero(TURN));
        let to_middle = self.way_to_middle(half);
        let place = Place { at: Place { at: self.call_point()?, turn }.point(to_middle), turn };
        let stock = stock_at_corner(over.map(|way| way.max(0.0)), corner);
        let blank = Blank { reach: raw[0], stock, aside: ASIDE };
        self.stud((mill, asked), place, Shape::Rectangle { half, corner }, blank)
    }

    /// Cycle 257.
    pub fn circular_stud(&self) -> Made<Planned> {
        let Some((mill, asked)) = self.stud_of()? else { return Ok(Planned::default()) };
        let radius = self.given.length(DIAMETER) / 2.0;
        let raw = self.given.length(RAW_DIAMETER) / 2.0;
        if raw < radius - 1e-9 {
            return self.refuse(codes::P2090::blank_q222_is_smaller_than_stud());
        }
        let angle = self.given.number(START_ANGLE).unwrap_or(-1.0);
        if angle != -1.0 && !(0.0..=359.0).contains(&angle) {
            return self.refuse(codes::P2090::angle_of_approach_q376_is_not_1(&angle));
        }
        let place = Place { at: self.call_point()?, turn: Deg(angle.max(0.0)) };
        let blank = Blank { reach: raw, stock: raw - radius, aside: ASIDE };
        self.stud((mill, asked), place, Shape::Circle { radius }, blank)
    }

    /// Cycle 258.
    pub fn polygon_stud(&self) -> Made<Planned> {
        let Some((mill, asked)) = self.stud_of()? else { return Ok(Planned::default()) };
        let given = self.given;
        if given.or_zero(CORNER) != 0.0 {
            return self.refuse_argument(CORNER, codes::P9010::radius_or_chamfer_at_corners_of_polygon());
        }
        let Some(starts) = self.settings.cycles.multi_edge_start else {
            let fault = codes::K9040::whether_edge_or_corner_lies_at_q224();
            return self.refuse_argument(TURN, fault.answer(Answer::key("cycles", "multi_edge_start")));
        };
        let (edges, radius) = (given.whole(CORNERS).unsigned_abs(), given.length(CIRCLE) / 2.0);
        let cos = Deg(180.0 / f64::from(edges)).sin_cos().1;
        let (apothem, corner, read) = if given.whole(CIRCLE_THROUGH) == 0 {
            (radius, radius / cos, codes::P8106::q573_0_is_read_as_inscribed_circle())
        } else {
            (radius * cos, radius, codes::P8106::q573_1_is_read_as_circumscribed_circle())
        };
        let raw = given.length(RAW_DIAMETER) / 2.0;
        if raw < corner - 1e-9 {
            return self
                .refuse_argument(RAW_DIAMETER, codes::P2090::blank_q222_is_within_corners(&shown(2.0 * corner)));
        }
        self.say_of_all(read);
        let place = Place { at: self.call_point()?, turn: Deg(given.or_zero(TURN)) };
        let blank = Blank { reach: raw, stock: raw - apothem, aside: ASIDE };
        self.stud((mill, asked), place, Shape::Polygon { edges, apothem, starts: starts.into() }, blank)
    }

    /// What all take; older definitions have no Q215 and rough.
    fn stud_of(&self) -> Made<Option<(Mill, Machining)>> {
        let Some(mill) = self.cutter_of()? else { return Ok(None) };
        let Some(asked) = self.asked(&mill)? else { return Ok(None) };
        let asked = if self.given.has(OPERATION) { asked } else { Machining { wall: false, floor: false, ..asked } };
        Ok(Some((mill, asked)))
    }

    fn stud(&self, (mill, asked): (Mill, Machining), place: Place, shape: Shape, blank: Blank) -> Made<Planned> {
        let Machining { rough, wall, floor, allowance, step, feed } = asked;
        if wall && blank.stock > 2.0 * mill.radius {
            self.finishing_meets_roughing((allowance, 2.0 * mill.radius), mill.radius)?;
        }
        if floor {
            self.floor_in_one_cut(&mill)?;
        }
        let spigot = Spigot {
            counter_clockwise: !self.climbs()?,
            width: Some(self.overlap(mill.radius)?),
            mill,
            place,
            shape,
            allowance,
            blank,
            finishes_floor: false,
            rough,
            finish: (wall || floor).then_some(Finish { wall, floor, feed, step }),
        };
        Ok(Cycle::Spigot(self.sound(spigot)?).into())
    }
}
