//! How deep a hole goes where the tip of the drill counts, where drilling begins below the surface, and cycle 241.
//!
//! Source: K 6.1, and B2 of the cycles (docs/sources.md).

use crate::geo::tolerance;
use core::fmt::Display;

use crate::diag::fault::Asking;
use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::cycle::drilling::{DeepHole, Entry, Levels, Method, tip_height};
use crate::ir::function::{Coolant, Turn};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

use super::call::CycleCall;
use super::drilling::{
    BY_DIAMETER, COOLANT_OFF, COOLANT_ON, DEEPENED, DEPTH_REFERENCE, DIAMETER, DRILLING_SPEED, DWELL_DEPTH,
    ENTRY_SPEED, ENTRY_TURN, FEED_PERCENT, PLUNGE, PREPOSITION, RETRACT_FEED, ROUGH_DIAMETER,
};
use super::{CLEARANCE, Cut};

impl CycleCall<'_> {
    /// Q343: does the diameter on the surface say how deep it goes?
    pub fn is_by_diameter(&self) -> bool {
        self.given.whole(BY_DIAMETER) == 1
    }

    /// Depth of the tip from the surface, negative or 0.
    pub fn hole_depth(&self) -> Made<f64> {
        if self.is_by_diameter() {
            return self.depth_by_diameter();
        }
        let deep = self.depth()?;
        if deep == 0.0 || self.given.whole(DEPTH_REFERENCE) == 0 {
            return Ok(deep);
        }
        Ok(deep - self.tip_height(self.tool_radius()?, codes::K2941::depth_of_full_diameter)?)
    }

    /// Cycle 240 with Q343 = 1.
    fn depth_by_diameter(&self) -> Made<f64> {
        let diameter = self.required(DIAMETER)?.abs();
        let tool = self.st.state.tool.active().and_then(|tool| tool.effective_radius());
        if let Some(radius) = tool.filter(|radius| *radius > 0.0 && diameter > 2.0 * radius + tolerance::LOST) {
            return self.refuse(codes::P2090::diameter_q344_is_larger_than_tool(&diameter, &(2.0 * radius)));
        }
        Ok(-self.tip_height(diameter / 2.0, codes::K2941::centring_by_diameter)?)
    }

    /// How far the tip lies in front of where the drill has this radius.
    fn tip_height(&self, radius: f64, missing: fn(&dyn Display) -> Asking) -> Made<f64> {
        let tool = self.st.state.tool.active();
        if let Some(angle) = tool.and_then(|tool| tool.tip_angle).filter(|angle| *angle > 0.0 && *angle < 180.0) {
            return Ok(tip_height(radius, Deg(angle)));
        }
        let called = tool.map_or("N", |tool| tool.called.as_str());
        self.refuse(missing(&called).answer(Answer::tool(called, "tip_angle")))
    }

    /// Down to where the hole is open: Q379, or as wide as Q342.
    pub fn hole_entry(&self, levels: &Levels) -> Made<Option<Entry>> {
        let (deepened, open) = (self.given.length(DEEPENED), self.given.length(ROUGH_DIAMETER));
        let (height, low) = if deepened > 0.0 {
            if deepened >= levels.way() {
                return self.refuse(codes::P2090::deepened_start_q379_is_not_above_depth(&deepened));
            }
            if self.st.cycle.number == 205 {
                self.say_of_all(codes::K8141::with_deepened_start());
            }
            let height = levels.reference - deepened + self.given.length(CLEARANCE);
            (height, codes::P2090::deepened_start_lies_below_depth())
        } else if open > 0.0 {
            let tip = self.tip_height(open / 2.0, codes::K2941::hole_is_drilled_already)?;
            (levels.reference - tip, codes::P2090::open_hole_q342_lies_below_depth())
        } else {
            return Ok(None);
        };
        if height <= levels.depth {
            return self.refuse(low);
        }
        if !self.given.has(PREPOSITION) {
            return self.refuse(codes::P2090::is_missing(&PREPOSITION));
        }
        let feed = self.retract_feed(PREPOSITION, None)?;
        Ok(Some(Entry { height: height.min(levels.start_plane()), feed }))
    }

    /// Cycle 241.
    pub fn deep_hole(&self, cut: Cut) -> Made<Method> {
        if self.given.or_zero(DWELL_DEPTH) != 0.0 {
            return self.refuse(codes::P9010::dwell_depth());
        }
        if self.given.number(FEED_PERCENT).is_some_and(|percent| percent != 100.0) {
            return self.refuse(codes::P9010::another_feed_than_that_of_q206());
        }
        let infeed = self.given.length(PLUNGE);
        if infeed > 0.0 && infeed < self.hole_depth()?.abs() {
            return self.refuse(codes::P9010::pecking_is_not_supported(&infeed));
        }
        self.say_of_all(codes::K8141::spindle_drills_with_m3_at_q428());
        let entry = match self.given.whole(ENTRY_TURN) {
            3 => Some(Turn::Clockwise),
            4 => Some(Turn::CounterClockwise),
            _ => None,
        };
        Ok(Method::Deep(DeepHole {
            dwell: cut.dwell,
            entry: (self.given.or_zero(ENTRY_SPEED), entry),
            drilling: (self.given.or_zero(DRILLING_SPEED), Turn::Clockwise),
            coolant: [self.coolant(COOLANT_ON, 8.0)?, self.coolant(COOLANT_OFF, 9.0)?],
            back: self.retract_feed(RETRACT_FEED, Some(cut.feed))?,
        }))
    }

    fn coolant(&self, name: Name, usual: f64) -> Made<Option<Coolant>> {
        match self.given.number(name).unwrap_or(usual) {
            0.0 => Ok(None),
            7.0 => Ok(Some(Coolant::Mist)),
            8.0 => Ok(Some(Coolant::Flood)),
            9.0 => Ok(Some(Coolant::Off)),
            other => self.refuse(codes::P9010::m_function_is_not_supported(&name, &other)),
        }
    }
}
