//! What milling cycles have in common: their cutter, heights and feeds become a [`Mill`].
//!
//! Source: K 6.0, 6.5; F B4 (docs/sources.md).

use crate::diag::{Answer, Fault, codes};
use crate::geo::tolerance;
use crate::geo::{Deg, Point2};
use crate::ir::Feed;
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill};
use crate::ir::cycle::pocket::Insertion;
use crate::ir::function::Turn;
use crate::machine::{Axis, AxisSet};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

use super::call::{By, CycleCall, Instead};
use super::drilling::{FEED, PLUNGE};
use super::milling::{
    CLIMB, FEED_REFERENCE, FINISHING_FEED, FINISHING_INFEED, FLOOR_ALLOWANCE, MILLING_FEED, OPERATION, OVERLAP,
    PLUNGING, SIDE_ALLOWANCE,
};

/// Least and greatest factor of the overlap.
pub(super) const OVERLAPS: std::ops::RangeInclusive<f64> = 0.1..=1.9999;

/// What Q215 asks for.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Machining {
    pub rough: bool,
    pub wall: bool,
    pub floor: bool,
    /// On the wall.
    pub allowance: f64,
    /// Infeed in depth of the wall.
    pub step: f64,
    /// Of finishing.
    pub feed: Feed,
}

/// How a milling cycle gets to a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum Plunging {
    Vertical,
    /// Greatest angle of the way.
    Helix(Deg),
    Ramp(Deg),
}

impl Plunging {
    /// As an insertion of a slot, along which the tool goes to and fro.
    pub fn along(self) -> Insertion {
        match self {
            Plunging::Vertical => Insertion::Vertical,
            Plunging::Helix(angle) | Plunging::Ramp(angle) => Insertion::Ramp { angle, stroke: None },
        }
    }
}

impl CycleCall<'_> {
    // The tool and its place.

    /// Where the cycle is called, in the plane.
    pub fn call_point(&self) -> Made<Point2> {
        let (first, second, _) = self.st.state.plane().axes();
        Ok(Point2::new(self.position(Axis::ALL[first])?, self.position(Axis::ALL[second])?))
    }

    /// The place that a cycle names itself: it runs there wherever CYCL CALL POS takes the tool, and a pattern has nothing
    /// to say.
    pub fn center_of_its_own(&self, (first, second): (Name, Name)) -> Made<Point2> {
        if self.st.calling.by == By::Pattern {
            return self.refuse(codes::P9010::pattern_with_centre_of_its_own());
        }
        Ok(Point2::new(self.given.length(first), self.given.length(second)))
    }

    /// Radius of the tool with its oversizes.
    pub fn tool_radius(&self) -> Made<f64> {
        let Some(tool) = self.st.state.tool.active() else { return self.without(Instead::Radius) };
        match tool.effective_radius() {
            // With two radii in two tables none counts.
            Some(radius) if tool.other_radius.is_none() => Ok(radius),
            _ => self.without(Instead::Radius),
        }
    }

    /// Radius of the cutter, above 0.
    pub fn cutter_radius(&self) -> Made<f64> {
        let radius = self.tool_radius()?;
        if radius > 0.0 {
            return Ok(radius);
        }
        self.refuse(codes::P2090::radius_of_tool_with_its_oversizes(&radius))
    }

    /// Does the tool axis carry a cutter?
    pub fn can_mill(&self) -> Made {
        let axis = self.st.state.axis();
        if AxisSet::MAIN.contains(axis) {
            return Ok(());
        }
        self.refuse(codes::P2090::tool_axis_cannot_mill(&axis.letter()))
    }

    // Heights and feeds.

    /// Heights by Q200 to Q204; nothing where the depth is 0.
    pub fn mill_heights(&self) -> Made<Option<Heights>> {
        let heights = self.heights();
        let deep = self.depth()?;
        if deep == 0.0 {
            self.without_depth();
            return Ok(None);
        }
        Ok(Some(Heights {
            retract: self.st.calling.retract.height(&heights),
            reference: heights.surface,
            clearance: heights.clearance,
            depth: heights.surface + deep,
            step: 0.0,
            division: Division::Even,
            allowance: 0.0,
        }))
    }

    /// The cutter of a cycle that has one level; nothing where the depth is 0.
    pub fn round_cutter(&self, feeds: Feeds) -> Made<Option<Mill>> {
        let radius = self.cutter_radius()?;
        Ok(self.mill_heights()?.map(|heights| Mill { plane: self.st.state.plane(), heights, radius, feeds }))
    }

    /// What milling cycles from 200 on take; nothing where the depth is 0.
    pub fn cutter_of(&self) -> Made<Option<Mill>> {
        self.can_mill()?;
        let radius = self.cutter_radius()?;
        let Some(heights) = self.mill_heights()? else { return Ok(None) };
        let plane = self.feed(MILLING_FEED)?;
        let feeds = Feeds { plane, depth: self.feed_if(FEED, plane)? };
        let (step, allowance) = (self.given.length(PLUNGE), self.given.length(FLOOR_ALLOWANCE));
        let heights = Heights { step, division: Division::Whole, allowance, ..heights };
        Ok(Some(Mill { plane: self.st.state.plane(), heights, radius, feeds }))
    }

    /// A feed that may be missing.
    pub fn feed_if(&self, name: Name, usual: Feed) -> Made<Feed> {
        if self.given.has(name) { self.feed(name) } else { Ok(usual) }
    }

    /// Width of a cut: Q370 radii.
    pub fn overlap(&self, radius: f64) -> Made<f64> {
        let factor = self.given.number(OVERLAP).unwrap_or(1.0);
        if OVERLAPS.contains(&factor) {
            return Ok(factor * radius);
        }
        self.refuse(codes::P2090::overlap_factor_q370_is_not_0_1(&factor))
    }

    /// Q439 says of what Q207 is the feed.
    pub fn feed_of_centre(&self) -> Made {
        match self.given.whole(FEED_REFERENCE) {
            0 => Ok(()),
            other => self.refuse(codes::P9010::feed_of_cutting_edge_is_not_supported(&other)),
        }
    }

    // Roughing and finishing.

    /// Q215 = 2, and neither Q368 nor Q369 leaves anything; faces and slots without them know their stock otherwise.
    pub fn leaves_nothing_to_finish(&self) -> bool {
        let finishes = |name| self.given.takes(name) && self.given.or_zero(name) > 0.0;
        let by_both = self.given.takes(SIDE_ALLOWANCE)
            && self.given.signature.parameter(SIDE_ALLOWANCE).is_some_and(|known| known.without_effect.is_none());
        by_both && self.given.whole(OPERATION) == 2 && !finishes(SIDE_ALLOWANCE) && !finishes(FLOOR_ALLOWANCE)
    }

    /// Roughing and finishing by Q215 and the allowances; nothing where nothing is left to do.
    pub fn asked(&self, mill: &Mill) -> Made<Option<Machining>> {
        let (allowance, step) = (self.given.length(SIDE_ALLOWANCE), self.given.length(FINISHING_INFEED));
        let feed = self.feed_if(FINISHING_FEED, mill.feeds.plane)?;
        if self.leaves_nothing_to_finish() {
            self.say(codes::K8103::neither_q368_nor_q369_leaves_anything());
            return Ok(None);
        }
        let operation = self.given.whole(OPERATION);
        let finishes = operation != 1;
        let (wall, floor) = (finishes && allowance > 0.0, finishes && mill.heights.allowance > 0.0);
        Ok(Some(Machining { rough: operation != 2, wall, floor, allowance, step, feed }))
    }

    /// A wider `allowance` than `most` would leave stock between roughing and finishing.
    pub fn finishing_meets_roughing(&self, (allowance, most): (f64, f64), radius: f64) -> Made {
        if allowance <= most + tolerance::LOST {
            return Ok(());
        }
        let fault = codes::P2090::allowance_on_wall_is_mm(&shown(allowance), &shown(2.0 * radius), &shown(most));
        self.refuse(fault)
    }

    /// The floor is finished in one cut, which goes no deeper than any other.
    pub fn floor_in_one_cut(&self, mill: &Mill) -> Made {
        let Heights { allowance, step, .. } = mill.heights;
        if allowance <= step + tolerance::LOST {
            return Ok(());
        }
        self.refuse(codes::P2090::floor_would_be_finished_in_one_cut(&shown(allowance), &shown(step)))
    }

    // The sense.

    /// Does the tool go round counter-clockwise inside, clockwise outside? By Q351, with M3; cycles without it climb.
    pub fn climbs(&self) -> Made<bool> {
        let given = self.given.number(CLIMB);
        let climbs = match given.unwrap_or(1.0) {
            1.0 => true,
            -1.0 => false,
            other => return self.refuse(codes::P2090::kind_of_milling_q351_is_not_1(&other)),
        };
        self.turns_by_m3(given.map(|_| CLIMB))?;
        Ok(climbs)
    }

    /// Climb and up-cut milling, by `name` where there is a choice, are defined for M3.
    pub fn turns_by_m3(&self, name: Option<Name>) -> Made {
        if self.st.state.spindle.turn() == Some(Turn::CounterClockwise) {
            return self.refuse(match name {
                Some(name) => codes::K9031::climb_and_up_cut_are_defined_for_m3(&name),
                None => codes::K9031::climb_is_defined_for_m3(),
            });
        }
        if self.is_mirrored() {
            self.say_of_all(codes::K8107::mirror_turns_climb_into_up_cut());
        }
        Ok(())
    }

    /// A mirror turns the way round, and not the spindle.
    fn is_mirrored(&self) -> bool {
        self.st.state.ctx.frame.flips(self.st.state.plane())
    }

    // Going down.

    /// How the tool goes down, by Q366, and the greatest angle of its way.
    pub fn plunging(&self) -> Made<Plunging> {
        let kind = self.given.whole(PLUNGING);
        if kind == 0 {
            return Ok(Plunging::Vertical);
        }
        let angle = self.plunging_angle(
            |called| codes::K2902::plunging_by_q366_needs_angle(&kind, called).answer(plunge_angle(called)),
            |called| codes::K2902::plunging_by_q366_at_angle_0(&kind, called).answer(plunge_angle(called)),
        )?;
        Ok(match angle {
            None => Plunging::Vertical,
            Some(angle) if kind == 1 => Plunging::Helix(angle),
            Some(angle) => Plunging::Ramp(angle),
        })
    }

    /// ANGLE of the tool; none for one that goes straight down.
    pub fn plunging_angle(&self, missing: impl Fn(&&str) -> Fault, flat: impl Fn(&&str) -> Fault) -> Made<Option<Deg>> {
        let tool = self.st.state.tool.active();
        let called = tool.map_or("", |tool| tool.called.as_str());
        match tool.and_then(|tool| tool.plunge_angle) {
            Some(angle) if angle >= 90.0 => Ok(None),
            Some(angle) if angle > 0.0 => Ok(Some(Deg(angle))),
            Some(_) => self.refuse(flat(&called)),
            None => self.refuse(missing(&called)),
        }
    }
}

/// What says the angle.
pub(super) fn plunge_angle(called: &&str) -> Answer {
    Answer::tool(called, "plunge_angle")
}

/// Without the last digits of arithmetic.
pub(in super::super) fn shown(length: f64) -> f64 {
    libm::round(length * 1e6) / 1e6
}
