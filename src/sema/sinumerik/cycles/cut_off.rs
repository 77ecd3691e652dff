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
use crate::machine::options::cycles::CutOffReference;

use super::super::Outcome;
use super::super::g_groups::{GCode, Group};
use super::arguments::{AMODE, DIAG1, DIAG2, DIAGM, FF1, FF2, Key, RC, SDAC, SDIS, SPD, SS2, SV1, SV2, VARI};
use super::call::CycleCall;

/// Metres in a foot: cutting speeds of inch programs.
const FOOT: f64 = 0.3048;

/// What the call tells the spindle.
#[derive(Default)]
struct Told {
    speed: Option<Spindle>,
    turn: Option<Turn>,
    /// The fixed turns from the diameter of the reduced feed on.
    reduced: Option<f64>,
}

impl CycleCall<'_, '_> {
    /// CYCLE92
    pub(super) fn cut_off(&mut self) -> Outcome {
        self.groove_conditions()?;
        self.digits_of_are_known(VARI)?;
        let args = self.args;
        self.part_catcher()?;
        let point = self.turned_reference()?;
        if point.y <= 0.0 {
            return self.refuse_cycle(args.span_of(SPD), codes::P2090::diameter_spd_is_not_above_0(&args.place(SPD)));
        }
        let tool = self.groove_tool(Towards::MinusX)?;
        self.turning_position(args.span)?;
        let reduced = self.needed_length(DIAG1, "the diameter of the reduced feed")? / 2.0;
        let edge = match (self.length_of(args, RC).unwrap_or(0.0), args.digit(AMODE, 4)) {
            (0.0, _) => CutEdge::Sharp,
            (size, 1) => CutEdge::Chamfer(size),
            (size, _) => CutEdge::Round(size),
        };
        let feed = self.mill_feed(FF1)?;
        let reduced_feed = if args.or_zero(FF2) == 0.0 { feed } else { self.mill_feed(FF2)? };
        let clearance = self.above_zero(SDIS)?;
        let told = self.cut_off_speeds(reduced)?;
        let cut = CutOff {
            face: point.x + self.beside_reference(&tool),
            outer: point.y,
            reduced,
            end: self.needed_length(DIAG2, "the final diameter")? / 2.0,
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
        self.say_once(args.span, codes::P8101::cut_goes_in_front_of_edge_first(&args.name()));
        self.send_cycle(Cycle::CutOff(cut));
        self.spindle_was_told(&told);
        Ok(())
    }

    /// The part catcher comes out at `_DIAGM`, by a program of the machine builder; at the end of the cut and beyond the
    /// value is a leftover of the editor.
    fn part_catcher(&self) -> Outcome {
        let args = self.args;
        let diameter = args.or_zero(DIAGM);
        if diameter == 0.0 || diameter <= args.or_zero(DIAG2) {
            return Ok(());
        }
        if !self.job.settings.cycles.ignores_gripper {
            return self.refuse(
                args.span_of(DIAGM),
                codes::S9015::at_diameter_diagm_cut_stops(&args.name(), &diameter)
                    .answer(Answer::key("cycles", "parts_gripper").one_of(&["\"ignore\""])),
            );
        }
        let found = codes::P8106::part_catcher_at_diameter_is_left_out(&args.name(), &diameter)
            .at(self.loc(args.span_of(DIAGM)));
        self.report(found.help("see that nothing waits for the part"));
        Ok(())
    }

    /// From Z0 to the face of the workpiece.
    fn beside_reference(&self, tool: &RecessTool) -> f64 {
        // The programmed corner, as far as it lies on the far side.
        let other = tool.width + tool.edge;
        match self.job.settings.cycles.cutoff_reference {
            Some(CutOffReference::Workpiece) => 0.0,
            Some(CutOffReference::Tip) => other,
            None => {
                if other > 0.0 && self.job.diags.first_time(codes::S8224, tool.width.to_bits()) {
                    let found = codes::S8224::cycle92_z0_is_taken_for_corner(&tool.width).at(self.loc(self.args.span));
                    self.report(
                        found.help(
                            Answer::key("cycles", "cutoff_reference")
                                .help("set `[cycles] cutoff_reference` to \"workpiece\" or \"tip\""),
                        ),
                    );
                }
                0.0
            }
        }
    }

    fn cut_off_speeds(&mut self, reduced: f64) -> Outcome<Told> {
        let args = self.args;
        let [speed, limit, slow] = [SV1, SV2, SS2].map(|key| args.or_zero(key));
        let turn = match args.or_zero(SDAC) {
            0.0 => None,
            3.0 => Some(Turn::Clockwise),
            4.0 => Some(Turn::CounterClockwise),
            _ => {
                return self
                    .refuse_cycle(args.span_of(SDAC), codes::P2090::sdac_is_no_sense_of_spindle(&args.place(SDAC)));
            }
        };
        let turn = turn.filter(|turn| self.st.spindles.turn() != Some(*turn));
        if limit > 0.0 && speed == 0.0 {
            return self
                .refuse_cycle(args.span_of(SV2), codes::P2090::greatest_speed_sv2_without_speed_sv1(&args.place(SV2)));
        }
        if speed == 0.0 && slow == 0.0 && turn.is_none() && !self.st.spindles.is_cutting() {
            return Ok(Told::default());
        }
        self.master_is_main(args.span, "the speed of a cut-off")?;
        let highest =
            [Some(limit).filter(|n| *n > 0.0), self.st.spindles.limit()].into_iter().flatten().reduce(f64::min);
        let metres = if self.st.feed_unit() == 1.0 { speed } else { speed * FOOT };
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
        Ok(Told { speed: told, turn, reduced })
    }

    /// G26 and LIMS bound every speed.
    fn within_limit(&self, speed: f64) -> f64 {
        self.st.spindles.limit().map_or(speed, |limit| limit.min(speed))
    }

    /// Turns of a cutting speed at a radius.
    fn speed_at(&self, radius: f64, metres: f64, highest: Option<f64>) -> Outcome<f64> {
        let args = self.args;
        let free = (radius > 1e-3).then(|| libm::round(1000.0 * metres / (2.0 * PI * radius)));
        match [free, highest].into_iter().flatten().reduce(f64::min) {
            Some(turns) => Ok(turns),
            None => self.refuse_cycle(args.span, codes::P2090::reduced_speed_ss2_is_missing(&args.place(SS2))),
        }
    }

    fn spindle_was_told(&mut self, told: &Told) {
        let printed = told.reduced.or(match told.speed {
            Some(Spindle::Speed(turns)) => Some(turns),
            _ => None,
        });
        if let Some(turns) = printed {
            self.st.spindles.set_turns(turns, turns);
            // The feed keeps its kind.
            match self.st.codes.of(Group::FeedType) {
                GCode::G96 => self.st.codes.activate(GCode::G97),
                GCode::G961 => self.st.codes.activate(GCode::G971),
                _ => {}
            }
        }
        if told.turn.is_some() {
            self.st.spindles.set_turn(told.turn);
        }
    }

    fn cut_off_fault(&self, fault: CutOffFault) -> Outcome {
        let args = self.args;
        let (key, alarm, help): (Key, _, _) = match fault {
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
        self.refuse_cycle(
            args.span_of(key),
            codes::P2090::family_refuses(&fault, &args.written(key), &args.place(key)).help(help).alarm(alarm),
        )
    }
}
