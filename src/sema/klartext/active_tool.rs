//! The tool in the spindle, and how far its change got.

use crate::diag::{Answer, Label, codes};
use crate::ir::function::CutterData;
use crate::ir::{Feed, Function};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::position::Position;
use crate::text::{Loc, Span};

use super::{Core, Outcome, Reported};

/// The tool in the spindle; lengths in mm, `None` for unknown.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ActiveTool {
    /// Number to print.
    pub number: u32,
    /// Number in the control's own table, where it is known.
    pub own: Option<u32>,
    /// As called: the number without the index, or the name.
    pub called: String,
    pub radius: Option<f64>,
    /// What the tool table says where TOOL DEF gave another radius.
    pub other_radius: Option<f64>,
    pub length: Option<f64>,
    pub corner_radius: Option<f64>,
    /// At which it goes down into material at most, degrees.
    pub plunge_angle: Option<f64>,
    /// Cutting edges that follow each other in a turn.
    pub teeth: Option<u8>,
    /// Angle at the tip, degrees.
    pub tip_angle: Option<f64>,
    /// Oversizes of length, radius and corner radius from the table.
    pub table_deltas: [f64; 3],
    /// The same from TOOL CALL.
    pub call_deltas: [f64; 3],
}

impl ActiveTool {
    /// Radius with all oversizes.
    pub fn effective_radius(&self) -> Option<f64> {
        self.radius.map(|r| r + self.table_deltas[1] + self.call_deltas[1])
    }
}

/// How far a tool change got since the last block that cut.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Change {
    /// Complete, or none under way.
    #[default]
    None,
    /// An M6 stood in front of its TOOL CALL: the next TOOL CALL changes.
    Announced,
    /// The tool that was called is in the spindle already: an M6 changes nothing.
    InSpindle,
    /// Printed at the TOOL CALL; did the tool move since?
    Printed { moved: bool },
    /// Called and made ready; the M6 is still to come.
    Called {
        number: u32,
        /// TOOL CALL.
        from: Loc,
        /// Coordinate of the tool axis at the TOOL CALL, before it was forgotten.
        height: Option<f64>,
        /// The block under way holds the M6: wherever it goes, the change waits at its end.
        at_end: bool,
        /// Something moved since.
        moved: bool,
    },
    /// The change was missing where something cut, which was reported: an M6 now comes too late.
    Missed,
}

/// The tool that was called, and the one in the spindle.
#[derive(Debug, Clone, Default)]
pub(super) struct ToolState {
    active: Option<ActiveTool>,
    axis: Option<Axis>,
    /// The tool change under way.
    pub change: Change,
    /// Number of the tool that the last change printed.
    pub in_spindle: Option<u32>,
    /// A cycle that measures tools was left out: what the tables say of them is not what the control has.
    measured: bool,
    /// Axes that moved in the work offset in force with tools before this one.
    pub worked: AxisSet,
}

impl ToolState {
    /// The tool that was called last.
    pub fn active(&self) -> Option<&ActiveTool> {
        self.active.as_ref()
    }

    /// Tool axis of the last TOOL CALL that named one.
    #[inline]
    pub fn axis(&self) -> Option<Axis> {
        self.axis
    }

    pub fn is_measured(&self) -> bool {
        self.measured
    }

    /// A cycle that measures tools was left out: their sizes are the machine's.
    pub fn measure(&mut self) {
        self.measured = true;
        if let Some(tool) = &mut self.active {
            (tool.length, tool.radius, tool.corner_radius) = (None, None, None);
        }
    }

    /// The tool axis of a TOOL CALL; true where it is another one.
    pub fn set_axis(&mut self, axis: Axis) -> bool {
        self.axis.replace(axis) != Some(axis)
    }

    /// Another tool comes; axes that stand at a known place were moved with the one before.
    pub fn replace(&mut self, tool: ActiveTool, at: &Position) {
        if self.active.is_some() {
            let moved: AxisSet = AxisSet::MAIN.iter().filter(|axis| at.get(*axis).is_some()).collect();
            self.worked = self.worked.union(moved);
        }
        self.active = Some(tool);
    }

    /// The oversizes of a TOOL CALL for the tool that stays. True where it drops one.
    pub fn change_deltas(&mut self, deltas: [Option<f64>; 3]) -> bool {
        let Some(tool) = &mut self.active else { return false };
        let dropped = tool.call_deltas.iter().zip(&deltas).any(|(old, new)| *old != 0.0 && new.is_none());
        tool.call_deltas = deltas.map(Option::unwrap_or_default);
        dropped
    }

    /// What compensation has to know of the tool.
    pub fn cutter(&self) -> Option<Function> {
        let tool = self.active.as_ref()?;
        let known = tool.effective_radius();
        let radius = if tool.call_deltas[1] != 0.0 { known } else { None };
        Some(Function::Cutter(CutterData { number: tool.number, radius, known, ..CutterData::default() }))
    }

    /// FZ: `feed` mm for each tooth of the tool in the spindle.
    pub fn feed_of_teeth(&self, core: &Core<'_>, feed: f64, span: Span) -> Outcome<Feed> {
        let Some(tool) = &self.active else {
            return core.refuse(span, codes::K9013::fz_is_feed_per_tooth_and_no());
        };
        if let Some(teeth) = tool.teeth {
            return Ok(Feed::PerRevolution(feed * f64::from(teeth)));
        }
        let called = &tool.called;
        core.refuse(span, codes::K9013::fz_is_feed_per_tooth(&called).answer(Answer::tool(called, "teeth")))
    }

    /// Before RL or RR: is there a tool, and is its radius what the target believes?
    pub fn check_cutter(&self, core: &Core<'_>, span: Span) -> Outcome {
        match &self.active {
            None => core.refuse(span, codes::P2004::radius_compensation_without_tool()),
            Some(tool) if tool.call_deltas[1] != 0.0 && tool.radius.is_none() => {
                let fault = codes::P2004::tool_has_oversize_dr(&tool.called);
                core.refuse(span, fault.answer(Answer::tool(&tool.called, "radius")))
            }
            Some(_) => self.one_radius(core, span),
        }
    }

    /// TOOL DEF and the tool table give the tool the same radius: the target may compensate by the table.
    fn one_radius(&self, core: &Core<'_>, span: Span) -> Outcome {
        let Some(tool) = &self.active else { return Ok(()) };
        let (Some(own), Some(table)) = (tool.radius, tool.other_radius) else { return Ok(()) };
        let called = &tool.called;
        let fault = codes::K2890::tool_has_radius_in_its_tool_def(&called, &own, &table);
        core.refuse(span, fault.answer(Answer::tool(called, "radius")))
    }

    /// Radius of the active tool with its oversizes.
    pub fn radius(&self, core: &Core<'_>, span: Span) -> Outcome<f64> {
        self.one_radius(core, span)?;
        match &self.active {
            Some(tool) => match tool.effective_radius() {
                Some(radius) => Ok(radius),
                None => {
                    let fault = codes::P2004::radius_of_tool_is_not_known(&tool.called);
                    core.refuse(span, fault.answer(Answer::tool(&tool.called, "radius")))
                }
            },
            None => core.refuse(span, codes::P2004::no_tool_is_called()),
        }
    }
}

// The change under way.

impl ToolState {
    /// TOOL CALL of the tool that was called last: nothing is to change that is not under way already.
    pub fn call_again(&mut self) {
        match self.change {
            Change::Called { .. } | Change::Missed => {}
            Change::Announced => self.change = Change::None,
            Change::None | Change::InSpindle | Change::Printed { .. } => self.change = Change::InSpindle,
        }
    }

    /// The block under way ends with M6.
    pub fn m6_at_end(&mut self) {
        if let Change::Called { at_end, .. } = &mut self.change {
            *at_end = true;
        }
    }

    /// Something cuts: the tool that was called has to be in the spindle.
    pub fn cuts_now(&mut self, core: &Core<'_>) -> Outcome {
        let Change::Called { number, from, .. } = self.change else {
            if self.change != Change::Missed {
                self.change = Change::None;
            }
            return Ok(());
        };
        if self.in_spindle == Some(number) {
            self.change = Change::None;
            return Ok(());
        }
        self.change = Change::Missed;
        let fault = codes::K2801::tool_is_called(&number);
        let fault = fault.answer(Answer::key("control", "tool_change").one_of(&["\"t\""]));
        core.report(fault.at(core.here.origin.loc).also(from, Label::CalledHere));
        Err(Reported)
    }

    /// A move while a change is under way: `cuts`, or to a place of the tool axis.
    pub fn watch_move(&mut self, core: &Core<'_>, cuts: bool, along: bool) {
        match &mut self.change {
            Change::None | Change::InSpindle | Change::Missed => {}
            Change::Printed { moved } => *moved = true,
            // Back towards the workpiece, the M6 was not meant for a change at the next TOOL CALL.
            Change::Announced if along => self.change = Change::None,
            Change::Announced => {}
            Change::Called { at_end: true, .. } => return,
            Change::Called { moved, .. } => *moved = true,
        }
        if cuts {
            let _ = self.cuts_now(core);
        }
    }

    /// TOOL CALL of another tool while one waits for its M6: after a move it was not only the tool to make ready.
    pub fn warn_of_replaced(&self, core: &Core<'_>, next: u32) {
        if let Change::Called { number, from, moved: true, .. } = self.change
            && self.in_spindle != Some(number)
        {
            let found = codes::K2803::no_m6_follows_this_tool_call_before(&next, &number).at(from);
            core.report(found.also(core.here.origin.loc, Label::NextToolCall));
        }
    }

    /// The run is over: a tool that was called for its M6 stays ready.
    pub fn warn_of_forgotten(&self, core: &Core<'_>) {
        if let Change::Called { number, from, .. } = self.change
            && self.in_spindle != Some(number)
        {
            core.report(codes::K2803::no_m6_follows_this_tool_call(&number).at(from));
        }
    }
}
