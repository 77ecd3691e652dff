//! Studs: 256 and 257.
//!
//! Source: K 6.5 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Deg;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::spigot::{Blank, Finish, Shape, Spigot};

use super::cycles::DefinedCycle;
use super::cycles::call::Call;
use super::cycles::milling::{CORNER, DIAMETER, FIRST_SIDE, OPERATION, SECOND_SIDE, TURN};
use super::cycles::pockets::START_ANGLE;
use super::cycles::studs::{APPROACH, RAW, RAW_DIAMETER};
use super::milling::Asked;
use super::{Outcome, Run};

/// Beside the blank the tool goes down so far away, mm.
pub(super) const ASIDE: f64 = 2.0;

impl Run<'_> {
    /// Cycle 256.
    pub(super) fn rectangular_stud(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, asked)) = self.stud_of(cycle, call)? else { return Ok(None) };
        let half = [self.above_zero(cycle, FIRST_SIDE)? / 2.0, self.above_zero(cycle, SECOND_SIDE)? / 2.0];
        let raw = [self.above_zero(cycle, RAW.0)? / 2.0, self.above_zero(cycle, RAW.1)? / 2.0];
        let over = [raw[0] - half[0], raw[1] - half[1]];
        if over.iter().any(|way| *way < -1e-9) {
            return self.refuse_value(cycle, codes::P2090::blank_q424());
        }
        let corner = self.optional_length(cycle, CORNER)?;
        if corner < 0.0 {
            return self.refuse_cycle(cycle, codes::P9010::chamfer_at_corners_is_not_supported(&corner));
        }
        let approach = self.choice(cycle, APPROACH, 4)?;
        if approach != 0 {
            return self.refuse_cycle(cycle, codes::P9010::approach_at_corner_is_not_supported(&approach));
        }
        let turn = Deg(self.cycle_option(cycle, TURN)?);
        let to_middle = self.way_to_middle(cycle, half)?;
        let place = Place { at: Place { at: self.call_point(cycle)?, turn }.point(to_middle), turn };
        // The corner of the blank is the farthest from the round one of the stud.
        let stock = libm::hypot(over[0].max(0.0) + corner, over[1].max(0.0) + corner) - corner;
        let blank = Blank { reach: raw[0], stock, aside: ASIDE };
        self.stud(cycle, (mill, asked), place, Shape::Rectangle { half, corner }, blank)
    }

    /// Cycle 257.
    pub(super) fn circular_stud(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, asked)) = self.stud_of(cycle, call)? else { return Ok(None) };
        let radius = self.above_zero(cycle, DIAMETER)? / 2.0;
        let raw = self.above_zero(cycle, RAW_DIAMETER)? / 2.0;
        if raw < radius - 1e-9 {
            return self.refuse_value(cycle, codes::P2090::blank_q222_is_smaller_than_stud());
        }
        let angle = if cycle.gives_q(START_ANGLE) { self.cycle_number(cycle, START_ANGLE)? } else { -1.0 };
        if angle != -1.0 && !(0.0..=359.0).contains(&angle) {
            return self.refuse_value(cycle, codes::P2090::angle_of_approach_q376_is_not_1(&angle));
        }
        let place = Place { at: self.call_point(cycle)?, turn: Deg(angle.max(0.0)) };
        let blank = Blank { reach: raw, stock: raw - radius, aside: ASIDE };
        self.stud(cycle, (mill, asked), place, Shape::Circle { radius }, blank)
    }

    /// What both take; older definitions have no Q215 and rough.
    fn stud_of(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<(Mill, Asked)>> {
        let Some(mill) = self.cutter_of(cycle, call)? else { return Ok(None) };
        let Some(asked) = self.asked(cycle, &mill)? else { return Ok(None) };
        let asked = if cycle.gives_q(OPERATION) { asked } else { Asked { wall: false, floor: false, ..asked } };
        Ok(Some((mill, asked)))
    }

    fn stud(
        &mut self,
        cycle: &DefinedCycle,
        (mill, asked): (Mill, Asked),
        place: Place,
        shape: Shape,
        blank: Blank,
    ) -> Outcome<Option<Cycle>> {
        let Asked { rough, wall, floor, allowance, step, feed } = asked;
        if wall && blank.stock > 2.0 * mill.radius {
            self.finishing_meets_roughing(cycle, (allowance, 2.0 * mill.radius), mill.radius)?;
        }
        if floor {
            self.floor_in_one_cut(cycle, &mill)?;
        }
        let spigot = Spigot {
            counter_clockwise: !self.climbs(cycle)?,
            width: Some(self.overlap(cycle, mill.radius)?),
            mill,
            place,
            shape,
            allowance,
            blank,
            finishes_floor: false,
            rough,
            finish: (wall || floor).then_some(Finish { wall, floor, feed, step }),
        };
        Ok(Some(Cycle::Spigot(self.sound(cycle, spigot)?)))
    }
}
