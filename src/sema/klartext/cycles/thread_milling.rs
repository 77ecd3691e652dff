//! Cycles 262 to 265 and 267: their parameters become a [`ThreadMilling`].
//!
//! Source: K 6.2, F B6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::geo::tolerance;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{AdvancedStop, Levels, Method};
use crate::ir::cycle::milling::{Feeds, Mill, Place};
use crate::ir::cycle::thread_milling::{Positioning, Side, Sink, Stage, ThreadMilling, Turns, Ways};
use crate::ir::cycle::{Cycle, Drilling};
use crate::machine::Axis;
use crate::machine::options::klartext_cycles::OutsideThread;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

use super::Planned;
use super::bores::NOMINAL;
use super::call::CycleCall;
use super::drilling::{AHEAD_ABOVE, BREAK_WAY, FEED, PITCH, PLUNGE, PREPOSITION};
use super::holes::steps;
use super::milling::{CLIMB, MILLING_FEED};
use super::threads::{APPROACH_FEED, FRONT_DEPTH, FRONT_OFFSET, SINK_FEED, SINK_LATER, STEPS, TOTAL_DEPTH};

/// Depth of a metric thread in pitches, of a hole and of a stud (ISO 68-1).
const IN_HOLE: f64 = 0.541_266;
const ON_STUD: f64 = 0.613_435;

impl CycleCall<'_> {
    /// Cycle 262.
    pub fn thread_in_hole(&self) -> Made<Planned> {
        let turns = self.turns_of_thread();
        let Some(thread) = self.inside_thread(turns)? else { return Ok(Planned::default()) };
        self.depth_of_core_hole(&thread);
        self.thread_cycle(thread)
    }

    /// Cycle 263.
    pub fn thread_with_countersink(&self) -> Made<Planned> {
        let Some(mut thread) = self.inside_thread(Turns::Once)? else { return Ok(Planned::default()) };
        let feed = self.feed(SINK_FEED)?;
        match self.height_below(TOTAL_DEPTH, &thread.mill)? {
            Some(height) => {
                self.say_of_all(codes::K8141::countersink_is_made_straight_down_in_middle());
                self.keep_above(&mut thread, height)?;
                let approach = height + thread.mill.heights.clearance;
                let sink = Sink { approach, height, radius: 0.0, counter_clockwise: true, feed };
                thread.before.push(Stage::Sink(sink));
            }
            None => self.depth_of_core_hole(&thread),
        }
        thread.before.extend(self.front(&thread, feed)?);
        self.thread_cycle(thread)
    }

    /// Cycle 264.
    pub fn thread_with_hole(&self) -> Made<Planned> {
        let Some(mut thread) = self.inside_thread(Turns::Once)? else { return Ok(Planned::default()) };
        let Some(depth) = self.height_below(TOTAL_DEPTH, &thread.mill)? else {
            return self.refuse(codes::P2090::depth_of_hole_q356_is_0());
        };
        // The hole is as wide as the tool.
        if thread.ways.positioning == Some(Positioning::Rapid) && thread.ways.beside.is_some() {
            return self.refuse(codes::P9010::going_sideways_at_rapid());
        }
        self.keep_above(&mut thread, depth)?;
        let heights = &thread.mill.heights;
        let levels =
            Levels { retract: heights.safe(), reference: heights.reference, clearance: heights.clearance, depth };
        let mut peck = steps(self.given.length(PLUNGE), (0.0, 0.0), 0.0);
        peck.breaks = self.breaks_by_depth();
        peck.way = self.given.length(BREAK_WAY);
        peck.removal.ahead = AdvancedStop::Evenly([self.given.length(AHEAD_ABOVE); 2]);
        let feed = self.feed(FEED)?;
        let axis = Axis::ALL[thread.mill.plane.axes().2];
        thread.before.push(Stage::Drill(Drilling { axis, levels, feed, entry: None, method: Method::Peck(peck) }));
        thread.before.extend(self.front(&thread, thread.mill.feeds.plane)?);
        self.thread_cycle(thread)
    }

    /// Cycle 265: from above the surface down, into the solid.
    pub fn thread_from_solid(&self) -> Made<Planned> {
        let Some(mut thread) = self.inside_thread(Turns::Continuous)? else { return Ok(Planned::default()) };
        let radius = thread.mill.radius;
        if thread.nominal - radius > radius + tolerance::LOST {
            return self.refuse(codes::K2942::tool_leaves_core(&(2.0 * thread.nominal), &(2.0 * radius)));
        }
        thread.counter_clockwise = thread.left_hand;
        // Nothing below the depth is cut.
        thread.ways.along[1] = 0.0;
        thread.ways.beside = Some(0.0);
        let feed = self.feed(SINK_FEED)?;
        let front = self.front(&thread, feed)?;
        if self.given.whole(SINK_LATER) == 1 {
            thread.after.extend(front);
        } else {
            // Nothing is open yet: the way down cuts.
            let approach = thread.mill.heights.safe();
            thread.before.extend(front.map(|stage| match stage {
                Stage::Sink(sink) => Stage::Sink(Sink { approach, ..sink }),
                other => other,
            }));
        }
        self.thread_cycle(thread)
    }

    /// Cycle 267.
    pub fn thread_on_stud(&self) -> Made<Planned> {
        let Some(touched) = self.settings.cycles.klartext.outside_thread else {
            return self.refuse(codes::K9040::what_tool_touches_is_open().answer(Answer::key("cycles", "thread_267")));
        };
        let turns = self.turns_of_thread();
        let Some(mut thread) = self.thread(turns)? else { return Ok(Planned::default()) };
        thread.side = Side::External;
        thread.counter_clockwise = !thread.counter_clockwise;
        thread.core = match touched {
            OutsideThread::Nominal => thread.nominal,
            OutsideThread::Core => thread.nominal - ON_STUD * thread.pitch,
        };
        let beside = thread.mill.heights.clearance.max(thread.pitch);
        thread.ways.beside = Some(thread.nominal + thread.mill.radius + beside);
        let feed = self.feed(SINK_FEED)?;
        let front = self.front(&thread, feed)?;
        thread.before.extend(front);
        self.say_of_all(codes::K8141::beside_stud_tool_goes_half_pitch_below());
        self.thread_cycle(thread)
    }

    /// What all of them take; nothing where the depth is 0. As in a hole.
    fn thread(&self, turns: Turns) -> Made<Option<ThreadMilling>> {
        let feed = self.feed(MILLING_FEED)?;
        let positioning = self.retract_feed(PREPOSITION, None)?.map_or(Positioning::Rapid, Positioning::At);
        let feeds = Feeds { plane: feed, depth: feed };
        let Some(mill) = self.round_cutter(feeds)? else { return Ok(None) };
        if self.st.state.ctx.frame.linear().determinant() < 0.0 {
            return self.refuse(codes::P9010::milling_under_mirror());
        }
        let nominal = self.given.length(NOMINAL) / 2.0;
        let pitch = self.given.length(PITCH);
        if pitch == 0.0 {
            return self.refuse(codes::P2090::pitch_q239_is_0());
        }
        // Cycle 265 has no Q351: the hand of the thread decides.
        let climbs = if self.given.takes(CLIMB) { self.climbs()? } else { true };
        let pitch_way = pitch.abs();
        let onto = self.feed_onto(feed)?;
        Ok(Some(ThreadMilling {
            place: Place { at: self.call_point()?, turn: Deg(0.0) },
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
    fn feed_onto(&self, feed: Feed) -> Made<Feed> {
        if self.given.has(APPROACH_FEED) { self.feed_or(APPROACH_FEED, Some(feed)) } else { Ok(feed) }
    }

    fn inside_thread(&self, turns: Turns) -> Made<Option<ThreadMilling>> {
        let Some(mut thread) = self.thread(turns)? else { return Ok(None) };
        let radius = thread.mill.radius;
        if radius >= thread.core {
            return self.refuse(codes::K2901::core_is_smaller(&(2.0 * radius), &(2.0 * thread.nominal)));
        }
        // A small tool first goes half of the way to the wall.
        if 2.0 * radius < 2.0 * thread.nominal - 4.0 * thread.pitch - tolerance::LOST {
            thread.ways.beside = Some((thread.nominal - radius) / 2.0);
        }
        Ok(Some(thread))
    }

    /// Q355
    fn turns_of_thread(&self) -> Turns {
        match self.given.whole(STEPS) {
            0 => Turns::Once,
            1 => Turns::Continuous,
            count => Turns::Strips(count as u32),
        }
    }

    fn depth_of_core_hole(&self, thread: &ThreadMilling) {
        let deeper = thread.pitch / 2.0;
        self.say_of_all(codes::K8141::tool_goes_mm(&deeper));
    }

    /// A depth below the surface; nothing where it is 0.
    fn height_below(&self, name: Name, mill: &Mill) -> Made<Option<f64>> {
        let depth = self.given.length(name);
        if depth > 0.0 {
            return self.refuse(codes::P2090::depth_is_positive_2(&name, &depth));
        }
        Ok((depth != 0.0).then_some(mill.heights.reference + depth))
    }

    /// The way to the thread, or from it, goes no deeper than `floor`.
    fn keep_above(&self, thread: &mut ThreadMilling, floor: f64) -> Made {
        let room = thread.mill.heights.depth - floor;
        if room < -tolerance::LOST {
            return self.refuse(codes::P2090::depth_q356_is_less_than_depth());
        }
        let rises = thread.counter_clockwise != thread.left_hand;
        let deep = &mut thread.ways.along[usize::from(!rises)];
        *deep = deep.min(room.max(0.0));
        Ok(())
    }

    /// The countersink at the front: Q358 and Q359.
    fn front(&self, thread: &ThreadMilling, feed: Feed) -> Made<Option<Stage>> {
        let radius = self.given.length(FRONT_OFFSET);
        let Some(height) = self.height_below(FRONT_DEPTH, &thread.mill)? else { return Ok(None) };
        let internal = thread.side == Side::Internal;
        let nominal = self.given.length(NOMINAL) / 2.0;
        let beyond = if internal { radius - nominal } else { nominal - radius };
        if radius != 0.0 && beyond > thread.pitch {
            // A chamfer needs the middle of the cutter on the other side of the edge.
            self.say_of_all(codes::K8111::circle_of_countersink(&FRONT_OFFSET, &radius, &(2.0 * nominal)));
        }
        let counter_clockwise = internal;
        Ok(Some(Stage::Sink(Sink { approach: height, height, radius, counter_clockwise, feed })))
    }

    fn thread_cycle(&self, thread: ThreadMilling) -> Made<Planned> {
        Ok(Cycle::ThreadMilling(self.sound(thread)?).into())
    }
}
