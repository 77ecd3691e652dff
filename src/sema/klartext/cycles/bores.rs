//! Bore milling: cycle 208.
//!
//! Source: F B1 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::tolerance;
use crate::geo::{Deg, parts};
use crate::ir::cycle::milling::{Feeds, Place};
use crate::ir::cycle::{BoreMilling, Cycle};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter};

use super::call::CycleCall;
use super::drilling::{FEED, Q201, ROUGH_DIAMETER};
use super::milling::{OVERLAP, Q351, cycle};
use super::{ABOVE_0, AT_SURFACE, Planned, Row, SECOND, SET_UP, q};

pub(in super::super) const TURN_INFEED: Name = Name::Q(334);
pub(in super::super) const NOMINAL: Name = Name::Q(335);

pub(super) const DIAMETER: Parameter = q(NOMINAL, Kind::Length, "nominal diameter").needed().rule(ABOVE_0);

pub(super) const ROWS: &[Row] = &[cycle(
    208,
    "CYCL DEF 208",
    "BORE MILLING",
    |call| call.bore_milling(),
    &[
        SET_UP,
        Q201,
        q(FEED, Kind::Feed, "feed on the helix").needed(),
        q(TURN_INFEED, Kind::Length, "infeed of a turn").needed().rule(ABOVE_0),
        AT_SURFACE,
        SECOND,
        DIAMETER,
        q(ROUGH_DIAMETER, Kind::Length, "diameter that is drilled already").unsigned().default("0"),
        Parameter { needed: false, ..Q351 }.default("+1"),
        q(OVERLAP, Kind::Number, "width of a cut in radii of the cutter, 0.1 to 1.9999").default("one circle"),
    ],
)];

/// A smaller circle of the centre is none: the tool goes straight down, mm.
const STRAIGHT: f64 = 1e-5;

impl CycleCall<'_> {
    /// Cycle 208.
    pub fn bore_milling(&self) -> Made<Planned> {
        let options = self.settings.cycles.klartext;
        let feed = self.feed(FEED)?;
        let Some(mill) = self.round_cutter(Feeds { plane: feed, depth: feed })? else { return Ok(Planned::default()) };
        let pitch = self.given.length(TURN_INFEED);
        let size = self.given.length(NOMINAL) / 2.0;
        let circles = self.circles_of_bore(size, mill.radius)?;
        let climbs = self.climbs()?;
        let from = if options.helix_from_surface { mill.heights.reference } else { mill.heights.safe() };
        let place = Place { at: self.call_point()?, turn: Deg(0.0) };
        let bore = BoreMilling {
            mill,
            place,
            circles,
            pitch,
            counter_clockwise: climbs,
            from,
            straight: options.straight_entry,
        };
        Ok(Cycle::BoreMilling(self.sound(bore)?).into())
    }

    /// Radii of the circles of the centre, from inside out.
    fn circles_of_bore(&self, size: f64, radius: f64) -> Made<Vec<f64>> {
        let drilled = self.given.length(ROUGH_DIAMETER) / 2.0;
        if size < radius - tolerance::LOST {
            return self.refuse(codes::K2901::hole_is_smaller(&(2.0 * size), &(2.0 * radius)));
        }
        if drilled >= size {
            return self.refuse(codes::P2090::drilled_hole_q342_is_not_smaller(&(2.0 * drilled)));
        }
        if size < radius + STRAIGHT {
            return Ok(Vec::new());
        }
        let given = self.given.or_zero(OVERLAP) != 0.0;
        // Radius of what one circle leaves in the middle.
        let left = size - 2.0 * radius;
        if !given && (left <= tolerance::LOST || drilled > 0.0 && drilled >= left - tolerance::LOST) {
            return Ok(vec![size - radius]);
        }
        if !given && drilled == 0.0 {
            // The control refuses more than two diameters of the tool.
            return self.refuse(codes::K2942::hole_is_over_two_diameters(&(2.0 * size), &(2.0 * radius)));
        }
        let width = if given { self.overlap(radius)? } else { radius };
        // A helix in the solid leaves no core.
        let width = if drilled < radius { width.min(radius) } else { width };
        let base = drilled.max(radius);
        let count = parts::count(size - base, width).max(1.0);
        if count == 1.0 {
            return Ok(vec![size - radius]);
        }
        if !self.settings.cycles.klartext.bore_in_rings {
            let fault = codes::K9040::order_of_circles_is_open(&(2.0 * size));
            return self.refuse(fault.answer(Answer::key("cycles", "cycle_208_rings").one_of(&["true"])));
        }
        if count > 1000.0 {
            return self.refuse(codes::P2090::overlap_q370_makes_more_than_1000_circles());
        }
        let step = (size - base) / count;
        Ok((1..=count as u32).map(|i| base - radius + step * f64::from(i)).collect())
    }
}
