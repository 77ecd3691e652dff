//! How deep a hole goes where the tip of the drill counts, where drilling begins below the surface, and cycle 241.
//!
//! Source: K 6.1, and B2 of the cycles (docs/sources.md).

use libm::tan;

use crate::diag::{Answer, Diagnostic, codes};
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
            other => return self.cycle_value(cycle, &format!("Q343 = {other} is not 0 or 1")),
        }
        let deep = self.depth_below(cycle)?;
        match self.cycle_option(cycle, DEPTH_REFERENCE)? {
            0.0 => Ok(deep),
            _ if deep == 0.0 => Ok(deep),
            1.0 => {
                let radius = self.tool_radius(self.block_span())?;
                Ok(deep - self.tip_height(cycle, radius, "a depth of the full diameter (Q395 = 1)")?)
            }
            other => self.cycle_value(cycle, &format!("Q395 = {other} is not 0 or 1")),
        }
    }

    /// Cycle 240 with Q343 = 1.
    fn depth_by_diameter(&mut self, cycle: &DefinedCycle) -> Outcome<f64> {
        let diameter = self.cycle_length(cycle, DIAMETER)?.abs();
        let tool = self.st.tool.active().and_then(super::active_tool::ActiveTool::effective_radius);
        if let Some(radius) = tool.filter(|radius| *radius > 0.0 && diameter > 2.0 * radius + SAME) {
            let message = format!("the diameter Q344 = {diameter} is larger than the tool of {} mm", 2.0 * radius);
            return self.cycle_value(cycle, &message);
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
        let message = format!("cycle {}: {what} needs the angle at the tip of tool {called} (T-ANGLE)", cycle.number);
        self.report(
            Diagnostic::new(codes::K2941, self.here.origin.loc, message)
                .also(cycle.loc, "the cycle is defined here")
                .help(Answer::tool(&called, "tip_angle").help(format!(
                    "give `[tools.{called}] tip_angle`, or T-ANGLE in the tool table: 118 for a common drill"
                ))),
        );
        Err(Reported)
    }

    /// A length of 0 or more that newer software has; 0 where the definition does not set it.
    pub(super) fn cycle_open_length(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        let mm = self.level().frame.unit.mm();
        let value = self.cycle_option(cycle, q)? * mm;
        if value >= 0.0 { Ok(value) } else { self.cycle_value(cycle, &format!("{q} = {value} is below 0")) }
    }

    /// Down to where the hole is open: Q379, or as wide as Q342.
    pub(super) fn hole_entry(&mut self, cycle: &DefinedCycle, levels: &Levels) -> Outcome<Option<Entry>> {
        let deepened = self.cycle_open_length(cycle, DEEPENED)?;
        let open = self.cycle_open_length(cycle, ROUGH_DIAMETER)?;
        let (height, what) = if deepened > 0.0 {
            if deepened >= levels.way() {
                let message = format!("the deepened start Q379 = {deepened} is not above the depth");
                return self.cycle_value(cycle, &message);
            }
            if cycle.number == 205 {
                self.way_of_cycle(cycle, "with a deepened start (Q379) the plunging depths count from there");
            }
            (levels.reference - deepened + self.cycle_length(cycle, CLEARANCE)?, "a deepened start")
        } else if open > 0.0 {
            (levels.reference - self.tip_height(cycle, open / 2.0, "a hole that is drilled already (Q342)")?, "Q342")
        } else {
            return Ok(None);
        };
        if height <= levels.depth {
            return self.cycle_value(cycle, &format!("{what} lies below the depth of the cycle"));
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
            return self.cycle_unbuilt(cycle, "a dwell depth (Q435)");
        }
        if cycle.sets(FEED_PERCENT) && self.cycle_number(cycle, FEED_PERCENT)? != 100.0 {
            return self.cycle_unbuilt(cycle, "another feed than that of Q206 (Q401)");
        }
        let depth = self.hole_depth(cycle)?.abs();
        let infeed = self.cycle_open_length(cycle, PLUNGE)?;
        if infeed > 0.0 && infeed < depth {
            return self.cycle_unbuilt(cycle, &format!("pecking (Q202 = {infeed})"));
        }
        self.way_of_cycle(cycle, "the spindle drills with M3 at Q428, and goes in and out as Q426 and Q427 say");
        let entry = match self.cycle_number(cycle, ENTRY_TURN)? {
            3.0 => Some(Turn::Clockwise),
            4.0 => Some(Turn::CounterClockwise),
            5.0 => None,
            other => return self.cycle_value(cycle, &format!("the sense Q426 = {other} is not 3, 4 or 5")),
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
            other => self.cycle_unbuilt(cycle, &format!("the M function {q} = {other}")),
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
    pub(super) fn way_of_cycle(&mut self, cycle: &DefinedCycle, what: &str) {
        let message = format!("cycle {}: {what}", cycle.number);
        if self.job.diags.first_text(codes::K8141, &message) {
            self.report(
                Diagnostic::new(codes::K8141, self.here.origin.loc, message)
                    .also(cycle.loc, "the cycle is defined here")
                    .help("docs/cycles.md describes it"),
            );
        }
    }
}
