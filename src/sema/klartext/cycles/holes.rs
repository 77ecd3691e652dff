//! Drilling and tapping: what their parameters make of a hole.
//!
//! Source: K 4.4, 6.0 to 6.2 (docs/sources.md). The parameters Q200 and up stay variables: a call takes what they hold
//! then. The values of the old dotted cycles are those of the definition.

use crate::diag::codes;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{
    AdvancedStop, Bore, Breaks, Degression, Levels, Method, Pecking, Removal, Tap, usual_ahead,
};
use crate::ir::cycle::{Cycle, Drilling as Hole};
use crate::ir::function::{Spindle, Turn};
use crate::machine::{Axis, AxisSet};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

use super::call::{CycleCall, Instead};
use super::drilling::{
    AHEAD_ABOVE, AHEAD_BELOW, ANGLE, BREAK_DEPTH, BREAK_WAY, BREAKS, DECREMENT, DEEPENED, DIRECTION, DWELL_ABOVE,
    LEAST_PLUNGE, PITCH, PLUNGE, RETRACT_FEED,
};
use super::{CLEARANCE, Cut, Drilling, Planned};

/// Way by which cycle 202 lifts the edge off the wall, in mm.
const LIFT: f64 = 0.2;
/// The feed of a hole whose pitch makes it.
const NO_FEED: Feed = Feed::PerMinute(1.0);

/// Parts that all old cycles have.
pub(in super::super) const OLD_CLEARANCE: Name = Name::Part(1);
const OLD_DEPTH: Name = Name::Part(2);
/// The pecking depth of cycle 1, the pitch of cycle 17.
const OLD_STEP: Name = Name::Part(3);

impl CycleCall<'_> {
    /// A hole where the tool stands.
    pub fn hole(&self, drilling: &Drilling) -> Made<Planned> {
        let axis = self.st.state.axis();
        if !AxisSet::MAIN.contains(axis) {
            return self.refuse(codes::P2090::tool_axis_cannot_drill(&axis.letter()));
        }
        let levels =
            if self.given.takes(OLD_CLEARANCE) { Some(self.old_levels(axis)?) } else { self.levels_of_hole()? };
        let Some(levels) = levels else { return Ok(Planned::default()) };
        let feed = drilling.feed.map_or(Ok(NO_FEED), |name| self.feed(name))?;
        let dwell = drilling.dwell.map_or(Ok(0.0), |name| self.dwell(name))?;
        let method = (drilling.method)(self, Cut { feed, dwell })?;
        let entry = self.hole_entry(&levels)?;
        Ok(Cycle::Drilling(self.sound(Hole { axis, levels, feed, entry, method })?).into())
    }

    /// Nothing where the depth is 0.
    fn levels_of_hole(&self) -> Made<Option<Levels>> {
        let heights = self.heights();
        let deep = self.hole_depth()?;
        if deep == 0.0 {
            self.without_depth();
            return Ok(None);
        }
        Ok(Some(Levels {
            retract: self.st.calling.retract.height(&heights),
            reference: heights.surface,
            clearance: heights.clearance,
            depth: heights.surface + deep,
        }))
    }

    /// Cycles 1 to 5 and 17: the tool stands at the set-up clearance and comes back to it.
    pub fn old_levels(&self, axis: Axis) -> Made<Levels> {
        let start = self.position(axis)?;
        // The signs of the set-up clearance and the pecking depth have no meaning: old programs give all the same.
        let (clearance, deep) = (self.given.magnitude(OLD_CLEARANCE), self.given.length(OLD_DEPTH));
        if deep > 0.0 {
            return self.refuse(codes::P2090::depth_is_positive());
        }
        if deep == 0.0 {
            return self.refuse(codes::P2090::depth_is_0());
        }
        let reference = start - clearance;
        Ok(Levels { retract: start, reference, clearance, depth: reference + deep })
    }

    /// Where an axis stands.
    pub fn position(&self, axis: Axis) -> Made<f64> {
        match self.st.state.position.programmed(axis) {
            Some(at) => Ok(at),
            None => self.without(Instead::Position(axis)),
        }
    }

    // Methods.

    /// Cycle 1.
    pub fn old_pecking(&self, cut: Cut) -> Made<Method> {
        let mut peck = steps(self.given.magnitude(OLD_STEP), (0.0, 0.0), cut.dwell);
        peck.removal.ahead = AdvancedStop::Evenly([usual_ahead(self.given.magnitude(OLD_DEPTH)); 2]);
        Ok(Method::Peck(peck))
    }

    /// Cycle 17.
    pub fn old_rigid_tapping(&self, cut: Cut) -> Made<Method> {
        Ok(self.tapping(cut, Some(self.given.length(OLD_STEP))))
    }

    /// Cycle 200: out of the hole after every step.
    pub fn drilling(&self, cut: Cut) -> Made<Method> {
        let mut peck = steps(self.given.length(PLUNGE), (0.0, 0.0), cut.dwell);
        peck.removal.dwell = self.dwell(DWELL_ABOVE)?;
        peck.removal.ahead = AdvancedStop::Evenly([self.given.length(CLEARANCE); 2]);
        Ok(Method::Peck(peck))
    }

    /// Cycle 201.
    pub fn reaming(&self, cut: Cut) -> Made<Method> {
        Ok(Method::Ream { dwell: cut.dwell, back: self.feed_or(RETRACT_FEED, Some(cut.feed))? })
    }

    /// Cycle 202.
    pub fn boring(&self, cut: Cut) -> Made<Method> {
        let lift = match self.given.whole(DIRECTION) {
            1 => [-LIFT, 0.0, 0.0],
            2 => [0.0, -LIFT, 0.0],
            3 => [LIFT, 0.0, 0.0],
            4 => [0.0, LIFT, 0.0],
            _ => [0.0; 3],
        };
        let back = self.retract_feed(RETRACT_FEED, Some(cut.feed))?;
        // Whole turns more or less are the same angle, and the target takes 0 to 360.
        let angle = self.given.or_zero(ANGLE);
        let orient = if (0.0..=360.0).contains(&angle) { angle } else { angle.rem_euclid(360.0) };
        if lift != [0.0; 3] {
            if *self.st.state.ctx.frame.linear() != nalgebra::Matrix3::identity() {
                return self.refuse(codes::P9010::lifting_edge_off_wall_under_mirror());
            }
            self.call_point()?;
        }
        let turn = self.st.state.spindle.turn().unwrap_or(Turn::Clockwise);
        Ok(Method::Bore(Bore { dwell: cut.dwell, turn, orient, back, lift }))
    }

    /// Cycle 203.
    pub fn universal(&self, cut: Cut) -> Made<Method> {
        let times = self.given.whole(BREAKS) as u32;
        // Older software lifts by this fixed way.
        let way = self.given.length_if(BREAK_WAY).unwrap_or(LIFT);
        let dwell = self.dwell(DWELL_ABOVE)?;
        let back = self.retract_feed(RETRACT_FEED, Some(cut.feed))?;
        let breaks = if times > 0 { Breaks::Times(times) } else { Breaks::Never };
        let ahead = AdvancedStop::Evenly([self.given.length(CLEARANCE); 2]);
        let removal = Removal { back, dwell, ahead, last: Some(back) };
        Ok(Method::Peck(Pecking { breaks, way, removal, ..self.shorter_steps(cut) }))
    }

    /// Cycle 205.
    pub fn pecking(&self, cut: Cut) -> Made<Method> {
        let ahead = [self.given.length(AHEAD_ABOVE), self.given.length(AHEAD_BELOW)];
        if ahead[0] != ahead[1] {
            self.say_of_all_bare(codes::K2408::advanced_stop_distance_changes_from_q258());
        }
        let given = self.given.has(RETRACT_FEED);
        let back = if given { self.retract_feed(RETRACT_FEED, Some(cut.feed))? } else { None };
        // Chips are removed at rapid traverse; Q208 is for the way out of the finished hole.
        let removal = Removal { back: None, dwell: 0.0, ahead: AdvancedStop::Evenly(ahead), last: Some(back) };
        Ok(Method::Peck(Pecking {
            from: self.given.length(DEEPENED),
            breaks: self.breaks_by_depth(),
            way: self.given.length(BREAK_WAY),
            removal,
            ..self.shorter_steps(cut)
        }))
    }

    /// Q257
    pub fn breaks_by_depth(&self) -> Breaks {
        let every = self.given.length(BREAK_DEPTH);
        if every > 0.0 { Breaks::Every(every) } else { Breaks::Never }
    }

    /// By Q202, Q212 and Q205.
    fn shorter_steps(&self, cut: Cut) -> Pecking {
        let shorter = (self.given.length(DECREMENT), self.given.length(LEAST_PLUNGE));
        steps(self.given.length(PLUNGE), shorter, cut.dwell)
    }

    /// Cycle 207.
    pub fn rigid_tapping(&self, cut: Cut) -> Tap {
        self.tap(cut, Some(self.given.length(PITCH)))
    }

    pub fn tapping(&self, cut: Cut, lead: Option<f64>) -> Method {
        Method::Tap(self.tap(cut, lead))
    }

    /// `lead` is positive for a right-hand thread; without one the feed of the hole holds both ways.
    fn tap(&self, cut: Cut, lead: Option<f64>) -> Tap {
        if lead.is_none() {
            self.say_of_all_bare(codes::K2409::spindle_is_reversed_by_m4());
        }
        let turn = match lead {
            Some(lead) if lead < 0.0 => Turn::CounterClockwise,
            Some(_) => Turn::Clockwise,
            None => self.st.state.spindle.turn().unwrap_or(Turn::Clockwise),
        };
        let after = if lead.is_some() { Spindle::Stop } else { Spindle::Start(turn) };
        Tap { dwell: cut.dwell, dwell_reversed: true, ..Tap::new(lead.is_some(), lead, turn, after) }
    }
}

/// Steps that become shorter by an amount, down to a least one; the tool leaves the hole after each.
pub(super) fn steps(first: f64, (less, least): (f64, f64), dwell: f64) -> Pecking {
    // The least step counts only where the steps become shorter.
    let least = if less == 0.0 { least.min(0.0) } else { least };
    let mut peck = Pecking { dwell_at_bottom: dwell, ..Pecking::new(first, Degression::Plain { less, least }) };
    peck.removal.last = Some(None);
    peck
}
