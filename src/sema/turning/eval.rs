//! Variables and formulas: reading, computing, assigning.

use crate::diag::codes;
use crate::geo::Deg;
use crate::lexer::turning::{VarKind, VarRef};
use crate::parser::turning::ast::{Binary, Block, Formula, Op, Unary};
use crate::text::Span;

use super::{Outcome, Reported, Run};

/// Results beyond this are no value of a part program.
const LARGEST: f64 = 1e12;

impl Run<'_> {
    /// Computes a formula of the block.
    pub(super) fn formula(&mut self, block: &Block, formula: Formula) -> Outcome<f64> {
        let mut stack = std::mem::take(&mut self.stack);
        stack.clear();
        let result = self.run_ops(&mut stack, block, formula);
        let value = stack.pop();
        self.stack = stack;
        result?;
        match value {
            Some(value) if value.is_finite() && value.abs() <= LARGEST => Ok(value),
            Some(_) => self.fail(codes::T2009, formula.span, "the result is too large"),
            None => self.fail(codes::T1001, formula.span, "a value is missing"),
        }
    }

    fn run_ops(&mut self, stack: &mut Vec<f64>, block: &Block, formula: Formula) -> Outcome {
        for op in block.formula(formula) {
            let value = match *op {
                Op::Number(n) => Ok(n),
                Op::Var(var, span) => Ok(self.variable(var, span)?),
                Op::Unary(f) => unary(f, stack.pop().unwrap_or(0.0)),
                Op::Binary(f) => {
                    let b = stack.pop().unwrap_or(0.0);
                    let a = stack.pop().unwrap_or(0.0);
                    binary(f, a, b)
                }
            };
            match value {
                Ok(value) => stack.push(value),
                Err(why) => return self.fail(codes::T2009, formula.span, why),
            }
        }
        Ok(())
    }

    /// Value of a variable.
    fn variable(&mut self, var: VarRef, span: Span) -> Outcome<f64> {
        let here = self.level_number();
        match var.kind {
            VarKind::Local | VarKind::Argument => {
                let start = self.vars.get(var).and_then(|slot| slot.value);
                match (self.level().frame.locals.get(&var).copied(), start) {
                    (Some(Some(value)), _) | (None, Some(value)) => Ok(value),
                    (Some(None), _) => Err(Reported),
                    (None, None) => self.unset(var, span),
                }
            }
            _ => match self.vars.get(var) {
                Some(slot) if var.kind == VarKind::Hash && slot.level != 0 && slot.level != here => self.fail_help(
                    codes::T2014,
                    span,
                    format!("{var} was assigned in another program than the one that reads it"),
                    "hand the value over in the L block, or use #c variables",
                ),
                Some(slot) => slot.value.ok_or(Reported),
                None => self.unset(var, span),
            },
        }
    }

    fn unset<T>(&self, var: VarRef, span: Span) -> Outcome<T> {
        let key = var.to_string().to_ascii_uppercase();
        match var.kind {
            VarKind::Machine | VarKind::Interpreter => self.fail_help(
                codes::T2010,
                span,
                format!("{var} is set by the control at the machine"),
                format!("give its value in partc.toml: `[variables]` with `\"{key}\" = …`"),
            ),
            VarKind::Real if var.number > 900 => self.fail_help(
                codes::T2010,
                span,
                format!("{var} holds what the control measured"),
                format!("give its value in partc.toml: `[variables]` with `{key} = …`"),
            ),
            VarKind::Argument => self.fail_help(
                codes::T2008,
                span,
                format!("the call gives no value for {var}"),
                "add the word to the L block of the call",
            ),
            _ => self.fail_help(
                codes::T2008,
                span,
                format!("{var} is read before a value is assigned to it"),
                format!("assign a value, or give one in partc.toml: `[variables]` with `\"{key}\" = …`"),
            ),
        }
    }

    /// `#1=…`
    pub(super) fn assign(&mut self, var: VarRef, block: &Block, formula: Formula) -> Outcome {
        let value = self.formula(block, formula);
        match var.kind {
            VarKind::Machine | VarKind::Interpreter => {
                return self.fail(codes::T2010, block.span, format!("{var} belongs to the control"));
            }
            VarKind::Local | VarKind::Argument => {
                self.level().frame.locals.insert(var, value.ok());
            }
            _ => {
                let level = self.level_number();
                self.vars.set(var, value.ok(), level);
            }
        }
        value.map(|_| ())
    }

    /// 1 for the main program, one more for each call that is open.
    fn level_number(&self) -> u32 {
        // A level is told apart by how often a call was made, so that two calls never share one.
        self.levels.last().map_or(1, |level| level.frame.number)
    }
}

fn unary(f: Unary, x: f64) -> Result<f64, String> {
    let domain = |good: bool, value: f64, what: &str| if good { Ok(value) } else { Err(format!("{what} of {x}")) };
    match f {
        Unary::Negate => Ok(-x),
        Unary::Sqrt => domain(x >= 0.0, x.max(0.0).sqrt(), "square root"),
        Unary::Sin => Ok(Deg(x).sin_cos().0),
        Unary::Cos => Ok(Deg(x).sin_cos().1),
        Unary::Tan => {
            let (sin, cos) = Deg(x).sin_cos();
            domain(cos != 0.0, sin / cos, "tangent")
        }
        Unary::Asin => domain(x.abs() <= 1.0, Deg::from_radians(libm::asin(x)).0, "arc sine"),
        Unary::Acos => domain(x.abs() <= 1.0, Deg::from_radians(libm::acos(x)).0, "arc cosine"),
        Unary::Atan => Ok(Deg::from_radians(libm::atan(x)).0),
        Unary::Abs => Ok(x.abs()),
        // No manual says which way a negative number is cut off, or a half is rounded.
        Unary::Int => domain(x >= 0.0 || x.fract() == 0.0, x.trunc(), "integer part"),
        Unary::Round => domain(x.fract().abs() != 0.5, x.round(), "rounded value"),
        Unary::Ln => domain(x > 0.0, libm::log(x.max(f64::MIN_POSITIVE)), "logarithm"),
        Unary::Exp => domain(x < 100.0, libm::exp(x), "exponential"),
    }
}

fn binary(f: Binary, a: f64, b: f64) -> Result<f64, String> {
    let truth = |t: bool| Ok(f64::from(u8::from(t)));
    match f {
        Binary::Add => Ok(a + b),
        Binary::Subtract => Ok(a - b),
        Binary::Multiply => Ok(a * b),
        Binary::Divide if b == 0.0 => Err(format!("{a} is divided by zero")),
        Binary::Divide => Ok(a / b),
        Binary::Equal => truth(a == b),
        Binary::NotEqual => truth(a != b),
        Binary::Less => truth(a < b),
        Binary::LessEqual => truth(a <= b),
        Binary::Greater => truth(a > b),
        Binary::GreaterEqual => truth(a >= b),
        Binary::And => truth(a != 0.0 && b != 0.0),
        Binary::Or => truth(a != 0.0 || b != 0.0),
        Binary::RootOfSum => Ok(libm::hypot(a, b)),
        Binary::RootOfDifference if a.abs() < b.abs() => Err(format!("square root of {a}² - {b}²")),
        Binary::RootOfDifference => Ok(((a - b) * (a + b)).sqrt()),
    }
}
