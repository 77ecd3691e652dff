//! Tools of a configuration, a line for each, with what the programs say of them.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::answers::Needs;
use super::need::{FREE, Need, Place, WIDTH};
use super::tool_hints::Hint;

/// Tools as one table, a line for each: behind what its fields are, number, fields, what its name or its block says, place.
pub(super) fn tool_lines(text: &mut String, all: &Needs, heads: &[(bool, String)], tools: &[Vec<&Need>]) {
    // What holds for all tools may stand there already.
    if !text.lines().any(|line| line == "[tools]") {
        let _ = writeln!(text, "{}[tools]", if text.is_empty() { "" } else { "\n" });
    }
    let fields: BTreeMap<&str, &Need> =
        tools.iter().flatten().map(|need| (need.answer.path[1].as_str(), *need)).collect();
    for (field, need) in fields.iter().filter(|(field, _)| **field != "name") {
        let what = match &need.choices()[..] {
            [_, _, ..] => need.choices().join(" or "),
            _ => need.wanted().trim_end_matches("; ").to_owned(),
        };
        let _ = writeln!(text, "# {field}: {what}");
    }
    for ((is_named, head), needs) in heads.iter().zip(tools) {
        let name_first = |need: &&&Need| need.answer.path[1] != "name";
        let mut needs: Vec<&&Need> = needs.iter().collect();
        needs.sort_by_key(name_first);
        let fields: Vec<String> = needs
            .iter()
            .map(|need| match (all.of_tool(need), &need.choices()[..]) {
                (Some(value), _) => format!("{} = {value}", need.answer.path[1]),
                (None, [only]) => format!("{} = {only}", need.answer.path[1]),
                (None, _) => format!("{} = ", need.answer.path[1]),
            })
            .collect();
        let is_whole = needs.iter().all(|need| all.of_tool(need).is_some() || need.answer.path[1] == "name")
            && needs.iter().any(|need| all.of_tool(need).is_some());
        let mark = if is_whole { "" } else { "#" };
        let entry = format!("{mark}{head} = {{ {} }}", fields.join(", "));
        let remark = if *is_named { format!("{FREE}; ") } else { String::new() };
        let measured = needs.iter().any(|need| !matches!(need.answer.path[1].as_str(), "name" | "number"));
        let hint = all.hint_of(needs[0]).filter(|_| measured);
        let said = hint.map_or_else(String::new, |hint| remark_of(hint, &needs[0].first));
        let _ = writeln!(text, "{entry:WIDTH$} # {remark}{said}{}", needs[0].places());
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
