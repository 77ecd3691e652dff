//! Cycles 220 and 221, and CYCL CALL POS: a machining cycle at many places.
//!
//! Source: K 4.4 and 6.4 (docs/sources.md). On the way to the first place the tool goes to the 2nd set-up clearance
//! unless it stands higher; Q301 decides how high it goes from place to place; after the last one it stands at the 2nd
//! set-up clearance.

use crate::diag::{Answer, codes};
use crate::geo::Point2;
use crate::ir::contour::Path;
use crate::ir::{Feed, Pos};
use crate::machine::{Axis, AxisSet};
use crate::parser::klartext::ast::Block;
use crate::sema::common::plane::plane_axes;
use crate::sema::cycle::given::Given;
use crate::text::Loc;

use super::cycles::call::{By, Calling, Heights, Retract};
use super::cycles::faces::TOP;
use super::cycles::holes::OLD_CLEARANCE;
use super::cycles::patterns::{AT_SECOND, ON_ARCS, SAME_PLACE, repeated};
use super::cycles::{self, DefinedCycle, SURFACE};
use super::words::{Admits, FeedWord, Words};
use super::{Outcome, Reported, Run};

/// Cycles from this number on say their heights, and have no contour with a place of its own.
pub(super) const FIRST_PLACED: u32 = 200;

/// Places whose computing is one step.
pub(super) const PLACES_A_STEP: u64 = 16;

impl Run<'_> {
    /// Runs the machining cycle at the places of a pattern, whose Q200, Q203 and Q204 hold instead of its own.
    pub(super) fn pattern_cycle(&mut self, pattern: &DefinedCycle, places: Option<cycles::Places>) -> Outcome {
        let by = format!("cycle {}", pattern.number);
        let cycle = self.pattern_subject(&by)?;
        let Some(places) = places else {
            return self.refuse_cycle(pattern, codes::P9010::this_pattern_is_not_supported());
        };
        self.all_are_set(pattern)?;
        let old = matches!(cycle.number, 1..=5 | 17);
        if cycle.number < FIRST_PLACED && !old {
            return self.refuse_cycle(pattern, codes::P9010::pattern_of_cycle_is_not_supported(&cycle.number));
        }
        let of_pattern = self.checked(pattern)?;
        if of_pattern.or_zero(ON_ARCS) != 0.0 {
            return self.refuse_cycle(pattern, codes::P9010::going_from_place_to_place_on_arcs());
        }
        let places = self.planned(pattern, &of_pattern, Calling::HERE, None, places)?;
        let near = of_pattern.whole(AT_SECOND) == 0;
        self.core.budget.take(places.len() as u64 / PLACES_A_STEP);
        self.warn_of_repeated_places(&by, places.iter().copied(), pattern.loc);
        let heights = self.heights(pattern, &of_pattern, 0.0);
        self.same_unit(&cycle)?;
        let given = self.checked(&cycle)?;
        self.surfaces_agree(pattern, (&cycle, &given), &heights)?;
        if old {
            self.clearances_agree(pattern, (&cycle, &given), &heights)?;
        }
        self.lift_to(&heights);
        for (i, place) in places.iter().enumerate() {
            self.core.goes_on()?;
            self.rapid_in_plane(*place);
            let last = i + 1 == places.len();
            let retract = if near && !last { Retract::Near } else { Retract::Far };
            if old {
                self.rapid_to(heights.start());
            }
            self.run_given(&cycle, &given, Calling { shift: 0.0, retract, by: By::Pattern })?;
            if old {
                self.rapid_to(retract.height(&heights));
            }
        }
        Ok(())
    }

    /// A face has a height of its own in place of Q203, which the pattern would have to override.
    fn surfaces_agree(
        &self,
        pattern: &DefinedCycle,
        (cycle, given): (&DefinedCycle, &Given),
        heights: &Heights,
    ) -> Outcome {
        let Some(own) = given.length_if(TOP).filter(|own| (own - heights.surface).abs() > SAME_PLACE) else {
            return Ok(());
        };
        self.refuse_cycle(pattern, codes::P2090::q203_of_pattern(&heights.surface, &cycle.number, &own))
    }

    /// The old cycles work from where the tool stands, the set-up clearance of the pattern.
    fn clearances_agree(
        &self,
        pattern: &DefinedCycle,
        (cycle, given): (&DefinedCycle, &Given),
        heights: &Heights,
    ) -> Outcome {
        let own = given.magnitude(OLD_CLEARANCE);
        if (own - heights.clearance).abs() <= SAME_PLACE {
            return Ok(());
        }
        let fault = codes::P2090::set_up_clearance_1_of_cycle(&cycle.number, &own, &heights.clearance);
        self.refuse_cycle(pattern, fault)
    }

    fn rapid_to(&mut self, height: f64) {
        let axis = self.st.axis();
        if self.st.position.get(axis) != Some(height) {
            let mut end = Pos::UNKNOWN;
            end.set(axis, height);
            self.send(&end, Path::Rapid);
        }
    }

    /// Places of CYCL CALL PAT and POS lift the surface Q203.
    pub(super) fn has_a_surface(&self, cycle: &DefinedCycle, by: &str) -> Outcome {
        if cycle.row().needed().any(|name| name == SURFACE) {
            return Ok(());
        }
        self.refuse_cycle(cycle, codes::P9010::with_face_which_has_heights(&by))
    }

    /// A place that stands in the list twice is machined twice.
    pub(super) fn warn_of_repeated_places(&self, what: &str, places: impl Iterator<Item = Point2>, loc: Loc) {
        if let Some(fault) = repeated(what, places) {
            self.core.report(fault.at(loc));
        }
    }

    /// To the 2nd set-up clearance, unless the tool is known to stand there or higher.
    fn lift_to(&mut self, heights: &Heights) {
        let axis = self.st.axis();
        if self.st.position.get(axis).is_some_and(|at| at >= heights.second) {
            return;
        }
        self.rapid_to(heights.second);
    }

    fn rapid_in_plane(&mut self, place: Point2) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(self.st.plane(), place);
        self.st.polar.forget_last();
        self.send(&end, Path::Rapid);
    }

    /// Feed of the way from place to place; `None` for rapid traverse.
    pub(super) fn pattern_feed(&mut self, w: &Words, call: &str) -> Outcome<Option<Feed>> {
        self.set_feed(w)?;
        if w.feed != FeedWord::None {
            return self.move_feed(w);
        }
        let rapid = self.core.job.settings.control.klartext_readings.pattern_at_rapid;
        let (way, feed) =
            if rapid { ("at rapid traverse", None) } else { ("at the feed programmed last", self.move_feed(w)?) };
        self.core.report(
            codes::K2806::has_no_f(&call, &way).answer(Answer::key("control", "pattern_feed")).at(self
                .core
                .here
                .origin
                .loc),
        );
        Ok(feed)
    }

    /// CYCL CALL POS without the tool axis: the surface is that of the cycle.
    fn names_its_surface(&self, named: AxisSet, axis: Axis) {
        if named.contains(axis) {
            return;
        }
        let axis = axis.letter();
        self.core.report(codes::K8027::cycl_call_pos_names_no(&axis).at(self.core.here.origin.loc));
    }

    /// CYCL CALL POS: to the position in the plane, then the cycle, whose surface Z lifts. Where the tool stands below
    /// the surface, it first goes to the set-up clearance.
    pub(super) fn run_cycle_at(&mut self, cycle: &DefinedCycle, block: &Block) -> Outcome {
        // The first word is POS itself.
        let mut rest = block.clone();
        rest.words.drain(..1);
        let w = self.gather(&rest, "CYCL CALL POS", Admits::AXES.and(Admits::FEED).and(Admits::M))?;
        self.check_m(&w)?;
        self.forbid_m(&w, "CYCL CALL POS", &[2, 30, 89, 91, 92, 99])?;
        let axis = self.st.axis();
        let plane = plane_axes(self.st.plane());
        let named = w.axes.known();
        let strange = !named.without(plane.union(AxisSet::of(axis))).is_empty();
        if cycle.number < FIRST_PLACED || !w.incremental.is_empty() || strange || !plane.without(named).is_empty() {
            let span = if w.axes_span.is_empty() { self.core.block_span() } else { w.axes_span };
            return self.core.refuse(span, codes::P9010::cycl_call_pos_is_supported_for_cycles());
        }
        self.has_a_surface(cycle, "CYCL CALL POS")?;
        self.names_its_surface(named, axis);
        self.m_at_start(&w, true)?;
        let feed = self.pattern_feed(&w, "CYCL CALL POS")?;
        let shift = w.axes.get(axis).unwrap_or(0.0);
        self.same_unit(cycle)?;
        let given = self.checked(cycle)?;
        let heights = self.heights(cycle, &given, shift);
        let Some(at) = self.st.position.get(axis) else {
            self.position_of(axis, w.axes_span, "CYCL CALL POS")?;
            return Err(Reported);
        };
        if at < heights.surface {
            let mut up = Pos::UNKNOWN;
            up.set(axis, heights.start());
            self.send(&up, Path::Rapid);
        }
        let mut end = Pos::UNKNOWN;
        for axis in plane.iter() {
            end.set(axis, w.axes.get(axis).unwrap_or(0.0));
        }
        self.st.polar.forget_last();
        self.send(&end, Path::straight(feed));
        self.run_given(cycle, &given, Calling { shift, retract: Retract::Far, by: By::Position })?;
        self.m_at_end(&w)
    }
}
