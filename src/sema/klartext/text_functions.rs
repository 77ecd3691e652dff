//! Functions of texts.

use crate::parser::klartext::ast::TextFn;
use crate::sema::value::{Fault, Machine};

use super::vars::Val;

/// Longest text a parameter holds.
const LONGEST: usize = 255;

fn said<T>(why: impl Into<String>) -> Result<T, Fault> {
    Err(Fault::Said(why.into()))
}

fn text(machine: &mut Machine) -> Result<String, Fault> {
    match machine.pop()? {
        Val::Text(text) => Ok(String::from_utf8_lossy(&text).into_owned()),
        _ => said("a text parameter is needed"),
    }
}

fn number(machine: &mut Machine) -> Result<f64, Fault> {
    machine.pop()?.number().map_or_else(|| said("a number is needed"), Ok)
}

fn count(n: f64) -> Result<usize, Fault> {
    if n >= 0.0 && n.fract() == 0.0 { Ok(n as usize) } else { said(format!("{n} is no position")) }
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
            let Ok(value) = plain.parse::<f64>() else { return said(format!("`{text}` is no number")) };
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
        TextFn::Unknown => return said("the function reads from the control"),
    })
}

/// Two texts in one.
pub(super) fn join(machine: &mut Machine) -> Result<Val, Fault> {
    let (b, a) = (machine.pop()?, machine.pop()?);
    let (Val::Text(a), Val::Text(b)) = (a, b) else { return said("a text is needed") };
    if a.len() + b.len() > LONGEST {
        return said(format!("the text is longer than {LONGEST} characters"));
    }
    Ok(Val::Text([a, b].concat().into()))
}
