//! Tools of a configuration, a line for each, with what the programs say of them.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::need::{FREE, Need, Place, WIDTH};
use super::tool_hints::Hint;

/// A tool of the configuration.
pub(super) struct ToolLine<'n> {
    /// It is known by its name, and its number is any that is free.
    pub is_named: bool,
    pub head: String,
    /// Its fields, each with what the user said of it.
    pub needs: Vec<(&'n Need, Option<&'n str>)>,
    /// What the programs say of it.
    pub hint: Option<&'n Hint>,
}

/// Tools as one table, a line for each: behind what its fields are, number, fields, what its name or its block says, place.
pub(super) fn tool_lines(text: &mut String, tools: Vec<ToolLine<'_>>) {
    // What holds for all tools may stand there already.
    if !text.lines().any(|line| line == "[tools]") {
        let _ = writeln!(text, "{}[tools]", if text.is_empty() { "" } else { "\n" });
    }
    let all = tools.iter().flat_map(|tool| &tool.needs);
    let fields: BTreeMap<&str, &Need> = all.map(|(need, _)| (need.answer.path[1].as_str(), *need)).collect();
    for (field, need) in fields.iter().filter(|(field, _)| **field != "name") {
        let what = match &need.choices()[..] {
            [_, _, ..] => need.choices().join(" or "),
            _ => need.wanted().trim_end_matches("; ").to_owned(),
        };
        let _ = writeln!(text, "# {field}: {what}");
    }
    for ToolLine { is_named, head, mut needs, hint } in tools {
        needs.sort_by_key(|(need, _)| need.answer.path[1] != "name");
        let fields: Vec<String> = needs
            .iter()
            .map(|(need, given)| match (given, &need.choices()[..]) {
                (Some(value), _) => format!("{} = {value}", need.answer.path[1]),
                (None, [only]) => format!("{} = {only}", need.answer.path[1]),
                (None, _) => format!("{} = ", need.answer.path[1]),
            })
            .collect();
        let is_whole = needs.iter().all(|(need, given)| given.is_some() || need.answer.path[1] == "name")
            && needs.iter().any(|(_, given)| given.is_some());
        let mark = if is_whole { "" } else { "#" };
        let entry = format!("{mark}{head} = {{ {} }}", fields.join(", "));
        let remark = if is_named { format!("{FREE}; ") } else { String::new() };
        let measured = needs.iter().any(|(need, _)| !matches!(need.answer.path[1].as_str(), "name" | "number"));
        let first = needs[0].0;
        let said = hint.filter(|_| measured).map_or_else(String::new, |hint| remark_of(hint, &first.first));
        let _ = writeln!(text, "{entry:WIDTH$} # {remark}{said}{}", first.places());
    }
}

/// What the programs say of a tool, and where it is called, unless that is the block that asks.
fn remark_of(hint: &Hint, asks: &Place) -> String {
    let said = hint.words();
    let said = if said.is_empty() { said } else { format!("{said}; ") };
    if hint.call == *asks {
        return said;
    }
    let Place { file, line, block } = &hint.call;
    format!("{said}called in {file}:{line} `{block}`, asked for by ")
}
