//! FN 18: SYSREAD, for what the program text determines.
//!
//! Source: K 5.7, and 7.2 for the unit of lengths (docs/sources.md). It lists ID 20 NR 1, ID 50, ID 210, ID 220 and ID 270;
//! further answers are a reading that warns.

use crate::diag::{Answer, codes};
use crate::lexer::klartext::QRef;
use crate::machine::{Axis, Generation, ToolKey, Unit};
use crate::parser::klartext::ast::{Addr, Block};

use super::active_tool::ActiveTool;
use super::meanings;
use super::place::View;
use super::reading::Reading;
use super::tool_table::Tools;
use super::transformation::Transformation;
use super::vars::Slot;
use super::{Outcome, Reported, Run};

/// What is asked for.
#[derive(Debug, Clone, Copy, Default)]
struct Request {
    id: u32,
    nr: u32,
    idx: Option<f64>,
}

impl Request {
    /// `ID240 NR1 IDX3`
    fn name(self) -> String {
        let idx = self.idx.map(|idx| format!(" IDX{idx}")).unwrap_or_default();
        format!("ID{} NR{}{idx}", self.id, self.nr)
    }
}

impl Request {
    /// IDX as the number of an axis.
    fn axis(self) -> Option<Axis> {
        let index = self.idx.filter(|n| n.fract() == 0.0 && (1.0..=9.0).contains(n))?;
        Axis::ALL.get(index as usize - 1).copied()
    }

    /// Does it ask for a length?
    fn is_length(self) -> bool {
        let rotary = self.idx.is_some_and(|n| (4.0..=6.0).contains(&n));
        match (self.id, self.nr) {
            (50, 1..=6) | (200, 1..=3) => true,
            (220, 2) | (240, 1) | (270, 1) => !rotary,
            _ => false,
        }
    }
}

impl ActiveTool {
    /// Active tool: radius, length, corner radius; IDX 1 without, 2 with table, 3 with all oversizes.
    fn size(&self, r: Request, mm: f64) -> Option<f64> {
        let (value, i) = match r.nr {
            1 => (self.radius?, 1),
            2 => (self.length?, 0),
            _ => (self.corner_radius?, 2),
        };
        let table = self.table_deltas[i];
        match r.idx.map(|n| n as u32) {
            Some(1) => Some(value / mm),
            Some(2) => Some((value + table) / mm),
            Some(3) => Some((value + table + self.call_deltas[i]) / mm),
            _ => None,
        }
    }
}

/// ID 210 and ID 220: what the transformation does.
fn transformed(t: &Transformation, r: Request, mm: f64) -> Option<f64> {
    match (r.id, r.nr) {
        (210, 1) => t.basic.map(|angle| angle.0),
        (210, 2) => Some(t.angle.0),
        (210, 3) => Some((0..3).map(|i| if t.mirror.contains(Axis::ALL[i]) { f64::from(1 << i) } else { 0.0 }).sum()),
        (210, 4) => r.axis().map(|axis| t.scale * t.axis_scale.get(axis.index()).copied().unwrap_or(1.0)),
        (210, 5) if t.turn.0 == 0.0 => r.axis().filter(|axis| axis.is_main()).map(|_| 0.0),
        (210, 6) if t.turn.0 == 0.0 => Some(0.0),
        (220, 2) => r.axis().map(|axis| {
            let shift = t.shift[axis.index()];
            if axis.is_rotary() { shift } else { shift / mm }
        }),
        _ => None,
    }
}

impl Run<'_> {
    pub(super) fn system_read(&mut self, target: QRef, block: &Block, text: &[u8]) -> Outcome {
        let answers = Answers { view: self.view(), tools: &self.tools, block };
        let value = request(self.reading(), block, text).and_then(|request| answers.answer(request));
        let slot = match value {
            Ok(value) => Slot::Number(value),
            Err(Reported) => Slot::Lost,
        };
        self.vars.assign(&mut self.core, target, slot, block.span)?;
        value.map(drop)
    }
}

fn request(reading: Reading<'_, '_>, block: &Block, text: &[u8]) -> Outcome<Request> {
    let mut request = Request::default();
    let mut words = block.words.iter();
    while let Some(name) = words.next() {
        let value = match (name.addr, words.next()) {
            (Addr::Name, Some(value)) if value.addr == Addr::Value => value,
            _ => return reading.core.refuse(name.span, codes::P1001::sysread_takes_id()),
        };
        let whole = |n: f64| (n >= 0.0 && n.fract() == 0.0).then_some(n as u32);
        let n = reading.number(value.value, value.span)?;
        match (name.span.of(text).to_ascii_uppercase().as_slice(), whole(n)) {
            (b"ID", Some(n)) => request.id = n,
            (b"NR", Some(n)) => request.nr = n,
            (b"IDX", _) => request.idx = Some(n),
            _ => {
                return reading.core.refuse(value.span, codes::P1001::sysread_takes_whole_numbers_behind_id());
            }
        }
    }
    Ok(request)
}

/// What a block that asks is answered by.
struct Answers<'r, 'a> {
    view: View<'r, 'a>,
    tools: &'r Tools,
    block: &'r Block,
}

impl Answers<'_, '_> {
    /// Millimetres per unit of the lengths that the control gives.
    fn unit_of_lengths(&self) -> f64 {
        let control = &self.view.core.job.settings.control;
        let in_mm = control.klartext_choices.system_in_mm.unwrap_or(control.klartext >= Generation::Tnc7);
        if in_mm { 1.0 } else { self.view.core.mm() }
    }

    /// No manual page of an older control says in which unit FN 18 reads a length in an INCH program.
    fn unit_is_said(&self, r: Request, value: f64) -> Outcome {
        let control = &self.view.core.job.settings.control;
        let said = control.klartext_choices.system_in_mm.is_some() || control.klartext >= Generation::Tnc7;
        if said || value == 0.0 || self.view.core.unit() == Unit::Mm || !r.is_length() {
            return Ok(());
        }
        let fault = codes::K2855::is_length_in_inch_program_controls_may(&r.name());
        self.view.core.refuse(self.block.span, fault.answer(Answer::key("control", "system_unit")))
    }

    fn answer(&self, r: Request) -> Outcome<f64> {
        let mm = self.unit_of_lengths();
        let axis = r.axis();
        let known = match (r.id, r.nr) {
            // State of the machine as the program set it.
            (20, 1) => self.view.st.tool.active().and_then(|tool| tool.own).map(f64::from),
            (20, 3) => self.view.st.tool.axis().map(|axis| axis.index() as f64),
            (20, 4) => self.view.st.spindle.speed(),
            (50, 1..=6) => return self.table_value(r),
            (200, 1..=3) => self.view.st.tool.active().and_then(|tool| tool.size(r, mm)),
            // What the control gives of a tilted plane depends on how it was defined.
            (210, 5 | 6) if !self.view.st.tilt.is_upright() => None,
            (210 | 220, _) => transformed(self.view.st.frames.transform(), r, mm),
            (240, 1) => axis.filter(|axis| !self.view.st.position.may_be_moved(*axis)).and_then(|axis| {
                let value = self.view.machine_coordinate(axis)?;
                Some(if axis.is_rotary() { value } else { value / mm })
            }),
            (270, 1) => match axis {
                Some(axis) if !self.view.st.position.may_be_moved(axis) => match self.view.st.position.get(axis) {
                    None if self.answered(r).is_some() => None,
                    _ => {
                        let value = self.view.position_of(axis, self.block.span, "SYSREAD")?;
                        self.unit_is_said(r, value)?;
                        return Ok(if axis.is_rotary() {
                            value - self.view.st.rotary.turns_of(axis)
                        } else {
                            value / mm
                        });
                    }
                },
                _ => None,
            },
            _ => None,
        };
        match known {
            Some(value) => {
                self.unit_is_said(r, value)?;
                if matches!((r.id, r.nr), (20, 2..) | (200, _)) {
                    let fault = codes::K8021::id_nr_is_answered_as_older_programs(&r.id, &r.nr);
                    self.view.core.note(self.block.span, fault);
                }
                Ok(value)
            }
            None => match self.answered(r) {
                Some(value) => Ok(value),
                None => self.only_at_machine(r, axis),
            },
        }
    }

    fn only_at_machine(&self, r: Request, axis: Option<Axis>) -> Outcome<f64> {
        let meaning = meanings::of_system_data(r.id, r.nr, r.idx);
        let what = if meaning.is_empty() { String::new() } else { format!(", {meaning},") };
        let place = matches!((r.id, r.nr), (240 | 270, 1));
        let why = match axis {
            Some(axis) if place && self.view.st.position.may_be_moved(axis) => {
                ": the axis may have been moved by hand since the program stopped"
            }
            _ => "",
        };
        let fault = codes::K9016::system_data_id_nr_is_known(&r.id, &r.nr, &what, &why, &r.name());
        self.view.core.refuse(self.block.span, fault.answer(Answer::variable(r.name(), meaning)))
    }

    /// What `[variables]` says, in the unit of the program.
    fn answered(&self, r: Request) -> Option<f64> {
        let bare = |name: &str| name.replace(' ', "");
        let name = bare(&r.name());
        self.view.core.job.settings.variables.iter().find(|(key, _)| bare(key) == name).map(|(_, value)| *value)
    }

    /// ID 50: tool table, NR 1 L, 2 R, 3 R2, 4 DL, 5 DR, 6 DR2; IDX is the tool.
    fn table_value(&self, r: Request) -> Outcome<f64> {
        let mm = self.unit_of_lengths();
        let Some(n) = r.idx.filter(|n| *n >= 1.0) else {
            return self.view.core.refuse(self.block.span, codes::K9016::id_50_reads_tool_table());
        };
        let key = ToolKey::Number(n.trunc() as u32, (n.fract() * 10.0).round() as u8);
        let mut data = self.view.core.job.settings.tools.table.get(&key).cloned();
        if let Some((length, radius)) = self.tools.defined(n as u32) {
            let tool = data.get_or_insert_with(Default::default);
            tool.length = length.or(tool.length);
            tool.radius = radius.or(tool.radius);
        }
        if self.view.st.tool.is_measured() {
            data = None;
        }
        let value = data.as_ref().and_then(|tool| match r.nr {
            1 => tool.length,
            2 => tool.radius,
            3 => tool.corner_radius,
            n => Some(tool.deltas[n as usize - 4]),
        });
        match value {
            Some(value) => {
                self.unit_is_said(r, value)?;
                Ok(value / mm)
            }
            None => self.view.core.refuse(
                self.block.span,
                codes::P2004::table_data_of_tool_is_not_known(&key).answer(Answer::tool(&key, field_of(r.nr))),
            ),
        }
    }
}

/// The key of a tool that answers for a number of its data in the tool table.
fn field_of(nr: u32) -> &'static str {
    match nr {
        1 => "length",
        2 => "radius",
        _ => "corner_radius",
    }
}
