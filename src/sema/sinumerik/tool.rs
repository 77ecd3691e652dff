//! Tools: choice, change, cutting edge, radius compensation.
//!
//! Source: S 2.12 and 2.15 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::function::CutterData;
use crate::ir::{Function, Side};
use crate::machine::tools::ToolKey;
use crate::machine::{ChangeCall, MachineKind, Settings, StandIn, Unit};
use crate::sema::Reported;
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::text::Span;

use super::compensation::{Cutter, edge_points_to, nose};
use super::system_variables::SystemVariables;
use super::words::{Given, Words};
use super::{Channel, Core, Outcome, State};

/// The tool in use.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ToolInUse {
    /// In the spindle or turret.
    active: Option<u32>,
    /// Chosen by T, not yet changed.
    next: Option<u32>,
    /// T was refused: which tool waits is not known.
    pub waits_unnamed: bool,
    /// Edge (D number).
    edge: Option<u32>,
    /// D that was programmed between T and M6, and the doubt after M6 whether it counts (MD 20270).
    edge_before_change: Option<u32>,
    edge_in_doubt: bool,
    /// Another tool than the one in use was in use before.
    others_worked: bool,
    /// The program wrote the radius, or where the edge lies, behind the selection.
    rewritten: bool,
}

impl ToolInUse {
    pub fn active(&self) -> Option<u32> {
        self.active
    }

    pub fn next(&self) -> Option<u32> {
        self.next
    }

    /// The tool that T has chosen and nothing has changed in yet.
    pub fn waiting(&self) -> Option<u32> {
        self.next.filter(|next| Some(*next) != self.active)
    }

    pub fn edge(&self) -> Option<u32> {
        self.edge
    }

    /// Did another tool than the one in use work before?
    pub fn others_worked(&self) -> bool {
        self.others_worked
    }

    /// The edge whose data count: D1 where none was said.
    pub fn edge_or_first(&self) -> u32 {
        self.edge.unwrap_or(1)
    }

    /// Whether the last D counts is a machine datum.
    pub fn edge_in_doubt(&self) -> bool {
        self.edge_in_doubt
    }

    /// The program wrote its data behind the selection.
    pub fn is_rewritten(&self) -> bool {
        self.rewritten
    }

    /// D0: the tool in use counts without its data.
    pub fn is_without_offset(&self) -> bool {
        self.edge == Some(0) && self.active.is_some_and(|number| number != 0)
    }

    /// T
    pub fn choose(&mut self, number: u32) {
        (self.next, self.edge_before_change) = (Some(number), None);
        self.waits_unnamed = false;
    }

    /// The chosen tool comes into use, by its first edge.
    fn change_to(&mut self, number: u32) {
        self.others_worked |= self.active.is_some_and(|active| active != 0 && active != number);
        (self.active, self.edge) = (Some(number), Some(1));
        self.edge_in_doubt = self.edge_before_change.take().is_some_and(|edge| edge != 1);
        self.rewritten = false;
    }

    /// D
    fn select_edge(&mut self, edge: u32) {
        (self.edge, self.edge_in_doubt, self.rewritten) = (Some(edge), false, false);
        if self.next.is_some() && self.next != self.active {
            self.edge_before_change = Some(edge);
        }
    }

    /// Is it known that the edge has the lengths of D1? The target has one length for a tool, so the ways of an edge with another one would be off by the difference.
    fn has_length_of_first(&self, core: &Core<'_>, system: &SystemVariables, edge: u32, span: Span) -> Outcome<bool> {
        let Some(number) = self.active.filter(|_| edge > 1) else { return Ok(false) };
        let mut known = true;
        for parameter in 3..=5 {
            let length = |edge: u32| system.of_edge(parameter, number, edge);
            if let (Some(first), Some(other)) = (length(1), length(edge))
                && first != other
            {
                return core.refuse(
                    span,
                    codes::S9021::length_of_d_of_t_is_mm(&(parameter - 2), &edge, &number, &other, &first),
                );
            }
            known &= length(1) == length(edge) && (length(1).is_some() || parameter != 3);
        }
        Ok(known)
    }

    /// The program writes `$TC_…`: what the radius compensation takes from the edge in use counts from the next selection.
    pub fn is_written(&mut self, word: &str, key: &str) {
        let Some(number) = self.active.filter(|_| matches!(word, "$TC_DP2" | "$TC_DP6" | "$TC_DP15")) else {
            return;
        };
        if key == format!("{word}[{number},{}]", self.edge_or_first()) {
            self.rewritten = true;
        }
    }

    /// What the program wrote for the edge in use counts from its next selection on: whether it does before, is open.
    pub fn is_as_selected(&self, core: &Core<'_>, number: u32, edge: u32, span: Span) -> Outcome {
        if !self.rewritten {
            return Ok(());
        }
        core.refuse(span, codes::P9013::data_of_t_d_were_written_after(&number, &edge))
    }
}

/// Turrets change with T (MD 22550 = 0), mills with M6.
fn changes_by_t(settings: &Settings) -> bool {
    // A program that changes to the chosen tool would have nothing to do.
    let by_program =
        || settings.programs.values().any(|known| matches!(known, StandIn::Change(ChangeCall { tool: None, .. })));
    let by_m = !settings.control.tool_change_m.is_empty();
    settings
        .control
        .sinumerik
        .tool_change_by_t
        .unwrap_or_else(|| settings.machine.kind == MachineKind::Lathe && !by_m && !by_program())
}

impl State {
    /// Edge number `d` comes into force.
    pub(super) fn select_edge(&mut self, core: &Core<'_>, d: f64, span: Span) -> Outcome {
        if d.fract() != 0.0 || !(0.0..=32_000.0).contains(&d) {
            return core.refuse(span, codes::S2043::d_is_no_edge_number(&d));
        }
        let edge = d as u32;
        if self.tool.edge.is_some_and(|old| old != edge) {
            self.forget_tip(core.here.origin.loc, By::Edge);
        }
        let changes = self.tool.edge != Some(edge) || self.tool.rewritten;
        if self.side() != Side::None && !self.compensation.is_starting() && changes {
            return core.refuse(span, codes::S2080::cutting_edge_changes_while_radius_compensation());
        }
        let alike = self.tool.has_length_of_first(core, &self.system, edge, span)?;
        self.tool.select_edge(edge);
        if alike {
            core.say_once(span, codes::S8010::cutting_edges_other_than_d1_are_not());
        } else if edge > 1 && core.job.diags.first_time(codes::S8254, (self.tool.active, edge)) {
            core.report(codes::S8254::d_is_not_printed(&edge).at(core.loc(span)));
        }
        Ok(())
    }
}

impl Channel<'_> {
    pub(super) fn tool_word_given(&mut self, t: Given, w: &mut Words) -> Outcome {
        let number = match w.tool_name.take() {
            Some(name) => self.tool_by_name(&name, t.span)?,
            None if t.value.fract() == 0.0 && (0.0..=32_000.0).contains(&t.value) => {
                self.core.tool_by_number(t.value as u32, t.span)?
            }
            None => return self.core.refuse(t.span, codes::S2043::t_is_no_tool_number(&t.value)),
        };
        self.proposed.call(number);
        if number != 0 {
            let unit = if self.st.feed_unit() == Unit::Inch.mm() { Unit::Inch } else { Unit::Mm };
            self.core.job.calls_tool_in(unit, self.core.loc(t.span));
        }
        self.left.chosen(&mut self.core, number);
        self.st.tool.choose(number);
        let settings = &self.core.job.settings.tools;
        if settings.complete && number != 0 && settings.called(number).is_none() {
            let found = codes::P2006::tool_is_not_in_tool_table(&number).at(self.core.loc(t.span));
            self.core.report(found.help("add it to the table, or check the number"));
        }
        if changes_by_t(self.core.job.settings) {
            return self.change_tool();
        }
        if !w.m.iter().any(|m| m.number == 6) {
            self.function(Function::ToolPrepare { number: settings.printed_number(number) });
        }
        Ok(())
    }

    pub(super) fn tool_by_name(&mut self, name: &str, span: Span) -> Outcome<u32> {
        let tools = &self.core.job.settings.tools;
        match tools.by_exact_name(name) {
            Some((Some(printed), _)) => {
                let Some(key) = tools.key_of_name(name, true) else { return Ok(printed) };
                let written = self.st.system.tool_named(name).filter(|own| tools.printed_number(*own) != printed);
                if let Some(other) = tools.other_of_number(key).or(written) {
                    self.core.report(self.core.another_tool(key, &ToolKey::Number(other, 0), printed, span));
                    return Err(Reported);
                }
                self.core.prints_tool(key, printed, span)?;
                // What has no number of its own is known by the printed one.
                Ok(if let ToolKey::Number(own, _) = key { *own } else { printed })
            }
            _ => {
                let help = self.proposed.help(name, tools);
                self.st.tool.waits_unnamed = true;
                self.core.refuse(span, codes::S2043::tool_has_no_number(&name).help(&help))
            }
        }
    }

    pub(super) fn change_tool(&mut self) -> Outcome {
        let Some(number) = self.st.tool.next else {
            return self.core.refuse(Where::Block, codes::S2043::no_tool_is_chosen_so_program_t());
        };
        if self.st.side() != Side::None {
            return self.core.refuse(Where::Block, codes::S2080::tool_changes_while_radius_compensation());
        }
        let printed = self.core.job.settings.tools.printed_number(number);
        self.st.tool.change_to(number);
        self.left.changed();
        self.function(Function::ToolChange { number: printed });
        // A tool of another length.
        self.st.forget_tip(self.core.here.origin.loc, By::ToolChange);
        self.stand_after_change();
        Ok(())
    }

    /// Tells the target which tool is compensated.
    pub(super) fn select_cutter(&mut self, span: Span) -> Outcome {
        let help = if self.st.tool.next.is_some() {
            Answer::key("control", "tool_change")
                .help("the tool is chosen, not changed: M6 is missing, or set `[control] tool_change = \"t\"`")
        } else {
            "select a tool before".into()
        };
        let Some(number) = self.st.tool.active.filter(|n| *n != 0) else {
            return self.core.refuse(span, codes::S2080::radius_compensation_without_tool().help(help));
        };
        if self.st.tool.edge_in_doubt {
            return self.core.refuse(span, codes::S2080::d_was_programmed_between_t());
        }
        let edge = self.st.tool.edge_or_first();
        let radius = cutter_radius(&self.core, &self.st.system, number, edge, span)?;
        self.st.tool.is_as_selected(&self.core, number, edge, span)?;
        if self.core.resolves() {
            let tool = self.core.job.settings.tools.called(number).filter(|_| edge == 1);
            let listed = || tool.and_then(|tool| Some(tool.radius? + tool.deltas[1]));
            let Some(radius) = radius.or_else(listed) else {
                let fault = codes::P9013::radius_of_t_d_is_not_known(&number, &edge);
                return self.core.refuse(span, fault.answer(Answer::tool(number, "radius")));
            };
            let nose = nose(&self.core, &self.st, number, edge, radius, span)?;
            return self.st.path.begin(&self.core, Cutter { radius, nose }, span);
        }
        let edge = match radius {
            // The target looks for both in its own tool table.
            None => [0, 0],
            Some(radius) => edge_points_to(nose(&self.core, &self.st, number, edge, radius.abs(), span)?),
        };
        let number = self.core.job.settings.tools.printed_number(number);
        self.function(Function::Cutter(CutterData { number, radius, edge, ..CutterData::default() }));
        Ok(())
    }
}

/// The radius that the program gives an edge, with its wear; `None` for that of the target's own table.
fn cutter_radius(
    core: &Core<'_>,
    system: &SystemVariables,
    number: u32,
    edge: u32,
    span: Span,
) -> Outcome<Option<f64>> {
    if edge == 0 {
        return core.refuse(span, codes::S2080::radius_compensation_under_d0());
    }
    if system.is_written("$P_AD[6]") || system.is_written("$P_AD[15]") {
        return core.refuse(span, codes::P9013::program_changes_radius_of_active_tool());
    }
    let written = |parameter: u8| system.of_edge(parameter, number, edge);
    let listed = || {
        let tool = core.job.settings.tools.called(number).filter(|_| edge == 1);
        tool.and_then(|tool| tool.radius)
    };
    match (written(6), written(15).filter(|wear| *wear != 0.0)) {
        (radius, None) if radius.is_some() || edge == 1 => Ok(radius),
        (radius, Some(wear)) if radius.or_else(listed).is_some() => {
            Ok(radius.or_else(listed).map(|radius| radius + wear))
        }
        (_, wear) => {
            let what = if wear.is_some() { "the program writes its wear only" } else { "the target knows that of D1" };
            core.refuse(span, codes::P9013::radius_of_t_d_is_not(&number, &edge, &what))
        }
    }
}

impl Core<'_> {
    pub(super) fn tool_by_number(&mut self, number: u32, span: Span) -> Outcome<u32> {
        if number != 0 {
            let printed = self.job.settings.tools.printed_number(number);
            self.prints_tool(&ToolKey::Number(number, 0), printed, span)?;
        }
        Ok(number)
    }
}
