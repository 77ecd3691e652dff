//! Milling cycles: their common parameters become a [`Mill`], and the cycle that one of them makes is sent.
//!
//! Source: K 6.0, 6.5; F B4 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill};
use crate::ir::cycle::pocket::Insertion;
use crate::ir::cycle::{Cycle, Family};
use crate::ir::function::Turn;
use crate::ir::{Feed, Pos};
use crate::machine::{Axis, AxisSet};

use super::cycles::call::Call;
use super::cycles::drilling::{FEED, PLUNGE};
use super::cycles::milling::{
    CLIMB, FEED_REFERENCE, FINISHING_FEED, FINISHING_INFEED, FLOOR_ALLOWANCE, MILLING_FEED, OPERATION, OVERLAP,
    PLUNGING, SIDE_ALLOWANCE,
};
use super::cycles::{DefinedCycle, MillingOf, Q};
use super::machining::Needs;
use super::{Outcome, Reported, Run};

/// Least and greatest factor of the overlap.
const OVERLAPS: std::ops::RangeInclusive<f64> = 0.1..=1.9999;

/// What Q215 asks for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asked {
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

impl Run<'_> {
    /// Mills where the tool stands, or at the place that the cycle names.
    pub(super) fn mill(&mut self, cycle: &DefinedCycle, making: MillingOf, call: Call) -> Outcome {
        self.cycle_may_run(cycle, Needs::Turning)?;
        self.frame_keeps_the_cutter(cycle)?;
        let Some(made) = making(self, cycle, call)? else { return Ok(()) };
        self.says_own_path(cycle);
        if !matches!(made, Cycle::ThreadMilling(_)) {
            self.warn_of_rounded_cutter(cycle);
        }
        let mut end = made.leaves(self.st.position.at());
        self.st.left_by = None;
        if ends_anywhere(&made) {
            self.says_open_end(cycle);
            self.st.left_by = Some(cycle.loc);
            let (first, second, _) = self.st.plane().axes();
            for axis in [first, second] {
                end.forget(Axis::ALL[axis]);
            }
        }
        if self.moves_beside(AxisSet::of(self.st.axis()), false) {
            return Err(Reported);
        }
        self.core.send_cycle(&made, &self.st.ctx);
        self.st.polar.forget_last();
        self.st.position.cycle_leaves(&end, AxisSet::MAIN);
        self.st.moved = true;
        Ok(())
    }

    /// The tool has the size that it has: a frame may shift, turn and mirror in the plane.
    fn frame_keeps_the_cutter(&mut self, cycle: &DefinedCycle) -> Outcome {
        let (first, second, third) = self.st.plane().axes();
        let linear = self.st.ctx.frame.linear();
        let tilted =
            [first, second].iter().any(|a| linear[(third, *a)].abs() > 1e-9 || linear[(*a, third)].abs() > 1e-9);
        let scaled = self.st.ctx.frame.uniform_scale().is_none_or(|scale| (scale - 1.0).abs() > 1e-9);
        let what = if scaled {
            "under a scaling, which would change the path and not the cutter,"
        } else if tilted || linear[(third, third)] < 0.0 {
            "while the tool axis is mirrored or tilted"
        } else {
            return Ok(());
        };
        self.report(
            codes::K9030::cycle_milling_is_not_supported(&cycle.number, &what)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Err(Reported)
    }

    /// The paths are those of a cutter with sharp corners.
    fn warn_of_rounded_cutter(&mut self, cycle: &DefinedCycle) {
        let Some(tool) = self.st.tool.active() else { return };
        let rounding = tool.corner_radius.unwrap_or(0.0) + tool.table_deltas[2] + tool.call_deltas[2];
        if rounding <= 0.0 {
            return;
        }
        let flat = 2.0 * (tool.effective_radius().unwrap_or(0.0) - rounding).max(0.0);
        self.report_once(
            codes::P8102::cycle_corner_radius_mm_of_cutter(&cycle.number, &shown(rounding), &shown(flat))
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
    }

    /// Once for each kind of cycle: which path is made.
    fn says_own_path(&mut self, cycle: &DefinedCycle) {
        let what = cycle.row().called();
        let found = codes::P8101::cycle_finished_shape_is_as_programmed(&cycle.number, &what).at(self.here.origin.loc);
        self.report_once(found.help("docs/cycles.md describes the path"));
    }

    /// Once for each kind of cycle: nobody says where the tool stands in the plane afterwards.
    fn says_open_end(&mut self, cycle: &DefinedCycle) {
        let found = codes::K8104::cycle_where_control_leaves_tool_in_working(&cycle.number).at(self.here.origin.loc);
        self.report_once(found.help("name both axes of the plane in the next block that moves in it"));
    }

    /// A block leaves the open place where a cycle ended: only a retract may, and one that names both axes.
    #[cold]
    pub(super) fn leave_open_end(&mut self, named: AxisSet, harmless: bool) {
        let Some(cycle) = self.st.left_by else { return };
        let (first, second, _) = self.st.plane().axes();
        let plane = [Axis::ALL[first], Axis::ALL[second]];
        let missing = |axis: &Axis| !named.contains(*axis) && self.st.position.get(*axis).is_none();
        let Some(axis) = plane.iter().copied().find(missing) else {
            self.st.left_by = None;
            return;
        };
        if harmless && plane.iter().all(|axis| !named.contains(*axis)) {
            return;
        }
        self.st.left_by = None;
        if self.st.position.is_lost(axis) {
            return;
        }
        self.report(
            codes::P2001::block_needs_position(&axis.letter())
                .at(self.here.origin.loc)
                .also(cycle, "the cycle is defined here"),
        );
    }

    /// Does the tool go no deeper?
    pub(super) fn rises(&self, end: &Pos) -> bool {
        let axis = self.st.axis();
        matches!((self.st.position.get(axis), end.get(axis)), (Some(from), Some(to)) if to >= from)
    }

    /// Arguments that make a cycle, or what is wrong with them.
    pub(super) fn sound<F: Family>(&mut self, cycle: &DefinedCycle, family: F) -> Outcome<F> {
        match family.check() {
            Ok(()) => Ok(family),
            Err(fault) => self.cycle_value(cycle, &fault.to_string()),
        }
    }

    /// Where the cycle is called, in the plane.
    pub(super) fn call_point(&mut self, cycle: &DefinedCycle) -> Outcome<Point2> {
        let (first, second, _) = self.st.plane().axes();
        let (span, what) = (self.block_span(), format!("cycle {}", cycle.number));
        Ok(Point2::new(
            self.position_of(Axis::ALL[first], span, &what)?,
            self.position_of(Axis::ALL[second], span, &what)?,
        ))
    }

    /// Radius of the cutter, above 0.
    pub(super) fn cutter_radius(&mut self, cycle: &DefinedCycle) -> Outcome<f64> {
        let radius = self.tool_radius(self.block_span())?;
        if radius > 0.0 {
            return Ok(radius);
        }
        self.refuse_value(cycle, codes::P2090::radius_of_tool_with_its_oversizes(&radius))
    }

    /// What milling cycles from 200 on take; nothing where the depth is 0.
    pub(super) fn cutter_of(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Mill>> {
        let axis = self.st.axis();
        if !AxisSet::MAIN.contains(axis) {
            return self.refuse_value(cycle, codes::P2090::tool_axis_cannot_mill(&axis.letter()));
        }
        let radius = self.cutter_radius(cycle)?;
        let heights = self.heights(cycle, call.shift)?;
        let deep = self.depth_below(cycle)?;
        if deep == 0.0 {
            self.has_no_depth(cycle);
            return Ok(None);
        }
        let step = self.above_zero(cycle, PLUNGE)?;
        let plane = self.cycle_feed(cycle, MILLING_FEED, None)?;
        let depth = if cycle.gives_q(FEED) { self.cycle_feed(cycle, FEED, None)? } else { plane };
        let feeds = Feeds { plane, depth };
        let heights = Heights {
            retract: call.retract.height(&heights),
            reference: heights.surface,
            clearance: heights.clearance,
            depth: heights.surface + deep,
            step,
            division: Division::Whole,
            allowance: self.not_below_zero(cycle, FLOOR_ALLOWANCE)?,
        };
        Ok(Some(Mill { plane: self.st.plane(), heights, radius, feeds }))
    }

    /// A length that has to be above 0.
    pub(super) fn above_zero(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        let value = self.cycle_length(cycle, q)?;
        if value > 0.0 {
            return Ok(value);
        }
        self.refuse_value(cycle, codes::P2090::is_not_above_zero_2(&q, &value))
    }

    /// A length without sign that may be missing.
    pub(super) fn not_below_zero(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        let value = self.optional_length(cycle, q)?;
        if value >= 0.0 {
            return Ok(value);
        }
        self.refuse_value(cycle, codes::P2090::is_below_zero(&q, &value))
    }

    /// A length that may be missing: 0.
    pub(super) fn optional_length(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        if cycle.gives_q(q) { self.cycle_length(cycle, q) } else { Ok(0.0) }
    }

    /// One of the whole numbers up to `most`; 0 where it is missing.
    pub(super) fn choice(&mut self, cycle: &DefinedCycle, q: Q, most: u32) -> Outcome<u32> {
        let value = self.cycle_option(cycle, q)?;
        if value.fract() == 0.0 && (0.0..=f64::from(most)).contains(&value) {
            return Ok(value as u32);
        }
        self.refuse_value(cycle, codes::P2090::is_not_one_of_0(&q, &value, &most))
    }

    /// Roughing and finishing by Q215 and the allowances; nothing where nothing is left to do.
    pub(super) fn asked(&mut self, cycle: &DefinedCycle, mill: &Mill) -> Outcome<Option<Asked>> {
        let allowance = self.not_below_zero(cycle, SIDE_ALLOWANCE)?;
        let step = self.not_below_zero(cycle, FINISHING_INFEED)?;
        let feed = if cycle.gives_q(FINISHING_FEED) {
            self.cycle_feed(cycle, FINISHING_FEED, None)?
        } else {
            mill.feeds.plane
        };
        let operation = self.choice(cycle, OPERATION, 2)?;
        let finishes = operation != 1;
        let (wall, floor) = (finishes && allowance > 0.0, finishes && mill.heights.allowance > 0.0);
        if operation == 2 && !wall && !floor {
            self.nothing_to_finish(cycle, "Q215 = 2 finishes, and neither Q368 nor Q369 leaves anything to finish");
            return Ok(None);
        }
        Ok(Some(Asked { rough: operation != 2, wall, floor, allowance, step, feed }))
    }

    /// A wider `allowance` than `most` would leave stock between roughing and finishing.
    pub(super) fn finishing_meets_roughing(
        &mut self,
        cycle: &DefinedCycle,
        (allowance, most): (f64, f64),
        radius: f64,
    ) -> Outcome {
        if allowance <= most + 1e-9 {
            return Ok(());
        }
        self.refuse_value(
            cycle,
            codes::P2090::allowance_on_wall_is_mm(&shown(allowance), &shown(2.0 * radius), &shown(most)),
        )
    }

    /// The floor is finished in one cut, which goes no deeper than any other.
    pub(super) fn floor_in_one_cut(&mut self, cycle: &DefinedCycle, mill: &Mill) -> Outcome {
        let Heights { allowance, step, .. } = mill.heights;
        if allowance <= step + 1e-9 {
            return Ok(());
        }
        self.refuse_value(cycle, codes::P2090::floor_would_be_finished_in_one_cut(&shown(allowance), &shown(step)))
    }

    pub(super) fn nothing_to_finish(&mut self, cycle: &DefinedCycle, what: &str) {
        self.report(
            codes::K8103::cycle(&cycle.number, &what)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
    }

    /// Does the tool go round counter-clockwise inside, clockwise outside? By Q351, with M3; cycles without it climb.
    pub(super) fn climbs(&mut self, cycle: &DefinedCycle) -> Outcome<bool> {
        let by_choice = cycle.gives_q(CLIMB);
        let climbs = match if by_choice { self.cycle_number(cycle, CLIMB)? } else { 1.0 } {
            1.0 => true,
            -1.0 => false,
            other => return self.refuse_value(cycle, codes::P2090::kind_of_milling_q351_is_not_1(&other)),
        };
        self.turns_by_m3(cycle, by_choice.then_some(CLIMB))?;
        Ok(climbs)
    }

    /// Climb and up-cut milling, by `q` where there is a choice, are defined for M3.
    pub(super) fn turns_by_m3(&mut self, cycle: &DefinedCycle, q: Option<Q>) -> Outcome {
        if self.st.spindle.turn() == Some(Turn::CounterClockwise) {
            self.report(
                codes::K9031::cycle_climb_defined_for_m3(
                    &cycle.number,
                    &q.map_or("milling is".to_owned(), |q| format!("and up-cut milling ({q}) are")),
                )
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
            );
            return Err(Reported);
        }
        self.warn_of_mirrored_sense(cycle);
        Ok(())
    }

    /// A mirror turns the way round, and not the spindle.
    fn warn_of_mirrored_sense(&mut self, cycle: &DefinedCycle) {
        let (first, second, _) = self.st.plane().axes();
        let linear = self.st.ctx.frame.linear();
        let area =
            linear[(first, first)] * linear[(second, second)] - linear[(first, second)] * linear[(second, first)];
        if area >= 0.0 {
            return;
        }
        self.report_once(
            codes::K8107::cycle_mirror_turns_climb_into_up_cut(&cycle.number)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
    }

    /// Width of a cut: Q370 radii.
    pub(super) fn overlap(&mut self, cycle: &DefinedCycle, radius: f64) -> Outcome<f64> {
        let factor = if cycle.gives_q(OVERLAP) { self.cycle_number(cycle, OVERLAP)? } else { 1.0 };
        if OVERLAPS.contains(&factor) {
            return Ok(factor * radius);
        }
        self.refuse_value(cycle, codes::P2090::overlap_factor_q370_is_not_0_1(&factor))
    }

    /// Q439 says of what Q207 is the feed.
    pub(super) fn feed_of_centre(&mut self, cycle: &DefinedCycle) -> Outcome {
        match self.choice(cycle, FEED_REFERENCE, 3)? {
            0 => Ok(()),
            other => self.refuse_cycle(cycle, codes::P9010::feed_of_cutting_edge_is_not_supported(&other)),
        }
    }

    /// How the tool goes down, by Q366, and the greatest angle of its way.
    pub(super) fn plunging(&mut self, cycle: &DefinedCycle) -> Outcome<Plunging> {
        let kind = self.choice(cycle, PLUNGING, 2)?;
        if kind == 0 {
            return Ok(Plunging::Vertical);
        }
        Ok(match self.plunging_angle(cycle, &format!("Q366 = {kind}"), "Q366 = 0")? {
            None => Plunging::Vertical,
            Some(angle) if kind == 1 => Plunging::Helix(angle),
            Some(angle) => Plunging::Sway(angle),
        })
    }

    /// ANGLE of the tool, which `asked` needs; none for one that goes straight down.
    pub(super) fn plunging_angle(&mut self, cycle: &DefinedCycle, asked: &str, without: &str) -> Outcome<Option<Deg>> {
        match self.st.tool.active().and_then(|tool| tool.plunge_angle) {
            Some(angle) if angle >= 90.0 => Ok(None),
            Some(angle) if angle > 0.0 => Ok(Some(Deg(angle))),
            known => {
                let what = if known.is_some() { "is 0: it cannot plunge so" } else { "is not known" };
                let called = self.st.tool.active().map(|tool| tool.called.clone()).unwrap_or_default();
                self.report(
                    codes::K2902::cycle_needs_plunging_angle_angle_of_tool(
                        &cycle.number,
                        &asked,
                        &called,
                        &what,
                        &without,
                    )
                    .answer(Answer::tool(&called, "plunge_angle"))
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
                );
                Err(Reported)
            }
        }
    }

    /// The tool is larger than what it shall mill.
    pub(super) fn tool_too_large<T>(&mut self, cycle: &DefinedCycle, what: &str) -> Outcome<T> {
        self.report_cause(
            codes::K2901::cycle_tool_radius_too_large(&cycle.number, &what)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Err(Reported)
    }

    /// There is no way for a helix or a stroke of the tool.
    pub(super) fn no_room_to_plunge<T>(&mut self, cycle: &DefinedCycle, kind: u32) -> Outcome<T> {
        self.report(
            codes::K2903::cycle_pocket_has_no_room_for_plunging(&cycle.number, &kind)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Err(Reported)
    }
}

/// Without the last digits of arithmetic.
pub(super) fn shown(length: f64) -> f64 {
    libm::round(length * 1e6) / 1e6
}

/// Is the place open at which the control leaves the tool?
fn ends_anywhere(made: &Cycle) -> bool {
    match made {
        Cycle::Pocket(pocket) => pocket.home.is_none(),
        Cycle::Spigot(_)
        | Cycle::Facing(_)
        | Cycle::Ruled(_)
        | Cycle::Region(_)
        | Cycle::PilotHoles(_)
        | Cycle::PathMilling(_) => true,
        _ => false,
    }
}

/// How a milling cycle gets to a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Plunging {
    Vertical,
    /// Greatest angle of the way.
    Helix(Deg),
    Sway(Deg),
}

impl Plunging {
    /// As an insertion of a slot, along which the tool goes to and fro.
    pub fn along(self) -> Insertion {
        match self {
            Plunging::Vertical => Insertion::Vertical,
            Plunging::Helix(angle) | Plunging::Sway(angle) => Insertion::Sway { angle, stroke: None },
        }
    }
}
