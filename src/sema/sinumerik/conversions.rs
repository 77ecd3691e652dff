//! Values as a variable takes them: its type, its limits, the length of its texts, the elements of an array.
//!
//! Source: S 5.1 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::parser::sinumerik::ast::TypeName;
use crate::text::Span;

use super::value::{NoValue, Val, type_name};
use super::vars::Var;
use super::{Core, Outcome};

/// Alarms of an assignment: a value of a wrong type, and one out of range.
pub(super) const ASSIGNED: [u32; 2] = [12150, 12560];
/// The same of DEF.
pub(super) const DEFINED: [u32; 2] = [12390, 12160];

/// What fills an array.
pub(super) enum Fill {
    Set(Vec<Val>),
    Repeat(Val, Option<usize>),
}

impl Val {
    /// The value as a variable of `kind` takes it, with the alarms for a wrong type and a value out of range.
    pub(super) fn taken_as(&self, kind: TypeName, alarms: [u32; 2], core: &Core<'_>, span: Span) -> Outcome<Val> {
        let fault = match self.converted(kind) {
            Ok(made) => {
                if kind == TypeName::Int {
                    says_negative_half(self, &made, core, span);
                }
                return Ok(made);
            }
            Err(NoValue::Type) => codes::P2024::does_not_become(&self.what(), &type_name(kind)).alarm(alarms[0]),
            Err(NoValue::Range) => codes::S2029::value_lies_outside_what_holds(&type_name(kind)).alarm(alarms[1]),
        };
        core.refuse(span, fault)
    }

    /// LLI and ULI; the alarms are those below and above.
    pub(super) fn keeps_limits(&self, limits: [Option<f64>; 2], alarms: [u32; 2]) -> Result<(), Fault> {
        let Some(number) = self.number() else { return Ok(()) };
        match limits {
            [Some(least), _] if number < least => {
                Err(codes::S2029::is_below_limit_lli(&number, &least).alarm(alarms[0]))
            }
            [_, Some(most)] if number > most => Err(codes::S2029::is_above_limit_uli(&number, &most).alarm(alarms[1])),
            _ => Ok(()),
        }
    }

    pub(super) fn keeps_length(&self, length: usize) -> Result<(), Fault> {
        match self {
            Val::Text(text) if text.len() > length => Err(codes::S2030::text_has_characters(&text.len(), &length)),
            _ => Ok(()),
        }
    }
}

/// The manuals say how positive halves are rounded.
pub(super) fn says_negative_half(from: &Val, made: &Val, core: &Core<'_>, span: Span) {
    if let (Some(value), Some(made)) = (from.number(), made.number())
        && value < 0.0
        && value.fract() == -0.5
    {
        let found = codes::S8107::is_rounded_to_manuals_do_not_say(&value, &made).at(core.loc(span));
        core.report_new(found.help("keep the value off the half"));
    }
}

impl Var {
    /// The array, filled from the element `start` on.
    pub(super) fn filled(mut self, start: usize, fill: &Fill, core: &Core<'_>, span: Span) -> Outcome<Var> {
        let room = self.values.len() - start.min(self.values.len());
        match fill {
            Fill::Set(list) => {
                if list.len() > room {
                    return core.refuse(span, codes::S2017::values_for_elements(&list.len(), &room));
                }
                for (at, value) in list.iter().enumerate().filter(|(_, value)| **value != Val::Missing) {
                    self.values[start + at] = value.taken_as(self.kind, ASSIGNED, core, span)?;
                    self.kept.knows(start + at);
                }
            }
            Fill::Repeat(value, count) => {
                let value = value.taken_as(self.kind, ASSIGNED, core, span)?;
                let count = count.unwrap_or(room);
                if count > room {
                    return core.refuse(span, codes::S2017::values_for_elements(&count, &room));
                }
                for (at, element) in self.values.iter_mut().enumerate().skip(start).take(count) {
                    *element = value.clone();
                    self.kept.knows(at);
                }
            }
        }
        Ok(self)
    }
}
