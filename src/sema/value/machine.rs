//! The postfix loop and its stack.

use crate::lexer::formula::{Function, Operator};
use crate::sema::{Outcome, Reported};
use crate::text::Span;

use super::{Divisor, Fault, Never, Rules, Stop, Val};

/// Where a formula stands.
#[derive(Debug, Clone, Copy)]
pub struct At<'t> {
    pub span: Span,
    /// The block.
    pub text: &'t [u8],
}

/// What a dialect brings to the machine.
pub trait Formulas {
    type Op;
    type Axis: Clone + Ord;
    type Frame: Clone;

    fn machine(&mut self) -> &mut Machine<Self::Axis, Self::Frame>;

    /// Makes the value of one operation.
    fn operation(
        &mut self,
        op: &Self::Op,
        machine: &mut Machine<Self::Axis, Self::Frame>,
        at: At<'_>,
    ) -> Result<Val<Self::Axis, Self::Frame>, Stop>;

    /// The variable that `operand` ends with, if it is all that an operator behind it takes.
    fn divisor(&self, operand: &[Self::Op], at: At<'_>) -> Option<Divisor>;

    /// Reports a fault in the dialect's words.
    fn fault(&self, fault: Fault, at: At<'_>) -> Reported;
}

/// The value that `ops` leave.
pub fn evaluate<L: Formulas>(run: &mut L, ops: &[L::Op], at: At<'_>) -> Outcome<Val<L::Axis, L::Frame>> {
    // Reading a variable may compute another formula: that one finds an empty stack.
    let mut machine = run.machine().lend();
    let mut done = 0;
    let made = ops.iter().try_for_each(|op| {
        let value = run.operation(op, &mut machine, at)?;
        machine.stack.push(value);
        done += 1;
        Ok(())
    });
    let made = made.and_then(|()| machine.result());
    machine.stack.clear();
    *run.machine() = machine;
    match made {
        Ok(value) => Ok(value),
        Err(Stop::Fault(Fault::Zero(a))) => {
            let divisor = run.divisor(&ops[..done.min(ops.len())], at);
            Err(run.fault(divisor.map_or(Fault::Zero(a), |divisor| Fault::ZeroBy(a, divisor)), at))
        }
        Err(Stop::Fault(fault)) => Err(run.fault(fault, at)),
        Err(Stop::Reported) => Err(Reported),
    }
}

/// The stack of values, and the rules that they are computed by.
#[derive(Debug)]
pub struct Machine<A = Never, F = Never> {
    stack: Vec<Val<A, F>>,
    pub rules: Rules,
}

impl<A: Clone + Ord, F: Clone> Machine<A, F> {
    pub fn new(rules: Rules) -> Self {
        Machine { stack: Vec::new(), rules }
    }

    fn lend(&mut self) -> Self {
        Machine { stack: std::mem::take(&mut self.stack), rules: self.rules }
    }

    fn result(&mut self) -> Result<Val<A, F>, Stop> {
        let value = self.pop()?;
        match value {
            Val::Real(v) if !(v.is_finite() && v.abs() <= self.rules.result) => Err(Fault::TooLarge.into()),
            value => Ok(value),
        }
    }

    pub fn pop(&mut self) -> Result<Val<A, F>, Fault> {
        self.stack.pop().ok_or(Fault::Missing)
    }

    /// The last `count` values.
    pub fn last(&self, count: u32) -> &[Val<A, F>] {
        &self.stack[self.stack.len().saturating_sub(count as usize)..]
    }

    /// Takes the last `count` values away.
    pub fn discard(&mut self, count: u32) {
        self.stack.truncate(self.stack.len().saturating_sub(count as usize));
    }

    /// Applies a function to the last value.
    pub fn unary(&mut self, f: Function) -> Result<Val<A, F>, Fault> {
        let value = self.pop()?;
        self.rules.function(f, &value)
    }

    /// Applies an operator to the last two values.
    pub fn binary(&mut self, f: Operator) -> Result<Val<A, F>, Fault> {
        let right = self.pop()?;
        let left = self.pop()?;
        self.rules.operator(f, &left, &right)
    }
}

impl Rules {
    fn truth<A, F>(&self, truth: bool) -> Val<A, F> {
        if self.typed { Val::Bool(truth) } else { Val::Real(f64::from(u8::from(truth))) }
    }

    /// A function of a value.
    pub fn function<A: Clone + Ord, F: Clone>(&self, f: Function, value: &Val<A, F>) -> Result<Val<A, F>, Fault> {
        let misfit = Fault::Misfit(value.what());
        let int = |made: Option<i32>| made.map(Val::Int).ok_or(Fault::TooLargeInt);
        match (f, value) {
            (Function::Negate, Val::Int(n)) => int(n.checked_neg()),
            (Function::Abs, Val::Int(n)) => int(n.checked_abs()),
            (Function::BitNot, Val::Int(n)) => Ok(Val::Int(!n)),
            (Function::Not, value) => value.truth().map(|truth| self.truth(!truth)).ok_or(misfit),
            (Function::Negate, Val::Bool(_) | Val::Char(_)) | (Function::BitNot, _) => Err(misfit),
            (f, value) => self.unary(f, value.number().ok_or(misfit)?).map(Val::Real),
        }
    }

    /// An operator between two values.
    pub fn operator<A: Clone + Ord, F: Clone>(
        &self,
        f: Operator,
        a: &Val<A, F>,
        b: &Val<A, F>,
    ) -> Result<Val<A, F>, Fault> {
        use Operator::*;
        let mismatch = Fault::Mismatch(a.what(), b.what());
        match f {
            Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual => {
                let order = a.order(b, self.equal).ok_or(mismatch)?;
                Ok(self.truth(match f {
                    Equal => order.is_eq(),
                    NotEqual => order.is_ne(),
                    Less => order.is_lt(),
                    LessEqual => order.is_le(),
                    Greater => order.is_gt(),
                    _ => order.is_ge(),
                }))
            }
            And | Or | Xor => {
                let (Some(a), Some(b)) = (a.truth(), b.truth()) else { return Err(mismatch) };
                Ok(self.truth(match f {
                    And => a && b,
                    Or => a || b,
                    _ => a != b,
                }))
            }
            Divide | Power | RootOfSum | RootOfDifference | Angle => self.numbers(f, a, b),
            Add | Subtract | Multiply | WholeDivide | Modulo | BitAnd | BitOr | BitXor => match (a, b) {
                (Val::Int(a), Val::Int(b)) => ints(f, *a, *b).map(Val::Int),
                _ => self.numbers(f, a, b),
            },
        }
    }

    fn numbers<A: Clone + Ord, F: Clone>(&self, f: Operator, a: &Val<A, F>, b: &Val<A, F>) -> Result<Val<A, F>, Fault> {
        let bits = matches!(f, Operator::BitAnd | Operator::BitOr | Operator::BitXor);
        match (a.number(), b.number()) {
            (Some(x), Some(y)) if !bits => self.binary(f, x, y).map(Val::Real),
            _ => Err(Fault::Mismatch(a.what(), b.what())),
        }
    }
}

fn ints(f: Operator, a: i32, b: i32) -> Result<i32, Fault> {
    let made = match f {
        Operator::Add => a.checked_add(b),
        Operator::Subtract => a.checked_sub(b),
        Operator::Multiply => a.checked_mul(b),
        Operator::BitAnd => Some(a & b),
        Operator::BitOr => Some(a | b),
        Operator::BitXor => Some(a ^ b),
        _ if b == 0 => return Err(Fault::Zero(f64::from(a))),
        Operator::WholeDivide => a.checked_div(b),
        _ => a.checked_rem(b),
    };
    made.ok_or(Fault::TooLargeInt)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A dialect of numbers, with one variable that is lost.
    struct Run(Machine, std::cell::RefCell<Vec<Fault>>);

    enum Op {
        Number(f64),
        Lost,
        Nested,
        Unary(Function),
        Binary(Operator),
    }

    impl Formulas for Run {
        type Op = Op;
        type Axis = Never;
        type Frame = Never;

        fn machine(&mut self) -> &mut Machine {
            &mut self.0
        }

        fn operation(&mut self, op: &Op, machine: &mut Machine, at: At<'_>) -> Result<Val, Stop> {
            Ok(match *op {
                Op::Number(n) => Val::Real(n),
                Op::Lost => return Err(Stop::Reported),
                Op::Nested => evaluate(self, &[Op::Number(2.0), Op::Number(3.0), Op::Binary(Operator::Add)], at)?,
                Op::Unary(f) => machine.unary(f)?,
                Op::Binary(f) => machine.binary(f)?,
            })
        }

        fn divisor(&self, operand: &[Op], _: At<'_>) -> Option<Divisor> {
            matches!(operand, [.., Op::Nested])
                .then(|| Divisor { name: "N".to_owned(), set: super::super::SetBy::Nobody })
        }

        fn fault(&self, fault: Fault, _: At<'_>) -> Reported {
            self.1.borrow_mut().push(fault);
            Reported
        }
    }

    fn run(ops: &[Op]) -> Result<Val, Vec<Fault>> {
        let rules = Rules { result: 1e6, ..Rules::USUAL };
        let mut run = Run(Machine::new(rules), Default::default());
        let made = evaluate(&mut run, ops, At { span: Span::default(), text: b"" });
        assert!(run.0.stack.is_empty());
        made.map_err(|_| run.1.take())
    }

    #[test]
    fn a_formula_leaves_one_value() {
        use Op::*;
        let product = [Number(4.0), Nested, Binary(Operator::Multiply), Unary(Function::Negate)];
        assert_eq!(run(&product), Ok(Val::Real(-20.0)));
        assert_eq!(run(&[]), Err(vec![Fault::Missing]));
        assert_eq!(run(&[Number(1.0), Binary(Operator::Add)]), Err(vec![Fault::Missing]));
        assert_eq!(run(&[Number(2e6)]), Err(vec![Fault::TooLarge]));
        // A step may be larger than the result.
        let ops = [Number(2e6), Number(4.0), Binary(Operator::Divide)];
        assert_eq!(run(&ops), Ok(Val::Real(5e5)));
    }

    #[test]
    fn what_is_lost_is_not_reported_again() {
        assert_eq!(run(&[Op::Lost, Op::Number(0.0), Op::Binary(Operator::Divide)]), Err(vec![]));
        let zero = [Op::Number(1.0), Op::Number(0.0), Op::Binary(Operator::Divide), Op::Lost];
        assert_eq!(run(&zero), Err(vec![Fault::Zero(1.0)]));
    }

    #[test]
    fn types_are_kept() {
        let rules = Rules { typed: true, equal: 1e-12, ..Rules::USUAL };
        let int = Val::<Never, Never>::Int;
        let apply = |f, a: Val, b: Val| rules.operator(f, &a, &b);
        assert_eq!(apply(Operator::Add, int(2), int(3)), Ok(int(5)));
        assert_eq!(apply(Operator::Divide, int(3), int(2)), Ok(Val::Real(1.5)));
        assert_eq!(apply(Operator::WholeDivide, int(-7), int(2)), Ok(int(-3)));
        assert_eq!(apply(Operator::Modulo, int(7), int(0)), Err(Fault::Zero(7.0)));
        assert_eq!(apply(Operator::Multiply, int(i32::MAX), int(2)), Err(Fault::TooLargeInt));
        assert_eq!(apply(Operator::WholeDivide, int(i32::MIN), int(-1)), Err(Fault::TooLargeInt));
        assert_eq!(apply(Operator::BitAnd, int(6), int(3)), Ok(int(2)));
        assert_eq!(apply(Operator::BitAnd, int(6), Val::Real(3.0)), Err(Fault::Mismatch("an INT", "a REAL")));
        assert_eq!(apply(Operator::Equal, Val::Real(0.1 + 0.2), Val::Real(0.3)), Ok(Val::Bool(true)));
        assert_eq!(apply(Operator::Less, Val::text(b"A"), Val::Char(b'B')), Ok(Val::Bool(true)));
        assert_eq!(apply(Operator::Less, Val::text(b"A"), int(1)), Err(Fault::Mismatch("a text", "an INT")));
        assert_eq!(apply(Operator::Xor, Val::text(b""), int(1)), Ok(Val::Bool(true)));
        assert_eq!(rules.function(Function::Negate, &int(i32::MIN)), Err(Fault::TooLargeInt));
        assert_eq!(rules.function::<Never, Never>(Function::Negate, &Val::Bool(true)), Err(Fault::Misfit("a BOOL")));
        assert_eq!(rules.function(Function::Not, &int(0)), Ok(Val::Bool(true)));
        assert_eq!(Rules::USUAL.function(Function::Not, &int(0)), Ok(Val::Real(1.0)));
    }
}
