//! Parameters and formulas: reading, computing, assigning, conditional jumps.

use std::rc::Rc;

use crate::diag::{Answer, Label, codes};
use crate::ir::function::Turn;
use crate::lexer::klartext::{QKind, QRef, Value};
use crate::machine::{Axis, Generation, Settings, Unit};
use crate::parser::klartext::ast::{Block, Function, LabelRef, Op, Operand, Operator, Relation, Test, TextFn};
use crate::sema::value::{At, Divisor, Fault, Formulas, Machine, Modulo, Never, Rules, SetBy, Stop, evaluate, noun};
use crate::text::{Span, decode::readable};

use super::flow::{FrameKind, innermost_locals};
use super::meanings;
use super::text_functions;
use super::vars::{Slot, Val, exists};
use super::{Outcome, Reported, Run};

/// Largest value a parameter holds.
const LARGEST: f64 = 1e10;

/// The parameters of radius and length of the tool.
const RADIUS: u32 = 108;
const LENGTH: u32 = 114;

/// Values that differ by less may differ by the rounding of what they were computed from.
const ROUNDING: f64 = 1e-9;

/// How this control computes.
pub(super) fn rules(settings: &Settings) -> Rules {
    let control = &settings.control;
    Rules {
        step: LARGEST,
        result: LARGEST,
        // The sign of 0 is +1 on the older controls.
        sign_of_zero: if control.klartext >= Generation::Tnc7 { 0.0 } else { 1.0 },
        modulo: match control.modulo {
            crate::machine::Modulo::Truncate => Modulo::Truncate,
            crate::machine::Modulo::Floor => Modulo::Floor,
            crate::machine::Modulo::Refuse => Modulo::Positive,
        },
        ..Rules::USUAL
    }
}

impl Formulas for Run<'_> {
    type Op = Op;
    type Axis = Never;
    type Frame = Never;

    fn machine(&mut self) -> &mut Machine {
        &mut self.machine
    }

    fn operation(&mut self, op: &Op, machine: &mut Machine, at: At<'_>) -> Result<Val, Stop> {
        Ok(match *op {
            Op::Number(n) => Val::Real(n),
            Op::Param(q) => self.read(q, at.span)?,
            Op::Text(span) => Val::text(readable(span.of(at.text)).as_bytes()),
            Op::Unary(f) => machine.unary(f)?,
            Op::Binary(f) => machine.binary(f)?,
            Op::TextFn(TextFn::Unknown) => {
                return Ok(self.core.refuse(at.span, codes::K9017::this_string_function_reads_from_control())?);
            }
            Op::TextFn(f) => text_functions::apply(f, machine)?,
            Op::Join => text_functions::join(machine)?,
            Op::DoubtfulPower(span) => {
                self.warn_of_power(span);
                machine.pop()?
            }
        })
    }

    fn divisor(&self, operand: &[Op], _: At<'_>) -> Option<Divisor> {
        let ([.., Op::Param(q)] | [.., Op::Param(q), Op::Unary(Function::Negate)]) = *operand else { return None };
        let name = q.to_string();
        let own = (q.kind == QKind::Ql).then_some(self.core.here.origin.call);
        let set = SetBy::of(&self.core.job, &name, own);
        let nobody = if self.vars.get(self.locals(), q).is_none() { SetBy::Nobody } else { SetBy::Unknown };
        Some(Divisor { set: set.unwrap_or(nobody), name })
    }

    fn fault(&self, fault: Fault, at: At<'_>) -> Reported {
        let found = match fault {
            Fault::Domain(f, x) | Fault::Open(f, x) => codes::P2022::function_of_value_does_not_exist(&noun(f), &x),
            Fault::OpenBetween(_, a, b) => {
                codes::K2310::sign_of_result_is_not_documented(&a, &b).answer(Answer::key("control", "modulo"))
            }
            Fault::Outside(Operator::Power, a, b) => codes::P2022::power_does_not_exist(&a, &b),
            Fault::Outside(_, a, b) => codes::P2022::there_is_no_result(&a, &b),
            Fault::Zero(a) => codes::P2022::value_is_divided_by_zero(&a),
            Fault::ZeroBy(a, by) => {
                codes::P2022::value_is_divided_by_zero_that(&a, &by.said(&self.core.job, self.core.here.origin.loc))
            }
            Fault::TooLarge | Fault::TooLargeInt => codes::P2022::result_is_over_10_000_000_000(),
            Fault::Misfit(_) | Fault::Mismatch(..) => codes::P2022::number_is_needed_not_text(),
            Fault::Missing => codes::P1004::value_is_missing(),
            Fault::Said(found) => *found,
        };
        self.core.say(at.span, found);
        Reported
    }
}

impl Run<'_> {
    /// The number that stands behind an address.
    #[inline]
    pub(super) fn number(&mut self, value: Value, span: Span) -> Outcome<f64> {
        match value {
            Value::Number(n) => Ok(n),
            _ => self.number_of(value, span),
        }
    }

    /// The number of a parameter. Kept apart, so that a written number costs no call.
    #[inline(never)]
    fn number_of(&mut self, value: Value, span: Span) -> Outcome<f64> {
        match value {
            Value::Number(n) => Ok(n),
            Value::Param { negative, q } => {
                let n = self.parameter(q, span)?;
                Ok(if negative { -n } else { n })
            }
            Value::None | Value::FeedMax | Value::FeedAuto => {
                let word = self.word_text(span);
                self.core.refuse(span, codes::P1004::has_no_number_so_write_number(&word))
            }
        }
    }

    /// A number where one is written, else `None`.
    pub(super) fn number_if(&mut self, value: Value, span: Span) -> Outcome<Option<f64>> {
        match value {
            Value::None => Ok(None),
            value => self.number(value, span).map(Some),
        }
    }

    /// Value of a number parameter.
    pub(super) fn parameter(&mut self, q: QRef, span: Span) -> Outcome<f64> {
        match self.read(q, span)? {
            Val::Real(n) => Ok(n),
            _ => self.core.refuse(span, codes::P2024::holds_text(&q)),
        }
    }

    pub(super) fn read(&mut self, q: QRef, span: Span) -> Outcome<Val> {
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
        match self.vars.get(self.locals(), q) {
            Some(Slot::Number(n)) => Ok(Val::Real(*n)),
            Some(Slot::Text(text)) => Ok(Val::Text(Rc::clone(text))),
            Some(Slot::Lost) => Err(Reported),
            Some(&Slot::AtMachine(set)) => {
                self.core.report(
                    codes::P2023::is_set_by_control_at_machine_and_nothing(&q)
                        .at(self.core.loc(span))
                        .also(set, Label::SetHere),
                );
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
        self.core.report_once(codes::K2415::of_variables_is_not_used(&key, &given, &taken).at(self.core.loc(span)));
    }

    fn undefined(&mut self, q: QRef, span: Span) -> Outcome<Val> {
        if q.kind == QKind::Q && (100..200).contains(&q.number) {
            let meaning = meanings::of_parameter(q.number);
            let what = if meaning.is_empty() { String::new() } else { format!(": {meaning}") };
            return self.core.refuse(
                span,
                codes::P2023::is_set_by_control_at_machine(&q, &what).answer(Answer::variable(q, meaning)),
            );
        }
        if q.is_text() {
            return self.core.refuse(span, codes::P2020::is_read_before_text_is_assigned(&q));
        }
        if self.core.job.settings.control.klartext > Generation::Tnc426 {
            return self
                .core
                .refuse(span, codes::P2020::is_read_before_value_is_assigned(&q).answer(Answer::key("variables", q)));
        }
        self.core.report(codes::P2021::was_never_set(&q).at(self.core.loc(span)));
        Ok(Val::Real(0.0))
    }

    /// Q100 to Q199, as far as the compiler knows them.
    fn control_value(&mut self, number: u32, span: Span) -> Outcome<Option<f64>> {
        let mm = self.core.level().frame.unit.mm();
        Ok(match number {
            RADIUS => match self.st.tool.active().and_then(|tool| tool.effective_radius()) {
                Some(radius) => Some(radius / mm),
                None => return self.tool_data_missing(RADIUS, span).map(Some),
            },
            109 => Some(match self.st.tool.axis() {
                None => -1.0,
                Some(Axis::X) => 0.0,
                Some(Axis::Y) => 1.0,
                Some(Axis::Z) => 2.0,
                Some(Axis::U) => 6.0,
                Some(Axis::V) => 7.0,
                _ => 8.0,
            }),
            110 => Some(match (self.st.spindle.turn(), self.st.spindle.used()) {
                (Some(Turn::Clockwise), _) => 0.0,
                (Some(Turn::CounterClockwise), _) => 1.0,
                (None, Some(Turn::Clockwise)) => 2.0,
                (None, Some(Turn::CounterClockwise)) => 3.0,
                (None, None) => -1.0,
            }),
            111 => Some(f64::from(u8::from(self.st.coolant))),
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
        if let Some(Slot::Number(value)) = self.vars.get(self.locals(), q) {
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

    /// Computes the formula of the block.
    fn formula(&mut self, block: &Block, text: &[u8]) -> Outcome<Val> {
        evaluate(self, &block.ops, At { span: block.span, text })
    }

    fn warn_of_power(&self, span: Span) {
        if self.core.job.settings.control.klartext < Generation::Tnc7 {
            self.core.report(codes::K2306::older_controls_may_compute_this_power_differently().at(self.core.loc(span)));
        }
    }

    /// `Q1 = …` and FN 0 to 8, 13.
    pub(super) fn assign(&mut self, q: QRef, block: &Block, text: &[u8]) -> Outcome {
        let value = self.formula(block, text).and_then(|value| match value {
            Val::Real(n) => Ok(Slot::Number(n)),
            _ => self.core.refuse(block.span, codes::P2024::takes_number(&q)),
        });
        if block.number.is_none()
            && let Ok(Slot::Number(n)) = value
        {
            self.note_cycle_parameter(q, n, block.span)?;
        }
        self.set(q, value.unwrap_or(Slot::Lost), block.span)
    }

    pub(super) fn assign_text(&mut self, q: QRef, block: &Block, text: &[u8]) -> Outcome {
        let value = self.formula(block, text).and_then(|value| match value {
            Val::Text(text) => Ok(Slot::Text(text)),
            _ => self.core.refuse(block.span, codes::P2024::takes_text(&q)),
        });
        self.set(q, value.unwrap_or(Slot::Lost), block.span)
    }

    pub(super) fn set(&mut self, q: QRef, value: Slot, span: Span) -> Outcome {
        if !exists(q) {
            return self.core.refuse(span, codes::P2025::does_not_exist(&q));
        }
        if q.kind == QKind::Q && (100..200).contains(&q.number) {
            self.core.report(codes::K2305::belongs_to_control(&q).at(self.core.loc(span)));
        }
        let locals = innermost_locals(&mut self.core.levels);
        let locals = locals.expect("the main level has locals");
        if let Slot::Number(number) = value {
            let origin = self.core.here.origin;
            self.core.job.trail.assigns(origin.loc, origin.call, || q.to_string(), number);
        }
        self.vars.set(locals, q, value);
        Ok(())
    }

    /// The block `text` would have set a parameter and was refused: its value is lost, not undefined.
    pub(super) fn lose_target(&mut self, text: &[u8]) {
        let Some(q) = assigned(text) else { return };
        if exists(q)
            && let Some(locals) = innermost_locals(&mut self.core.levels)
        {
            self.vars.set(locals, q, Slot::Lost);
        }
    }

    /// FN 9 to 12.
    pub(super) fn jump_if(&mut self, test: Test, target: LabelRef, text: &[u8]) -> Outcome {
        let whole = Span::at(0, 0);
        let taken = match test {
            Test::Defined { q, defined } => {
                if !exists(q) {
                    return self.core.refuse(whole, codes::P2025::does_not_exist(&q));
                }
                self.vars.get(self.locals(), q).is_some() == defined
            }
            Test::Compare { relation, left, right } => {
                let (a, b) = (self.operand(left, text)?, self.operand(right, text)?);
                if let (Val::Real(a), Val::Real(b)) = (&a, &b)
                    && a != b
                    && (a - b).abs() < ROUNDING
                {
                    self.decided_by_rounding();
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
                        self.core.say_here(codes::P2024::comparison_mixes_text());
                        return Err(Reported);
                    }
                }
            }
        };
        if taken { self.jump(target, text) } else { Ok(()) }
    }

    #[cold]
    fn decided_by_rounding(&self) {
        self.core.report(codes::K2810::two_values_of_this_jump_differ().at(self.core.here.origin.loc));
    }

    fn operand(&mut self, operand: Operand, text: &[u8]) -> Outcome<Val> {
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

    /// FN 37: EXPORT copies a local parameter to the caller.
    pub(super) fn export(&mut self, number: u32) -> Outcome {
        let q = QRef { kind: QKind::Ql, number };
        let value = match self.vars.get(self.locals(), q) {
            Some(value) => value.clone(),
            None => {
                self.core.say_here(codes::P2020::has_no_value_to_export(&q));
                return Err(Reported);
            }
        };
        let inner = self.core.levels.iter().rposition(|level| level.frame.kind == FrameKind::Program);
        let outer = inner.and_then(|at| innermost_locals(&mut self.core.levels[..at]));
        if let Some(locals) = outer {
            locals.insert(number, value);
        }
        Ok(())
    }
}

/// The parameter in front of the first `=`: `Q1 = …`, `FN 1: Q1 = …`, `TABREAD Q10 = …`.
fn assigned(text: &[u8]) -> Option<QRef> {
    let front = text.split(|b| *b == b'=').next().filter(|front| front.len() < text.len())?;
    let word = front.trim_ascii_end().rsplit(|b| b.is_ascii_whitespace() || *b == b':').next()?;
    let name = word.to_ascii_uppercase();
    let (kind, digits) = match name.as_slice() {
        [b'Q', b'L', digits @ ..] => (QKind::Ql, digits),
        [b'Q', b'R', digits @ ..] => (QKind::Qr, digits),
        [b'Q', b'S', digits @ ..] => (QKind::Qs, digits),
        [b'Q', digits @ ..] => (QKind::Q, digits),
        _ => return None,
    };
    let number = std::str::from_utf8(digits).ok()?.parse().ok()?;
    Some(QRef { kind, number })
}
