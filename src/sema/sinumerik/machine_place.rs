//! Machine coordinates and the length of the tool: G53, G153, SUPA and SUPD.
//!
//! With MD 10760 = 0 the control places the tip of the tool, the target the nose of the spindle: what is printed is a
//! tool length off unless it is added. Source: S 4.8 (docs/sources.md).

use crate::diag::{Answer, Help, codes};
use crate::machine::{Axis, AxisSet, Settings};
use crate::sema::run::Where;
use crate::text::Span;

use super::words::Words;
use super::{Core, Outcome, State};

/// Length of the tool in the axis along which it counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum ToolLength {
    /// No tool, or D0.
    Off,
    Known(f64),
    Unknown,
}

impl State {
    /// Axes in which the length of a tool counts.
    pub(super) fn tool_axes(&self) -> AxisSet {
        let [_, _, third] = self.roles();
        // Where the tool stands along none of them, its length counts in all.
        let mut axes = if self.orientation.is_upright() { AxisSet::of(third) } else { AxisSet::MAIN };
        if self.machine.lathe {
            axes.insert(Axis::X);
            axes.insert(Axis::Z);
        }
        axes
    }

    /// The tool in use as the control counts it: length, wear and base length of the edge.
    pub(super) fn active_length(&self, settings: &Settings) -> ToolLength {
        let tool = &self.tool;
        if tool.edge() == Some(0) || tool.active() == Some(0) {
            return ToolLength::Off;
        }
        let Some(number) = tool.active() else {
            return if tool.edge().is_some() { ToolLength::Unknown } else { ToolLength::Off };
        };
        if tool.edge_in_doubt() || self.machine.lathe {
            return ToolLength::Unknown;
        }
        let edge = tool.edge_or_first();
        let written = |parameter: u8| self.system.number(&format!("$TC_DP{parameter}[{number},{edge}]"));
        let listed = || {
            let tool = settings.tools.called(number).filter(|_| edge == 1)?;
            tool.length.map(|length| length + tool.deltas[0])
        };
        match written(3).or_else(listed) {
            Some(length) => ToolLength::Known(length + written(12).unwrap_or(0.0) + written(21).unwrap_or(0.0)),
            None => ToolLength::Unknown,
        }
    }

    /// Where the spindle stands when the control has an axis at the machine coordinate `value`.
    pub(super) fn machine_place(
        &self,
        core: &Core<'_>,
        axis: Axis,
        value: f64,
        place: impl Into<Where>,
    ) -> Outcome<f64> {
        let place = place.into();
        if !self.tool_axes().contains(axis) {
            return Ok(value);
        }
        let length = self.active_length(core.job.settings);
        if length == ToolLength::Off {
            return Ok(value);
        }
        if !core.job.settings.output.prints_tool_length() {
            core.says_tip_in_machine_coordinates(place);
            return Ok(value);
        }
        if !self.orientation.is_upright() {
            let asking = codes::P2005::tool_does_not_stand_along_axis(&axis.letter());
            return core.refuse(place, asking.answer(Answer::key("control", "md10760").one_of(&["true"])));
        }
        match length {
            ToolLength::Known(length) => {
                core.say_once(
                    place,
                    codes::S8105::tool_length_is_added_to_machine_coordinates(&length, &axis.letter()),
                );
                Ok(value + length)
            }
            _ => self.length_is_needed(core, axis, place),
        }
    }

    fn length_is_needed<T>(&self, core: &Core<'_>, axis: Axis, place: impl Into<Where>) -> Outcome<T> {
        let ways = "write D0 in the block, or set `[control] md10760 = true`";
        let help = match self.tool.active() {
            Some(number) if !self.machine.lathe => {
                Answer::tool(number, "length").help(format!("give it: `[tools.{number}] length = 120.0`; or {ways}"))
            }
            _ => Help::from(ways),
        };
        let help = help.and(Answer::key("control", "md10760").one_of(&["true"]));
        core.refuse(place, codes::P2005::control_goes_to_this_machine_coordinate(&axis.letter()).help(&help))
    }

    /// SUPD: the tool offsets do not count in this block.
    pub(super) fn suppressed_tool(&self, core: &Core<'_>, w: &Words, span: Span) -> Outcome {
        // On a lathe each end point, also a polar one, lies in the axes of the lengths.
        let moves = self.machine.lathe || w.axes.iter().any(|axis| self.tool_axes().contains(axis));
        let radius = self.side() != crate::ir::Side::None;
        if radius || moves && self.active_length(core.job.settings) != ToolLength::Off {
            return core.refuse(span, codes::P2005::supd_moves_spindle());
        }
        core.say_once(span, codes::S8103::supd_is_left_out());
        Ok(())
    }

    /// G43 of the target adds the length of the tool to Z; on the control it acts along the third axis of the plane.
    pub(super) fn length_acts_along_z(&self, core: &Core<'_>) {
        let [_, _, third] = self.roles();
        let output = &core.job.settings.output;
        if third == Axis::Z || !output.prints_tool_length() || self.machine.lathe || self.describes {
            return;
        }
        let tool = &self.tool;
        if tool.edge() == Some(0)
            || tool.active().is_none_or(|number| number == 0)
            || !core.job.diags.first_time(codes::O9190, third)
        {
            return;
        }
        let plane = if third == Axis::Y { "G18" } else { "G19" };
        let [who, help] = output.length_along_z();
        let help = format!("{help}, or program the block under G17");
        let help = Answer::key("output", "tool_length").one_of(&["\"off\""]).help(help);
        core.report(
            codes::O9190::under_length_of_tool_acts_along(&plane, &third.letter(), &who)
                .at(core.loc(Where::Block))
                .help(help),
        );
    }
}

impl Core<'_> {
    fn says_tip_in_machine_coordinates(&self, place: impl Into<Where>) {
        if self.job.diags.first_time(codes::S8106, ()) {
            let help = "write D0 in the block; or set `[output] tool_length = \"G43\"` with the lengths of the tools, or \
                        `[control] md10760 = true`";
            let help = Answer::key("output", "tool_length").one_of(&["\"G43\""]).help(help);
            let help = help.and(Answer::key("control", "md10760").one_of(&["true"]));
            self.report(codes::S8106::control_goes_to_this_machine_coordinate().at(self.loc(place)).help(help));
        }
    }
}
