//! Formulas: how this control computes, and what a parameter takes of it.

use crate::diag::{Answer, codes};
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::{Generation, Settings};
use crate::parser::klartext::ast::{Block, Function, Op, Operator, Stmt, TextFn};
use crate::sema::value::{At, Divisor, Fault, Formulas, Machine, Modulo, Never, Rules, SetBy, Stop, evaluate, noun};
use crate::text::decode::readable;

use super::reading::Reading;
use super::text_functions;
use super::vars::{Slot, Val};
use super::{Outcome, Reported, Run};

/// Largest value a parameter holds.
const LARGEST: f64 = 1e10;

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

/// A formula while it is computed.
struct Formula<'f, 'a> {
    reading: Reading<'f, 'a>,
    machine: &'f mut Machine,
}

impl Formulas for Formula<'_, '_> {
    type Op = Op;
    type Axis = Never;
    type Frame = Never;

    fn machine(&mut self) -> &mut Machine {
        self.machine
    }

    fn operation(&mut self, op: &Op, machine: &mut Machine, at: At<'_>) -> Result<Val, Stop> {
        Ok(match *op {
            Op::Number(n) => Val::Real(n),
            Op::Param(q) => self.reading.read(q, at.span)?,
            Op::Text(span) => Val::text(readable(span.of(at.text)).as_bytes()),
            Op::Unary(f) => machine.unary(f)?,
            Op::Binary(f) => machine.binary(f)?,
            Op::TextFn(TextFn::Unknown) => {
                return Ok(self
                    .reading
                    .core
                    .refuse(at.span, codes::K9017::this_string_function_reads_from_control())?);
            }
            Op::TextFn(f) => text_functions::apply(f, machine)?,
            Op::Join => text_functions::join(machine)?,
            Op::DoubtfulPower(span) => {
                if self.reading.core.job.settings.control.klartext < Generation::Tnc7 {
                    self.reading.core.say(span, codes::K2306::older_controls_may_compute_this_power_differently());
                }
                machine.pop()?
            }
        })
    }

    fn divisor(&self, operand: &[Op], _: At<'_>) -> Option<Divisor> {
        let ([.., Op::Param(q)] | [.., Op::Param(q), Op::Unary(Function::Negate)]) = *operand else { return None };
        let name = q.to_string();
        let own = (q.kind == QKind::Ql).then_some(self.reading.core.here.origin.call);
        let set = SetBy::of(&self.reading.core.job, &name, own);
        let nobody =
            if self.reading.vars.get(self.reading.core.locals(), q).is_none() { SetBy::Nobody } else { SetBy::Unknown };
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
            Fault::ZeroBy(a, by) => codes::P2022::value_is_divided_by_zero_that(
                &a,
                &by.said(&self.reading.core.job, self.reading.core.here.origin.loc),
            ),
            Fault::TooLarge | Fault::TooLargeInt => codes::P2022::result_is_over_10_000_000_000(),
            Fault::Misfit(_) | Fault::Mismatch(..) => codes::P2022::number_is_needed_not_text(),
            Fault::Missing => codes::P1004::value_is_missing(),
            Fault::Said(found) => found,
        };
        self.reading.core.say(at.span, found);
        Reported
    }
}

impl Run<'_> {
    /// `Q1 = …` and FN 0 to 8, 13; a text for QS. What fails leaves the parameter without a value, not undefined.
    pub(super) fn assign(&mut self, q: QRef, block: &Block, text: &[u8]) -> Outcome {
        let reading = Reading { core: &self.core, vars: &self.vars, st: &self.st };
        let value =
            evaluate(&mut Formula { reading, machine: &mut self.machine }, &block.ops, At { span: block.span, text });
        let value = value.and_then(|value| match (value, block.stmt) {
            (Val::Text(text), Stmt::AssignText(_)) => Ok(Slot::Text(text)),
            (_, Stmt::AssignText(_)) => self.core.refuse(block.span, codes::P2024::takes_text(&q)),
            (Val::Real(n), _) => Ok(Slot::Number(n)),
            _ => self.core.refuse(block.span, codes::P2024::takes_number(&q)),
        });
        if block.number.is_none()
            && let Ok(Slot::Number(n)) = value
        {
            self.cycles.note_parameter(&self.core, q, n, block.span)?;
        }
        self.vars.assign(&mut self.core, q, value.unwrap_or(Slot::Lost), block.span)
    }
}
