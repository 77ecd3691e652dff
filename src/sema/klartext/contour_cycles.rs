//! Pockets along contours of subprograms, with islands: cycles 21 to 24.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Answer, codes};
use crate::geo::overlay::Area;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{Ahead, Levels, Method, usual_ahead};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill};
use crate::ir::cycle::pocket::{Finish, Insertion, Onto};
use crate::ir::cycle::region::Coarse;
use crate::ir::cycle::{Cycle, Drilling, PilotHoles, Region};
use crate::machine::{Axis, AxisSet};

use super::contour_data::{Known, NamedContours, Roughed, Values};
use super::cycles::call::Call;
use super::cycles::contours::{COARSE_TOOL, FEED_FACTOR, RECIPROCATING_FEED, RETRACT_FEED};
use super::cycles::contours::{
    DEPTH, DIRECTION, FLOOR, HEIGHT, INFEED, LEFT, MILLING_FEED, OVERLAP, PLUNGING_FEED, ROUGHING_TOOL, SET_UP, SIDE,
    SURFACE,
};
use super::cycles::{DefinedCycle, Q};
use super::drilling::steps;
use super::pockets::rounded;
use super::{Outcome, Reported, Run};

/// What a control takes for rapid traverse.
const FASTEST: f64 = 99_999.0;
/// Least and greatest factor of the overlap.
const OVERLAPS: core::ops::RangeInclusive<f64> = 0.1..=1.9999;

/// What the cycles of a pocket take.
pub(super) struct Pocket {
    pub named: Rc<NamedContours>,
    pub data: Rc<Values>,
}

impl Run<'_> {
    /// The contours that the cycle takes.
    pub(super) fn named_contours(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Rc<NamedContours>> {
        if call.placed() {
            return self.refuse_cycle(cycle, codes::P9010::contour_at_places_of_pattern());
        }
        match &self.contours.named {
            Known::Lost => Err(Reported),
            Known::Nothing => {
                self.lacks(cycle, "no contour is named in front of it", "write CYCL DEF 14.0 and 14.1 CONTOUR LABEL 1")
            }
            Known::Given(named) => {
                let named = Rc::clone(named);
                if named.program == self.level().program {
                    return Ok(named);
                }
                self.refuse_cycle(cycle, codes::P9010::contour_whose_label_stands_in_another_program())
            }
        }
    }

    fn lacks<T>(&mut self, cycle: &DefinedCycle, what: &str, help: &str) -> Outcome<T> {
        self.report(
            codes::K2952::cycle(&cycle.number, &what)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here")
                .help(help),
        );
        Err(Reported)
    }

    fn pocket_data(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Pocket> {
        let named = self.named_contours(cycle, call)?;
        let data = match &self.contours.pocket {
            Known::Lost => return Err(Reported),
            Known::Nothing => {
                return self.lacks(cycle, "there is no contour data in front of it", "write CYCL DEF 20 with Q1 to Q9");
            }
            Known::Given(data) => Rc::clone(data),
        };
        Ok(Pocket { named, data })
    }

    /// What all cycles of a pocket take, for a cutter of this radius; nothing where the depth is 0.
    fn contour_mill(
        &mut self,
        cycle: &DefinedCycle,
        data: &Values,
        radius: f64,
        (feeds, step): (Feeds, f64),
    ) -> Outcome<Option<Mill>> {
        let deep = self.kept_length(data, DEPTH)?;
        let surface = self.kept_length(data, SURFACE)?;
        let heights = Heights {
            retract: self.kept_length(data, HEIGHT)?,
            reference: surface,
            clearance: self.kept_unsigned(data, SET_UP)?,
            depth: surface + deep,
            step,
            division: Division::Whole,
            allowance: self.kept_unsigned(data, FLOOR)?,
        };
        self.mill_down(cycle, deep, Mill { plane: self.st.plane(), heights, radius, feeds })
    }

    /// A depth has a minus sign; with 0 the control does nothing.
    pub(super) fn mill_down(&mut self, cycle: &DefinedCycle, deep: f64, mill: Mill) -> Outcome<Option<Mill>> {
        let axis = self.st.axis();
        if !AxisSet::MAIN.contains(axis) {
            return self.refuse_value(cycle, codes::P2090::tool_axis_cannot_mill(&axis.letter()));
        }
        if deep > 0.0 {
            return self.refuse_value(cycle, codes::P2090::depth_q1_is_positive(&deep));
        }
        if deep == 0.0 {
            self.report(
                codes::K2404::cycle_has_depth_0(&cycle.number)
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
            return Ok(None);
        }
        Ok(Some(mill))
    }

    pub(super) fn contour_feeds(&mut self, cycle: &DefinedCycle) -> Outcome<Feeds> {
        Ok(Feeds {
            plane: self.cycle_feed(cycle, MILLING_FEED, None)?,
            depth: self.cycle_feed(cycle, PLUNGING_FEED, None)?,
        })
    }

    /// Q10: old programs write the infeed with the sign of the depth.
    pub(super) fn contour_infeed(&mut self, cycle: &DefinedCycle) -> Outcome<f64> {
        let step = self.cycle_length(cycle, INFEED)?.abs();
        if step > 0.0 { Ok(step) } else { self.refuse_value(cycle, codes::P2090::infeed_q10_is_0()) }
    }

    /// Q9 and Q15: does the tool climb?
    pub(super) fn is_climb(&mut self, cycle: &DefinedCycle, q: Q, value: f64) -> Outcome<bool> {
        self.turns_by_m3(cycle, Some(q))?;
        match value {
            1.0 => Ok(true),
            -1.0 => Ok(false),
            other => self.refuse_value(cycle, codes::P2090::kind_of_milling_is_not_1(&q, &other)),
        }
    }

    /// The pocket, as cycle 22 roughs it with this cutter.
    fn roughed_pocket(&mut self, cycle: &DefinedCycle, pocket: &Pocket, mill: Mill) -> Outcome<Region> {
        let data = &pocket.data;
        let direction = self.kept(data, DIRECTION)?;
        let counter_clockwise = self.is_climb(cycle, DIRECTION, direction)?;
        let factor = self.kept(data, OVERLAP)?;
        if !OVERLAPS.contains(&factor) {
            return self.refuse_value(&data.cycle, codes::P2090::overlap_factor_q2_is_not_0_1(&factor));
        }
        let allowance = self.kept_unsigned(data, SIDE)?;
        let Area { outlines, islands } = self.contour_area(cycle, pocket, mill.radius + allowance)?;
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
    pub(super) fn pilot_drilling(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let pocket = self.pocket_data(cycle, call)?;
        let feed = self.cycle_feed(cycle, PLUNGING_FEED, None)?;
        let number = self.cycle_number(cycle, ROUGHING_TOOL)?;
        let radius = self.radius_of_tool(cycle, number)?;
        let step = self.contour_infeed(cycle)?;
        let feeds = Feeds { plane: feed, depth: feed };
        let Some(mill) = self.contour_mill(cycle, &pocket.data, radius, (feeds, step))? else { return Ok(None) };
        let region = self.roughed_pocket(cycle, &pocket, mill)?;
        let (heights, axis) = (mill.heights, Axis::ALL[mill.plane.axes().2]);
        let levels = Levels {
            retract: heights.retract,
            reference: heights.reference,
            clearance: heights.clearance,
            depth: heights.rough_floor(),
        };
        let mut peck = steps(step, (0.0, 0.0), 0.0);
        peck.removal.ahead = Ahead::Evenly([usual_ahead((levels.reference - levels.depth).abs()); 2]);
        let hole = Drilling { axis, levels, feed, entry: None, method: Method::Peck(peck) };
        self.sound(cycle, PilotHoles { pocket: Box::new(region), hole }).map(|made| Some(Cycle::PilotHoles(made)))
    }

    /// Cycle 22.
    pub(super) fn rough_out(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let pocket = self.pocket_data(cycle, call)?;
        let coarse = self.coarse_tool(cycle, &pocket)?;
        let (insertion, insertion_feed) = self.insertion_by_feed(cycle)?;
        if cycle.gives_q(FEED_FACTOR) && self.cycle_number(cycle, FEED_FACTOR)? != 100.0 {
            return self.cycle_otherwise(
                cycle,
                "a lower feed at full engagement (Q401)",
                "write Q401=+100, and Q12 as the feed that the tool bears at full engagement",
            );
        }
        self.retracts_at_rapid(cycle)?;
        let radius = self.cutter_radius(cycle)?;
        let (feeds, step) = (self.contour_feeds(cycle)?, self.contour_infeed(cycle)?);
        let Some(mill) = self.contour_mill(cycle, &pocket.data, radius, (feeds, step))? else { return Ok(None) };
        let region = self.roughed_pocket(cycle, &pocket, mill)?;
        let made = self.sound(cycle, Region { insertion, insertion_feed, coarse, ..region })?;
        let area = Area { outlines: made.outlines.clone(), islands: made.islands.clone() };
        let frame = self.st.ctx.frame.clone();
        let tool = self.st.tool.active().map(|tool| tool.called.to_string());
        let allowance = made.allowance;
        let oversize = self.st.tool.active().map_or(0.0, |tool| tool.table_deltas[1] + tool.call_deltas[1]);
        self.contours.roughed = Known::Given(Rc::new(Roughed {
            named: pocket.named,
            tool,
            radius,
            oversize,
            allowance,
            area,
            frame,
            pocket: pocket.data,
        }));
        Ok(Some(Cycle::Region(made)))
    }

    /// Cycle 23.
    pub(super) fn floor_finishing(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let pocket = self.pocket_data(cycle, call)?;
        self.retracts_at_rapid(cycle)?;
        let radius = self.cutter_radius(cycle)?;
        let feeds = self.contour_feeds(cycle)?;
        let Some(mill) = self.contour_mill(cycle, &pocket.data, radius, (feeds, 0.0))? else { return Ok(None) };
        let region = self.roughed_pocket(cycle, &pocket, mill)?;
        let finish = Some(finishing(feeds.plane, 0.0, (false, None)));
        let cleared = self.is_roughed(&pocket, &region);
        self.warn_of_larger_cutter(&pocket, radius);
        self.sound(cycle, Region { rough: false, finish, cleared, ..region }).map(|made| Some(Cycle::Region(made)))
    }

    /// Cycle 24.
    pub(super) fn side_finishing(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let pocket = self.pocket_data(cycle, call)?;
        let radius = self.cutter_radius(cycle)?;
        let (feeds, step) = (self.contour_feeds(cycle)?, self.contour_infeed(cycle)?);
        let Some(mill) = self.contour_mill(cycle, &pocket.data, radius, (feeds, step))? else { return Ok(None) };
        let mill = Mill { heights: Heights { allowance: 0.0, ..mill.heights }, ..mill };
        let left = self.not_below_zero(cycle, LEFT)?;
        let allowance = self.kept_unsigned(&pocket.data, SIDE)?;
        let roughed = self.roughed_before()?.filter(|roughed| {
            Rc::ptr_eq(&roughed.named, &pocket.named)
                && roughed.allowance == allowance
                && roughed.frame == self.st.ctx.frame
        });
        let by = roughed.map_or(0.0, |roughed| roughed.radius);
        if left + radius >= allowance + by {
            let tool = if by == 0.0 {
                "0, because no cycle 22 roughed this contour here, with this Q3, before".to_owned()
            } else {
                by.to_string()
            };
            return self.refuse_value(
                cycle,
                codes::P2090::q14_radius_of_cutter_together_are_not(&left, &radius, &allowance, &tool),
            );
        }
        let direction = self.cycle_number(cycle, DIRECTION)?;
        let counter_clockwise = self.is_climb(cycle, DIRECTION, direction)?;
        let Area { outlines, islands } = self.contour_area(cycle, &pocket, radius + left)?;
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
        self.sound(cycle, region).map(|made| Some(Cycle::Region(made)))
    }

    /// What a larger cutter left goes in one cut.
    fn warn_of_larger_cutter(&mut self, pocket: &Pocket, radius: f64) {
        let Known::Given(roughed) = &self.contours.roughed else { return };
        let before = roughed.radius;
        if before > radius && Rc::ptr_eq(&roughed.pocket, &pocket.data) && roughed.frame == self.st.ctx.frame {
            let found = codes::K8109::cycle_23_with_cutter_of_radius_mm(&rounded(radius), &rounded(before))
                .at(self.here.origin.loc);
            self.report(found.help("let a cycle 22 with this tool and Q18 run in between"));
        }
    }

    /// Was this pocket roughed here, with these data, and by no larger cutter?
    fn is_roughed(&self, pocket: &Pocket, region: &Region) -> bool {
        let Known::Given(roughed) = &self.contours.roughed else { return false };
        Rc::ptr_eq(&roughed.pocket, &pocket.data)
            && (&roughed.area.outlines, &roughed.area.islands) == (&region.outlines, &region.islands)
            && roughed.frame == self.st.ctx.frame
            && roughed.radius <= region.mill.radius
    }

    /// The last run of cycle 22. What needs one that was refused suffers only from that.
    fn roughed_before(&self) -> Outcome<Option<Rc<Roughed>>> {
        match &self.contours.roughed {
            Known::Nothing => Ok(None),
            Known::Lost => Err(Reported),
            Known::Given(roughed) => Ok(Some(Rc::clone(roughed))),
        }
    }

    /// Q18: what the tool cleared that roughed these contours before.
    fn coarse_tool(&mut self, cycle: &DefinedCycle, pocket: &Pocket) -> Outcome<Option<Box<Coarse>>> {
        let number = self.cycle_option(cycle, COARSE_TOOL)?;
        if number == 0.0 {
            return Ok(None);
        }
        let radius = self.cutter_radius(cycle)?;
        let before = self.roughed_before()?.filter(|before| {
            Rc::ptr_eq(&before.pocket, &pocket.data)
                && Rc::ptr_eq(&before.named, &pocket.named)
                && before.tool.as_deref() == Some(&number.to_string())
                && before.frame == self.st.ctx.frame
        });
        let Some(before) = before else {
            return self.refuse_value(cycle, codes::P2090::no_cycle_22_with_tool(&number));
        };
        if before.oversize > 0.0 {
            return self
                .refuse_value(cycle, codes::P2090::coarse_tool_q18_cut_with_oversize(&number, &before.oversize));
        }
        let (coarse, Area { outlines, islands }) = (before.radius, before.area.clone());
        let allowance = before.allowance;
        if coarse <= radius {
            return self.refuse_value(cycle, codes::P2090::coarse_tool(&number, &coarse, &radius));
        }
        Ok(Some(Box::new(Coarse { radius: coarse, allowance, outlines, islands })))
    }

    /// Q19: 0 is straight down, else to and fro at the angle of the tool, with this feed.
    fn insertion_by_feed(&mut self, cycle: &DefinedCycle) -> Outcome<(Insertion, Option<Feed>)> {
        if self.cycle_option(cycle, RECIPROCATING_FEED)? == 0.0 {
            return Ok((Insertion::Vertical, None));
        }
        let feed = self.cycle_feed(cycle, RECIPROCATING_FEED, None)?;
        let insertion = match self.plunging_angle(cycle, "Q19 above 0", "Q19 = 0")? {
            Some(angle) => Insertion::Sway { angle, stroke: None },
            None => Insertion::Vertical,
        };
        Ok((insertion, Some(feed)))
    }

    /// Q18
    pub(super) fn no_coarse_tool(&mut self, cycle: &DefinedCycle) -> Outcome {
        if self.cycle_option(cycle, COARSE_TOOL)? == 0.0 {
            return Ok(());
        }
        self.refuse_cycle(cycle, codes::P9010::what_coarse_tool())
    }

    /// Q208
    fn retracts_at_rapid(&mut self, cycle: &DefinedCycle) -> Outcome {
        if !cycle.gives_q(RETRACT_FEED) || cycle.word(RETRACT_FEED) == Some("FMAX") {
            return Ok(());
        }
        let feed = self.cycle_number(cycle, RETRACT_FEED)?;
        if feed >= FASTEST {
            Ok(())
        } else {
            self.refuse_cycle(cycle, codes::P9010::going_out_of_pocket_at_feed(&feed))
        }
    }

    /// The radius of the tool that will rough.
    fn radius_of_tool(&mut self, cycle: &DefinedCycle, number: f64) -> Outcome<f64> {
        if number.fract() != 0.0 || !(1.0..=32767.0).contains(&number) {
            return self.refuse_value(cycle, codes::P2090::tool_that_roughs(&number));
        }
        match self.radius_by_number(number as u32).filter(|radius| *radius > 0.0) {
            Some(radius) => Ok(radius),
            None => {
                self.refuse(self.block_span(), codes::P2004::cycle_21(&number).answer(Answer::tool(number, "radius")))
            }
        }
    }
}

/// A finishing cut of the wall, or of the floor.
fn finishing(feed: Feed, step: f64, (wall, arc): (bool, Option<f64>)) -> Finish {
    let onto = arc.map_or(Onto::Usual, Onto::Quarter);
    Finish { wall, floor: !wall, feed, step, speed: None, onto, inserts: false }
}
