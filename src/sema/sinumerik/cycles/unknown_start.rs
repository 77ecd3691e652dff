//! Turning cycles behind a change of tool: where the tool stands is not known, and the cycle itself says where it begins.

use crate::diag::codes;
use crate::geo::{Plane, Point2};
use crate::ir::contour::Path;
use crate::ir::cycle::{Cycle, UndercutCycle};
use crate::machine::Axis;

use super::super::{Outcome, Reported};
use super::call::CycleCall;

impl CycleCall<'_, '_> {
    /// Sends a cycle that begins where the tool stands, made for that place. Where it is not known the tool goes to `front`
    /// first, in one rapid move of both axes as to the start of CYCLE951, and comes back there.
    pub(super) fn send_from(&mut self, front: Point2, made: impl FnOnce(Point2) -> Cycle) -> Outcome {
        if let Some(at) = self.st.position.in_plane(Plane::Zx) {
            self.send_cycle(made(at));
            return Ok(());
        }
        // What was refused in front of the cycle is not worth a second error.
        if [Axis::X, Axis::Z].into_iter().any(|axis| self.st.position.is_lost(axis)) {
            return Err(Reported);
        }
        let end = self.moved_in_plane(front);
        self.send(&end, Path::Rapid);
        self.send_cycle(made(front));
        // The control may end where it came from.
        self.st.position.forget(end.known());
        let found = codes::S8164::where_tool_stands_is_not_known(&self.args.name()).at(self.loc(self.args.span));
        self.report(found.help("position the tool in X and Z in front of the cycle"));
        Ok(())
    }

    /// In front of the face and out of the cylinder by the distance of the cycle, whatever the nose of the tool.
    pub(super) fn in_front_of(&self, cycle: &UndercutCycle) -> Point2 {
        let nose = self.known_radius().unwrap_or(0.0).max(0.0);
        let face = cycle.face_end.map_or(0.0, |end| (end - cycle.corner.y).abs());
        let (along, away) = (cycle.clearance + 2.0 * nose, face + cycle.clearance);
        let (first, second) = (cycle.orientation.first, cycle.orientation.second);
        // Inside, not beyond the turning centre.
        let height = (cycle.corner.y + second * away).max(0.0);
        Point2::new(cycle.corner.x + first * along, height)
    }
}
