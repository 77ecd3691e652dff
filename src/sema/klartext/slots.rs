//! Slots that are milled to and fro on falling strokes: 210 and 211.
//!
//! Source: K 6.5; F B3 (docs/sources.md).

use core::f64::consts::PI;

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::milling::{Heights, Mill, Place};
use crate::ir::cycle::pocket::{Between, Finish, Insertion, Onto, Pocket, Shape, Strategy};

use super::cycles::DefinedCycle;
use super::cycles::call::{By, Call};
use super::cycles::milling::{FINISHING_INFEED, FIRST_SIDE, OPERATION, SECOND_SIDE, TURN};
use super::cycles::patterns::{CENTER, CIRCLE, START_ANGLE};
use super::cycles::pockets::OPENING;
use super::pockets::rounded;
use super::{Outcome, Run};

/// A wall that stands out by less is none, mm.
const NOTHING: f64 = 1e-6;

impl Run<'_> {
    /// Cycle 210.
    pub(super) fn reciprocating_slot(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let center = self.center_of_its_own(cycle, call)?;
        let Some(mill) = self.cutter_of(cycle, call)? else { return Ok(None) };
        let (length, width) = (self.above_zero(cycle, FIRST_SIDE)?, self.above_zero(cycle, SECOND_SIDE)?);
        if length <= width {
            return self.refuse_value(cycle, codes::P2090::slot_length_q218_mm_is_not_above(&length, &width));
        }
        let half = (length - width) / 2.0;
        let place = Place { at: center, turn: Deg(self.cycle_option(cycle, TURN)?) };
        self.slot_in_strokes(cycle, mill, (place, length), Shape::Slot { from: -half, to: half, width })
    }

    /// Cycle 211.
    pub(super) fn reciprocating_bow(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let center = self.center_of_its_own(cycle, call)?;
        let Some(mill) = self.cutter_of(cycle, call)? else { return Ok(None) };
        let (radius, width) = (self.above_zero(cycle, CIRCLE)? / 2.0, self.above_zero(cycle, SECOND_SIDE)?);
        let sweep = self.cycle_number(cycle, OPENING)?;
        if sweep <= 0.0 || sweep >= 360.0 {
            return self.refuse_value(cycle, codes::P2090::opening_angle_q248_is_not_above_0(&sweep));
        }
        let place = Place { at: center, turn: Deg(self.cycle_number(cycle, START_ANGLE)?) };
        let length = radius * sweep * PI / 180.0 + width;
        self.slot_in_strokes(cycle, mill, (place, length), Shape::Bow { radius, sweep: Deg(sweep), width })
    }

    /// The place that a cycle names itself: it runs there wherever CYCL CALL POS takes the tool, and a pattern has nothing
    /// to say.
    pub(super) fn center_of_its_own(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Point2> {
        if call.by == By::Pattern {
            return self.refuse_cycle(cycle, codes::P9010::pattern_with_centre_of_its_own());
        }
        Ok(Point2::new(self.cycle_length(cycle, CENTER.0)?, self.cycle_length(cycle, CENTER.1)?))
    }

    fn slot_in_strokes(
        &mut self,
        cycle: &DefinedCycle,
        mill: Mill,
        (place, length): (Place, f64),
        shape: Shape,
    ) -> Outcome<Option<Cycle>> {
        // Roughing takes the middle line; the rest stands on the wall.
        let wall = self.fits(cycle, &shape, mill.radius)?;
        let size = 2.0 * mill.radius;
        let width = size + 2.0 * wall;
        if size < width / 3.0 - NOTHING {
            let what = format!("the tool of {size} mm is below a third of the width Q219 = {} mm", rounded(width));
            return self.tool_too_small(cycle, &what);
        }
        if size >= length / 2.0 {
            let length = libm::round(length * 1e4) / 1e4;
            let what = format!("the tool of {size} mm is not below half of the length {length} mm of the slot");
            return self.tool_too_large(cycle, &what);
        }
        let step = self.not_below_zero(cycle, FINISHING_INFEED)?;
        let operation = self.choice(cycle, OPERATION, 2)?;
        let finishes = operation != 1 && wall > NOTHING;
        if operation == 2 && !finishes {
            self.nothing_to_finish(cycle, "Q215 = 2 finishes the wall, and the tool is as wide as the slot");
            return Ok(None);
        }
        let fall = if operation == 2 { mill.heights.step } else { self.fall_of_a_stroke(cycle, mill.heights.step) };
        let finish = Finish {
            wall: true,
            floor: false,
            feed: mill.feeds.plane,
            step,
            speed: None,
            onto: Onto::Semicircle,
            inserts: false,
        };
        let pocket = Pocket {
            counter_clockwise: self.climbs(cycle)?,
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
            between: Between::Lifted,
            home: None,
        };
        let home = pocket.ends_in_the_middle().then(|| place.point(shape.middle()));
        self.milled(cycle, Pocket { home, ..pocket })
    }

    /// By `[cycles] q202`; without it the reading that is taken is said once.
    fn fall_of_a_stroke(&mut self, cycle: &DefinedCycle, infeed: f64) -> f64 {
        match self.job.settings.cycles.klartext.strokes_in_pairs {
            Some(true) => return infeed / 2.0,
            Some(false) => return infeed,
            None => {}
        }
        self.report_once(
            codes::K8142::cycle_each_stroke_falls_by_q202(&cycle.number)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here")
                .help(
                    Answer::key("cycles", "q202")
                        .one_of(&["\"stroke\"", "\"pair\""])
                        .help("say which by `[cycles] q202 = \"stroke\"` or `\"pair\"`"),
                ),
        );
        infeed
    }
}
