//! How deep a hole goes where the tip of the drill counts, where drilling begins below the surface, and cycle 241.
//!
//! Source: K 6.1, and B2 of the cycles (docs/sources.md).

use libm::tan;

use crate::diag::{Answer, Fault, codes};
use crate::ir::cycle::drilling::{DeepHole, Entry, Levels, Method};
use crate::ir::function::{Coolant, Turn};

use super::cycles::DefinedCycle;
use super::cycles::drilling::{
    BY_DIAMETER, COOLANT_OFF, COOLANT_ON, DEEPENED, DEPTH_REFERENCE, DIAMETER, DRILLING_SPEED, DWELL_DEPTH,
    ENTRY_SPEED, ENTRY_TURN, FEED_PERCENT, PLUNGE, PREPOSITION, RETRACT_FEED, ROUGH_DIAMETER,
};
use super::cycles::{CLEARANCE, Cut, Q};
use super::{Outcome, Reported, Run};

/// What a hole by the diameter may be larger than its drill, mm.
const SAME: f64 = 1e-9;

impl Run<'_> {
    /// Depth of the tip from the surface, negative or 0.
    pub(super) fn hole_depth(&mut self, cycle: &DefinedCycle) -> Outcome<f64> {
        match self.cycle_option(cycle, BY_DIAMETER)? {
            0.0 => {}
            1.0 => return self.depth_by_diameter(cycle),
            other => return self.refuse_value(cycle, codes::P2090::q343_is_not_0_or_1(&other)),
        }
        let deep = self.depth_below(cycle)?;
        match self.cycle_option(cycle, DEPTH_REFERENCE)? {
            0.0 => Ok(deep),
            _ if deep == 0.0 => Ok(deep),
            1.0 => {
                let radius = self.tool_radius(self.block_span())?;
                Ok(deep - self.tip_height(cycle, radius, "a depth of the full diameter (Q395 = 1)")?)
            }
            other => self.refuse_value(cycle, codes::P2090::q395_is_not_0_or_1(&other)),
        }
    }

    /// Cycle 240 with Q343 = 1.
    fn depth_by_diameter(&mut self, cycle: &DefinedCycle) -> Outcome<f64> {
        let diameter = self.cycle_length(cycle, DIAMETER)?.abs();
        let tool = self.st.tool.active().and_then(super::active_tool::ActiveTool::effective_radius);
        if let Some(radius) = tool.filter(|radius| *radius > 0.0 && diameter > 2.0 * radius + SAME) {
            return self
                .refuse_value(cycle, codes::P2090::diameter_q344_is_larger_than_tool(&diameter, &(2.0 * radius)));
        }
        Ok(-self.tip_height(cycle, diameter / 2.0, "centring by the diameter (Q343 = 1)")?)
    }

    /// How far the tip lies in front of where the drill has this radius.
    fn tip_height(&mut self, cycle: &DefinedCycle, radius: f64, what: &str) -> Outcome<f64> {
        let tool = self.st.tool.active();
        if let Some(angle) = tool.and_then(|tool| tool.tip_angle).filter(|angle| *angle > 0.0 && *angle < 180.0) {
            return Ok(radius / tan(angle.to_radians() / 2.0));
        }
        let called = tool.map_or_else(|| "N".to_owned(), |tool| tool.called.clone());
        self.report(
            codes::K2941::cycle_needs_angle_at_tip_of_tool(&cycle.number, &what, &called)
                .answer(Answer::tool(&called, "tip_angle"))
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Err(Reported)
    }

    /// A length of 0 or more that newer software has; 0 where the definition does not set it.
    pub(super) fn cycle_open_length(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        let mm = self.level().frame.unit.mm();
        let value = self.cycle_option(cycle, q)? * mm;
        if value >= 0.0 { Ok(value) } else { self.refuse_value(cycle, codes::P2090::is_below_0(&q, &value)) }
    }

    /// Down to where the hole is open: Q379, or as wide as Q342.
    pub(super) fn hole_entry(&mut self, cycle: &DefinedCycle, levels: &Levels) -> Outcome<Option<Entry>> {
        let deepened = self.cycle_open_length(cycle, DEEPENED)?;
        let open = self.cycle_open_length(cycle, ROUGH_DIAMETER)?;
        let (height, what) = if deepened > 0.0 {
            if deepened >= levels.way() {
                return self.refuse_value(cycle, codes::P2090::deepened_start_q379_is_not_above_depth(&deepened));
            }
            if cycle.number == 205 {
                self.own_way_of(cycle, codes::K8141::with_deepened_start());
            }
            (levels.reference - deepened + self.cycle_length(cycle, CLEARANCE)?, "a deepened start")
        } else if open > 0.0 {
            (levels.reference - self.tip_height(cycle, open / 2.0, "a hole that is drilled already (Q342)")?, "Q342")
        } else {
            return Ok(None);
        };
        if height <= levels.depth {
            return self.refuse_value(cycle, codes::P2090::lies_below_depth_of_cycle(&what));
        }
        let feed = self.retract_feed(cycle, PREPOSITION, None)?;
        Ok(Some(Entry { height: height.min(levels.start_plane()), feed }))
    }

    /// Cycle 240.
    pub(super) fn centering(&mut self, _: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        Ok(Method::Drill { dwell: cut.dwell })
    }

    /// Cycle 241.
    pub(super) fn deep_hole(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        if self.cycle_option(cycle, DWELL_DEPTH)? != 0.0 {
            return self.refuse_cycle(cycle, codes::P9010::dwell_depth());
        }
        if cycle.sets(FEED_PERCENT) && self.cycle_number(cycle, FEED_PERCENT)? != 100.0 {
            return self.refuse_cycle(cycle, codes::P9010::another_feed_than_that_of_q206());
        }
        let depth = self.hole_depth(cycle)?.abs();
        let infeed = self.cycle_open_length(cycle, PLUNGE)?;
        if infeed > 0.0 && infeed < depth {
            return self.refuse_cycle(cycle, codes::P9010::pecking_is_not_supported(&infeed));
        }
        self.own_way_of(cycle, codes::K8141::spindle_drills_with_m3_at_q428());
        let entry = match self.cycle_number(cycle, ENTRY_TURN)? {
            3.0 => Some(Turn::Clockwise),
            4.0 => Some(Turn::CounterClockwise),
            5.0 => None,
            other => return self.refuse_value(cycle, codes::P2090::sense_q426_is_not_3_4(&other)),
        };
        let speeds = (self.cycle_number(cycle, ENTRY_SPEED)?, self.cycle_number(cycle, DRILLING_SPEED)?);
        let coolant = [self.coolant_of(cycle, COOLANT_ON, 8.0)?, self.coolant_of(cycle, COOLANT_OFF, 9.0)?];
        let back = self.retract_feed(cycle, RETRACT_FEED, Some(cut.feed))?;
        Ok(Method::Deep(DeepHole {
            dwell: cut.dwell,
            entry: (speeds.0, entry),
            drilling: (speeds.1, Turn::Clockwise),
            coolant,
            back,
        }))
    }

    fn coolant_of(&mut self, cycle: &DefinedCycle, q: Q, usual: f64) -> Outcome<Option<Coolant>> {
        match if cycle.sets(q) { self.cycle_number(cycle, q)? } else { usual } {
            0.0 => Ok(None),
            7.0 => Ok(Some(Coolant::Mist)),
            8.0 => Ok(Some(Coolant::Flood)),
            9.0 => Ok(Some(Coolant::Off)),
            other => self.refuse_cycle(cycle, codes::P9010::m_function_is_not_supported(&q, &other)),
        }
    }

    /// What a deep hole leaves of spindle and coolant.
    pub(super) fn leave_deep_hole(&mut self, hole: &DeepHole) {
        match hole.entry {
            (speed, Some(turn)) => {
                self.st.spindle.set_speed(speed);
                self.st.spindle.start(turn);
            }
            (_, None) => {
                self.st.spindle.set_speed(hole.drilling.0);
                self.st.spindle.stop();
            }
        }
        if let Some(last) = hole.coolant[1].or(hole.coolant[0]) {
            self.st.coolant = last != Coolant::Off;
        }
    }

    /// Says once a program and kind what is partc's own way in a cycle.
    pub(super) fn own_way_of(&mut self, cycle: &DefinedCycle, fault: Fault) {
        let found = fault.of(format_args!("cycle {}", cycle.number)).at(self.here.origin.loc);
        self.report_once(found.also(cycle.loc, "the cycle is defined here"));
    }
}
