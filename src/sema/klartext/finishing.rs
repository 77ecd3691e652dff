//! Walls of pockets and studs that are finished: 212 to 215.
//!
//! Source: K 6.5; F B3 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Deg;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::pocket::{Pocket, Shape};
use crate::ir::cycle::spigot::{self, Blank, Spigot};

use super::cycles::DefinedCycle;
use super::cycles::call::Call;
use super::cycles::finishing::ALLOWANCE;
use super::cycles::milling::{CORNER, DIAMETER, FIRST_SIDE, SECOND_SIDE};
use super::cycles::studs::RAW_DIAMETER;
use super::milling::Asked;
use super::studs::ASIDE;
use super::{Outcome, Run};

impl Run<'_> {
    /// Cycle 212.
    pub(super) fn finished_rectangle(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, place)) = self.finished_at(cycle, call)? else { return Ok(None) };
        let half = [self.above_zero(cycle, FIRST_SIDE)? / 2.0, self.above_zero(cycle, SECOND_SIDE)? / 2.0];
        let corner = self.not_below_zero(cycle, CORNER)?;
        let corner = self.corner_of(cycle, ("Q220", corner), mill.radius)?;
        let allowance = self.not_below_zero(cycle, ALLOWANCE)?;
        self.finished_wall(cycle, mill, (place, allowance), Shape::Rectangle { half, corner })
    }

    /// Cycle 214.
    pub(super) fn finished_circle(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, place)) = self.finished_at(cycle, call)? else { return Ok(None) };
        let radius = self.above_zero(cycle, DIAMETER)? / 2.0;
        let raw = self.not_below_zero(cycle, RAW_DIAMETER)? / 2.0;
        if raw >= radius {
            return self.refuse_value(cycle, codes::P2090::pocket_that_is_there());
        }
        self.finished_wall(cycle, mill, (place, radius - raw), Shape::Circle { radius })
    }

    /// Cycle 213.
    pub(super) fn finished_stud(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, place)) = self.finished_at(cycle, call)? else { return Ok(None) };
        let half = [self.above_zero(cycle, FIRST_SIDE)? / 2.0, self.above_zero(cycle, SECOND_SIDE)? / 2.0];
        let corner = self.not_below_zero(cycle, CORNER)?;
        let stock = self.not_below_zero(cycle, ALLOWANCE)?;
        let blank = Blank { reach: half[0] + stock, stock, aside: ASIDE };
        self.finished_round(cycle, mill, place, (spigot::Shape::Rectangle { half, corner }, blank))
    }

    /// Cycle 215.
    pub(super) fn finished_round_stud(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, place)) = self.finished_at(cycle, call)? else { return Ok(None) };
        let radius = self.above_zero(cycle, DIAMETER)? / 2.0;
        let raw = self.above_zero(cycle, RAW_DIAMETER)? / 2.0;
        if raw < radius {
            return self.refuse_value(cycle, codes::P2090::stud_that_is_there());
        }
        let blank = Blank { reach: raw, stock: raw - radius, aside: ASIDE };
        self.finished_round(cycle, mill, place, (spigot::Shape::Circle { radius }, blank))
    }

    fn finished_at(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<(Mill, Place)>> {
        let place = Place { at: self.center_of_its_own(cycle, call)?, turn: Deg(0.0) };
        Ok(self.cutter_of(cycle, call)?.map(|mill| (mill, place)))
    }

    fn finished_wall(
        &mut self,
        cycle: &DefinedCycle,
        mill: Mill,
        (place, allowance): (Place, f64),
        shape: Shape,
    ) -> Outcome<Option<Cycle>> {
        let (step, feed) = (mill.heights.step, mill.feeds.plane);
        let asked = Asked { rough: false, wall: true, floor: false, allowance, step, feed };
        let pocket = self.pocket(cycle, mill, asked, shape, (place, mill.radius))?;
        self.milled(cycle, Pocket { home: Some(place.at), ..pocket })
    }

    /// One circuit on each level.
    fn finished_round(
        &mut self,
        cycle: &DefinedCycle,
        mill: Mill,
        place: Place,
        (shape, blank): (spigot::Shape, Blank),
    ) -> Outcome<Option<Cycle>> {
        if blank.stock > 2.0 * mill.radius {
            let what = format!(
                "{} mm stand on the wall, and one circuit of the tool takes {} mm",
                blank.stock,
                2.0 * mill.radius
            );
            return self.tool_too_small(cycle, &what);
        }
        let spigot = Spigot {
            counter_clockwise: !self.climbs(cycle)?,
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
        Ok(Some(Cycle::Spigot(self.sound(cycle, spigot)?)))
    }
}
