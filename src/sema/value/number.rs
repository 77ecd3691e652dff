//! Functions and operators on numbers, every one with its domain.

use crate::geo::{Deg, Vec2};
use crate::lexer::formula::{Function, Operator};

use super::Fault;

/// Cosines below this are those of a right angle.
const RIGHT_ANGLE: f64 = 1e-12;

/// What controls read differently.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// Largest result of a function or operator.
    pub step: f64,
    /// Largest value of a formula.
    pub result: f64,
    /// Angles count in radians.
    pub radians: bool,
    pub sign_of_zero: f64,
    /// EXP takes numbers below this.
    pub exponents: f64,
    /// Is it known how decimals of negative numbers are cut off?
    pub cuts_negative: bool,
    /// Is it known that halves are rounded away from zero?
    pub rounds_halves: bool,
    pub modulo: Modulo,
    /// Part of their size within which two numbers are equal.
    pub equal: f64,
    /// Comparisons give a BOOL, not 1 or 0.
    pub typed: bool,
}

/// How a rest is computed where an operand is negative or no whole number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Modulo {
    /// It has the sign of the first operand.
    Truncate,
    /// It has the sign of the second operand.
    Floor,
    /// Unknown for negative operands.
    Positive,
    /// Unknown for negative operands and fractions, as for whole division.
    Whole,
}

impl Rules {
    /// What most controls do.
    pub const USUAL: Rules = Rules {
        step: f64::MAX,
        result: f64::MAX,
        radians: false,
        sign_of_zero: 0.0,
        exponents: f64::INFINITY,
        cuts_negative: true,
        rounds_halves: true,
        modulo: Modulo::Truncate,
        equal: 0.0,
        typed: false,
    };

    fn sin_cos(&self, x: f64) -> (f64, f64) {
        if self.radians { libm::sincos(x) } else { Deg(x).sin_cos() }
    }

    fn angle(&self, radians: f64) -> f64 {
        if self.radians { radians } else { Deg::from_radians(radians).0 }
    }

    fn limited(&self, y: f64) -> Result<f64, Fault> {
        if y.is_finite() && y.abs() <= self.step { Ok(y) } else { Err(Fault::TooLarge) }
    }

    /// A function of a number.
    pub fn unary(&self, f: Function, x: f64) -> Result<f64, Fault> {
        let outside = Err(Fault::Domain(f, x));
        let y = match f {
            Function::Negate => -x,
            Function::Abs => x.abs(),
            Function::Sign if x == 0.0 => self.sign_of_zero,
            Function::Sign => x.signum(),
            Function::Int if x < 0.0 && x.fract() != 0.0 && !self.cuts_negative => return Err(Fault::Open(f, x)),
            Function::Int => libm::trunc(x),
            Function::Fraction => x - libm::trunc(x),
            Function::Round if x.fract().abs() == 0.5 && !self.rounds_halves => return Err(Fault::Open(f, x)),
            Function::Round => libm::round(x),
            Function::RoundUp if x < 0.0 => libm::floor(x),
            Function::RoundUp => libm::ceil(x),
            Function::Sin => self.sin_cos(x).0,
            Function::Cos => self.sin_cos(x).1,
            Function::Tan => {
                let (sin, cos) = self.sin_cos(x);
                if cos.abs() < RIGHT_ANGLE {
                    return outside;
                }
                sin / cos
            }
            Function::Asin | Function::Acos if x.abs() > 1.0 => return outside,
            Function::Asin => self.angle(libm::asin(x)),
            Function::Acos => self.angle(libm::acos(x)),
            Function::Atan => self.angle(libm::atan(x)),
            Function::Sqrt if x < 0.0 => return outside,
            Function::Sqrt => x.sqrt(),
            Function::Square => x * x,
            Function::Ln | Function::Log if x <= 0.0 => return outside,
            Function::Ln => libm::log(x),
            Function::Log => libm::log10(x),
            Function::Exp if x >= self.exponents => return outside,
            Function::Exp => libm::exp(x),
            Function::Not | Function::BitNot => return Err(Fault::Misfit("a REAL")),
        };
        self.limited(y)
    }

    /// An operator between numbers that gives a number.
    pub fn binary(&self, f: Operator, a: f64, b: f64) -> Result<f64, Fault> {
        use Operator::*;
        let y = match f {
            Add => a + b,
            Subtract => a - b,
            Multiply => a * b,
            Divide | WholeDivide | Modulo if b == 0.0 => return Err(Fault::Zero(a)),
            Divide => a / b,
            WholeDivide => {
                self.rest_is_known(f, a, b)?;
                libm::trunc(a / b)
            }
            Modulo => self.rest(a, b)?,
            Power => {
                let y = libm::pow(a, b);
                if y.is_nan() {
                    return Err(Fault::Outside(f, a, b));
                }
                y
            }
            RootOfSum => libm::hypot(a, b),
            RootOfDifference if a.abs() < b.abs() => return Err(Fault::Outside(f, a, b)),
            RootOfDifference => ((a - b) * (a + b)).sqrt(),
            Angle if self.radians => Deg::of(Vec2::new(b, a)).radians(),
            Angle => Deg::of(Vec2::new(b, a)).0,
            BitAnd | BitOr | BitXor | And | Or | Xor | Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual => {
                return Err(Fault::Mismatch("a REAL", "a REAL"));
            }
        };
        self.limited(y)
    }

    fn rest_is_known(&self, f: Operator, a: f64, b: f64) -> Result<(), Fault> {
        let negative = a < 0.0 || b < 0.0;
        let known = match self.modulo {
            self::Modulo::Truncate | self::Modulo::Floor => true,
            // The rest of zero has no sign.
            self::Modulo::Positive => !negative || f == Operator::WholeDivide || a % b == 0.0,
            self::Modulo::Whole => !negative && a.fract() == 0.0 && b.fract() == 0.0,
        };
        if known { Ok(()) } else { Err(Fault::OpenBetween(f, a, b)) }
    }

    fn rest(&self, a: f64, b: f64) -> Result<f64, Fault> {
        self.rest_is_known(Operator::Modulo, a, b)?;
        let rest = a % b;
        Ok(match self.modulo {
            _ if rest == 0.0 => 0.0,
            self::Modulo::Floor if (rest < 0.0) != (b < 0.0) => rest + b,
            _ => rest,
        })
    }
}

/// What a function computes, for messages.
pub fn noun(f: Function) -> &'static str {
    match f {
        Function::Negate => "negative",
        Function::Abs => "absolute value",
        Function::Sign => "sign",
        Function::Int => "integer part",
        Function::Fraction => "fraction",
        Function::Round | Function::RoundUp => "rounded value",
        Function::Sin => "sine",
        Function::Cos => "cosine",
        Function::Tan => "tangent",
        Function::Asin => "arc sine",
        Function::Acos => "arc cosine",
        Function::Atan => "arc tangent",
        Function::Sqrt => "square root",
        Function::Square => "square",
        Function::Ln | Function::Log => "logarithm",
        Function::Exp => "exponential",
        Function::Not | Function::BitNot => "opposite",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const USUAL: Rules = Rules::USUAL;

    #[test]
    fn values_of_the_manuals() {
        assert_eq!(USUAL.binary(Operator::Modulo, 400.0, 360.0), Ok(40.0));
        assert!((USUAL.binary(Operator::RootOfSum, 5.0, 4.0).unwrap() - 6.4031).abs() < 1e-4);
        assert!((USUAL.binary(Operator::Angle, 25.0, 50.0).unwrap() - 26.5651).abs() < 1e-4);
        assert_eq!(USUAL.binary(Operator::Angle, -10.0, -10.0), Ok(225.0));
        assert_eq!(USUAL.binary(Operator::RootOfDifference, 5.0, 4.0), Ok(3.0));
        assert_eq!(USUAL.binary(Operator::WholeDivide, -7.0, 2.0), Ok(-3.0));
        assert_eq!(USUAL.unary(Function::Int, -2.7), Ok(-2.0));
        assert!((USUAL.unary(Function::Fraction, -2.7).unwrap() + 0.7).abs() < 1e-12);
        assert_eq!(USUAL.unary(Function::Round, 2.5), Ok(3.0));
        assert_eq!(USUAL.unary(Function::Round, -2.5), Ok(-3.0));
        assert_eq!(USUAL.unary(Function::RoundUp, -3.1), Ok(-4.0));
        assert_eq!(USUAL.unary(Function::Cos, 90.0), Ok(0.0));
        assert_eq!(USUAL.unary(Function::Asin, 0.5).map(libm::round), Ok(30.0));
    }

    #[test]
    fn nothing_is_computed_outside_its_domain() {
        for (f, x) in [
            (Function::Sqrt, -1e-9),
            (Function::Asin, 1.000001),
            (Function::Acos, -1.000001),
            (Function::Tan, 90.0),
            (Function::Tan, -270.0),
            (Function::Ln, 0.0),
            (Function::Log, -1.0),
        ] {
            assert_eq!(USUAL.unary(f, x), Err(Fault::Domain(f, x)));
        }
        let radians = Rules { radians: true, ..USUAL };
        let right = core::f64::consts::FRAC_PI_2;
        assert_eq!(radians.unary(Function::Tan, right), Err(Fault::Domain(Function::Tan, right)));
        for f in [Operator::Divide, Operator::WholeDivide, Operator::Modulo] {
            assert_eq!(USUAL.binary(f, 3.0, 0.0), Err(Fault::Zero(3.0)));
            assert_eq!(USUAL.binary(f, 3.0, -0.0), Err(Fault::Zero(3.0)));
        }
        assert!(matches!(USUAL.binary(Operator::Power, -8.0, 0.5), Err(Fault::Outside(..))));
        assert!(matches!(USUAL.binary(Operator::RootOfDifference, 3.0, 5.0), Err(Fault::Outside(..))));
    }

    #[test]
    fn too_large_is_a_fault() {
        assert_eq!(USUAL.binary(Operator::Multiply, 1e200, 1e200), Err(Fault::TooLarge));
        assert_eq!(USUAL.binary(Operator::Power, 0.0, -1.0), Err(Fault::TooLarge));
        assert_eq!(USUAL.unary(Function::Exp, 1000.0), Err(Fault::TooLarge));
        let small = Rules { step: 1e10, exponents: 100.0, ..USUAL };
        assert_eq!(small.binary(Operator::Multiply, 1e9, 1e9), Err(Fault::TooLarge));
        assert_eq!(small.unary(Function::Exp, 100.0), Err(Fault::Domain(Function::Exp, 100.0)));
    }

    #[test]
    fn open_questions_are_answered_by_the_rules() {
        let rest = |modulo, a, b| Rules { modulo, ..USUAL }.binary(Operator::Modulo, a, b);
        assert_eq!(rest(Modulo::Truncate, -7.0, 3.0), Ok(-1.0));
        assert_eq!(rest(Modulo::Floor, -7.0, 3.0), Ok(2.0));
        assert_eq!(rest(Modulo::Floor, 7.0, -3.0), Ok(-2.0));
        assert_eq!(rest(Modulo::Positive, -7.0, 3.0), Err(Fault::OpenBetween(Operator::Modulo, -7.0, 3.0)));
        assert_eq!(rest(Modulo::Positive, -6.0, 3.0), Ok(0.0));
        assert_eq!(rest(Modulo::Positive, 7.5, 3.0), Ok(1.5));
        assert_eq!(rest(Modulo::Whole, 7.5, 3.0), Err(Fault::OpenBetween(Operator::Modulo, 7.5, 3.0)));
        assert_eq!(rest(Modulo::Whole, 7.0, 3.0), Ok(1.0));
        let careful = Rules { cuts_negative: false, rounds_halves: false, ..USUAL };
        assert_eq!(careful.unary(Function::Int, -2.5), Err(Fault::Open(Function::Int, -2.5)));
        assert_eq!(careful.unary(Function::Int, -2.0), Ok(-2.0));
        assert_eq!(careful.unary(Function::Round, 2.5), Err(Fault::Open(Function::Round, 2.5)));
        assert_eq!(careful.unary(Function::Round, 2.4), Ok(2.0));
        assert_eq!(Rules { sign_of_zero: 1.0, ..USUAL }.unary(Function::Sign, 0.0), Ok(1.0));
        assert_eq!(USUAL.unary(Function::Sign, -0.0), Ok(0.0));
    }
}
