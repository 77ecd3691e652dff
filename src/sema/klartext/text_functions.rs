//! Functions of texts.

use crate::diag::codes;
use crate::parser::klartext::ast::TextFn;
use crate::sema::value::{Fault, Machine};

use super::vars::Val;

/// Longest text a parameter holds.
const LONGEST: usize = 255;

fn text(machine: &mut Machine) -> Result<String, Fault> {
    match machine.pop()? {
        Val::Text(text) => Ok(String::from_utf8_lossy(&text).into_owned()),
        _ => Err(codes::P2022::text_parameter_is_needed().into()),
    }
}

fn number(machine: &mut Machine) -> Result<f64, Fault> {
    machine.pop()?.number().ok_or_else(|| codes::P2022::number_is_needed().into())
}

fn count(n: f64) -> Result<usize, Fault> {
    if n >= 0.0 && n.fract() == 0.0 { Ok(n as usize) } else { Err(codes::P2022::is_no_position(&n).into()) }
}

/// Applies a text function to its arguments, the last one on top.
pub(super) fn apply(f: TextFn, machine: &mut Machine) -> Result<Val, Fault> {
    Ok(match f {
        TextFn::ToChar => {
            let (decimals, value) = (number(machine)?, number(machine)?);
            let places = if decimals < 0.0 { 0 } else { count(decimals)?.min(9) };
            Val::text(format!("{value:.places$}").as_bytes())
        }
        TextFn::ToNumber => {
            let text = text(machine)?;
            let plain = text.trim().replace(',', ".");
            let value: f64 = plain.parse().map_err(|_| codes::P2022::is_no_number(&text))?;
            if !(value.is_finite() && value.abs() <= machine.rules.step) {
                return Err(Fault::TooLarge);
            }
            Val::Real(value)
        }
        TextFn::Substring => {
            let (len, begin) = (count(number(machine)?)?, count(number(machine)?)?);
            Val::text(text(machine)?.chars().skip(begin).take(len).collect::<String>().as_bytes())
        }
        TextFn::Find => {
            let begin = count(number(machine)?)?;
            let (wanted, text) = (text(machine)?, text(machine)?);
            let rest: String = text.chars().skip(begin).collect();
            let at = rest.find(&*wanted).map_or(text.chars().count(), |at| begin + rest[..at].chars().count());
            Val::Real(at as f64)
        }
        TextFn::Length => Val::Real(text(machine)?.chars().count() as f64),
        TextFn::Compare => {
            let (b, a) = (text(machine)?, text(machine)?);
            Val::Real(f64::from(a.cmp(&b) as i8))
        }
        TextFn::Unknown => return Err(codes::P2022::function_reads_from_control().into()),
    })
}

/// Two texts in one.
pub(super) fn join(machine: &mut Machine) -> Result<Val, Fault> {
    let (b, a) = (machine.pop()?, machine.pop()?);
    let (Val::Text(a), Val::Text(b)) = (a, b) else {
        return Err(codes::P2022::text_is_needed().into());
    };
    if a.len() + b.len() > LONGEST {
        return Err(codes::P2022::text_is_longer(&LONGEST).into());
    }
    Ok(Val::Text([a, b].concat().into()))
}
