//! NC variables and formulas.
//!
//! Source: M 3 (docs/sources.md). Values are plain numbers; unit and diameter come with the word that uses them.

use crate::diag::{Answer, codes};
use crate::lexer::formula::{Function, Operator};
use crate::machine::Settings;
use crate::machine::options::mtc200::Reading;
use crate::parser::mtc200::ast::{Block, Formula, Op, Target, Value, Word};
use crate::sema::value::{At, Divisor, Fault, Formulas, Machine, Modulo, Never, Rules, SetBy, Stop, Val, evaluate};
use crate::text::Span;

use super::{Core, Outcome, Reported};

/// Variables have three digits.
const VARIABLES: usize = 1000;

/// Results nearer to zero than this, and not zero, come from rounding.
const NEAR_ZERO: f64 = 1e-9;

/// Largest number of a word or formula.
const LARGEST: f64 = 1e12;

fn rules(radians: bool) -> Rules {
    Rules { result: LARGEST, radians, cuts_negative: false, modulo: Modulo::Whole, ..Rules::USUAL }
}

/// What a branch asks of the last result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Condition {
    Always,
    Zero,
    NotZero,
    NotNegative,
    Negative,
}

/// The NC variables, and the result of the last assignment, which branches look at.
#[derive(Debug)]
pub(super) struct Variables {
    values: Vec<Option<Outcome<f64>>>,
    result: Option<f64>,
    machine: Machine,
}

impl Variables {
    /// Variables with their start values: `@50` and `@050` are the same.
    pub fn new(settings: &Settings) -> Variables {
        let mut values = vec![None; VARIABLES];
        for (name, value) in &settings.variables {
            let number = name.strip_prefix('@').and_then(|digits| digits.parse::<usize>().ok());
            if let Some(slot) = number.and_then(|number| values.get_mut(number)) {
                *slot = Some(Ok(*value));
            }
        }
        Variables { values, result: None, machine: Machine::new(rules(settings.control.mtc200.radians)) }
    }

    /// Does the last result fulfil the condition?
    pub fn fulfil(&self, condition: Condition) -> Result<bool, crate::diag::Fault> {
        if condition == Condition::Always {
            return Ok(true);
        }
        let Some(result) = self.result else {
            return Err(codes::M2204::no_result_was_calculated_before_this_branch());
        };
        if result != 0.0 && result.abs() < NEAR_ZERO {
            return Err(codes::M2205::last_result_is_nearly_zero(&format_args!("{result:.1e}")));
        }
        Ok(match condition {
            Condition::Always => true,
            Condition::Zero => result == 0.0,
            Condition::NotZero => result != 0.0,
            Condition::NotNegative => result >= 0.0,
            Condition::Negative => result < 0.0,
        })
    }
}

/// Computes what the words of a block say.
pub(super) struct Computing<'r, 'a> {
    pub core: &'r Core<'a>,
    pub variables: &'r mut Variables,
}

impl Formulas for Computing<'_, '_> {
    type Op = Op;
    type Axis = Never;
    type Frame = Never;

    fn machine(&mut self) -> &mut Machine {
        &mut self.variables.machine
    }

    fn operation(&mut self, op: &Op, machine: &mut Machine, at: At<'_>) -> Result<Val, Stop> {
        Ok(match *op {
            Op::Number(n) => Val::Real(n),
            Op::Variable(number, span) => Val::Real(self.variable(number, span)?),
            Op::Unary(f) => {
                use Function::{Acos, Asin, Atan, Cos, Sin, Tan};
                if matches!(f, Sin | Cos | Tan | Asin | Acos | Atan) {
                    self.core.reading(Reading::Degrees, at.span, codes::P8106::angles_count_in_degrees);
                }
                machine.unary(f)?
            }
            Op::Binary(f) => machine.binary(f)?,
        })
    }

    fn divisor(&self, operand: &[Op], _: At<'_>) -> Option<Divisor> {
        let ([.., Op::Variable(n, _)] | [.., Op::Variable(n, _), Op::Unary(Function::Negate)]) = *operand else {
            return None;
        };
        let set = SetBy::of(&self.core.job, &format!("@{n}"), None).unwrap_or(SetBy::Unknown);
        Some(Divisor { set, name: format!("@{n:03}") })
    }

    fn fault(&self, fault: Fault, at: At<'_>) -> Reported {
        let found = match fault {
            Fault::Open(f, x) => codes::M2304::result_of_function_depends_on_rounding(&name(f), &x),
            Fault::OpenBetween(f, a, b) => {
                let name = if f == Operator::Modulo { "MOD" } else { "DIV" };
                codes::M2304::result_of_two_depends_on_rounding(&a, &name, &b)
            }
            Fault::Domain(f, x) => codes::P2022::function_does_not_exist(&name(f), &x),
            Fault::Zero(_) => codes::P2022::formula_divides_by_zero(),
            Fault::ZeroBy(_, by) => {
                codes::P2022::formula_divides_by_zero_that(&by.said(&self.core.job, self.core.here.origin.loc))
            }
            Fault::Missing => codes::P1001::formula_is_empty(),
            Fault::TooLarge
            | Fault::TooLargeInt
            | Fault::Outside(..)
            | Fault::Misfit(_)
            | Fault::Mismatch(..)
            | Fault::Said(_) => codes::P2022::result_of_formula_is_too_large(),
        };
        self.core.say(at.span, found);
        Reported
    }
}

fn name(f: Function) -> &'static str {
    match f {
        Function::Int => "INT",
        Function::Sqrt => "SQRT",
        Function::Tan => "TAN",
        Function::Asin => "ASIN",
        Function::Acos => "ACOS",
        other => crate::sema::value::noun(other),
    }
}

impl Computing<'_, '_> {
    /// The number behind an address.
    #[inline]
    pub(super) fn number(&mut self, word: &Word, block: &Block) -> Outcome<f64> {
        match word.value {
            Value::Literal(n) if n.abs() <= LARGEST => Ok(n),
            Value::Literal(_) => self.core.refuse(word.span, codes::P2022::number_is_too_large()),
            Value::Formula(formula) => self.formula(formula, word.span, block),
            Value::None | Value::Label(_) => self.core.refuse(word.span, codes::M1003::word_has_no_value()),
        }
    }

    fn formula(&mut self, formula: Formula, span: Span, block: &Block) -> Outcome<f64> {
        let value = evaluate(self, block.formula(formula), At { span, text: b"" })?;
        value.number().ok_or(Reported)
    }

    fn variable(&mut self, number: u32, span: Span) -> Outcome<f64> {
        let Some(slot) = self.variables.values.get_mut(number as usize) else {
            return self.core.refuse(span, codes::P2025::there_is_no_variable(&number));
        };
        if let Some(value) = *slot {
            return value;
        }
        *slot = Some(Err(Reported));
        // Later uses are not worth another report.
        self.core
            .refuse(span, codes::P2020::was_never_set(&number).answer(Answer::key("variables", format!("@{number}"))))
    }

    /// A block that assigns variables; does nothing for other blocks.
    #[inline]
    pub(super) fn assignments(&mut self, block: &Block) -> Outcome<bool> {
        let is_assignment = |word: &Word| matches!(word.target, Target::Variable(_));
        if !block.words.first().is_some_and(is_assignment) || !block.words.iter().all(is_assignment) {
            return Ok(false);
        }
        for word in &block.words {
            let Target::Variable(variable) = word.target else { continue };
            let value = self.number(word, block);
            match self.variables.values.get_mut(variable as usize) {
                Some(slot) => {
                    if let Ok(number) = value {
                        let origin = self.core.here.origin;
                        self.core.job.trail.assigns(origin.loc, origin.call, || format!("@{variable}"), number);
                    }
                    *slot = Some(value);
                }
                None => return self.core.refuse(word.span, codes::P2025::there_is_no_variable(&variable)),
            }
            self.variables.result = Some(value?);
        }
        Ok(true)
    }
}
