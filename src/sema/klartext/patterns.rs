//! Cycles 220 and 221, and CYCL CALL POS: a machining cycle at many places.
//!
//! Source: K 4.4 and 6.4 (docs/sources.md). On the way to the first place the tool goes to the 2nd set-up clearance
//! unless it stands higher; Q301 decides how high it goes from place to place; after the last one it stands at the 2nd
//! set-up clearance.

use crate::diag::{Answer, Fault, codes};
use crate::geo::Point2;
use crate::ir::contour::Path;
use crate::ir::{Feed, Pos};
use crate::machine::AxisSet;
use crate::parser::klartext::ast::Block;
use crate::sema::common::plane::plane_axes;
use crate::sema::cycle::given::Given;

use super::cycles::call::{By, Calling, Heights, Retract};
use super::cycles::faces::TOP;
use super::cycles::holes::OLD_CLEARANCE;
use super::cycles::patterns::{AT_SECOND, ON_ARCS, SAME_PLACE, repeated};
use super::cycles::{self, DefinedCycle, SURFACE};
use super::words::{Admits, FeedWord, Words};
use super::{Core, Outcome, Reported, Run};

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
            return pattern.refuse(&self.core, codes::P9010::this_pattern_is_not_supported());
        };
        pattern.all_are_set(&self.core)?;
        let old = matches!(cycle.number, 1..=5 | 17);
        if cycle.number < FIRST_PLACED && !old {
            return pattern.refuse(&self.core, codes::P9010::pattern_of_cycle_is_not_supported(&cycle.number));
        }
        let of_pattern = self.checked(pattern)?;
        if of_pattern.or_zero(ON_ARCS) != 0.0 {
            return pattern.refuse(&self.core, codes::P9010::going_from_place_to_place_on_arcs());
        }
        let places = self.planned(pattern, &of_pattern, Calling::HERE, None, places)?;
        let near = of_pattern.whole(AT_SECOND) == 0;
        self.core.budget.take(places.len() as u64 / PLACES_A_STEP);
        if let Some(fault) = repeated(&by, places.iter().copied()) {
            self.core.report(fault.at(pattern.loc));
        }
        let heights = pattern.heights(&self.core, &of_pattern, 0.0);
        cycle.same_unit(&self.core)?;
        let given = self.checked(&cycle)?;
        if let Some(fault) = contradicts(&heights, &cycle, &given, old) {
            return pattern.refuse(&self.core, fault);
        }
        self.rise_to(heights.second);
        for (i, place) in places.iter().enumerate() {
            self.core.goes_on()?;
            self.go_in_plane(*place, Path::Rapid);
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

    /// To this height along the tool axis, unless the tool is known to stand there or higher.
    pub(super) fn rise_to(&mut self, height: f64) {
        if self.st.position.get(self.st.axis()).is_none_or(|at| at < height) {
            self.rapid_to(height);
        }
    }

    fn rapid_to(&mut self, height: f64) {
        let axis = self.st.axis();
        if self.st.position.get(axis) != Some(height) {
            let mut end = Pos::UNKNOWN;
            end.set(axis, height);
            self.send(&end, Path::Rapid);
        }
    }

    pub(super) fn go_in_plane(&mut self, place: Point2, path: Path) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(self.st.plane(), place);
        self.st.polar.forget_last();
        self.send(&end, path);
    }

    /// Feed of the way from place to place; `None` for rapid traverse.
    pub(super) fn pattern_feed(&mut self, w: &Words, call: &str) -> Outcome<Option<Feed>> {
        self.st.set_feed(&self.core, w)?;
        if w.feed != FeedWord::None {
            return self.st.feed.of_move(&self.core, w);
        }
        let (way, feed) = match self.core.job.settings.control.klartext_readings.pattern_at_rapid {
            true => ("at rapid traverse", None),
            false => ("at the feed programmed last", self.st.feed.of_move(&self.core, w)?),
        };
        self.core.say_here(codes::K2806::has_no_f(&call, &way).answer(Answer::key("control", "pattern_feed")));
        Ok(feed)
    }

    /// CYCL CALL POS: to the position in the plane, then the cycle, whose surface Z lifts. Where the tool stands below
    /// the surface, it first goes to the set-up clearance.
    pub(super) fn run_cycle_at(&mut self, cycle: &DefinedCycle, block: &Block) -> Outcome {
        // The first word is POS itself.
        let mut rest = block.clone();
        rest.words.drain(..1);
        let admits = Admits::AXES.and(Admits::FEED).and(Admits::M);
        let w = self.gather_m(&rest, "CYCL CALL POS", admits, &[2, 30, 89, 91, 92, 99])?;
        let axis = self.st.axis();
        let plane = plane_axes(self.st.plane());
        let named = w.axes.known();
        let strange = !named.without(plane.union(AxisSet::of(axis))).is_empty();
        if cycle.number < FIRST_PLACED || !w.incremental.is_empty() || strange || !plane.without(named).is_empty() {
            let span = if w.axes_span.is_empty() { self.core.block_span() } else { w.axes_span };
            return self.core.refuse(span, codes::P9010::cycl_call_pos_is_supported_for_cycles());
        }
        cycle.has_a_surface(&self.core, "CYCL CALL POS")?;
        // Else the surface is that of the cycle.
        if !named.contains(axis) {
            self.core.say_here(codes::K8027::cycl_call_pos_names_no(&axis.letter()));
        }
        self.m_at_start(&w, true)?;
        let feed = self.pattern_feed(&w, "CYCL CALL POS")?;
        let shift = w.axes.get(axis).unwrap_or(0.0);
        cycle.same_unit(&self.core)?;
        let given = self.checked(cycle)?;
        let heights = cycle.heights(&self.core, &given, shift);
        let Some(at) = self.st.position.get(axis) else {
            self.view().position_of(axis, w.axes_span, "CYCL CALL POS")?;
            return Err(Reported);
        };
        if at < heights.surface {
            self.rapid_to(heights.start());
        }
        let mut end = Pos::UNKNOWN;
        for axis in plane.iter() {
            end.set(axis, w.axes.get(axis).unwrap_or(0.0));
        }
        self.st.polar.forget_last();
        self.send(&end, Path::straight(feed));
        self.run_given(cycle, &given, Calling { shift, retract: Retract::Far, by: By::Position })?;
        self.m_at_end(w.m())
    }
}

/// Heights that the cycle says otherwise than the pattern, whose Q200, Q203 and Q204 would have to hold.
fn contradicts(heights: &Heights, cycle: &DefinedCycle, given: &Given, old: bool) -> Option<Fault> {
    // A face has a height of its own in place of Q203.
    if let Some(own) = given.length_if(TOP).filter(|own| (own - heights.surface).abs() > SAME_PLACE) {
        return Some(codes::P2090::q203_of_pattern(&heights.surface, &cycle.number, &own));
    }
    // The old cycles work from where the tool stands, the set-up clearance of the pattern.
    let own = if old { given.magnitude(OLD_CLEARANCE) } else { heights.clearance };
    let differs = (own - heights.clearance).abs() > SAME_PLACE;
    differs.then(|| codes::P2090::set_up_clearance_1_of_cycle(&cycle.number, &own, &heights.clearance))
}

impl DefinedCycle {
    /// Places of CYCL CALL PAT and POS lift the surface Q203.
    pub(super) fn has_a_surface(&self, core: &Core<'_>, by: &str) -> Outcome {
        if self.row().needed().any(|name| name == SURFACE) {
            return Ok(());
        }
        self.refuse(core, codes::P9010::with_face_which_has_heights(&by))
    }
}
