//! Drilling cycles: 1, 2, 17, 200 to 203, 205 to 207, 240, 241. Their parameters become a [`Drilling`].
//!
//! Source: K 4.4, 6.0 to 6.2 (docs/sources.md). The parameters Q200 and up stay variables: a call takes what they hold
//! then. The values of the old dotted cycles are those of the definition.

use crate::diag::codes;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{Ahead, Bore, Breaks, Degression, Levels, Method, Pecking, Removal, Tap, usual_ahead};
use crate::ir::cycle::{Cycle, Drilling, Family};
use crate::ir::function::{Spindle, Turn};
use crate::machine::{Axis, AxisSet};
use crate::sema::cycle::row::Name;

use super::cycles::DefinedCycle;
use super::cycles::call::Call;
use super::cycles::drilling::{
    AHEAD_ABOVE, AHEAD_BELOW, ANGLE, BREAK_DEPTH, BREAK_WAY, BREAKS, DECREMENT, DEEPENED, DIRECTION, DWELL,
    DWELL_ABOVE, FEED, LEAST_PLUNGE, PITCH, PLUNGE, RETRACT_FEED,
};
use super::cycles::{CLEARANCE, Cut, DEPTH};
use super::machining::Needs;
use super::{Outcome, Reported, Run};

/// Way by which cycle 202 lifts the edge off the wall, in mm.
const LIFT: f64 = 0.2;
/// The feed of a hole whose pitch makes it.
const NO_FEED: Feed = Feed::PerMinute(1.0);

impl Run<'_> {
    /// Drills where the tool stands.
    pub(super) fn drill(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome {
        // The control itself starts the spindle for rigid tapping.
        let drilling = cycle.row().nature.drilling();
        let by_pitch = drilling.is_some_and(|drilling| drilling.feed.is_none());
        let own_spindle = drilling.is_some_and(|drilling| drilling.own_spindle);
        let spindle = match (own_spindle, by_pitch) {
            (true, _) => Needs::Nothing,
            (false, true) => Needs::Speed,
            (false, false) => Needs::Turning,
        };
        self.cycle_may_run(cycle, spindle)?;
        self.leave_open_end(AxisSet::EMPTY, false);
        self.check_pitch(cycle)?;
        let Some(hole) = self.hole(cycle, call)? else { return Ok(()) };
        if let Err(fault) = hole.check() {
            return self.cycle_value(cycle, &fault.to_string());
        }
        if self.moves_beside(AxisSet::of(self.st.axis()), false) {
            return Err(Reported);
        }
        let cycle = Cycle::Drilling(hole);
        let end = cycle.leaves(self.st.position.at());
        self.core.send_cycle(&cycle, &self.st.ctx);
        let axis = self.st.axis();
        self.st.position.cycle_leaves(&end, AxisSet::of(axis));
        self.st.moved = true;
        match &cycle {
            Cycle::Drilling(Drilling { method: Method::Tap(Tap { after: Spindle::Stop, .. }), .. }) => {
                self.st.spindle.stop();
            }
            Cycle::Drilling(Drilling { method: Method::Deep(hole), .. }) => self.leave_deep_hole(hole),
            _ => {}
        }
        Ok(())
    }

    /// A scaling changes the depth of a thread, but no tap has another pitch.
    fn check_pitch(&mut self, cycle: &DefinedCycle) -> Outcome {
        let t = self.st.frames.transform();
        let scaled = t.scale != 1.0 || t.axis_scale != [1.0; 3];
        if scaled && cycle.row().nature.drilling().is_some_and(|drilling| drilling.taps) {
            return self.refuse_cycle(cycle, codes::P9010::tapping_under_scaling());
        }
        Ok(())
    }

    fn hole(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Drilling>> {
        let axis = self.st.axis();
        if !AxisSet::MAIN.contains(axis) {
            return self.refuse_value(cycle, codes::P2090::tool_axis_cannot_drill(&axis.letter()));
        }
        let row = cycle.row();
        let Some(drilling) = row.nature.drilling() else { return Ok(None) };
        if row.has_parts(cycle.number) {
            let levels = self.old_levels(cycle, axis)?;
            let dwell = match drilling.dwell {
                Some(Name::Part(part)) => self.part_dwell(cycle, part)?,
                _ => 0.0,
            };
            let feed = match drilling.feed {
                Some(Name::Part(part)) => self.part_feed(cycle, part)?,
                _ => NO_FEED,
            };
            let method = (drilling.method)(self, cycle, Cut { feed, dwell })?;
            return Ok(Some(Drilling { axis, levels, feed, entry: None, method }));
        }
        let heights = self.heights(cycle, call.shift)?;
        let deep = self.hole_depth(cycle)?;
        if deep == 0.0 {
            self.has_no_depth(cycle);
            return Ok(None);
        }
        let levels = Levels {
            retract: call.retract.height(&heights),
            reference: heights.surface,
            clearance: heights.clearance,
            depth: heights.surface + deep,
        };
        let feed = match drilling.feed {
            Some(_) => self.cycle_feed(cycle, FEED, None)?,
            None => NO_FEED,
        };
        let dwell = if drilling.dwell.is_some() { self.cycle_dwell(cycle, DWELL)? } else { 0.0 };
        let method = (drilling.method)(self, cycle, Cut { feed, dwell })?;
        let entry = self.hole_entry(cycle, &levels)?;
        Ok(Some(Drilling { axis, levels, feed, entry, method }))
    }

    /// Q201, negative or 0.
    pub(super) fn depth_below(&mut self, cycle: &DefinedCycle) -> Outcome<f64> {
        let deep = self.cycle_length(cycle, DEPTH)?;
        if deep > 0.0 {
            return self.refuse_value(cycle, codes::P2090::depth_q201_is_positive(&deep));
        }
        Ok(deep)
    }

    /// Cycle 200: out of the hole after every step.
    pub(super) fn drilling(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let ahead = self.cycle_length(cycle, CLEARANCE)?;
        let first = self.infeed(cycle)?;
        let dwell_out = self.cycle_dwell(cycle, DWELL_ABOVE)?;
        let mut peck = steps(first, (0.0, 0.0), cut.dwell);
        peck.removal.dwell = dwell_out;
        peck.removal.ahead = Ahead::Evenly([ahead; 2]);
        Ok(Method::Peck(peck))
    }

    /// Cycle 201.
    pub(super) fn reaming(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        Ok(Method::Ream { dwell: cut.dwell, back: self.cycle_feed(cycle, RETRACT_FEED, Some(cut.feed))? })
    }

    /// Cycle 207.
    pub(super) fn rigid_tapping(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let lead = self.cycle_length(cycle, PITCH)?;
        self.tapping(cut, Some(lead))
    }

    /// Q202.
    pub(super) fn infeed(&mut self, cycle: &DefinedCycle) -> Outcome<f64> {
        let step = self.cycle_length(cycle, PLUNGE)?;
        if step <= 0.0 {
            return self.refuse_value(cycle, codes::P2090::plunging_depth_q202_is_not_above_zero(&step));
        }
        Ok(step)
    }

    pub(super) fn universal(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let first = self.infeed(cycle)?;
        let ahead = self.cycle_length(cycle, CLEARANCE)?;
        let times = self.cycle_number(cycle, BREAKS)?;
        if !(times >= 0.0 && times.fract() == 0.0 && times <= 99_999.0) {
            return self.refuse_value(cycle, codes::P2090::number_of_chip_breaks_q213_is_no(&times));
        }
        // Older software lifts by this fixed way.
        let way = if cycle.sets(BREAK_WAY) { self.cycle_length(cycle, BREAK_WAY)? } else { LIFT };
        let shorter = (self.cycle_length(cycle, DECREMENT)?, self.cycle_length(cycle, LEAST_PLUNGE)?);
        let dwell = self.cycle_dwell(cycle, DWELL_ABOVE)?;
        let back = self.retract_feed(cycle, RETRACT_FEED, Some(cut.feed))?;
        let breaks = if times > 0.0 { Breaks::Times(times as u32) } else { Breaks::Never };
        let removal = Removal { back, dwell, ahead: Ahead::Evenly([ahead; 2]), last: Some(back) };
        Ok(Method::Peck(Pecking { breaks, way, removal, ..steps(first, shorter, cut.dwell) }))
    }

    pub(super) fn pecking(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let from = self.cycle_open_length(cycle, DEEPENED)?;
        let first = self.infeed(cycle)?;
        let ahead = [self.cycle_length(cycle, AHEAD_ABOVE)?, self.cycle_length(cycle, AHEAD_BELOW)?];
        if ahead[0] != ahead[1] {
            self.job.diags.push_once(codes::K2408::advanced_stop_distance_changes_from_q258().at(self.here.origin.loc));
        }
        let every = self.cycle_length(cycle, BREAK_DEPTH)?;
        let back =
            if cycle.sets(RETRACT_FEED) { self.retract_feed(cycle, RETRACT_FEED, Some(cut.feed))? } else { None };
        let shorter = (self.cycle_length(cycle, DECREMENT)?, self.cycle_length(cycle, LEAST_PLUNGE)?);
        let way = self.cycle_length(cycle, BREAK_WAY)?;
        let breaks = if every > 0.0 { Breaks::Every(every) } else { Breaks::Never };
        // Chips are removed at rapid traverse; Q208 is for the way out of the finished hole.
        let removal = Removal { back: None, dwell: 0.0, ahead: Ahead::Evenly(ahead), last: Some(back) };
        Ok(Method::Peck(Pecking { from, breaks, way, removal, ..steps(first, shorter, cut.dwell) }))
    }

    pub(super) fn boring(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let lift = match self.cycle_number(cycle, DIRECTION)? {
            0.0 => [0.0; 3],
            1.0 => [-LIFT, 0.0, 0.0],
            2.0 => [0.0, -LIFT, 0.0],
            3.0 => [LIFT, 0.0, 0.0],
            4.0 => [0.0, LIFT, 0.0],
            other => {
                return self.refuse_value(cycle, codes::P2090::disengaging_direction_q214_is_not_0(&other));
            }
        };
        let back = self.retract_feed(cycle, RETRACT_FEED, Some(cut.feed))?;
        // Whole turns more or less are the same angle, and the target takes 0 to 360.
        let angle = self.cycle_option(cycle, ANGLE)?;
        let orient = if (0.0..=360.0).contains(&angle) { angle } else { angle.rem_euclid(360.0) };
        if lift != [0.0; 3] {
            if *self.st.ctx.frame.linear() != nalgebra::Matrix3::identity() {
                return self.refuse_cycle(cycle, codes::P9010::lifting_edge_off_wall_under_mirror());
            }
            let (first, second, _) = self.st.plane().axes();
            for axis in [first, second] {
                self.position_of(Axis::ALL[axis], self.block_span(), "cycle 202")?;
            }
        }
        let turn = self.st.spindle.turn().unwrap_or(Turn::Clockwise);
        Ok(Method::Bore(Bore { dwell: cut.dwell, turn, orient, back, lift }))
    }

    /// `lead` is positive for a right-hand thread; without one the feed of the hole holds both ways.
    pub(super) fn tapping(&mut self, cut: Cut, lead: Option<f64>) -> Outcome<Method> {
        if lead.is_none() {
            self.job.diags.push_once(codes::K2409::spindle_is_reversed_by_m4().at(self.here.origin.loc));
        }
        let turn = match lead {
            Some(lead) if lead < 0.0 => Turn::CounterClockwise,
            Some(_) => Turn::Clockwise,
            None => self.st.spindle.turn().unwrap_or(Turn::Clockwise),
        };
        Ok(Method::Tap(Tap {
            rigid: lead.is_some(),
            lead: lead.map(f64::abs),
            turn,
            dwell: cut.dwell,
            dwell_reversed: true,
            speed_in: None,
            speed_out: None,
            orient: None,
            step: None,
            after: if lead.is_some() { Spindle::Stop } else { Spindle::Start(turn) },
            speed_after: None,
        }))
    }

    /// Cycles 1, 2 and 17: the tool stands at the set-up clearance and comes back to it.
    pub(super) fn old_levels(&mut self, cycle: &DefinedCycle, axis: Axis) -> Outcome<Levels> {
        let span = self.block_span();
        let start = self.position_of(axis, span, &format!("cycle {}", cycle.number))?;
        let mm = cycle.mm;
        // The signs of the set-up clearance and the pecking depth have no meaning: old programs give all the same.
        let clearance = self.part(cycle, 1)?.abs() * mm;
        let deep = self.part(cycle, 2)? * mm;
        if deep > 0.0 {
            return self.refuse_value(cycle, codes::P2090::depth_is_positive());
        }
        if deep == 0.0 {
            return self.refuse_value(cycle, codes::P2090::depth_is_0());
        }
        let reference = start - clearance;
        Ok(Levels { retract: start, reference, clearance, depth: reference + deep })
    }

    /// Cycle 1.
    pub(super) fn old_pecking(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let first = self.part(cycle, 3)?.abs() * cycle.mm;
        let depth = self.part(cycle, 2)?.abs() * cycle.mm;
        let mut peck = steps(first, (0.0, 0.0), cut.dwell);
        peck.removal.ahead = Ahead::Evenly([usual_ahead(depth); 2]);
        Ok(Method::Peck(peck))
    }

    /// Cycle 17.
    pub(super) fn old_rigid_tapping(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let lead = self.part(cycle, 3)? * cycle.mm;
        self.tapping(cut, Some(lead))
    }

    fn part(&mut self, cycle: &DefinedCycle, part: u32) -> Outcome<f64> {
        match cycle.part(part) {
            Some(value) => Ok(value),
            None => self.refuse_value(cycle, codes::P2090::part_has_no_value(&cycle.number, &part)),
        }
    }

    fn part_dwell(&mut self, cycle: &DefinedCycle, part: u32) -> Outcome<f64> {
        let seconds = self.part(cycle, part)?;
        self.check_dwell(cycle, seconds)
    }

    fn part_feed(&mut self, cycle: &DefinedCycle, part: u32) -> Outcome<Feed> {
        let value = self.part(cycle, part)?;
        self.check_feed(cycle, value)
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
