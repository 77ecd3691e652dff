//! Cycles 262 to 265 and 267: their parameters become a [`ThreadMilling`].
//!
//! Source: K 6.2, F B6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{Ahead, Breaks, Levels, Method};
use crate::ir::cycle::milling::{Feeds, Mill, Place};
use crate::ir::cycle::thread_milling::{Positioning, Side, Sink, Stage, ThreadMilling, Turns, Ways};
use crate::ir::cycle::{Cycle, Drilling};
use crate::machine::Axis;
use crate::machine::options::klartext_cycles::OutsideThread;
use crate::sema::cycle::row::Name;

use super::cycles::bores::NOMINAL;
use super::cycles::call::Call;
use super::cycles::drilling::{AHEAD_ABOVE, BREAK_DEPTH, BREAK_WAY, FEED, PITCH, PREPOSITION};
use super::cycles::milling::{CLIMB, MILLING_FEED};
use super::cycles::threads::{APPROACH_FEED, FRONT_DEPTH, FRONT_OFFSET, SINK_FEED, SINK_LATER, STEPS, TOTAL_DEPTH};
use super::cycles::{DefinedCycle, Q};
use super::drilling::steps;
use super::{Outcome, Reported, Run};

/// Depth of a metric thread in pitches, of a hole and of a stud (ISO 68-1).
const IN_HOLE: f64 = 0.541_266;
const ON_STUD: f64 = 0.613_435;
/// What arithmetic may lose at a size, mm.
const SAME: f64 = 1e-9;

impl Run<'_> {
    /// Cycle 262.
    pub(super) fn thread_in_hole(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let turns = self.turns_of_thread(cycle)?;
        let Some(thread) = self.inside_thread(cycle, call, turns)? else { return Ok(None) };
        self.depth_of_core_hole(cycle, &thread);
        self.thread_cycle(cycle, thread)
    }

    /// Cycle 263.
    pub(super) fn thread_with_countersink(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some(mut thread) = self.inside_thread(cycle, call, Turns::Once)? else { return Ok(None) };
        let feed = self.cycle_feed(cycle, SINK_FEED, None)?;
        match self.height_below(cycle, TOTAL_DEPTH, &thread.mill)? {
            Some(height) => {
                self.own_way_of(cycle, codes::K8141::countersink_is_made_straight_down_in_middle());
                self.keep_above(cycle, &mut thread, height)?;
                let approach = height + thread.mill.heights.clearance;
                let sink = Sink { approach, height, radius: 0.0, counter_clockwise: true, feed };
                thread.before.push(Stage::Sink(sink));
            }
            None => self.depth_of_core_hole(cycle, &thread),
        }
        thread.before.extend(self.front(cycle, &thread, feed)?);
        self.thread_cycle(cycle, thread)
    }

    /// Cycle 264.
    pub(super) fn thread_with_hole(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some(mut thread) = self.inside_thread(cycle, call, Turns::Once)? else { return Ok(None) };
        let Some(depth) = self.height_below(cycle, TOTAL_DEPTH, &thread.mill)? else {
            return self.refuse_value(cycle, codes::P2090::depth_of_hole_q356_is_0());
        };
        // The hole is as wide as the tool.
        if thread.ways.positioning == Some(Positioning::Rapid) && thread.ways.beside.is_some() {
            return self.cycle_otherwise(
                cycle,
                "going sideways through the material at rapid traverse (Q253=FMAX)",
                "write Q253 as a number, or take a tool that is nearly as wide as the core of the thread",
            );
        }
        self.keep_above(cycle, &mut thread, depth)?;
        let heights = &thread.mill.heights;
        let levels =
            Levels { retract: heights.safe(), reference: heights.reference, clearance: heights.clearance, depth };
        let mut peck = steps(self.infeed(cycle)?, (0.0, 0.0), 0.0);
        let every = self.cycle_open_length(cycle, BREAK_DEPTH)?;
        peck.breaks = if every > 0.0 { Breaks::Every(every) } else { Breaks::Never };
        peck.way = self.cycle_length(cycle, BREAK_WAY)?;
        peck.removal.ahead = Ahead::Evenly([self.cycle_length(cycle, AHEAD_ABOVE)?; 2]);
        let feed = self.cycle_feed(cycle, FEED, None)?;
        let axis = Axis::ALL[thread.mill.plane.axes().2];
        thread.before.push(Stage::Drill(Drilling { axis, levels, feed, entry: None, method: Method::Peck(peck) }));
        thread.before.extend(self.front(cycle, &thread, thread.mill.feeds.plane)?);
        self.thread_cycle(cycle, thread)
    }

    /// Cycle 265: from above the surface down, into the solid.
    pub(super) fn thread_from_solid(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some(mut thread) = self.inside_thread(cycle, call, Turns::Continuous)? else { return Ok(None) };
        let radius = thread.mill.radius;
        if thread.nominal - radius > radius + SAME {
            self.report(
                codes::K2942::cycle_265(&(2.0 * thread.nominal), &(2.0 * radius))
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
            return Err(Reported);
        }
        thread.counter_clockwise = thread.left_hand;
        // Nothing below the depth is cut.
        thread.ways.along[1] = 0.0;
        thread.ways.beside = Some(0.0);
        let feed = self.cycle_feed(cycle, SINK_FEED, None)?;
        let front = self.front(cycle, &thread, feed)?;
        match self.cycle_number(cycle, SINK_LATER)? {
            // Nothing is open yet: the way down cuts.
            0.0 => {
                let approach = thread.mill.heights.safe();
                thread.before.extend(front.map(|stage| match stage {
                    Stage::Sink(sink) => Stage::Sink(Sink { approach, ..sink }),
                    other => other,
                }));
            }
            1.0 => thread.after.extend(front),
            other => return self.refuse_value(cycle, codes::P2090::q360_is_not_0_or_1(&other)),
        }
        self.thread_cycle(cycle, thread)
    }

    /// Cycle 267.
    pub(super) fn thread_on_stud(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some(touched) = self.job.settings.cycles.klartext.outside_thread else {
            self.report(
                codes::K9040::cycle_267()
                    .answer(Answer::key("cycles", "thread_267"))
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
            return Err(Reported);
        };
        let turns = self.turns_of_thread(cycle)?;
        let Some(mut thread) = self.thread(cycle, call, turns)? else { return Ok(None) };
        thread.side = Side::External;
        thread.counter_clockwise = !thread.counter_clockwise;
        thread.core = match touched {
            OutsideThread::Nominal => thread.nominal,
            OutsideThread::Core => thread.nominal - ON_STUD * thread.pitch,
        };
        let beside = thread.mill.heights.clearance.max(thread.pitch);
        thread.ways.beside = Some(thread.nominal + thread.mill.radius + beside);
        let feed = self.cycle_feed(cycle, SINK_FEED, None)?;
        let front = self.front(cycle, &thread, feed)?;
        thread.before.extend(front);
        self.own_way_of(cycle, codes::K8141::beside_stud_tool_goes_half_pitch_below());
        self.thread_cycle(cycle, thread)
    }

    /// What all of them take; nothing where the depth is 0. As in a hole.
    fn thread(&mut self, cycle: &DefinedCycle, call: Call, turns: Turns) -> Outcome<Option<ThreadMilling>> {
        let feed = self.cycle_feed(cycle, MILLING_FEED, None)?;
        let positioning = self.retract_feed(cycle, PREPOSITION, None)?.map_or(Positioning::Rapid, Positioning::At);
        let feeds = Feeds { plane: feed, depth: feed };
        let Some(mill) = self.round_cutter(cycle, call, feeds)? else { return Ok(None) };
        if self.st.ctx.frame.linear().determinant() < 0.0 {
            return self.refuse_cycle(cycle, codes::P9010::milling_under_mirror());
        }
        let nominal = self.above_zero(cycle, NOMINAL)? / 2.0;
        let pitch = self.cycle_length(cycle, PITCH)?;
        if pitch == 0.0 {
            return self.refuse_value(cycle, codes::P2090::pitch_q239_is_0());
        }
        // Cycle 265 has no Q351: the hand of the thread decides.
        let takes = cycle.row().needed().any(|name| name == Name::Q(CLIMB.0));
        let climbs = if takes { self.climbs(cycle)? } else { true };
        let pitch_way = pitch.abs();
        let onto = self.feed_onto(cycle, feed)?;
        Ok(Some(ThreadMilling {
            place: Place { at: self.call_point(cycle)?, turn: Deg(0.0) },
            mill,
            side: Side::Internal,
            nominal,
            core: nominal - IN_HOLE * pitch_way,
            pitch: pitch_way,
            left_hand: pitch < 0.0,
            counter_clockwise: climbs,
            turns,
            rests: vec![0.0],
            ways: Ways { beyond: true, positioning: Some(positioning), ..Ways::of_half_a_pitch(pitch_way, onto) },
            before: Vec::new(),
            after: Vec::new(),
        }))
    }

    /// Q512; 0 or missing: the feed for milling.
    fn feed_onto(&mut self, cycle: &DefinedCycle, feed: Feed) -> Outcome<Feed> {
        if cycle.gives_q(APPROACH_FEED) { self.cycle_feed(cycle, APPROACH_FEED, Some(feed)) } else { Ok(feed) }
    }

    fn inside_thread(&mut self, cycle: &DefinedCycle, call: Call, turns: Turns) -> Outcome<Option<ThreadMilling>> {
        let Some(mut thread) = self.thread(cycle, call, turns)? else { return Ok(None) };
        let radius = thread.mill.radius;
        if radius >= thread.core {
            let (hole, tool) = (2.0 * thread.nominal, 2.0 * radius);
            return self.tool_too_large(
                cycle,
                &format!("the tool of {tool} mm does not fit into the core of a thread of {hole} mm (Q335)"),
            );
        }
        // A small tool first goes half of the way to the wall.
        if 2.0 * radius < 2.0 * thread.nominal - 4.0 * thread.pitch - SAME {
            thread.ways.beside = Some((thread.nominal - radius) / 2.0);
        }
        Ok(Some(thread))
    }

    /// Q355
    fn turns_of_thread(&mut self, cycle: &DefinedCycle) -> Outcome<Turns> {
        match self.cycle_number(cycle, STEPS)? {
            0.0 => Ok(Turns::Once),
            1.0 => Ok(Turns::Continuous),
            n if n > 1.0 && n <= 99_999.0 && n.fract() == 0.0 => Ok(Turns::Strips(n as u32)),
            other => self.refuse_value(cycle, codes::P2090::threads_of_step_q355_are_no_whole(&other)),
        }
    }

    fn depth_of_core_hole(&mut self, cycle: &DefinedCycle, thread: &ThreadMilling) {
        let deeper = thread.pitch / 2.0;
        self.own_way_of(cycle, codes::K8141::tool_goes_mm(&deeper));
    }

    /// A depth below the surface; nothing where it is 0.
    fn height_below(&mut self, cycle: &DefinedCycle, q: Q, mill: &Mill) -> Outcome<Option<f64>> {
        let depth = self.cycle_length(cycle, q)?;
        if depth > 0.0 {
            return self.refuse_value(cycle, codes::P2090::depth_is_positive_2(&q, &depth));
        }
        Ok((depth != 0.0).then_some(mill.heights.reference + depth))
    }

    /// The way to the thread, or from it, goes no deeper than `floor`.
    fn keep_above(&mut self, cycle: &DefinedCycle, thread: &mut ThreadMilling, floor: f64) -> Outcome {
        let room = thread.mill.heights.depth - floor;
        if room < -SAME {
            return self.refuse_value(cycle, codes::P2090::depth_q356_is_less_than_depth());
        }
        let rises = thread.counter_clockwise != thread.left_hand;
        let deep = &mut thread.ways.along[usize::from(!rises)];
        *deep = deep.min(room.max(0.0));
        Ok(())
    }

    /// The countersink at the front: Q358 and Q359.
    fn front(&mut self, cycle: &DefinedCycle, thread: &ThreadMilling, feed: Feed) -> Outcome<Option<Stage>> {
        let radius = self.cycle_open_length(cycle, FRONT_OFFSET)?;
        let Some(height) = self.height_below(cycle, FRONT_DEPTH, &thread.mill)? else { return Ok(None) };
        let internal = thread.side == Side::Internal;
        let nominal = self.above_zero(cycle, NOMINAL)? / 2.0;
        let beyond = if internal { radius - nominal } else { nominal - radius };
        if radius != 0.0 && beyond > thread.pitch {
            self.says_sink_in_the_face(cycle, radius, 2.0 * nominal);
        }
        let counter_clockwise = internal;
        Ok(Some(Stage::Sink(Sink { approach: height, height, radius, counter_clockwise, feed })))
    }

    /// The middle of the cutter goes over the face: a chamfer needs it on the other side of the edge.
    fn says_sink_in_the_face(&mut self, cycle: &DefinedCycle, radius: f64, diameter: f64) {
        self.report_once(
            codes::K8111::cycle_circle_of_countersink(&cycle.number, &FRONT_OFFSET, &radius, &diameter)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
    }

    fn thread_cycle(&mut self, cycle: &DefinedCycle, thread: ThreadMilling) -> Outcome<Option<Cycle>> {
        Ok(Some(Cycle::ThreadMilling(self.sound(cycle, thread)?)))
    }
}
