//! M functions, spindle, tool, dwell.
//!
//! Source: M 5.4, 7, 8 (docs/sources.md). When an M function acts is not documented: what starts something acts
//! before the move of its block, what ends something behind it.

use crate::diag::{Answer, codes};
use crate::geo::{Plane, Vec2};
use crate::ir::function::{Coolant, CutterData, Spindle, Turn};
use crate::ir::{self, Function, Side};
use crate::machine::options::mtc200::{InchSpeed, Reading};
use crate::machine::tools::ToolKey;
use crate::machine::{Compensation, MachineKind, Unit};
use crate::sema::common::compensation::edge_direction;
use crate::text::Span;

use super::g_functions::{G, Group};
use super::words::{At, Words};
use super::{Outcome, Run};

/// Longest time of G04, as written.
const MOST_DWELL: f64 = 1e6;

/// Blocks of a compensated contour that need not move in the plane.
const MOST_WITHOUT_MOVE: u32 = 2;

/// Metres in a foot.
const FOOT: f64 = 0.3048;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum When {
    Start,
    End,
}

fn when(number: u32) -> Option<When> {
    Some(match number {
        3 | 4 | 6 | 7 | 8 | 13 | 14 | 19 => When::Start,
        0 | 1 | 2 | 5 | 9 | 30 => When::End,
        _ => return None,
    })
}

/// Functions of one group contradict each other.
fn groups(number: u32) -> [u8; 2] {
    match number {
        3 | 4 | 5 | 19 => [1, 0],
        7..=9 => [0, 2],
        13 | 14 => [1, 2],
        2 | 30 => [3, 0],
        _ => [0, 0],
    }
}

pub(super) fn conflict(a: u32, b: u32) -> bool {
    groups(a).iter().any(|group| *group != 0 && groups(b).contains(group))
}

/// What the program told the spindle.
#[derive(Debug, Clone, Copy)]
pub(super) struct SpindleState {
    /// It does not turn, as far as the program says.
    stands: bool,
    /// G96: S counts as cutting speed.
    cutting: bool,
    /// Cutting speed in m/min.
    cutting_speed: Option<f64>,
    /// G92: highest speed under G96, rev/min.
    limit: Option<f64>,
}

impl Default for SpindleState {
    fn default() -> SpindleState {
        SpindleState { stands: true, cutting: false, cutting_speed: None, limit: None }
    }
}

impl SpindleState {
    pub fn stands(&self) -> bool {
        self.stands
    }
}

/// The tool that is chosen, and the one in use.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ToolInUse {
    /// Tool of the last T word.
    selected: Option<u32>,
    /// Tool of the last change.
    active: Option<u32>,
    /// A correction D other than 0 was chosen.
    corrected: bool,
    /// An edge E other than the first was chosen.
    other_edge: bool,
}

impl ToolInUse {
    /// Tool of the last change.
    pub fn active(&self) -> Option<u32> {
        self.active
    }

    /// Letters of what was chosen beside the first edge and no correction.
    pub fn chosen(&self) -> [(char, bool); 2] {
        [('D', self.corrected), ('E', self.other_edge)]
    }

    /// D
    fn correct(&mut self, number: u32) {
        self.corrected = number != 0;
    }

    /// E
    fn take_edge(&mut self, number: u32) {
        self.other_edge = number > 1;
    }
}

impl Run<'_> {
    /// M functions that are not known are refused before anything of the block acts.
    #[inline]
    pub(super) fn check_m(&mut self, w: &Words) -> Outcome {
        for (i, &(number, span)) in w.m().iter().enumerate() {
            if when(number).is_none() && !self.core.job.settings.output.pass_m.contains(&number) {
                self.core.report(
                    codes::P2007::m_is_function_of_machine_so_if_target(&number)
                        .answer(Answer::pass_m(number))
                        .at(self.core.loc(span)),
                );
            }
            if let Some((first, _)) = w.m()[..i].iter().find(|(first, _)| conflict(*first, number)) {
                return self.core.refuse(span, codes::P1005::m_contradicts_m_of_same_block(&number, &first));
            }
        }
        Ok(())
    }

    #[inline]
    pub(super) fn m_at_start(&mut self, w: &Words, moves: bool) -> Outcome {
        for &(number, span) in w.m() {
            match when(number) {
                Some(When::Start) => self.act(number, span)?,
                Some(When::End) => {}
                None if self.core.job.settings.output.pass_m.contains(&number) => self.aux(number, span, moves),
                None => {}
            }
        }
        for &(number, span) in w.aux() {
            self.aux(number, span, moves);
        }
        Ok(())
    }

    /// An M function whose moment is not known.
    fn aux(&mut self, number: u32, span: Span, moves: bool) {
        if moves {
            self.core.report(codes::P2008::m_is_printed_before_move_of_its_block(&number).at(self.core.loc(span)));
        }
        self.function(Function::Aux(number));
        // It may be the one that starts a spindle of this machine.
        self.st.spindle.stands = false;
    }

    #[inline]
    pub(super) fn m_at_end(&mut self, w: &Words) -> Outcome {
        // Behind the end of the program nothing is done any more, wherever its word stands in the block.
        for last in [false, true] {
            for &(number, span) in w.m() {
                if when(number) == Some(When::End) && matches!(number, 2 | 30) == last {
                    self.act(number, span)?;
                }
            }
        }
        Ok(())
    }

    fn act(&mut self, number: u32, span: Span) -> Outcome {
        let function = match number {
            0 => Function::Stop,
            1 => Function::OptionalStop,
            3 | 13 => Function::Spindle(Spindle::Start(Turn::Clockwise)),
            4 | 14 => Function::Spindle(Spindle::Start(Turn::CounterClockwise)),
            5 => Function::Spindle(Spindle::Stop),
            7 => Function::Coolant(Coolant::Mist),
            8 => Function::Coolant(Coolant::Flood),
            9 => Function::Coolant(Coolant::Off),
            19 => Function::Spindle(Spindle::Orient(0.0)),
            6 => return self.m6(span),
            // The end waits for the flow words of the block.
            _ => return self.end_of_program(number == 30, span),
        };
        match number {
            3 | 4 | 13 | 14 => self.st.spindle.stands = false,
            5 | 19 => self.st.spindle.stands = true,
            _ => {}
        }
        self.function(function);
        if matches!(number, 13 | 14) {
            self.function(Function::Coolant(Coolant::Flood));
        }
        Ok(())
    }

    // Tool.

    /// T, and the change where M6 stands in the same block or T alone changes.
    pub(super) fn tool_word(&mut self, at: At, changes: bool) -> Outcome {
        let number = self.whole(at, "T")?;
        self.st.tool.selected = Some(number);
        if self.core.job.settings.control.mtc200.t_changes {
            return self.change(at.span);
        }
        if !changes {
            self.function(Function::ToolPrepare { number: self.core.job.settings.tools.printed_number(number) });
        }
        Ok(())
    }

    fn m6(&mut self, span: Span) -> Outcome {
        if self.core.job.settings.control.mtc200.t_changes {
            self.without_geometry("M6", span);
            return Ok(());
        }
        self.change(span)
    }

    fn change(&mut self, span: Span) -> Outcome {
        let Some(number) = self.st.tool.selected else {
            return self.core.refuse(span, codes::M2012::m6_without_selected_tool());
        };
        if self.st.compensation.is_on() {
            return self.core.refuse(span, codes::P1003::tool_changes_under_path_compensation());
        }
        self.st.tool.active = Some(number);
        self.length_acts_along_z(self.st.plane, span)?;
        let own = number;
        let number = self.core.job.settings.tools.printed_number(own);
        self.core.prints_tool(&ToolKey::Number(own, 0), number, span)?;
        self.function(Function::ToolChange { number });
        self.function(Function::Cutter(CutterData { number, ..CutterData::default() }));
        self.forget_tip();
        self.stand_after_change();
        Ok(())
    }

    /// G40, G41, G42.
    pub(super) fn set_side(&mut self, side: Side, span: Span, w: &Words) -> Outcome {
        if side != Side::None {
            let Some(tool) = self.st.tool.active else {
                return self.core.refuse(span, codes::M2012::path_compensation_without_tool());
            };
            if self.st.compensation.sent() != Side::None && self.st.compensation.sent() != side {
                return self.core.refuse(span, codes::P1003::g41_g42_follow_each_other_without_g40());
            }
            if self.core.job.settings.output.compensation == Compensation::Resolve {
                self.compute_compensation(tool, span)?;
                let says = w.g.iter().flatten().any(|(g, _)| matches!(g, G::Chamfers(_)));
                if !(says || self.st.transition.said) {
                    let what = codes::P8106::g43_is_in_force_at_start;
                    self.reading(Reading::Transition, span, what);
                }
            }
        }
        self.st.compensation.select(side);
        Ok(())
    }

    /// D or E: both choose a radius that only the machine knows, which counts under G41 and G42.
    pub(super) fn tool_data_word(&mut self, letter: u8, number: u32, span: Span) -> Outcome {
        if letter == b'D' {
            self.st.tool.correct(number);
        } else {
            self.st.tool.take_edge(number);
        }
        let computed = self.core.job.settings.output.compensation == Compensation::Resolve;
        if computed && self.st.compensation.is_on() { self.radius_is_that_of_the_table(span) } else { Ok(()) }
    }

    fn radius_is_that_of_the_table(&mut self, span: Span) -> Outcome {
        let printed = || Answer::key("output", "compensation").one_of(&["\"control\""]);
        if self.st.tool.corrected {
            return self.core.refuse(span, codes::P9013::what_correction_d_in_force_adds().answer(printed()));
        }
        if self.st.tool.other_edge {
            return self.core.refuse(span, codes::P9013::radius_of_edge_e_in_force().answer(printed()));
        }
        Ok(())
    }

    /// The compiler itself computes the path of the tool centre, or of the nose centre of a turning tool.
    fn compute_compensation(&mut self, tool: u32, span: Span) -> Outcome {
        self.core.job.calls_tool_in(if self.st.inch { Unit::Inch } else { Unit::Mm }, self.core.loc(span));
        let known = self.core.job.settings.tools.by_number(tool, 0);
        let answers =
            |field| [Answer::tool(tool, field), Answer::key("output", "compensation").one_of(&["\"control\""])];
        let radius = known.and_then(|tool| tool.radius.map(|radius| radius + tool.deltas[1]));
        let Some(radius) = radius.filter(|radius| *radius >= 0.0) else {
            let asking = match radius {
                Some(_) => codes::P9013::radius_of_tool_is_below_zero_for_path(&tool),
                None => codes::P9013::radius_of_tool_is_not_known_for_path(&tool),
            };
            return self.core.refuse(span, asking.answers(answers("radius")));
        };
        let turns = self.core.job.settings.machine.kind == MachineKind::Lathe && self.st.plane == Plane::Zx;
        let edge = match known.and_then(|tool| tool.orientation).and_then(edge_direction) {
            Some(edge) if turns => edge,
            None if turns && radius > 0.0 => {
                return self.core.refuse(
                    span,
                    codes::P9013::cutting_edge_position_of_tool_is_not(&tool).answers(answers("orientation")),
                );
            }
            _ => Vec2::zeros(),
        };
        self.radius_is_that_of_the_table(span)?;
        self.st.transition.between = 0;
        self.st.compensate(ir::Compensation { radius, nose: -edge * radius, ..Default::default() });
        Ok(())
    }

    /// A block without a move in the plane; after too many of them the control takes the contour as finished.
    #[inline]
    pub(super) fn waits_in_contour(&mut self, moves_in_plane: bool, span: Span) -> Outcome {
        if !self.st.compensation.is_on() {
            return Ok(());
        }
        let before = self.st.transition.between;
        self.st.transition.between = if moves_in_plane { 0 } else { before + 1 };
        if !moves_in_plane
            || before <= MOST_WITHOUT_MOVE
            || self.core.job.settings.output.compensation == Compensation::Control
        {
            return Ok(());
        }
        self.core.refuse(span, codes::P9013::blocks_in_front_of_this_one(&before, &MOST_WITHOUT_MOVE))
    }

    // Spindle.

    /// G96 and G97.
    pub(super) fn spindle_mode(&mut self, on: bool, span: Span, w: &Words) -> Outcome {
        let changes = self.st.spindle.cutting != on;
        self.st.spindle.cutting = on;
        let limit_only = w.g[Group::Once as usize].is_some_and(|(g, _)| g == G::SpeedLimit);
        if changes && (w.speed.is_none() || limit_only) {
            let (name, form) = if on { ("G96", "G96 S180") } else { ("G97", "G97 S1200") };
            return self.core.refuse(span, codes::P1004::needs_its_s_in_same_block(&name, &form));
        }
        Ok(())
    }

    pub(super) fn speed_word(&mut self, at: At, limit: bool) -> Outcome {
        if at.value < 0.0 || (limit && at.value == 0.0) {
            return self.core.refuse(at.span, codes::M2705::spindle_speed(&at.value));
        }
        if limit {
            self.st.spindle.limit = Some(at.value);
            if self.st.spindle.cutting {
                self.send_cutting_speed();
            }
            return Ok(());
        }
        if !self.st.spindle.cutting {
            self.function(Function::Spindle(Spindle::Speed(at.value)));
            return Ok(());
        }
        let metres = match (self.st.inch, self.core.job.settings.control.mtc200.inch_speed) {
            (false, _) | (true, InchSpeed::Metres) => at.value,
            (true, InchSpeed::Feet) => at.value * FOOT,
            (true, InchSpeed::Refuse) => {
                return self.core.refuse(
                    at.span,
                    codes::M9007::unit_of_cutting_speed_under_g70().answer(Answer::key("control", "inch_speed")),
                );
            }
        };
        self.st.spindle.cutting_speed = Some(metres);
        self.send_cutting_speed();
        Ok(())
    }

    fn send_cutting_speed(&mut self) {
        if let Some(speed) = self.st.spindle.cutting_speed {
            let limit = self.st.spindle.limit;
            self.function(Function::Spindle(Spindle::CuttingSpeed { speed, limit }));
        }
    }

    /// G04.
    pub(super) fn dwell(&mut self, w: &Words, span: Span) -> Outcome {
        let Some(at) = w.feed else { return self.core.refuse(span, codes::P1004::g04_needs_its_time()) };
        if !(0.0..=MOST_DWELL).contains(&at.value) {
            return self.core.refuse(at.span, codes::M2705::dwell_time(&at.value));
        }
        self.reading(Reading::Dwell, at.span, codes::P8106::f_of_g04_counts_in_seconds);
        let unit = if self.core.job.settings.control.mtc200.dwell_ms { 1e-3 } else { 1.0 };
        self.function(Function::Dwell(at.value * unit));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contradictions() {
        assert!(conflict(3, 4) && conflict(8, 9) && conflict(13, 9) && conflict(3, 5) && conflict(13, 3));
        assert!(!conflict(3, 8) && !conflict(5, 9) && !conflict(1, 30) && conflict(2, 30));
    }
}
