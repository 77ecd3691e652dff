//! What a planned cycle does: it is sent, and leaves the tool, the spindle and what the program may do next.
//!
//! Source: K 6.0, 6.5; F B4 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Label, codes};
use crate::ir::Pos;
use crate::ir::cycle::drilling::{Method, Tap};
use crate::ir::cycle::{Cycle, Drilling};
use crate::ir::function::Spindle;
use crate::machine::{Axis, AxisSet};
use crate::sema::run::Where;

use super::active_tool::ActiveTool;
use super::cycles::machining::shown;
use super::cycles::{DefinedCycle, Planned};
use super::known::Known;
use super::state::State;
use super::{Core, Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn send_planned(&mut self, cycle: &DefinedCycle, planned: Planned) -> Outcome {
        self.core.budget.take(planned.steps);
        if self.st.tilt.bars() {
            self.bar();
            return Err(Reported);
        }
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
        if self.st.moves_beside(&mut self.core, AxisSet::of(axis), false) {
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
            Cycle::Drilling(Drilling { method: Method::Deep(hole), .. }) => self.st.spindle.leave_deep_hole(hole),
            _ => {}
        }
        Ok(())
    }

    /// Mills where the tool stands, or at the place that the cycle names.
    fn send_milled(&mut self, cycle: &DefinedCycle, made: &Cycle) -> Outcome {
        let path = codes::P8101::cycle_finished_shape_is_as_programmed(&cycle.number, &cycle.row().called());
        self.core.say_once(Where::Block, path.help("docs/cycles.md describes the path"));
        if !matches!(made, Cycle::ThreadMilling(_)) {
            cycle.warn_of_rounded_cutter(&self.core, self.st.tool.active());
        }
        let mut end = made.leaves(self.st.position.at());
        self.st.left_by = None;
        if ends_anywhere(made) {
            self.core.say_once(Where::Block, codes::K8104::cycle_where_control_leaves_tool_in_working(&cycle.number));
            self.st.left_by = Some(cycle.loc);
            let (first, second, _) = self.st.plane().axes();
            for axis in [first, second] {
                end.forget(Axis::ALL[axis]);
            }
        }
        if self.st.moves_beside(&mut self.core, AxisSet::of(self.st.axis()), false) {
            return Err(Reported);
        }
        self.core.send_cycle(made, &self.st.ctx);
        self.st.polar.forget_last();
        self.st.position.cycle_leaves(&end, AxisSet::MAIN);
        self.st.moved = true;
        Ok(())
    }
}

impl State {
    /// A block leaves the open place where a cycle ended: only a retract may, and one that names both axes.
    #[cold]
    pub fn leave_open_end(&mut self, core: &Core<'_>, named: AxisSet, harmless: bool) {
        let Some(cycle) = self.left_by else { return };
        let (first, second, _) = self.plane().axes();
        let plane = [Axis::ALL[first], Axis::ALL[second]];
        let missing = |axis: &Axis| !named.contains(*axis) && self.position.get(*axis).is_none();
        let Some(axis) = plane.iter().copied().find(missing) else {
            self.left_by = None;
            return;
        };
        if harmless && plane.iter().all(|axis| !named.contains(*axis)) {
            return;
        }
        self.left_by = None;
        if self.position.is_lost(axis) {
            return;
        }
        core.report(
            codes::P2001::block_needs_position(&axis.letter())
                .at(core.here.origin.loc)
                .also(cycle, Label::CycleDefined),
        );
    }

    /// Does the tool go no deeper?
    pub fn rises(&self, end: &Pos) -> bool {
        let axis = self.axis();
        matches!((self.position.get(axis), end.get(axis)), (Some(from), Some(to)) if to >= from)
    }
}

impl DefinedCycle {
    /// The paths are those of a cutter with sharp corners.
    fn warn_of_rounded_cutter(&self, core: &Core<'_>, tool: Option<&ActiveTool>) {
        let Some(tool) = tool else { return };
        let rounding = tool.corner_radius.unwrap_or(0.0) + tool.table_deltas[2] + tool.call_deltas[2];
        if rounding <= 0.0 {
            return;
        }
        let flat = 2.0 * (tool.effective_radius().unwrap_or(0.0) - rounding).max(0.0);
        let fault = codes::P8102::cycle_corner_radius_mm_of_cutter(&self.number, &shown(rounding), &shown(flat));
        core.report_once(fault.at(core.here.origin.loc).also(self.loc, Label::CycleDefined));
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
