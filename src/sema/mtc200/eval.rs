//! NC variables and formulas.
//!
//! Source: reference section 3. Values are plain numbers; unit and diameter come with the word that uses them.

use crate::diag::{Diagnostic, codes};
use crate::geo::Deg;
use crate::machine::options::mtc200::Reading;
use crate::parser::mtc200::ast::{Block, Formula, Func, Op, Target, Value, Word};
use crate::text::Span;

use super::{Outcome, Run};

/// Variables have three digits.
pub(super) const VARIABLES: usize = 1000;

/// Largest number of a word or formula.
const LARGEST: f64 = 1e12;

impl Run<'_> {
    /// The number behind an address.
    #[inline]
    pub(super) fn number(&mut self, word: &Word, block: &Block) -> Outcome<f64> {
        match word.value {
            Value::Literal(n) if n.abs() <= LARGEST => Ok(n),
            Value::Literal(_) => self.fail(codes::M2302, word.span, "the number is too large"),
            Value::Formula(formula) => self.formula(formula, word.span, block),
            Value::None | Value::Label(_) => self.fail(codes::M1003, word.span, "the word has no value"),
        }
    }

    fn formula(&mut self, formula: Formula, span: Span, block: &Block) -> Outcome<f64> {
        let mut stack = std::mem::take(&mut self.stack);
        stack.clear();
        let result = block.formula(formula).iter().try_for_each(|op| self.operation(*op, &mut stack, span));
        let value = stack.pop();
        self.stack = stack;
        result?;
        match value {
            Some(value) if value.abs() <= LARGEST => Ok(value),
            Some(_) => self.fail(codes::M2302, span, "the result of the formula is too large"),
            None => self.fail(codes::M1001, span, "the formula is empty"),
        }
    }

    fn operation(&mut self, op: Op, stack: &mut Vec<f64>, span: Span) -> Outcome {
        let value = match op {
            Op::Number(n) => n,
            Op::Variable(number, at) => self.variable(number, at)?,
            Op::Negate => -stack.pop().unwrap_or(0.0),
            Op::Call(func) => {
                let x = stack.pop().unwrap_or(0.0);
                self.call(func, x, span)?
            }
            Op::Add | Op::Subtract | Op::Multiply | Op::Divide | Op::Modulo | Op::WholeDivide => {
                let b = stack.pop().unwrap_or(0.0);
                let a = stack.pop().unwrap_or(0.0);
                self.binary(op, a, b, span)?
            }
        };
        stack.push(value);
        Ok(())
    }

    fn binary(&mut self, op: Op, a: f64, b: f64, span: Span) -> Outcome<f64> {
        let value = match op {
            Op::Add => a + b,
            Op::Subtract => a - b,
            Op::Multiply => a * b,
            _ if b == 0.0 => return self.fail(codes::M2302, span, "the formula divides by zero"),
            Op::Divide => a / b,
            _ if a < 0.0 || b < 0.0 || a.fract() != 0.0 || b.fract() != 0.0 => {
                let name = if op == Op::Modulo { "MOD" } else { "DIV" };
                let message = format!("the result of {a} {name} {b} depends on how the control rounds");
                return self.fail_help(codes::M2304, span, message, "use whole numbers of zero or more");
            }
            Op::Modulo => a % b,
            _ => (a / b).trunc(),
        };
        if value.is_finite() {
            return Ok(value);
        }
        self.fail(codes::M2302, span, "the result of the formula is too large")
    }

    fn call(&mut self, func: Func, x: f64, span: Span) -> Outcome<f64> {
        let radians = self.job.settings.control.mtc200.radians;
        let from_radians = |angle: f64| if radians { angle } else { Deg::from_radians(angle).0 };
        let sin_cos = || if radians { libm::sincos(x) } else { Deg(x).sin_cos() };
        let name = func.name();
        if matches!(func, Func::Sin | Func::Cos | Func::Tan | Func::Asin | Func::Acos | Func::Atan) {
            self.reading(Reading::Degrees, span, "angles in formulas count in degrees");
        }
        let value = match func {
            Func::Abs => x.abs(),
            Func::Int if x < 0.0 && x.fract() != 0.0 => {
                let message = format!("the result of INT({x}) depends on how the control rounds");
                return self.fail_help(codes::M2304, span, message, "make the value positive: -INT(-@050)");
            }
            Func::Int => x.trunc(),
            Func::Sqrt if x < 0.0 => return self.fail(codes::M2302, span, format!("SQRT({x}) does not exist")),
            Func::Sqrt => x.sqrt(),
            Func::Sin => sin_cos().0,
            Func::Cos => sin_cos().1,
            Func::Tan => {
                let (sin, cos) = sin_cos();
                if cos.abs() < 1e-12 {
                    return self.fail(codes::M2302, span, format!("TAN({x}) does not exist"));
                }
                sin / cos
            }
            Func::Asin | Func::Acos if x.abs() > 1.0 => {
                return self.fail(codes::M2302, span, format!("{name}({x}) does not exist"));
            }
            Func::Asin => from_radians(libm::asin(x)),
            Func::Acos => from_radians(libm::acos(x)),
            Func::Atan => from_radians(libm::atan(x)),
        };
        Ok(value)
    }

    fn variable(&mut self, number: u32, span: Span) -> Outcome<f64> {
        let Some(slot) = self.variables.get_mut(number as usize) else { return self.no_variable(number, span) };
        if let Some(value) = *slot {
            return Ok(value);
        }
        *slot = Some(0.0);
        // Later uses are not worth another report.
        self.report(
            Diagnostic::new(codes::M2301, self.loc(span), format!("@{number:03} was never set"))
                .help(format!("give its value in partc.toml: `[variables]` with `\"@{number}\" = …`")),
        );
        Ok(0.0)
    }

    fn no_variable<T>(&self, number: u32, span: Span) -> Outcome<T> {
        let message = format!("there is no variable @{number}");
        self.fail_help(codes::M2303, span, message, "variables are @000 to @999")
    }

    /// A block that assigns variables; does nothing for other blocks.
    pub(super) fn assignments(&mut self, block: &Block) -> Outcome<bool> {
        let is_assignment = |word: &Word| matches!(word.target, Target::Variable(_));
        if !block.words.first().is_some_and(is_assignment) || !block.words.iter().all(is_assignment) {
            return Ok(false);
        }
        for word in &block.words {
            let Target::Variable(number) = word.target else { continue };
            let value = self.number(word, block);
            match self.variables.get_mut(number as usize) {
                // A failed formula is reported; later uses of the variable are not worth another report.
                Some(slot) => *slot = Some(value.unwrap_or(0.0)),
                None => return self.no_variable(number, word.span),
            }
            self.result = Some(value?);
        }
        Ok(true)
    }
}
