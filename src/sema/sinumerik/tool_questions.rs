//! What programs ask of the tool management: GETT, GETEXET, GETSELT, `$TC_…`, `$P_TOOL…`.
//!
//! Comes in: the question. Goes out: what the program or the tool table says; for anything else an error that asks for it by the
//! tool and the fact. No answer is made up.
//!
//! Source: S 5.7 (docs/sources.md).

use crate::diag::{Answer, Help, codes};
use crate::machine::tools::{ToolKey, Tools};
use crate::machine::{Settings, Tool};
use crate::parser::sinumerik::ast::{Block, Formula};
use crate::text::Span;

use super::machine_place::ToolLength;
use super::state::State;
use super::system_meanings::meaning_of;
use super::tool::ToolInUse;
use super::value::{Val, whole};
use super::{Outcome, Run};

impl Run<'_> {
    /// `GETT("NAME",1)`: the number of a tool by its name, and of its sister by the second argument.
    pub(super) fn number_of_named_tool(&mut self, args: &[Val], span: Span) -> Outcome<Val> {
        let (name, sister) = match args {
            [Val::Text(name)] => (name, Some(1)),
            [Val::Text(name), sister] => (name, sister.number().and_then(whole)),
            _ => {
                return self.channel.core.refuse(span, codes::S2021::gett_takes_name_of_tool());
            }
        };
        let name = String::from_utf8_lossy(name).into_owned();
        if sister != Some(1) {
            return self.channel.core.refuse(span, codes::P9010::gett_asks_for_sister(&name));
        }
        if let Some(number) = self.channel.st.system.tool_named(&name) {
            return Ok(Val::Int(i32::try_from(number).unwrap_or(0)));
        }
        let number = self.channel.tool_by_name(&name, span)?;
        Ok(Val::Int(i32::try_from(number).unwrap_or(0)))
    }

    /// `GETEXET(T,1)`: the tool in use. `GETSELT(T,1)`: the one that T has chosen.
    pub(super) fn asks_for_tool(
        &mut self,
        name: &str,
        formulas: &[Formula],
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let [variable, spindle @ ..] = formulas else {
            return self.channel.core.refuse(span, codes::S2021::lacks_variable_that_takes_tool(&name));
        };
        if let Some(spindle) = spindle.first().filter(|formula| !formula.is_missing()) {
            let number = self.number(*spindle, block, text)?;
            if whole(number) != Some(i32::from(self.channel.st.spindles.master())) {
                return self.channel.core.refuse(spindle.span, codes::P9010::asks_for_tool_of_spindle(&name, &number));
            }
        }
        let tool = &self.channel.st.tool;
        let (number, variable_name) = match name {
            "GETSELT" => (tool.next().or(tool.active()), "$P_TOOLP"),
            _ => (tool.active(), "$P_TOOLNO"),
        };
        let given = || self.channel.core.job.settings.variables.get(variable_name).copied().and_then(whole);
        let Some(number) = number.and_then(|number| i32::try_from(number).ok()).or_else(given) else {
            let meaning = meaning_of(variable_name, &[]).unwrap_or_default();
            let help = format!("select a tool before it, or give it under [variables]: \"{variable_name}\" = number");
            return self.channel.core.refuse(
                span,
                codes::P2023::asks_for_program_has_selected_none(&name, &meaning)
                    .help(Answer::variable(variable_name, meaning).help(help)),
            );
        };
        match self.reference(*variable, block, text)? {
            Some(reference) => {
                self.set_reference(reference, number);
                Ok(())
            }
            None => self.channel.core.refuse(variable.span, codes::S2021::needs_variable(&name)),
        }
    }
}

impl State {
    /// What the tool table knows of an edge: `$TC_DP3[t,1]`, `$P_AD[6]`, `$P_TOOLL[1]`; lengths in mm.
    pub(super) fn table_value(&self, settings: &Settings, word: &str, args: &[Val]) -> Option<f64> {
        if word == "$P_TOOLL"
            && let ToolLength::Known(length) = self.active_length(settings)
        {
            return Some(length).filter(|_| matches!(args, [first] if first.number() == Some(1.0)));
        }
        let (number, parameter) = self.tool.asked_parameter(word, args)?;
        let tool = settings.tools.called(number)?;
        let told = |delta: f64| Some(delta).filter(|delta| *delta != 0.0);
        match parameter {
            2 => tool.orientation.map(f64::from),
            3 => tool.length,
            6 => tool.radius,
            7 => tool.corner_radius,
            12 => told(tool.deltas[0]),
            15 => told(tool.deltas[1]),
            _ => None,
        }
    }
}

impl ToolInUse {
    /// The tool and the parameter of its edge 1 that a name asks for.
    fn asked_parameter(&self, word: &str, args: &[Val]) -> Option<(u32, i32)> {
        let numbers: Vec<i32> = args.iter().map(|arg| arg.number().and_then(whole)).collect::<Option<_>>()?;
        let active = || self.active().filter(|_| self.edge_or_first() == 1);
        match (word, numbers.as_slice()) {
            ("$P_AD", [parameter]) => Some((active()?, *parameter)),
            ("$P_TOOLL", [1]) => Some((active()?, 3)),
            (_, [tool, 1]) => Some((u32::try_from(*tool).ok()?, word.strip_prefix("$TC_DP")?.parse().ok()?)),
            _ => None,
        }
    }
}

/// Name and existence of a tool, as far as the tool table says.
pub(super) fn told_of_tool(tools: &Tools, word: &str, args: &[Val]) -> Option<Val> {
    let [number] = args else { return None };
    let number = u32::try_from(number.number().and_then(whole)?).ok()?;
    match word {
        "$TC_TP2" => {
            let named = |(key, tool): (&ToolKey, &Tool)| match key {
                ToolKey::Name(name) if tool.number == Some(number) => Some(name.clone()),
                _ => None,
            };
            let own = tools.by_number(number, 0).and_then(|tool| tool.name.clone());
            own.or_else(|| tools.table.iter().find_map(named)).map(|name| Val::text(name.as_bytes()))
        }
        "$P_TOOLEXIST" if tools.called(number).is_some() => Some(Val::Bool(true)),
        "$P_TOOLEXIST" if tools.complete => Some(Val::Bool(false)),
        _ => None,
    }
}

/// How to tell what is asked for: a field of the tool, where one says it.
pub(super) fn tool_is_asked(tools: &Tools, tool: &ToolInUse, word: &str, args: &[Val], key: &str) -> Option<Help> {
    let first = || args.first()?.number().and_then(whole).and_then(|number| u32::try_from(number).ok());
    let (number, field) = match word {
        "$TC_TP2" => (first()?, "name"),
        "$P_TOOLR" => (tool.active().filter(|_| tool.edge_or_first() == 1)?, "radius"),
        _ => {
            let (number, parameter) = tool.asked_parameter(word, args)?;
            let field = match parameter {
                2 => "orientation",
                3 => "length",
                6 => "radius",
                7 => "corner_radius",
                _ => return None,
            };
            (number, field)
        }
    };
    if number == 0 {
        return None;
    }
    let named = |(key, named): (&ToolKey, &Tool)| matches!(key, ToolKey::Name(_)) && named.number == Some(number);
    let own = ToolKey::Number(number, 0);
    let entry = if tools.table.contains_key(&own) { None } else { tools.table.iter().find(|entry| named(*entry)) };
    let name = match entry.map(|(key, _)| key) {
        Some(ToolKey::Name(name)) => name.clone(),
        _ => number.to_string(),
    };
    let shown = if entry.is_some() { format!("\"{name}\"") } else { name.clone() };
    let value = match field {
        "name" => "\"…\"",
        _ => "…",
    };
    let or = if field == "name" { String::new() } else { format!("; or under [variables]: \"{key}\" = value") };
    Some(Answer::tool(name, field).help(format!("give it: `[tools.{shown}] {field} = {value}`{or}")))
}
