//! Reading: what the numbers, parameters and names of a block are where it runs.
//!
//! Nothing is changed by it; what has no value is reported here, in the words of the block.

use std::rc::Rc;

use crate::diag::{Answer, Label as Also, codes};
use crate::ir::function::Turn;
use crate::lexer::klartext::{QKind, QRef, Value};
use crate::machine::{Generation, Unit};
use crate::parser::klartext::ast::{LabelRef, Operand, Relation, Test};
use crate::sema::run::Where;
use crate::text::{Span, decode::readable, number::decimal};

use super::labels::Label;
use super::meanings;
use super::state::State;
use super::vars::{Slot, Val, Vars, exists, named};
use super::{Core, Outcome, Reported};

/// The parameters of radius and length of the tool.
const RADIUS: u32 = 108;
const LENGTH: u32 = 114;

/// Values that differ by less may differ by the rounding of what they were computed from.
const ROUNDING: f64 = 1e-9;

/// What a block reads: parameters, and what the control knows of tool and spindle.
#[derive(Clone, Copy)]
pub(super) struct Reading<'r, 'a> {
    pub core: &'r Core<'a>,
    pub vars: &'r Vars,
    pub st: &'r State,
}

impl Reading<'_, '_> {
    /// The number that stands behind an address.
    #[inline]
    pub fn number(&self, value: Value, span: Span) -> Outcome<f64> {
        match value {
            Value::Number(n) => Ok(n),
            _ => self.number_of(value, span),
        }
    }

    /// The number of a parameter. Kept apart, so that a written number costs no call.
    #[inline(never)]
    fn number_of(&self, value: Value, span: Span) -> Outcome<f64> {
        match value {
            Value::Number(n) => Ok(n),
            Value::Param { negative, q } => {
                let n = self.parameter(q, span)?;
                Ok(if negative { -n } else { n })
            }
            Value::None | Value::FeedMax | Value::FeedAuto => {
                let word = self.core.word_text(span);
                self.core.refuse(span, codes::P1004::has_no_number_so_write_number(&word))
            }
        }
    }

    /// A number where one is written, else `None`.
    pub fn number_if(&self, value: Value, span: Span) -> Outcome<Option<f64>> {
        match value {
            Value::None => Ok(None),
            value => self.number(value, span).map(Some),
        }
    }

    /// Value of a number parameter.
    pub fn parameter(&self, q: QRef, span: Span) -> Outcome<f64> {
        match self.read(q, span)? {
            Val::Real(n) => Ok(n),
            _ => self.core.refuse(span, codes::P2024::holds_text(&q)),
        }
    }

    pub fn read(&self, q: QRef, span: Span) -> Outcome<Val> {
        if !exists(q) {
            return self.core.refuse(span, codes::P2025::does_not_exist(&q));
        }
        if q.kind == QKind::Q
            && (100..200).contains(&q.number)
            && let Some(value) = self.control_value(q.number, span)?
        {
            self.says_unused(q, value, span);
            return Ok(Val::Real(value));
        }
        match self.vars.get(self.core.locals(), q) {
            Some(Slot::Number(n)) => Ok(Val::Real(*n)),
            Some(Slot::Text(text)) => Ok(Val::Text(Rc::clone(text))),
            Some(Slot::Lost) => Err(Reported),
            Some(&Slot::AtMachine(set)) => {
                let fault = codes::P2023::is_set_by_control_at_machine_and_nothing(&q);
                self.core.report(fault.at(self.core.loc(span)).also(set, Also::SetHere));
                Err(Reported)
            }
            None => self.undefined(q, span),
        }
    }

    /// What the program and `[tools]` determine goes before a value of `[variables]`.
    fn says_unused(&self, q: QRef, taken: f64, span: Span) {
        let variables = &self.core.job.settings.variables;
        if variables.is_empty() {
            return;
        }
        let key = q.to_string();
        let Some(given) = variables.get(&key).filter(|given| **given != taken) else { return };
        self.core.say_once(span, codes::K2415::of_variables_is_not_used(&key, &given, &taken));
    }

    fn undefined(&self, q: QRef, span: Span) -> Outcome<Val> {
        if q.kind == QKind::Q && (100..200).contains(&q.number) {
            let meaning = meanings::of_parameter(q.number);
            let what = if meaning.is_empty() { String::new() } else { format!(": {meaning}") };
            let fault = codes::P2023::is_set_by_control_at_machine(&q, &what);
            return self.core.refuse(span, fault.answer(Answer::variable(q, meaning)));
        }
        if q.is_text() {
            return self.core.refuse(span, codes::P2020::is_read_before_text_is_assigned(&q));
        }
        if self.core.job.settings.control.klartext > Generation::Tnc426 {
            return self
                .core
                .refuse(span, codes::P2020::is_read_before_value_is_assigned(&q).answer(Answer::key("variables", q)));
        }
        self.core.say(span, codes::P2021::was_never_set(&q));
        Ok(Val::Real(0.0))
    }

    /// Q100 to Q199, as far as the compiler knows them.
    fn control_value(&self, number: u32, span: Span) -> Outcome<Option<f64>> {
        let mm = self.core.mm();
        Ok(match number {
            RADIUS => match self.st.tool.active().and_then(|tool| tool.effective_radius()) {
                Some(radius) => Some(radius / mm),
                None => return self.tool_data_missing(RADIUS, span).map(Some),
            },
            109 => Some(self.st.tool.axis().map_or(-1.0, |axis| axis.index() as f64)),
            110 => Some(match (self.st.spindle.turn(), self.st.spindle.used()) {
                (Some(Turn::Clockwise), _) => 0.0,
                (Some(Turn::CounterClockwise), _) => 1.0,
                (None, Some(Turn::Clockwise)) => 2.0,
                (None, Some(Turn::CounterClockwise)) => 3.0,
                (None, None) => -1.0,
            }),
            111 => Some(f64::from(u8::from(self.st.spindle.coolant()))),
            113 => Some(match self.core.levels[0].frame.unit {
                Unit::Mm => 0.0,
                Unit::Inch => 1.0,
            }),
            LENGTH => match self.st.tool.active().and_then(|tool| tool.length) {
                Some(length) => Some(length / mm),
                None => return self.tool_data_missing(LENGTH, span).map(Some),
            },
            _ => None,
        })
    }

    /// Radius or length of the tool, which `q` holds, is needed and not known; a configured start value helps out.
    fn tool_data_missing(&self, number: u32, span: Span) -> Outcome<f64> {
        let q = QRef { kind: QKind::Q, number };
        if let Some(Slot::Number(value)) = self.vars.get(self.core.locals(), q) {
            return Ok(*value);
        }
        let is_radius = number == RADIUS;
        let asking = match (self.st.tool.active(), is_radius) {
            (Some(tool), true) => codes::P2004::radius_of_tool_is_not_known(&tool.called),
            (Some(tool), false) => codes::P2005::length_of_tool_is_not_known(&tool.called),
            (None, true) => codes::P2004::no_tool_is_called_so_it_has_no_value(&q),
            (None, false) => codes::P2005::no_tool_is_called_so_it_has_no_value(&q),
        };
        let answer = match self.st.tool.active() {
            Some(tool) => Answer::tool(&tool.called, if is_radius { "radius" } else { "length" }),
            None => Answer::variable(q, meanings::of_parameter(number)),
        };
        self.core.refuse(span, asking.answer(answer))
    }

    /// `+0`, `-12,5`, `+Q1`, `-QL5`: its value, `None` where `text` is neither a number nor a parameter.
    pub fn written(&self, text: &str, span: Span) -> Option<Outcome<f64>> {
        if let Some(number) = signed_number(text) {
            return Some(Ok(number));
        }
        let (negative, name) = match text.strip_prefix('-') {
            Some(name) => (true, name),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let q = named(name).filter(|q| !q.is_text())?;
        Some(self.parameter(q, span).map(|value| if negative { -value } else { value }))
    }

    /// Does the condition of FN 9 to 12 hold?
    pub fn holds(&self, test: Test, text: &[u8]) -> Outcome<bool> {
        let whole = Span::at(0, 0);
        Ok(match test {
            Test::Defined { q, defined } => {
                if !exists(q) {
                    return self.core.refuse(whole, codes::P2025::does_not_exist(&q));
                }
                self.vars.get(self.core.locals(), q).is_some() == defined
            }
            Test::Compare { relation, left, right } => {
                let (a, b) = (self.operand(left, text)?, self.operand(right, text)?);
                if let (Val::Real(a), Val::Real(b)) = (&a, &b)
                    && a != b
                    && (a - b).abs() < ROUNDING
                {
                    self.core.say_here(codes::K2810::two_values_of_this_jump_differ());
                }
                match (&a, &b) {
                    (Val::Real(a), Val::Real(b)) => match relation {
                        Relation::Equal => a == b,
                        Relation::NotEqual => a != b,
                        Relation::Greater => a > b,
                        Relation::Less => a < b,
                    },
                    (Val::Text(a), Val::Text(b)) if relation == Relation::Equal => a == b,
                    (Val::Text(a), Val::Text(b)) if relation == Relation::NotEqual => a != b,
                    _ => {
                        return self.core.refuse(Where::Block, codes::P2024::comparison_mixes_text());
                    }
                }
            }
        })
    }

    fn operand(&self, operand: Operand, text: &[u8]) -> Outcome<Val> {
        let span = self.core.block_span();
        Ok(match operand {
            Operand::Number(n) => Val::Real(n),
            Operand::Text(span) => Val::text(readable(span.of(text)).as_bytes()),
            Operand::Param { negative, q } => match self.read(q, span)? {
                Val::Real(n) => Val::Real(if negative { -n } else { n }),
                text => text,
            },
        })
    }

    // Names.

    /// The label that a block names.
    pub fn label(&self, label: LabelRef, text: &[u8]) -> Outcome<Label> {
        let LabelRef::Param(q) = label else {
            return Label::written(label, text).ok_or(Reported);
        };
        let span = self.core.block_span();
        match self.read(q, span)? {
            Val::Text(name) => Ok(Label::Name(String::from_utf8_lossy(&name).into())),
            Val::Real(n) if n.fract() == 0.0 && (0.0..=65535.0).contains(&n) => Ok(Label::Number(n as u32)),
            other => {
                let n = other.number().unwrap_or_default();
                self.core.refuse(span, codes::P2011::is_no_label_number(&q, &n))
            }
        }
    }

    /// The name as written: bare, in quotes, or in a text parameter.
    pub fn program_name(&self, name: &[u8]) -> Outcome<String> {
        let name = readable(name.trim_ascii()).into_owned();
        if let Some(digits) = name.strip_prefix("QS").or_else(|| name.strip_prefix("qs"))
            && let Ok(number) = digits.parse()
        {
            let span = self.core.block_span();
            return match self.read(QRef { kind: QKind::Qs, number }, span)? {
                Val::Text(text) => Ok(String::from_utf8_lossy(&text).into_owned()),
                _ => self.core.refuse(span, codes::P2024::text_parameter_is_needed()),
            };
        }
        let name = name.trim_matches('"').trim().to_owned();
        if name.is_empty() {
            return self.core.refuse(Where::Block, codes::P1004::name_of_program_is_missing());
        }
        Ok(name)
    }
}

/// `+0`, `-12,5`, `40`.
pub(super) fn signed_number(text: &str) -> Option<f64> {
    let (sign, digits) = match text.as_bytes() {
        [b'-', digits @ ..] => (-1.0, digits),
        [b'+', digits @ ..] => (1.0, digits),
        digits => (1.0, digits),
    };
    let (number, len) = decimal(digits, true)?;
    (len == digits.len()).then_some(sign * number)
}
