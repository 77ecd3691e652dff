//! Slots that are milled to and fro on falling strokes: 210 and 211.
//!
//! Source: K 6.5; F B3 (docs/sources.md).

use crate::geo::tolerance;
use core::f64::consts::PI;

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::cycle::milling::{Heights, Mill, Place};
use crate::ir::cycle::pocket::{Finish, Insertion, LevelChange, Pocket, Shape, Strategy, WallApproach};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Parameter, Rule};

use super::call::CycleCall;
use super::drilling::{FEED, Q201};
use super::machining::shown;
use super::milling::{FINISHING_INFEED, FIRST_SIDE, OPERATION, Q202, Q207, Q338, SECOND_SIDE, TURN, cycle};
use super::patterns::{CENTER, CIRCLE, START_ANGLE};
use super::pockets::OPENING;
use super::{ABOVE_0, AT_SURFACE, Planned, Row, SECOND, SET_UP, q};

const Q202_OF_A_STROKE: Parameter = Parameter { what: "by how much a stroke falls (`[cycles] q202`)", ..Q202 };
const Q206: Parameter = q(FEED, Kind::Feed, "feed for going down while it finishes").default("Q207");
const Q215: Parameter =
    q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes the wall").needed().rule(Rule::OneOf(0, 2));
const Q216: Parameter = q(CENTER.0, Kind::Length, "centre along the first axis").needed();
const Q217: Parameter = q(CENTER.1, Kind::Length, "centre along the second axis").needed();
const Q219: Parameter =
    q(SECOND_SIDE, Kind::Length, "width of the slot, one to three diameters of the cutter").needed().rule(ABOVE_0);

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
        |call| call.reciprocating_slot(),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the slot, above twice the diameter of the cutter")
                .needed()
                .rule(ABOVE_0),
            Q219,
            q(TURN, Kind::Angle, "angle by which the slot is turned about its centre").default("0")
        ],
    ),
    cycle(
        211,
        "CYCL DEF 211",
        "CIRCULAR SLOT",
        |call| call.reciprocating_bow(),
        parameters![
            q(CIRCLE, Kind::Length, "diameter of the pitch circle").needed().rule(ABOVE_0),
            Q219,
            q(START_ANGLE, Kind::Angle, "angle of the centre of the first arc").needed(),
            q(OPENING, Kind::Angle, "angle of the slot between the centres of its arcs").needed()
        ],
    ),
];

impl CycleCall<'_> {
    /// Cycle 210.
    pub fn reciprocating_slot(&self) -> Made<Planned> {
        let center = self.center_of_its_own(CENTER)?;
        let Some(mill) = self.cutter_of()? else { return Ok(Planned::default()) };
        let (length, width) = (self.given.length(FIRST_SIDE), self.given.length(SECOND_SIDE));
        if length <= width {
            return self.refuse(codes::P2090::slot_length_q218_mm_is_not_above(&length, &width));
        }
        let half = (length - width) / 2.0;
        let place = Place { at: center, turn: Deg(self.given.or_zero(TURN)) };
        self.slot_in_strokes(mill, (place, length), Shape::Slot { from: -half, to: half, width })
    }

    /// Cycle 211.
    pub fn reciprocating_bow(&self) -> Made<Planned> {
        let center = self.center_of_its_own(CENTER)?;
        let Some(mill) = self.cutter_of()? else { return Ok(Planned::default()) };
        let (radius, width) = (self.given.length(CIRCLE) / 2.0, self.given.length(SECOND_SIDE));
        let sweep = self.given.or_zero(OPENING);
        if sweep <= 0.0 || sweep >= 360.0 {
            return self.refuse(codes::P2090::opening_angle_q248_is_not_above_0(&sweep));
        }
        let place = Place { at: center, turn: Deg(self.given.or_zero(START_ANGLE)) };
        let length = radius * sweep * PI / 180.0 + width;
        self.slot_in_strokes(mill, (place, length), Shape::Bow { radius, sweep: Deg(sweep), width })
    }

    fn slot_in_strokes(&self, mill: Mill, (place, length): (Place, f64), shape: Shape) -> Made<Planned> {
        // Roughing takes the middle line; the rest stands on the wall.
        let wall = self.room(&shape, mill.radius)?;
        let size = 2.0 * mill.radius;
        let width = size + 2.0 * wall;
        if size < width / 3.0 - tolerance::SAME {
            return self.refuse(codes::K2942::tool_is_below_third_of_width(&size, &shown(width)));
        }
        if size >= length / 2.0 {
            let length = libm::round(length * 1e4) / 1e4;
            return self.refuse(codes::K2901::tool_is_not_below_half_of_slot(&size, &length));
        }
        let step = self.given.length(FINISHING_INFEED);
        let operation = self.given.whole(OPERATION);
        let finishes = operation != 1 && wall > tolerance::SAME;
        if operation == 2 && !finishes {
            self.say(codes::K8103::tool_is_as_wide_as_slot());
            return Ok(Planned::default());
        }
        let fall = if operation == 2 { mill.heights.step } else { self.fall_of_a_stroke(mill.heights.step) };
        let finish = Finish {
            wall: true,
            floor: false,
            feed: mill.feeds.plane,
            step,
            speed: None,
            onto: WallApproach::Semicircle,
            inserts: false,
        };
        let pocket = Pocket {
            counter_clockwise: self.climbs()?,
            width: mill.radius,
            // The strokes divide the depth.
            mill: Mill { heights: Heights { step: 0.0, ..mill.heights }, ..mill },
            shape,
            places: vec![place],
            allowance: wall,
            insertion: Insertion::Strokes { fall },
            strategy: Strategy::Levels,
            rough: operation != 2,
            finish: finishes.then_some(finish),
            cleared: None,
            transfer: None,
            between: LevelChange::Lifted,
            home: None,
        };
        let home = pocket.ends_in_the_middle().then(|| place.point(shape.middle()));
        self.milled(Pocket { home, ..pocket })
    }

    /// By `[cycles] q202`; without it the reading that is taken is said once.
    fn fall_of_a_stroke(&self, infeed: f64) -> f64 {
        match self.settings.cycles.klartext.strokes_in_pairs {
            Some(true) => return infeed / 2.0,
            Some(false) => return infeed,
            None => {}
        }
        let answer = Answer::key("cycles", "q202").one_of(&["\"stroke\"", "\"pair\""]);
        self.say_of_all(codes::K8142::each_stroke_falls_by_q202().answer(answer));
        infeed
    }
}
