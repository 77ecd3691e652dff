//! Variables and formulas: reading, computing, assigning.

use crate::diag::{Answer, codes};
use crate::lexer::formula::Function;
use crate::lexer::turning::{VarKind, VarRef};
use crate::parser::turning::ast::{Block, Formula, Op};
use crate::sema::value::{At, Divisor, Fault, Formulas, Machine, Never, SetBy, Stop, Val, evaluate, noun};
use crate::text::Span;

use super::vars::Vars;
use super::{Core, Outcome, Reported};

/// Variables and program flow: what formulas are computed with, and which block runs next.
pub(super) struct Computing<'r, 'a> {
    pub core: &'r mut Core<'a>,
    pub vars: &'r mut Vars,
}

impl Formulas for Computing<'_, '_> {
    type Op = Op;
    type Axis = Never;
    type Frame = Never;

    fn machine(&mut self) -> &mut Machine {
        &mut self.vars.machine
    }

    fn operation(&mut self, op: &Op, machine: &mut Machine, _: At<'_>) -> Result<Val, Stop> {
        Ok(match *op {
            Op::Number(n) => Val::Real(n),
            Op::Var(var, span) => Val::Real(self.variable(var, span)?),
            Op::Unary(f) => machine.unary(f)?,
            Op::Binary(f) => machine.binary(f)?,
        })
    }

    fn divisor(&self, operand: &[Op], _: At<'_>) -> Option<Divisor> {
        let ([.., Op::Var(var, _)] | [.., Op::Var(var, _), Op::Unary(Function::Negate)]) = *operand else {
            return None;
        };
        let own = matches!(var.kind, VarKind::Local | VarKind::Argument).then_some(self.core.here.origin.call);
        let name = var.to_string();
        Some(Divisor { set: SetBy::of(&self.core.job, &name, own).unwrap_or(SetBy::Unknown), name })
    }

    fn fault(&self, fault: Fault, at: At<'_>) -> Reported {
        let found = match fault {
            Fault::Domain(f, x) | Fault::Open(f, x) => codes::P2022::function_has_no_value(&noun(f), &x),
            Fault::Outside(_, a, b) => codes::P2022::root_of_difference_of_squares(&a, &b),
            Fault::Zero(a) => codes::P2022::value_is_divided_by_zero(&a),
            Fault::ZeroBy(a, by) => {
                codes::P2022::value_is_divided_by_zero_that(&a, &by.said(&self.core.job, self.core.here.origin.loc))
            }
            Fault::Missing => codes::P1001::value_is_missing_in_formula(),
            Fault::TooLarge
            | Fault::TooLargeInt
            | Fault::OpenBetween(..)
            | Fault::Misfit(_)
            | Fault::Mismatch(..)
            | Fault::Said(_) => codes::P2022::result_is_too_large(),
        };
        self.core.say(at.span, found);
        Reported
    }
}

impl Computing<'_, '_> {
    /// Computes a formula of the block.
    pub(super) fn formula(&mut self, block: &Block, formula: Formula) -> Outcome<f64> {
        let value = evaluate(self, block.formula(formula), At { span: formula.span, text: b"" })?;
        value.number().ok_or(Reported)
    }

    /// Value of a variable.
    fn variable(&mut self, var: VarRef, span: Span) -> Outcome<f64> {
        let here = self.core.level().frame.number;
        match var.kind {
            VarKind::Local | VarKind::Argument => {
                let start = self.vars.get(var).and_then(|slot| slot.value);
                match (self.core.level().frame.locals.get(&var).copied(), start) {
                    (Some(Some(value)), _) | (None, Some(value)) => Ok(value),
                    (Some(None), _) => Err(Reported),
                    (None, None) => self.unset(var, span),
                }
            }
            _ => match self.vars.get(var) {
                Some(slot) if var.kind == VarKind::Hash && slot.level != 0 && slot.level != here => {
                    self.core.refuse(span, codes::T2014::was_assigned_in_another_program_than_one(&var))
                }
                Some(slot) => slot.value.ok_or(Reported),
                None => self.unset(var, span),
            },
        }
    }

    fn unset<T>(&self, var: VarRef, span: Span) -> Outcome<T> {
        let key = var.to_string().to_ascii_uppercase();
        let asking = match var.kind {
            VarKind::Machine | VarKind::Interpreter => codes::P2023::is_set_by_control_so_give(&var, &key),
            VarKind::Real if var.number > 900 => codes::P2023::holds_what_control_measured(&var, &key),
            VarKind::Argument => return self.core.refuse(span, codes::P2020::call_gives_no_value(&var)),
            _ => codes::P2020::is_read_before_value_so_assign_value(&var, &key),
        };
        self.core.refuse(span, asking.answer(Answer::key("variables", &key)))
    }

    /// `#1=…`
    pub(super) fn assign(&mut self, var: VarRef, block: &Block, formula: Formula) -> Outcome {
        let value = self.formula(block, formula);
        if let Ok(number) = value {
            let origin = self.core.here.origin;
            self.core.job.trail.assigns(origin.loc, origin.call, || var.to_string(), number);
        }
        match var.kind {
            VarKind::Machine | VarKind::Interpreter => {
                return self.core.refuse(block.span, codes::P2023::belongs_to_control(&var));
            }
            VarKind::Local | VarKind::Argument => {
                self.core.level().frame.locals.insert(var, value.ok());
            }
            _ => {
                let level = self.core.level().frame.number;
                self.vars.set(var, value.ok(), level);
            }
        }
        value.map(|_| ())
    }
}
