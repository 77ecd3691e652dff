//! Functions of formulas.
//!
//! Source: S 5.2; angles are degrees (docs/sources.md).

use std::borrow::Cow;

use crate::diag::codes;
use crate::geo::Deg;
use crate::lexer::formula::Function;
use crate::sema::value::Fault;

use super::value::{RULES, Val, to_text, whole};

/// Why a function has no value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum NoResult {
    /// Wrong number of arguments; how many it takes.
    Count(&'static str),
    /// An argument of the wrong type.
    Type,
    /// An argument outside what the function takes.
    Domain(&'static str),
}

use NoResult::{Count, Domain, Type};

impl NoResult {
    /// What is wrong with the call of `name`.
    pub(super) fn fault(&self, name: &str) -> crate::diag::Fault {
        match self {
            Count(takes) => codes::S2021::takes(&name, takes),
            Type => codes::P2024::does_not_take_value_of_this_type(&name),
            Domain(why) => {
                let alarm = match name {
                    "SPRINT" => 14065,
                    "RTOI" | "BTOI" => 14096,
                    "AXNAME" => 14097,
                    "NUMBER" => 14098,
                    _ => 14051,
                };
                codes::P2022::formula_has_no_value(&name, why).alarm(alarm)
            }
        }
    }
}

type Made = Result<Val, NoResult>;

/// How a function is computed.
#[derive(Debug, Clone, Copy)]
pub(super) enum FormulaFunction {
    /// Of one number, by the value machine.
    Number(Function),
    /// Of its arguments alone.
    Plain(fn(&[Val]) -> Made),
    /// It needs the program: its variables, axes, files.
    Program,
}

use FormulaFunction::{Number, Plain, Program};

/// The functions; no variable can have their names.
const FUNCTIONS: &[(&str, FormulaFunction)] = &[
    ("SIN", Number(Function::Sin)),
    ("COS", Number(Function::Cos)),
    ("TAN", Number(Function::Tan)),
    ("ASIN", Number(Function::Asin)),
    ("ACOS", Number(Function::Acos)),
    ("ATAN2", Plain(atan2)),
    ("SQRT", Number(Function::Sqrt)),
    ("POT", Number(Function::Square)),
    ("ABS", Number(Function::Abs)),
    ("LN", Number(Function::Ln)),
    ("EXP", Number(Function::Exp)),
    ("TRUNC", Number(Function::Int)),
    ("ROUND", Number(Function::Round)),
    ("ROUNDUP", Number(Function::RoundUp)),
    ("MINVAL", Plain(|args| min_max(args, |x, y| x <= y))),
    ("MAXVAL", Plain(|args| min_max(args, |x, y| x >= y))),
    ("BOUND", Plain(bound)),
    ("ITOR", Plain(to_real)),
    ("BTOR", Plain(to_real)),
    ("RTOI", Plain(to_int)),
    ("BTOI", Plain(to_int)),
    ("RTOB", Plain(to_bool)),
    ("ITOB", Plain(to_bool)),
    ("AXNAME", Program),
    ("AXSTRING", Plain(axis_text)),
    ("SPI", Plain(|args| one(args).cloned())),
    ("ISAXIS", Plain(|args| Ok(Val::Bool((1.0..=3.0).contains(&real(one(args)?)?))))),
    ("STRLEN", Plain(|args| Ok(Val::Int(bytes(args, 0)?.len() as i32)))),
    ("TOUPPER", Plain(|args| Ok(Val::text(&bytes(args, 0)?.to_ascii_uppercase())))),
    ("TOLOWER", Plain(|args| Ok(Val::text(&bytes(args, 0)?.to_ascii_lowercase())))),
    ("INDEX", Plain(|args| character(args, |text, wanted| text.iter().position(|c| *c == wanted)))),
    ("RINDEX", Plain(|args| character(args, |text, wanted| text.iter().rposition(|c| *c == wanted)))),
    ("MINDEX", Plain(any_character)),
    ("MATCH", Plain(part)),
    ("SUBSTR", Plain(substring)),
    ("ISNUMBER", Plain(|args| Ok(Val::Bool(number_of(&bytes(args, 0)?).is_some())))),
    ("NUMBER", Plain(|args| number_of(&bytes(args, 0)?).map(Val::Real).ok_or(Domain("the text is no number")))),
    ("SPRINT", Plain(|args| Ok(Val::text(&sprint(args)?)))),
    ("CTRANS", Program),
    ("CFINE", Program),
    ("CROT", Program),
    ("CSCALE", Program),
    ("CMIRROR", Program),
    ("CRPL", Program),
    ("INVFRAME", Program),
    ("ISVAR", Program),
    ("ISFILE", Program),
    ("MODAXVAL", Program),
    ("SET", Program),
    ("REP", Program),
];

/// The function of this name.
pub(super) fn find(name: &str) -> Option<(&'static str, FormulaFunction)> {
    FUNCTIONS.iter().find(|(known, _)| *known == name).copied()
}

/// A function of one number.
pub(super) fn number(f: Function, args: &[Val]) -> Made {
    RULES.function(f, one(args)?).map_err(|fault| match (fault, f) {
        (Fault::Misfit(_) | Fault::Mismatch(..), _) => Type,
        (Fault::TooLargeInt, _) => Domain("it fits no INT"),
        (Fault::Domain(..), Function::Tan) => Domain("the tangent of 90 degrees is infinite"),
        (Fault::Domain(..), Function::Asin | Function::Acos) => Domain("its argument lies outside -1 to 1"),
        (Fault::Domain(..), Function::Sqrt) => Domain("the root of a negative number does not exist"),
        (Fault::Domain(..), Function::Ln) => Domain("a logarithm needs a number above 0"),
        _ => Domain("the value is infinite"),
    })
}

fn one(args: &[Val]) -> Result<&Val, NoResult> {
    match args {
        [value] => Ok(value),
        _ => Err(Count("one argument")),
    }
}

fn real(value: &Val) -> Result<f64, NoResult> {
    value.number().ok_or(Type)
}

fn atan2(args: &[Val]) -> Made {
    let [y, x] = args else { return Err(Count("two arguments")) };
    Ok(Val::Real(Deg::from_radians(libm::atan2(real(y)?, real(x)?)).0))
}

fn min_max(args: &[Val], first: fn(f64, f64) -> bool) -> Made {
    let [a, b] = args else { return Err(Count("two arguments")) };
    Ok(if first(real(a)?, real(b)?) { a.clone() } else { b.clone() })
}

fn bound(args: &[Val]) -> Made {
    let [low, high, value] = args else { return Err(Count("three arguments")) };
    let (l, h, v) = (real(low)?, real(high)?, real(value)?);
    if l > h {
        return Err(Domain("its lower bound is above its upper bound"));
    }
    let bounded = if v < l {
        low
    } else if v > h {
        high
    } else {
        value
    };
    Ok(bounded.clone())
}

fn to_real(args: &[Val]) -> Made {
    Ok(Val::Real(real(one(args)?)?))
}

fn to_int(args: &[Val]) -> Made {
    whole(real(one(args)?)?).map(Val::Int).ok_or(Domain("it fits no INT"))
}

fn to_bool(args: &[Val]) -> Made {
    one(args)?.truth().map(Val::Bool).ok_or(Type)
}

fn axis_text(args: &[Val]) -> Made {
    match one(args)? {
        Val::Axis(axis) => Ok(Val::text(axis.bytes())),
        _ => Err(Type),
    }
}

/// The text that stands as this argument.
fn bytes(args: &[Val], at: usize) -> Result<Cow<'_, [u8]>, NoResult> {
    match args.get(at) {
        Some(Val::Text(text)) => Ok(Cow::Borrowed(text)),
        Some(Val::Char(c)) => Ok(Cow::Owned(vec![*c])),
        Some(_) => Err(Type),
        None => Err(Count("more arguments")),
    }
}

fn place(found: Option<usize>) -> Made {
    Ok(Val::Int(found.and_then(|at| i32::try_from(at).ok()).unwrap_or(-1)))
}

fn character(args: &[Val], find: fn(&[u8], u8) -> Option<usize>) -> Made {
    let (text, what) = (bytes(args, 0)?, bytes(args, 1)?);
    let [wanted] = what.as_ref() else { return Err(Domain("it looks for one character")) };
    place(find(&text, *wanted))
}

fn any_character(args: &[Val]) -> Made {
    let (text, any) = (bytes(args, 0)?, bytes(args, 1)?);
    place(text.iter().position(|c| any.contains(c)))
}

fn part(args: &[Val]) -> Made {
    let (text, part) = (bytes(args, 0)?, bytes(args, 1)?);
    place(if part.is_empty() { Some(0) } else { text.windows(part.len()).position(|w| w == part.as_ref()) })
}

fn substring(args: &[Val]) -> Made {
    let text = bytes(args, 0)?;
    let at = |value: Option<&Val>| -> Result<Option<usize>, NoResult> {
        match value {
            None | Some(Val::Missing) => Ok(None),
            Some(value) => {
                let n = whole(real(value)?).ok_or(Type)?;
                Ok(Some(usize::try_from(n).map_err(|_| Domain("its place is negative"))?))
            }
        }
    };
    let from = at(args.get(1))?.ok_or(Count("two or three arguments"))?.min(text.len());
    let len = at(args.get(2))?.unwrap_or(text.len()).min(text.len() - from);
    Ok(Val::text(&text[from..from + len]))
}

/// The number that a text spells.
pub(super) fn number_of(text: &[u8]) -> Option<f64> {
    let text = text.trim_ascii();
    let (sign, digits) = match text.first()? {
        b'-' => (-1.0, &text[1..]),
        b'+' => (1.0, &text[1..]),
        _ => (1.0, text),
    };
    let (value, used) = crate::text::number::decimal(digits, false)?;
    let rest = &digits[used..];
    if rest.is_empty() {
        return Some(sign * value);
    }
    let exponent = rest.strip_prefix(b"EX").or_else(|| rest.strip_prefix(b"ex"))?;
    let exponent: i32 = std::str::from_utf8(exponent).ok()?.parse().ok()?;
    let scaled = sign * value * libm::pow(10.0, f64::from(exponent.clamp(-300, 300)));
    scaled.is_finite().then_some(scaled)
}

/// `SPRINT("%D %.3F %S", a, b, c)`
fn sprint(args: &[Val]) -> Result<Vec<u8>, NoResult> {
    let Some(Val::Text(format)) = args.first() else { return Err(Type) };
    let mut out = Vec::new();
    let mut rest = format.as_ref();
    let mut values = args[1..].iter();
    while let Some((&byte, behind)) = rest.split_first() {
        rest = behind;
        if byte != b'%' {
            out.push(byte);
            continue;
        }
        let len = rest.iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
        let (size, behind) = rest.split_at(len);
        let Some((kind, behind)) = behind.split_first() else { return Err(Domain("its format ends after %")) };
        rest = behind;
        if *kind == b'%' {
            out.push(b'%');
            continue;
        }
        let value = values.next().ok_or(Domain("its format has more fields than values"))?;
        let size = std::str::from_utf8(size).unwrap_or_default();
        let (width, places) = size.split_once('.').unwrap_or((size, ""));
        let width = width.parse::<usize>().unwrap_or(0).min(200);
        let places = places.parse::<usize>().unwrap_or(6).min(15);
        let field = match kind.to_ascii_uppercase() {
            b'D' => whole(real(value)?).ok_or(Type)?.to_string(),
            b'F' => format!("{:.places$}", real(value)?),
            b'B' => if value.truth().ok_or(Type)? { "TRUE" } else { "FALSE" }.to_owned(),
            b'S' | b'C' => String::from_utf8_lossy(&to_text(value).ok_or(Type)?).into_owned(),
            _ => return Err(Domain("its format has a field that is not %D, %F, %S, %C or %B")),
        };
        out.extend(std::iter::repeat_n(b' ', width.saturating_sub(field.len())));
        out.extend_from_slice(field.as_bytes());
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(name: &str, args: &[Val]) -> Made {
        match find(name).unwrap().1 {
            Number(f) => number(f, args),
            Plain(function) => function(args),
            Program => unreachable!(),
        }
    }

    fn r(name: &str, args: &[f64]) -> f64 {
        let args: Vec<Val> = args.iter().map(|v| Val::Real(*v)).collect();
        call(name, &args).unwrap().number().unwrap()
    }

    #[test]
    fn worked_examples() {
        assert!((r("ATAN2", &[30.5, 80.1]) - 20.8455).abs() < 1e-4);
        assert_eq!(r("ROUND", &[2.5]), 3.0);
        assert_eq!(r("TRUNC", &[-2.7]), -2.0);
        assert_eq!(r("POT", &[3.0]), 9.0);
        assert_eq!(r("BOUND", &[0.0, 10.0, 14.0]), 10.0);
        assert_eq!(r("ROUNDUP", &[-3.1]), -4.0);
        assert_eq!(r("COS", &[90.0]), 0.0);
    }

    #[test]
    fn texts() {
        let text = |s: &str| Val::text(s.as_bytes());
        assert_eq!(call("SUBSTR", &[text("ABCDE"), Val::Int(1), Val::Int(3)]), Ok(text("BCD")));
        assert_eq!(call("INDEX", &[text("ABC"), text("C")]), Ok(Val::Int(2)));
        assert_eq!(call("INDEX", &[text("ABC"), text("X")]), Ok(Val::Int(-1)));
        assert_eq!(call("NUMBER", &[text("-1.5EX2")]), Ok(Val::Real(-150.0)));
        assert_eq!(call("SPRINT", &[text("A%3DB%.2F"), Val::Int(7), Val::Real(1.5)]), Ok(text("A  7B1.50")));
    }
}
