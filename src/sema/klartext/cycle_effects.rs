//! What a planned cycle does: it is sent, and leaves the tool, the spindle and what the program may do next.
//!
//! Source: K 6.0, 6.5; F B4 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Label, codes};
use crate::ir::Pos;
use crate::ir::cycle::drilling::{DeepHole, Method, Tap};
use crate::ir::cycle::{Cycle, Drilling};
use crate::ir::function::{Coolant, Spindle};
use crate::machine::{Axis, AxisSet};

use super::cycles::machining::shown;
use super::cycles::{DefinedCycle, Planned};
use super::known::Known;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn send_planned(&mut self, cycle: &DefinedCycle, planned: Planned) -> Outcome {
        self.core.budget.take(planned.steps);
        if let Some(roughed) = planned.roughed {
            self.contours.roughed = Known::Given(Rc::from(roughed));
        }
        match planned.cycle {
            Some(made) if cycle.row().drills() => self.send_hole(&made),
            Some(made) => self.send_milled(cycle, &made),
            None => Ok(()),
        }
    }

    /// Drills where the tool stands.
    fn send_hole(&mut self, made: &Cycle) -> Outcome {
        let axis = self.st.axis();
        if self.moves_beside(AxisSet::of(axis), false) {
            return Err(Reported);
        }
        let end = made.leaves(self.st.position.at());
        self.core.send_cycle(made, &self.st.ctx);
        self.st.position.cycle_leaves(&end, AxisSet::of(axis));
        self.st.moved = true;
        match made {
            Cycle::Drilling(Drilling { method: Method::Tap(Tap { after: Spindle::Stop, .. }), .. }) => {
                self.st.spindle.stop();
            }
            Cycle::Drilling(Drilling { method: Method::Deep(hole), .. }) => self.leave_deep_hole(hole),
            _ => {}
        }
        Ok(())
    }

    /// Mills where the tool stands, or at the place that the cycle names.
    fn send_milled(&mut self, cycle: &DefinedCycle, made: &Cycle) -> Outcome {
        self.says_own_path(cycle);
        if !matches!(made, Cycle::ThreadMilling(_)) {
            self.warn_of_rounded_cutter(cycle);
        }
        let mut end = made.leaves(self.st.position.at());
        self.st.left_by = None;
        if ends_anywhere(made) {
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
        self.core.send_cycle(made, &self.st.ctx);
        self.st.polar.forget_last();
        self.st.position.cycle_leaves(&end, AxisSet::MAIN);
        self.st.moved = true;
        Ok(())
    }

    /// What a deep hole leaves of spindle and coolant.
    fn leave_deep_hole(&mut self, hole: &DeepHole) {
        match hole.entry {
            (speed, Some(turn)) => {
                self.st.spindle.set_speed(speed);
                self.st.spindle.start(turn);
            }
            (_, None) => {
                self.st.spindle.set_speed(hole.drilling.0);
                self.st.spindle.stop();
            }
        }
        if let Some(last) = hole.coolant[1].or(hole.coolant[0]) {
            self.st.coolant = last != Coolant::Off;
        }
    }

    /// The tool has the size that it has: a frame may shift, turn and mirror in the plane.
    pub(super) fn frame_keeps_the_cutter(&self, cycle: &DefinedCycle) -> Outcome {
        let (frame, plane) = (&self.st.ctx.frame, self.st.plane());
        if !frame.is_unscaled() {
            return self.refuse_cycle(cycle, codes::K9030::milling_under_scaling());
        }
        if !frame.keeps_axis_across(plane) {
            return self.refuse_cycle(cycle, codes::K9030::milling_with_mirrored_tool_axis());
        }
        Ok(())
    }

    /// The paths are those of a cutter with sharp corners.
    fn warn_of_rounded_cutter(&self, cycle: &DefinedCycle) {
        let Some(tool) = self.st.tool.active() else { return };
        let rounding = tool.corner_radius.unwrap_or(0.0) + tool.table_deltas[2] + tool.call_deltas[2];
        if rounding <= 0.0 {
            return;
        }
        let flat = 2.0 * (tool.effective_radius().unwrap_or(0.0) - rounding).max(0.0);
        self.core.report_once(
            codes::P8102::cycle_corner_radius_mm_of_cutter(&cycle.number, &shown(rounding), &shown(flat))
                .at(self.core.here.origin.loc)
                .also(cycle.loc, Label::CycleDefined),
        );
    }

    /// Once for each kind of cycle: which path is made.
    fn says_own_path(&self, cycle: &DefinedCycle) {
        let what = cycle.row().called();
        let found =
            codes::P8101::cycle_finished_shape_is_as_programmed(&cycle.number, &what).at(self.core.here.origin.loc);
        self.core.report_once(found.help("docs/cycles.md describes the path"));
    }

    /// Once for each kind of cycle: nobody says where the tool stands in the plane afterwards.
    fn says_open_end(&self, cycle: &DefinedCycle) {
        let found =
            codes::K8104::cycle_where_control_leaves_tool_in_working(&cycle.number).at(self.core.here.origin.loc);
        self.core.report_once(found);
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
        self.core.report(
            codes::P2001::block_needs_position(&axis.letter())
                .at(self.core.here.origin.loc)
                .also(cycle, Label::CycleDefined),
        );
    }

    /// Does the tool go no deeper?
    pub(super) fn rises(&self, end: &Pos) -> bool {
        let axis = self.st.axis();
        matches!((self.st.position.get(axis), end.get(axis)), (Some(from), Some(to)) if to >= from)
    }
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
