//! Tools: choice, change, cutting edge, radius compensation.
//!
//! Source: S 2.12 and 2.15 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::function::CutterData;
use crate::ir::{Function, Side};
use crate::machine::tools::ToolKey;
use crate::machine::{ChangeCall, StandIn, Unit};
use crate::sema::Reported;
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::words::{Given, Words};
use super::{Channel, Core, Outcome};

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
}

/// How the radius compensation begins and ends.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CompensationState {
    /// G40, G41 or G42 waits for its move.
    starts: bool,
    /// The side that G40 ended, and whether its offset still waits for a move in the plane.
    leaving: Side,
    leaving_open: bool,
    /// G41 or G42 of the block, until its D is known.
    open: Option<Span>,
}

impl CompensationState {
    /// G41 or G42 of the block, once its D is known.
    pub fn take_open(&mut self, waits: bool) -> Option<Span> {
        self.open.take_if(|_| !waits)
    }

    /// Blocks stand where the compensation would start.
    pub fn begins_no_more(&mut self) {
        self.starts = false;
    }

    /// The side that G40 ended.
    pub fn left(&self) -> Side {
        self.leaving
    }

    /// A move in machine coordinates has ended the contour.
    pub fn is_over(&mut self) {
        (self.starts, self.leaving_open) = (false, false);
    }

    /// G40, G41 or G42 waits for its move or its D.
    pub fn waits(&self) -> bool {
        self.starts || self.leaving_open || self.open.is_some()
    }

    /// The side on which a move is printed under `side`: behind G40 the one of before, until a move in the plane takes
    /// the offset off.
    #[inline]
    pub fn side_of_move(&self, side: Side) -> Side {
        if self.leaving_open { self.leaving } else { side }
    }

    /// G40 waits for a move in the plane.
    #[inline]
    pub fn is_leaving(&self) -> bool {
        self.leaving_open
    }
}

impl Channel<'_> {
    pub(super) fn tool_word_given(&mut self, t: Given, w: &mut Words) -> Outcome {
        let number = match w.tool_name.take() {
            Some(name) => self.tool_by_name(&name, t.span)?,
            None if t.value.fract() == 0.0 && (0.0..=32_000.0).contains(&t.value) => {
                self.tool_by_number(t.value as u32, t.span)?
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
        if self.changes_by_t() {
            return self.change_tool();
        }
        if !w.m.iter().any(|m| m.number == 6) {
            self.function(Function::ToolPrepare { number: settings.printed_number(number) });
        }
        Ok(())
    }

    /// Turrets change with T (MD 22550 = 0), mills with M6.
    pub(super) fn changes_by_t(&self) -> bool {
        let settings = &self.core.job.settings;
        // A program that changes to the chosen tool would have nothing to do.
        let by_program =
            || settings.programs.values().any(|known| matches!(known, StandIn::Change(ChangeCall { tool: None, .. })));
        let by_m = !settings.control.tool_change_m.is_empty();
        settings.control.sinumerik.tool_change_by_t.unwrap_or_else(|| self.st.machine.lathe && !by_m && !by_program())
    }

    pub(super) fn tool_by_number(&mut self, number: u32, span: Span) -> Outcome<u32> {
        if number != 0 {
            let printed = self.core.job.settings.tools.printed_number(number);
            self.core.prints_tool(&ToolKey::Number(number, 0), printed, span)?;
        }
        Ok(number)
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
        self.forget_tip(By::ToolChange);
        self.stand_after_change();
        Ok(())
    }

    pub(super) fn edge(&mut self, d: Given) -> Outcome {
        self.edge_number(d.value, d.span)
    }

    /// The target has one length for a tool, so the ways of an edge with another one would be off by the difference.
    fn refuse_other_length(&self, edge: u32, span: Span) -> Outcome {
        let Some(number) = self.st.tool.active.filter(|_| edge > 1) else { return Ok(()) };
        for parameter in 3..=5 {
            let length = |edge: u32| self.st.system.number(&format!("$TC_DP{parameter}[{number},{edge}]"));
            if let (Some(first), Some(other)) = (length(1), length(edge))
                && first != other
            {
                return self.core.refuse(
                    span,
                    codes::S9021::length_of_d_of_t_is_mm(&(parameter - 2), &edge, &number, &other, &first),
                );
            }
        }
        Ok(())
    }

    /// Edge number `d` comes into force.
    pub(super) fn edge_number(&mut self, d: f64, span: Span) -> Outcome {
        if d.fract() != 0.0 || !(0.0..=32_000.0).contains(&d) {
            return self.core.refuse(span, codes::S2043::d_is_no_edge_number(&d));
        }
        let edge = d as u32;
        if self.st.tool.edge.is_some_and(|old| old != edge) {
            self.forget_tip(By::Edge);
        }
        let changes = self.st.tool.edge != Some(edge) || self.st.tool.rewritten;
        if self.st.side() != Side::None && !self.st.compensation.starts && changes {
            return self.core.refuse(span, codes::S2080::cutting_edge_changes_while_radius_compensation());
        }
        self.refuse_other_length(edge, span)?;
        self.st.tool.select_edge(edge);
        if edge > 1 && self.has_length_of_first(edge) {
            self.core.say_once(span, codes::S8010::cutting_edges_other_than_d1_are_not());
        } else if edge > 1 && self.core.job.diags.first_time(codes::S8254, (self.st.tool.active, edge)) {
            self.core.report(codes::S8254::d_is_not_printed(&edge).at(self.core.loc(span)));
        }
        Ok(())
    }

    /// Is it known that the edge has the lengths of D1?
    fn has_length_of_first(&self, edge: u32) -> bool {
        let Some(number) = self.st.tool.active else { return false };
        let length = |edge: u32, parameter: u8| self.st.system.number(&format!("$TC_DP{parameter}[{number},{edge}]"));
        length(1, 3).is_some() && (3..=5).all(|parameter| length(1, parameter) == length(edge, parameter))
    }

    /// The program writes `$TC_…`: what the radius compensation takes from the edge in use counts from the next selection.
    pub(super) fn radius_is_written(&mut self, word: &str, key: &str) {
        let Some(number) = self.st.tool.active.filter(|_| matches!(word, "$TC_DP2" | "$TC_DP6" | "$TC_DP15")) else {
            return;
        };
        if key == format!("{word}[{number},{}]", self.st.tool.edge_or_first()) {
            self.st.tool.rewritten = true;
        }
    }

    /// Position of a cutting edge.
    pub(super) fn edge_position(&self, number: u32, edge: u32) -> Option<f64> {
        self.st.edge_position(self.core.job.settings, number, edge)
    }

    /// The radius of the active edge with its wear.
    pub(super) fn known_radius(&self) -> Option<f64> {
        self.st.known_radius(self.core.job.settings)
    }

    pub(super) fn compensation_code(&mut self, code: GCode, span: Span) -> Outcome {
        if code != GCode::G40 {
            if self.core.resolves() {
                self.begins_again(code, span)?;
            }
            if self.st.codes.of(Group::CompensationType).index > 2 {
                let kind = self.st.codes.of(Group::CompensationType).word();
                return self.core.refuse(span, codes::P9013::under_radius_is_compensated_in_space(&kind));
            }
            self.st.compensation.open = Some(span);
            if !self.core.resolves() {
                self.says_shape_of_compensation(span);
            }
        } else {
            self.st.compensation.open = None;
        }
        if code != GCode::G40 && self.st.compensation.leaving_open {
            return self.core.refuse(span, codes::S2080::side_stands_behind_g40_without_move());
        }
        if code == GCode::G40 && self.st.side() != Side::None {
            self.st.compensation.leaving = self.st.side();
        }
        let waits = self.st.compensation.starts || self.st.compensation.leaving_open;
        self.st.compensation.starts = !self.st.is(code) || waits;
        self.st.codes.activate(code);
        Ok(())
    }

    /// The target rounds corners, enters and leaves the contour in its own way.
    fn says_shape_of_compensation(&self, span: Span) {
        let shapes = [Group::Approach, Group::Corner, Group::Collision, Group::CompensationEnds];
        if let Some(code) = shapes.into_iter().map(|group| self.st.codes.of(group)).find(|code| code.index != 1) {
            self.core.says_shape(span, &code.word());
        }
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
        let radius = self.cutter_radius(number, edge, span)?;
        self.edge_is_as_selected(number, edge, span)?;
        if self.core.resolves() {
            return self.compute_compensation(number, edge, radius, span);
        }
        let edge = match radius {
            // The target looks for both in its own tool table.
            None => [0, 0],
            Some(radius) => self.edge_points_to(number, edge, radius, span)?,
        };
        let number = self.core.job.settings.tools.printed_number(number);
        self.function(Function::Cutter(CutterData { number, radius, edge, ..CutterData::default() }));
        Ok(())
    }

    pub(super) fn edge_was_rewritten(&self) -> bool {
        self.st.tool.rewritten
    }

    /// What the program wrote for the edge in use counts from its next selection on: whether it does before, is open.
    pub(super) fn edge_is_as_selected(&self, number: u32, edge: u32, span: Span) -> Outcome {
        if !self.st.tool.rewritten {
            return Ok(());
        }
        self.core.refuse(span, codes::P9013::data_of_t_d_were_written_after(&number, &edge))
    }

    /// The same for G41 and G42 themselves, which do not come into force without it.
    pub(super) fn select_cutter_or_end(&mut self, span: Span) -> Outcome {
        let result = self.select_cutter(span);
        if result.is_err() {
            self.end_compensation();
        }
        result
    }

    fn end_compensation(&mut self) {
        self.st.codes.activate(GCode::G40);
        self.st.compensation.starts = false;
    }

    /// The block of a G41 or G42 has failed in front of its D: no later block stands for it.
    pub(super) fn begin_no_compensation(&mut self) {
        if self.st.compensation.take_open(false).is_some() {
            self.end_compensation();
        }
    }

    /// The radius that the program gives an edge, with its wear; `None` for that of the target's own table.
    fn cutter_radius(&self, number: u32, edge: u32, span: Span) -> Outcome<Option<f64>> {
        if edge == 0 {
            return self.core.refuse(span, codes::S2080::radius_compensation_under_d0());
        }
        if self.st.system.is_written("$P_AD[6]") || self.st.system.is_written("$P_AD[15]") {
            return self.core.refuse(span, codes::P9013::program_changes_radius_of_active_tool());
        }
        let written = |parameter: u8| {
            let key = format!("$TC_DP{parameter}[{number},{edge}]");
            self.st.system.number(&key)
        };
        let listed = || {
            let tool = self.core.job.settings.tools.called(number).filter(|_| edge == 1);
            tool.and_then(|tool| tool.radius)
        };
        match (written(6), written(15).filter(|wear| *wear != 0.0)) {
            (radius, None) if radius.is_some() || edge == 1 => Ok(radius),
            (radius, Some(wear)) if radius.or_else(listed).is_some() => {
                Ok(radius.or_else(listed).map(|radius| radius + wear))
            }
            (_, wear) => {
                let what =
                    if wear.is_some() { "the program writes its wear only" } else { "the target knows that of D1" };
                self.core.refuse(span, codes::P9013::radius_of_t_d_is_not(&number, &edge, &what))
            }
        }
    }

    /// Compensation starts and ends on a straight line.
    pub(super) fn check_start_of_compensation(&mut self, code: GCode, in_plane: bool, span: Span) -> Outcome {
        if !self.st.compensation.starts {
            return Ok(());
        }
        let on = self.st.side() != Side::None;
        let line = matches!(code, GCode::G0 | GCode::G1);
        if !on && line && !in_plane && !self.core.job.settings.control.sinumerik.g40_needs_motion {
            // The plane position does not change, so the offset can wait for the next move in the plane.
            self.st.compensation.leaving_open = true;
            if !self.core.resolves() && self.core.job.diags.first_time(codes::S8134, ()) {
                let found = codes::S8134::g40_stands_in_front_of_move().at(self.core.loc(span));
                self.core
                    .report(found.help("program G40 with a move in the plane; some controls show alarm 10754 here"));
            }
            return Ok(());
        }
        (self.st.compensation.starts, self.st.compensation.leaving_open) = (false, false);
        if line && in_plane {
            return Ok(());
        }
        let alarm = if on { 10753 } else { 10754 };
        let what = if in_plane { "on an arc" } else { "without a move in the plane" };
        self.core
            .refuse(span, codes::S2080::radius_compensation(&(if on { "starts" } else { "ends" }), &what).alarm(alarm))
    }

    /// What ends the compensation on the target while the tool still stands beside the contour: its next move would go
    /// over the contour.
    pub(super) fn leaves_in_front_of(&mut self, function: &Function) -> Outcome {
        let ends = match function {
            // The path was computed, and stays where it is.
            Function::ToolChange { .. } => !self.core.resolves(),
            _ => matches!(function, Function::WorkOffset(_) | Function::Plane(_) | Function::Transformation(_)),
        };
        if !ends || !self.st.compensation.leaving_open {
            return Ok(());
        }
        self.st.compensation.leaving_open = false;
        self.core.refuse(Where::Block, codes::S2080::g40_has_had_no_move_in_plane())
    }
}

impl Core<'_> {
    pub(super) fn says_shape(&self, span: Span, word: &str) {
        self.say_once(span, codes::S8043::is_left_out(&word));
    }
}
