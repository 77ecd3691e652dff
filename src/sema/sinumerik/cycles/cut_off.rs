//! Cut-off: CYCLE92. Its path is in `lower::cycles::cut_off`.
//!
//! Source: M 6.5, C 5.11 (docs/sources.md).

use std::f64::consts::PI;

use crate::diag::{Answer, codes};
use crate::ir::cycle::cut_off::{CutEdge, CutOff, CutOffFault};
use crate::ir::cycle::recess::RecessTool;
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Family};
use crate::ir::function::{Spindle, Turn};
use crate::machine::Unit;
use crate::machine::options::cycles::CutOffReference;

use super::call::{Act, Acts, CycleCall, SpindleTold};
use super::names::{AMODE, DIAG1, DIAG2, DIAGM, FF1, FF2, RC, SDAC, SDIS, SPD, SS2, SV1, SV2, VARI};
use crate::sema::cycle::call::{Kind, Made};

impl CycleCall<'_> {
    /// CYCLE92
    pub(super) fn cut_off(&self) -> Made<Acts> {
        self.digits_of_are_known(VARI)?;
        let given = self.given;
        self.part_catcher()?;
        let point = self.turned_reference();
        if point.y <= 0.0 {
            return self.refuse_argument(SPD, codes::P2090::diameter_spd_is_not_above_0(&given.argument(SPD)));
        }
        let tool = self.groove_tool(Towards::MinusX)?;
        let reduced = self.given.length(DIAG1) / 2.0;
        let edge = match (self.given.length(RC), given.digit(AMODE, 4)) {
            (0.0, _) => CutEdge::Sharp,
            (size, 1) => CutEdge::Chamfer(size),
            (size, _) => CutEdge::Round(size),
        };
        let feed = self.mill_feed(FF1)?;
        let reduced_feed = if given.or_zero(FF2) == 0.0 { feed } else { self.mill_feed(FF2)? };
        let clearance = given.length(SDIS);
        let told = self.cut_off_speeds(reduced)?;
        let cut = CutOff {
            face: point.x + self.beside_reference(&tool),
            outer: point.y,
            reduced,
            end: self.given.length(DIAG2) / 2.0,
            edge,
            tool,
            clearance,
            feed,
            reduced_feed,
            speed: told.speed,
            turn: told.turn,
            reduced_speed: told.reduced.map(Spindle::Speed),
        };
        if let Err(fault) = cut.check() {
            return self.cut_off_fault(fault);
        }
        self.second_edge("cuts the edge with this edge of the tool");
        self.note(given.place, codes::P8101::cut_goes_in_front_of_edge_first(&given.called), Kind::Once);
        Ok(vec![Act::Cycle(Cycle::CutOff(cut)), Act::Spindle(told)])
    }

    /// The part catcher comes out at `_DIAGM`, by a program of the machine builder; at the end of the cut and beyond the
    /// value is a leftover of the editor.
    fn part_catcher(&self) -> Made {
        let given = self.given;
        let diameter = given.or_zero(DIAGM);
        if diameter == 0.0 || diameter <= given.or_zero(DIAG2) {
            return Ok(());
        }
        if !self.settings.cycles.ignores_gripper {
            return self.refuse_as_said(
                given.place_of(DIAGM),
                codes::S9015::at_diameter_diagm_cut_stops(&given.called, &diameter)
                    .answer(Answer::key("cycles", "parts_gripper").one_of(&["\"ignore\""])),
            );
        }
        let fault = codes::P8106::part_catcher_at_diameter_is_left_out(&given.called, &diameter);
        self.note(given.place_of(DIAGM), fault.help("see that nothing waits for the part"), Kind::Each);
        Ok(())
    }

    /// From Z0 to the face of the workpiece.
    fn beside_reference(&self, tool: &RecessTool) -> f64 {
        // The programmed corner, as far as it lies on the far side.
        let other = tool.width + tool.edge;
        match self.settings.cycles.cutoff_reference {
            Some(CutOffReference::Workpiece) => 0.0,
            Some(CutOffReference::Tip) => other,
            None => {
                if other > 0.0 {
                    let key = Answer::key("cycles", "cutoff_reference");
                    let fault = codes::S8224::cycle92_z0_is_taken_for_corner(&tool.width).answer(key);
                    self.note(self.given.place, fault, Kind::Once);
                }
                0.0
            }
        }
    }

    fn cut_off_speeds(&self, reduced: f64) -> Made<SpindleTold> {
        let given = self.given;
        let [speed, limit, slow] = [SV1, SV2, SS2].map(|key| given.or_zero(key));
        let turn = match given.or_zero(SDAC) {
            0.0 => None,
            3.0 => Some(Turn::Clockwise),
            4.0 => Some(Turn::CounterClockwise),
            _ => {
                return self.refuse_argument(SDAC, codes::P2090::sdac_is_no_sense_of_spindle(&given.argument(SDAC)));
            }
        };
        let turn = turn.filter(|turn| self.st.spindles.turn() != Some(*turn));
        if limit > 0.0 && speed == 0.0 {
            return self.refuse_argument(SV2, codes::P2090::greatest_speed_sv2_without_speed_sv1(&given.argument(SV2)));
        }
        if speed == 0.0 && slow == 0.0 && turn.is_none() && !self.st.spindles.is_cutting() {
            return Ok(SpindleTold::default());
        }
        self.master_is_main(given.place, "the speed of a cut-off")?;
        let highest =
            [Some(limit).filter(|n| *n > 0.0), self.st.spindles.limit()].into_iter().flatten().reduce(f64::min);
        let metres = if self.st.feed_unit() == 1.0 { speed } else { speed * Unit::FOOT };
        let told = match (speed > 0.0, limit > 0.0) {
            (true, true) => Some(Spindle::CuttingSpeed { speed: metres, limit: highest }),
            (true, false) => Some(Spindle::Speed(self.within_limit(speed))),
            (false, _) => None,
        };
        let cutting = match told {
            Some(Spindle::CuttingSpeed { speed, .. }) => Some(speed),
            Some(_) => None,
            None => self.st.spindles.speed().filter(|_| self.st.spindles.is_cutting()),
        };
        let reduced = match (slow > 0.0, cutting) {
            (true, _) => Some(self.within_limit(slow)),
            (false, None) => None,
            (false, Some(metres)) => Some(self.speed_at(reduced, metres, highest)?),
        };
        Ok(SpindleTold { speed: told, turn, reduced })
    }

    /// G26 and LIMS bound every speed.
    fn within_limit(&self, speed: f64) -> f64 {
        self.st.spindles.limit().map_or(speed, |limit| limit.min(speed))
    }

    /// Turns of a cutting speed at a radius.
    fn speed_at(&self, radius: f64, metres: f64, highest: Option<f64>) -> Made<f64> {
        let given = self.given;
        let free = (radius > 1e-3).then(|| libm::round(1000.0 * metres / (2.0 * PI * radius)));
        match [free, highest].into_iter().flatten().reduce(f64::min) {
            Some(turns) => Ok(turns),
            None => self.refuse(codes::P2090::reduced_speed_ss2_is_missing(&given.argument(SS2))),
        }
    }

    fn cut_off_fault<T>(&self, fault: CutOffFault) -> Made<T> {
        let at = match fault {
            CutOffFault::EdgeSize => (RC, 61603, "give a smaller radius or chamfer, or a smaller `_DIAG1`"),
            CutOffFault::Order => {
                (DIAG1, 61019, "`_SPD` is the largest diameter, `_DIAG2` the smallest, `_DIAG1` between")
            }
            CutOffFault::Clearance => (SDIS, 61019, "give a safety distance above 0"),
            CutOffFault::Feed => (FF1, 61003, "give a feed above 0"),
            CutOffFault::Point | CutOffFault::Width | CutOffFault::Nose | CutOffFault::Edge => {
                (SPD, 61019, "check the arguments of the cycle and the tool data")
            }
        };
        self.unsound(at, &fault)
    }
}
