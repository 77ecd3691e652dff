//! Tools of a configuration, a line for each, and what their names say of them.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::answers::{FREE, Need, Needs, WIDTH};

/// Tools as one table, a line for each: behind what its fields are, number, fields, what its name or its block says, place.
pub(super) fn tool_lines(text: &mut String, all: &Needs, heads: &[(bool, String)], tools: &[Vec<&Need>]) {
    let _ = writeln!(text, "{}[tools]", if text.is_empty() { "" } else { "\n" });
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
        let said = needs.iter().any(|need| need.answer.path[1] == "radius").then(|| radius_in(needs[0])).flatten();
        let said = said.map_or_else(String::new, |radius| format!("radius {radius}, by its name?; "));
        let _ = writeln!(text, "{entry:WIDTH$} # {remark}{said}{}", needs[0].places());
    }
}

/// The radius that the name of a tool, or the comment of its block, seems to carry: `MILL_D10`, `DR_R0.8K95`, `end mill 10 mm`.
pub(super) fn radius_in(need: &Need) -> Option<f64> {
    let name = need.choices().into_iter().next().unwrap_or_default();
    [name.as_str(), need.first.block.as_str()].into_iter().find_map(radius_of)
}

fn radius_of(text: &str) -> Option<f64> {
    let text = text.to_uppercase();
    let number = |at: usize| -> Option<(f64, usize)> {
        let digits = text[at..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |end| at + end);
        Some((text[at..digits].trim_end_matches('.').parse().ok()?, digits))
    };
    let starts = |letter: char| {
        let text = &text;
        text.match_indices(letter).filter(move |(at, _)| !text[..*at].ends_with(|c: char| c.is_alphanumeric()))
    };
    let after = |letter: char| starts(letter).find_map(|(at, sign)| number(at + sign.len()));
    let of_unit = || {
        let (before, _) = text.split_once(" MM").or_else(|| text.split_once("MM"))?;
        let from = before.rfind(|c: char| !c.is_ascii_digit() && c != '.').map_or(0, |at| at + 1);
        let is_cutter = ["MILL", "DRILL", "CUTTER", "FR", "BOHR"].iter().any(|word| before.contains(word));
        if is_cutter && before.is_char_boundary(from) { number(from) } else { None }
    };
    let radius = after('R').map(|(value, _)| value);
    let diameter = || after('D').or_else(|| after('Ø')).or_else(of_unit).map(|(value, _)| value / 2.0);
    radius.or_else(diameter).filter(|radius| *radius > 0.0 && *radius < 500.0)
}

#[cfg(test)]
mod tests {
    use super::radius_of;

    #[test]
    fn names_of_tools_carry_radii() {
        for (text, radius) in [
            ("\"FS_D10\"", Some(5.0)),
            ("\"DR_R0.8K95E80\"", Some(0.8)),
            ("TOOL CALL 5 Z S2000 ; end mill 10 mm", Some(5.0)),
            ("T1 M6 ; Schaftfraeser D12", Some(6.0)),
            ("TOOL CALL 5 Z S2000 DR+0.2", None),
            ("\"DRILL\"", None),
            ("Ø8.5 BOHRER", Some(4.25)),
        ] {
            assert_eq!(radius_of(text), radius, "{text}");
        }
    }
}
