//! What programs ask of the tool management: GETT, GETEXET, GETSELT, `$TC_…`, `$P_TOOL…`.
//!
//! Comes in: the question. Goes out: what the program or the tool table says; for anything else an error that asks for it by the
//! tool and the fact. No answer is made up.
//!
//! Source: S 5.7 (docs/sources.md).

use crate::diag::{Answer, Fault, Help, codes};
use crate::machine::tools::{ToolKey, Tools};
use crate::machine::{Settings, Tool};

use super::State;
use super::machine_place::ToolLength;
use super::tool::ToolInUse;
use super::value::{Val, whole};

/// `GETT("NAME",1)`: the name of the tool whose number is asked for, and of its sister by the second argument.
pub(super) fn named_tool(args: &[Val]) -> Result<String, Fault> {
    let (name, sister) = match args {
        [Val::Text(name)] => (name, Some(1)),
        [Val::Text(name), sister] => (name, sister.number().and_then(whole)),
        _ => return Err(codes::S2021::gett_takes_name_of_tool()),
    };
    let name = String::from_utf8_lossy(name).into_owned();
    if sister == Some(1) { Ok(name) } else { Err(codes::P9010::gett_asks_for_sister(&name)) }
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
