//! Walls of pockets and studs that are finished: 212 to 215.
//!
//! Source: K 6.5; F B3 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Deg;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::pocket::{Pocket, Shape};
use crate::ir::cycle::spigot::{self, Blank, Spigot};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter};

use super::call::CycleCall;
use super::drilling::Q201;
use super::machining::Machining;
use super::milling::{CORNER, DIAMETER, FIRST_SIDE, Q202, Q206, Q207, SECOND_SIDE, cycle};
use super::patterns::CENTER;
use super::studs::{ASIDE, RAW_DIAMETER};
use super::{ABOVE_0, AT_SURFACE, Planned, Row, SECOND, SET_UP, q};

pub(in super::super) const ALLOWANCE: Name = Name::Q(221);

const Q216: Parameter = q(CENTER.0, Kind::Length, "centre along the first axis").needed();
const Q217: Parameter = q(CENTER.1, Kind::Length, "centre along the second axis").needed();
const Q218: Parameter = q(FIRST_SIDE, Kind::Length, "finished length along the first axis").needed().rule(ABOVE_0);
const Q219: Parameter = q(SECOND_SIDE, Kind::Length, "finished length along the second axis").needed().rule(ABOVE_0);
const Q221: Parameter =
    q(ALLOWANCE, Kind::Length, "what stands on the wall along the first axis").unsigned().default("0");
const Q223: Parameter = q(DIAMETER, Kind::Length, "finished diameter").needed().rule(ABOVE_0);

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
        |call| call.finished_rectangle(),
        parameters![
            Q218,
            Q219,
            q(CORNER, Kind::Length, "radius of the corners; the cutter's where that is larger").unsigned().default("0"),
            Q221
        ],
    ),
    cycle(
        213,
        "CYCL DEF 213",
        "STUD FINISHING",
        |call| call.finished_stud(),
        parameters![Q218, Q219, q(CORNER, Kind::Length, "radius of the corners").unsigned().default("0"), Q221],
    ),
    cycle(
        214,
        "CYCL DEF 214",
        "CIRCULAR POCKET FINISHING",
        |call| call.finished_circle(),
        parameters![q(RAW_DIAMETER, Kind::Length, "diameter of the pocket that is there").needed().unsigned(), Q223],
    ),
    cycle(
        215,
        "CYCL DEF 215",
        "CIRCULAR STUD FINISHING",
        |call| call.finished_round_stud(),
        parameters![q(RAW_DIAMETER, Kind::Length, "diameter of the stud that is there").needed().rule(ABOVE_0), Q223],
    ),
];

impl CycleCall<'_> {
    /// Cycle 212.
    pub fn finished_rectangle(&self) -> Made<Planned> {
        let Some((mill, place)) = self.finished_at()? else { return Ok(Planned::default()) };
        let half = [self.given.length(FIRST_SIDE) / 2.0, self.given.length(SECOND_SIDE) / 2.0];
        let corner = self.given.length(CORNER);
        let corner = self.corner_of(CORNER, corner, mill.radius);
        let allowance = self.given.length(ALLOWANCE);
        self.finished_wall(mill, (place, allowance), Shape::Rectangle { half, corner })
    }

    /// Cycle 214.
    pub fn finished_circle(&self) -> Made<Planned> {
        let Some((mill, place)) = self.finished_at()? else { return Ok(Planned::default()) };
        let radius = self.given.length(DIAMETER) / 2.0;
        let raw = self.given.length(RAW_DIAMETER) / 2.0;
        if raw >= radius {
            return self.refuse(codes::P2090::pocket_that_is_there());
        }
        self.finished_wall(mill, (place, radius - raw), Shape::Circle { radius })
    }

    /// Cycle 213.
    pub fn finished_stud(&self) -> Made<Planned> {
        let Some((mill, place)) = self.finished_at()? else { return Ok(Planned::default()) };
        let half = [self.given.length(FIRST_SIDE) / 2.0, self.given.length(SECOND_SIDE) / 2.0];
        let corner = self.given.length(CORNER);
        let stock = self.given.length(ALLOWANCE);
        let blank = Blank { reach: half[0] + stock, stock, aside: ASIDE };
        self.finished_round(mill, place, (spigot::Shape::Rectangle { half, corner }, blank))
    }

    /// Cycle 215.
    pub fn finished_round_stud(&self) -> Made<Planned> {
        let Some((mill, place)) = self.finished_at()? else { return Ok(Planned::default()) };
        let radius = self.given.length(DIAMETER) / 2.0;
        let raw = self.given.length(RAW_DIAMETER) / 2.0;
        if raw < radius {
            return self.refuse(codes::P2090::stud_that_is_there());
        }
        let blank = Blank { reach: raw, stock: raw - radius, aside: ASIDE };
        self.finished_round(mill, place, (spigot::Shape::Circle { radius }, blank))
    }

    fn finished_at(&self) -> Made<Option<(Mill, Place)>> {
        let place = Place { at: self.center_of_its_own(CENTER)?, turn: Deg(0.0) };
        Ok(self.cutter_of()?.map(|mill| (mill, place)))
    }

    fn finished_wall(&self, mill: Mill, (place, allowance): (Place, f64), shape: Shape) -> Made<Planned> {
        let (step, feed) = (mill.heights.step, mill.feeds.plane);
        let asked = Machining { rough: false, wall: true, floor: false, allowance, step, feed };
        let pocket = self.pocket(mill, asked, shape, (place, mill.radius))?;
        self.milled(Pocket { home: Some(place.at), ..pocket })
    }

    /// One circuit on each level.
    fn finished_round(&self, mill: Mill, place: Place, (shape, blank): (spigot::Shape, Blank)) -> Made<Planned> {
        if blank.stock > 2.0 * mill.radius {
            let takes = 2.0 * mill.radius;
            return self.refuse(codes::K2942::more_stands_than_one_circuit_takes(&blank.stock, &takes));
        }
        let spigot = Spigot {
            counter_clockwise: !self.climbs()?,
            width: None,
            mill,
            place,
            shape,
            allowance: 0.0,
            blank,
            finishes_floor: false,
            rough: true,
            finish: None,
        };
        Ok(Cycle::Spigot(self.sound(spigot)?).into())
    }
}
