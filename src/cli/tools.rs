//! `partc tools`: data of tools and of the machine from the files of controls, in one form, and into other forms.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;

use serde_json::{Map, Value, json};

use crate::machine::table::{Contents, Edge, Kind, Place, csv};
use crate::machine::tools::Corner;
use crate::machine::{Axis, Tool, ToolKey, Unit};
use crate::text::decode::{escaped_json, harmless_lines};

use super::args::{TableForm, ToolsArgs};
use super::config::{Once, read_table};
use super::listing::print;
use super::output::Destination;
use super::paths::same_file;
use super::{Exit, Trouble, say};

/// `partc tools`
pub(super) fn tools(args: &ToolsArgs) -> Result<Exit, Trouble> {
    let shown = args.file.display();
    let mut contents = read_table(&args.file, Once::Yes)?;
    let stated = args.unit.as_deref().map(|unit| if unit == "inch" { Unit::Inch } else { Unit::Mm });
    match (contents.unit, stated) {
        (Some(unit), Some(stated)) if unit != stated => {
            return Err(format!("{shown}: the file states another unit than --unit"));
        }
        (None, Some(stated)) => contents.take_for(stated),
        (None, None) if contents.kind != Kind::Machine || !contents.limits.is_empty() => {
            say(&format!(
                "{shown}: note: the file states no unit, and its lengths are taken for mm; --unit inch says otherwise"
            ));
        }
        _ => {}
    }
    if args.output.as_deref().is_some_and(|path| same_file(path, &args.file)) {
        return Err(format!("{shown}: the table would be replaced by what is made of it; name another file"));
    }
    let mut lost = Vec::new();
    let text = match args.to {
        TableForm::Table => table(&contents),
        TableForm::Json => format!("{}\n", escaped_json(&object(&contents).to_string())),
        TableForm::Csv => as_csv(&contents, &mut lost),
        TableForm::Toml => as_toml(&contents, &mut lost),
        TableForm::ToolT if contents.has_tools() => tool_t(&contents, &mut lost),
        TableForm::ToolTbl if contents.has_tools() => tool_tbl(&contents, &mut lost),
        TableForm::ToolT | TableForm::ToolTbl => {
            return Err(format!("{shown}: is a {}, and holds no tools", contents.kind.name()));
        }
    };
    for (line, what) in &contents.left_out {
        say(&format!("{shown}:{line}: note: {what} is left out: partc has no use for it"));
    }
    for what in lost {
        say(&format!("{shown}: warning: {what}"));
    }
    match &args.output {
        Some(path) if path.as_os_str() != "-" => {
            let written = Destination::open(path).and_then(|mut out| {
                out.write_all(text.as_bytes())?;
                out.commit()
            });
            written.map(|()| Exit::Clean).map_err(|error| format!("{}: {error}", path.display()))
        }
        _ => print(text.as_bytes()),
    }
}

/// A length or an angle without digits that only the conversion of units made.
fn shown(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    // No -0.
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}

/// The fields of a tool that have a value, by their names in `partc.toml`.
fn fields(tool: &Tool) -> Vec<(&'static str, String)> {
    let mut list = Vec::new();
    let mut text = |name, value: &Option<String>| list.extend(value.clone().map(|value| (name, value)));
    text("name", &tool.name);
    text("kind", &tool.kind);
    let numbers = [
        ("radius", tool.radius),
        ("length", tool.length),
        ("corner_radius", tool.corner_radius),
        ("tip_angle", tool.tip_angle),
        ("plunge_angle", tool.plunge_angle),
        ("teeth", tool.teeth.map(f64::from)),
        ("delta_length", Some(tool.deltas[0]).filter(|delta| *delta != 0.0)),
        ("delta_radius", Some(tool.deltas[1]).filter(|delta| *delta != 0.0)),
        ("delta_corner", Some(tool.deltas[2]).filter(|delta| *delta != 0.0)),
        ("orientation", tool.orientation.map(f64::from)),
        ("clearance", tool.clearance),
        ("width", tool.width),
    ];
    list.extend(numbers.into_iter().filter_map(|(name, value)| Some((name, shown(value?)))));
    match tool.reference {
        Corner::Minus => {}
        Corner::Plus => list.push(("reference", "plus".to_owned())),
        Corner::Middle => list.push(("reference", "middle".to_owned())),
    }
    list.extend(tool.number.map(|number| ("printed", number.to_string())));
    list
}

fn number_of(key: &ToolKey) -> String {
    match key {
        ToolKey::Number(..) => key.to_string(),
        ToolKey::Name(_) => String::new(),
    }
}

/// Titles that any tool has a value for, in the order of CSV.
fn titles(contents: &Contents) -> Vec<&'static str> {
    let all: Vec<_> = contents.tools.values().map(fields).collect();
    let has = |title: &str| all.iter().flatten().any(|(name, _)| *name == title);
    csv::TITLES.iter().copied().filter(|title| *title == "number" || has(title)).collect()
}

/// Edges and parameters that a tool of the other forms does not have.
fn further(contents: &Contents) -> impl Iterator<Item = (&Edge, &f64)> {
    contents.edges.iter().filter(|(edge, value)| {
        **value != 0.0 && !(edge.edge == 1 && matches!(edge.parameter, 1 | 2 | 3 | 6 | 12 | 15 | 24))
    })
}

/// Rows of cells under their titles, in columns.
fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |at: usize| rows.iter().filter_map(|row| row.get(at)).map(|cell| cell.chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|at| width(at).unwrap_or(0)).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
        format!("{}\n", cells.collect::<Vec<_>>().join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}

fn table(contents: &Contents) -> String {
    let unit = match contents.unit {
        Some(Unit::Inch) => "inch in the file, mm here",
        _ => "mm",
    };
    let mut text = format!("{}, {unit}\n", contents.kind.name());
    if !contents.tools.is_empty() {
        text += &format!("\n{}", aligned(&tool_rows(contents)));
    }
    let further: Vec<_> = further(contents).collect();
    if !further.is_empty() {
        text.push('\n');
        for (edge, value) in further {
            let _ = writeln!(text, "$TC_DP{}[{},{}] = {}", edge.parameter, edge.tool, edge.edge, shown(*value));
        }
    }
    if !contents.places.is_empty() {
        text += &format!("\n{}", aligned(&place_rows(&contents.places)));
    }
    for (word, values) in &contents.offsets {
        let values: Vec<String> =
            values.iter().map(|(axis, value)| format!("{} {}", axis.letter(), shown(*value))).collect();
        let _ = write!(text, "\n{word}  {}", values.join("  "));
    }
    for (axis, [least, most]) in &contents.limits {
        let side = |limit: &Option<f64>| limit.map_or_else(|| "-".to_owned(), shown);
        let _ = write!(text, "\n{}  {} to {}", axis.letter(), side(least), side(most));
    }
    harmless_lines(text.trim_end()) + "\n"
}

fn tool_rows(contents: &Contents) -> Vec<Vec<String>> {
    let titles = titles(contents);
    let mut rows = vec![titles.iter().map(|title| (*title).to_owned()).collect::<Vec<_>>()];
    for (key, tool) in &contents.tools {
        let fields = fields(tool);
        let name = match key {
            ToolKey::Name(name) => Some(name.clone()),
            ToolKey::Number(..) => None,
        };
        let cell = |title: &&str| match *title {
            "number" => number_of(key),
            title => {
                let field = fields.iter().find(|(name, _)| *name == title).map(|(_, value)| value.clone());
                field.or_else(|| name.clone().filter(|_| title == "name")).unwrap_or_default()
            }
        };
        rows.push(titles.iter().map(cell).collect());
    }
    rows
}

fn place_rows(places: &[Place]) -> Vec<Vec<String>> {
    let axes: Vec<Axis> =
        Axis::ALL.into_iter().filter(|axis| places.iter().any(|place| place.values.contains_key(axis))).collect();
    let turned = places.iter().any(|place| place.rotation != 0.0);
    let mut head = vec!["row".to_owned()];
    head.extend(axes.iter().map(|axis| axis.letter().to_string()));
    head.extend(turned.then(|| "rotation".to_owned()));
    head.push("remark".to_owned());
    let mut rows = vec![head];
    for place in places {
        let mut row = vec![place.number.map(|number| number.to_string()).unwrap_or_default()];
        row.extend(axes.iter().map(|axis| place.values.get(axis).map(|value| shown(*value)).unwrap_or_default()));
        row.extend(turned.then(|| shown(place.rotation)));
        row.push(place.remark.clone().unwrap_or_default());
        rows.push(row);
    }
    rows
}

/// A number, not a text, where it is one.
fn value_of(name: &str, text: &str) -> Value {
    let is_text = matches!(name, "name" | "kind" | "reference");
    text.parse::<f64>().ok().filter(|_| !is_text).map_or_else(|| json!(text), |number| json!(number))
}

fn by_axis(values: &BTreeMap<Axis, f64>) -> Value {
    let pairs = values.iter().map(|(axis, value)| (axis.letter().to_string(), value_of("", &shown(*value))));
    Value::Object(pairs.collect::<Map<_, _>>())
}

fn object(contents: &Contents) -> Value {
    let tool = |(key, tool): (&ToolKey, &Tool)| {
        let number = number_of(key);
        let mut map = Map::new();
        map.insert("number".to_owned(), if number.is_empty() { Value::Null } else { json!(number) });
        if let ToolKey::Name(name) = key {
            map.insert("name".to_owned(), json!(name));
        }
        map.extend(fields(tool).into_iter().map(|(name, value)| (name.to_owned(), value_of(name, &value))));
        Value::Object(map)
    };
    let place = |place: &Place| json!({ "row": place.number, "values": by_axis(&place.values), "rotation": place.rotation, "remark": place.remark });
    let edge = |(edge, value): (&Edge, &f64)| json!({ "tool": edge.tool, "edge": edge.edge, "parameter": edge.parameter, "value": value_of("", &shown(*value)) });
    let limits = contents.limits.iter().map(|(axis, limits)| (axis.letter().to_string(), json!(limits)));
    json!({
        "version": 1,
        "kind": contents.kind.name(),
        "unit_of_file": contents.unit.map(|unit| if unit == Unit::Inch { "inch" } else { "mm" }),
        "tools": contents.tools.iter().map(tool).collect::<Vec<_>>(),
        "edges": contents.edges.iter().map(edge).collect::<Vec<_>>(),
        "rows": contents.places.iter().map(place).collect::<Vec<_>>(),
        "offsets": contents.offsets.iter().map(|(word, values)| (word.clone(), by_axis(values))).collect::<Map<_, _>>(),
        "limits": limits.collect::<Map<_, _>>(),
    })
}

fn as_csv(contents: &Contents, lost: &mut Vec<String>) -> String {
    lose_further(contents, lost);
    let mut rows = if contents.has_tools() { tool_rows(contents) } else { place_rows(&contents.places) };
    if contents.has_tools() {
        // Whoever reads the file again shall not have to guess.
        for (at, row) in rows.iter_mut().enumerate() {
            row.insert(1, if at == 0 { "unit" } else { "mm" }.to_owned());
        }
    }
    for word in contents.offsets.keys() {
        lost.push(format!("{word} has no place in CSV"));
    }
    let cell = |cell: &String| {
        if cell.contains([',', '"', ';']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.clone() }
    };
    rows.iter().map(|row| row.iter().map(cell).collect::<Vec<_>>().join(",") + "\n").collect()
}

fn lose_further(contents: &Contents, lost: &mut Vec<String>) {
    for (edge, _) in further(contents) {
        lost.push(format!(
            "$TC_DP{}[{},{}] is lost: name the file itself as `[tools] table`",
            edge.parameter, edge.tool, edge.edge
        ));
    }
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

fn as_toml(contents: &Contents, lost: &mut Vec<String>) -> String {
    lose_further(contents, lost);
    let mut text = String::new();
    for (key, tool) in &contents.tools {
        let name = match key {
            ToolKey::Number(number, 0) => number.to_string(),
            ToolKey::Number(..) => quoted(&key.to_string()),
            ToolKey::Name(name) => quoted(name),
        };
        let _ = writeln!(text, "[tools.{name}]");
        for (field, value) in fields(tool) {
            match field {
                "delta_length" | "delta_radius" | "delta_corner" => {
                    lost.push(format!(
                        "tool {key}: {field} {value} has no key in partc.toml: name the file itself as `[tools] table`"
                    ));
                }
                "printed" => drop(writeln!(text, "number = {value}")),
                "name" | "kind" | "reference" => drop(writeln!(text, "{field} = {}", quoted(&value))),
                "orientation" => drop(writeln!(text, "{field} = {value}")),
                _ if value.contains('.') => drop(writeln!(text, "{field} = {value}")),
                _ => drop(writeln!(text, "{field} = {value}.0")),
            }
        }
        text.push('\n');
    }
    let decimal = |value: f64| {
        let text = shown(value);
        if text.contains('.') { text } else { text + ".0" }
    };
    let values = |values: &BTreeMap<Axis, f64>| {
        let list: Vec<String> =
            values.iter().map(|(axis, value)| format!("{} = {}", axis.letter(), decimal(*value))).collect();
        format!("{{ {} }}", list.join(", "))
    };
    let mut datums = String::new();
    for place in contents.places.iter().filter(|_| contents.kind == Kind::Presets) {
        let word = place.number.and_then(|row| OFFSETS.get((row as usize).wrapping_sub(1)));
        match word {
            Some(word) if place.rotation == 0.0 => {
                let remark = place.remark.as_ref().map(|remark| format!("  # {remark}")).unwrap_or_default();
                let _ = writeln!(datums, "\"{word}\" = {}{}", values(&place.values), harmless_lines(&remark));
            }
            _ => {
                let row = place.number.map(|row| row.to_string()).unwrap_or_default();
                lost.push(format!("preset {row} is lost: rows 1 to 9 without a rotation become work offsets"));
            }
        }
    }
    for (word, offset) in &contents.offsets {
        let _ = writeln!(datums, "{word} = {}", values(offset));
    }
    if !datums.is_empty() {
        text += &format!("[datums]\n{datums}\n");
    }
    let both = contents.limits.iter().filter_map(|(axis, limits)| Some((axis, limits[0]?, limits[1]?)));
    let limits: Vec<String> = both
        .map(|(axis, least, most)| format!("{} = [{}, {}]", axis.letter(), decimal(least), decimal(most)))
        .collect();
    if !limits.is_empty() {
        text += &format!("[machine]\nlimits = {{ {} }}\n", limits.join(", "));
    }
    for (axis, _) in contents.limits.iter().filter(|(_, limits)| limits.contains(&None)) {
        lost.push(format!("the limits of {} are lost: one of them is not there", axis.letter()));
    }
    if !contents.places.is_empty() && contents.kind != Kind::Presets {
        lost.push("rows of this table have no keys in partc.toml; a program selects the table itself".to_owned());
    }
    text.trim_end().to_owned() + "\n"
}

/// Says what of a tool the other form has no place for.
fn lose(tool: &Tool, key: &ToolKey, kept: &[&str], lost: &mut Vec<String>) {
    for (field, value) in fields(tool).into_iter().filter(|(field, _)| !kept.contains(field)) {
        lost.push(format!("tool {key}: {field} {value} has no place in this form"));
    }
}

fn tool_t(contents: &Contents, lost: &mut Vec<String>) -> String {
    lose_further(contents, lost);
    let mut titles = vec!["T", "NAME", "L", "R", "R2", "DL", "DR", "DR2", "ANGLE", "T-ANGLE"];
    let counted = contents.tools.values().any(|tool| tool.teeth.is_some());
    titles.extend(counted.then_some("CUT"));
    let mut rows = vec![titles.into_iter().map(str::to_owned).collect()];
    let kept = [
        "name",
        "radius",
        "length",
        "corner_radius",
        "tip_angle",
        "plunge_angle",
        "teeth",
        "delta_length",
        "delta_radius",
        "delta_corner",
    ];
    let number = |value: Option<f64>| {
        value.map_or_else(String::new, |value| format!("{}{}", if value < 0.0 { "" } else { "+" }, shown(value)))
    };
    for (key, tool) in &contents.tools {
        if number_of(key).is_empty() {
            lost.push(format!("tool {key} is lost: this form has numbers only"));
            continue;
        }
        lose(tool, key, &kept, lost);
        let name = tool.name.clone().unwrap_or_default();
        if name.chars().count() > NAME {
            lost.push(format!("tool {key}: its name is longer than {NAME} characters"));
        }
        let angle = |angle: Option<f64>| angle.map(shown).unwrap_or_default();
        let mut row = vec![
            number_of(key),
            name.chars().filter(|c| !c.is_control()).take(NAME).collect(),
            number(tool.length),
            number(tool.radius),
            number(tool.corner_radius),
            number(Some(tool.deltas[0])),
            number(Some(tool.deltas[1])),
            number(Some(tool.deltas[2])),
            angle(tool.plunge_angle),
            angle(tool.tip_angle),
        ];
        row.extend(counted.then(|| tool.teeth.map_or_else(String::new, |teeth| teeth.to_string())));
        rows.push(row);
    }
    format!("BEGIN TOOL    .T MM\n{}[END]\n", aligned(&rows))
}

/// Work offsets of the presets from 1 on.
const OFFSETS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];

/// Longest name of a tool in TOOL.T.
const NAME: usize = 32;

fn tool_tbl(contents: &Contents, lost: &mut Vec<String>) -> String {
    lose_further(contents, lost);
    let mut text = String::new();
    for (key, tool) in &contents.tools {
        let ToolKey::Number(number, 0) = key else {
            lost.push(format!("tool {key} is lost: this form has whole numbers only"));
            continue;
        };
        lose(tool, key, &["name", "radius", "length"], lost);
        let _ = write!(text, "T{number} P{number}");
        if let Some(radius) = tool.radius {
            let _ = write!(text, " D{}", shown(2.0 * radius));
        }
        if let Some(length) = tool.length {
            let _ = write!(text, " Z{}", shown(length));
        }
        if let Some(name) = &tool.name {
            let _ = write!(text, " ;{}", harmless_lines(name));
        }
        text.push('\n');
    }
    text
}
