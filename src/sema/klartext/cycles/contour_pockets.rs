//! Pockets along contours of subprograms, with islands: cycles 21 to 24.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Answer, Fault, codes};
use crate::geo::overlay::Area;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{AdvancedStop, Levels, Method, usual_ahead};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill};
use crate::ir::cycle::pocket::{Finish, Insertion, WallApproach};
use crate::ir::cycle::region::Coarse;
use crate::ir::cycle::{Cycle, Drilling, PilotHoles, Region};
use crate::machine::Axis;
use crate::sema::cycle::call::{Made, Refusal};
use crate::sema::cycle::row::Name;

use super::super::known::Known;
use super::Planned;
use super::call::{CycleCall, Instead, no_such_word};
use super::contours::{
    COARSE_TOOL, CORNERS, DEPTH, DIRECTION, FEED_FACTOR, FLOOR, HEIGHT, INFEED, LEFT, MILLING_FEED, OVERLAP,
    PLUNGING_FEED, RECIPROCATING_FEED, RETRACT_FEED, ROUGHING_TOOL, SET_UP, SIDE, SURFACE,
};
use super::data::{Contoured, Kept, Roughed};
use super::holes::steps;
use super::machining::{OVERLAPS, plunge_angle, shown};

/// What a control takes for rapid traverse.
const FASTEST: f64 = 99_999.0;

impl CycleCall<'_> {
    /// What all cycles of a pocket take, for a cutter of this radius; nothing where the depth is 0.
    fn contour_mill(&self, radius: f64, (feeds, step): (Feeds, f64)) -> Made<Option<Mill>> {
        let deep = self.kept_length(DEPTH)?;
        let surface = self.kept_length(SURFACE)?;
        let heights = Heights {
            retract: self.kept_length(HEIGHT)?,
            reference: surface,
            clearance: self.kept_unsigned(SET_UP)?,
            depth: surface + deep,
            step,
            division: Division::Whole,
            allowance: self.kept_unsigned(FLOOR)?,
        };
        self.mill_down(deep, Mill { plane: self.st.state.plane(), heights, radius, feeds })
    }

    /// A depth has a minus sign; with 0 the control does nothing.
    pub fn mill_down(&self, deep: f64, mill: Mill) -> Made<Option<Mill>> {
        self.can_mill()?;
        if deep > 0.0 {
            return self.refuse(codes::P2090::depth_q1_is_positive(&deep));
        }
        if deep == 0.0 {
            self.say_bare(codes::K2404::cycle_has_depth_0(&self.st.cycle.number));
            return Ok(None);
        }
        Ok(Some(mill))
    }

    pub fn contour_feeds(&self) -> Made<Feeds> {
        Ok(Feeds { plane: self.feed(MILLING_FEED)?, depth: self.feed(PLUNGING_FEED)? })
    }

    /// Q10: old programs write the infeed with the sign of the depth.
    pub fn contour_infeed(&self) -> Made<f64> {
        let step = self.given.magnitude(INFEED);
        if step > 0.0 { Ok(step) } else { self.refuse(codes::P2090::infeed_q10_is_0()) }
    }

    /// Q9 and Q15: does the tool climb?
    pub fn is_climb(&self, name: Name, value: f64) -> Made<bool> {
        self.turns_by_m3(Some(name))?;
        match value {
            1.0 => Ok(true),
            -1.0 => Ok(false),
            other => self.refuse(codes::P2090::kind_of_milling_is_not_1(&name, &other)),
        }
    }

    /// The pocket, as cycle 22 roughs it with this cutter.
    fn roughed_pocket(&self, mill: Mill) -> Made<Region> {
        let direction = self.kept(DIRECTION)?;
        let counter_clockwise = self.is_climb(DIRECTION, direction)?;
        let factor = self.kept(OVERLAP)?;
        if !OVERLAPS.contains(&factor) {
            return self.refuse_data(codes::P2090::overlap_factor_q2_is_not_0_1(&factor));
        }
        let allowance = self.kept_unsigned(SIDE)?;
        let Area { outlines, islands } = self.area(mill.radius + allowance)?.clone();
        Ok(Region {
            outlines,
            islands,
            counter_clockwise,
            allowance,
            left: 0.0,
            cleared: true,
            width: factor * mill.radius,
            insertion: Insertion::Vertical,
            insertion_feed: None,
            coarse: None,
            start: None,
            rough: true,
            finish: None,
            lifts_high: false,
            mill,
        })
    }

    // The cycles.

    /// Cycle 21.
    pub fn pilot_drilling(&self) -> Made<Planned> {
        let feed = self.feed(PLUNGING_FEED)?;
        let radius = self.radius_of_tool(self.given.or_zero(ROUGHING_TOOL))?;
        let step = self.contour_infeed()?;
        let feeds = Feeds { plane: feed, depth: feed };
        let Some(mill) = self.contour_mill(radius, (feeds, step))? else { return Ok(Planned::default()) };
        let region = self.roughed_pocket(mill)?;
        let (heights, axis) = (mill.heights, Axis::ALL[mill.plane.axes().2]);
        let levels = Levels {
            retract: heights.retract,
            reference: heights.reference,
            clearance: heights.clearance,
            depth: heights.rough_floor(),
        };
        let mut peck = steps(step, (0.0, 0.0), 0.0);
        peck.removal.ahead = AdvancedStop::Evenly([usual_ahead((levels.reference - levels.depth).abs()); 2]);
        let hole = Drilling { axis, levels, feed, entry: None, method: Method::Peck(peck) };
        Ok(Cycle::PilotHoles(self.sound(PilotHoles { pocket: Box::new(region), hole })?).into())
    }

    /// Cycle 22.
    pub fn rough_out(&self) -> Made<Planned> {
        let coarse = self.coarse_tool()?;
        let (insertion, insertion_feed) = self.insertion_by_feed()?;
        if self.given.number(FEED_FACTOR).is_some_and(|percent| percent != 100.0) {
            return self.refuse(codes::P9010::lower_feed_at_full_engagement());
        }
        self.retracts_at_rapid()?;
        let radius = self.cutter_radius()?;
        let (feeds, step) = (self.contour_feeds()?, self.contour_infeed()?);
        let Some(mill) = self.contour_mill(radius, (feeds, step))? else { return Ok(Planned::default()) };
        let region = self.roughed_pocket(mill)?;
        let made = self.sound(Region { insertion, insertion_feed, coarse, ..region })?;
        let (contours, state) = (self.contours()?, self.st.state);
        let tool = state.tool.active();
        let roughed = Box::new(Roughed {
            named: Rc::clone(&contours.named),
            tool: tool.map(|tool| tool.called.clone()),
            radius,
            oversize: tool.map_or(0.0, |tool| tool.table_deltas[1] + tool.call_deltas[1]),
            allowance: made.allowance,
            area: Area { outlines: made.outlines.clone(), islands: made.islands.clone() },
            frame: state.ctx.frame.clone(),
            pocket: Rc::clone(&self.data()?.values),
        });
        Ok(Planned { roughed: Some(roughed), ..Cycle::Region(made).into() })
    }

    /// Cycle 23.
    pub fn floor_finishing(&self) -> Made<Planned> {
        self.retracts_at_rapid()?;
        let radius = self.cutter_radius()?;
        let feeds = self.contour_feeds()?;
        let Some(mill) = self.contour_mill(radius, (feeds, 0.0))? else { return Ok(Planned::default()) };
        let region = self.roughed_pocket(mill)?;
        let finish = Some(finishing(feeds.plane, 0.0, (false, None)));
        let cleared = self.is_roughed(&region)?;
        self.warn_of_larger_cutter(radius)?;
        Ok(Cycle::Region(self.sound(Region { rough: false, finish, cleared, ..region })?).into())
    }

    /// Cycle 24.
    pub fn side_finishing(&self) -> Made<Planned> {
        let radius = self.cutter_radius()?;
        let (feeds, step) = (self.contour_feeds()?, self.contour_infeed()?);
        let Some(mill) = self.contour_mill(radius, (feeds, step))? else { return Ok(Planned::default()) };
        let mill = Mill { heights: Heights { allowance: 0.0, ..mill.heights }, ..mill };
        let left = self.given.length(LEFT);
        let allowance = self.kept_unsigned(SIDE)?;
        let (named, frame) = (&self.contours()?.named, &self.st.state.ctx.frame);
        let roughed = self.roughed_before()?.filter(|roughed| {
            Rc::ptr_eq(&roughed.named, named) && roughed.allowance == allowance && roughed.frame == *frame
        });
        let by = roughed.map_or(0.0, |roughed| roughed.radius);
        if left + radius >= allowance + by {
            return self.refuse(if by == 0.0 {
                codes::P2090::q14_and_cutter_reach_q3_unroughed(&left, &radius, &allowance)
            } else {
                codes::P2090::q14_radius_of_cutter_together_are_not(&left, &radius, &allowance, &by)
            });
        }
        let direction = self.given.or_zero(DIRECTION);
        let counter_clockwise = self.is_climb(DIRECTION, direction)?;
        let Area { outlines, islands } = self.area(radius + left)?.clone();
        let region = Region {
            outlines,
            islands,
            counter_clockwise,
            allowance,
            left,
            cleared: true,
            width: radius,
            insertion: Insertion::Vertical,
            insertion_feed: None,
            coarse: None,
            start: None,
            rough: false,
            finish: Some(finishing(feeds.plane, step, (true, Some(2.0 * radius)))),
            lifts_high: false,
            mill,
        };
        Ok(Cycle::Region(self.sound(region)?).into())
    }

    /// What a larger cutter left goes in one cut.
    fn warn_of_larger_cutter(&self, radius: f64) -> Made {
        let Known::Given(roughed) = self.st.roughed else { return Ok(()) };
        let before = roughed.radius;
        if before > radius && self.is_of_this_pocket(roughed)? {
            self.say_bare(codes::K8109::cycle_23_with_cutter_of_radius_mm(&shown(radius), &shown(before)));
        }
        Ok(())
    }

    /// Was this pocket roughed here, with these data, and by no larger cutter?
    fn is_roughed(&self, region: &Region) -> Made<bool> {
        let Known::Given(roughed) = self.st.roughed else { return Ok(false) };
        Ok(self.is_of_this_pocket(roughed)?
            && (&roughed.area.outlines, &roughed.area.islands) == (&region.outlines, &region.islands)
            && roughed.radius <= region.mill.radius)
    }

    /// Was it roughed in this system, with these data?
    fn is_of_this_pocket(&self, roughed: &Roughed) -> Made<bool> {
        Ok(Rc::ptr_eq(&roughed.pocket, &self.data()?.values) && roughed.frame == self.st.state.ctx.frame)
    }

    /// The last run of cycle 22. What needs one that was refused suffers only from that.
    fn roughed_before(&self) -> Made<Option<&Roughed>> {
        match self.st.roughed {
            Known::Nothing => Ok(None),
            Known::Lost => Err(Refusal::Known),
            Known::Given(roughed) => Ok(Some(roughed)),
        }
    }

    /// Q18: what the tool cleared that roughed these contours before.
    fn coarse_tool(&self) -> Made<Option<Box<Coarse>>> {
        let number = self.given.or_zero(COARSE_TOOL);
        if number == 0.0 {
            return Ok(None);
        }
        let radius = self.cutter_radius()?;
        let (named, called) = (&self.contours()?.named, number.to_string());
        let before = match self.roughed_before()? {
            Some(before)
                if self.is_of_this_pocket(before)?
                    && Rc::ptr_eq(&before.named, named)
                    && before.tool.as_deref() == Some(&called) =>
            {
                Some(before)
            }
            _ => None,
        };
        let Some(before) = before else {
            return self.refuse(codes::P2090::no_cycle_22_with_tool(&number));
        };
        if before.oversize > 0.0 {
            return self.refuse(codes::P2090::coarse_tool_q18_cut_with_oversize(&number, &before.oversize));
        }
        let (coarse, Area { outlines, islands }) = (before.radius, before.area.clone());
        let allowance = before.allowance;
        if coarse <= radius {
            return self.refuse(codes::P2090::coarse_tool(&number, &coarse, &radius));
        }
        Ok(Some(Box::new(Coarse { radius: coarse, allowance, outlines, islands })))
    }

    /// Q19: 0 is straight down, else to and fro at the angle of the tool, with this feed.
    fn insertion_by_feed(&self) -> Made<(Insertion, Option<Feed>)> {
        if self.given.word(RECIPROCATING_FEED).is_none() && self.given.or_zero(RECIPROCATING_FEED) == 0.0 {
            return Ok((Insertion::Vertical, None));
        }
        let feed = self.feed(RECIPROCATING_FEED)?;
        let angle = self.plunging_angle(
            |called| codes::K2902::plunging_by_q19_needs_angle(called).answer(plunge_angle(called)),
            |called| codes::K2902::plunging_by_q19_at_angle_0(called).answer(plunge_angle(called)),
        )?;
        let insertion = match angle {
            Some(angle) => Insertion::Ramp { angle, stroke: None },
            None => Insertion::Vertical,
        };
        Ok((insertion, Some(feed)))
    }

    /// Q18
    pub fn no_coarse_tool(&self) -> Made {
        if self.given.or_zero(COARSE_TOOL) == 0.0 {
            return Ok(());
        }
        self.refuse(codes::P9010::what_coarse_tool())
    }

    /// Q208
    fn retracts_at_rapid(&self) -> Made {
        match (self.given.word(RETRACT_FEED), self.given.number(RETRACT_FEED)) {
            (Some("FMAX"), _) | (None, None) => Ok(()),
            (Some(word), _) => self.refuse(no_such_word(word, RETRACT_FEED)),
            (None, Some(feed)) if feed >= FASTEST => Ok(()),
            (None, Some(feed)) => self.refuse(codes::P9010::going_out_of_pocket_at_feed(&feed)),
        }
    }

    /// The radius of the tool that will rough.
    fn radius_of_tool(&self, number: f64) -> Made<f64> {
        if number.fract() != 0.0 || !(1.0..=32767.0).contains(&number) {
            return self.refuse(codes::P2090::tool_that_roughs(&number));
        }
        match (self.st.radius_of)(number as u32).filter(|radius| *radius > 0.0) {
            Some(radius) => Ok(radius),
            None => self.refuse_bare(codes::P2004::cycle_21(&number).answer(Answer::tool(number, "radius"))),
        }
    }

    // What other definitions say.

    pub fn contours(&self) -> Made<&Contoured> {
        self.st.contours.ok_or(Refusal::Known)
    }

    /// Of cycle 20.
    fn data(&self) -> Made<&Kept> {
        self.contours()?.data.as_ref().ok_or(Refusal::Known)
    }

    /// What the contours make together; the path `away` from it keeps the radius Q8 of inside corners.
    fn area(&self, away: f64) -> Made<&Area> {
        match &self.contours()?.area {
            Some(area) => Ok(area),
            None => {
                let corners = if self.data()?.given.has(CORNERS) { self.kept_unsigned(CORNERS)? } else { 0.0 };
                self.without(Instead::Area { corners, away })
            }
        }
    }

    /// A parameter of cycle 20, which has to be what it was.
    fn kept(&self, name: Name) -> Made<f64> {
        self.kept_of(self.data()?, name)
    }

    fn kept_length(&self, name: Name) -> Made<f64> {
        Ok(self.kept(name)? * self.given.unit)
    }

    fn kept_unsigned(&self, name: Name) -> Made<f64> {
        let value = self.kept_length(name)?;
        if value >= 0.0 { Ok(value) } else { self.refuse_data(codes::P2090::is_below_zero(&name, &value)) }
    }

    /// A parameter of cycle 20 or 270.
    pub fn kept_of(&self, data: &Kept, name: Name) -> Made<f64> {
        if let Some(word) = data.given.word(name) {
            return self.refuse_data(no_such_word(word, name));
        }
        match (data.given.number(name), data.values.set_to(name)) {
            (None, _) => self.refuse_data(codes::P2090::is_missing(&name)),
            (Some(now), Some(set)) if set != now => self.refuse_data(codes::P2090::it_set_to_is_now(&name, &set, &now)),
            (Some(now), _) => Ok(now),
        }
    }

    /// Refuses what the definition of the data says.
    pub fn refuse_data<T>(&self, fault: Fault) -> Made<T> {
        self.without(Instead::Data(fault))
    }
}

/// A finishing cut of the wall, or of the floor.
fn finishing(feed: Feed, step: f64, (wall, arc): (bool, Option<f64>)) -> Finish {
    let onto = arc.map_or(WallApproach::Usual, WallApproach::Quarter);
    Finish { wall, floor: !wall, feed, step, speed: None, onto, inserts: false }
}
