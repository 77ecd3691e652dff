//! Computes formulas: angles in degrees, the control's functions, every error with a name.

use std::rc::Rc;

use crate::geo::Deg;
use crate::machine::Generation;
use crate::parser::klartext::ast::{Binary, TextFn, Unary};

/// A number or a text on the stack of a formula.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Val {
    Number(f64),
    Text(Rc<str>),
}

/// Largest value a parameter holds.
const LARGEST: f64 = 1e10;
/// Longest text a parameter holds.
const LONGEST: usize = 255;

/// A computation without a result: why.
pub(super) type Failure = String;

pub(super) fn unary(f: Unary, x: f64, generation: Generation) -> Result<f64, Failure> {
    let outside = |name: &str| Err(format!("{name} of {x} does not exist"));
    let y = match f {
        Unary::Sin => Deg(x).sin_cos().0,
        Unary::Cos => Deg(x).sin_cos().1,
        Unary::Tan => {
            let (sin, cos) = Deg(x).sin_cos();
            if cos == 0.0 {
                return outside("tangent");
            }
            sin / cos
        }
        Unary::Asin if x.abs() > 1.0 => return outside("arc sine"),
        Unary::Asin => Deg::from_radians(libm::asin(x)).0,
        Unary::Acos if x.abs() > 1.0 => return outside("arc cosine"),
        Unary::Acos => Deg::from_radians(libm::acos(x)).0,
        Unary::Atan => Deg::from_radians(libm::atan(x)).0,
        Unary::Square => x * x,
        Unary::Root if x < 0.0 => return outside("square root"),
        Unary::Root => x.sqrt(),
        Unary::Ln if x <= 0.0 => return outside("logarithm"),
        Unary::Ln => libm::log(x),
        Unary::Log if x <= 0.0 => return outside("logarithm"),
        Unary::Log => libm::log10(x),
        Unary::Exp => libm::exp(x),
        Unary::Negate => -x,
        Unary::Integer => x.trunc(),
        Unary::Absolute => x.abs(),
        Unary::Fraction => x - x.trunc(),
        // The sign of 0 is +1 on the controls of this time, 0 on later ones.
        Unary::Sign if x == 0.0 => {
            if generation >= Generation::Tnc7 {
                0.0
            } else {
                1.0
            }
        }
        Unary::Sign => x.signum(),
    };
    checked(y)
}

pub(super) fn binary(f: Binary, a: f64, b: f64) -> Result<f64, Failure> {
    let y = match f {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide if b == 0.0 => return Err(format!("{a} is divided by zero")),
        Binary::Divide => a / b,
        Binary::Modulo if b == 0.0 => return Err(format!("{a} is divided by zero")),
        Binary::Modulo => a % b,
        Binary::Power => {
            let y = libm::pow(a, b);
            if y.is_nan() {
                return Err(format!("{a} to the power of {b} does not exist"));
            }
            y
        }
        Binary::Length => libm::hypot(a, b),
        // The opposite side comes first.
        Binary::Angle => Deg::of(crate::geo::Vec2::new(b, a)).0,
    };
    checked(y)
}

/// A value that a parameter can hold.
pub(super) fn checked(y: f64) -> Result<f64, Failure> {
    if y.is_finite() && y.abs() <= LARGEST { Ok(y) } else { Err("the result is over 10 000 000 000".to_owned()) }
}

/// Applies a text function to its arguments, which `pop` takes from the stack, the last one first.
pub(super) fn text_fn(f: TextFn, stack: &mut Vec<Val>) -> Result<Val, Failure> {
    let text = |stack: &mut Vec<Val>| match stack.pop() {
        Some(Val::Text(text)) => Ok(text),
        _ => Err("a text parameter is needed".to_owned()),
    };
    let number = |stack: &mut Vec<Val>| match stack.pop() {
        Some(Val::Number(n)) => Ok(n),
        _ => Err("a number is needed".to_owned()),
    };
    let count = |n: f64| if n >= 0.0 && n.fract() == 0.0 { Ok(n as usize) } else { Err(format!("{n} is no position")) };
    Ok(match f {
        TextFn::ToChar => {
            let decimals = number(stack)?;
            let value = number(stack)?;
            let places = if decimals < 0.0 { 0 } else { count(decimals)?.min(9) };
            Val::Text(format!("{value:.places$}").into())
        }
        TextFn::ToNumber => {
            let text = text(stack)?;
            let plain = text.trim().replace(',', ".");
            let value: f64 = plain.parse().map_err(|_| format!("`{text}` is no number"))?;
            Val::Number(checked(value)?)
        }
        TextFn::Substring => {
            let (len, begin) = (count(number(stack)?)?, count(number(stack)?)?);
            let text = text(stack)?;
            Val::Text(text.chars().skip(begin).take(len).collect::<String>().into())
        }
        TextFn::Find => {
            let begin = count(number(stack)?)?;
            let (wanted, text) = (text(stack)?, text(stack)?);
            let rest: String = text.chars().skip(begin).collect();
            let at = rest.find(&*wanted).map_or(text.chars().count(), |at| begin + rest[..at].chars().count());
            Val::Number(at as f64)
        }
        TextFn::Length => Val::Number(text(stack)?.chars().count() as f64),
        TextFn::Compare => {
            let (b, a) = (text(stack)?, text(stack)?);
            Val::Number(match a.cmp(&b) {
                std::cmp::Ordering::Less => -1.0,
                std::cmp::Ordering::Equal => 0.0,
                std::cmp::Ordering::Greater => 1.0,
            })
        }
        TextFn::Unknown => return Err("the function reads from the control".to_owned()),
    })
}

/// Two texts in one.
pub(super) fn join(a: &str, b: &str) -> Result<Val, Failure> {
    if a.len() + b.len() > LONGEST {
        return Err(format!("the text is longer than {LONGEST} characters"));
    }
    Ok(Val::Text(format!("{a}{b}").into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_the_reference() {
        assert_eq!(binary(Binary::Modulo, 400.0, 360.0), Ok(40.0));
        assert!((binary(Binary::Length, 5.0, 4.0).unwrap() - 6.4031).abs() < 1e-4);
        assert!((binary(Binary::Angle, 25.0, 50.0).unwrap() - 26.5651).abs() < 1e-4);
        assert_eq!(binary(Binary::Angle, -10.0, -10.0), Ok(225.0));
        let g = Generation::Itnc530;
        assert_eq!(unary(Unary::Integer, -2.7, g), Ok(-2.0));
        assert!((unary(Unary::Fraction, -2.7, g).unwrap() + 0.7).abs() < 1e-12);
        assert_eq!(unary(Unary::Sign, 0.0, g), Ok(1.0));
        assert_eq!(unary(Unary::Sign, 0.0, Generation::Tnc7), Ok(0.0));
        assert!(unary(Unary::Root, -1.0, g).is_err());
        assert!(unary(Unary::Tan, 90.0, g).is_err());
        assert!(binary(Binary::Divide, 1.0, 0.0).is_err());
        assert!(binary(Binary::Multiply, 1e9, 1e9).is_err());
    }
}
