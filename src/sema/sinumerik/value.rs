//! Values of variables and formulas, their types and conversions.
//!
//! Source: S 5.1 and 5.2 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Fault, codes};
use crate::parser::sinumerik::ast::TypeName;
pub(super) use crate::sema::value::whole;

use crate::sema::value::Rules;

use super::axis_names::NamedAxis;
use super::frames::FrameValue;

/// Relative difference up to which two REAL values are equal.
const EQUAL: f64 = 1e-12;

/// Whole numbers, truth and texts are types of their own.
pub(super) const RULES: Rules = Rules { equal: EQUAL, typed: true, ..Rules::USUAL };

/// Highest R parameter.
pub(super) const MOST_R: u32 = 32_534;

/// Longest text of a variable.
pub(super) const MOST_TEXT: usize = 400;

/// A value of a formula.
pub(super) type Val = crate::sema::value::Val<NamedAxis, Rc<FrameValue>>;

impl Val {
    /// The start value of a type.
    pub(super) fn zero(kind: TypeName) -> Val {
        match kind {
            TypeName::Int => Val::Int(0),
            TypeName::Real => Val::Real(0.0),
            TypeName::Bool => Val::Bool(false),
            TypeName::Char => Val::Char(0),
            TypeName::String => Val::text(b""),
            // An axis variable names no axis until it is set.
            TypeName::Axis => Val::Missing,
            TypeName::Frame => Val::Frame(Rc::new(FrameValue::default())),
        }
    }

    /// The value as one of `kind`.
    pub(super) fn converted(&self, kind: TypeName) -> Result<Val, NoValue> {
        let converted = match (kind, self) {
            (TypeName::Int, Val::Int(_))
            | (TypeName::Real, Val::Real(_))
            | (TypeName::Bool, Val::Bool(_))
            | (TypeName::Char, Val::Char(_))
            | (TypeName::String, Val::Text(_))
            | (TypeName::Axis, Val::Axis(_))
            | (TypeName::Frame, Val::Frame(_)) => self.clone(),
            (TypeName::Bool, value) => Val::Bool(value.truth().ok_or(NoValue::Type)?),
            (TypeName::Int, value) => Val::Int(whole(value.number().ok_or(NoValue::Type)?).ok_or(NoValue::Range)?),
            (TypeName::Real, value) => Val::Real(value.number().ok_or(NoValue::Type)?),
            (TypeName::Char, Val::Text(text)) => match text.as_ref() {
                [one] => Val::Char(*one),
                _ => return Err(NoValue::Range),
            },
            (TypeName::Char, value) => {
                let n = whole(value.number().ok_or(NoValue::Type)?).ok_or(NoValue::Range)?;
                Val::Char(u8::try_from(n).map_err(|_| NoValue::Range)?)
            }
            (TypeName::String, Val::Char(c)) => Val::text(&[*c]),
            _ => return Err(NoValue::Type),
        };
        Ok(converted)
    }

    /// The number that is needed.
    pub(super) fn as_number(&self) -> Result<f64, Fault> {
        match self.number() {
            Some(v) if v.is_finite() => Ok(v),
            Some(_) => Err(codes::P2022::value_is_infinite()),
            None => Err(codes::P2024::number_is_needed(&self.what())),
        }
    }

    fn as_index(&self) -> Result<i32, Fault> {
        let fault = || codes::S2018::index_is_whole_number_this_is(&self.what());
        self.number().and_then(whole).ok_or_else(fault)
    }
}

/// Indices of an array, as whole numbers.
pub(super) fn indices(args: &[Val]) -> Result<Vec<i32>, Fault> {
    args.iter().map(Val::as_index).collect()
}

/// The number of an R parameter.
pub(super) fn r_index(args: &[Val]) -> Result<u32, Fault> {
    let [index] = args else {
        indices(args)?;
        return Err(codes::S2018::r_parameter_has_one_index());
    };
    let index = index.as_index()?;
    let number = u32::try_from(index).ok().filter(|n| *n <= MOST_R);
    number.ok_or_else(|| codes::S2018::there_is_no_parameter_r(&index))
}

/// Why a value does not become one of another type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoValue {
    Type,
    Range,
}

/// Name of a type.
pub(super) fn type_name(kind: TypeName) -> &'static str {
    match kind {
        TypeName::Int => "INT",
        TypeName::Real => "REAL",
        TypeName::Bool => "BOOL",
        TypeName::Char => "CHAR",
        TypeName::String => "STRING",
        TypeName::Axis => "AXIS",
        TypeName::Frame => "FRAME",
    }
}

/// A value as `<<` writes it.
pub(super) fn to_text(value: &Val) -> Option<Vec<u8>> {
    Some(match value {
        Val::Int(n) => n.to_string().into_bytes(),
        Val::Real(v) => real_text(*v).into_bytes(),
        Val::Bool(b) => vec![if *b { b'1' } else { b'0' }],
        Val::Char(c) => vec![*c],
        Val::Text(text) => text.to_vec(),
        Val::Axis(axis) => axis.bytes().to_vec(),
        Val::Frame(_) | Val::List(_) | Val::Missing => return None,
    })
}

/// Up to ten decimal places without zeros at the end.
fn real_text(value: f64) -> String {
    let text = format!("{value:.10}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversions() {
        assert_eq!(Val::Real(2.5).converted(TypeName::Int), Ok(Val::Int(3)));
        assert_eq!(Val::Real(-2.5).converted(TypeName::Int), Ok(Val::Int(-2)));
        assert_eq!(Val::Real(3e10).converted(TypeName::Int), Err(NoValue::Range));
        assert_eq!(Val::text(b"").converted(TypeName::Bool), Ok(Val::Bool(false)));
        assert_eq!(Val::text(b"A").converted(TypeName::Char), Ok(Val::Char(b'A')));
        assert_eq!(Val::text(b"12").converted(TypeName::Real), Err(NoValue::Type));
        assert_eq!(to_text(&Val::Real(1.5)), Some(b"1.5".to_vec()));
        assert_eq!(to_text(&Val::Real(-0.0)), Some(b"0".to_vec()));
    }
}
