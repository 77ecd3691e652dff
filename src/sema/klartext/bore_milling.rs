//! Cycle 208: its parameters become a [`BoreMilling`].
//!
//! Source: F B1 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, parts};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place};
use crate::ir::cycle::{BoreMilling, Cycle};

use super::cycles::DefinedCycle;
use super::cycles::bores::{NOMINAL, TURN_INFEED};
use super::cycles::call::Call;
use super::cycles::drilling::{FEED, ROUGH_DIAMETER};
use super::cycles::milling::{CLIMB, OVERLAP};
use super::{Outcome, Reported, Run};

/// What arithmetic may lose at a size, mm.
const SAME: f64 = 1e-9;
/// A smaller circle of the centre is none: the tool goes straight down, mm.
const STRAIGHT: f64 = 1e-5;

impl Run<'_> {
    /// The cutter of a cycle that has one level; nothing where the depth is 0.
    pub(super) fn round_cutter(&mut self, cycle: &DefinedCycle, call: Call, feeds: Feeds) -> Outcome<Option<Mill>> {
        let radius = self.cutter_radius(cycle)?;
        let heights = self.heights(cycle, call.shift)?;
        let deep = self.depth_below(cycle)?;
        if deep == 0.0 {
            self.has_no_depth(cycle);
            return Ok(None);
        }
        let heights = Heights {
            retract: call.retract.height(&heights),
            reference: heights.surface,
            clearance: heights.clearance,
            depth: heights.surface + deep,
            step: 0.0,
            division: Division::Even,
            allowance: 0.0,
        };
        Ok(Some(Mill { plane: self.st.plane(), heights, radius, feeds }))
    }

    /// Cycle 208.
    pub(super) fn bore_milling(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let options = self.job.settings.cycles.klartext;
        let feed = self.cycle_feed(cycle, FEED, None)?;
        let Some(mill) = self.round_cutter(cycle, call, Feeds { plane: feed, depth: feed })? else { return Ok(None) };
        let pitch = self.above_zero(cycle, TURN_INFEED)?;
        let size = self.above_zero(cycle, NOMINAL)? / 2.0;
        let circles = self.circles_of_bore(cycle, size, mill.radius)?;
        let climbs = if cycle.sets(CLIMB) { self.climbs(cycle)? } else { true };
        let from = if options.helix_from_surface { mill.heights.reference } else { mill.heights.safe() };
        let place = Place { at: self.call_point(cycle)?, turn: Deg(0.0) };
        let bore = BoreMilling {
            mill,
            place,
            circles,
            pitch,
            counter_clockwise: climbs,
            from,
            straight: options.straight_entry,
        };
        Ok(Some(Cycle::BoreMilling(self.sound(cycle, bore)?)))
    }

    /// Radii of the circles of the centre, from inside out.
    fn circles_of_bore(&mut self, cycle: &DefinedCycle, size: f64, radius: f64) -> Outcome<Vec<f64>> {
        let drilled = self.cycle_open_length(cycle, ROUGH_DIAMETER)? / 2.0;
        if size < radius - SAME {
            return self.tool_too_large(
                cycle,
                &format!("the hole has {} mm (Q335), and the tool {} mm", 2.0 * size, 2.0 * radius),
            );
        }
        if drilled >= size {
            return self.refuse_value(cycle, codes::P2090::drilled_hole_q342_is_not_smaller(&(2.0 * drilled)));
        }
        if size < radius + STRAIGHT {
            return Ok(Vec::new());
        }
        let given = self.cycle_option(cycle, OVERLAP)? != 0.0;
        // Radius of what one circle leaves in the middle.
        let left = size - 2.0 * radius;
        if !given && (left <= SAME || drilled > 0.0 && drilled >= left - SAME) {
            return Ok(vec![size - radius]);
        }
        if !given && drilled == 0.0 {
            return self.bore_too_wide(cycle, size, radius);
        }
        let width = if given { self.overlap(cycle, radius)? } else { radius };
        // A helix in the solid leaves no core.
        let width = if drilled < radius { width.min(radius) } else { width };
        let base = drilled.max(radius);
        let count = parts::count(size - base, width).max(1.0);
        if count == 1.0 {
            return Ok(vec![size - radius]);
        }
        if !self.job.settings.cycles.klartext.bore_in_rings {
            self.report(
                codes::K9040::cycle_208(&(2.0 * size))
                    .answer(Answer::key("cycles", "cycle_208_rings").one_of(&["true"]))
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
            return Err(Reported);
        }
        if count > 1000.0 {
            return self.refuse_value(cycle, codes::P2090::overlap_q370_makes_more_than_1000_circles());
        }
        let step = (size - base) / count;
        Ok((1..=count as u32).map(|i| base - radius + step * f64::from(i)).collect())
    }

    /// The control refuses a hole of more than two diameters of the tool.
    fn bore_too_wide<T>(&mut self, cycle: &DefinedCycle, size: f64, radius: f64) -> Outcome<T> {
        self.report(
            codes::K2942::cycle_208(&(2.0 * size), &(2.0 * radius))
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Err(Reported)
    }

    /// The tool is smaller than the cycle asks for.
    pub(super) fn tool_too_small<T>(&mut self, cycle: &DefinedCycle, what: &str) -> Outcome<T> {
        self.report(
            codes::K2942::cycle_tool_radius_too_small(&cycle.number, &what)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Err(Reported)
    }
}
