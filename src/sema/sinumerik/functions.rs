//! Functions of formulas.
//!
//! Source: reference section 5.2; angles are degrees.

use crate::geo::Deg;

use super::value::{Val, to_text, whole};

/// Why a function has no value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum NoResult {
    /// No such function.
    Unknown,
    /// Wrong number of arguments; how many it takes.
    Count(&'static str),
    /// An argument of the wrong type.
    Type,
    /// An argument outside what the function takes.
    Domain(&'static str),
}

use NoResult::{Count, Domain, Type, Unknown};

type Made = Result<Val, NoResult>;

/// Names that no variable can have.
pub(super) const NAMES: &[&str] = &[
    "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN2", "SQRT", "POT", "ABS", "LN", "EXP", "TRUNC", "ROUND", "ROUNDUP",
    "MINVAL", "MAXVAL", "BOUND", "ITOR", "BTOR", "RTOI", "BTOI", "RTOB", "ITOB", "AXNAME", "AXSTRING", "SPI", "ISAXIS",
    "STRLEN", "TOUPPER", "TOLOWER", "INDEX", "RINDEX", "MINDEX", "MATCH", "SUBSTR", "ISNUMBER", "NUMBER", "SPRINT",
    "CTRANS", "CFINE", "CROT", "CSCALE", "CMIRROR", "CRPL", "INVFRAME", "ISVAR", "ISFILE", "MODAXVAL", "SET", "REP",
];

/// Computes a function of plain values. Frame functions and those that need the program are elsewhere.
pub(super) fn call(name: &str, args: &[Val]) -> Made {
    match name {
        "SIN" | "COS" | "TAN" | "ASIN" | "ACOS" | "SQRT" | "POT" | "ABS" | "LN" | "EXP" | "TRUNC" | "ROUND"
        | "ROUNDUP" => one_real(name, args),
        "ATAN2" => {
            let [y, x] = two(args)?;
            Ok(Val::Real(libm::atan2(y, x).to_degrees()))
        }
        "MINVAL" | "MAXVAL" => min_max(name, args),
        "BOUND" => {
            let [low, high, value] = args else { return Err(Count("three arguments")) };
            let (l, h, v) = (real(low)?, real(high)?, real(value)?);
            if l > h {
                return Err(Domain("its lower bound is above its upper bound"));
            }
            Ok(if v < l {
                low.clone()
            } else if v > h {
                high.clone()
            } else {
                value.clone()
            })
        }
        "ITOR" | "BTOR" => Ok(Val::Real(real(one(args)?)?)),
        "RTOI" | "BTOI" => whole(real(one(args)?)?).map(Val::Int).ok_or(Domain("it fits no INT")),
        "RTOB" | "ITOB" => one(args)?.truth().map(Val::Bool).ok_or(Type),
        "AXSTRING" => match one(args)? {
            Val::Axis(axis) => Ok(Val::text(axis.bytes())),
            _ => Err(Type),
        },
        "SPI" => one(args).cloned(),
        "ISAXIS" => {
            let n = real(one(args)?)?;
            Ok(Val::Bool((1.0..=3.0).contains(&n)))
        }
        _ => text_function(name, args),
    }
}

fn one(args: &[Val]) -> Result<&Val, NoResult> {
    match args {
        [value] => Ok(value),
        _ => Err(Count("one argument")),
    }
}

fn two(args: &[Val]) -> Result<[f64; 2], NoResult> {
    match args {
        [a, b] => Ok([real(a)?, real(b)?]),
        _ => Err(Count("two arguments")),
    }
}

fn real(value: &Val) -> Result<f64, NoResult> {
    value.number().ok_or(Type)
}

fn one_real(name: &str, args: &[Val]) -> Made {
    let value = one(args)?;
    let v = real(value)?;
    let result = match name {
        "SIN" => Deg(v).sin_cos().0,
        "COS" => Deg(v).sin_cos().1,
        "TAN" => {
            let (sin, cos) = Deg(v).sin_cos();
            if cos == 0.0 {
                return Err(Domain("the tangent of 90 degrees is infinite"));
            }
            sin / cos
        }
        "ASIN" | "ACOS" => {
            if v.abs() > 1.0 {
                return Err(Domain("its argument lies outside -1 to 1"));
            }
            if name == "ASIN" { libm::asin(v).to_degrees() } else { libm::acos(v).to_degrees() }
        }
        "SQRT" if v < 0.0 => return Err(Domain("the root of a negative number does not exist")),
        "SQRT" => v.sqrt(),
        "POT" => v * v,
        "ABS" => {
            return Ok(match value {
                Val::Int(n) => Val::Int(n.checked_abs().ok_or(Domain("it fits no INT"))?),
                _ => Val::Real(v.abs()),
            });
        }
        "LN" if v <= 0.0 => return Err(Domain("a logarithm needs a number above 0")),
        "LN" => libm::log(v),
        "EXP" => libm::exp(v),
        "TRUNC" => libm::trunc(v),
        "ROUND" => libm::round(v),
        // Away from zero.
        _ => {
            if v < 0.0 {
                libm::floor(v)
            } else {
                libm::ceil(v)
            }
        }
    };
    Ok(Val::Real(result))
}

fn min_max(name: &str, args: &[Val]) -> Made {
    let [a, b] = args else { return Err(Count("two arguments")) };
    let (x, y) = (real(a)?, real(b)?);
    let first = if name == "MINVAL" { x <= y } else { x >= y };
    Ok(if first { a.clone() } else { b.clone() })
}

fn text_function(name: &str, args: &[Val]) -> Made {
    let bytes = |at: usize| -> Result<Vec<u8>, NoResult> {
        match args.get(at) {
            Some(Val::Text(text)) => Ok(text.to_vec()),
            Some(Val::Char(c)) => Ok(vec![*c]),
            Some(_) => Err(Type),
            None => Err(Count("more arguments")),
        }
    };
    let index = |found: Option<usize>| Val::Int(found.map_or(-1, |at| i32::try_from(at).unwrap_or(-1)));
    Ok(match name {
        "STRLEN" => Val::Int(bytes(0)?.len() as i32),
        "TOUPPER" => Val::text(&bytes(0)?.to_ascii_uppercase()),
        "TOLOWER" => Val::text(&bytes(0)?.to_ascii_lowercase()),
        "INDEX" | "RINDEX" => {
            let (text, what) = (bytes(0)?, bytes(1)?);
            let [wanted] = what.as_slice() else { return Err(Domain("it looks for one character")) };
            index(if name == "INDEX" {
                text.iter().position(|c| c == wanted)
            } else {
                text.iter().rposition(|c| c == wanted)
            })
        }
        "MINDEX" => {
            let (text, any) = (bytes(0)?, bytes(1)?);
            index(text.iter().position(|c| any.contains(c)))
        }
        "MATCH" => {
            let (text, part) = (bytes(0)?, bytes(1)?);
            let found = if part.is_empty() { Some(0) } else { text.windows(part.len()).position(|w| w == part) };
            index(found)
        }
        "SUBSTR" => {
            let text = bytes(0)?;
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
            Val::text(&text[from..from + len])
        }
        "ISNUMBER" => Val::Bool(number_of(&bytes(0)?).is_some()),
        "NUMBER" => Val::Real(number_of(&bytes(0)?).ok_or(Domain("the text is no number"))?),
        "SPRINT" => Val::text(&sprint(args)?),
        _ => return Err(Unknown),
    })
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
        let Some((kind, behind)) = behind.split_first() else { return Err(Domain("its format ends behind %")) };
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
