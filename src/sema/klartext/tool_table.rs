//! Tools as blocks name them: out of the tool table, TOOL DEF, and the numbers proposed for those without one.

use std::cell::RefCell;

use rustc_hash::FxHashMap;

use crate::diag::{Answer, codes};
use crate::lexer::klartext::Value;
use crate::machine::tools::ToolKey;
use crate::machine::{Proposed, Tool};
use crate::parser::klartext::ast::{Addr, Word};
use crate::text::Span;

use super::active_tool::ActiveTool;
use super::reading::Reading;
use super::vars::Val;
use super::{Core, Outcome};

/// Highest tool number.
const MOST_TOOLS: f64 = 32767.0;
/// How far two radii of one tool may lie apart by rounding, in mm: a value in inches has no whole micrometre.
const SAME_RADIUS: f64 = 0.001 + 1e-9;

/// A tool as a block names it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Named {
    Number(u32, u8),
    Name(String),
}

impl std::fmt::Display for Named {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Named::Number(n, 0) => write!(f, "{n}"),
            Named::Number(n, index) => write!(f, "\"{n}.{index}\""),
            Named::Name(name) => write!(f, "\"{name}\""),
        }
    }
}

impl Named {
    /// TOOL CALL 0 takes the tool out.
    pub fn is_none(&self) -> bool {
        *self == Named::Number(0, 0)
    }

    /// The tool that the first word names, and the words behind it.
    pub fn first<'w>(reading: Reading<'_, '_>, words: &'w [Word], text: &[u8]) -> Outcome<Option<(Named, &'w [Word])>> {
        let Some((&first, rest)) = words.split_first() else { return Ok(None) };
        let name = |bytes: &[u8]| Named::Name(crate::text::decode::readable(bytes).trim_matches('"').to_owned());
        let tool = match (first.addr, first.value) {
            (Addr::Text, _) => name(first.span.of(text)),
            (Addr::Value, Value::Param { q, .. }) if q.is_text() => match reading.read(q, first.span)? {
                Val::Text(text) => Named::Name(String::from_utf8_lossy(&text).into_owned()),
                _ => return reading.core.refuse(first.span, codes::P2024::text_parameter_is_needed()),
            },
            (Addr::Value, Value::Number(_)) => Named::number(reading.core, first.span.of(text), first.span)?,
            (Addr::Value, value) => {
                let n = reading.number(value, first.span)?;
                Named::number(reading.core, format!("{n}").as_bytes(), first.span)?
            }
            _ => return Ok(None),
        };
        Ok(Some((tool, rest)))
    }

    /// `5` or `5.2`.
    fn number(core: &Core<'_>, digits: &[u8], span: Span) -> Outcome<Named> {
        let text = String::from_utf8_lossy(digits);
        let text = text.trim_start_matches('+');
        let (number, index) = text.split_once(['.', ',']).unwrap_or((text, ""));
        let index = if index.trim_end_matches('0').is_empty() { Ok(0) } else { index.parse() };
        match (number.parse::<u32>(), index) {
            (Ok(number), Ok(index)) if f64::from(number) <= MOST_TOOLS => Ok(Named::Number(number, index)),
            _ => core.refuse(span, codes::K2010::is_no_tool_number(&text)),
        }
    }
}

/// What the program says of tools, and what is proposed for them.
#[derive(Debug, Default)]
pub(super) struct Tools {
    /// Length and radius of TOOL DEF, in mm.
    defined: FxHashMap<u32, (Option<f64>, Option<f64>)>,
    /// Numbers proposed for tools without one.
    proposed: RefCell<Proposed>,
}

impl Tools {
    /// TOOL DEF with its length and radius.
    pub fn define(&mut self, number: u32, length: Option<f64>, radius: Option<f64>) {
        self.defined.insert(number, (length, radius));
    }

    /// Length and radius that TOOL DEF gives.
    pub fn defined(&self, number: u32) -> Option<(Option<f64>, Option<f64>)> {
        self.defined.get(&number).copied()
    }

    /// The tool that a TOOL CALL names, with the oversizes of its call; its sizes are not known where they were `measured`.
    pub fn called(
        &self,
        core: &Core<'_>,
        tool: &Named,
        deltas: [Option<f64>; 3],
        measured: bool,
        span: Span,
    ) -> Outcome<ActiveTool> {
        let (number, data) = self.look_up(core, tool, span)?;
        let (mut length, mut radius, mut corner_radius) = (data.length, data.radius, data.corner_radius);
        if let Named::Number(n, 0) = tool {
            if let Some((l, r)) = self.defined(*n) {
                length = l.or(length);
                radius = r.or(radius);
            }
            if *n == 0 {
                (length, radius) = (Some(0.0), Some(0.0));
            }
        }
        let mut other_radius = data.radius.filter(|table| radius.is_some_and(|own| differs(own, *table)));
        if measured {
            other_radius = None;
            (length, radius, corner_radius) = (None, None, None);
        }
        let own = match tool {
            Named::Number(own, _) => Some(*own),
            Named::Name(name) => match core.job.settings.tools.key_of_name(name, false) {
                Some(ToolKey::Number(own, _)) => Some(*own),
                _ => None,
            },
        };
        Ok(ActiveTool {
            number,
            own,
            called: tool.to_string(),
            radius,
            length,
            other_radius,
            corner_radius,
            plunge_angle: data.plunge_angle,
            teeth: data.teeth,
            tip_angle: data.tip_angle,
            table_deltas: data.deltas,
            call_deltas: deltas.map(Option::unwrap_or_default),
        })
    }

    /// The radius of a tool by its number, with the oversize of the table, where it is known.
    pub fn radius_of(&self, core: &Core<'_>, number: u32) -> Option<f64> {
        let data = core.job.settings.tools.by_number(number, 0);
        let own = self.defined(number).and_then(|(_, radius)| radius);
        let radius = own.or_else(|| data.and_then(|data| data.radius))?;
        Some(radius + data.map_or(0.0, |data| data.deltas[1]))
    }

    /// Number to print and data of a tool.
    pub fn look_up(&self, core: &Core<'_>, tool: &Named, span: Span) -> Outcome<(u32, Tool)> {
        let tools = &core.job.settings.tools;
        match tool {
            Named::Number(number, index) => {
                let data = tools.by_number(*number, *index);
                if data.is_none() && tools.complete && *number != 0 && !self.defined.contains_key(number) {
                    core.say(span, codes::P2006::tool_is_not_in_tool_table(&tool));
                }
                self.proposed.borrow_mut().call(*number);
                let data = data.cloned().unwrap_or_default();
                let printed = data.number.or((*index == 0).then_some(*number));
                match printed {
                    Some(printed) => {
                        core.prints_tool(&ToolKey::Number(*number, *index), printed, span)?;
                        Ok((printed, data))
                    }
                    None => core.refuse(
                        span,
                        codes::K2006::tool_is_index(&number, &index, &tool).answer(Answer::tool(tool, "number")),
                    ),
                }
            }
            Named::Name(name) => match tools.by_name(name) {
                Some((Some(number), data)) => {
                    if let Some(key) = tools.key_of_name(name, false) {
                        core.prints_tool(key, number, span)?;
                    }
                    Ok((number, data.clone()))
                }
                _ => {
                    let help = self.proposed.borrow_mut().help(name, tools);
                    core.refuse(span, codes::K2005::tool_has_no_number(&tool).help(help))
                }
            },
        }
    }
}

/// Are these two radii, or one that was computed and rounded?
fn differs(a: f64, b: f64) -> bool {
    (a - b).abs() > SAME_RADIUS
}
