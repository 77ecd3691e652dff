//! The configuration in force as text: a `partc.toml` that says the same, with the place each value comes from.

use std::fmt::Write as _;

use serde_json::{Map, json};

use super::keys::{Key, Kind, SECTIONS, Section};
use super::schema::plain;
use super::tree::{Node, Table, Value};

/// Width of what stands in front of the place.
const WIDTH: usize = 36;

/// `tree` with the defaults of what it does not set, as TOML. Keys without a value are comments.
pub fn toml(tree: &Table) -> String {
    toml_of(tree, None)
}

/// Dialects of the groups of keys of `[control]`; the first group is for all.
const OWNERS: &[&str] = &["", "klartext", "heidenhain-turning", "sinumerik", "mtc200"];

/// The same without the keys that other languages than `dialect` have, unless they are set.
pub fn toml_of(tree: &Table, dialect: Option<&str>) -> String {
    let mut text = String::new();
    for section in SECTIONS {
        let _ = writeln!(text, "{}[{}]", if text.is_empty() { "" } else { "\n" }, section.name);
        let table = table_of(tree, section);
        for (group, key) in section.keys.iter().enumerate().flat_map(|(at, keys)| keys.iter().map(move |key| (at, key)))
        {
            let owner = OWNERS.get(group).filter(|owner| section.name == "control" && !owner.is_empty());
            let is_foreign = dialect.is_some_and(|dialect| owner.is_some_and(|owner| *owner != dialect));
            let all = values(key);
            match (table.and_then(|table| table.get(key.name)), key.default_node()) {
                (Some(node), _) => line(&mut text, key.name, node, &(place(node) + &all)),
                _ if is_foreign => {}
                (None, Some(node)) if key.warns => {
                    let place = format!("in use, with a warning until it is set{all}");
                    line(&mut text, &format!("# {}", key.name), &node, &place);
                }
                (None, Some(node)) => line(&mut text, key.name, &node, &format!("default{all}")),
                (None, None) => {
                    let _ = writeln!(text, "{:WIDTH$}  # not set: {}{all}", format!("# {} =", key.name), key.doc);
                }
            }
        }
        let named = named(table, section);
        for (name, node) in named.iter().filter(|(_, node)| !matches!(node.value, Value::Table(_))) {
            line(&mut text, name, node, &place(node));
        }
        for (name, node) in named {
            if let Value::Table(inner) = &node.value {
                let _ = writeln!(text, "[{}.{}]", section.name, quoted_key(name));
                for (name, node) in inner {
                    line(&mut text, name, node, &place(node));
                }
            }
        }
    }
    text
}

/// All values of a key that chooses between some.
fn values(key: &Key) -> String {
    match key.kind {
        Kind::Choice(values) => format!("; one of {}", values.join(", ")),
        _ => String::new(),
    }
}

/// The same as JSON: by section and key the value, and `from` where it comes from.
pub fn json(tree: &Table) -> serde_json::Value {
    let mut sections = Map::new();
    for section in SECTIONS {
        let table = table_of(tree, section);
        let mut keys = Map::new();
        for key in section.keys() {
            let entry = match (table.and_then(|table| table.get(key.name)), key.default_node()) {
                (Some(node), _) => json!({ "value": plain(&node.value), "from": place(node) }),
                (None, Some(node)) if key.warns => json!({ "value": plain(&node.value), "from": "reading" }),
                (None, Some(node)) => json!({ "value": plain(&node.value), "from": "default" }),
                (None, None) => json!({ "value": null, "from": null }),
            };
            keys.insert(key.name.to_owned(), entry);
        }
        for (name, node) in named(table, section) {
            keys.insert(name.clone(), json!({ "value": plain(&node.value), "from": place(node) }));
        }
        sections.insert(section.name.to_owned(), keys.into());
    }
    json!({ "version": 1, "settings": sections })
}

fn table_of<'t>(tree: &'t Table, section: &Section) -> Option<&'t Table> {
    match &tree.get(section.name)?.value {
        Value::Table(table) => Some(table),
        _ => None,
    }
}

/// Entries whose keys the user chose.
fn named<'t>(table: Option<&'t Table>, section: &Section) -> Vec<(&'t String, &'t Node)> {
    let known = |name: &str| section.keys().any(|key| key.name == name);
    table.into_iter().flatten().filter(|(name, _)| !known(name)).collect()
}

fn place(node: &Node) -> String {
    if node.spot.line == 0 { node.spot.file.clone() } else { format!("{}:{}", node.spot.file, node.spot.line) }
}

fn line(text: &mut String, name: &str, node: &Node, place: &str) {
    let name = if name.starts_with("# ") { name.to_owned() } else { quoted_key(name) };
    let entry = format!("{name} = {}", value(&node.value));
    let _ = writeln!(text, "{entry:WIDTH$}  # {place}");
}

fn quoted_key(name: &str) -> String {
    let bare = !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-'));
    if bare { name.to_owned() } else { quoted(name) }
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut out = "\"".to_owned();
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", c as u32);
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

fn value(value_: &Value) -> String {
    match value_ {
        Value::Text(text) => quoted(text),
        Value::Whole(n) => n.to_string(),
        // With a point even where it is a whole number.
        Value::Number(x) => format!("{x:?}"),
        Value::Flag(flag) => flag.to_string(),
        Value::List(items) => {
            format!("[{}]", items.iter().map(|item| value(&item.value)).collect::<Vec<_>>().join(", "))
        }
        Value::Table(table) => {
            let inner: Vec<String> =
                table.iter().map(|(name, node)| format!("{} = {}", quoted_key(name), value(&node.value))).collect();
            format!("{{ {} }}", inner.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Settings, config, tree};

    fn read(text: &str) -> Settings {
        config::read(&tree::parse(text, "partc.toml").unwrap()).unwrap()
    }

    #[test]
    fn the_defaults_shown_are_the_defaults_in_force() {
        assert_eq!(read(&toml(&Table::new())), Settings::default());
    }

    #[test]
    fn what_is_shown_means_the_same() {
        let text = "[machine]\nlimits = { X = [-10.0, 800] }\n[tools]\n[tools.1]\nradius = 5.0\n[tools.\"A \\\"B\\\"\"]\nlength = 1e3\n\
                    [datums]\npreset.12 = \"G55\"\nG54 = { X = 1.5 }\n[variables]\nQ50 = -3\n[output]\npass_m = [25, 26]\n\
                    [include]\nroots = { \"TNC:\" = \"a\\\\b\" }\n";
        let tree = tree::parse(text, "partc.toml").unwrap();
        let shown = toml(&tree);
        assert_eq!(read(&shown), read(text), "{shown}");
        assert!(shown.contains("# partc.toml:5") && shown.contains("# default"), "{shown}");
        assert_eq!(json(&tree)["settings"]["output"]["pass_m"]["value"], json!([25, 26]));
    }
}
